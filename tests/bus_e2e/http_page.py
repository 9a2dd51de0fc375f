"""What a web page asks of axisd-http: http_page.py BIN-FOLDER EDS

The files of the page, the server, the overview, the EDS, frames and samples of the unit.
"""

import concurrent.futures
import gzip
import pathlib
import re
import sys

import can
import http_client
import programs

SCRIPT = 'let a = 1;\n' * 100
BROWSER = {'Accept': 'text/html,application/xhtml+xml,*/*;q=0.8'}


def build_page(folder):
    """A folder as the build of a page leaves it."""
    page = pathlib.Path(folder.path('web'))
    (page / 'assets').mkdir(parents=True)
    (page / 'index.html').write_text('<!doctype html><title>axisd</title>', encoding='utf-8')
    (page / 'session.html').write_text('not served', encoding='utf-8')
    (page / 'assets' / 'index-1a2b3c.js').write_text(SCRIPT, encoding='utf-8')
    (page / 'assets' / 'index-1a2b3c.js.gz').write_bytes(gzip.compress(SCRIPT.encode()))
    (page / 'assets' / 'other.bin').write_text('not served', encoding='utf-8')
    return str(page)


def raw(gateway, path, headers):
    """Status, headers and bytes of a GET."""
    connection = http_client.http.client.HTTPConnection('127.0.0.1', gateway.port, timeout=programs.PATIENCE)
    try:
        connection.request('GET', path, headers=headers)
        answer = connection.getresponse()
        return answer.status, answer.headers, answer.read()
    finally:
        connection.close()


def check_files(gateway):
    """A browser gets the page, and keeps what it may keep."""
    status, headers, body = raw(gateway, '/', BROWSER)
    assert status == 200 and body.startswith(b'<!doctype html>'), body
    assert headers.get_all('Content-Security-Policy') == [
        "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; connect-src 'self'; "
        "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"]
    for name, value in {'X-Content-Type-Options': 'nosniff', 'Referrer-Policy': 'no-referrer', 'Cache-Control': 'no-cache',
                        'Cross-Origin-Opener-Policy': 'same-origin', 'Cross-Origin-Resource-Policy': 'same-origin'}.items():
        assert headers.get_all(name) == [value], (name, headers.get_all(name))
    status, _, body = raw(gateway, '/', {**BROWSER, 'If-None-Match': headers['ETag']})
    assert (status, body) == (304, b'')
    assert gateway.request('GET', '/')[2]['program'] == 'axisd-http'  # for who does not ask for a page

    status, headers, body = raw(gateway, '/assets/index-1a2b3c.js', {'Accept-Encoding': 'br, gzip'})
    assert status == 200 and gzip.decompress(body).decode() == SCRIPT and headers['Content-Encoding'] == 'gzip'
    assert headers.get_content_type() == 'text/javascript' and 'immutable' in headers['Cache-Control']
    status, headers, body = raw(gateway, '/assets/index-1a2b3c.js', {})
    assert status == 200 and body.decode() == SCRIPT and 'Content-Encoding' not in headers
    for path in ('/session.html', '/assets/session.html', '/assets/../session.html', '/assets/..%2fsession.html', '/assets/other.bin',
                 '/assets/', '/assets', '/assets/%2e%2e', '/assets/index-1a2b3c.js.gz', '//etc/passwd', '/assets//etc/passwd'):
        status, _, body = raw(gateway, path, BROWSER)
        assert status == 404 and b'not served' not in body, (path, status)
    assert raw(gateway, '/', {**BROWSER, 'Host': 'evil.example'})[0] == 421
    assert raw(gateway, '/', {**BROWSER, 'Origin': 'http://evil.example'})[0] == 403


def check_server(gateway):
    """Who asks is told what its token is."""
    assert gateway.request('GET', '/api/v1/server')[2]['token'] == 'right'
    wrong = {'Authorization': 'Bearer ' + '0' * 64}
    assert gateway.request('GET', '/api/v1/server', headers=wrong, token=False)[2]['token'] == 'wrong'
    answer = gateway.request('GET', '/api/v1/server', token=False)[2]
    assert (answer['program'], answer['token'], answer['read_only']) == ('axisd-http', 'missing', False)
    assert re.match(r'\d+[.]\d+[.]\d+', answer['version'])


