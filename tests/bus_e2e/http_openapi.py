"""The OpenAPI file against axisd-http: http_openapi.py BIN-FOLDER FILE

Every operation of the file is requested with arguments that it takes, and with some that it does not; every answer is what the file
says, and nothing more. Needs python3-jsonschema.
"""

import json
import pathlib
import sys
import urllib.parse

import control_schema
import http_client
import jsonschema
import programs

# What every operation is asked for, in an order in which all can be answered: path, query, body.
REQUESTS = [
    ('start', {}, {}, None), ('metrics', {}, {}, None), ('metrics.get', {}, {}, None), ('openapi.json', {}, {}, None), ('units', {}, {}, None),
    ('server', {}, {}, None), ('overview', {}, {}, None), ('eds', {}, {}, None), ('asset', {'name': 'no.js'}, {}, None),
    ('status', {}, {}, None), ('axis', {'axis': 1}, {}, None), ('explain', {}, {}, None), ('explain', {}, {'axis': 1}, None),
    ('fault.inject', {'axis': 1}, {}, {'number': 7860, 'value': 3}), ('fault.list', {}, {}, None),
    ('status', {}, {}, None), ('fault.ack', {'axis': 1}, {}, None), ('fault.buffer', {'axis': 1}, {'kind': 'all'}, None),
    ('fault.clear', {'axis': 1}, {'kind': 'all'}, None),
    ('inject.kinds', {}, {}, None), ('inject.add', {}, {}, {'kind': 'heartbeat.late', 'delay_ms': 5, 'until': '10 heartbeat'}),
    ('inject.list', {}, {}, None), ('inject.remove', {}, {'id': 1}, None),
    ('parameter.search', {}, {'text': 'ramp', 'axis': 1}, None), ('parameter.diff', {}, {'against': 'stored'}, None),
    ('parameter.read', {'parameter': '1/p1120,1/p1070[0],0/r0722.3'}, {}, None),
    ('parameter.read', {'parameter': 'p1120'}, {'axis': 1}, None),
    ('parameter.write', {'parameter': 'p1120'}, {'axis': 1}, {'value': 2.5}),
    ('parameter.list', {'axis': 1}, {'count': 5}, None), ('parameter.list', {'axis': 0}, {'filter': 'inputs'}, None),
    ('object.list', {}, {'count': 20}, None), ('object.read', {'index': '1018'}, {'sub_index': 4}, None),
    ('object.write', {'index': '6083'}, {}, {'value': 5000}),
    ('supply.get', {}, {}, None), ('supply.set', {}, {}, {'line_voltage_V': 390}),
    ('load.get', {'axis': 1}, {}, None), ('load.set', {'axis': 1}, {}, {'torque_Nm': 1.5}),
    ('encoder.get', {'axis': 1}, {}, None), ('encoder.fail', {'axis': 1}, {}, {'defect': 'none'}),
    ('state.machine', {'axis': 1}, {}, None), ('identification.get', {'axis': 1}, {}, None),
    ('panel.get', {'axis': 1}, {}, None), ('panel.take', {'axis': 1}, {}, {'timeout_ms': 10000}),
    ('panel.set', {'axis': 1}, {}, {'on': False, 'speed_rpm': 0}), ('panel.release', {'axis': 1}, {}, None),
    ('plant.get', {'axis': 1}, {}, None), ('plant.set', {'axis': 1}, {}, {'ambient_C': 30}),
    ('input.list', {}, {}, None), ('input.set', {'input': 3}, {}, {'state': True}), ('output.list', {}, {}, None),
    ('input.analog', {}, {}, {'voltage_V': 1}),
    ('pdo.list', {}, {'all': True}, None), ('pdo.list.post', {}, {}, {'watch': True}), ('nmt.get', {}, {}, None),
    ('audit.get', {}, {'rule': 'sdo.overlap'}, None),
    ('if1.exchange', {'do': 2}, {}, None), ('if1.exchange.put', {'do': 2}, {}, {'received': [1150, '0000']}),
    ('parameter.record', {}, {}, {'request': '25010201100803B10000'}),
    ('pkw.exchange', {}, {}, {'do': 2, 'request': '1000008000000000'}),
    ('signal.list', {}, {'search': 'speed'}, None), ('signal.read', {}, {'signals': '1/speed,1/r0063'}, None),
    ('live', {}, {'signals': '1/speed,1/torque', 'period_ms': 5, 'frames': True}, None), ('live', {}, {'frames': True}, None),
    ('recent', {}, {'kinds': 'nmt,fault', 'after': 5}, None), ('recent', {}, {}, None),
    ('trace.start', {}, {}, {'signals': ['1/speed'], 'every': 'cycle', 'samples': 5}), ('trace.status', {}, {}, None),
    ('trace.stop', {}, {}, {}), ('trace.read', {}, {'part': 'samples'}, None),
    ('record.start', {}, {}, {'name': 'one'}), ('record.status', {}, {}, None), ('record.stop', {}, {}, None),
    ('store', {}, {}, None), ('store.status', {}, {}, None), ('restore', {}, {}, {'which': 'factory'}),
    ('unit.off', {}, {}, None), ('unit.on', {}, {}, None), ('quit', {}, {}, None),
]
STREAMS = [('events.subscribe', {}, {'kinds': 'nmt,fault'}), ('frames.subscribe', {}, {}), ('samples.subscribe', {}, {'signals': '1/speed', 'period_ms': 50})]
# Those that this unit may refuse.
MAY_BE_REFUSED = {'asset', 'input.analog', 'trace.read', 'restore', 'store', 'bus.restart'}
REFUSED = [('bus.restart', {}, {}, None)]


