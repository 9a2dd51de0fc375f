"""A daemon, a hub, a gateway, masters and faults for long: soak.py BIN-FOLDER [--seconds N] [--interface vcan0] [--seed N] [--json FILE]

To be run by with-can, or with --interface where the kernel has CAN. Three units (two drive units and a CiA 402 device) are
driven, asked, saved, reset and hurt all the time. Every ten seconds memory and descriptors of the programs are looked at. The last line
has what was done, and how many cycles the units have skipped, which a busy machine makes them do. What must not happen ends it with status 1:

- an SDO request without its answer, an answer to another one, a heartbeat that is overdue
- an axis that is not in Operation enabled some seconds after its fault was taken back
- a request of HTTP without an answer, or with another status
- memory that has grown by more than 2 MiB behind the first tenth, or one descriptor more
- a program that has ended
"""

import argparse
import json
import os
import random
import struct
import sys
import time

import programs
from http_client import Gateway
from sdo_client import SAVE
from watched_bus import ANSWER, Bus, Failure

ENABLED_WITHIN = 10.0  # s
MEMORY_ROOM = 2048  # KiB
NODES = {1: 2, 2: 1, 3: 1}  # axes by node-ID
PROFILED = 3  # the CiA 402 device
READABLE = [(0x1000, 0), (0x1018, 1), (0x1008, 0), (0x6041, 0), (0x1A00, 0), (0x1001, 0), (0x5F00, 0)]


class Soak:
    """The programs, what is done with them, and what was seen."""

    def __init__(self, arguments, folder):
        self.random = random.Random(arguments.seed)
        self.folder = folder
        self.counts = {}
        interface = arguments.interface
        self.programs = {}
        if interface is None:
            path = folder.path('bus')
            self.programs['canhub'] = folder.start('canhub', '--path', path)
            self.programs['canhub'].expect('ready')
            os.environ['CAN_BUS'] = path
            interface = f'unix:{path}'
        self.bus = Bus(arguments.interface or 'vcan0')
        with open(folder.path('units.json'), 'w', encoding='ascii') as file:
            json.dump({'units': [{'interface': interface, 'node_id': node} | self.device(node) for node in NODES]}, file)
        self.programs['axisd'] = folder.start('axisd', '--config', folder.path('units.json'),
                                              '--state-directory', folder.path('state'))
        for _ in NODES:
            self.programs['axisd'].expect(r'ready: node \d+')
        self.gateway = Gateway(folder)
        self.programs['axisd-http'] = self.gateway.program
        self.units = {}
        for name in self.gateway.wait_for_units(lambda units: len(units) == len(NODES)):
            self.units[int(name.rsplit('/', 1)[1])] = f'/api/v1/units/{name}'
        for node in NODES:
            self.commission(node)

    @staticmethod
    def device(node):
        if node == PROFILED:
            return {'profile': 'cia402', 'axes': [{}]}
        return {'axes': [{'parameters': {'p1120': 0.5, 'p1121': 0.5}}] * NODES[node]}

    def count(self, what):
        self.counts[what] = self.counts.get(what, 0) + 1

    def commission(self, node):
        self.bus.write(node, 0x1017, 0, 500, 2)
        self.bus.send(0, bytes([1, node]))
        self.enable(node)

    def control(self, node, axis, word):
        if node == PROFILED:
            self.bus.write(node, 0x6040, 0, word, 2)
        else:
            self.bus.write(node, 0x6040 + 0x800 * (axis - 1), 0, word, 2)

    def enable(self, node):
        """All axes to Operation enabled, over faults that are there."""
        for axis in range(1, NODES[node] + 1):
            offset = 0x800 * (axis - 1)
            end = time.monotonic() + ENABLED_WITHIN
            if node == PROFILED:
                self.bus.write(node, 0x6060, 0, 3, 1)
            while True:
                answer = self.bus.ask(node, 0x40, 0x6041 + offset, 0)
                state = struct.unpack('<H', answer[4:6])[0] & 0x6F
                if state == 0x27:
                    break
                if time.monotonic() > end:
                    raise Failure(f'axis {axis} of node {node} has statusword {state:02X}h')
                if state & 0x08:
                    self.control(node, axis, 0)
                    self.control(node, axis, 0x80)
                else:
                    self.control(node, axis, {0x40: 0x06, 0x60: 0x06, 0x21: 0x07, 0x23: 0x0F, 0x07: 0x00}.get(state, 0x06))
                self.listen(0.02)

    def listen(self, duration):
        until = time.monotonic() + duration
        while self.bus.next(until):
            pass

    # What may happen.

    def read(self, node):
        index, sub_index = self.random.choice(READABLE)
        self.bus.ask(node, 0x40, index, sub_index)

    def turn(self, node):
        for axis in range(1, NODES[node] + 1):
            self.bus.write(node, 0x60FF + 0x800 * (axis - 1), 0, self.random.randrange(-200_000, 200_000) & 0xFFFFFFFF, 4)

    def save(self, node):
        self.bus.write(node, 0x1010, 1, SAVE, 4)

    def hurt(self, node):
        axis = self.random.randrange(1, NODES[node] + 1)
        self.ask_gateway('POST', node, f'/axes/{axis}/faults', {'number': 7860})
        self.listen(0.5)
        self.enable(node)

    def disturb(self, node):
        self.ask_gateway('POST', node, '/injected', {'kind': 'sdo.late', 'delay_ms': 5, 'times': 3})
        for _ in range(4):
            self.read(node)
        self.ask_gateway('DELETE', node, '/injected')

    def reset(self, node):
        self.bus.heard.pop(node, None)
        self.bus.send(0, bytes([0x81, node]))
        until = time.monotonic() + ANSWER
        while frame := self.bus.next(until):
            if frame == (0x700 + node, b'\0'):
                self.listen(0.05)
                return self.commission(node)
        raise Failure(f'node {node} has not booted')

    def power(self, node):
        self.bus.heard.pop(node, None)
        self.ask_gateway('POST', node, '/power/off')
        self.listen(0.3)
        self.ask_gateway('POST', node, '/power/on')
        self.listen(1.0)
        self.commission(node)

    def look(self, node):
        self.ask_gateway('GET', node, self.random.choice(['', '/pdos', '/explain?axis=1', '/faults', '/storage']))
        self.ask_gateway('GET', None, '/metrics')

    def ask_gateway(self, verb, node, path, body=None):
        if verb == 'POST' and body is None:
            body = {}
        status, _, answer = self.gateway.request(verb, (self.units[node] if node else '') + path, body)
        self.count('HTTP requests')
        if status not in (200, 201, 202, 204):
            raise Failure(f'{verb} {path} of node {node}: {status} {answer}')
        return answer

    ACTS = [(read, 60), (turn, 10), (look, 10), (save, 2), (hurt, 2), (disturb, 2), (reset, 1), (power, 1)]

    def act(self):
        act = self.random.choices([act for act, _ in self.ACTS], [weight for _, weight in self.ACTS])[0]
        act(self, self.random.choice(list(NODES)))
        self.count(act.__name__)
        self.listen(0.01)

    def miss(self):
        now = time.monotonic()
        for node, heard in self.bus.heard.items():
            if now - heard > 2:
                raise Failure(f'node {node} has not been heard for {now - heard:.1f} s')

    def sample(self):
        """Memory (KiB) and descriptors of every program, and what units have skipped."""
        found = {}
        for name, program in self.programs.items():
            if program.process.poll() is not None:
                raise Failure(f'{name} has ended: {program.rest()}')
            pid = program.process.pid
            with open(f'/proc/{pid}/status', encoding='ascii') as file:
                memory = next(int(line.split()[1]) for line in file if line.startswith('VmRSS'))
            found[name] = (memory, len(os.listdir(f'/proc/{pid}/fd')))
        return found

    def skipped(self):
        return sum(self.ask_gateway('GET', node, '')['skipped_cycles'] for node in NODES)