def check_overview(gateway, unit):
    """It is what the status says, and the same for all who ask."""
    status = gateway.request('GET', unit)[2]
    overview = gateway.request('GET', '/api/v1/overview')[2]['units']
    assert [(each['unit'], each['on']) for each in overview] == [(unit.split('/units/')[1], True)]
    for key in ('node_id', 'nmt_state', 'dc_link_V', 'leds'):
        assert overview[0][key] == status[key], key
    for key, value in overview[0]['axes'][0].items():
        assert status['axes'][0][key] == value, key
    with concurrent.futures.ThreadPoolExecutor(16) as pool:
        texts = {str(answer[2]) for answer in pool.map(lambda _: gateway.request('GET', '/api/v1/overview'), range(64))}
    assert texts
    assert gateway.request('POST', f'{unit}/power/off')[0] == 200
    while (told := gateway.request('GET', '/api/v1/overview')[2]['units'])[0]['on']:
        pass
    assert told == [{'unit': overview[0]['unit'], 'on': False}], told
    assert gateway.request('POST', f'{unit}/power/on')[0] == 200


def check_eds(gateway, unit, eds):
    """It is the file of a unit with one axis."""
    status, headers, body = raw(gateway, f'{unit}/eds', {})
    assert status == 200 and headers.get_content_type() == 'text/plain'
    assert body == pathlib.Path(eds).read_bytes()
    assert gateway.code('GET', '/api/v1/units/nowhere/7/eds') == (404, 'unknown-unit')


def check_frames(gateway, unit):
    """What passes on the bus is told, in its order and with the time between."""
    with can.Bus(interface='socketcan', channel='vcan0') as bus, gateway.stream(f'{unit}/frames') as one, \
            gateway.stream(f'{unit}/frames') as two:
        assert one.expect('unit') == two.expect('unit')
        for _ in range(100):
            bus.send(can.Message(arbitration_id=0x605, data=bytes.fromhex('4018100400000000'), is_extended_id=False))
        for stream in (one, two):
            requests, answers, last = 0, 0, 0.0
            while answers < 100:
                line = stream.expect('frames')
                assert line['lost'] == 0, line
                for text in line['frames']:
                    at, direction, frame = text.split()
                    assert float(at) >= last, line
                    last = float(at)
                    requests += (direction, frame) == ('R', '605#4018100400000000')
                    answers += direction == 'S' and frame.startswith('585#43181004')
                assert line['t'] == last
            assert requests == 100


def check_samples(gateway, unit):
    """They are a period apart, whatever else happens."""
    with gateway.stream(f'{unit}/samples?signals=1/speed,dc_voltage&period_ms=2&batch_ms=50') as stream:
        assert stream.expect('signals')['batch_ms'] == 50
        times, lost = [], 0
        while len(times) < 500:
            line = stream.expect('samples')
            assert [len(values) for values in line['values']] == [len(line['t'])] * 2
            times += line['t']
            lost += line['lost']
        steps = [round((later - earlier) * 1e6) for earlier, later in zip(times, times[1:])]
        assert all(step % 2000 == 0 and step > 0 for step in steps), steps
        assert sum(step // 2000 - 1 for step in steps) <= lost, (steps, lost)
    assert gateway.code('GET', f'{unit}/samples?signals=1/speed&period_ms=2&batch_ms=5000') == (400, 'bad-parameter')
    assert gateway.code('GET', f'{unit}/samples?signals=1/dance&period_ms=2&batch_ms=50') == (404, 'not-found')


def main():
    with programs.Folder(sys.argv[1]) as folder:
        programs.start_unit(folder)
        gateway = http_client.Gateway(folder, '--page', build_page(folder))
        unit = gateway.unit()
        check_files(gateway)
        check_server(gateway)
        check_eds(gateway, unit, sys.argv[2])
        check_frames(gateway, unit)
        check_samples(gateway, unit)
        check_overview(gateway, unit)
        assert gateway.program.end() == 0
        bare = http_client.Gateway(folder, '--page', folder.path('nowhere'), '--read-only')
        assert b'<li><a href="/api/v1/units">' in raw(bare, '/', BROWSER)[2]
        assert bare.request('GET', '/api/v1/server')[2]['token'] == 'none'
        assert bare.code('GET', '/assets/index-1a2b3c.js') == (404, 'no-such-path')


if __name__ == '__main__':
    main()
