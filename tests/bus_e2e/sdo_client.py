"""A master of the tests on vcan0 that asks nodes by SDO, and looks at their answers itself."""

import socket
import struct
import time

SAVE = struct.unpack('<I', b'save')[0]
ANSWER = 5  # s


def answer_in(frame):
    """The SDO answer that FRAME is, as (node, data); none if it is none."""
    identifier = struct.unpack('<I', frame[:4])[0]
    return [(identifier - 0x580, frame[8:])] if 0x581 <= identifier <= 0x5FF else []


class Client:
    """A socket on a bus, with SDO requests to its nodes."""

    def __init__(self):
        self.socket = socket.socket(socket.AF_CAN, socket.SOCK_RAW, socket.CAN_RAW)
        self.socket.bind(('vcan0',))

    def request(self, node, command, index, sub_index, value=0):
        self.socket.send(struct.pack('<IB3xBHBI', 0x600 + node, 8, command, index, sub_index, value))

    def answers(self, longest, count=1):
        """The frames of SDO answers that come within LONGEST s: at most COUNT, as (node, data)."""
        found = []
        end = time.monotonic() + longest
        while len(found) < count and (left := end - time.monotonic()) > 0:
            self.socket.settimeout(left)
            try:
                frame = self.socket.recv(16)
            except TimeoutError:
                break
            found += answer_in(frame)
        return found

    def read(self, node):
        """1017h of NODE in ms."""
        self.request(node, 0x40, 0x1017, 0)
        for answered, data in self.answers(ANSWER):
            if answered == node and data[0] == 0x4B:
                return struct.unpack('<H', data[4:6])[0]
        raise AssertionError(f'node {node} does not answer')

    def drain(self):
        """The frames of SDO answers that have come by now, as answers() has them."""
        self.socket.setblocking(False)
        found = []
        try:
            while True:
                found += answer_in(self.socket.recv(16))
        except BlockingIOError:
            pass
        self.socket.setblocking(True)
        return found
