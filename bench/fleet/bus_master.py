"""A CANopen master of many nodes on one user-space bus: SDO to all of them at once, synchronous PDOs, SYNC."""
import pathlib
import select
import struct
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "python"))
from axisd import hub_protocol  # noqa: E402  pylint: disable=wrong-import-position

SET_FILTERS, STATISTICS = 4, 10
FRAME, BUS_STATISTICS, MEMBER_STATISTICS = struct.Struct("=IB3x8s"), struct.Struct("=QII"), struct.Struct("=32siiQQQQ")
NOTHING, ALL, SDO_ANSWERS = b"", struct.pack("=II", 0, 0), struct.pack("=II", 0x580, 0x780)
PATIENCE = 60.0  # s
OBJECTS_OF_AXIS, PDOS_OF_AXIS = 0x800, 0x40
INVALID, NO_REMOTE_FRAME = 0xC0000000, 0x40000000
TPDO_IDENTIFIERS = (0x180, 0x280, 0x380, 0x480, 0x200, 0x300, 0x400, 0x500)  # of axes 1 to 8


class BusMaster:
    """The master of nodes 1 to `nodes` with `axes` axes each on the bus at `path`."""

    def __init__(self, path, nodes, axes):
        self.nodes, self.axes = range(1, nodes + 1), axes
        self.member, _ = hub_protocol.join(str(path), "vcan0")
        self.member.setblocking(False)
        self.hear(NOTHING)

    def hear(self, filters):
        """From now on what passes `filters`, and nothing that came before."""
        hub_protocol.ask(self.member, SET_FILTERS, payload=filters)
        while self.receive(0) is not None:
            pass

    def send(self, identifier, data=b""):
        message = FRAME.pack(identifier, len(data), data)
        while True:
            try:
                return self.member.send(message)
            except BlockingIOError:
                select.select([], [self.member], [], PATIENCE)

    def receive(self, seconds):
        """Identifier and data of the next frame; None if none comes."""
        if not select.select([self.member], [], [], seconds)[0]:
            return None
        identifier, length, data = FRAME.unpack_from(self.member.recv(hub_protocol.LONGEST_MESSAGE))
        return identifier, data[:length]

    def gather(self, function, accepts):
        """Waits until each node has sent what `accepts` takes under identifier `function` + node."""
        missing, deadline = set(self.nodes), time.monotonic() + PATIENCE
        while missing:
            frame = self.receive(max(0.0, deadline - time.monotonic()))
            if frame is None:
                sys.exit(f"no answer of nodes {sorted(missing)} under {function:03X}h")
            if frame[0] - function in missing and accepts(frame[1]):
                missing.discard(frame[0] - function)

    def write(self, index, sub_index, size, value_of):
        """An expedited download to all nodes at the same time."""
        self.hear(SDO_ANSWERS)
        for node in self.nodes:
            self.send(0x600 + node, struct.pack("<BHBI", 0x23 | (4 - size) << 2, index, sub_index,
                                                value_of(node) & 0xFFFFFFFF))
        self.gather(0x580, lambda data: self.is_done(data, index, sub_index))
        self.hear(NOTHING)

    @staticmethod
    def is_done(data, index, sub_index):
        if data[0] == 0x80:
            sys.exit(f"SDO {index:04X}:{sub_index:02X}: abort {struct.unpack_from('<I', data, 4)[0]:08X}h")
        return data[:4] == struct.pack("<BHB", 0x60, index, sub_index)

    def map_all(self):
        """One TPDO of each axis, synchronous, with its statusword; no other PDO. All identifiers that the predefined
        connection set gives to PDOs of a node are those of its axes then."""
        for direction, identifier in ((0x1400, 0x200), (0x1800, 0x180)):
            for number in range(4):
                self.write(direction + number, 1, 4, lambda node, at=identifier + number * 0x100: INVALID | at + node)
        for axis, identifier in zip(range(self.axes), TPDO_IDENTIFIERS):
            communication = 0x1800 + PDOS_OF_AXIS * axis
            self.write(communication, 2, 1, lambda _: 1)
            self.write(communication, 1, 4, lambda node, at=identifier: NO_REMOTE_FRAME | at + node)

    def start(self):
        """NMT: all Operational."""
        self.send(0x000, b"\x01\x00")

    def sync(self):
        self.send(0x080)

    def command(self, word):
        """Controlword `word` to all axes."""
        for axis in range(self.axes):
            self.write(0x6040 + OBJECTS_OF_AXIS * axis, 0, 2, lambda _: word)

    def set_speeds(self):
        """Another target velocity for each axis, beyond 1000 rpm."""
        for axis in range(self.axes):
            self.write(0x60FF + OBJECTS_OF_AXIS * axis, 0, 4,
                       lambda node, axis=axis: 70_000_000 + node * 100_000 + axis * 1_000_000)

    def statistics(self):
        """Frames that went over the bus so far, and those that its members have lost."""
        _, answer = hub_protocol.ask(self.member, STATISTICS)
        frames, _, members = BUS_STATISTICS.unpack_from(answer)
        rows = list(MEMBER_STATISTICS.iter_unpack(answer[BUS_STATISTICS.size:]))
        while len(rows) < members:
            _, answer = hub_protocol.ask(self.member, STATISTICS, len(rows))
            page = list(MEMBER_STATISTICS.iter_unpack(answer[BUS_STATISTICS.size:]))
            if not page:
                break
            rows += page
        return frames, sum(row[5] for row in rows)

    def sample(self, seconds, most=20_000):
        """The frames of the next `seconds`, `most` of them at most."""
        self.hear(ALL)
        frames, end = [], time.monotonic() + seconds
        while len(frames) < most and (frame := self.receive(max(0.0, end - time.monotonic()))) is not None:
            frames.append(frame)
        self.hear(NOTHING)
        return frames
