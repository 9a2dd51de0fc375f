"""axisd-agent with its units and hubs, axisd-nats, and axisd-http before a farm, do all that they can in the sandbox of their units, over a
server with TLS.

usage: sandboxed_farm.py PROGRAMS UNITS-FOLDER SOURCES

To be run by own_network.sh. A system call that the unit refuses ends the program (tests/systemd/in_sandbox.py).
"""

import grp
import json
import os
import pathlib
import ssl
import subprocess
import sys
import time
import urllib.request

import fleet_hosts
import nats_client
import sandboxes
from hosts import PATIENCE, Bench, Server, wait_until

SERVICES = ('axisd-agent', 'axisd-nats', 'axisd-http')
UNITS = ('line1.1', 'line1.2', 'line2.1')
PAGE = 'http://127.0.0.1:8402'
fleet_hosts.URL = 'tls://localhost:4222/lab'


class SandboxedBench(Bench):
    """One that starts programs of a farm as services, and has them speak TLS."""

    def __init__(self, programs, units_folder):
        super().__init__(programs)
        self.units_folder, self.services = pathlib.Path(units_folder), []

    def start(self, *words, env=None, **options):
        name = pathlib.Path(str(words[0])).name
        if name not in SERVICES:
            return super().start(*words, env=env, **options)
        folder = self.folder / f'service-{len(self.services)}'
        folder.mkdir()
        service = sandboxes.Service(folder)
        words = sandboxes.words_of(self.units_folder / f'{name}.service', [*words, '--tls-ca', self.folder / 'tls' / 'ca.crt'])
        process = super().start(*words, env={**(env or os.environ), **service.environment}, **options)
        service.hears('READY=1')
        self.services.append((process, service))
        return process

    def end_services(self):
        for process, service in reversed(self.services):
            service.hears('WATCHDOG=1')
            process.terminate()
            service.hears('STOPPING=1')
            status = process.wait(2 * PATIENCE)
            assert status == 0, (process.args, status)


class Fleet(fleet_hosts.Fleet):
    """One whose server takes nobody without TLS."""

    def __init__(self, bench, sources):
        self.tls = bench.folder / 'tls'
        subprocess.run([sources / 'examples/fleet/certificates.sh', self.tls, 'localhost'], check=True)
        self.context = ssl.create_default_context(cafile=self.tls / 'ca.crt')
        super().__init__(bench)

    def serve(self):
        return Server(self.bench, settings=f'tls {{ cert_file: "{self.tls}/server.crt", key_file: "{self.tls}/server.key" }}')

    def connect(self):
        try:
            self.client = nats_client.Client(('localhost', 4222), tls=self.context, no_responders=True)
        except OSError:
            return False
        self.asked = 0
        return True

    def axisctl(self, *words):
        return super().axisctl('--tls-ca', self.tls / 'ca.crt', *words)

    def is_kept(self, unit, file):
        try:
            self.axisctl('fleet', 'state', 'export', unit.replace('.', '/'), file)
        except AssertionError:
            return False
        return True


def saved(fleet, unit):
    return fleet.ask(unit, 'parameter.read', parameters=['1/p1121'])['result']['parameters'][0]['value']


def serve(bench):
    """The units over HTTP."""
    bench.start(bench.program('axisd-http'), '--farm', fleet_hosts.URL, '--listen', PAGE.removeprefix('http://'),
                env={**os.environ, 'STATE_DIRECTORY': str(bench.folder)})

    def names():
        with urllib.request.urlopen(f'{PAGE}/api/v1/units') as answer:
            return answer.read().decode()

    wait_until(lambda: all(unit.replace('.', '/') in names() for unit in UNITS), f'the gateway has the units, not {names()}')
    with urllib.request.urlopen(f'{PAGE}/api/v1/units/line1/1') as answer:
        assert json.loads(answer.read())['nmt_state'] == 'Pre-operational'


def use(fleet, bench):
    wanted = [{'bus': unit.split('.')[0], 'node_id': int(unit.split('.')[1]), 'axes': [{}],
               'record': {'name': 'run', 'signals': ['1/r0063'], 'every_s': 0.01}} for unit in UNITS]
    file = bench.folder / 'fleet.json'
    file.write_text(json.dumps({'units': wanted}))
    fleet.axisctl('fleet', 'apply', '--unchecked', file)
    fleet.await_units(UNITS)
    assert fleet.place(UNITS[0])['host'] == 'a'
    assert 'result' in fleet.ask(UNITS[0], 'parameter.write', parameter='1/p1121', value=7.5)
    assert 'result' in fleet.ask(UNITS[0], 'store')
    wait_until(lambda: fleet.is_kept(UNITS[0], bench.folder / 'kept'), 'what was saved lies on the server')
    fleet.axisctl('--unit', 'line1/1', 'fault', 'inject', '1', '7860')
    path = bench.folder / 'run-a' / 'line1' / 'can-bus'
    status = subprocess.run([bench.program('canhub'), '--status', '--path', path], capture_output=True, text=True, check=True).stdout
    assert 'whole' in status, status
    for host in fleet.hosts.values():
        for process in [host.agent.pid, host.door.pid, *host.processes('axisd'), *host.processes('canhub')]:
            assert 'Seccomp:\t2' in pathlib.Path(f'/proc/{process}/status').read_text(), 'what a service starts is confined as well'
    # What ends is started again, a document that changes is followed, one that is wrong is told.
    os.kill(fleet.hosts['a'].running()[UNITS[1]], 9)
    wait_until(lambda: fleet.place(UNITS[1]).get('restarts') == 1, 'the agent has seen that its unit has ended')
    fleet.want(UNITS[2], {'configuration': {'axes': [{}, {}]}})
    fleet.want('line2.9', {'configuration': {'axes': [{'motr': '1fk7063'}]}})
    fleet.await_problem('line2.9', 'unknown key')
    fleet.await_units(UNITS)
    serve(bench)
    # A second host takes all from the first one.
    fleet.add('b', '--control-group', grp.getgrgid(os.getegid()).gr_name)
    fleet.axisctl('fleet', 'drain', 'a')
    wait_until(lambda: not fleet.hosts['a'].running(), 'a host gives its units away')
    fleet.await_units(UNITS)
    assert {place['host'] for place in fleet.places(UNITS).values()} == {'b'}
    assert saved(fleet, UNITS[0]) == 7.5


def main():
    programs, units_folder, sources = sys.argv[1:]
    begin = time.monotonic()
    with SandboxedBench(programs, units_folder) as bench:
        fleet = Fleet(bench, pathlib.Path(sources))
        try:
            fleet.add('a', '--control-group', grp.getgrgid(os.getegid()).gr_name)
            use(fleet, bench)
            bench.end_services()
        finally:
            fleet.end()
        logs = [host.log.read_text(encoding='utf-8') for host in fleet.hosts.values()]
        killed = [line for log in logs for line in log.splitlines() if 'signal 31' in line]
        assert not killed, killed
    print(json.dumps({'seconds': round(time.monotonic() - begin, 1), 'refused': 0}))


main()
