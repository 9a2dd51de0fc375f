"""A small CANopen slave on python-can, built on no CANopen library: slave.py INTERFACE EDS [MANNER]

Serves the objects of EDS as node 5, says "ready" on standard error, and has one MANNER of slaves in the field:
  late-abort      an abort of a transfer long ago comes before some answers
  empty-segments  2003h comes in segments without data, and never ends
  oversize        2003h announces four bytes and never ends
  consumer-crash  ends when 0 is written to 1016h:01
  no-boot-up      boots without a word
"""

import configparser
import os
import struct
import sys
import time

import can

NODE = 5
SIZES = {0x05: 1, 0x06: 2, 0x07: 4}
NO_OBJECT, NO_SUB_INDEX, READ_ONLY, NO_COMMAND, TOGGLE = 0x06020000, 0x06090011, 0x06010002, 0x05040001, 0x05030000
TOO_LONG, TOO_SHORT, INVALID_VALUE, NOT_MAPPABLE, TOO_MUCH = 0x06070012, 0x06070013, 0x06090030, 0x06040041, 0x06040042
INCOMPATIBLE, NOT_NOW = 0x06040043, 0x08000022
OPERATIONAL, STOPPED, PRE_OPERATIONAL = 5, 4, 127
BIT_31 = 0x80000000
RESTRICTED = ((0, 0x7F), (0x101, 0x180), (0x581, 0x5FF), (0x601, 0x67F), (0x6E0, 0x6FF), (0x701, 0x77F))


class Abort(Exception):
    """Refuses a transfer with the code args[0]."""


class Entry:
    """An object or sub-index of the EDS."""

    def __init__(self, section):
        self.access = section['AccessType']
        self.mappable = section.get('PDOMapping') == '1'
        self.size = SIZES.get(int(section['DataType'], 0))
        self.initial = self._bytes(section.get('DefaultValue', ''))
        self.value = self.initial

    def _bytes(self, text):
        if self.size is None:
            return text.encode() or bytes(range(100))
        relative = text.startswith('$NODEID+')
        number = int(text.removeprefix('$NODEID+') or '0', 0) + (NODE if relative else 0)
        return number.to_bytes(self.size, 'little')

    @property
    def number(self):
        return int.from_bytes(self.value, 'little')


def entries_of(path):
    sections = configparser.RawConfigParser()
    sections.optionxform = str
    sections.read(path)
    entries = {}
    for name in sections.sections():
        index, _, sub = name.partition('sub')
        if len(index) == 4 and 'DataType' in sections[name]:
            entries[int(index, 16), int(sub or '0', 16)] = Entry(sections[name])
    return entries


