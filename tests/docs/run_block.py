"""Runs a block of commands of the documentation as somebody who pastes it: run_block.py BIN-FOLDER SOURCE-FOLDER NAME

The whole block goes to the standard input of a shell whose folder looks like the source tree. Behind "->" a comment says what
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
import programs  # noqa: E402  pylint: disable=wrong-import-position

LONGEST = 150  # s
SKIPPED = 77
MODULES = 'build/master/node_modules'


@dataclasses.dataclass
class Blocks:
    """Blocks of one page that are pasted one after the other, and the world they are pasted into."""
    page: str
    starts: list  # of the first line of each block
    unit: bool = False  # with axisd as node 5 on the bus of with-can
    copies: dict = dataclasses.field(default_factory=dict)  # files that the reader has: name, and what it is a copy of
    npm: bool = False  # with the packages that the page tells to install
    check: str = ''  # function of this file that judges the rest


BLOCKS = {
    'turn': Blocks('README.md', ['candump vcan0 & sleep'], unit=True, check='reached_speed'),
    'disturb': Blocks('README.md', ['PATH=$PATH:build/release/bin'], unit=True, check='unit_has_ended'),
    'turn_and_disturb': Blocks('README.md', ['candump vcan0 & sleep', 'PATH=$PATH:build/release/bin'], unit=True,
                               check='unit_has_ended'),
    'without_can': Blocks('README.md', ['build/release/bin/axisd --interface unix:']),
    'ci_bus': Blocks('docs/ci.md', ['with-can -- candump vcan0 &']),
    'ci_python': Blocks('docs/ci.md', ['with-can -- pytest-3 examples/ci/test_drive.py']),
    'ci_npm': Blocks('docs/ci.md', ['NODE_PATH=examples/masters/npm/node_modules'], npm=True),
    'ci_shell': Blocks('docs/ci.md', ['with-can --private -- examples/ci/drive.sh']),
    'preload': Blocks('docs/preload.md', ['with-can -- candump vcan0 &']),
    'clock': Blocks('docs/time.md', ['candump vcan0 & sleep', 'candump vcan0,585:7FF'], unit=True),
    'explain': Blocks('docs/control.md', ['$ axisctl explain 1'], unit=True),
    'lint': Blocks('docs/eds-checks.md', ['edstool lint --severity error'],
                   copies={'device.eds': 'eds/axisd.eds', 'known.txt': 'tests/docs/known.txt'}),
}


def block_of(text, start):
    """The indented block whose first line begins with START."""
    lines = text.split('\n')
    first = [n for n, line in enumerate(lines) if line.startswith('    ' + start)]
    assert len(first) == 1, f'{len(first)} blocks begin with "{start}"'
    end = first[0]
    while end < len(lines) and (lines[end].startswith('    ') or not lines[end].strip()):
        end += 1
    return [line[4:] for line in lines[first[0]:end] if line.strip()]


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


def make_tree(folder, source, bin_folder, blocks):
    """A folder that looks like the source tree to those who paste; what they write stays in it."""
    tree = folder.path('tree')
    os.makedirs(os.path.join(tree, 'build/release'))
    os.symlink(bin_folder, os.path.join(tree, 'build/release/bin'))
    shutil.copytree(os.path.join(source, 'examples'), os.path.join(tree, 'examples'),
                    ignore=shutil.ignore_patterns('node_modules', '__pycache__'))
    for name, original in blocks.copies.items():
        shutil.copy(os.path.join(source, original), os.path.join(tree, name))
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
        environment = {**folder.environment, 'PATH': f'{bin_folder}:{os.environ["PATH"]}'}
        unit = None
        if blocks.unit:
            unit = folder.start('axisd', '--interface', f'unix:{os.environ["CAN_BUS"]}', '--node-id', '5')
            unit.expect('ready: node 5 on')
            environment.update((key, value) for key, value in os.environ.items() if key in ('CAN_BUS', 'LD_PRELOAD'))
        tree = make_tree(folder, source, bin_folder, blocks)
        before = 0
        for start in blocks.starts:
            block = block_of(page, start)
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


sys.exit(run(sys.argv[3], os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])))
