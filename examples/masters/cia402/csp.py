#!/usr/bin/env python3
"""A master of cyclic synchronous position (mode 8): set-points for each axis of a node and SYNC, every millisecond.

    csp.py [--channel vcan0] [--node 5] [--axes 1] [--seconds 10] [--period 1] [--motion sin2|trapezoid] [--pid PID-OF-AXISD]

Needs python-can (python3-can) on SocketCAN. It prints what became of the set-points; exit status 0 if no axis has failed.

Each axis has three PDOs, whose COB-IDs are those of the nodes from NODE on, one an axis:
RPDO 200h 6040h, 607Ah and TPDO 280h 6064h, 60F4h with SYNC, TPDO 180h 6041h at each change.
"""

import argparse
import gc
import math
import os
import socket
import struct
import sys
import time

import can

FRAME = struct.Struct('=IB3x8s')  # struct can_frame
COMMAND, ANSWER = struct.Struct('<Hi'), struct.Struct('<ii')
SYNC = FRAME.pack(0x80, 0, b'')
INVALID, NO_RTR = 0x80000000, 0x40000000
SHUTDOWN, SWITCH_ON, ENABLE, HALT = 0x06, 0x07, 0x0F, 0x100
CYCLIC_POSITION = 8
FAULT, FOLLOWS = 1 << 3, 1 << 12
REVOLUTION = 65536  # position units, as delivered
SPIN = 150e-6  # s before a deadline that are not slept, for a sleep ends late
PATIENCE = 20  # s
REST = 50  # periods with the last set-point, again and again until all axes were there for as long
NEAR = 64  # position units
BEHIND = 20  # SYNCs that may be without an answer: receive buffers of a system are small


class Failed(Exception):
    """args[0] tells why the master gives up."""


class Node:
    """SDO and NMT; bytes of frames that are cyclic go through `socket`."""

    def __init__(self, bus, node):
        self.bus, self.node, self.socket = bus, node, bus.socket

    def nmt(self, command):
        self.bus.send(can.Message(arbitration_id=0, data=[command, self.node], is_extended_id=False))

    def _ask(self, data):
        self.bus.send(can.Message(arbitration_id=0x600 + self.node, data=data, is_extended_id=False))
        end = time.monotonic() + PATIENCE
        while (left := end - time.monotonic()) > 0:
            message = self.bus.recv(left)
            if message is not None and message.arbitration_id == 0x580 + self.node:
                index, sub_index, value = struct.unpack('<xHBI', message.data)
                if message.data[0] == 0x80:
                    raise Failed(f'{index:04X}h:{sub_index:02X}: abort {value:08X}h')
                return bytes(message.data[4:])
        raise Failed(f'node {self.node} does not answer')

    def write(self, index, sub_index, form, value):
        data = struct.pack('<' + form, value)
        self._ask(struct.pack('<BHB4s', 0x23 | 4 - len(data) << 2, index, sub_index, data))

    def read(self, index, form):
        return struct.unpack_from('<' + form, self._ask(struct.pack('<BHB4x', 0x40, index, 0)))[0]

    def map(self, index, cob_id, kind, objects):
        """A PDO: off, its objects, type, on."""
        self.write(index, 1, 'I', cob_id | INVALID)
        self.write(index + 0x200, 0, 'B', 0)
        for number, entry in enumerate(objects, 1):
            self.write(index + 0x200, number, 'I', entry)
        self.write(index + 0x200, 0, 'B', len(objects))
        self.write(index, 2, 'B', kind)
        self.write(index, 1, 'I', cob_id)


