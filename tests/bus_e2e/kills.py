"""Programs are killed at random instants: kills.py BIN-FOLDER [--kills N] [--seed N] [--scene NAME]

To be run by with-can. Each scene kills a program N times (SIGKILL) and looks at what is there afterwards:

store       axisd while it saves: the old or the new value is there, the new one if its save was answered
stores      the same of four units of one program that save at once
load        axisd while two masters ask it: the next one starts, on the same bus
hub         canhub with two units as members: both go on, and are on the next hub, which one of them may have started
suspended   axisd is stopped (SIGSTOP) for a moment and goes on, then killed

The seed is printed; the last line has the number of kills and of what was lost.
"""

import argparse
import contextlib
import json
import os
import random
import signal
import sys
import time

import programs
from sdo_client import ANSWER, SAVE, Client

READY = r'ready: node \d+'


class Scene:
    """The folder of a scene, its random numbers, and what it has found."""

    def __init__(self, arguments, folder):
        self.arguments, self.folder = arguments, folder
        self.random = random.Random(arguments.seed)
        self.lost = 0

    def unit(self, *options):
        return self.folder.start('axisd', '--interface', f'unix:{os.environ["CAN_BUS"]}', '--control', 'none',
                                 '--state-directory', self.folder.path('state'), *options)

    def kill_after(self, program, longest):
        """Kills PROGRAM within LONGEST s."""
        time.sleep(self.random.uniform(0, longest))
        program.kill()
        self.folder.programs.remove(program)

    def miss(self, what):
        self.lost += 1
        print(what, flush=True)


def save_and_kill(scene, client, nodes, options):
    """One life of units that save a value each; the values that they may have afterwards are looked at in the next life."""
    allowed = {node: {0} for node in nodes}
    for kill in range(scene.arguments.kills):
        unit = scene.unit(*options)
        for _ in nodes:
            unit.expect(READY)
        client.drain()
        for node in nodes:
            found = client.read(node)
            if found not in allowed[node]:
                scene.miss(f'kill {kill}: node {node} has {found} ms, expected one of {sorted(allowed[node])}')
            allowed[node] = {found}
        value = 100 + kill % 60_000
        for node in nodes:
            client.request(node, 0x2B, 0x1017, 0, value)
        assert len(client.answers(ANSWER, len(nodes))) == len(nodes)
        for node in nodes:
            client.request(node, 0x23, 0x1010, 1, SAVE)
            allowed[node].add(value)
        scene.kill_after(unit, scene.random.choice([0.0005, 0.003, 0.02]))
        for node, data in client.drain():
            if data[0] == 0x60:
                allowed[node] = {value}


def store(scene, client):
    save_and_kill(scene, client, [5], ['--node-id', '5'])


def stores(scene, client):
    nodes = [1, 2, 3, 4]
    with open(scene.folder.path('units.json'), 'w', encoding='ascii') as file:
        json.dump({'units': [{'interface': f'unix:{os.environ["CAN_BUS"]}', 'node_id': {'from': 1, 'to': 4}}]}, file)
    scene.unit = lambda *_: scene.folder.start('axisd', '--config', scene.folder.path('units.json'), '--control', 'none',
                                               '--state-directory', scene.folder.path('state'))
    save_and_kill(scene, client, nodes, [])


def load(scene, client):
    other = Client()
    for _ in range(scene.arguments.kills):
        unit = scene.unit('--node-id', '5')
        unit.expect(READY)
        for _ in range(scene.random.randrange(1, 20)):
            client.request(5, 0x40, 0x1000, 0)
            other.request(5, 0x40, 0x1018, 1)
        scene.kill_after(unit, 0.005)
    unit = scene.unit('--node-id', '5')
    unit.expect(READY)
    client.drain()
    if client.read(5) != 0:
        scene.miss('the last unit does not answer as a new one')


def hub(scene, _):
    path = scene.folder.path('bus')
    program = scene.folder.start('canhub', '--path', path)
    program.expect('ready')
    units = []
    for node in (5, 6):
        units.append(scene.folder.start('axisd', '--interface', f'unix:{path}', '--node-id', str(node), '--control', 'none',
                                        '--state-directory', scene.folder.path('state')))
        units[-1].expect(READY)
    for kill in range(scene.arguments.kills):
        time.sleep(scene.random.uniform(0, 0.01))
        kill_hubs(path)
        program.kill()
        scene.folder.programs.remove(program)
        program = scene.folder.start('canhub', '--path', path)
        program.expect('ready|is served by another canhub')
        for unit in units:
            try:
                unit.expect('is up again')
            except AssertionError as error:
                scene.miss(f'kill {kill}: {error}')
                return


def kill_hubs(path):
    """Kills whoever serves PATH: one that a unit has started has no parent here."""
    for process in filter(str.isdigit, os.listdir('/proc')):
        with contextlib.suppress(FileNotFoundError, ProcessLookupError):
            with open(f'/proc/{process}/cmdline', 'rb') as file:
                words = file.read().split(b'\0')
            if words[0].endswith(b'canhub') and path.encode() in words:
                os.kill(int(process), signal.SIGKILL)


def suspended(scene, client):
    for kill in range(scene.arguments.kills):
        unit = scene.unit('--node-id', '5')
        unit.expect(READY)
        client.drain()
        for _ in range(3):
            unit.process.send_signal(signal.SIGSTOP)
            client.request(5, 0x40, 0x1017, 0)
            time.sleep(scene.random.uniform(0, 0.01))
            unit.process.send_signal(signal.SIGCONT)
            if not client.answers(ANSWER):
                scene.miss(f'kill {kill}: a unit that was suspended has not answered')
        scene.kill_after(unit, 0.002)


SCENES = {'store': store, 'stores': stores, 'load': load, 'hub': hub, 'suspended': suspended}


def play(name, arguments):
    with programs.Folder(arguments.bin) as folder:
        scene = Scene(arguments, folder)
        begin = time.monotonic()
        SCENES[name](scene, Client())
        print(f'{name}: {arguments.kills} kills in {time.monotonic() - begin:.0f} s, lost {scene.lost}', flush=True)
        return scene.lost


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('bin')
    parser.add_argument('--kills', type=int, default=20)
    parser.add_argument('--seed', type=int, default=random.SystemRandom().randrange(1_000_000))
    parser.add_argument('--scene', choices=SCENES)
    arguments = parser.parse_args()
    print(f'seed {arguments.seed}', flush=True)
    names = [arguments.scene] if arguments.scene else list(SCENES)
    lost = sum(play(name, arguments) for name in names)
    print(f'{arguments.kills * len(names)} kills, lost {lost}')
    sys.exit(1 if lost else 0)


main()
