"""axisd with the profile cia402 as node 5, and a master that knows its EDS."""

import json
import os
import struct
import time

import programs
from eds_file import FORMATS, Eds
from master import NODE, Abort, Master, can

AXIS_STEP = 0x800  # between the objects of two axes
SYNC, EMCY, HEARTBEAT = 0x080, 0x080, 0x700
TPDO, RPDO = 0x180, 0x200  # the first one of a node; the next are 100h higher
PRE_OPERATIONAL, OPERATIONAL = 0x7F, 0x05

# 6060h
NO_MODE, PROFILE_POSITION, PROFILE_VELOCITY, HOMING, CYCLIC_POSITION = 0, 1, 3, 6, 8
# 6040h
SHUTDOWN, SWITCH_ON, ENABLE, RESET, START, IMMEDIATELY, HALT = 0x06, 0x07, 0x0F, 0x80, 0x10, 0x20, 0x100
# 6041h
DISABLED, READY, SWITCHED_ON, ENABLED = 0x40, 0x21, 0x23, 0x27
REACHED, ACKNOWLEDGED, ERROR, HOMED = 1 << 10, 1 << 12, 1 << 13, 1 << 15
ATTAINED = FOLLOWS = ACKNOWLEDGED
STEPS = (SHUTDOWN, READY), (SWITCH_ON, SWITCHED_ON), (ENABLE, ENABLED)

REVOLUTION = 65536  # position units


def is_in(state, statusword):
    return statusword & (0x4F if state == DISABLED else 0x6F) == state


def signed(data):
    return int.from_bytes(data, 'little', signed=True)


class Watched:
    """A bus of python-can that keeps the last data under each identifier, and takes no EMCY but one that is expected."""

    def __init__(self, bus):
        self.bus = bus
        self.latest = {}
        self.expected = set()  # error codes
        self.send = bus.send

    def recv(self, timeout):
        message = self.bus.recv(timeout)
        if message is not None:
            self.latest[message.arbitration_id] = bytes(message.data)
            if EMCY < message.arbitration_id <= EMCY + 127:
                code = struct.unpack('<H', message.data[:2])[0]
                assert code in self.expected, f'EMCY {code:04X}h: {message.arbitration_id:03X}#{message.data.hex()}'
        return message


class Cia402Master(Master):
    """Objects by their types in the EDS, and the course of an axis over SDO; objects are those of axis 1."""

    def __init__(self, bus, eds_path, node=NODE):
        super().__init__(bus, node)
        self.eds = Eds(eds_path, node)

    def get(self, index, sub_index=0, axis=1):
        index += AXIS_STEP * (axis - 1)
        form = FORMATS[int(self.eds.entry(index, sub_index)['DataType'], 0)]
        return struct.unpack(form, self.upload(index, sub_index))[0]

    def put(self, index, value, sub_index=0, axis=1):
        index += AXIS_STEP * (axis - 1)
        try:
            self.write(index, sub_index, self.eds.packed(index, sub_index, value))
        except Abort as abort:
            raise AssertionError(f'{index:04X}h:{sub_index:02X} = {value:X}h: {abort.args[0]:08X}h') from abort

    def refused(self, index, sub_index, data):
        """The abort code of a write that is not taken."""
        try:
            self.write(index, sub_index, data)
        except Abort as abort:
            return abort.args[0]
        raise AssertionError(f'{index:04X}h:{sub_index:02X} takes {data.hex()}')

    def upload_segmented(self, index, sub_index=0):
        """Bytes of an object of any size."""
        self.send(0x600 + self.node, struct.pack('<BHB4x', 0x40, index, sub_index).hex())
        size, = struct.unpack('<I', self._sdo_answer(index, sub_index)[4:])
        text, toggle = b'', 0
        while True:
            self.send(0x600 + self.node, struct.pack('<B7x', 0x60 | toggle).hex())
            answer = self.receive(0x580 + self.node)
            assert answer[0] & 0xF0 == toggle, answer.hex()
            text += answer[1:8 - (answer[0] >> 1 & 7)]
            toggle ^= 0x10
            if answer[0] & 1:
                assert len(text) == size, (text, size)
                return text

    def operational(self):
        self.send(0x000, f'01{self.node:02x}')

    def until(self, holds, what, axis=1):
        """Reads 6041h until it HOLDS; what was read."""
        deadline = time.monotonic() + programs.PATIENCE
        while not holds(statusword := self.get(0x6041, axis=axis)):
            assert time.monotonic() < deadline, f'{what}: 6041h is {statusword:04X}h, 6064h {self.get(0x6064, axis=axis)}'
        return statusword

    def enable(self, axis=1):
        """To Operation enabled: 6041h shows each state right behind its command."""
        for controlword, state in STEPS:
            self.put(0x6040, controlword, axis=axis)
            statusword = self.get(0x6041, axis=axis)
            assert is_in(state, statusword), f'{controlword:04X}h led to {statusword:04X}h'

    def home(self, method, axis=1):
        """A homing; the states that 6041h went through, as its bits 13, 12 and 10."""
        self.put(0x6098, method, axis=axis)
        self.put(0x6060, HOMING, axis=axis)
        assert self.get(0x6061, axis=axis) == HOMING
        self.put(0x6040, ENABLE | START, axis=axis)
        seen = []

        def is_over(statusword):
            now = statusword & (ERROR | ATTAINED | REACHED)
            if not seen or now != seen[-1]:
                seen.append(now)
            return now in (ATTAINED | REACHED, ERROR | REACHED)

        self.until(is_over, 'homing', axis)
        self.put(0x6040, ENABLE, axis=axis)
        return seen

    def position(self, target, more=0, axis=1):
        """A positioning by the handshake of mode 1, with further bits of 6040h."""
        self.put(0x607A, target, axis=axis)
        self.put(0x6040, ENABLE | START | more, axis=axis)
        statusword = self.get(0x6041, axis=axis)
        assert statusword & ACKNOWLEDGED and not statusword & REACHED, f'{statusword:04X}h'
        self.put(0x6040, ENABLE | more, axis=axis)
        self.until(lambda now: not now & ACKNOWLEDGED, 'the end of the handshake', axis)
        self.until(lambda now: now & REACHED, f'position {target}', axis)
        assert abs(self.get(0x6064, axis=axis) - target) <= self.get(0x6067, axis=axis)


def start_unit(folder, axes=(), **unit):
    """axisd with the profile cia402 as node 5, ready on the bus of with-can or on vcan0; UNIT adds to its configuration."""
    with open(folder.path('axisd.json'), 'w', encoding='ascii') as file:
        json.dump({'profile': 'cia402', 'axes': list(axes) or [{}], **unit}, file)
    interface = f'unix:{os.environ["CAN_BUS"]}' if 'CAN_BUS' in os.environ else 'vcan0'
    daemon = folder.start('axisd', '--interface', interface, '--node-id', str(NODE),
                          '--config', folder.path('axisd.json'), '--state-directory', folder.path('state'),
                          '--control', folder.path('control.sock'))
    daemon.expect(f'ready: node {NODE} on')
    return daemon


def run(bin_folder, eds_path, course, axes=(), **unit):
    """COURSE(master) before a unit of its own."""
    with programs.Folder(bin_folder) as folder, can.Bus('vcan0', interface='socketcan') as bus:
        daemon = start_unit(folder, axes, **unit)
        course(Cia402Master(Watched(bus), eds_path))
        assert daemon.end() == 0
