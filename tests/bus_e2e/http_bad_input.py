"""Whom and what axisd-http refuses: http_bad_input.py BIN-FOLDER"""

import os
import random
import socket
import subprocess
import sys

import http_client
import programs


def raw(gateway, text, shut=False):
    """What comes for TEXT until the server closes the connection."""
    with socket.create_connection(('127.0.0.1', gateway.port), programs.PATIENCE) as connection:
        connection.sendall(text)
        if shut:
            connection.shutdown(socket.SHUT_WR)
        answer = b''
        while part := connection.recv(65536):
            answer += part
        return answer.decode(errors='replace')


def check_names(gateway):
    """Host and Origin are those of this server."""
    def code(headers, verb='GET'):
        return gateway.code(verb, '/api/v1/units', headers=headers)

    assert code({'Host': 'evil.example'}) == (421, 'wrong-host')
    assert code({'Host': 'localhost.evil.example:8402'}) == (421, 'wrong-host')
    assert code({'Host': 'localhost:1'}) == (200, None)
    assert code({'Origin': 'http://evil.example'}) == (403, 'forbidden-origin')
    assert code({'Origin': 'null'}) == (403, 'forbidden-origin')
    assert code({'Origin': f'http://127.0.0.1:{gateway.port}'}) == (200, None)
    assert code({'Origin': 'http://evil.example'}, 'OPTIONS') == (403, 'forbidden-origin')
    assert 'Access-Control-Allow-Origin' not in gateway.request('GET', '/')[1]
    assert raw(gateway, b'GET / HTTP/1.0\r\n\r\n').split()[1] == '421'
    twice = raw(gateway, b'GET / HTTP/1.1\r\nHost: localhost\r\nHost: evil.example\r\nConnection: close\r\n\r\n')
    assert twice.split()[1] in ('400', '421'), twice


def check_writes(gateway, unit):
    """A write needs the token, and a body that it can take."""
    load = f'{unit}/axes/1/load'
    body = {'torque_Nm': 1}

    def code(content=body, **headers):
        return gateway.code('PUT', load, content, headers=headers, token=False)

    right = f'Bearer {gateway.token}'
    assert code() == (401, 'token-missing')
    assert code(Authorization='Bearer ' + 'x' * len(gateway.token)) == (401, 'token-wrong')
    assert code(Authorization='Basic YTpi') == (401, 'token-missing')
    assert code(Authorization=right) == (200, None)
    for content in ('{', '[]', '"x"', '{"torque_Nm": 1}x', '[' * 5000):
        assert code(content, Authorization=right) == (400, 'bad-request'), content[:20]
    assert code({'torque_Nm': 1e9}, Authorization=right) == (400, 'bad-parameter')
    assert code({'torque_Nm': 1, 'unit': 'vcan9/1'}, Authorization=right) == (400, 'bad-request')
    assert gateway.code('PUT', load, body, headers={'Content-Type': 'text/plain'}) == (415, 'not-json')
    assert gateway.code('PUT', load, '{"torque_Nm": 1, "x": "' + 'x' * 65536 + '"}') == (413, 'too-long')
    assert gateway.code('DELETE', load) == (405, 'method-not-allowed')
    assert gateway.request('DELETE', load)[1]['Allow'] == 'GET, HEAD, PUT, OPTIONS'
    for path in ('/api', '/api/v1/units/', '/etc/passwd', '/api/v1/../../etc/passwd', '/api/v1/units/%00/5', '//'):
        assert gateway.code('GET', path) == (404, 'no-such-path'), path
    assert gateway.code('PUT', f'{unit}/parameters/p1120?axis=1', {'value': -1})[0] == 422
    assert gateway.code('PUT', f'{unit}/parameters/r0063?axis=1', {'value': 1}) == (409, 'read-only')
    assert gateway.code('GET', f'{unit}/parameters/p9999') == (404, 'not-found')
    assert gateway.code('GET', f'{unit}/pdos?all=perhaps') == (400, 'bad-parameter')
    assert gateway.code('GET', f'{unit}/pdos?all=%zz') == (400, 'bad-request')


