"""A page of `axisctl record --html` has the recording of the unit and what the unit tells: record_html.py BIN-FOLDER

To be run by with-can, on a bus of its own.
"""

import glob
import json
import os
import resource
import shutil
import signal
import subprocess
import sys
import time

import programs
from html_pages import BLANK, FRAME, SAMPLES, frame_of, recording_of, session_of
from master import BOOT_UP, NODE, Master, can

FAILED, USAGE, NOT_THERE, NOT_REACHABLE = 1, 2, 4, 5
TITLE = 'a <script> of 20 % </script>'
SIGNALS = [f'{axis}/{signal}' for axis in (1, 2) for signal in ('speed', 'speed_setpoint', 'torque', 'current')]
# Of a unit with two axes; what further methods bring is there too.
RESOURCES = {'', 'explain', 'faults', 'pdos?all=true', 'objects', 'signals', 'injected', 'injected/kinds', 'nmt', 'storage', 'supply', 'metrics',
             'parameters/diff?against=factory', 'parameters/diff?against=stored',
             *(f'axes/{axis}/{what}' for axis in (0, 1, 2) for what in ('parameters', 'faults')),
             *(f'axes/{axis}/{what}' for axis in (1, 2) for what in ('load', 'encoder', 'plant'))}


class Trial:
    """A unit with two axes, its master, and axisctl."""

    def __init__(self, folder, bus):
        self.folder = folder
        with open(folder.path('axisd.json'), 'w', encoding='ascii') as file:
            json.dump({'axes': [{}, {}]}, file)
        with open(folder.path('blank.html'), 'w', encoding='ascii') as file:
            file.write(BLANK)
        self.socket = folder.path('control.sock')
        self.unit = folder.start('axisd', '--interface', f'unix:{os.environ["CAN_BUS"]}', '--node-id', str(NODE), '--config',
                                 folder.path('axisd.json'), '--control', self.socket, '--state-directory', folder.path('state'))
        self.unit.expect('ready')
        self.master = Master(bus)
        self.master.expect(*BOOT_UP)

    def words(self, *words):
        return [os.path.join(self.folder.bin_folder, 'axisctl'), '--socket', self.socket, *words]

    def run(self, *words, **options):
        return subprocess.run(self.words(*words), env=self.folder.environment, capture_output=True, text=True, check=False,
                              timeout=programs.PATIENCE, **options)

    def ask(self, *words):
        done = self.run('--json', *words)
        assert done.returncode == 0, done.stderr
        return done.stdout

    def page(self, name, *words, **options):
        """Runs `axisctl record --html`; what came of it, and the path of the page."""
        path = self.folder.path(name)
        return self.run('record', '--html', path, '--template', self.folder.path('blank.html'), *words, **options), path

    def file(self):
        [path] = glob.glob(self.folder.path('state/*/recordings/*.axrec'))
        return path

    def wait_for_recording(self):
        deadline = time.monotonic() + programs.PATIENCE
        while json.loads(self.ask('record', 'status'))['state'] != 'recording':
            assert time.monotonic() < deadline
            time.sleep(0.01)


def shown_frames(trial, path):
    """Direction, identifier and data of all frames, as axisctl prints them."""
    lines = [json.loads(line) for line in trial.ask('record', 'show', path).splitlines()]
    return [(line['direction'], line['id'], line['data']) for line in lines if line['type'] == 'frame']


def check_live(trial):
    path = trial.folder.path('live.html')
    recorder = subprocess.Popen(trial.words('record', '--html', path, '--for', '600', '--title', TITLE, '--every', '0.005',
                                            '--template', trial.folder.path('blank.html')),
                                env=trial.folder.environment, stderr=subprocess.PIPE, text=True)
    try:
        trial.wait_for_recording()
        trial.master.send(0x600 + NODE, '4000100000000000')
        answer = trial.master.receive(0x580 + NODE).hex().upper()
        recorder.send_signal(signal.SIGINT)
        _, errors = recorder.communicate(timeout=programs.PATIENCE)
    finally:
        recorder.kill()
        recorder.wait()
    assert (recorder.returncode, errors) == (0, ''), errors
    session = session_of(path)
    assert session['title'] == TITLE
    [unit] = session['units']
    head, records = recording_of(unit)
    frames = [frame_of(content) for kind, _, content in records if kind == FRAME]
    assert frames == [('received', f'{0x600 + NODE:03X}', '4000100000000000'), ('sent', f'{0x580 + NODE:03X}', answer)], frames
    assert frames == shown_frames(trial, trial.file())
    assert [signal['name'] for signal in head['signals']] == SIGNALS, head['signals']
    assert any(kind == SAMPLES for kind, _, _ in records)
    assert unit['recordings'][0]['name'] == os.path.basename(trial.file())
    resources = unit['resources']
    assert RESOURCES <= set(resources), RESOURCES - set(resources)
    assert resources['']['node_id'] == NODE
    for path in ('objects', 'axes/2/parameters'):
        assert resources[path][path.rpartition('/')[2]] and 'next' not in resources[path], path
    assert len(resources['signals']['signals']) == len(json.loads(trial.ask('signal', 'list'))['signals'])
    eds = os.path.join(trial.folder.bin_folder, '../share/axisd/eds/axisd-2-axes.eds')
    with open(eds, encoding='utf-8', newline='') as file:
        assert unit['eds'] == file.read()
    assert unit['unit'].endswith(f'/{NODE}')
    return unit['unit']


