"""Runs blocks of commands of the documentation as somebody who pastes it: run_block.py BIN-FOLDER SOURCE-FOLDER NAME

Each block goes to the standard input of a shell whose folder looks like the source tree. Behind "->" a comment says what
comes: a frame, which candump must show, or a text, which a program must print; each behind the one before. In a block with
prompts ("$ COMMAND") everything that is printed has to be what stands there.
"""

import dataclasses
import os
import re
import shutil
import signal
import subprocess
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, 'bus_e2e'))
import pages  # noqa: E402  pylint: disable=wrong-import-position
import programs  # noqa: E402  pylint: disable=wrong-import-position

LONGEST = 150  # s
SKIPPED = 77
MODULES = 'build/master/node_modules'
DEVIATIONS = 'build/release/share/axisd/eds/axisd-deviations.json'


@dataclasses.dataclass
class Blocks:
    """Blocks of one page that are pasted one after the other, and the world they are pasted into."""
    page: str
    starts: list  # of the first line of each block
    can: bool = False  # where every CAN interface is the bus of with-can
    unit: bool = False  # the same with axisd as node 5
    # Files that the reader has: name, and what it is a copy of, from the source or (bin/...) from the build.
    copies: dict = dataclasses.field(default_factory=dict)
    npm: bool = False  # with the packages that the page tells to install
    one_shell: bool = False  # into the same shell, which goes on from block to block
    saved: dict = dataclasses.field(default_factory=dict)  # blocks that the reader saves: name of the file, and first line
    check: str = ''  # function of this file that judges the rest


BLOCKS = {
    'turn': Blocks('README.md', ['candump vcan0 & sleep'], unit=True, check='reached_speed'),
    'disturb': Blocks('docs/how-to/disturb.md', ['PATH=$PATH:build/release/bin'], unit=True, check='unit_has_ended'),
    'panel': Blocks('docs/how-to/panel.md', ['axisctl panel show 1'], unit=True),
    'without_can': Blocks('README.md', ['axisd --interface unix:']),
    'ci_bus': Blocks('docs/how-to/ci.md', ['with-can -- candump vcan0 &']),
    'ci_python': Blocks('docs/how-to/ci.md', ['with-can -- pytest-3 examples/ci/test_drive.py']),
    'ci_npm': Blocks('docs/how-to/ci.md', ['NODE_PATH=examples/masters/npm/node_modules'], npm=True),
    'ci_shell': Blocks('docs/how-to/ci.md', ['with-can --private -- examples/ci/drive.sh']),
    'preload': Blocks('docs/reference/preload.md', ['with-can -- candump vcan0 &']),
    'bus_faults': Blocks('docs/reference/bus-faults.md', ['candump vcan0 & sleep 1'], can=True),
    'clock': Blocks('docs/how-to/clock.md', ['candump vcan0 & sleep', 'candump vcan0,585:7FF'], unit=True),
    'faults': Blocks('docs/reference/faults.md', ['$ axisctl inject add'], unit=True),
    'explain': Blocks('docs/reference/control.md', ['$ axisctl explain 1'], unit=True),
    'first_session': Blocks('docs/tutorial/first-session.md',
                            ['with-can -- candump', 'axisctl status', 'send()', 'axisctl watch', 'axisctl trace start',
                             'axisctl fault inject', 'with-can -- python3 master.py'], one_shell=True,
                            saved={'master.py': 'import struct'}),
    'cia402': Blocks('docs/how-to/cia402.md',
                     ['with-can -- candump vcan0,285~7FF', 'send()', 'send 605#2F98600018000000', 'send 605#2F60600001000000',
                      'with-can -- python3 csp.py'], one_shell=True, saved={'axis.json': '{', 'csp.py': 'import math'}),
    'observe': Blocks('docs/how-to/observe.md', ['axisctl trace start', 'axisctl record start'], unit=True),
    'test_a_slave': Blocks('docs/how-to/test-a-slave.md',
                           ['axisd --interface unix: --node-id 5 &', 'axisd --interface unix: --node-id 5 & sleep 2'],
                           copies={'eds/axisd.eds': 'eds/axisd.eds',
                                   DEVIATIONS: DEVIATIONS}),
    'example_slave': Blocks('examples/README.md', ['candump vcan0 & sleep 1'], can=True,
                            copies={'example_slave': 'bin/tests/example_slave'}),
    'edstool': Blocks('docs/reference/edstool.md', ['edstool show'],
                      copies={name: name for name in ('eds/axisd.eds', 'eds/axisd-unit.eds')}),
    'scenarios': Blocks('docs/how-to/scenarios.md', ['axisctl run --list'],
                        saved={'lost-setpoint.json': '{"title": "The axis goes on'}),
    'fixtures': Blocks('docs/how-to/fixtures.md', ['pytest-3 -n 4', 'python3 two_units.py', 'pytest-3 test_time.py', 'pytest-3 test_master.py'],
                       saved={'test_drive.py': 'import axisd', 'two_units.py': 'from axisd', 'test_time.py': 'import pytest',
                              'test_master.py': 'import can'}),
    'fixtures_node': Blocks('docs/how-to/fixtures.md', ['node --test'], saved={'drive.test.js': "const assert"}),
    'http': Blocks('docs/reference/http.md', ['axisd-http & sleep 2'], unit=True),
    'if1': Blocks('docs/reference/interfaces.md', ['axisctl set 1/p0922', 'axisctl ds47', 'axisctl pkw'], unit=True),
    'zoo': Blocks('docs/reference/zoo.md', ['canopen-zoo --run NeverToggles --interface unix: --node 5 &',
                                            'canopen-zoo --run NeverAcknowledges',
                                            'canopen-zoo --run NeverToggles --interface unix: --node 5 --eds']),
    'lint': Blocks('docs/reference/eds-checks.md', ['edstool lint --severity error'],
                   copies={'device.eds': 'eds/axisd.eds', 'known.txt': 'tests/docs/known.txt'}),
}