def check_slow(gateway):
    """Half a request, and a request by and by, end after a while; others are served meanwhile."""
    slow = socket.create_connection(('127.0.0.1', gateway.port), programs.PATIENCE)
    slow.sendall(b'POST / HTTP/1.1\r\nHost: localhost\r\nContent-Le')
    assert gateway.request('GET', '/')[0] == 200
    answer = slow.recv(65536)
    assert answer.startswith(b'HTTP/1.1 408 ') or answer == b'', answer
    slow.close()


def check_junk(gateway):
    """What is no request at all."""
    for junk in (b'\x00' * 100, b'\x16\x03\x01\x02\x00\x01', b'GET\r\n\r\n', b'GET / HTTP/1.1\r\nHost: localhost\r\nX: ' + b'x' * 100000,
                 b'POST / HTTP/1.1\r\nHost: localhost\r\nContent-Length: -5\r\n\r\n', random.Random(1).randbytes(2000)):
        try:
            raw(gateway, junk, shut=True)
        except ConnectionError:
            pass
        assert gateway.request('GET', '/')[0] == 200


def check_read_only(folder):
    gateway = http_client.Gateway(folder, '--read-only')
    unit = gateway.unit()
    assert gateway.request('GET', unit)[0] == 200
    assert gateway.code('PUT', f'{unit}/supply', {'line_voltage_V': 1}) == (403, 'read-only-server')
    assert gateway.code('POST', f'{unit}/quit') == (403, 'read-only-server')
    assert gateway.program.end() == 0


def check_other_names(folder):
    gateway = http_client.Gateway(folder, '--allow-host', 'Drive.Lab', '--allow-origin', 'http://localhost:3000')
    assert gateway.code('GET', '/', headers={'Host': 'drive.lab'}) == (200, None)
    status, headers, _ = gateway.request('GET', '/', headers={'Origin': 'http://localhost:3000'})
    assert (status, headers['Access-Control-Allow-Origin']) == (200, 'http://localhost:3000'), headers
    assert 'Origin' in headers.get_all('Vary'), headers  # beside Accept, as a browser gets the page here
    status, headers, _ = gateway.request('OPTIONS', '/api/v1/units', headers={'Origin': 'http://localhost:3000'})
    assert status == 204 and 'Authorization' in headers['Access-Control-Allow-Headers'], headers
    assert gateway.program.end() == 0


def check_start(folder):
    """What is wrong with a start is said in one line."""
    def end(*options):
        done = subprocess.run([os.path.join(folder.bin_folder, 'axisd-http'), *options], env=folder.environment,
                              capture_output=True, text=True, timeout=programs.PATIENCE, check=False)
        assert done.stderr.count('\n') == 1 and done.stderr.startswith('axisd-http: '), done.stderr
        return done.returncode

    assert end('--listen', 'localhost:80') == 2
    assert end('--listen', '127.0.0.1') == 2
    assert end('--log-level', 'loud') == 2
    assert end('--allow-origin', 'localhost') == 2
    assert end('--dance') == 2
    assert end('--read-only', '--listen', '192.0.2.1:80') == 1
    assert end('--token-file', '/dev/null') == 1
    with open(folder.path('open'), 'w', encoding='ascii') as file:
        file.write('x' * 64)
    os.chmod(folder.path('open'), 0o644)
    assert end('--token-file', folder.path('open')) == 1


def main():
    with programs.Folder(sys.argv[1]) as folder:
        check_start(folder)
        programs.start_unit(folder)
        check_read_only(folder)
        assert not os.path.exists(folder.path('.local/state/axisd-http/token'))
        check_other_names(folder)
        gateway = http_client.Gateway(folder)
        assert os.stat(folder.path('.local/state/axisd-http/token')).st_mode & 0o777 == 0o600
        unit = gateway.unit()
        check_names(gateway)
        check_writes(gateway, unit)
        check_junk(gateway)
        check_slow(gateway)
        assert gateway.request('GET', unit)[2]['axes'][0]['load_torque_Nm'] == 1
        assert gateway.program.end() == 0


if __name__ == '__main__':
    main()
