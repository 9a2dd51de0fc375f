"""axisd-http in a folder of its own, and a client of it."""

import http.client
import json
import socket

import programs


class Gateway:
    """axisd-http with what a unit is called that it has found."""

    def __init__(self, folder, *options):
        self.program = folder.start('axisd-http', '--listen', '127.0.0.1:0', *options)
        self.port = int(self.program.expect(r'ready: http://127[.]0[.]0[.]1:(\d+)/')[1])
        try:
            with open(folder.path('.local/state/axisd-http/token'), encoding='ascii') as file:
                self.token = file.read().strip()
        except FileNotFoundError:
            self.token = None

    def request(self, verb, path, body=None, headers=None, token=True):
        """Status, headers and body of the answer, as JSON where it is some."""
        sent = {'Authorization': f'Bearer {self.token}'} if token and self.token else {}
        if body is not None:
            sent['Content-Type'] = 'application/json'
            body = body if isinstance(body, (str, bytes)) else json.dumps(body)
        connection = http.client.HTTPConnection('127.0.0.1', self.port, timeout=programs.PATIENCE)
        try:
            connection.request(verb, path, body, {**sent, **(headers or {})})
            answer = connection.getresponse()
            text = answer.read().decode()
            is_json = answer.headers.get_content_type() == 'application/json'
            return answer.status, answer.headers, json.loads(text) if is_json and text else text
        finally:
            connection.close()

    def code(self, verb, path, *arguments, **options):
        """Status and code of an error."""
        status, _, answer = self.request(verb, path, *arguments, **options)
        return status, answer['error']['code'] if 'error' in answer else None

    def unit(self):
        """The path of the only unit, as soon as there is one."""
        names = self.wait_for_units(lambda units: units)
        return f'/api/v1/units/{names[0]}'

    def wait_for_units(self, is_wanted):
        with self.stream('/api/v1/events') as stream:
            while True:
                name, data = stream.next()
                if name == 'units' and is_wanted(data['units']):
                    return data['units']

    def stream(self, path, headers=''):
        return Stream(self.port, path, headers)


class Stream:
    """Server-sent events."""

    def __init__(self, port, path, headers=''):
        self.socket = socket.create_connection(('127.0.0.1', port), programs.PATIENCE)
        self.socket.sendall(f'GET {path} HTTP/1.0\r\nHost: localhost\r\n{headers}\r\n'.encode())
        self.lines = self.socket.makefile('r', encoding='utf-8', newline='\n')
        self.status = int(self.lines.readline().split()[1])
        while self.lines.readline().strip():
            pass

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.lines.close()
        self.socket.close()

    def next(self):
        """Name and data of the next event."""
        name = None
        while True:
            line = self.lines.readline()
            assert line, 'the stream has ended'
            key, _, value = line.rstrip('\n').partition(': ')
            if key == 'event':
                name = value
            elif key == 'data':
                return name, json.loads(value)

    def expect(self, name, **members):
        """The data of the next event called NAME that has MEMBERS."""
        while True:
            got, data = self.next()
            if got == name and all(data.get(key) == value for key, value in members.items()):
                return data
