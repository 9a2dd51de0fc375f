"""Every kind of fault of a unit on the wire: wire_faults.py BIN-FOLDER [INTERFACE]

For each kind the same frames are sent to the unit without and with the fault, and what the unit sends is compared; then the fault
is taken back. Prints the command, both sequences and the count of hits. INTERFACE (vcan0) is the bus; without it the bus is that of
with-can.
"""

import json
import os
import re
import shlex
import socket
import struct
import sys
import time

import programs

NODE = 5
READ, READ_ID, ID = '605#4000100000000000', '605#4018100100000000', '585#4318100153000006'
TYPE = '585#430010009201FFFF'


class Bus:
    """The interface: frames in the notation of candump, those of the unit with the time they came."""

    def __init__(self, interface):
        self.socket = socket.socket(socket.AF_CAN, socket.SOCK_RAW, socket.CAN_RAW)
        self.socket.setsockopt(socket.SOL_CAN_RAW, socket.CAN_RAW_FILTER, struct.pack('=II', 0, 0))
        self.socket.bind((interface,))
        self.socket.settimeout(programs.PATIENCE)
        self.seen = []  # (time, frame) of one run

    def send(self, text):
        identifier, data = text.split('#')
        remote = data == 'R'
        data = b'' if remote else bytes.fromhex(data)
        self.socket.send(struct.pack('=IB3x8s', int(identifier, 16) | (0x40000000 if remote else 0), len(data), data))

    def next(self, patience=programs.PATIENCE):
        """The next frame; None: nothing came."""
        self.socket.settimeout(patience)
        try:
            identifier, length, data = struct.unpack('=IB3x8s', self.socket.recv(16))
        except TimeoutError:
            return None
        text = f'{identifier & 0x7FF:03X}#' + ('R' if identifier & 0x40000000 else data[:length].hex().upper())
        self.seen.append((time.monotonic(), text))
        return text

    def wait(self, pattern):
        """Waits until a frame matches; fails if none comes."""
        while True:
            frame = self.next()
            assert frame, f'{pattern} has not come, only {[text for _, text in self.seen]}'
            if re.fullmatch(pattern, frame):
                return frame

    def ask(self, frame, answer):
        """Repeats FRAME until the unit answers so."""
        deadline = time.monotonic() + programs.PATIENCE
        while True:
            self.send(frame)
            got = self.wait('58[0-9A-F]#.*')
            if re.fullmatch(answer, got):
                return got
            assert time.monotonic() < deadline, f'{frame}: {got}, expected {answer}'



