"""A CANopen master of several nodes that does what it is told: hosts_master.py FIRST-NODE LAST-NODE

To be run by with-can. It reads words from standard input, one a line, and answers each with a line of JSON: {"error": ...} if
something is not as it should be, else what was found.
boot NODE...        waits for the boot-up of those, none of which has been told yet
anew                waits until all units, which were Operational, have booted; of those that did it unheard the heartbeat tells
times COUNT         how long COUNT expedited uploads of each node take (s)
start               maps PDOs, heartbeat, start, and each axis to Operation enabled, turning
stop                each axis to rest
lost NODE...        waits until the heartbeat of exactly those is missing; time since the last one (s)
heard               waits until no heartbeat is missing
told                how often the network went down since the last time
"""

import errno
import json
import select
import socket
import struct
import sys
import time

PATIENCE = 20  # s
HEARTBEAT, MISSING = 0.1, 0.5  # s: producer, consumer
FRAME = struct.Struct("=IB3x8s")
FULL_SPEED = 209715200  # increments/s: 3000 rpm
INVALID = 1 << 31
BOOT_UP, PRE_OPERATIONAL = b"\0", b"\x7f"
RESET, SHUTDOWN, SWITCH_ON, ENABLE = 0x80, 0x06, 0x07, 0x0F
READY, SWITCHED_ON, ENABLED = 0x21, 0x23, 0x27
STATE, FAULT = 0x6F, 0x08
RPDO, TPDO = 0x200, 0x180


class Bus:
    """A raw socket, and what was last heard under each identifier."""

    def __init__(self):
        self.socket = socket.socket(socket.PF_CAN, socket.SOCK_RAW | socket.SOCK_NONBLOCK, socket.CAN_RAW)
        self.socket.bind(("can0",))
        self.last, self.heard, self.count, self.down = {}, {}, {}, 0

    def send(self, identifier, data):
        self.socket.send(FRAME.pack(identifier, len(data), bytes(data).ljust(8, b"\0")))

    def read(self, patience):
        """Takes what has come, or comes within PATIENCE (s)."""
        if not select.select([self.socket], [], [], max(0, patience))[0]:
            return
        while True:
            try:
                identifier, length, data = FRAME.unpack(self.socket.recv(FRAME.size))
            except BlockingIOError:
                return
            except OSError as error:
                if error.errno != errno.ENETDOWN:
                    raise
                self.down += 1
                continue
            self.last[identifier] = data[:length]
            self.heard[identifier] = time.monotonic()
            self.count[identifier] = self.count.get(identifier, 0) + 1

    def wait(self, condition, what):
        end = time.monotonic() + PATIENCE
        while not condition():
            assert time.monotonic() < end, f"not within {PATIENCE} s: {what}"
            self.read(0.05)


class Node:
    """A drive, as the master sees it."""

    def __init__(self, bus, number):
        self.bus, self.number, self.boots = bus, number, 0

    def _exchange(self, request, index, sub):
        answer = 0x580 + self.number
        self.bus.last.pop(answer, None)
        self.bus.send(0x600 + self.number, request)
        self.bus.wait(lambda: answer in self.bus.last, f"an answer of node {self.number} to {index:04X}h:{sub:02X}")
        data = self.bus.last[answer]
        assert data[1:4] == struct.pack("<HB", index, sub) and data[0] != 0x80, (self.number, data.hex())
        return data

    def get(self, index, sub=0):
        return int.from_bytes(self._exchange(struct.pack("<BHB4x", 0x40, index, sub), index, sub)[4:8], "little")

    def set(self, index, sub, value, size):
        self._exchange(struct.pack("<BHB", 0x23 | (4 - size) << 2, index, sub) + value.to_bytes(size, "little").ljust(4, b"\0"), index, sub)

    def map(self, communication, cob_id, *entries):
        self.set(communication, 1, (cob_id + self.number) | INVALID, 4)
        self.set(communication + 0x200, 0, 0, 1)
        for sub, entry in enumerate(entries, 1):
            self.set(communication + 0x200, sub, entry, 4)
        self.set(communication + 0x200, 0, len(entries), 1)
        self.set(communication, 1, cob_id + self.number + (1 << 30 if communication >= 0x1800 else 0), 4)

    def command(self, controlword, velocity=0):
        self.bus.send(RPDO + self.number, struct.pack("<Hi", controlword, velocity))

    def state(self):
        return self._process_data()[0] & STATE

    def velocity(self):
        return self._process_data()[1]

    def _process_data(self):
        data = self.bus.last.get(TPDO + self.number, b"")
        return struct.unpack("<Hi", data) if len(data) == 6 else (0, 0)

    def is_missing(self):
        return time.monotonic() - self.bus.heard.get(0x700 + self.number, 0) > MISSING


