"""A bus of which everything is looked at that is on it: soak.py."""

import socket
import struct
import time

ANSWER = 5.0  # s


class Failure(Exception):
    """Something that must not happen."""


class Bus:
    """A socket that sees all frames, an SDO client, and when each node was heard last."""

    def __init__(self, interface):
        self.socket = socket.socket(socket.AF_CAN, socket.SOCK_RAW, socket.CAN_RAW)
        self.socket.bind((interface,))
        self.heard = {}
        self.frames = 0
        self.statusword = {}

    def send(self, identifier, data=b''):
        self.socket.send(struct.pack('<IB3x', identifier, len(data)) + data.ljust(8, b'\0'))

    def next(self, until):
        """The next frame before UNTIL, or nothing."""
        left = until - time.monotonic()
        if left <= 0:
            return None
        self.socket.settimeout(left)
        try:
            frame = self.socket.recv(16)
        except TimeoutError:
            return None
        identifier, length = struct.unpack('<IB', frame[:5])
        self.frames += 1
        if 0x701 <= identifier <= 0x77F:
            self.heard[identifier - 0x700] = time.monotonic()
        if 0x181 <= identifier <= 0x1FF and length >= 2:
            self.statusword[identifier - 0x180] = struct.unpack('<H', frame[8:10])[0]
        return identifier, frame[8:8 + length]

    def ask(self, node, command, index, sub_index, value=0):
        """The answer to an SDO request."""
        self.send(0x600 + node, struct.pack('<BHBI', command, index, sub_index, value))
        until = time.monotonic() + ANSWER
        while frame := self.next(until):
            if frame[0] == 0x580 + node:
                if frame[1][1:4] != struct.pack('<HB', index, sub_index):
                    raise Failure(f'node {node} answers {frame[1].hex()} to {index:04X}h:{sub_index:02X}')
                return frame[1]
        raise Failure(f'node {node} has not answered {index:04X}h:{sub_index:02X}')

    def write(self, node, index, sub_index, value, size):
        answer = self.ask(node, {1: 0x2F, 2: 0x2B, 4: 0x23}[size], index, sub_index, value)
        if answer[0] != 0x60:
            raise Failure(f'node {node} refuses {index:04X}h:{sub_index:02X}: {answer[4:].hex()}')