def block_of(text, start):
    """The block whose first line begins with START, or is it."""
    blocks = [block.lines for block in pages.blocks_of(text)[0]]
    found = [lines for lines in blocks if lines[0] == start] or [lines for lines in blocks if lines[0].startswith(start)]
    assert len(found) == 1, f'{len(found)} blocks begin with "{start}"'
    return found[0]


def promises(block):
    """What comments say that comes."""
    return [found[1].strip() for line in block if (found := re.search(r'#.*-> (.+)$', line))]


def frames_of(output):
    """The frames that candump has shown, as cansend writes them."""
    shown = re.findall(r'^\s*\S+\s+([0-9A-F]{3})\s+\[\d\]((?: +[0-9A-F]{2})*)\s*$', output, re.MULTILINE)
    return [f'{identifier}#{data.replace(" ", "")}' for identifier, data in shown]


def missing(block, output):
    """The first promise that has not been kept, or nothing."""
    frames, text = iter(frames_of(output)), output
    for promise in promises(block):
        if re.fullmatch('[0-9A-F]{3}#[0-9A-F]*', promise):
            if promise not in frames:  # takes the iterator behind it
                return promise
        else:
            before, found, text = text.partition(promise)
            if not found:
                return promise
    return None


def reached_speed(output, _):
    speeds = [int.from_bytes(bytes.fromhex(frame[8:16]), 'little', signed=True)
              for frame in frames_of(output) if re.fullmatch('285#[0-9A-F]{12}', frame)]
    assert any(abs(speed - 209715200) < 209716 for speed in speeds), f'at most {max(speeds, default=0)} increments/s'


def unit_has_ended(_, unit):
    assert unit.process.wait(programs.PATIENCE) == 0


def make_sleep_patient(folder):
    """What a page waits for by sleep is there then on a busy machine, too."""
    script = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'patient_sleep.py')
    with open(folder.path('bin/sleep'), 'w', encoding='utf-8') as file:
        file.write(f'#!/bin/sh\nexec "{sys.executable}" "{script}" "$@"\n')
    os.chmod(folder.path('bin/sleep'), 0o755)


