"""Whatever ends the process of a test: no daemon, no hub and no folder of it is left."""

import os
import pathlib
import select
import signal
import subprocess
import sys
import time

import pytest

PATIENCE = 20.0  # s
WAITS = '''
import sys, threading
import axisd
units = []
starter = threading.Thread(target=lambda: units.append(axisd.Unit()))
starter.start()
starter.join()
unit = units[0]
unit.wait(frame=0x705)
print(unit.pid, unit.bus.hub.pid, unit.folder, flush=True)
sys.stdin.readline()
{end}
'''


def begin(end):
    """A process with a unit, which was started by a thread that has ended: its handle, the unit, the hub, and the folder.

    It goes on to `end` when the unit and the hub are watched."""
    process = subprocess.Popen([sys.executable, '-c', WAITS.format(end=end)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               stdin=subprocess.PIPE, text=True)
    unit, hub, folder = process.stdout.readline().split()
    programs = [os.pidfd_open(int(pid)) for pid in (unit, hub)]
    process.stdin.write('\n')
    process.stdin.flush()
    return process, programs, pathlib.Path(folder).parent


def wait_until_gone(programs, session):
    for program in programs:
        ended, _, _ = select.select([program], [], [], PATIENCE)
        assert ended, 'a program has not ended'
        os.close(program)
    deadline = time.monotonic() + PATIENCE
    while session.exists():  # nothing tells its end
        assert time.monotonic() < deadline, f'{session} is still there: {list(session.rglob("*"))}'
        time.sleep(0.01)


@pytest.mark.parametrize('number', [signal.SIGKILL, signal.SIGTERM, signal.SIGINT])
def test_a_signal_leaves_nothing(number):
    # Python that is about to read would not see a signal that comes just before.
    process, programs, session = begin('import time\nwhile True: time.sleep(0.1)')
    process.send_signal(number)
    assert process.wait(PATIENCE) == -number
    wait_until_gone(programs, session)


@pytest.mark.parametrize('end, status', [('pass', 0), ('raise SystemExit(3)', 3), ('import os; os._exit(4)', 4),
                                         ('import os; os.abort()', -signal.SIGABRT)])
def test_an_end_without_close_leaves_nothing(end, status):
    process, programs, session = begin(end)
    assert process.wait(PATIENCE) == status
    wait_until_gone(programs, session)


def test_a_forked_child_leaves_the_unit_alone():
    process, programs, session = begin('''
import os
child = os.fork()
if child == 0:
    unit.close()
    unit.bus.close()
    with axisd.Unit() as other:
        other.wait(frame=0x705)
    sys.exit(0)
assert os.waitpid(child, 0)[1] == 0
assert unit.status['nmt_state'] == 'Pre-operational'
with axisd.Unit() as other:
    other.wait(frame=0x705)
''')
    assert process.wait(PATIENCE) == 0, process.stderr.read()
    wait_until_gone(programs, session)
