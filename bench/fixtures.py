"""What a unit as a fixture costs: fixtures.py [BUILD-FOLDER], build/release if not given. Prints times and memory.

Starts: 50, alone and beside eight busy programs. Twenty tests that turn a motor, by pytest, one after the other and with -n 4
(python3-pytest-xdist), with the memory of all their processes at the peak.
"""

import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

BUILD = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[1] / 'build' / 'release').resolve()
sys.path.insert(0, str(BUILD / 'python'))
import axisd  # noqa: E402  pylint: disable=wrong-import-position

STARTS = 50
BUSY = 8
PERIOD = 0.02  # s between two looks at the memory
TESTS = '''
import pytest

@pytest.mark.parametrize('number', range(20))
def test_turns(drive, number):
    drive.write('p1120', 0.5)
    drive.nmt('start')
    drive.wait(nmt='operational')
    drive.switch_on()
    drive.bus.send(0x305, '0F000000800C')
    drive.wait(value='1/speed', ge=2990)
'''


def starts():
    """Seconds from the call to the boot-up frame, of each start."""
    times = []
    for _ in range(STARTS):
        begin = time.perf_counter()
        with axisd.Unit() as unit:
            unit.bus.wait_for(0x705, timeout=60)
            times.append(time.perf_counter() - begin)
    return times


def print_starts(name):
    times = [1000 * seconds for seconds in starts()]
    print(f'start to boot-up, {name}: median {statistics.median(times):.1f} ms, worst {max(times):.1f} ms of {STARTS}')


def family(root):
    """A process and all below it."""
    children = {}
    for entry in filter(str.isdecimal, os.listdir('/proc')):
        try:
            parent = int(pathlib.Path('/proc', entry, 'stat').read_text(encoding='ascii').rsplit(')', 1)[1].split()[1])
        except (OSError, IndexError, ValueError):
            continue
        children.setdefault(parent, []).append(int(entry))
    found, left = [], [root]
    while left:
        found.append(left.pop())
        left += children.get(found[-1], [])
    return found


def memory(processes):
    """Resident memory, that with shared pages counted once, that of daemons and hubs (MB), and how many processes."""
    sums = [0.0, 0.0, 0.0, 0]
    for process in processes:
        try:
            text = pathlib.Path(f'/proc/{process}/smaps_rollup').read_text(encoding='ascii')
            name = pathlib.Path(f'/proc/{process}/comm').read_text(encoding='utf-8').strip()
            resident, shared = (int(text.split(key)[1].split()[0]) / 1024 for key in ('\nRss:', '\nPss:'))
        except (OSError, IndexError):
            continue
        sums = [sums[0] + resident, sums[1] + shared, sums[2] + resident * (name in ('axisd', 'canhub')), sums[3] + 1]
    return sums


def print_tests(folder, workers):
    begin, peak = time.perf_counter(), [0.0] * 4
    with subprocess.Popen([sys.executable, '-m', 'pytest', '-q', '-p', 'no:cacheprovider', '-n', str(workers), folder],
                          env={**os.environ, 'PYTHONPATH': str(BUILD / 'python')}, stdout=subprocess.PIPE, text=True) as run:
        while run.poll() is None:
            peak = [max(pair) for pair in zip(peak, memory(family(run.pid)))]
            time.sleep(PERIOD)
        last = run.stdout.read().splitlines()[-1]
    print(f'-n {workers}: {last}; with pytest itself {time.perf_counter() - begin:.1f} s; at the peak {peak[3]} processes, '
          f'{peak[0]:.0f} MB resident, {peak[1]:.0f} MB with shared pages once, {peak[2]:.0f} MB of axisd and canhub')


def main():
    print_starts('alone')
    busy = [subprocess.Popen([sys.executable, '-c', 'while True: pass']) for _ in range(BUSY)]
    try:
        print_starts(f'beside {BUSY} busy programs')
    finally:
        for program in busy:
            program.kill()
            program.wait()
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, 'test_twenty.py').write_text(TESTS, encoding='ascii')
        for workers in (0, 4):
            print_tests(folder, workers)


if __name__ == '__main__':
    main()