class Axis:
    """An axis, numbered from 0: its frames, and what the master has seen of it."""

    def __init__(self, node, number):
        self.node, self.number = node, number
        self.object = 0x800 * number
        self.place = node.node + number  # in the ranges of COB-IDs
        self.start = 0
        self.answers = 0  # TPDOs that came with SYNC
        self.error = self.distance = 0  # the largest ones, position units
        self.near = 0  # answers in a row, the last one among them, that were near the set-point
        self.losses = 0  # how often bit 12 of 6041h fell
        self.statusword = 0

    def configure(self, period_ms):
        self.node.write(0x60C2 + self.object, 1, 'B', period_ms)
        self.node.write(0x60C2 + self.object, 2, 'b', -3)
        pdo, high = 0x40 * self.number, self.object << 16
        self.node.map(0x1400 + pdo, 0x200 + self.place, 1, [0x60400010 + high, 0x607A0020 + high])
        self.node.map(0x1800 + pdo, 0x180 + self.place | NO_RTR, 0xFF, [0x60410010 + high])
        self.node.map(0x1801 + pdo, 0x280 + self.place | NO_RTR, 1, [0x60640020 + high, 0x60F40020 + high])
        for other in 0x1401, 0x1402, 0x1403:
            self.node.write(other + pdo, 1, 'I', INVALID | 0x100 + self.place)
        for other in 0x1802, 0x1803:
            self.node.write(other + pdo, 1, 'I', INVALID | NO_RTR | 0x100 + self.place)

    def enable(self):
        if self.node.read(0x6041 + self.object, 'H') & FAULT:
            self.node.write(0x6040 + self.object, 0, 'H', 0x80)
        self.node.write(0x6060 + self.object, 0, 'b', CYCLIC_POSITION)
        if (mode := self.node.read(0x6061 + self.object, 'b')) != CYCLIC_POSITION:
            raise Failed(f'axis {self.number + 1}: mode {mode}')
        for controlword, state in (SHUTDOWN, 0x21), (SWITCH_ON, 0x23), (ENABLE, 0x27):
            self.node.write(0x6040 + self.object, 0, 'H', controlword)
            if (word := self.node.read(0x6041 + self.object, 'H')) & 0x6F != state:
                raise Failed(f'axis {self.number + 1}: {controlword:04X}h led to {word:04X}h')
        self.start = self.node.read(0x6062 + self.object, 'i')

    def frames(self, table, controlword=ENABLE):
        """RPDOs for each place of the table."""
        return [FRAME.pack(0x200 + self.place, 6, COMMAND.pack(controlword, self.start + place)) for place in table]

    def take_answer(self, data, set_point):
        """6064h and 60F4h at a SYNC; @p set_point was that of the SYNC before, where the demand then is."""
        position, error = ANSWER.unpack(data)
        self.answers += 1
        self.error = max(self.error, abs(error))
        distance = abs(position - self.start - set_point)
        self.distance = max(self.distance, distance)
        self.near = self.near + 1 if distance <= NEAR else 0

    def take_statusword(self, data):
        word, = struct.unpack_from('<H', data)
        self.losses += bool(self.statusword & ~word & FOLLOWS)
        self.statusword = word
        if word & FAULT:
            raise Failed(f'axis {self.number + 1}: fault, 6041h is {word:04X}h')


def places(motion, way, steps):
    """Position units at each step of a motion by @p way and back, @p steps each."""
    def trapezoid(share):  # a third each for acceleration, constant speed and deceleration
        if share < 1 / 3:
            return 9 / 4 * share * share
        return 1 - trapezoid(1 - share) if share > 2 / 3 else 1 / 4 + 3 / 2 * (share - 1 / 3)

    shape = trapezoid if motion == 'trapezoid' else lambda share: math.sin(math.pi / 2 * share) ** 2
    there = [round(way * shape(step / steps)) for step in range(steps)]
    return there + [round(way * shape(1 - step / steps)) for step in range(steps)]


class Cycle:
    """Set-points and SYNC at absolute times, and what comes back."""

    def __init__(self, node, axes, period):
        self.node, self.axes, self.period = node, axes, period
        self.by_identifier = {0x280 + axis.place: axis for axis in axes}
        self.of_statusword = {0x180 + axis.place: axis for axis in axes}
        self.set_points = [0]  # of each SYNC; before the first one the axis held its start
        self.skipped, self.latest = 0, 0.0  # periods without SYNC; s, the longest that one was late
        self.due = None  # when the next SYNC is
        self.resting = self.frames([0] * REST)  # made now: later there is no time
        self.halting = self.frames([0], ENABLE | HALT)
        self.ending = self.frames([0], SHUTDOWN)

    def frames(self, table, controlword=ENABLE):
        """RPDOs of all axes for each place of the table."""
        return list(zip(*(axis.frames(table, controlword) for axis in self.axes)))

    @property
    def syncs(self):
        return len(self.set_points) - 1

    def receive(self):
        """Takes what has arrived."""
        try:
            while True:
                identifier, _, data = FRAME.unpack(self.node.socket.recv(FRAME.size, socket.MSG_DONTWAIT))
                if (axis := self.by_identifier.get(identifier)) is not None:
                    axis.take_answer(data, self.set_points[axis.answers])
                elif (axis := self.of_statusword.get(identifier)) is not None:
                    axis.take_statusword(data)
                elif identifier == 0x80 + self.node.node and data[:2] != b'\0\0':
                    raise Failed(f'EMCY {data[1]:02X}{data[0]:02X}h')
        except BlockingIOError:
            pass

    def wait_for_answers(self):
        """Where the unit or the master has stood still, until the answers are no longer far behind."""
        end = time.monotonic() + PATIENCE
        while self.syncs - min(axis.answers for axis in self.axes) > BEHIND:
            if time.monotonic() > end:
                raise Failed(f'{BEHIND} SYNCs have no answer')
            self.receive()

    def wait_until(self, due):
        time.sleep(max(0, due - SPIN - time.monotonic()))
        while (now := time.monotonic()) < due:
            pass
        return now

    def run(self, frames, table, rounds=1):
        """All rounds through the table; @p frames has the RPDOs of all axes for each place."""
        send = self.node.socket.send
        due = self.due or time.monotonic() + 10 * self.period
        for _ in range(rounds):
            for place, frames_of_place in zip(table, frames):
                for frame in frames_of_place:
                    send(frame)
                now = self.wait_until(due)
                send(SYNC)
                self.set_points.append(place)
                self.latest = max(self.latest, now - due)
                if (lost := int((now - due) / self.period)) > 0:
                    self.skipped += lost
                    due += lost * self.period
                due += self.period
                self.receive()
                self.wait_for_answers()
        self.due = due

    def settle(self):
        """The first place of the way until all axes stand there: one that overshoots only passes."""
        end = time.monotonic() + PATIENCE
        self.run(self.resting, [0] * REST)
        while any(axis.near < REST for axis in self.axes):
            if time.monotonic() > end:
                raise Failed('not all axes are back')
            self.run(self.resting, [0] * REST)

    def finish(self):
        """Until the last answers have come."""
        end = time.monotonic() + PATIENCE
        while any(axis.answers < self.syncs for axis in self.axes) and time.monotonic() < end:
            self.receive()
            time.sleep(0.001)


