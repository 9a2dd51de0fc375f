"""Two units in one process, one of which follows the speed of the other: slave_to_slave.py BIN-FOLDER EXAMPLE-FOLDER

What examples/slave-to-slave tells its readers to run. To be run by with-can, on a bus of its own.
"""

import json
import os
import struct
import subprocess
import sys
import time

import programs
from control_client import ControlClient
from master import Master, can

LEADER, FOLLOWER = 5, 6
SPEED = 52428800  # increments a second, 750 rpm
TRIES, SECONDS = 5, 3


def velocity(data):
    return struct.unpack('<i', data[2:6])[0]


def switch_on(script, control):
    """Runs SCRIPT until both axes are on: its controlwords come after pauses, too close for a unit that stands still meanwhile."""
    names = [unit['unit'] for unit in control.call('units')['units']]
    for _ in range(TRIES):
        subprocess.run([script, 'vcan0'], check=True, timeout=4 * programs.PATIENCE)
        deadline = time.monotonic() + SECONDS
        while time.monotonic() < deadline:
            states = [control.call('status', unit=name)['axes'][0]['state'] for name in names]
            if states == ['Operation enabled'] * 2:
                return
    raise AssertionError(states)


def main():
    example = sys.argv[2]
    with programs.Folder(sys.argv[1]) as folder, can.Bus('vcan0', interface='socketcan') as bus:
        with open(os.path.join(example, 'two-units.json'), encoding='ascii') as file:
            configuration = json.load(file)
        for unit in configuration['units']:
            assert unit['interface'] == 'vcan0', unit
            unit['interface'] = f'unix:{os.environ["CAN_BUS"]}'
            unit['axes'] = [{'parameters': {'p1120': 0.5, 'p1121': 0.5}}]
        with open(folder.path('two-units.json'), 'w', encoding='ascii') as file:
            json.dump(configuration, file)
        units = folder.start('axisd', '--config', folder.path('two-units.json'),
                             '--control', folder.path('control.sock'), '--state-directory', folder.path('state'))
        master = Master(bus)
        boot_ups = set()
        while boot_ups != {LEADER, FOLLOWER}:
            message = bus.recv(programs.PATIENCE)
            assert message is not None, boot_ups
            boot_ups.add(message.arbitration_id - 0x700)
        switch_on(os.path.join(example, 'slave-to-slave.sh'), ControlClient(folder.path('control.sock'), programs.PATIENCE))
        # The leader turns, tells its speed, and the follower turns with it.
        master.receive(0x380 + LEADER, lambda data: abs(struct.unpack('<h', data)[0] - 0x1000) < 0x30)
        master.receive(0x280 + FOLLOWER, lambda data: len(data) == 6 and abs(velocity(data) - SPEED) < SPEED // 100)
        master.send(0x300 + LEADER, '0f00' + struct.pack('<i', 0).hex())
        master.receive(0x280 + FOLLOWER, lambda data: len(data) == 6 and abs(velocity(data)) < SPEED // 100)
        assert units.end() == 0


if __name__ == '__main__':
    main()
