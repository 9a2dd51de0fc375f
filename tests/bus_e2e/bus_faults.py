"""Faults of the bus between candump and cansend, each by its command: bus_faults.py BIN-FOLDER

To be run by with-can, on a bus of its own: what is heard without the fault, with it, what canhub counts, and what is heard
when it has been taken back.
"""

import json
import os
import re
import subprocess
import sys
import time

import programs

LAST = '7FE#'  # behind what a case sends


class Candump:
    """What candump prints, a frame a text as cansend takes it."""

    def __init__(self, bus):
        self.bus = bus
        self.process = subprocess.Popen(['candump', '-L', 'can0,0:0,#FFFFFFFF'], stdout=subprocess.PIPE, text=True)

    def __enter__(self):
        try:
            self.bus.wait_for(rf'^raw +{self.process.pid} can0 ')
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
        self.process.stdout.close()

    def send(self, *frames):
        for frame in frames:
            subprocess.run(['cansend', *frame.split(':')] if ':' in frame else ['cansend', 'can0', frame], check=True)

    def heard(self, frames, most=None):
        """Sends FRAMES and one more; what comes until that has come, or MOST frames have."""
        self.send(*frames, LAST)
        seen = []
        while LAST not in seen and len(seen) != most:
            line = self.process.stdout.readline()
            assert line, f'candump has ended behind {seen}'
            seen.append(line.split()[2])
        return [frame for frame in seen if frame != LAST]

    def next_at(self):
        """The next frame, behind the time (s) at which it passed the hub."""
        time_text, _, frame = self.process.stdout.readline().split()[:3]
        return float(time_text.strip('()')), frame

    def next(self):
        return self.next_at()[1]


class Bus:
    """The bus, as canhub tells of it."""

    def __init__(self, folder):
        self.folder = folder

    def canhub(self, *options):
        return self.folder.output_of('canhub', '--path', os.environ['CAN_BUS'], *options)

    def status(self):
        """Nothing as long as nobody is there: the first member starts the hub."""
        try:
            return self.canhub('--status')
        except subprocess.CalledProcessError:
            return ''

    def inject(self, *faults):
        return [int(number) for fault in faults for number in self.canhub('--inject', fault).split()]

    def faults(self):
        return json.loads(self.canhub('--injected', '--json'))['faults']

    def take_back(self):
        self.canhub('--take-back', 'all')
        assert self.canhub('--injected') == 'no faults\n'

    def wait_for(self, pattern):
        deadline = time.monotonic() + programs.PATIENCE
        while not re.search(pattern, self.status(), re.MULTILINE):
            assert time.monotonic() < deadline, f'{pattern} is not in {self.status()}'


# Fault, what is sent, what candump hears with it, hits.
CASES = [
    ('bus.drop id=185 after=1 times=2', ['185#01', '185#02', '186#', '185#03', '185#04'], ['185#01', '186#', '185#04'], 2),
    ('bus.drop id=180 mask=780', ['185#', '1FF#', '205#'], ['205#'], 2),
    ('bus.duplicate id=185 every=2', ['185#01', '185#02', '186#'], ['185#01', '185#02', '185#02', '186#'], 1),
    ('bus.corrupt id=185 byte=1 bits=FF', ['185#0102', '186#0102'], ['185#01FD', '186#0102'], 1),
    ('bus.cut members=can1', ['185#', 'can1:186#', '187#'], ['185#', '187#'], 1),
    ('bus.cut members=can1 event=frame_185 after=1', ['can1:186#', '185#', 'can1:186#'], ['186#', '185#'], 1),
]


def hit_frames(bus, dump):
    """What a bus loses one by one: as many as a fault of seed 5 wants."""
    frames = [f'185#{number:02X}' for number in range(20)]
    bus.inject('bus.drop id=185 probability=0.5 seed=5')
    heard = dump.heard(frames)
    hit_at = bus.faults()[0]['hit_at']
    bus.take_back()
    assert [frames[number - 1] for number in hit_at] == [frame for frame in frames if frame not in heard][:16], hit_at
    return hit_at


