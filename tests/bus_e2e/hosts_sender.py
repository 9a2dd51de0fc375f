"""Sends on can0, to be run by with-can.

hosts_sender.py burst DATA IDENTIFIER...: one frame with DATA (hexadecimal) of each IDENTIFIER, each by a socket of its own
hosts_sender.py numbers SENDER LOG: numbered frames until SIGTERM, 50 a second. Its log: "S NUMBER TIME", a frame that it sends,
"R SENDER NUMBER TIME", one that it hears, its own ones too; TIME in ns of CLOCK_MONOTONIC
"""
import errno
import select
import signal
import socket
import struct
import sys
import time

FRAME = struct.Struct("=IB3x8s")
NUMBERS = struct.Struct("<BI")
PERIOD = 0.02  # s


def member():
    made = socket.socket(socket.PF_CAN, socket.SOCK_RAW | socket.SOCK_NONBLOCK, socket.CAN_RAW)
    made.setsockopt(socket.SOL_CAN_RAW, socket.CAN_RAW_RECV_OWN_MSGS, 1)
    made.bind(("can0",))
    return made


def frame(identifier, data):
    return FRAME.pack(identifier, len(data), data.ljust(8, b"\0"))


def burst(data, identifiers):
    senders = [(member(), identifier) for identifier in identifiers]
    for sender, identifier in senders:
        sender.send(frame(identifier, data))


class Numbers:
    def __init__(self, sender, log):
        self.sender, self.log, self.socket, self.number, self.runs = sender, open(log, "w", buffering=1, encoding="ascii"), member(), 0, True
        signal.signal(signal.SIGTERM, self.stop)

    def stop(self, *_):
        self.runs = False

    def send(self):
        self.number += 1
        self.log.write(f"S {self.number} {time.monotonic_ns()}\n")
        try:
            self.socket.send(frame(0x700 + self.sender, NUMBERS.pack(self.sender, self.number)))
        except OSError as failure:
            assert failure.errno in (errno.ENETDOWN, errno.ENOBUFS, errno.EAGAIN), failure

    def read(self):
        """False: there was nothing."""
        try:
            identifier, _, data = FRAME.unpack(self.socket.recv(FRAME.size))
        except BlockingIOError:
            return False
        except OSError as failure:
            assert failure.errno == errno.ENETDOWN, failure
            return True
        if identifier >= 0x700:
            sender, number = NUMBERS.unpack_from(data)
            self.log.write(f"R {sender} {number} {time.monotonic_ns()}\n")
        return True

    def run(self):
        poll = select.poll()
        poll.register(self.socket, select.POLLIN)
        due = time.monotonic()
        while self.runs:
            if poll.poll(1000 * max(0, due - time.monotonic())):
                while self.read():
                    pass
            if time.monotonic() >= due:
                self.send()
                due = max(due + PERIOD, time.monotonic())


if sys.argv[1] == "burst":
    burst(bytes.fromhex(sys.argv[2]), [int(word) for word in sys.argv[3:]])
else:
    Numbers(int(sys.argv[2]), sys.argv[3]).run()
