"""Every n-th call of a program fails, each in turn: failing_calls.py BIN-FOLDER LIBRARY [--every N] [--program NAME] [--kinds K,...]

To be run by with-can. For each kind of calls (tests/support/failing_calls.h) that PROGRAM makes in a dialogue, the first one fails, then
the second one, and so on; with --every N each N-th of a kind that has many. The program goes on, or ends as its exit statuses say with one
line on standard error; it is ended by no signal, and what was saved is there whole when it starts again. The last line has the number
of calls that failed.
"""

import argparse
import errno
import json
import mmap
import os
import re
import signal
import socket
import struct
import subprocess
import sys
import time

import programs

KINDS = re.findall(r'X\((\w+)\)', open(os.path.join(os.path.dirname(__file__), '../support/failing_calls.h'),
                                       encoding='ascii').read())[1:]
ERRORS = {'open': errno.EMFILE, 'read': errno.EIO, 'write': errno.ENOSPC, 'short_write': 0, 'fsync': errno.EIO,
          'rename': errno.EIO, 'unlink': errno.EACCES, 'mkdir': errno.EACCES, 'socket': errno.EMFILE, 'bind': errno.EADDRINUSE,
          'listen': errno.EADDRINUSE, 'connect': errno.ECONNREFUSED, 'accept': errno.EMFILE, 'send': errno.ENOBUFS,
          'receive': errno.ENOMEM, 'epoll': errno.ENOMEM, 'wait': errno.EINTR, 'timer': errno.EMFILE, 'eventfd': errno.EMFILE,
          'map': errno.ENOMEM, 'thread': errno.EAGAIN, 'memory': errno.ENOMEM}
MOST_OF_KIND = 100_000   # of what a program calls all the time, so many are tried
SIZE_OF_COUNTS = 4096
SAVE = struct.unpack('<I', b'save')[0]
ANSWER = 3  # s, for an answer of a program that is well; a save may wait for the disk


class Client:
    """A socket on the bus of with-can, with the requests of a master to node 5."""

    def __init__(self):
        self.socket = socket.socket(socket.AF_CAN, socket.SOCK_RAW, socket.CAN_RAW)
        self.socket.bind(('vcan0',))

    def ask(self, command, index, sub_index, value=0):
        """The answer to an SDO request, nothing if there is none."""
        self.socket.send(struct.pack('<IB3xBHBI', 0x605, 8, command, index, sub_index, value))
        end = time.monotonic() + ANSWER
        while (left := end - time.monotonic()) > 0:
            self.socket.settimeout(left)
            try:
                frame = self.socket.recv(16)
            except TimeoutError:
                return None
            if struct.unpack('<I', frame[:4])[0] == 0x585 and frame[9:12] == struct.pack('<HB', index, sub_index):
                return frame[8:]
        return None

    def heartbeat_time(self):
        answer = self.ask(0x40, 0x1017, 0)
        return struct.unpack('<H', answer[4:6])[0] if answer and answer[0] == 0x4B else None


class Run:
    """One run of a program in which one call fails, or none."""

    def __init__(self, arguments, kind=None, number=0):
        self.arguments, self.kind, self.number = arguments, kind, number
        self.folder = programs.Folder(arguments.bin)

    def __enter__(self):
        self.folder.__enter__()
        self.counts_file = self.folder.path('counts')
        with open(self.counts_file, 'wb') as file:
            file.truncate(SIZE_OF_COUNTS)
        return self

    def __exit__(self, *rest):
        self.folder.__exit__(*rest)

    def start(self, name, *options, fails=True):
        environment = dict(self.folder.environment, CAN_BUS=os.environ['CAN_BUS'])
        if fails:
            environment |= {'LD_PRELOAD': self.arguments.library, 'FAIL_COUNTS': self.counts_file}
            if self.kind:
                environment['FAIL_CALL'] = f'{self.kind} {self.number} {ERRORS[self.kind]}'
        program = programs.Program([os.path.join(self.arguments.bin, name), *options], environment)
        self.folder.programs.append(program)
        return program

    def counts(self):
        with open(self.counts_file, 'r+b') as file, mmap.mmap(file.fileno(), SIZE_OF_COUNTS) as page:
            return dict(zip(KINDS, struct.unpack_from(f'<{len(KINDS)}Q', page)))


def is_up(program, pattern, longest=5):
    """Whether PROGRAM has written PATTERN; not if it has ended before."""
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


def end(program):
    """Ends PROGRAM if it runs; its exit status and what it has written."""
    if program.process.poll() is None:
        program.process.terminate()
    status = program.process.wait(programs.PATIENCE)
    os.set_blocking(program.process.stderr.fileno(), True)
    return status, program.rest()


def unit_options(run):
    return ['--interface', f'unix:{os.environ["CAN_BUS"]}', '--node-id', '5', '--state-directory', run.folder.path('state'),
            '--control', run.folder.path('axisd.sock')]


