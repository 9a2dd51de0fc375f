"""The schema of the control socket against a daemon: control_schema.py BIN-FOLDER SCHEMA

Every method is asked for something, by a request that the schema allows; every answer, error and notice is what the schema says,
and nothing more. Needs python3-jsonschema.
"""

import copy
import json
import pathlib
import socket
import sys

import jsonschema
import programs
from masters import can_master

# What every method is asked for, in an order in which all can be answered.
REQUESTS = [
    ('units', {}), ('status', {}), ('metrics', {}), ('explain', {}), ('explain', {'axis': 1}),
    ('events.subscribe', {}), ('frames.subscribe', {}), ('samples.subscribe', {'signals': ['1/speed'], 'period_ms': 50}),
    ('fault.inject', {'axis': 1, 'number': 7860, 'value': 3}), ('fault.list', {}), ('fault.list', {'axis': 1}),
    ('status', {}), ('fault.ack', {'axis': 1}), ('fault.buffer', {'axis': 1}), ('fault.clear', {'axis': 1}),
    ('inject.kinds', {}), ('inject.add', {'kind': 'heartbeat.late', 'delay_ms': 5, 'after': 3, 'until': '10 heartbeat'}),
    ('inject.add', {'kind': 'sdo.abort', 'code': '0x08000000', 'times': 1}), ('inject.list', {}), ('inject.remove', {'id': 1}), ('inject.remove', {}),
    ('load.set', {'axis': 1, 'torque_Nm': 1.5}), ('load.get', {'axis': 1}), ('supply.set', {'line_voltage_V': 390}),
    ('supply.get', {}), ('encoder.fail', {'axis': 1, 'defect': 'none'}), ('encoder.get', {'axis': 1}),
    ('state.machine', {'axis': 1}), ('identification.get', {'axis': 1}), ('panel.get', {'axis': 1}),
    ('panel.take', {'axis': 1, 'timeout_ms': 10000}), ('panel.set', {'axis': 1, 'on': False, 'speed_rpm': 0}),
    ('panel.release', {'axis': 1}), ('panel.get', {'axis': 1}),
    ('plant.get', {'axis': 1}), ('plant.set', {'axis': 1, 'ambient_C': 30}),
    ('input.set', {'input': 3, 'state': True}), ('input.list', {}), ('output.list', {}), ('input.analog', {'voltage_V': 1}),
    ('parameter.read', {'parameters': ['1/p1120', '1/p1070', '0/r0722.3', '1/r0899.2']}),
    ('parameter.write', {'parameter': 'p1120', 'value': 2.5}), ('parameter.list', {'axis': 1, 'count': 5}),
    ('parameter.list', {'axis': 0, 'filter': 'inputs'}), ('parameter.search', {'text': 'ramp'}),
    ('parameter.search', {'text': 'ramp', 'axis': 1}), ('parameter.diff', {}), ('parameter.diff', {'against': 'stored'}),
    ('object.read', {'index': '6041'}), ('object.write', {'index': '6083', 'value': 5000}), ('object.list', {'count': 20}),
    ('pdo.list', {'all': True}), ('pdo.list', {'watch': True}), ('pdo.list', {}), ('nmt.get', {}),
    ('audit.get', {}), ('audit.get', {'rule': 'object.read-only'}),
    ('signal.list', {'search': 'speed'}), ('signal.read', {'signals': ['1/speed', '1/r0063']}),
    ('trace.start', {'signals': ['1/speed'], 'every': 'cycle', 'samples': 5}), ('trace.status', {}), ('trace.stop', {}),
    ('trace.read', {}), ('trace.read', {'part': 'frames'}), ('trace.read', {'part': 'events'}),
    ('record.start', {'name': 'one'}), ('record.status', {}), ('record.stop', {}), ('record.status', {}),
    ('if1.exchange', {'do': 2}), ('if1.exchange', {'do': 2, 'received': [1150, '0000']}),
    ('parameter.record', {'request': '25010201100803B10000'}), ('pkw.exchange', {'do': 2, 'request': '1000008000000000'}),
    ('store', {}), ('store.status', {}), ('restore', {'which': 'factory'}),
    ('samples.subscribe', {'signals': ['1/speed', '1/r0063'], 'period_ms': 1, 'batch_ms': 20}),
    ('samples.unsubscribe', {}), ('frames.unsubscribe', {}), ('events.unsubscribe', {}),
    ('unit.off', {}), ('units', {}), ('unit.on', {}), ('status', {}), ('quit', {}),
]
# Those that this unit may refuse: the bus is not off, an input that it does not have.
REFUSED = [('bus.restart', {}, 'refused')]
MAY_BE_REFUSED = {'input.analog', 'trace.read', 'restore', 'store'}