def check_files(trial, name):
    """Pages of files: while the unit is there, of one that is cut, of one that is none."""
    file = trial.file()
    cut, headless = trial.folder.path('cut.axrec'), trial.folder.path('headless.axrec')
    with open(file, 'rb') as whole:
        content = whole.read()
    for path, part in ((cut, content[:-10]), (headless, content[:100])):
        with open(path, 'wb') as target:
            target.write(part)
    done, path = trial.page('files.html', '--from', file, cut)
    assert done.returncode == 0, done.stderr
    assert done.stderr.startswith(f'axisctl: {cut}: ') and done.stderr.count('\n') == 1, done.stderr
    [unit] = session_of(path)['units']
    assert unit['unit'] == name and unit['resources']['']['node_id'] == NODE
    assert len(recording_of(unit, 1)[1]) == len(recording_of(unit, 0)[1]) - 1
    done, path = trial.page('headless.html', '--from', headless)
    assert (done.returncode, done.stderr) == (NOT_THERE, f'axisctl: {headless}: cut within its head\n'), done.stderr
    assert not os.path.exists(path)


def check_refusals(trial):
    file = trial.file()
    expected = {
        ('record', '--html', trial.folder.path('none/page.html')): (FAILED, 'none/page.html: cannot be written: No such file or directory'),
        ('record', '--html', '/dev/null', '--from', file, '--template', trial.folder.path('blank.html')):
            (FAILED, '/dev/null: cannot be written: Not a regular file'),
        ('record', '--html', trial.folder.path('x.html'), '--template', trial.folder.path('none.html')):
            (NOT_THERE, 'none.html: cannot be read: No such file or directory'),
        ('record', '--html', trial.folder.path('x.html'), '--from', file, '--template', file): (NOT_THERE, 'expected <script'),
        ('record', '--html', trial.folder.path('x.html'), '--signals', '7/speed', '--template', trial.folder.path('blank.html')):
            (NOT_THERE, '7/speed'),
        ('record', 'start', '--html', trial.folder.path('x.html')): (USAGE, 'start excludes --html'),
        ('record', '--title', 'x'): (USAGE, '--title requires --html'),
        ('record',): (USAGE, 'expected a subcommand: start, stop, status, show, candump'),
    }
    for words, (status, message) in expected.items():
        done = trial.run(*words)
        assert done.returncode == status and message in done.stderr and done.stderr.count('\n') == 1, (words, done)
    assert not os.path.exists(trial.folder.path('x.html'))


def check_whole_or_not(trial):
    """A disk that is full leaves the page that was there, and nothing beside it."""
    def leave_no_room():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))

    os.mkdir(trial.folder.path('full'))
    done, path = trial.page('full/page.html', '--from', trial.file())
    assert done.returncode == 0, done.stderr
    with open(path, 'rb') as before:
        content = before.read()
    done, path = trial.page('full/page.html', '--from', trial.file(), preexec_fn=leave_no_room)
    assert (done.returncode, done.stderr) == (FAILED, f'axisctl: {path}: cannot be written: File too large\n'), done.stderr
    with open(path, 'rb') as after:
        assert after.read() == content
    assert os.listdir(trial.folder.path('full')) == ['page.html']


def check_size(trial):
    """What no browser would like is refused with a hint."""
    large = trial.folder.path('large.axrec')
    shutil.copy(trial.file(), large)
    with open(large, 'ab') as file:
        file.truncate(50_000_000)
    done, path = trial.page('large.html', '--from', large)
    assert done.returncode == NOT_THERE and 'more than 64 MB: record less, see --max-MB' in done.stderr, done.stderr
    assert not os.path.exists(path)
    os.remove(large)


def check_alone(trial):
    """Without a unit, the file says what it knows."""
    assert trial.unit.end() == 0
    done, path = trial.page('alone.html', '--from', trial.file())
    assert (done.returncode, done.stderr) == (0, ''), done.stderr
    [unit] = session_of(path)['units']
    assert unit['resources'] == {} and unit['eds'] and session_of(path)['title'] == unit['unit']
    done, _ = trial.page('alone.html')
    assert done.returncode == NOT_REACHABLE, done.stderr


def main():
    with programs.Folder(sys.argv[1]) as folder, can.Bus('vcan0', interface='socketcan') as bus:
        trial = Trial(folder, bus)
        name = check_live(trial)
        check_files(trial, name)
        check_refusals(trial)
        check_whole_or_not(trial)
        check_size(trial)
        check_alone(trial)


main()
