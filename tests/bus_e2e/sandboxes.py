"""Programs in the sandbox of their unit files, as services of systemd: told where their folders are, heard when they are ready."""

import ctypes
import os
import pathlib
import queue
import re
import signal
import socket
import sys
import threading
import time

import programs

LAUNCHER = pathlib.Path(__file__).parent.parent / 'systemd' / 'in_sandbox.py'
WATCHDOG = 1  # s
PR_SET_CHILD_SUBREAPER = 36

ADDRESSES = 'names are resolved by addresses of this machine where they are known: getaddrinfo(3) has all of a name without'

# System calls that a unit refuses, that its programs make nevertheless, and why they can do without them. Any other one ends them.
SURVIVED = {
    'axisd-bus@.service': {'socket:AF_CAN': 'whether an interface is up is asked at a socket of CAN if there is one, else at a local one'},
    'axisd-http.service': {'socket:AF_NETLINK': ADDRESSES},
    'axisd-nats.service': {'socket:AF_NETLINK': ADDRESSES},
}


def words_of(unit_file, words):
    """Those that start the program WORDS in the sandbox of UNIT_FILE."""
    survived = ','.join(SURVIVED.get(pathlib.Path(unit_file).name, {}))
    return [sys.executable, str(LAUNCHER), '--survives', survived, str(unit_file), '--', *map(str, words)]


class Service:
    """What systemd gives a service, and hears of it. It listens always, as systemd does: a service would wait for it."""

    def __init__(self, folder):
        self.socket = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
        self.socket.bind(f'{folder}/notify')
        self.heard = queue.SimpleQueue()
        threading.Thread(target=self._listen, daemon=True).start()
        self.environment = {'NOTIFY_SOCKET': f'{folder}/notify', 'WATCHDOG_USEC': str(WATCHDOG * 1_000_000),
                            'PYTHONDONTWRITEBYTECODE': '1'}

    def hears(self, pattern):
        """Waits for a message with PATTERN."""
        end, heard = time.monotonic() + programs.PATIENCE, []
        while not heard or not re.search(pattern, heard[-1]):
            try:
                heard.append(self.heard.get(timeout=max(0, end - time.monotonic())))
            except queue.Empty:
                raise AssertionError(f'no {pattern}, only {heard}') from None

    def _listen(self):
        while True:
            self.heard.put(self.socket.recv(65536).decode())


class Folder(programs.Folder):
    """One whose service() runs as the unit file says, beside programs that run as they like."""

    def __init__(self, bin_folder, units_folder):
        super().__init__(bin_folder)
        self.units_folder, self.services = pathlib.Path(units_folder), []
        become_parent_of_orphans()

    def __enter__(self):
        super().__enter__()
        self.systemd = Service(self.folder.name)
        return self

    def __exit__(self, kind, *rest):
        if kind is not None:
            for program in self.services:
                print(f'{program.words[4]}: {status_of(program)}', file=sys.stderr)
        super().__exit__(kind, *rest)
        if kind is None:
            expect_orphans_end()

    def service(self, unit, name, *options):
        """Program NAME, which is ready, and of which systemd has heard so."""
        environment = {**self.environment, **self.systemd.environment}
        program = programs.Program(words_of(self.units_folder / unit, [os.path.join(self.bin_folder, name), *options]), environment)
        self.programs.append(program)
        self.services.append(program)
        try:
            self.systemd.hears('READY=1')
        except AssertionError as error:
            raise AssertionError(f'{unit}: {error}; {status_of(program)}') from None
        return program

    def end(self, program):
        """Ends a service as systemd does; whatever it did until then, no call of it was refused."""
        self.systemd.hears('WATCHDOG=1')
        if program.process.poll() is None:
            program.process.terminate()
        self.systemd.hears('STOPPING=1')
        status = program.process.wait(programs.PATIENCE)
        assert status == 0, f'{status_of(program)}'


def status_of(program):
    """How PROGRAM has ended, if it has, and what it has written."""
    status = program.process.poll()
    if status is None:
        os.set_blocking(program.process.stderr.fileno(), False)
        return f'it runs\n{program.text}{(program.process.stderr.read() or b"").decode()}'
    how = 'a system call was refused' if status == -signal.SIGSYS else f'exit status {status}'
    return f'{how}\n{program.rest()}'


def become_parent_of_orphans():
    """Hubs that a service has started are this process's when that has ended."""
    assert ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0) == 0


def expect_orphans_end():
    """They end by themselves when nobody is on their bus, and none by a system call that was refused."""
    end = time.monotonic() + programs.PATIENCE
    while time.monotonic() < end:
        try:
            child, status = os.waitpid(-1, os.WNOHANG)
        except ChildProcessError:
            return
        assert not child or os.waitstatus_to_exitcode(status) != -signal.SIGSYS, 'a hub has made a system call that was refused'
        if not child:
            time.sleep(0.02)
    raise AssertionError('a program that a service has started does not end')
