"""Programs that know nothing of it by the time of the bus: bus_time.py programs|same_twice BIN-FOLDER EDS

programs    each sends the same frames in virtual time as in the machine's, and in virtual time at the instants that it means
same_twice  in virtual time a second run has the same log as the first, with all time stamps, on a machine that is busy, too
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

PARTS = pathlib.Path(__file__).parent / 'bus_time'
SLAVE = pathlib.Path(__file__).parent / 'foreign_slaves' / 'slave.js'
BEGIN = 1735689600  # s, the clock of each bus at first
PATIENCE = 120  # s

# Each with the log of candump in $LOG, the programs of this folder in $PARTS, EDS and SLAVE.
SCRIPTS = {
    'can-utils': 'cansend vcan0 123#112233; cangen vcan0 -g 10 -n 20 -I i -L 8 -D i; sleep 1; cansend vcan0 7FF#',
    'python-can': '/usr/bin/python3 "$PARTS/master.py"',
    'npm': 'node "$SLAVE" vcan0 "$EDS" 2>/dev/null & sleep 2; node "$PARTS/master.js" "$EDS"; kill $!',
    'pytest': '/usr/bin/python3 -m pytest -q -p no:cacheprovider "$PARTS/frames_test.py" >&2',
}
CANOPEN = ('npm',)
AROUND = 'candump -L vcan0 >"$LOG" & dump=$!; sleep 1; {}; sleep 1; kill $dump; wait $dump; true'


class Frame:
    """A line of a log: its time in microseconds of the bus's clock, and the rest."""

    def __init__(self, line):
        stamp, _, self.text = line.split()
        seconds, part = stamp.strip('()').split('.')
        self.time = (int(seconds) - BEGIN) * 1_000_000 + int(part)


def run(bin_folder, eds, time, script):
    """The log of SCRIPT on a bus of its own whose time is TIME."""
    with tempfile.TemporaryDirectory(prefix='axisd-test-') as folder:
        log = pathlib.Path(folder) / 'log'
        environment = {**os.environ, 'LOG': str(log), 'PARTS': str(PARTS), 'EDS': eds, 'SLAVE': str(SLAVE),
                       'XDG_RUNTIME_DIR': folder, 'PYTHONDONTWRITEBYTECODE': '1'}
        finished = subprocess.run([os.path.join(bin_folder, 'with-can'), '--private', '--time', time, '--bitrate', '1000000',
                                   'sh', '-c', AROUND.format(script)],
                                  env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                  timeout=PATIENCE, check=False)
        assert finished.returncode == 0, f'{script}: status {finished.returncode}: {finished.stdout}'
        return log.read_text(encoding='ascii')


def frames(log):
    return [Frame(line) for line in log.splitlines()]


def check_masters(bin_folder, eds, log):
    """canopen-audit finds nothing in a log of frames that are CANopen."""
    with tempfile.NamedTemporaryFile('w', encoding='ascii', suffix='.log') as file:
        file.write(log)
        file.flush()
        judged = subprocess.run([os.path.join(bin_folder, 'canopen-audit'), file.name, '--strict', '--eds', f'5:{eds}'],
                                stdout=subprocess.PIPE, text=True, timeout=PATIENCE, check=False)
        assert judged.returncode == 0, judged.stdout


def check_programs(bin_folder, eds):
    for name, script in SCRIPTS.items():
        real = frames(run(bin_folder, eds, 'real', script))
        log = run(bin_folder, eds, 'virtual', script)
        virtual = frames(log)
        if name in CANOPEN:
            check_masters(bin_folder, eds, log)
        print(f'{name}: {len(virtual)} frames in {virtual[-1].time / 1e6:.6f} s')
        assert len(real) > 10, f'{name}: {len(real)} frames'
        assert [frame.text for frame in virtual] == [frame.text for frame in real], \
            f'{name}: {[frame.text for frame in virtual]} in virtual time, {[frame.text for frame in real]} in real time'
        if name == 'can-utils':
            # Of their ends: a stuffed bit is 1 us. The first of cangen waits for the end of the frame before.
            times = [frame.time for frame in virtual[2:-1]]
            assert all(abs(after - before - 10_000) < 20 for before, after in zip(times, times[1:])), f'{name}: {times}'


def check_twice(bin_folder, eds):
    for name, script in SCRIPTS.items():
        first = run(bin_folder, eds, 'virtual', script)
        busy = [subprocess.Popen(['sh', '-c', 'while :; do :; done']) for _ in range(2 * (os.cpu_count() or 1))]
        try:
            second = run(bin_folder, eds, 'virtual', script)
        finally:
            for process in busy:
                process.kill()
                process.wait()
        assert first == second, f'{name}: first\n{first}\nthen\n{second}'
        assert re.search(r'\S', first), f'{name}: no frames'


if __name__ == '__main__':
    {'programs': check_programs, 'same_twice': check_twice}[sys.argv[1]](sys.argv[2], sys.argv[3])