def axisd_dialogue(run, client):
    """Saves a heartbeat time of 100 ms, then one of 200 ms, each by a run of its own of which the second one is that with the failure."""
    first = run.start('axisd', *unit_options(run), fails=False)
    first.expect('ready: node 5')
    client.ask(0x2B, 0x1017, 0, 100)
    assert client.ask(0x23, 0x1010, 1, SAVE)[0] == 0x60
    assert end(first)[0] == 0

    unit = run.start('axisd', *unit_options(run))
    kept = None
    if is_up(unit, 'ready: node 5|is down'):
        client.ask(0x2B, 0x1017, 0, 200)
        answer = client.ask(0x23, 0x1010, 1, SAVE)
        kept = answer is not None and answer[0] == 0x60
        axisctl = subprocess.run([os.path.join(run.arguments.bin, 'axisctl'), '--socket', run.folder.path('axisd.sock'), 'status'],
                                 env=run.folder.environment, capture_output=True, text=True, timeout=programs.PATIENCE)
        assert axisctl.returncode >= 0, axisctl
    status, said = end(unit)

    last = run.start('axisd', *unit_options(run), fails=False)
    last.expect('ready: node 5')
    found = client.heartbeat_time()
    assert found == 200 if kept else found in (100, 200), f'saved {kept}, and found {found} ms\n{said}\n{end(last)[1]}'
    assert end(last)[0] == 0
    return status, said


def canhub_dialogue(run, _):
    """Two members, of which one hears what the other says, and the status."""
    path = run.folder.path('hub')
    hub = run.start('canhub', '--path', path)
    if is_up(hub, 'ready'):
        environment = dict(run.folder.environment, CAN_BUS=path)
        with_can = [os.path.join(run.arguments.bin, 'with-can'), '--bus', path, '--']
        for frame in '123#11', '124#22':
            subprocess.run([*with_can, 'cansend', 'vcan0', frame], env=environment, capture_output=True, timeout=programs.PATIENCE)
        subprocess.run([os.path.join(run.arguments.bin, 'canhub'), '--status', '--path', path], env=environment, capture_output=True,
                       timeout=programs.PATIENCE)
    return end(hub)


def gateway_dialogue(run, _):
    """A unit, the gateway before it, and some requests."""
    unit = run.start('axisd', *unit_options(run), fails=False)
    unit.expect('ready: node 5')
    gateway = run.start('axisd-http', '--listen', '127.0.0.1:0')
    if is_up(gateway, r'http://[\d.]+:(\d+)'):
        port = int(re.search(r'http://[\d.]+:(\d+)', gateway.text)[1])
        for path in ('/api/v1/units', '/', '/metrics', '/nothing'):
            try:
                with socket.create_connection(('127.0.0.1', port), ANSWER) as connection:
                    connection.settimeout(ANSWER)
                    connection.sendall(f'GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nConnection: close\r\n\r\n'.encode())
                    while connection.recv(65536):
                        pass
            except OSError:
                pass
    return end(gateway)


DIALOGUES = {'axisd': axisd_dialogue, 'canhub': canhub_dialogue, 'axisd-http': gateway_dialogue}


def judge(program, status, said):
    """PROGRAM has ended as it may: by itself, and not without a word if it has failed."""
    where = f'exit status {status}\n{said}'
    assert status in (0, 1, 2), where
    assert 'Sanitizer' not in said and 'terminate called' not in said, where
    assert status == 0 or re.search(rf'^{program}: .+', said, re.MULTILINE), where


def numbers_of(count, every):
    step = max(every, -(-count // MOST_OF_KIND))
    return range(1, count + 1, step)


def fail_each(arguments, program, client):
    dialogue = DIALOGUES[program]
    with Run(arguments) as run:
        status, said = dialogue(run, client)
        assert status == 0, said
        counts = run.counts()
    tried, wrong = {}, 0
    for kind in arguments.kinds or KINDS:
        for number in numbers_of(counts[kind], arguments.every):
            try:
                with Run(arguments, kind, number) as run:
                    judge(program, *dialogue(run, client))
            except AssertionError as error:
                wrong += 1
                print(f'{program}: {kind} {number}: {error}', flush=True)
            tried[kind] = tried.get(kind, 0) + 1
    print(f'{program}: ' + ', '.join(f'{kind} {count} of {counts[kind]}' for kind, count in tried.items()), flush=True)
    return sum(tried.values()), wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('bin')
    parser.add_argument('library')
    parser.add_argument('--every', type=int, default=1)
    parser.add_argument('--program', choices=DIALOGUES)
    parser.add_argument('--kinds', type=lambda text: text.split(','))
    arguments = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    client = Client()
    results = [fail_each(arguments, program, client) for program in ([arguments.program] if arguments.program else DIALOGUES)]
    tried, wrong = map(sum, zip(*results))
    print(json.dumps({'failed_calls': tried, 'wrong': wrong}))
    sys.exit(1 if wrong else 0)


main()