WRONG = [
    (b'hello', 'malformed'), (b'[1]', 'malformed'), (b'{"id": 1}', 'malformed'), (b'{"id": [1], "method": "status"}', 'malformed'),
    (b'{"id": 1, "method": "status", "params": 5}', 'malformed'), (b'{"id": 1, "method": "stat\xff"}', 'malformed'),
    (b'{"id": 1, "method": "status"', 'malformed'), (b'{"id":' + b'[' * 30000 + b']' * 30000 + b'}', 'malformed'),
    (b'{"id": 1, "method": "dance"}', 'unknown-method'), (b'{"id": 1, "method": ""}', 'unknown-method'),
    (b'{"id": 1, "method": "status", "params": {"unit": "vcan9/77"}}', 'unknown-unit'),
    (b'{"id": 1, "method": "fault.ack"}', 'bad-parameter'),
    (b'{"id": 1, "method": "fault.ack", "params": {"axis": 9}}', 'bad-parameter'),
    (b'{"id": 1, "method": "fault.ack", "params": {"axis": "1"}}', 'bad-parameter'),
    (b'{"id": 1, "method": "fault.inject", "params": {"axis": 1, "number": 9}}', 'not-found'),
    (b'{"id": 1, "method": "inject.add", "params": {"kind": "sdo.lat"}}', 'bad-parameter'),
    (b'{"id": 1, "method": "inject.add", "params": {"kind": "sdo.late"}}', 'bad-parameter'),
    (b'{"id": 1, "method": "inject.add", "params": {"kind": "sdo.late", "delay_ms": 5, "server": 9}}', 'refused'),
    (b'{"id": 1, "method": "inject.remove", "params": {"id": 9}}', 'not-found'),
    (b'{"id": 1, "method": "parameter.read", "params": {"parameters": ["p9999"]}}', 'not-found'),
    (b'{"id": 1, "method": "parameter.write", "params": {"parameter": "p1120", "value": -1}}', 'out-of-range'),
    (b'{"id": 1, "method": "parameter.write", "params": {"parameter": "1/r0063", "value": 1}}', 'read-only'),
    (b'{"id": 1, "method": "signal.read", "params": {"signals": ["1/dance"]}}', 'not-found'),
]


def closed(schema):
    """The same without members that it does not name."""
    schema = copy.deepcopy(schema)

    def close(node):
        if isinstance(node, dict):
            if isinstance(node.get('properties'), dict) and 'additionalProperties' not in node:
                node['additionalProperties'] = False
            for value in node.values():
                close(value)
        elif isinstance(node, list):
            for value in node:
                close(value)

    open_error = copy.deepcopy(schema['$defs']['error'])
    close(schema)
    schema['$defs']['error'] = open_error
    return schema


class Conversation:
    """A connection, and the lines that nobody has asked for."""

    def __init__(self, path, schema):
        self.schema = schema
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.settimeout(programs.PATIENCE)
        self.socket.connect(path)
        self.lines = self.socket.makefile('rb')
        self.notices = []
        self.validators = {}  # jsonschema.validate() would check the schema with every value

    def check(self, definition, value):
        if definition not in self.validators:
            self.validators[definition] = jsonschema.Draft202012Validator(
                {'$ref': f'#/$defs/{definition}', '$defs': self.schema['$defs']})
        self.validators[definition].validate(value)

    def answer_to(self, line):
        self.socket.sendall(line + b'\n')
        while True:
            got = self.lines.readline()
            assert got.endswith(b'\n'), f'no answer to {line[:100]}'
            answer = json.loads(got)
            if 'result' in answer or 'error' in answer:
                return answer
            self.notices.append(answer)

    def wait_for(self, key):
        """Reads notices until one with KEY has come."""
        while not any(key in notice for notice in self.notices):
            self.notices.append(json.loads(self.lines.readline()))

    def ask(self, method, params):
        request = {'id': 1, 'method': method, 'params': params}
        self.check('request.' + method, request)
        answer = self.answer_to(json.dumps(request).encode())
        self.check('error' if 'error' in answer else 'answer.' + method, answer)
        return answer


def main():
    bin_folder, schema_file = sys.argv[1:]
    schema = json.loads(pathlib.Path(schema_file).read_text(encoding='utf-8'))
    jsonschema.Draft202012Validator.check_schema(schema)
    methods = {name[len('request.'):] for name in schema['$defs'] if name.startswith('request.')}
    asked = {request[0] for request in REQUESTS + REFUSED}
    assert methods == asked, f'not asked for: {methods - asked}, not in the schema: {asked - methods}'
    with programs.Folder(bin_folder) as folder:
        programs.start_unit(folder, audit=True)
        can_master.CanMaster().try_to_write(5, 0x1000, 0, 0, 4)  # something for audit.get
        path = next(pathlib.Path(folder.folder.name).glob('axisd*.sock'))
        talk = Conversation(str(path), closed(schema))
        for line, code in WRONG:
            answer = talk.answer_to(line)
            talk.check('error', answer)
            assert answer['error']['code'] == code, (line[:100], answer)
        for method, params, code in REFUSED:
            assert talk.ask(method, params)['error']['code'] == code, method
        for method, params in REQUESTS:
            answer = talk.ask(method, params)
            assert 'error' not in answer or method in MAY_BE_REFUSED, (method, params, answer)
            assert answer.get('error', {}).get('code') != 'unknown-method', method
            if 'batch_ms' in params:
                talk.wait_for('samples')
        for notice in talk.notices:
            talk.check('notice', notice)
        kinds = {key for notice in talk.notices for key in notice}
        assert kinds == {'event', 'frames', 'sample', 'samples'}, kinds


if __name__ == '__main__':
    main()
