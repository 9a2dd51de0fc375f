#!/usr/bin/env python3
"""Leads CANopen masters through faults of a drive, each on a user-space bus of its own, and tells what they did:

with-can --private -- faults.py [--master NAME] [--fault NAME] [--patience SECONDS]

Needs axisd, axisctl, candump, cansend, node with the npm packages canopen and socketcan, and python3-can. A master that has not ended by
itself after PATIENCE (10 s) is said to wait, and ended.
"""

import argparse
import concurrent.futures
import dataclasses
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
MASTERS = {
    'npm': ['node', str(HERE.parent / 'masters/npm/turn.js')],
    'python-can': ['python3', str(HERE / 'turn_python_can.py')],
}
NODE = '5'
BEFORE, BEHIND = 3, 5  # frames that are shown before and behind the one of the fault


@dataclasses.dataclass
class Fault:
    """What is injected before the master starts, and the frame at which it is seen."""
    name: str
    words: str  # of axisctl inject add
    seen: str  # pattern of a line of candump; empty: the last frames are shown


FAULTS = [
    Fault('none', '', ''),
    Fault('dies in motion', 'node.reset --while operation-enabled --event tpdo --after 40 --delay-ms 200', r' 705 .* 00$'),
    Fault('SDO abort in the boot sequence', 'sdo.abort --code 0x08000022 --after 1 --times 1', r' 585 .* 80 '),
    Fault('SDO answer after the time-out', 'sdo.late --delay-ms 3300 --after 1 --times 1', r' 585 .* 43 18 10 01| 605 .* 80 08 10'),
    Fault('reboots in configuration', 'node.reset --event sdo-response --after 4 --delay-ms 300', r' 705 .* 00$'),
    Fault('frozen feedback', 'drive.frozen --while operation-enabled --event tpdo --after 40', ''),
]


class Bench:
    """A bus, what happens on it, and a drive, which are there as long as the block."""

    def __init__(self, folder):
        self.folder, self.programs = folder, []
        self.bus, self.socket, self.dump = (os.path.join(folder, name) for name in ('bus', 'control', 'dump'))
        self.environment = {**os.environ, 'CAN_BUS': self.bus}

    def start(self, words, **options):
        program = subprocess.Popen(words, **{'env': self.environment, 'stdin': subprocess.DEVNULL, **options})
        self.programs.append(program)
        return program

    def __enter__(self):
        with open(os.path.join(self.folder, 'unit.json'), 'w', encoding='ascii') as file:
            json.dump({'axes': [{'parameters': {'p1120': 0.5, 'p1121': 0.5}}]}, file)
        with open(self.dump, 'wb') as file:
            self.start(['candump', '-td', 'vcan0'], stdout=file)
        # The drive is on the bus when candump is: the boot-up message is the first line.
        until(lambda: self.members() == 1)
        unit = self.start(['axisd', '--interface', f'unix:{self.bus}', '--node-id', NODE, '--control', self.socket,
                           '--state-directory', self.folder, '--config', os.path.join(self.folder, 'unit.json')],
                          stderr=subprocess.DEVNULL)
        until(lambda: ' 705 ' in self.frames() or unit.poll() is not None)
        return self

    def __exit__(self, *_):
        for program in self.programs:
            program.kill()
            program.wait()

    def members(self):
        status = subprocess.run(['canhub', '--status', '--path', self.bus], stdin=subprocess.DEVNULL, capture_output=True,
                                text=True, check=False)
        return status.stdout.count(' vcan0 ')

    def frames(self):
        with open(self.dump, encoding='ascii') as file:
            return file.read()

    def all_frames(self):
        """The lines of candump when it has written down what has been on the bus until now."""
        subprocess.run(['cansend', 'vcan0', '7FF#'], env=self.environment, stdin=subprocess.DEVNULL, check=True)
        until(lambda: ' 7FF ' in self.frames())
        return [line for line in self.frames().splitlines() if ' 7FF ' not in line]

    def ask(self, *words):
        """What axisctl answers."""
        run = subprocess.run(['axisctl', '--socket', self.socket, '--json', *words], stdin=subprocess.DEVNULL, capture_output=True,
                             text=True, check=False)
        if run.returncode != 0:
            raise SystemExit(f'axisctl {" ".join(words)}: {run.stdout}{run.stderr}')
        return json.loads(run.stdout)


def until(holds):
    """Waits until HOLDS, which comes at once but on a machine that has other things to do."""
    end = time.monotonic() + 60
    while not holds():
        if time.monotonic() > end:
            raise SystemExit('faults.py: bus and drive do not get ready')
        time.sleep(0.05)


def lead(name, command, fault, patience):
    """What the master NAME does when FAULT comes: lines."""
    with tempfile.TemporaryDirectory(prefix='faults-') as folder, Bench(folder) as bench:
        if fault.words:
            bench.ask('inject', 'add', *fault.words.split())
        before = len(bench.frames().splitlines())
        begin = time.monotonic()
        master = bench.start(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        try:
            said, _ = master.communicate(timeout=patience)
            end = f'ends after {time.monotonic() - begin:.1f} s with exit status {master.returncode}'
        except subprocess.TimeoutExpired:
            master.kill()
            said, _ = master.communicate()
            end = f'still waits after {patience:g} s'
        axis = bench.ask('status')['axes'][0]
        hits = sum(each['hits'] for each in bench.ask('inject', 'list')['faults'])
        lines = [f'## {fault.name}: {name}', f'axisctl inject add {fault.words}: hits {hits}' if fault.words else 'no fault', f'{name} {end}']
        lines += ['  | ' + line for line in told(said)]
        lines += [f'  the drive is left in {axis["state"]} at {axis["speed_rpm"]:.0f} rpm']
        lines += ['  ' + line for line in around(bench.all_frames()[before:], fault.seen)]
        return lines


def told(said):
    """The lines of the master but those that show where in its source it has failed."""
    return [line.rstrip(' {') for line in said.splitlines() if line and not re.match(r'[\s/}]|Traceback|node:|Node\.js', line)]


def around(lines, seen):
    """The frames next to the first that SEEN describes."""
    at = next((i for i, line in enumerate(lines) if seen and re.search(seen, line)), None)
    if at is None:
        return lines[-BEFORE:]
    return lines[max(0, at - BEFORE):at + BEHIND + 1]


def main():
    arguments = argparse.ArgumentParser(description='Leads CANopen masters through faults of a drive.')
    arguments.add_argument('--master', choices=MASTERS)
    arguments.add_argument('--fault', choices=[fault.name for fault in FAULTS])
    arguments.add_argument('--patience', type=float, default=10)
    chosen = arguments.parse_args()
    if 'CAN_BUS' not in os.environ:
        sys.exit('faults.py: runs under with-can --private --')
    runs = [(name, command, fault, chosen.patience) for fault in FAULTS if chosen.fault in (None, fault.name)
            for name, command in MASTERS.items() if chosen.master in (None, name)]
    with concurrent.futures.ThreadPoolExecutor(len(runs)) as pool:
        for lines in pool.map(lambda run: lead(*run), runs):
            print('\n'.join(lines) + '\n', flush=True)


if __name__ == '__main__':
    main()