def make_tree(folder, source, bin_folder, blocks):
    """A folder that looks like the source tree to those who paste; what they write stays in it."""
    tree = folder.path('tree')
    os.makedirs(os.path.join(tree, 'build/release'))
    os.symlink(bin_folder, os.path.join(tree, 'build/release/bin'))
    shutil.copytree(os.path.join(source, 'examples'), os.path.join(tree, 'examples'),
                    ignore=shutil.ignore_patterns('node_modules', '__pycache__'))
    for name, original in blocks.copies.items():
        os.makedirs(os.path.dirname(os.path.join(tree, name)), exist_ok=True)
        built = original.startswith('bin/')
        shutil.copy(os.path.join(os.path.dirname(bin_folder) if built else source, original), os.path.join(tree, name))
    if blocks.npm:
        os.symlink(os.path.join(source, MODULES), os.path.join(tree, 'examples/masters/npm/node_modules'))
    return tree


def wait_until(done, seconds):
    deadline = time.monotonic() + seconds
    while not done() and time.monotonic() < deadline:
        time.sleep(0.1)


def paste(block, tree, environment, wanted):
    """The output of a shell that is given BLOCK, until it has ended and WANTED is there; what it left behind ends with it."""
    path = os.path.join(tree, 'output')

    def output():
        with open(path, encoding='utf-8', errors='replace') as file:
            return file.read()

    with open(path, 'ab') as log:
        shell = subprocess.Popen(['bash'], stdin=subprocess.PIPE, stdout=log, stderr=log, cwd=tree, env=environment,
                                 start_new_session=True)
    try:
        shell.communicate('\n'.join(block).encode() + b'\n', timeout=LONGEST)
        wait_until(lambda: wanted(output()), programs.PATIENCE)
    finally:
        try:
            os.killpg(shell.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        shell.wait()
    return shell.returncode, output()


def run(name, bin_folder, source):
    blocks = BLOCKS[name]
    if blocks.npm and not os.path.isdir(os.path.join(source, MODULES)):
        print(f'skipped: there is no {MODULES}; scripts/test.sh installs it')
        return SKIPPED
    with open(os.path.join(source, blocks.page), encoding='utf-8') as file:
        page = file.read()
    with programs.Folder(bin_folder) as folder:
        os.mkdir(folder.path('bin'))
        os.symlink(sys.executable, folder.path('bin/python3'))  # that of the system, which has its packages
        make_sleep_patient(folder)
        environment = {**folder.environment, 'PATH': f'{bin_folder}:{folder.path("bin")}:{os.environ["PATH"]}'}
        # As if they were installed.
        environment.update(PYTHONPATH=os.path.join(os.path.dirname(bin_folder), 'python'),
                           NODE_PATH=os.path.join(os.path.dirname(bin_folder), 'node'))
        unit = None
        if blocks.unit:
            unit = folder.start('axisd', '--interface', f'unix:{os.environ["CAN_BUS"]}', '--node-id', '5')
            unit.expect('ready: node 5 on')
        if blocks.unit or blocks.can:
            environment.update((key, value) for key, value in os.environ.items() if key in ('CAN_BUS', 'LD_PRELOAD'))
        tree = make_tree(folder, source, bin_folder, blocks)
        for saved, start in blocks.saved.items():
            with open(os.path.join(tree, saved), 'w', encoding='utf-8') as file:
                file.write('\n'.join(block_of(page, start)) + '\n')
        before = 0
        pasted = [block_of(page, start) for start in blocks.starts]
        for block in [sum(pasted, [])] if blocks.one_shell else pasted:
            dialogue = block[0].startswith('$ ')
            commands = [line[2:] for line in block if line.startswith('$ ')] if dialogue else block
            status, output = paste(commands, tree, environment, lambda text: missing(block, text[before:]) is None)
            print(output[before:])
            assert status == 0, f'the shell ended with {status}'
            absent = missing(block, output[before:])
            assert absent is None, f'"{absent}" has not come'
            if dialogue:
                said = '\n'.join(line for line in block if not line.startswith('$ '))
                assert output.strip() == said, f'the page says:\n{said}'
            before = len(output)
        if blocks.check:
            globals()[blocks.check](output, unit)
    return 0


if __name__ == '__main__':
    sys.exit(run(sys.argv[3], os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])))