# kind: (arguments, state before, steps, what the unit sends without the fault, and with it: patterns of the whole sequence, and the
# steps with the fault where they are others). A step is a frame to be sent; ~PATTERN: wait for such a frame; !WORDS: a command of axisctl;
# -: the fault is taken back; +N: wait until it has hit N times; ?: the speed is read until it is that of a motor at rest.
MARK = [READ_ID, '~' + ID]
REQUEST = [READ, *MARK]
SEGMENTS = ['605#4008100000000000', '~585#41.*', '605#6000000000000000', '~585#.*', *MARK]
BLOCK = ['605#A408100004000000', '~585#C6.*', '605#A300000000000000', '~585#82.*', '605#A202040000000000', '~585#.*', '605#A100000000000000', *MARK]
BEAT = ['605#2B17100032000000', '~705#7F', '~705#7F', '~705#7F']
TPDOS = ['205#0600', '~485#.*', *MARK]
GONE = [READ, *MARK]
SEGMENT = '585#4108100008000000 585#{}053494E414D4943 '
BLOCKS = '585#C608100008000000 585#{}153494E414D4943 585#82.* 585#D9{}0000000000 '
STATUS = ['605#4041600000000000', '~585#4B416000.*']
SPEED = ['605#406C600000000000', '~585#436C6000.*']
TURNING, RESTING = '585#436C6000......01', '585#436C6000....(00|FF)(00|FF)'  # 606Ch is smoothed: it follows the motor
CASES = {
    'sdo.deaf': ('times=1', 'boot', REQUEST, f'{TYPE} {ID}', ID),
    'sdo.silent': ('times=1', 'boot', REQUEST, f'{TYPE} {ID}', ID),
    'sdo.late': ('delay_ms=200 object=1000', 'boot', [READ, f'~{TYPE}'], TYPE, TYPE),
    'sdo.twice': ('times=1', 'boot', REQUEST, f'{TYPE} {ID}', f'{TYPE} {TYPE} {ID}'),
    'sdo.abort': ('code=0x08000000 object=0x1000', 'boot', REQUEST, f'{TYPE} {ID}', f'585#8000100000000008 {ID}'),
    'sdo.toggle': ('step=2', 'boot', SEGMENTS, SEGMENT.format('0') + ID, SEGMENT.format('1') + ID),
    'sdo.multiplexor': ('times=1', 'boot', REQUEST, f'{TYPE} {ID}', f'585#430110009201FFFF {ID}'),
    'sdo.length': ('times=1', 'boot', REQUEST, f'{TYPE} {ID}', f'585#470010009201FFFF {ID}'),
    'sdo.crc': ('', 'boot', BLOCK, BLOCKS.format('0', '9442') + ID, BLOCKS.format('0', '9542') + ID),
    'sdo.sequence': ('step=2', 'boot', BLOCK[:4] + ['605#8008100000000405', *MARK], '585#C6.* 585#01.* 585#82.* ' + ID,
                     '585#C6.* 585#02.* 585#82.* ' + ID),
    'tpdo.swallow': ('pdo=1', 'op', TPDOS, '185#3116 285#.* 385#.* 485#.* ' + ID, '285#.* 385#.* 485#.* ' + ID),
    'tpdo.late': ('pdo=1 delay_ms=200 times=1', 'op', ['205#0600', '~185#3116'], '185#3116', '285#.* 385#.* 485#.* 185#3116'),
    'tpdo.twice': ('pdo=1', 'op', TPDOS, '185#3116 285#.* ' + ID, '185#3116 185#3116 285#.* ' + ID),
    'tpdo.short': ('pdo=2', 'op', TPDOS, '185#3116 285#311600000000 .*', '185#3116 285#3116000000 .*'),
    'tpdo.frozen': ('pdo=1', 'op', [*TPDOS, '205#0700', '~485#3316.*'], '185#3116 .* 185#3316 .*', '185#3116 .* 185#3116 285#3316.*'),
    'tpdo.swap': ('pdo=2', 'op', TPDOS, '185#3116 285#311600000000 .*', '185#3116 285#000000003116 .*'),
    'rpdo.deaf': ('pdo=1', 'op', ['205#0600', '~185#3116'], '185#3116', ID, ['205#0600', *MARK]),
    'sync.deaf': ('', 'sync', ['080#', *MARK], f'185#4016 {ID}', ID),
    'nmt.deaf': ('', 'boot', ['000#0105', '705#R', '~705#.*'], '.*705#05', '705#7F'),
    'heartbeat.gap': ('after=1', 'boot', BEAT, '.*705#7F 705#7F 705#7F', f'585#60[^ ]* 705#7F {ID} 705#7F',
                      [*BEAT[:2], '+5', *MARK, '-', '~705#7F']),
    'heartbeat.late': ('after=1 times=1 delay_ms=600', 'boot', BEAT, '.*705#7F 705#7F 705#7F', '.*705#7F 705#7F 705#7F'),
    'heartbeat.state': ('state=stopped times=1', 'boot', BEAT[:1] + ['~705#.*'], '.*705#7F', '.*705#04'),
    'guard.silent': ('times=1', 'boot', ['705#R', *MARK], f'705#7F {ID}', ID),
    'guard.toggle': ('times=1', 'boot', ['705#R', *MARK], f'705#7F {ID}', f'705#FF {ID}'),
    'boot-up.missing': ('times=1', 'boot', ['000#8205', *MARK], f'705#00 {ID}', ID),
    'boot-up.late': ('times=1 delay_ms=200', 'boot', ['000#8205', '~705#00'], '705#00', '705#00'),
    'boot-up.twice': ('times=1', 'boot', ['000#8205', *MARK], f'705#00 {ID}', f'705#00 705#00 {ID}'),
    'emcy.missing': ('', 'boot', ['!fault inject 1 7860', *MARK], '085#.* ' + ID, ID),
    'emcy.never-cleared': ('', 'boot', ['!fault inject 1 7860', '!fault ack 1', *MARK], '085#(?!0000).* 085#0000.* ' + ID, '085#(?!0000)[^ ]* ' + ID),
    'emcy.storm': ('code=0x8110 period_ms=10', 'boot', MARK, ID, '085#1081000000000000 .*085#1081000000000000', ['~085#.*', '~085#.*', '~085#.*']),
    'drive.frozen': ('axis=1', 'turn', ['305#0F0000000000', '?'], f'.*{RESTING}', f'.*{TURNING}',
                     ['+2', '305#0F0000000000', '!wait value 1/speed lt 1', *SPEED]),
    'drive.ignores-controlword': ('', 'turn', ['205#0700', '~185#3316.*', *STATUS], '.*585#4B41600033.*', '.*585#4B41600037.*', ['+2', '205#0700', '+20', *STATUS]),
    'drive.status-bit': ('bit=3 value=1', 'turn', STATUS, '.*585#4B41600037.*', '.*585#4B4160003F.*', ['+2', *STATUS]),
    'drive.never': ('state=operation-enabled', 'op', ['205#0600', '~185#3116', '205#0700', '~185#3316', '205#0F00', '~185#37.*'],
                    '.*185#37.*', '(?!.*185#37).*585#4B41600033.*', ['205#0600', '~185#3116', '205#0700', '~185#3316', '205#0F00', '+5', *STATUS]),
    'node.reset': ('delay_ms=100', 'boot', MARK, ID, '.*705#00 ' + ID, ['~705#00', *MARK]),
    'node.id': ('node_id=9', 'boot', [READ, '609#4000100000000000', *MARK], f'{TYPE} {ID}', '589#430010009201FFFF ' + ID,
                [READ, '609#4000100000000000', '~589#.*', '-', *MARK]),
    'node.gone': ('until="1 sdo-request"', 'boot', GONE, f'{TYPE} {ID}', ID),
    'controller.passive': ('', 'boot', ['!status', *MARK], ID, '.*' + ID),
    'controller.off': ('until="1 sdo-request"', 'boot', GONE, f'{TYPE} {ID}', f'(?!.*{TYPE}).*{ID}'),
}
LATE = {'sdo.late': 0.2, 'heartbeat.late': 0.6, 'boot-up.late': 0.2}  # s from the beginning to the last frame at least


