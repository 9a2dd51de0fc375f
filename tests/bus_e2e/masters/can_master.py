"""A CANopen master of a few lines, for masters that do things right or wrong on purpose."""

import socket
import struct
import time

FRAME = struct.Struct('=IB3x8s')
REMOTE = 0x40000000
EXTENDED = 0x80000000
PATIENCE = 5  # s of the bus


class Aborted(Exception):
    """The server has aborted a transfer: the code."""


class CanMaster:
    def __init__(self, interface='can0'):
        self.socket = socket.socket(socket.PF_CAN, socket.SOCK_RAW, socket.CAN_RAW)
        self.socket.bind((interface,))

    def send(self, identifier, data='', remote=False, extended=False):
        """Sends bytes given as hexadecimal digits, as they are."""
        raw = bytes.fromhex(data)
        flags = (REMOTE if remote else 0) | (EXTENDED if extended else 0)
        self.socket.send(FRAME.pack(identifier | flags, len(raw), raw.ljust(8, b'\0')))

    def receive(self, limit):
        """(identifier, bytes), or None when LIMIT seconds are over."""
        self.socket.settimeout(max(limit, 1e-6))
        try:
            identifier, length, data = FRAME.unpack(self.socket.recv(FRAME.size))
        except (TimeoutError, BlockingIOError):
            return None
        return identifier & 0x1FFFFFFF, data[:length]

    def expect(self, identifier, fits=lambda data: True, limit=PATIENCE):
        """The bytes of the next frame with IDENTIFIER that FITS."""
        end = time.monotonic() + limit
        while (left := end - time.monotonic()) > 0:
            heard = self.receive(left)
            if heard and heard[0] == identifier and fits(heard[1]):
                return heard[1]
        raise AssertionError(f'{identifier:03X}h has not come within {limit} s')

    def wait(self, seconds):
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0:
            self.receive(left)

    def request(self, node, data):
        """Sends an SDO request as it is, and waits for the answer to it."""
        self.send(0x600 + node, data)
        return self.expect(0x580 + node)

    def read(self, node, index, sub=0):
        """The value of an object of at most four bytes."""
        answer = self.request(node, f'40{index & 0xFF:02X}{index >> 8:02X}{sub:02X}00000000')
        if answer[0] == 0x80:
            raise Aborted(struct.unpack('<I', answer[4:])[0])
        return int.from_bytes(answer[4:8 - (answer[0] >> 2 & 3)], 'little')

    def write(self, node, index, sub, value, size):
        command = 0x23 | (4 - size) << 2
        data = (value & (1 << 8 * size) - 1).to_bytes(4, 'little').hex()
        answer = self.request(node, f'{command:02X}{index & 0xFF:02X}{index >> 8:02X}{sub:02X}{data}')
        if answer[0] == 0x80:
            raise Aborted(struct.unpack('<I', answer[4:])[0])

    def try_to_write(self, node, index, sub, value, size):
        """Writes, and does not look at the answer."""
        try:
            self.write(node, index, sub, value, size)
        except Aborted:
            pass

    def nmt(self, command, node=0):
        self.send(0, f'{command:02X}{node:02X}')

    def reset(self, node, command=0x81):
        """Resets a node and waits for its boot-up message."""
        self.nmt(command, node)
        self.expect(0x700 + node, lambda data: data == b'\0')

    def start(self, node):
        """Starts a node, and sees in its heartbeat that it runs."""
        self.write(node, 0x1017, 0, 100, 2)
        self.nmt(1, node)
        self.expect(0x700 + node, lambda data: data == b'\x05')

    def map(self, node, number, objects, is_receive):
        """Maps OBJECTS, (index, sub, bits) each, into a PDO by the book."""
        cob_id = (0x100 if is_receive else 0x80) + number * 0x100 + node
        communication = (0x1400 if is_receive else 0x1800) + number - 1
        mapping = communication + 0x200
        self.write(node, communication, 1, 1 << 31 | cob_id, 4)
        self.write(node, mapping, 0, 0, 1)
        for sub, (index, of, bits) in enumerate(objects, 1):
            self.write(node, mapping, sub, index << 16 | of << 8 | bits, 4)
        self.write(node, mapping, 0, len(objects), 1)
        self.write(node, communication, 1, cob_id, 4)
        return cob_id

    def status_until(self, node, mask, value, axis=0):
        """Reads the statusword until its bits of MASK are VALUE."""
        end = time.monotonic() + PATIENCE
        while (word := self.read(node, 0x6041 + 0x800 * axis)) & mask != value:
            assert time.monotonic() < end, f'statusword {word:04X}h'
            self.wait(0.01)
        return word

    def enable(self, node):
        """Leads a drive to Operation enabled, step by step."""
        for word, mask, value in ((0x06, 0x6F, 0x21), (0x07, 0x6F, 0x23), (0x0F, 0x6F, 0x27)):
            self.write(node, 0x6040, 0, word, 2)
            self.status_until(node, mask, value)
