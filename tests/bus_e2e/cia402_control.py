"""What the control socket says of a CiA 402 device, and refuses: cia402_control.py BIN-FOLDER

To be run by with-can, on a bus of its own.
"""

import json
import os
import pathlib
import sys
import time

import control_client
import programs

STATES = ['Not ready to switch on', 'Switch on disabled', 'Ready to switch on', 'Switched on', 'Operation enabled',
          'Quick stop active', 'Fault reaction active', 'Fault']
# What belongs to a drive unit with parameters.
REFUSED = [
    ('parameter.read', {'parameters': ['1/p1120']}),
    ('parameter.write', {'parameter': '1/p1120', 'value': 1}),
    ('parameter.list', {'axis': 1}),
    ('panel.get', {'axis': 1}),
    ('panel.take', {'axis': 1}),
    ('identification.get', {'axis': 1}),
    ('input.list', {}),
    ('output.list', {}),
    ('input.set', {'input': 1, 'state': True}),
]


def start(folder):
    with open(folder.path('axisd.json'), 'w', encoding='ascii') as file:
        json.dump({'profile': 'cia402', 'node_id': 5, 'axes': [{}, {}]}, file)
    unit = folder.start('axisd', '--interface', f'unix:{os.environ["CAN_BUS"]}', '--config', folder.path('axisd.json'))
    unit.expect('ready: node 5 on')
    path = next(pathlib.Path(folder.folder.name).glob('axisd-*-5.sock'))
    return control_client.ControlClient(str(path), programs.PATIENCE)


def refusal_of(client, method, **params):
    try:
        client.call(method, **params)
    except control_client.ControlError as error:
        return error.args[0]
    raise AssertionError(f'{method} {params} was not refused')


def write(client, item, value):
    client.call('object.write', index=item, value=value)


def wait_for(what, look):
    deadline = time.monotonic() + programs.PATIENCE
    while time.monotonic() < deadline:
        if look():
            return
        time.sleep(0.02)
    raise AssertionError(f'{what} has not come')


def axis_of(client, number=1):
    return client.call('status')['axes'][number - 1]


def check_status(client):
    status = client.call('status')
    assert status['profile'] == 'cia402', status['profile']
    first = status['axes'][0]
    assert (first['state'], first['mode'], first['homed']) == ('Switch on disabled', 'no mode', False), first
    assert first['error_code'] == '0x0000' and first['digital_inputs'].startswith('0x'), first


def check_refusals(client):
    for method, params in REFUSED:
        error = refusal_of(client, method, **params)
        assert error['code'] == 'refused', (method, error)
        assert error['message'] == (f'{method}: this device has no parameters: its profile is cia402, see object.read'), error


def check_state_machine(client):
    machine = client.call('state.machine', axis=2)
    assert machine['states'] == STATES, machine['states']
    assert sorted({row['number'] for row in machine['transitions'] if 'number' in row} | {1, 16}) == sorted(
        {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16}), machine
    shutdown = next(row for row in machine['transitions'] if row.get('number') == 2)
    assert '6840h' in shutdown['conditions'][0]['text'], shutdown


def check_a_move(client):
    """As an operator does it, by objects; the second axis stays where it is."""
    for word in (6, 7, 15):
        write(client, '6040', word)
    write(client, '6060', 1)
    axis = axis_of(client)
    assert (axis['state'], axis['mode']) == ('Operation enabled', 'profile position'), axis
    wait_for('the reason', lambda: client.call('explain', axis=1)['reasons'][0].startswith('No set-point'))
    write(client, '607A', 20000)
    write(client, '6040', 0x1F)
    wait_for('the target', lambda: abs(axis_of(client)['position_units'] - 20000) <= 2)
    assert axis_of(client, 2)['state'] == 'Switch on disabled'
    assert axis_of(client, 2)['position_units'] == 0


def check_faults(client):
    """One that is injected is acknowledged by the socket as by the edge of bit 7."""
    client.call('fault.inject', axis=1, number=7860)
    wait_for('the fault', lambda: axis_of(client)['state'] == 'Fault')
    assert axis_of(client)['error_code'] != '0x0000'
    client.call('fault.ack', axis=1)
    axis = axis_of(client)
    assert axis['state'] == 'Switch on disabled', axis


def check_injected_words(client):
    """A controlword that is ignored acts when it is no longer; a bit of the statusword lies."""
    write(client, '6040', 0)
    deaf = client.call('inject.add', kind='drive.ignores-controlword', axis=1)['id']
    liar = client.call('inject.add', kind='drive.status-bit', axis=1, bit=6, value=0)['id']
    wait_for('the bit', lambda: int(axis_of(client)['statusword'], 16) & 0x40 == 0)
    write(client, '6040', 6)
    assert axis_of(client)['state'] == 'Switch on disabled', axis_of(client)
    client.call('inject.remove', id=liar)
    wait_for('the true bit', lambda: int(axis_of(client)['statusword'], 16) & 0x40 != 0)
    client.call('inject.remove', id=deaf)
    wait_for('the word that waits', lambda: axis_of(client)['state'] == 'Ready to switch on')


def check_storage(client):
    client.call('store')
    wait_for('the save', lambda: client.call('store.status')['is_stored'])
    assert refusal_of(client, 'restore', which='stored')['code'] == 'refused'


def main():
    with programs.Folder(sys.argv[1]) as folder:
        client = start(folder)
        check_status(client)
        check_refusals(client)
        check_state_machine(client)
        check_a_move(client)
        check_faults(client)
        check_injected_words(client)
        check_storage(client)


main()
