"""Several frames in one message of the user-space bus, beside members of an older version: frames_in_one.py BIN-FOLDER

To be run by with-can, on a bus of its own. A member that takes and sends such messages, one that does not, a program under
with-can and axisd see the same frames in the same order, and axisd answers whatever its requests came in.
"""

import os
import socket
import struct
import sys

import programs
from master import BOOT_UP, NODE, Master, can

HELLO, BIND, INTERFACE_INDEX, SET_OPTION, OWN_MESSAGES = 0, 1, 6, 3, 1
MOST = 32  # frames in a message
FRAME, TRAILER = struct.Struct('=IB3x8s'), struct.Struct('=iIqII')
SIZE = FRAME.size + TRAILER.size
ROUNDS = 50
SYNC, REQUEST, ANSWER, END = 0x80, 0x600 + NODE, 0x580 + NODE, 0x7FE


class Member:
    """A member that hears itself; `most`: frames that a message to it may have, None: as an older client it does not say."""

    def __init__(self, path, most):
        self.socket = socket.socket(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        self.socket.bind(b'\0can-bus.1/port/' + os.urandom(8).hex().encode())
        self.socket.connect(path)
        self.socket.settimeout(programs.PATIENCE)
        _, answer = self.ask(HELLO, payload=b'' if most is None else struct.pack('=I', most))
        assert answer == (b'' if most is None else struct.pack('=I', MOST)), answer
        self.ask(SET_OPTION, payload=struct.pack('=II', OWN_MESSAGES, 1))
        index, _ = self.ask(INTERFACE_INDEX, payload=b'vcan0')
        self.ask(BIND, index)
        self.longest = 0  # frames in a message that has come

    def ask(self, operation, value=0, payload=b''):
        mine, its = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        with mine:
            with its:
                socket.send_fds(self.socket, [struct.pack('=IiI', operation, value, len(payload)) + payload], [its.fileno()])
            mine.settimeout(programs.PATIENCE)
            reply = mine.recv(8192)
        error, result, size = struct.unpack_from('=iiI', reply)
        assert error == 0, os.strerror(error)
        return result, reply[12:12 + size]

    def send(self, *frames):
        """All in one message."""
        self.socket.send(b''.join(FRAME.pack(identifier, len(data), data.ljust(8, b'\0')) + bytes(TRAILER.size)
                                  for identifier, data in frames))

    def frames_until(self, is_over):
        """What comes, until what has come IS_OVER."""
        frames = []
        while not is_over(frames):
            message = self.socket.recv(8192)
            assert message and len(message) % SIZE == 0, message
            self.longest = max(self.longest, len(message) // SIZE)
            for at in range(0, len(message), SIZE):
                identifier, length, data = FRAME.unpack_from(message, at)
                frames.append((identifier, data[:length]))
        return frames


def frames_of_program(bus, is_over):
    """The same of python-can under with-can."""
    frames = []
    while not is_over(frames):
        message = bus.recv(programs.PATIENCE)
        assert message is not None, frames
        frames.append((message.arbitration_id, bytes(message.data)))
    return frames


def ask_in_bursts(new, old):
    """Requests to the unit in messages of several frames, and frames of the older member between them."""
    for number in range(ROUNDS):
        data = struct.pack('<I', number)
        new.send((SYNC, b''), (REQUEST, bytes.fromhex('4000100000000000')), (0x123, data),
                 (REQUEST, bytes.fromhex('4018100100000000')))
        old.send((0x124, data))


def expect_in_order(frames):
    """Everything that was sent, each sender's in its order, and an answer to every request."""
    of = {identifier: [data for seen, data in frames if seen == identifier] for identifier in (SYNC, 0x123, 0x124, ANSWER)}
    numbers = [struct.pack('<I', number) for number in range(ROUNDS)]
    assert of[0x123] == numbers and of[0x124] == numbers, of
    assert len(of[SYNC]) == ROUNDS
    objects = [struct.unpack_from('<H', data, 1)[0] for data in of[ANSWER]]
    assert objects == [0x1000, 0x1018] * ROUNDS, objects


def main():
    with programs.Folder(sys.argv[1]) as folder, can.Bus('vcan0', interface='socketcan') as bus:
        unit = folder.start('axisd', '--interface', f'unix:{os.environ["CAN_BUS"]}', '--node-id', str(NODE))
        unit.expect('ready')
        master = Master(bus)
        master.expect(*BOOT_UP)
        new, old = Member(os.environ['CAN_BUS'], MOST), Member(os.environ['CAN_BUS'], None)
        ask_in_bursts(new, old)
        frames = new.frames_until(lambda seen: sum(identifier == ANSWER for identifier, _ in seen) == 2 * ROUNDS)
        old.send((END, b''))
        frames += new.frames_until(lambda seen: (END, b'') in seen)
        expect_in_order(frames)
        assert old.frames_until(lambda seen: (END, b'') in seen) == frames
        assert frames_of_program(bus, lambda seen: (END, b'') in seen) == frames
        assert new.longest > 1 and old.longest == 1, (new.longest, old.longest)


main()
