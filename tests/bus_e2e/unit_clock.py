"""A unit is given the time with cansend, as examples/clock does it: unit_clock.py BIN-FOLDER SCRIPT

To be run by with-can, on a bus of its own. No time is asserted but the order of what happened: between this machine's clock before
and after lies that of the unit.
"""

import datetime
import json
import os
import subprocess
import sys

import programs

TRIES = 5

def now():
    """UTC, cut off to milliseconds as the unit and `date` have it."""
    time = datetime.datetime.now(datetime.timezone.utc)
    return time.replace(microsecond=time.microsecond // 1000 * 1000)


def main():
    bin_folder, script = sys.argv[1:]
    with programs.Folder(bin_folder) as folder:
        socket = folder.path('control.sock')

        def axisctl(*words):
            return json.loads(folder.output_of('axisctl', '--socket', socket, '--json', *words))

        unit = folder.start('axisd', '--interface', f'unix:{os.environ["CAN_BUS"]}', '--node-id', '5',
                            '--control', socket, '--state-directory', folder.path('state'))
        unit.expect('ready: node 5 on')
        assert 'utc' not in axisctl('status')
        for method in 'simple', 'ping-snap':
            # A unit that stands still while the pauses of the script pass gets ping and snap at once.
            for _ in range(TRIES):
                before = now()
                subprocess.run([script, 'vcan0', '5', method], check=True, timeout=programs.PATIENCE)
                clock = axisctl('status')['utc']
                after = now()
                if clock['synchronised'] and clock['method'] == method:
                    break
            assert clock['synchronised'], clock
            assert clock['method'] == method, clock
            time = datetime.datetime.fromisoformat(clock['time'].replace('Z', '+00:00'))
            assert before <= time <= after, f'{before} <= {time} <= {after}'
        axisctl('fault', 'inject', '1', '7860')
        [fault] = axisctl('fault', 'list')['messages']
        stamp = datetime.datetime.fromisoformat(fault['utc'].replace('Z', '+00:00'))
        assert time <= stamp <= now(), fault
        assert unit.end() == 0


main()
