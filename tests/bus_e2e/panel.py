"""Master control by an operator panel, as clients of the control socket have it: panel.py BIN-FOLDER

To be run by with-can, on a bus of its own. The time of the panel is that of the unit; no time is asserted here, only waited for.
"""

import json
import pathlib
import sys
import time

import control_client
import programs

LONGEST = 30  # s, for what takes its time
SPEED = 300.0
# What the bus, which has sent nothing yet, makes of an axis that has just been given back.
HARMLESS = ('Switch on disabled', 'Ready to switch on')


def wait_for(what, look):
    """What LOOK returns when it is true."""
    deadline = time.monotonic() + LONGEST
    while time.monotonic() < deadline:
        found = look()
        if found:
            return found
        time.sleep(0.02)
    raise AssertionError(f'{what} has not come: {look()}')


def refusal_of(client, method, **params):
    try:
        client.call(method, **params)
    except control_client.ControlError as error:
        return error.args[0]
    raise AssertionError(f'{method} {params} was not refused')


class Listener:
    """The events of the unit, as they come to a connection of their own."""

    def __init__(self, path):
        self.client = control_client.ControlClient(path, LONGEST)
        self.client.call('events.subscribe', kinds=['drive-state', 'control'])

    def next(self, kind):
        """The next event of KIND; others are left out."""
        while True:
            event = json.loads(self.client.lines.readline()).get('event', {})
            if event.get('kind') == kind:
                return event

    def expect_states(self, *states):
        """Waits for STATES in this order; others may lie between them, but no fault."""
        for state in states:
            while (seen := self.next('drive-state')['state']) != state:
                assert seen in HARMLESS, (seen, state)


def turns(client):
    [axis] = client.call('status')['axes']
    return abs(axis['speed_rpm'] - SPEED) < 3 and axis['state'] == 'Operation enabled'


def check_a_panel_that_speaks(client, other, events):
    assert client.call('panel.get', axis=1)['active'] is False
    taken = client.call('panel.take', axis=1, timeout_ms=10000)
    assert taken['active'] and not taken['on'] and taken['timeout_ms'] == 10000, taken
    assert refusal_of(other, 'panel.take', axis=1)['code'] == 'refused'
    assert 'r0807' in client.call('panel.get', axis=1)['refusal']

    def renewed():
        client.call('panel.set', axis=1, on=True, speed_rpm=SPEED)
        return turns(client)

    wait_for('the speed of the panel', renewed)
    [reason] = client.call('explain', axis=1)['reasons']
    assert 'an operator panel leads it' in reason, reason
    [value] = client.call('parameter.read', parameters=['1/r0807'])['parameters']
    assert value['value'] == 1, value
    machine = client.call('state.machine', axis=1)
    assert machine['state'] == 'Operation enabled', machine['state']
    client.call('panel.release', axis=1)
    given = wait_for('the end of the control', lambda: not client.call('panel.get', axis=1)['active'])
    assert given
    assert refusal_of(client, 'panel.set', axis=1, on=True, speed_rpm=1)['code'] == 'refused'
    assert events.next('control')['method'] == 'panel.take'
    told = events.next('control')
    assert told['method'] == 'panel.set' and told['by'] == 'control' and 'speed_rpm 300' in told['text'], told


def check_a_panel_that_falls_silent(client, path):
    events = Listener(path)
    client.call('panel.take', axis=1, timeout_ms=5000)
    client.call('panel.set', axis=1, on=True, speed_rpm=SPEED)
    events.expect_states('Switched on', 'Operation enabled', 'OFF1 braking', 'Ready to switch on')
    wait_for('the end of the control', lambda: not client.call('panel.get', axis=1)['active'])


def check_an_inhibited_panel(client):
    client.call('parameter.write', parameter='1/p0806', value=1)
    refusal = refusal_of(client, 'panel.take', axis=1)
    assert refusal['code'] == 'refused' and 'p0806' in refusal['message'], refusal


def main():
    with programs.Folder(sys.argv[1]) as folder:
        programs.start_unit(folder)
        path = str(next(pathlib.Path(folder.folder.name).glob('axisd*.sock')))
        client, other = (control_client.ControlClient(path, programs.PATIENCE) for _ in range(2))
        check_a_panel_that_speaks(client, other, Listener(path))
        check_a_panel_that_falls_silent(client, path)
        check_an_inhibited_panel(client)


main()
