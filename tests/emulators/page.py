"""The blocks of docs/how-to/emulators.md, as somebody pastes them: page.py BIN-FOLDER

To be run by with-can, on a bus of its own.
"""

import os
import re
import signal
import subprocess
import sys

from guest import HERE, SOURCE
import programs

sys.path.insert(0, os.path.join(HERE, os.pardir, 'docs'))
import pages  # noqa: E402  pylint: disable=wrong-import-position

PAGE = os.path.join(SOURCE, 'docs', 'how-to', 'emulators.md')
REST = '-S -display none -monitor stdio'  # of a command line of qemu, for a guest that does not run


def block(start):
    """The block whose first line begins with START."""
    found = [block for block in pages.blocks_of(pages.read(PAGE))[0] if block.lines[0].startswith(start)]
    assert len(found) == 1, f'{len(found)} blocks begin with "{start}"'
    return '\n'.join(found[0].lines)


def promises(text):
    """What the comments of a block say that comes."""
    return [promise for comment in re.findall('# (->.*)$', text, re.MULTILINE)
            for promise in re.findall('-> ([^,]*)', comment)]


def paste(text, environment):
    """What a shell of the source tree prints that is given TEXT; what it left behind ends with it."""
    shell = subprocess.Popen(['bash', '-e'], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                             text=True, cwd=SOURCE, env=environment, start_new_session=True)
    try:
        # Something left behind holds the pipe; the end of the block is told by a mark.
        shell.stdin.write(text + '\necho end of the block\n')
        shell.stdin.flush()
        output = ''
        for line in shell.stdout:
            print(line, end='')
            if line == 'end of the block\n':
                return output
            output += line
        raise AssertionError(f'the shell ended with {shell.wait()}')
    finally:
        os.killpg(shell.pid, signal.SIGKILL)
        shell.wait()


def main():
    bin_folder = os.path.abspath(sys.argv[1])
    with programs.Folder(bin_folder) as folder:
        environment = {**os.environ, 'PATH': f'{bin_folder}:{os.environ["PATH"]}', 'XDG_RUNTIME_DIR': folder.folder.name,
                       'STATE_DIRECTORY': folder.folder.name}
        turn = block('axisd --interface unix: --node-id 5')
        output = paste(turn, environment)
        for promise in promises(turn):
            _, found, output = output.partition(promise)
            assert found, f'"{promise}" has not come'
        own = block('with-can -- qemu-system-x86_64 \\')
        assert own.count('...') == 1
        paste(own.replace('...', f'{REST} <<<quit'), environment)


main()