class Master:
    def __init__(self, first, last):
        self.bus = Bus()
        self.nodes = {number: Node(self.bus, number) for number in range(first, last + 1)}
        self.boots = {number: 0 for number in self.nodes}

    def boot(self, *numbers):
        """Boot-up is a heartbeat of 0; the units send no other one before they are told to."""
        for number in map(int, numbers):
            self.bus.wait(lambda number=number: self.bus.last.get(0x700 + number) == BOOT_UP, f"the boot-up of node {number}")
            del self.bus.last[0x700 + number]
        return sorted(map(int, numbers))

    def anew(self):
        for node in self.nodes.values():
            self.bus.wait(lambda node=node: self.bus.last.get(0x700 + node.number) in (BOOT_UP, PRE_OPERATIONAL), f"node {node.number} anew")
        return sorted(self.nodes)

    def times(self, count):
        times = []
        for _ in range(int(count)):
            for node in self.nodes.values():
                begin = time.monotonic()
                node.get(0x1000)
                times.append(time.monotonic() - begin)
        return times

    def start(self):
        for node in self.nodes.values():
            self.bus.send(0x000, [0x80, node.number])  # PDOs are mapped in Pre-operational
            node.map(0x1400, RPDO, 0x60400010, 0x60FF0020)
            node.map(0x1800, TPDO, 0x60410010, 0x606C0020)
            node.set(0x1800, 5, 20, 2)  # event timer (ms): the velocity changes without an event
            node.set(0x1017, 0, int(1000 * HEARTBEAT), 2)
            self.bus.send(0x000, [0x01, node.number])
        # Who was in Operational before has a fault now: the master has left it.
        self._command(lambda node: node.state() and not node.state() & FAULT, "no fault", RESET)
        for controlword, state in ((SHUTDOWN, READY), (SWITCH_ON, SWITCHED_ON), (ENABLE, ENABLED)):
            self._command(lambda node: node.state() == state, f"the state {state:02X}h", controlword)
        self._command(lambda node: abs(node.velocity() - FULL_SPEED) < FULL_SPEED / 100, "3000 rpm", ENABLE, FULL_SPEED)
        return {number: node.velocity() for number, node in self.nodes.items()}

    def stop(self):
        self._command(lambda node: abs(node.velocity()) < FULL_SPEED / 100 and node.state() == READY, "rest", SHUTDOWN)
        return {number: node.velocity() for number, node in self.nodes.items()}

    def _command(self, condition, what, *command):
        for node in self.nodes.values():
            node.command(*command)
        for node in self.nodes.values():
            try:
                self.bus.wait(lambda node=node: condition(node), what)
            except AssertionError as error:
                raise AssertionError(f"{error} of node {node.number}: {node.state():02X}h, {node.velocity()} increments/s") from error

    def lost(self, *numbers):
        wanted = set(map(int, numbers))
        self.bus.wait(lambda: {number for number, node in self.nodes.items() if node.is_missing()} >= wanted, f"no heartbeat of {numbers}")
        return max(time.monotonic() - self.bus.heard[0x700 + number] for number in wanted)

    def heard(self):
        self.bus.wait(lambda: not any(node.is_missing() for node in self.nodes.values()), "all heartbeats")
        return True

    def told(self):
        self.bus.read(0)
        self.bus.down, told = 0, self.bus.down
        return told


def main():
    master = Master(int(sys.argv[1]), int(sys.argv[2]))
    print(json.dumps("ready"), flush=True)
    while True:
        if not select.select([sys.stdin], [], [], 0)[0]:
            master.bus.read(0.02)
            continue
        words = sys.stdin.readline().split()
        if not words:
            return
        try:
            found = getattr(master, words[0])(*words[1:])
        except (AssertionError, OSError) as error:
            found = {"error": str(error)}
        print(json.dumps(found), flush=True)


main()
