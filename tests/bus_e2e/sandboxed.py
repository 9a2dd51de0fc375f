"""axisd, its hubs and axisd-http do all that they can in the sandbox of their units: sandboxed.py BIN-FOLDER UNITS-FOLDER SCENE

To be run by with-can and, within that, own_network.sh. A system call that the unit refuses ends the program (tests/systemd/in_sandbox.py).

unit       axisd@.service: one unit on the bus: SDO, PDO, a save that is there after the next start, heartbeat, trace, recording
with_modbus, with_port_502: Modbus TCP, by the drop-ins in UNITS-FOLDER
bus        axisd-bus@.service: a hub that the unit starts, buses of the network
many       axisd.service: several units of a configuration on several buses, in both profiles
gateway    axisd-http.service: the page, the API, streams, metrics
interface  vcan@.service: an interface comes and goes, of a kind that every kernel has
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import time

import http_client
import programs
import sandboxes
from master import BOOT_UP, Master, can, drive
from modbus import Plain

HEARTBEAT_TIME = 0x1017
PORT = 29536
GROUP = '239.74.163.2'


def unit_options(folder, *options):
    return ['--interface', f'unix:{os.environ["CAN_BUS"]}', '--node-id', '5', '--state-directory', folder.path('state'), '--control',
            folder.path('axisd.sock'), *options]


def axisctl(folder, *words):
    return folder.output_of('axisctl', '--socket', folder.path('axisd.sock'), *words)


def write_configuration(folder, **content):
    pathlib.Path(folder.path('axisd.json')).write_text(json.dumps(content), encoding='ascii')
    return folder.path('axisd.json')


def save(master):
    master.write(HEARTBEAT_TIME, 0, b'\x64\x00')
    master.write(0x1010, 1, b'save')


def expect_saved(master):
    master.expect(*BOOT_UP)
    assert master.upload(HEARTBEAT_TIME) == b'\x64\x00'
    master.receive(0x705, lambda data: data[0] == 0x7F)


def unit(folder):
    configuration = write_configuration(folder, axes=[{'parameters': {'p1120': 0.2, 'p1121': 0.2}}], audit=True,
                                        record={'name': 'run', 'signals': ['1/r0063'], 'every_s': 0.01})
    options = unit_options(folder, '--config', configuration)
    with can.Bus('vcan0', interface='socketcan') as bus:
        master = Master(bus)
        program = folder.service('axisd@.service', 'axisd', *options)
        master.expect(*BOOT_UP)
        axisctl(folder, 'trace', 'start', '1/speed', '--trigger', 'rising signal=1/speed level=700', '--before', '0.1')
        drive(master)
        save(master)
        axisctl(folder, 'trace', 'read', '-o', folder.path('trace.csv'))
        assert 'r0063' in axisctl(folder, 'get', '1/r0063')
        for words in (['status'], ['fault', 'inject', '1', '7860'], ['fault', 'ack', '1'], ['load', '1', '2'], ['record', 'status'], ['audit'],
                      ['record', 'stop'], ['store']):
            axisctl(folder, *words)
        folder.end(program)
        program = folder.service('axisd@.service', 'axisd', *options)
        expect_saved(master)
        folder.end(program)


def with_modbus(folder, port=0):
    configuration = write_configuration(folder, modbus={'port': port}, parameters={'p2040': 0})
    program = folder.service('axisd@.service', 'axisd', *unit_options(folder, '--config', configuration))
    port = int(program.expect(r'Modbus TCP on 127\.0\.0\.1:(\d+)')[1])
    for _ in range(3):
        Plain(port).ask(bytes((3, 0, 99, 0, 1)))
    folder.end(program)


def with_port_502(folder):
    with_modbus(folder, 502)


def bus(folder):
    """A bus of its own, one whose hub serves socketcand, one of the network."""
    own, served = folder.path('can-bus'), folder.path('served')
    options = ['--node-id', '5', '--state-directory', folder.path('state'), '--control', folder.path('axisd.sock')]
    program = folder.service('axisd-bus@.service', 'axisd', '--interface', f'unix:{own}', *options)
    dump = subprocess.Popen([f'{folder.bin_folder}/with-can', '--bus', own, '--', 'candump', '-n', '1', 'vcan0,585:7ff'], stdout=subprocess.PIPE,
                            env=folder.environment, text=True)
    while dump.poll() is None:
        subprocess.run([f'{folder.bin_folder}/with-can', '--bus', own, '--', 'cansend', 'vcan0', '605#4000100000000000'], check=True,
                       env=folder.environment, timeout=programs.PATIENCE)
        time.sleep(0.1)
    assert '43 00 10 00 92 01 FF FF' in dump.stdout.read()
    assert 'axisd' in folder.output_of('canhub', '--status', '--path', own)
    folder.end(program)
    hub = folder.start('canhub', '--path', served, '--socketcand', f'127.0.0.1:{PORT}')
    hub.expect('ready')
    program = folder.service('axisd-bus@.service', 'axisd', '--interface', f'socketcand://localhost:{PORT}/vcan0', *options)
    with can.Bus(interface='socketcand', channel='vcan0', host='127.0.0.1', port=PORT) as wire:
        assert Master(wire).read(0x1000)
    folder.end(program)
    program = folder.service('axisd-bus@.service', 'axisd', '--interface', f'udp-multicast://{GROUP}:43113', *options)
    with can.Bus(interface='udp_multicast', channel=GROUP, port=43113, fd=False) as wire:
        assert Master(wire).read(0x1000)
    folder.end(program)


def many(folder):
    own = folder.path('can-bus')
    units = [{'interface': f'unix:{os.environ["CAN_BUS"]}', 'bus': 'line1', 'node_id': {'from': 5, 'to': 12}},
             {'interface': f'unix:{own}', 'bus': 'line2', 'node_id': 5, 'profile': 'cia402'},
             {'interface': f'udp-multicast://{GROUP}:43113', 'bus': 'line3', 'node_id': 7}]
    options = ['--config', write_configuration(folder, units=units), '--state-directory', folder.path('state'), '--control',
               folder.path('axisd.sock')]
    with can.Bus('vcan0', interface='socketcan') as wire:
        master = Master(wire)
        program = folder.service('axisd.service', 'axisd', *options)
        master.expect(*BOOT_UP)
        drive(master)
        save(master)
        for name in ('line1/12', 'line2/5', 'line3/7'):
            axisctl(folder, '--unit', name, 'status')
        folder.end(program)
        program = folder.service('axisd.service', 'axisd', *options)
        expect_saved(master)
        folder.end(program)


def gateway(folder):
    program = programs.start_unit(folder, audit=True)
    door = Served(folder)
    name = door.unit()
    for path in ('/', '/metrics', '/api/v1/server', '/api/v1/overview', name, f'{name}/parameters/p1120', f'{name}/audit'):
        assert door.request('GET', path)[0] == 200, path
    with door.stream(f'{name}/samples?signals=1/speed&period_ms=20') as samples, door.stream('/api/v1/events') as events:
        samples.expect('sample')
        events.expect('units')
        assert door.request('PUT', f'{name}/parameters/p1121', {'value': 3.5})[0] == 200
        assert door.request('POST', f'{name}/axes/1/faults', {'number': 7860})[0] == 200
    folder.end(door.program)
    assert program.end() == 0


class Served(http_client.Gateway):
    """The gateway as a service."""

    def __init__(self, folder):
        services = type('Services', (), {'start': lambda _, *words: folder.service('axisd-http.service', *words), 'path': folder.path})
        super().__init__(services())


def interface(folder):
    """The commands of vcan@.service."""
    ip = shutil.which('ip')
    for words in (('add', 'dev', 'vcan0', 'type', 'bridge'), ('set', 'dev', 'vcan0', 'up'), ('delete', 'dev', 'vcan0')):
        subprocess.run(sandboxes.words_of(folder.units_folder / 'vcan@.service', [ip, 'link', *words]), check=True, timeout=programs.PATIENCE)


SCENES = {each.__name__: each for each in (unit, with_modbus, with_port_502, bus, many, gateway, interface)}


def main():
    bin_folder, units_folder, scene = sys.argv[1:]
    begin = time.monotonic()
    with sandboxes.Folder(bin_folder, units_folder) as folder:
        SCENES[scene](folder)
    print(f'{scene}: {time.monotonic() - begin:.1f} s, no call was refused')


main()