def test_frames(bus, dump):
    for fault, sent, with_it, hits in CASES:
        plain = [frame.split(':')[-1] for frame in sent]
        assert dump.heard(sent) == plain
        bus.inject(fault.replace('frame_', 'frame '))
        heard = dump.heard(sent)
        assert heard == with_it, f'{fault}: {heard}'
        [row] = bus.faults()
        assert row['hits'] == hits, row
        bus.take_back()
        assert dump.heard(sent) == plain, fault
    assert hit_frames(bus, dump) == hit_frames(bus, dump)


def test_delay(bus, dump):
    bus.inject('bus.delay id=185 delay_ms=3600000')
    assert dump.heard(['185#01', '186#']) == ['186#']
    bus.take_back()
    bus.inject('bus.delay id=185 delay_ms=200')
    dump.send('186#', '185#02')
    (before, first), (late, second) = dump.next_at(), dump.next_at()
    assert (first, second) == ('186#', '185#02'), (first, second)
    assert late - before >= 0.2, f'{late - before} s'
    bus.take_back()


def test_talkers(bus, dump):
    bus.inject('bus.babble id=111 length=1 period_us=1000 times=3', 'bus.error-frames class=bus-off times=2 period_ms=1')
    heard = sorted(dump.next() for _ in range(5))
    assert heard == ['111#00'] * 3 + ['20000040#0000000000000000'] * 2, heard
    assert [row['hits'] for row in bus.faults()] == [3, 2]
    bus.take_back()
    assert dump.heard([]) == []


def test_bit_rate(bus, dump):
    assert 'no bit rate' in bus.canhub('--status')
    bus.inject('bus.bit-rate bit_rate=20000')
    bus.wait_for('20000 bit/s')
    [load] = bus.inject('bus.load percent=50')
    assert dump.next() == dump.next() == '7FF#0000000000000000'
    bus.canhub('--take-back', str(load))
    assert [row['fault']['kind'] for row in bus.faults()] == ['bus.bit-rate']
    bus.take_back()
    bus.wait_for('no bit rate')


def test_cut_process(bus, dump):
    """One process is cut off: candump hears nothing of the others."""
    bus.inject(f'bus.cut members={dump.process.pid}')
    subprocess.run(['cansend', 'can0', '185#01'], check=True)
    bus.take_back()
    assert dump.heard(['185#02']) == ['185#02']


def test_unit(bus, folder):
    """What a unit makes of an error of its controller."""
    unit = programs.start_unit(folder)
    bus.inject('bus.error-frames class=error-passive times=1')
    unit.expect('error-passive')
    bus.inject('bus.error-frames class=error-active times=1')
    unit.expect('error-active')
    bus.take_back()


def test_start(folder):
    """Faults that a hub has from its start."""
    path = folder.path('other')
    hub = folder.start('canhub', '--path', path, '--with', 'bus.drop id=185', '--with',
                       '{"kind": "bus.delay", "delay_ms": 5}')
    hub.expect('ready')
    told = folder.output_of('canhub', '--path', path, '--injected')
    assert re.fullmatch(r' +id state +seen +hits +fault\n +1 active +0 +0 +bus.drop id=0x185\n'
                        r' +2 active +0 +0 +bus.delay delay_ms=5\n', told), told
    assert hub.end() == 0


def main():
    with programs.Folder(sys.argv[1]) as folder:
        bus = Bus(folder)
        with Candump(bus) as dump:
            test_frames(bus, dump)
            test_delay(bus, dump)
            test_talkers(bus, dump)
        for test in (test_bit_rate, test_cut_process):
            with Candump(bus) as dump:
                test(bus, dump)
        test_unit(bus, folder)
        test_start(folder)


main()
