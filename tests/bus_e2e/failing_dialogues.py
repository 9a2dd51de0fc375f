"""The dialogues of failing_calls.py with programs on a bus and at a control socket."""

import os
import re
import socket
import struct
import subprocess
import time

import programs
from sdo_client import SAVE, Client

ANSWER = 3  # s, for an answer of a program that is well; a save may wait for the disk


class Master(Client):
    """The requests of a master to node 5."""

    def __init__(self, _):
        super().__init__()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.socket.close()

    def ask(self, command, index, sub_index, value=0):
        """The answer to an SDO request, nothing if there is none."""
        self.request(5, command, index, sub_index, value)
        end = time.monotonic() + ANSWER
        while (left := end - time.monotonic()) > 0:
            for _, data in self.answers(left):
                if data[1:4] == struct.pack('<HB', index, sub_index):
                    return data
        return None

    def heartbeat_time(self):
        answer = self.ask(0x40, 0x1017, 0)
        return struct.unpack('<H', answer[4:6])[0] if answer and answer[0] == 0x4B else None


def is_up(program, pattern, longest):
    """Whether PROGRAM has written PATTERN within LONGEST s; not if it has ended before."""
    end = time.monotonic() + longest
    os.set_blocking(program.process.stderr.fileno(), False)
    while time.monotonic() < end:
        part = program.process.stderr.read()
        program.text += part.decode() if part else ''
        if re.search(pattern, program.text):
            return True
        if program.process.poll() is not None:
            return False
        time.sleep(0.005)
    return False


def comes_up(run, program, pattern):
    """is_up(); where no call fails, it is."""
    up = is_up(program, pattern, 5 if run.kind else programs.PATIENCE)
    assert up or run.kind, program.text
    return up


def end(program):
    """Ends PROGRAM if it runs; its exit status and what it has written."""
    if program.process.poll() is None:
        program.process.terminate()
    try:
        status = program.process.wait(programs.PATIENCE)
    except subprocess.TimeoutExpired as late:
        raise AssertionError(f'it has not ended {programs.PATIENCE} s after SIGTERM') from late
    os.set_blocking(program.process.stderr.fileno(), True)
    return status, program.rest()


def unit_options(run):
    return ['--interface', f'unix:{os.environ["CAN_BUS"]}', '--node-id', '5', '--state-directory', run.folder.path('state'),
            '--control', run.folder.path('axisd.sock')]


def with_axisd(run, master):
    """Saves a heartbeat time of 100 ms, then one of 200 ms, each by a run of its own of which the second one is that with the failure."""
    first = run.start('axisd', *unit_options(run), fails=False)
    first.expect('ready: node 5')
    master.ask(0x2B, 0x1017, 0, 100)
    assert master.ask(0x23, 0x1010, 1, SAVE)[0] == 0x60
    assert end(first)[0] == 0

    unit = run.start('axisd', *unit_options(run))
    kept = None
    if comes_up(run, unit, 'ready: node 5|is down'):
        master.ask(0x2B, 0x1017, 0, 200)
        answer = master.ask(0x23, 0x1010, 1, SAVE)
        kept = answer is not None and answer[0] == 0x60
        axisctl = subprocess.run([os.path.join(run.arguments.bin, 'axisctl'), '--socket', run.folder.path('axisd.sock'), 'status'],
                                 env=run.folder.environment, capture_output=True, text=True, timeout=programs.PATIENCE)
        assert axisctl.returncode >= 0, axisctl
        assert run.kind or (kept and axisctl.returncode == 0), f'saved {kept}, {axisctl}'
    status, said = end(unit)

    last = run.start('axisd', *unit_options(run), fails=False)
    last.expect('ready: node 5')
    found = master.heartbeat_time()
    assert found == 200 if kept else found in (100, 200), f'saved {kept}, and found {found} ms\n{said}\n{end(last)[1]}'
    assert end(last)[0] == 0
    return status, said


def with_canhub(run, _):
    """Two members, of which one hears what the other says, and the status."""
    path = run.folder.path('hub')
    hub = run.start('canhub', '--path', path)
    if comes_up(run, hub, 'ready'):
        environment = dict(run.folder.environment, CAN_BUS=path)
        with_can = [os.path.join(run.arguments.bin, 'with-can'), '--bus', path, '--']
        listener = subprocess.Popen([*with_can, 'candump', '-L', '-n', '1', '-T', '2000', 'vcan0'], env=environment, stdout=subprocess.PIPE,
                                    stderr=subprocess.DEVNULL, text=True)
        while listener.poll() is None:
            subprocess.run([*with_can, 'cansend', 'vcan0', '123#11'], env=environment, capture_output=True, timeout=programs.PATIENCE)
            time.sleep(0.01)
        status = subprocess.run([os.path.join(run.arguments.bin, 'canhub'), '--status', '--path', path], env=environment,
                                capture_output=True, text=True, timeout=programs.PATIENCE)
        heard = listener.communicate()[0]
        assert run.kind or ('123#11' in heard and status.returncode == 0), f'heard "{heard}", {status}'
    return end(hub)


def answer_of(port, path):
    """The status of the answer to a GET of PATH; nothing if there is none."""
    try:
        with socket.create_connection(('127.0.0.1', port), ANSWER) as connection:
            connection.settimeout(ANSWER)
            connection.sendall(f'GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nConnection: close\r\n\r\n'.encode())
            with connection.makefile('rb') as answer:
                words = answer.read().split(b' ', 2)
                return int(words[1]) if len(words) > 1 else None
    except OSError:
        return None


def with_gateway(run, _):
    """A unit, the gateway before it, and some requests. A gateway that goes on answers the next one."""
    unit = run.start('axisd', *unit_options(run), fails=False)
    unit.expect('ready: node 5')
    gateway = run.start('axisd-http', '--listen', '127.0.0.1:0')
    if comes_up(run, gateway, r'http://[\d.]+:(\d+)'):
        port = int(re.search(r'http://[\d.]+:(\d+)', gateway.text)[1])
        found = [answer_of(port, path) for path in ('/api/v1/units', '/', '/metrics', '/nothing')]
        assert run.kind or found == [200, 200, 200, 404], found
        if not any(answer_of(port, '/metrics') == 200 for _ in range(2)):  # the call that fails may be one of the first
            try:
                gateway.process.wait(ANSWER)
            except subprocess.TimeoutExpired as late:
                raise AssertionError(f'it goes on, has answered {found}, and then nothing') from late
    return end(gateway)
