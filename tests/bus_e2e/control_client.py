"""A client of the control socket: requests and their results, a line each."""

import json
import socket


class ControlError(Exception):
    """The daemon has refused a request; args[0] is its error."""


class ControlClient:
    """A connection to the control socket at PATH."""

    def __init__(self, path, patience):
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.settimeout(patience)
        self.socket.connect(path)
        self.lines = self.socket.makefile('r', encoding='utf-8')
        self.number = 0

    def call(self, method, **params):
        """The result of METHOD; raises ControlError."""
        self.number += 1
        request = {'id': self.number, 'method': method, 'params': params}
        self.socket.sendall((json.dumps(request) + '\n').encode())
        while True:
            answer = json.loads(self.lines.readline())
            if answer.get('id') == self.number:
                break
        if 'error' in answer:
            raise ControlError(answer['error'])
        return answer['result']
