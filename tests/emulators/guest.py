"""A guest with an emulated CAN controller on the bus of with-can, made by examples/emulators/qemu.sh."""

import os
import subprocess
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
SOURCE = os.path.dirname(os.path.dirname(HERE))
EXAMPLES = os.path.join(SOURCE, 'examples', 'emulators')
sys.path.insert(0, os.path.join(HERE, os.pardir, 'bus_e2e'))
PATIENCE = 150  # s, for a guest that is emulated on a busy machine

# What a guest does first: its interface, and candump that writes into `log` all that comes, error frames too.
LISTENING = r"""
set -eu
ip link set can0 up type can bitrate 125000
candump -L can0,0:0,#FFFFFFFF >log &
until grep -qE '^ *can0 ' /proc/net/can/rcvlist_all; do sleep 0.1; done
heard() { grep -qE " $1$" log; }
"""


class Guest:
    """A guest that runs SCRIPT, a file, on the bus $CAN_BUS; OPTIONS are those of qemu.sh."""

    def __init__(self, bin_folder, script, *arguments, options=()):
        environment = {**os.environ, 'PATH': f'{bin_folder}:{os.environ["PATH"]}'}
        self.started = time.monotonic()
        self.process = subprocess.Popen(
            [os.path.join(EXAMPLES, 'qemu.sh'), '--timeout', str(PATIENCE), *options, script, *arguments],
            env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, text=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait(PATIENCE)
        self.process.stdout.close()

    def line(self):
        """The next line that the guest writes."""
        text = self.process.stdout.readline()
        print(f'{time.monotonic() - self.started:6.1f} s  {text}', end='')
        assert text, f'the guest has ended with {self.process.wait()}'
        return text.rstrip('\n')

    def output(self):
        """The rest of what it writes, when it has ended well."""
        text, _ = self.process.communicate()
        print(text, end='')
        assert self.process.returncode == 0, f'the guest ended with {self.process.returncode}'
        return text.splitlines()


def write_script(folder, name, text):
    path = folder.path(name)
    with open(path, 'w', encoding='ascii') as file:
        file.write(text)
    return path
