"""A member of a bus that writes down all that happens to its socket: bus_member.py LOG [SENDER FRAMES-A-SECOND]

To be run by with-can. As a sender it sends numbered frames until SIGUSR1, and one more for each SIGUSR2. Lines of its log:
S NUMBER ERRNO TIME     it has sent a frame, or could not (0: it was taken)
R SENDER NUMBER OWN STAMP DROPPED TIME     it has read a frame; OWN: its own, confirmed; STAMP: of the frame on the bus;
        DROPPED: messages that it has lost so far because it did not read
D TIME     it was told that the network is down
TIME is before sending and behind reading, all in ns since 1970.
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
SO_RXQ_OVFL = 40
SO_TIMESTAMPNS = 35
ROOM = 256


class Member:
    def __init__(self, log, sender, rate):
        self.log, self.sender, self.number = open(log, "w", buffering=1, encoding="ascii"), sender, 0
        self.period = 1 / rate if rate else None
        self.more = 0       # asked for by signals so far
        self.more_sent = 0  # of them
        self.socket = socket.socket(socket.PF_CAN, socket.SOCK_RAW | socket.SOCK_NONBLOCK, socket.CAN_RAW)
        self.socket.setsockopt(socket.SOL_CAN_RAW, socket.CAN_RAW_RECV_OWN_MSGS, 1)
        self.socket.setsockopt(socket.SOL_SOCKET, SO_RXQ_OVFL, 1)
        self.socket.setsockopt(socket.SOL_SOCKET, SO_TIMESTAMPNS, 1)
        self.socket.bind(("can0",))

    def stop(self, *_):
        self.period = None

    def send_more(self, *_):
        self.more += 1

    def send(self):
        self.number += 1
        data = NUMBERS.pack(self.sender, self.number)
        error, now = 0, time.time_ns()
        try:
            self.socket.send(FRAME.pack(0x100 + self.sender, len(data), data.ljust(8, b"\0")))
        except OSError as failure:
            error = failure.errno
        self.log.write(f"S {self.number} {error} {now}\n")

    def read(self):
        """False: there was nothing."""
        try:
            frame, control, flags, _ = self.socket.recvmsg(FRAME.size, ROOM)
        except BlockingIOError:
            return False
        except OSError as failure:
            if failure.errno != errno.ENETDOWN:
                raise
            self.log.write(f"D {time.time_ns()}\n")
            return True
        sender, number = NUMBERS.unpack_from(FRAME.unpack(frame)[2])
        items = {kind: data for _, kind, data in control}
        seconds, rest = struct.unpack("=qq", items[SO_TIMESTAMPNS])
        dropped = struct.unpack("=I", items.get(SO_RXQ_OVFL, b"\0" * 4))[0]
        own = 1 if flags & socket.MSG_CONFIRM else 0
        self.log.write(f"R {sender} {number} {own} {seconds * 10**9 + rest} {dropped} {time.time_ns()}\n")
        return True

    def run(self):
        poll = select.poll()
        poll.register(self.socket, select.POLLIN)
        due = time.monotonic()
        while True:
            wait = 0.1 if self.period is None else max(0, due - time.monotonic())
            if poll.poll(1000 * wait):
                for _ in range(ROOM):
                    if not self.read():
                        break
            period = self.period  # a signal may end it in the next moment
            if period is not None and time.monotonic() >= due:
                self.send()
                due = max(due + period, time.monotonic())
            while self.more_sent < self.more:
                self.more_sent += 1
                self.send()


def main():
    member = Member(sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 0, float(sys.argv[3]) if len(sys.argv) > 3 else 0)
    signal.signal(signal.SIGUSR1, member.stop)
    signal.signal(signal.SIGUSR2, member.send_more)
    print("ready", flush=True)
    member.run()


main()
