"""Programs that run beside a test, in a folder of their own."""

import contextlib
import json
import os
import re
import select
import subprocess
import tempfile
import time

PATIENCE = 20  # s, for what should come at once: machines of others are slow


class Program:
    """A program and what it has written so far to standard error."""

    def __init__(self, words, environment, output=subprocess.DEVNULL):
        self.words = words
        self.text = ''
        self.process = subprocess.Popen(words, env=environment, stdin=subprocess.DEVNULL, stdout=output,
                                        stderr=subprocess.PIPE)

    def expect(self, pattern):
        """Waits until PATTERN has been written behind what was expected before."""
        deadline = time.monotonic() + PATIENCE
        while True:
            found = re.search(pattern, self.text)
            if found:
                self.text = self.text[found.end():]
                return found
            ready, _, _ = select.select([self.process.stderr], [], [], max(0, deadline - time.monotonic()))
            part = os.read(self.process.stderr.fileno(), 4096) if ready else b''
            if not part:
                raise AssertionError(f'{self.words[0]} has not written "{pattern}", only: {self.text}')
            self.text += part.decode()

    def rest(self):
        """What it has written until its end behind what was expected."""
        return self.text + self.process.stderr.read().decode()

    def kill(self):
        self.process.kill()
        self.process.wait()

    def end(self):
        """Ends it with SIGTERM; its exit status."""
        self.process.terminate()
        return self.process.wait(PATIENCE)

    def leave(self):
        """Nobody needs it any more. Where coverage is counted it ends by itself: who is killed leaves no counts."""
        if 'COUNT_COVERAGE' in os.environ and self.process.poll() is None:
            with contextlib.suppress(subprocess.TimeoutExpired):
                self.end()
        self.kill()


class Folder:
    """A new folder, the programs that are started in it, and the folder's end with theirs."""

    def __init__(self, bin_folder):
        self.bin_folder = bin_folder
        self.programs = []

    def __enter__(self):
        self.folder = tempfile.TemporaryDirectory(prefix='axisd-test-')
        self.environment = {'HOME': self.folder.name, 'XDG_RUNTIME_DIR': self.folder.name, 'PATH': os.environ['PATH']}
        return self

    def __exit__(self, *_):
        for program in self.programs:
            program.leave() if isinstance(program, Program) else program.kill()
        self.folder.cleanup()

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def start(self, name, *options):
        program = Program([os.path.join(self.bin_folder, name), *options], self.environment)
        self.programs.append(program)
        return program

    def candump(self, probe):
        """candump on vcan0, which listens: it has shown a frame of the identifier PROBE; the file of its log."""
        log = self.path('candump.log')
        with open(log, 'wb') as file:
            self.programs.append(subprocess.Popen(['candump', '-L', 'vcan0'], stdout=file))
        while not os.path.getsize(log):
            subprocess.run(['cansend', 'vcan0', f'{probe:03X}#00'], check=True, timeout=PATIENCE)
            time.sleep(0.02)
        return log

    def output_of(self, name, *options):
        """Runs a program that ends by itself; its standard output."""
        return subprocess.run([os.path.join(self.bin_folder, name), *options], env=self.environment, check=True,
                              capture_output=True, text=True, timeout=PATIENCE).stdout


def start_unit(folder, axis=None, **keys):
    """axisd as node 5 with short ramps, ready on the bus of with-can; `axis` adds to its axis, `keys` to its configuration."""
    with open(folder.path('axisd.json'), 'w', encoding='ascii') as file:
        json.dump({'axes': [{'parameters': {'p1120': 0.5, 'p1121': 0.5}, **(axis or {})}], **keys}, file)
    unit = folder.start('axisd', '--interface', f'unix:{os.environ["CAN_BUS"]}', '--node-id', '5',
                        '--config', folder.path('axisd.json'))
    unit.expect('ready: node 5 on')
    return unit