def processor_time(pid):
    with open(f'/proc/{pid}/stat', encoding='ascii') as file:
        fields = file.read().rsplit(')', 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf('SC_CLK_TCK')


def report(cycle, seconds, pid, used):
    print(f'{cycle.syncs} SYNCs to {len(cycle.axes)} axes in {seconds:.2f} s; {cycle.skipped} periods without one, '
          f'the latest was {cycle.latest * 1000:.2f} ms late')
    print(f'largest following error (60F4h): {max(axis.error for axis in cycle.axes)} position units, '
          f'distance of 6064h from its set-point: {max(axis.distance for axis in cycle.axes)}')
    print(f'answers that did not come: {sum(cycle.syncs - axis.answers for axis in cycle.axes)}; '
          f'set-points missed (bit 12 fell): {sum(axis.losses for axis in cycle.axes)} times')
    if pid:
        print(f'axisd took {100 * used / seconds:.0f} % of a core')


def arguments():
    parser = argparse.ArgumentParser()
    for name, default, what in (('--channel', 'vcan0', None), ('--node', 5, None), ('--axes', 1, None), ('--seconds', 10.0, None),
                                ('--period', 1, 'ms'), ('--way', 5.0, 'revolutions'), ('--time', 1.0, 's for the way')):
        parser.add_argument(name, type=type(default), default=default, help=what)
    parser.add_argument('--motion', choices=('sin2', 'trapezoid'), default='sin2')
    parser.add_argument('--pid', type=int, help='of axisd, to tell what processor time it takes')
    return parser.parse_args()


def follow(node, options):
    axes = [Axis(node, number) for number in range(options.axes)]
    node.nmt(0x80)
    for axis in axes:
        axis.configure(options.period)
    node.nmt(0x01)
    for axis in axes:
        axis.enable()
    period = options.period / 1000
    table = places(options.motion, options.way * REVOLUTION, round(options.time / period))
    rounds = max(1, round(options.seconds / period / len(table)))
    cycle = Cycle(node, axes, period)
    frames = cycle.frames(table)
    gc.disable()  # it would stop the master for some ms
    began, used = time.monotonic(), options.pid and processor_time(options.pid)
    try:
        cycle.run(frames, table, rounds)
        cycle.settle()
        cycle.run(cycle.halting, [0])  # with halt no set-point is missed any more
        seconds, used = time.monotonic() - began, options.pid and processor_time(options.pid) - used
        cycle.run(cycle.ending, [0])
        cycle.finish()
    except Failed:
        report(cycle, time.monotonic() - began, None, None)
        raise
    for axis in axes:
        axis.losses -= 1  # the halt
    report(cycle, seconds, options.pid, used)


def main():
    options = arguments()
    with can.Bus(options.channel, interface='socketcan', ignore_rx_error_frames=True) as bus:
        try:
            follow(Node(bus, options.node), options)
        except Failed as failure:
            sys.exit(f'csp.py: {failure.args[0]}')


main()