class Description:
    """The operations of the file, and whether an answer is what they say."""

    def __init__(self, document):
        self.document = document
        self.operations = {}
        for path, verbs in document['paths'].items():
            for verb, operation in verbs.items():
                self.operations[operation['operationId']] = (verb.upper(), path, operation)
        self.components = control_schema.closed({'$defs': {'error': {}}, **document['components']})
        self.components['schemas']['error'] = document['components']['schemas']['error']

    def url(self, name, unit, path_values, query):
        _, path, _ = self.operations[name]
        bus, node = unit
        values = {'bus': bus, 'node': node, **path_values}
        quoted = {key: urllib.parse.quote(str(value), safe='') for key, value in values.items()}
        words = urllib.parse.urlencode({key: str(value).lower() if isinstance(value, bool) else value
                                        for key, value in query.items()})
        return path.format(**quoted) + ('?' + words if words else '')

    def check(self, name, status, headers, answer):
        """ANSWER is one that the file has for STATUS."""
        _, _, operation = self.operations[name]
        assert str(status) in operation['responses'], (name, status, answer)
        response = operation['responses'][str(status)]
        if '$ref' in response:
            response = self.components['responses'][response['$ref'].rsplit('/', 1)[1]]
        kind = headers.get_content_type()
        assert kind in response['content'], (name, kind)
        schema = {**response['content'][kind]['schema'], 'components': self.components}
        jsonschema.Draft202012Validator(schema).validate(answer)


def ask(gateway, description, name, unit, path_values, query, body):
    verb, _, _ = description.operations[name]
    status, headers, answer = gateway.request(verb, description.url(name, unit, path_values, query), body)
    description.check(name, status, headers, answer)
    for header in ('X-Content-Type-Options', 'Content-Security-Policy', 'Cache-Control'):
        assert headers[header], (name, header)
    return status, answer


def check_wrong(gateway, description, name, unit, path_values):
    """What the operation does not take."""
    verb, path, operation = description.operations[name]
    url = description.url(name, unit, path_values, {'nonsense': 1})
    body = {} if verb != 'GET' else None
    wrong = [(url, body, 400)]
    if verb != 'GET':
        wrong.append((description.url(name, unit, path_values, {}), {'nonsense': 1}, 400))
        wrong.append((description.url(name, unit, path_values, {}), '[]', 400))
    if '{bus}' in path:
        elsewhere = description.url(name, ('nowhere', 77), path_values, {})
        wrong.append((elsewhere, body, 404))
    if verb != 'GET' and operation.get('requestBody', {}).get('required'):
        wrong.append((description.url(name, unit, path_values, {}), body, 400))
    if 'axis' in path_values and name != 'axis':
        wrong.append((description.url(name, unit, {**path_values, 'axis': 'x'}, {}), body, 400))
    for query in (row for row in operation.get('parameters', []) if row['in'] == 'query' and row['required']):
        wrong.append((description.url(name, unit, path_values, {}), body, 400))
        assert query['schema']
    for address, content, expected in wrong:
        status, headers, answer = gateway.request(verb, address, content)
        assert status == expected, (verb, address, content, status, answer)
        description.check(name, status, headers, answer)
    if verb != 'GET':
        assert gateway.code(verb, url, body, token=False) == (401, 'token-missing'), url
    status, headers, _ = gateway.request('OPTIONS', url)
    assert status == 204 and verb in headers['Allow'], (url, headers['Allow'])
    assert gateway.request('TRACE', url)[0] == 405, url


def main():
    bin_folder, file = sys.argv[1:]
    text = pathlib.Path(file).read_text(encoding='utf-8')
    description = Description(json.loads(text))
    asked = {request[0] for request in REQUESTS + REFUSED + STREAMS}
    there = set(description.operations)
    assert asked == there, f'not asked for: {there - asked}, not in the file: {asked - there}'
    with programs.Folder(bin_folder) as folder:
        programs.start_unit(folder, audit=True)
        gateway = http_client.Gateway(folder)
        unit = gateway.unit().rsplit('/', 2)[1:]
        assert gateway.request('GET', '/api/v1/openapi.json')[2] == json.loads(text)
        for name, path_values, query in STREAMS:
            with gateway.stream(description.url(name, unit, path_values, query)) as stream:
                assert stream.status == 200 and stream.next()
        for name, path_values in {request[0]: request[1] for request in REQUESTS + REFUSED + STREAMS}.items():
            if name != 'metrics':
                check_wrong(gateway, description, name, unit, path_values)
        for name, path_values, query, body in REFUSED + REQUESTS:
            status, answer = ask(gateway, description, name, unit, path_values, query, body)
            assert status == 200 or name in MAY_BE_REFUSED, (name, status, answer)


if __name__ == '__main__':
    main()