def judge(samples):
    """What has grown behind the first tenth."""
    grown = []
    first = samples[len(samples) // 10:]
    for name in samples[0]:
        memories, descriptors = zip(*(sample[name] for sample in first))
        half = len(first) // 2
        print(f'{name}: memory {memories[0]} to {memories[-1]} KiB (most {max(memories)}), descriptors {descriptors[0]} to {descriptors[-1]} (most {max(descriptors)})')
        if memories[-1] > memories[0] + MEMORY_ROOM:
            grown.append(f'{name} has grown from {memories[0]} to {memories[-1]} KiB')
        if half and min(descriptors[half:]) > max(descriptors[:half]):
            grown.append(f'{name} has more and more descriptors')
    return grown


def run(arguments):
    with programs.Folder(arguments.bin) as folder:
        soak = Soak(arguments, folder)
        begin = time.monotonic()
        samples, due, failures = [], 0.0, []
        while (gone := time.monotonic() - begin) < arguments.seconds and not failures:
            try:
                if gone >= due:
                    samples.append(soak.sample())
                    due += 10
                soak.act()
                soak.miss()
            except (Failure, AssertionError, OSError) as failure:
                failures.append(f'after {gone:.0f} s: {failure}')
        samples.append(soak.sample())
        failures += judge(samples)
        skipped = None if failures else soak.skipped()
        result = {'seconds': round(time.monotonic() - begin), 'frames': soak.bus.frames, **soak.counts, 'skipped_cycles': skipped,
                  'failures': failures}
        print(json.dumps(result))
        if arguments.json:
            with open(arguments.json, 'w', encoding='ascii') as file:
                json.dump({**result, 'samples': samples}, file)
        return failures


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('bin')
    parser.add_argument('--seconds', type=float, default=60)
    parser.add_argument('--interface', help='an interface of the kernel in place of a hub')
    parser.add_argument('--seed', type=int, default=random.SystemRandom().randrange(1_000_000))
    parser.add_argument('--json')
    arguments = parser.parse_args()
    print(f'seed {arguments.seed}', flush=True)
    failures = run(arguments)
    for failure in failures:
        print(failure, file=sys.stderr)
    sys.exit(1 if failures else 0)


main()