class Slave:
    def __init__(self, bus, entries, manner):
        self.bus, self.entries, self.manner = bus, entries, manner
        self.transfer = None
        self.boot(all_objects=True)

    def send(self, identifier, data):
        self.bus.send(can.Message(arbitration_id=identifier, is_extended_id=False, data=data))

    def boot(self, all_objects):
        for (index, _), entry in self.entries.items():
            if all_objects or index < 0x2000:
                entry.value = entry.initial
        self.transfer = None
        self.state = PRE_OPERATIONAL
        self.beat = None
        if self.manner != 'no-boot-up':
            self.send(0x700 + NODE, b'\0')

    def number(self, index, sub=0):
        return self.entries[index, sub].number

    # NMT and heartbeat.
    def command(self, data):
        if len(data) != 2 or data[1] not in (0, NODE):
            return
        states = {1: OPERATIONAL, 2: STOPPED, 128: PRE_OPERATIONAL}
        if data[0] in states:
            entered = states[data[0]] == OPERATIONAL != self.state
            self.state = states[data[0]]
            if entered:
                self.send_tpdos()
        elif data[0] in (129, 130):
            self.boot(all_objects=data[0] == 129)

    def on_time(self, now):
        period = self.number(0x1017) / 1000
        if period == 0:
            self.beat = None
        elif self.beat is None or now >= self.beat:
            self.beat = now + period if self.beat is None else max(self.beat + period, now)
            self.send(0x700 + NODE, bytes([self.state]))

    # PDOs.
    def mapped(self, index):
        words = [self.number(index, sub) for sub in range(1, self.number(index) + 1)]
        return [(word >> 16, word >> 8 & 0xFF) for word in words]

    def send_tpdos(self):
        for number in range(2):
            cob_id = self.number(0x1800 + number, 1)
            if not cob_id & BIT_31:
                self.send(cob_id & 0x7FF, b''.join(self.entries[at].value for at in self.mapped(0x1A00 + number)))

    def take_rpdo(self, identifier, data):
        for number in range(2):
            targets = [self.entries[at] for at in self.mapped(0x1600 + number)]
            length = sum(entry.size for entry in targets)
            if self.number(0x1400 + number, 1) & (BIT_31 | 0x7FF) != identifier or len(data) < length:
                continue
            for entry in targets:
                entry.value, data = data[:entry.size], data[entry.size:]

    def judge_cob_id(self, index, value):
        before = self.number(index, 1)
        if value & 0x20000000 or (index >= 0x1800 and not value & 0x40000000):  # remote requests are not answered
            raise Abort(INVALID_VALUE)
        if not value & BIT_31:
            if not before & BIT_31 and (value ^ before) & 0x7FF:
                raise Abort(INVALID_VALUE)
            if any(low <= value & 0x7FF <= high for low, high in RESTRICTED):
                raise Abort(INVALID_VALUE)
            if not self.mapped(index + 0x200):
                raise Abort(INCOMPATIBLE)

    def judge_mapping(self, index, sub, value):
        if not self.number(index - 0x200, 1) & BIT_31:
            raise Abort(NOT_NOW)
        receives = index < 0x1A00
        if sub == 0:
            if value > 2:
                raise Abort(TOO_MUCH)
            words = [self.number(index, each) for each in range(1, value + 1)]
        elif self.number(index) != 0:
            raise Abort(NOT_NOW)
        else:
            words = [value] if value else []
        for word in words:
            entry = self.entries.get((word >> 16, word >> 8 & 0xFF))
            if word and entry is None:
                raise Abort(NO_OBJECT)
            if entry is None or not entry.mappable or word & 0xFF != 8 * entry.size:
                raise Abort(NOT_MAPPABLE)
            if receives != (entry.access == 'rww'):
                raise Abort(NOT_MAPPABLE)

    # SDO.
    def entry(self, index, sub):
        if (index, sub) in self.entries:
            return self.entries[index, sub]
        raise Abort(NO_SUB_INDEX if any(known == index for known, _ in self.entries) else NO_OBJECT)

    def judge(self, index, sub, data):
        entry = self.entry(index, sub)
        if entry.access in ('ro', 'const'):
            raise Abort(READ_ONLY)
        if len(data) != entry.size:
            raise Abort(TOO_LONG if len(data) > entry.size else TOO_SHORT)
        value = int.from_bytes(data, 'little')
        if 0x1400 <= index < 0x1600 or 0x1800 <= index < 0x1A00:
            if sub == 1:
                self.judge_cob_id(index, value)
            elif 240 < value < 254:
                raise Abort(INVALID_VALUE)
        elif 0x1600 <= index < 0x1C00:
            self.judge_mapping(index, sub, value)
        elif index == 0x1016 and value >> 16 & 0x7F and value & 0xFFFF:
            others = {known for (at, each), known in self.entries.items() if at == index and each not in (0, sub)}
            if any(other.number >> 16 & 0x7F == value >> 16 & 0x7F for other in others):
                raise Abort(INCOMPATIBLE)
        return entry

    def write(self, index, sub, data):
        entry = self.judge(index, sub, data)
        if self.manner == 'consumer-crash' and (index, sub) == (0x1016, 1) and not any(data):
            os._exit(1)
        entry.value = bytes(data)
        if index == 0x1017:
            self.beat = None

    def answer(self, data):
        self.send(0x580 + NODE, bytes(data).ljust(8, b'\0'))

    def begin_upload(self, index, sub, head):
        entry = self.entry(index, sub)
        if entry.access == 'wo':
            raise Abort(0x06010001)
        value = entry.value
        if self.manner == 'late-abort' and index == 0x1018:
            self.answer(struct.pack('<BHBI', 0x80, 0, 0, 0x08000000))
        if len(value) <= 4:
            return self.answer(bytes([0x43 | (4 - len(value)) << 2]) + head + value)
        self.transfer = ('upload', index, sub, value, 0)
        announced = 4 if self.manner == 'oversize' and index == 0x2003 else len(value)
        return self.answer(b'\x41' + head + struct.pack('<I', announced))

    def upload_segment(self, command):
        if self.transfer is None or self.transfer[0] != 'upload':
            raise Abort(NO_COMMAND)
        kind, index, sub, left, toggle = self.transfer
        if command & 0x10 != toggle:
            raise Abort(TOGGLE)
        part, left = left[:7], left[7:]
        if index == 0x2003 and self.manner == 'empty-segments':
            part, left = b'', b'endless'
        if index == 0x2003 and self.manner == 'oversize':
            left = bytes(100)
        self.transfer = (kind, index, sub, left, toggle ^ 0x10) if left else None
        self.answer(bytes([toggle | (7 - len(part)) << 1 | (0 if left else 1)]) + part)

    def begin_download(self, command, index, sub, head, data):
        if command & 2:
            entry = self.entry(index, sub)
            self.write(index, sub, data[:4 - (command >> 2 & 3) if command & 1 else entry.size or 4])
        else:
            entry = self.entry(index, sub)
            announced = struct.unpack('<I', data)[0] if command & 1 else None
            if entry.access in ('ro', 'const'):
                raise Abort(READ_ONLY)
            if announced is not None and announced != entry.size:
                raise Abort(TOO_LONG if announced > entry.size else TOO_SHORT)
            self.transfer = ('download', index, sub, b'', 0)
        self.answer(b'\x60' + head)

    def download_segment(self, command, data):
        if self.transfer is None or self.transfer[0] != 'download':
            raise Abort(NO_COMMAND)
        kind, index, sub, value, toggle = self.transfer
        if command & 0x10 != toggle:
            raise Abort(TOGGLE)
        value += data[:7 - (command >> 1 & 7)]
        if len(value) > self.entry(index, sub).size:
            raise Abort(TOO_LONG)
        self.transfer = None if command & 1 else (kind, index, sub, value, toggle ^ 0x10)
        if command & 1:
            self.write(index, sub, value)
        self.answer([0x20 | toggle])

    def request(self, data):
        if len(data) != 8 or self.state == STOPPED:
            return
        command, head = data[0], bytes(data[1:4])
        index, sub = struct.unpack('<HB', head)
        named = (self.transfer[1], self.transfer[2]) if self.transfer and command >> 5 in (0, 3) else (index, sub)
        try:
            if command >> 5 == 4:
                self.transfer = None
            elif command >> 5 in (1, 2):
                self.transfer = None
                if command >> 5 == 2:
                    self.begin_upload(index, sub, head)
                else:
                    self.begin_download(command, index, sub, head, bytes(data[4:]))
            elif command >> 5 == 3:
                self.upload_segment(command)
            elif command >> 5 == 0:
                self.download_segment(command, bytes(data[1:]))
            else:
                raise Abort(NO_COMMAND)
        except Abort as abort:
            self.transfer = None
            self.answer(struct.pack('<BHBI', 0x80, *named, abort.args[0]))

    def run(self):
        while True:
            patience = None if self.beat is None else max(0, self.beat - time.monotonic())
            message = self.bus.recv(patience)
            if message is not None and not message.is_remote_frame and not message.is_extended_id:
                if message.arbitration_id == 0:
                    self.command(message.data)
                elif message.arbitration_id == 0x600 + NODE:
                    self.request(message.data)
                elif self.state == OPERATIONAL:
                    self.take_rpdo(message.arbitration_id, bytes(message.data))
            self.on_time(time.monotonic())


def main():
    interface, eds, *manner = sys.argv[1:]
    with can.Bus(interface='socketcan', channel=interface) as bus:
        slave = Slave(bus, entries_of(eds), manner[0] if manner else None)
        print('ready', file=sys.stderr, flush=True)
        slave.run()


main()
