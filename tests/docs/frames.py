"""Frames of a page, sent to a unit and expected from it.

A line is one frame or several, then words. What a master sends is sent: NMT, SYNC, RPDOs, SDO requests; all else has to
come. A master waits for the state that a controlword of CiA 402 leads to. An SDO request without a printed answer has
to be answered by no abort. "bit 8 of 6041h" and "6041h = xx31h" in the words are waited for."""

import re
import socket
import struct
import time

PATIENCE = 20  # s
PAUSE = 0.05  # s between frames of one RPDO, from when the unit has the first: it looks at them every 4 ms
NODE = 0x7F
FUNCTION = 0x780
TO_UNIT = {0x000, 0x080, 0x200, 0x300, 0x400, 0x500, 0x600}
SDO_REQUEST, SDO_ANSWER = 0x600, 0x580
ABORT = 0x80
FRAME = struct.Struct('=IB3x8s')
CONTROLWORD = 0x200  # the first word of RPDO 1
STATE_BITS = 0x6F
STATES = {0x0006: 0x21, 0x0007: 0x23, 0x000F: 0x27}  # what CiA 402 leads to: a master waits for it
STATUSWORD = bytes.fromhex('40416000') + bytes(4)


class Dialogue:
    """A raw socket on the bus, and what has been asked and not been answered."""

    def __init__(self):
        self.can = socket.socket(socket.AF_CAN, socket.SOCK_RAW, socket.CAN_RAW)
        self.can.bind(('vcan0',))
        self.request = None  # identifier and data of an SDO request whose answer the page does not print
        self.node = 5

    def take(self, line, place):
        """Plays one line of a block."""
        place = f'{place}: {line}'
        found = re.match(r'(?:[0-9A-F]{3}#[0-9A-F]*\s+)*(?:[0-9A-F]{3}#[0-9A-F]*)', line)
        assert found or not line.strip() or line.startswith(' '), f'{place}: begins with no frame'
        for frame in found[0].split() if found else []:
            identifier, data = int(frame[:3], 16), bytes.fromhex(frame[4:])
            if identifier & FUNCTION in TO_UNIT and not (self.request and identifier & FUNCTION == SDO_ANSWER):
                self.answered(place)
                self.send(identifier, data)
                if identifier & FUNCTION != SDO_REQUEST:
                    self.statusword(place)  # the unit has what was sent before
                    time.sleep(PAUSE)
                word = int.from_bytes(data[:2], 'little')
                if identifier & FUNCTION == CONTROLWORD and word in STATES:
                    self.wait_for(STATE_BITS, STATES[word], place)
            else:
                self.expect(lambda i, d, want=(identifier, data): (i, d) == want, place)
                self.request = None
        self.wait_for_state(line[found.end():] if found else line, place)

    def end(self, place):
        self.answered(place)

    def send(self, identifier, data):
        self.can.send(FRAME.pack(identifier, len(data), data))
        if identifier & FUNCTION == SDO_REQUEST:
            self.request, self.node = (identifier, data), identifier & NODE

    def expect(self, wanted, place):
        """The data of the next frame that is WANTED."""
        deadline = time.monotonic() + PATIENCE
        while (rest := deadline - time.monotonic()) > 0:
            self.can.settimeout(rest)
            try:
                identifier, length, data = FRAME.unpack(self.can.recv(FRAME.size))
            except TimeoutError:
                break
            if wanted(identifier, data[:length]):
                return data[:length]
        raise AssertionError(f'{place}: has not come')

    def answered(self, place):
        """The answer to a request whose answer is not printed: no abort."""
        if self.request is None:
            return
        identifier, request = self.request
        data = self.expect(lambda i, d: i == SDO_ANSWER + (identifier & NODE) and d[1:4] == request[1:4], place)
        assert data[0] != ABORT, f'{place}: the request before is answered by abort {data[:3:-1].hex()}'
        self.request = None

    def wait_for_state(self, words, place):
        """Waits until 6041h is what the words say."""
        wishes = [(1 << int(bit), 1 << int(bit)) for bit in re.findall(r'bit (\d+) of 6041h', words)]
        wishes += [(0xFF & ~0x80, int(low, 16) & ~0x80) for low in re.findall(r'6041h = xx([0-9A-F]{2})h', words)]
        for mask, value in wishes:
            self.wait_for(mask, value, place)

    def wait_for(self, mask, value, place):
        deadline = time.monotonic() + PATIENCE
        while (word := self.statusword(place)) & mask != value:
            assert time.monotonic() < deadline, f'{place}: 6041h is {word:04X}h'

    def statusword(self, place):
        self.answered(place)
        self.send(SDO_REQUEST + self.node, STATUSWORD)
        self.request = None
        data = self.expect(lambda i, d: i == SDO_ANSWER + self.node and d[1:4] == STATUSWORD[1:4], place)
        return struct.unpack_from('<H', data, 4)[0]
