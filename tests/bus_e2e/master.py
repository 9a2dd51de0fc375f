"""A small CANopen master on a bus of python-can."""

import struct
import sys
import time

from programs import PATIENCE

try:
    import can
except ImportError as missing:
    sys.exit(f'{missing}: install python3-can and python3-msgpack (scripts/setup.sh)')

NODE = 5
BOOT_UP = (0x700 + NODE, '00')
DEVICE_TYPE = 0xFFFF0192


class Abort(Exception):
    """The unit has refused an SDO transfer; args[0] is the abort code."""


class Master:
    """Sends frames and waits for those of a node."""

    def __init__(self, bus, node=NODE):
        self.bus = bus
        self.node = node

    def send(self, identifier, data):
        self.bus.send(can.Message(arbitration_id=identifier, is_extended_id=False, data=bytes.fromhex(data)))

    def receive(self, identifier, wanted=lambda data: True):
        """The data of the next frame under IDENTIFIER that is WANTED."""
        deadline = time.monotonic() + PATIENCE
        seen = []
        while time.monotonic() < deadline:
            message = self.bus.recv(deadline - time.monotonic())
            if message is None:
                continue
            seen.append(f'{message.arbitration_id:03X}#{message.data.hex()}')
            # python-can's socketcand takes every identifier for one of 29 bits, so that flag tells nothing.
            if message.arbitration_id == identifier and wanted(message.data):
                return message.data
        raise AssertionError(f'no such frame under {identifier:03X}h, only {seen[-20:]}')

    def expect(self, identifier, data):
        self.receive(identifier, lambda found: found.hex() == data.lower())

    def read(self, index, sub_index=0):
        """Expedited SDO upload of four bytes; the value."""
        return struct.unpack('<I', self.upload(index, sub_index))[0]

    def write(self, index, sub_index, data):
        """Expedited SDO download of one to four bytes."""
        self.send(0x600 + self.node, (struct.pack('<BHB', 0x23 | (4 - len(data)) << 2, index, sub_index)
                                 + data.ljust(4, b'\0')).hex())
        self._sdo_answer(index, sub_index)

    def upload(self, index, sub_index=0):
        """Expedited SDO upload; one to four bytes."""
        self.send(0x600 + self.node, struct.pack('<BHB4x', 0x40, index, sub_index).hex())
        answer = self._sdo_answer(index, sub_index)
        assert answer[0] & 0xF3 == 0x43, answer.hex()
        return bytes(answer[4:8 - (answer[0] >> 2 & 3)])

    def _sdo_answer(self, index, sub_index):
        answer = self.receive(0x580 + self.node)
        assert answer[1:4] == struct.pack('<HB', index, sub_index), answer.hex()
        if answer[0] == 0x80:
            raise Abort(struct.unpack('<I', answer[4:])[0])
        return answer


def drive(master):
    """NMT start, an SDO upload, and the axis turned by PDOs; the unit has just booted."""
    assert master.read(0x1000) == DEVICE_TYPE
    master.send(0x000, f'01{NODE:02x}')
    for controlword, statusword in (('0600', '3116'), ('0700', '3316'), ('0F00', '3716')):
        master.send(0x200 + NODE, controlword)
        master.expect(0x180 + NODE, statusword)
    master.send(0x300 + NODE, '0F000000800C')  # 3000 rpm
    master.receive(0x280 + NODE, lambda data: struct.unpack('<Hi', data)[1] > 100_000_000)
    master.send(0x200 + NODE, '0600')
    wait_for_rest(master)


def wait_for_rest(master):
    """Until nothing changes any more: of a network that loses frames, the last TPDO need not have come."""
    deadline = time.monotonic() + 2 * PATIENCE
    while True:
        while master.bus.recv(1) is not None:
            assert time.monotonic() < deadline, 'the unit does not come to rest'
        velocity = int.from_bytes(master.upload(0x606C), 'little', signed=True)
        if abs(velocity) < 1_000_000:
            return
        assert time.monotonic() < deadline, f'{velocity} increments/s'