class Unit:
    def __init__(self, folder, bus):
        self.folder, self.bus = folder, bus

    def control(self, *options):
        text = self.folder.output_of('axisctl', '--socket', self.folder.path('control.sock'), *options)
        return json.loads(text) if options[0] == '--json' else text

    def prepare(self, state):
        self.bus.send('000#8105')
        self.bus.wait('705#00')
        if state == 'sync':
            self.bus.send('605#2F00180201000000')
            self.bus.wait('585#60.*')
        if state != 'boot':
            self.bus.send('000#0105')
            self.bus.wait('485#4016.*')
        if state == 'turn':
            for frame, answer in (('205#0600', '185#3116'), ('205#0700', '185#3316'), ('205#0F00', '185#37.*')):
                self.bus.send(frame)
                self.bus.wait(answer)
            self.bus.send('305#0F0000004001')
            self.bus.ask(SPEED[0], TURNING)
        self.bus.send(READ_ID)
        self.bus.wait(ID)
        self.bus.seen.clear()

    def hits(self):
        faults = self.control('--json', 'inject', 'list')['faults']
        return faults[0]['hits'] if faults else 0

    def play(self, steps):
        """The frames that the unit has sent meanwhile, and the time until the last of them (s)."""
        began = time.monotonic()
        for step in steps:
            if step[0] == '~':
                self.bus.wait(step[1:])
            elif step[0] == '!':
                self.control(*step[1:].split())
            elif step == '?':
                self.bus.ask(SPEED[0], RESTING)
            elif step == '-':
                self.last_hits = self.hits()
                self.control('inject', 'remove')
            elif step[0] == '+':
                wanted = self.hits() + int(step[1:])
                while self.hits() < wanted:
                    pass
            else:
                self.bus.send(step)
        return [frame for _, frame in self.bus.seen], self.bus.seen[-1][0] - began

    def run(self, kind, words, state, steps, is_faulty):
        self.prepare(state)
        self.last_hits = 0
        if is_faulty:
            options = [part for word in shlex.split(words) for part in ('--' + word.split('=')[0].replace('_', '-'), word.split('=')[1])]
            self.control('inject', 'add', kind, *options)
            print(f'$ axisctl inject add {kind} {shlex.join(options)}')
        frames, took = self.play(steps)
        hits = max(self.last_hits, self.hits())
        self.control('inject', 'remove')
        return frames, took, hits


def check_kinds(unit):
    told = [row['kind'] for row in unit.control('--json', 'inject', 'kinds')['kinds']]
    assert set(told) == set(CASES), set(told) ^ set(CASES)
    for kind in told:
        words, state, steps, normal, faulty, *others = CASES[kind]
        frames, _, _ = unit.run(kind, words, state, steps, False)
        assert re.fullmatch(normal, ' '.join(frames)), f'{kind}, without: {frames}'
        wrong, took, hits = unit.run(kind, words, state, others[0] if others else steps, True)
        assert re.fullmatch(faulty, ' '.join(wrong)), f'{kind}: {wrong}'
        assert hits > 0, f'{kind} has hit nothing'
        assert took >= LATE.get(kind, 0), f'{kind}: over after {took} s'
        print(f'  without: {" ".join(frames[-8:])}\n  with:    {" ".join(wrong[-8:])}\n  hits: {hits}')


def main():
    bin_folder, interface = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else None
    address = interface or f'unix:{os.environ["CAN_BUS"]}'
    with programs.Folder(bin_folder) as folder:
        control = folder.path('control.sock')
        with open(folder.path('axisd.json'), 'w', encoding='ascii') as file:
            json.dump({'sdo_block': True, 'axes': [{'parameters': {'p1120': 0.2, 'p1121': 0.2}}]}, file)
        daemon = folder.start('axisd', '--interface', address, '--node-id', str(NODE), '--control', control,
                              '--config', folder.path('axisd.json'), '--state-directory', folder.path('state'))
        daemon.expect(f'ready: node {NODE} on')
        unit = Unit(folder, Bus('vcan0'))
        check_kinds(unit)
        assert unit.control('--json', 'inject', 'list') == {'faults': []}


main()
