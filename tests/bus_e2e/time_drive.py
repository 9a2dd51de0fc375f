"""axisd by the time of its bus: time_drive.py BIN-FOLDER

In virtual time an hour under a master that is a script of the shell, twice: the same log with all time stamps. In stepped time
axisctl lets it go on, and says what is wrong where it cannot.
"""

import itertools
import json
import os
import pathlib
import subprocess
import sys
import tempfile

BIN = pathlib.Path(sys.argv[1])
PATIENCE = 120  # s
# Start, an hour at rest with a SYNC each minute; switched on, and turned for some seconds.
MASTER = '''
axisd --interface "unix:$CAN_BUS" --node-id 5 --state-directory state --control control & drive=$!
candump -L vcan0 >log & dump=$!
sleep 1
cansend vcan0 000#0105
for minute in $(seq 60); do sleep 60; cansend vcan0 080#; done
for word in 06 07 0F; do cansend vcan0 "605#2B406000${word}000000"; sleep 1; done
cansend vcan0 605#23FF600000002003
sleep 3
cansend vcan0 605#4041600000000000
sleep 1
kill $drive; wait $drive
kill $dump; wait $dump
true
'''


def run(*words, folder, **more):
    environment = {**os.environ, 'PATH': f'{BIN}:{os.environ["PATH"]}', 'XDG_RUNTIME_DIR': folder}
    return subprocess.run(list(map(str, words)), cwd=folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          text=True, timeout=PATIENCE, **more)


def log_of_an_hour():
    with tempfile.TemporaryDirectory(prefix='axisd-test-') as folder:
        done = run('with-can', '--private', '--time', 'virtual', '--', 'sh', '-c', MASTER, folder=folder)
        assert done.returncode == 0, done.stderr
        judged = run('canopen-audit', 'log', '--strict', '--eds', f'5:{BIN.parent}/share/axisd/eds/axisd.eds', folder=folder)
        assert judged.returncode == 0, judged.stdout
        return pathlib.Path(folder, 'log').read_text(encoding='ascii').splitlines()


def check_virtual():
    one, other = log_of_an_hour(), log_of_an_hour()
    answers = [line.split()[2] for line in one if '585#4B416000' in line]
    assert len(answers) == 1, answers
    statusword = int(answers[0][14:16] + answers[0][12:14], 16)
    assert statusword & 0x6F == 0x27, f'not operation enabled: {statusword:04X}'
    begin, end = (float(line.split()[0].strip('()')) for line in (one[0], one[-1]))
    assert 3600 < end - begin < 3610, f'{end - begin} s'
    first = next((i for i, pair in enumerate(itertools.zip_longest(one, other)) if pair[0] != pair[1]), None)
    assert first is None, f'line {first}: {one[first:first + 1]} and {other[first:first + 1]}'
    print(f'virtual: {len(one)} frames of {end - begin:.3f} s, twice the same')


def check_stepped():
    with tempfile.TemporaryDirectory(prefix='axisd-test-') as folder:
        bus = f'{folder}/bus'

        def step(*words):
            return run('axisctl', 'step', *words, '--path', bus, folder=folder)

        none = step('1s')
        assert none.returncode == 5, none
        hub = subprocess.Popen([BIN / 'canhub', '--path', bus, '--time', 'stepped'], stderr=subprocess.PIPE, text=True)
        drive = None
        try:
            assert 'ready' in hub.stderr.readline()
            drive = subprocess.Popen([BIN / 'axisd', '--interface', f'unix:{bus}', '--node-id', '5', '--state-directory', f'{folder}/state',
                                      '--control', f'{folder}/control'], stderr=subprocess.PIPE, text=True, env={**os.environ, 'XDG_RUNTIME_DIR': folder})
            assert 'ready' in drive.stderr.readline()
            assert step('10ms').stdout == '0.010000000\n'
            assert step('1.5h').stdout == '5400.010000000\n'
            uptime = run('axisctl', '--socket', f'{folder}/control', '--json', 'status', folder=folder)
            assert 5399 < json.loads(uptime.stdout)['uptime_s'] < 5401, uptime
            wrong = step('soon')
            assert wrong.returncode == 2 and 'DURATION: expected' in wrong.stderr, wrong
        finally:
            for process in filter(None, (drive, hub)):
                process.terminate()
                process.wait()
        with subprocess.Popen([BIN / 'canhub', '--path', bus], stderr=subprocess.PIPE, text=True) as real:
            assert 'ready' in real.stderr.readline()
            refused = step('1s')
            real.terminate()
        assert refused.returncode == 3 and 'not stepped' in refused.stderr, refused
    print('stepped: 10 ms and an hour and a half, and three refusals')


check_virtual()
check_stepped()
