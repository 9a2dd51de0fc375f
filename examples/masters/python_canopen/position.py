"""References the axis of node 5 and positions it, as position.js: MDI, override, intermediate stop, traversing blocks,
reject. The unit has "positioner": true and "positioner_wiring": "mdi": position.py [EDS], with python-canopen"""

import pathlib
import queue
import sys
import time

import canopen

NODE = 5
AXIS = 2  # drive object
PATIENCE = 20  # s, for what has to come
GAP = 0.01  # s between two frames of one PDO: the unit takes one every 4 ms
EDS = pathlib.Path(__file__).parents[3] / 'eds/axisd.eds'

# 6040h
ENABLED, NO_REJECT, NO_STOP, START, REFERENCE = 0x043F, 1 << 4, 1 << 5, 1 << 6, 1 << 11
# 5800h (POS_STW1) and 5801h (POS_STW2)
ABSOLUTE, MDI, TRACKING = 1 << 8, 1 << 15, 1 << 0
# 6041h, 5810h (POS_ZSW1) and 5811h (POS_ZSW2)
STATE, REACHED, REFERENCED, ACCEPTED = 0x6F, 1 << 8, 1 << 14, 1 << 15
BLOCK, IN_BLOCKS = 0x3F, 1 << 13
TRAVERSING = 1 << 15
WINDOW = 40  # LU, p2544
FULL = 0x4000  # 100 %
RPM = 69905  # increments/s
VELOCITY = 6000  # 1000 LU/min

# Number, task, mode, position (LU), parameter of each traversing block: tasks 1 POSITIONING, 5 WAIT; bits 4 to 7 of the
# mode 0 END, 1 CONTINUE_WITH_STOP, 2 CONTINUE_FLYING, bits 8 to 11 0 ABSOLUTE, 1 RELATIVE.
BLOCKS = (1, 1, 0x020, 50000, 0), (2, 1, 0x010, 20000, 0), (3, 5, 0x010, 0, 200), (4, 1, 0x100, 10000, 0)


class Positioner:
    """The words of the axis, those that are sent as attributes."""

    def __init__(self, node):
        self.node = node
        self.control, self.setpoints, self.shares = (node.rpdo[i] for i in (1, 2, 3))
        states = node.tpdo[1], node.tpdo[2]
        for pdo in self.control, self.setpoints, self.shares, *states:
            pdo.read()
        self.received = queue.Queue()  # a frame that comes between two looks is not lost
        for pdo in states:
            pdo.add_callback(lambda pdo: self.received.put((pdo.cob_id, [entry.raw for entry in pdo.map])))
        self.places = {states[0].cob_id: ('statusword', 'block_state', 'motion_state', 'override_state'),
                       states[1].cob_id: ('position', 'velocity')}
        self.statusword = self.block_state = self.motion_state = self.override_state = self.position = self.velocity = 0
        self.words = {'controlword': 0, 'blocks': 0, 'mode': 0, 'override': FULL}

    def parameter(self, number, value, size, index=0):
        self.node.sdo.download(0x2000 + number, index, value.to_bytes(size, 'little', signed=True))

    def send(self, pdo, values):
        for entry, value in zip(pdo.map, values):
            entry.raw = value
        pdo.transmit()
        time.sleep(GAP)

    def command(self, **words):
        """Sends controlword, POS_STW1 (blocks), POS_STW2 (mode) and override, the given ones anew."""
        self.words.update(words)
        controlword, *free = self.words.values()
        self.send(self.control, [controlword, *((word ^ 0x8000) - 0x8000 for word in free)])  # INTEGER16

    def change(self, set=0, clear=0):
        self.command(controlword=self.words['controlword'] & ~clear | set)

    def until(self, holds, what):
        deadline = time.monotonic() + PATIENCE
        while not holds():
            try:
                cob_id, values = self.received.get(timeout=max(0, deadline - time.monotonic()))
            except queue.Empty:
                raise SystemExit(f'waited in vain for {what}; the axis is at {self.position}') from None
            self.__dict__.update(zip(self.places[cob_id], values))

    def expect(self, holds, what):
        if not holds:
            raise SystemExit(f'expected {what}; the axis is at {self.position}')

    def at(self, target):
        return abs(self.position - target) <= WINDOW

    def start(self):
        """A rising edge of START, until the unit has taken it."""
        self.change(set=START)
        self.until(lambda: self.statusword & ACCEPTED, 'bit 15 of 6041h')
        self.change(clear=START)
        self.until(lambda: not self.statusword & ACCEPTED, 'the end of bit 15 of 6041h')

    def move(self, target):
        self.send(self.setpoints, (target, VELOCITY))
        self.send(self.shares, (FULL, FULL))
        self.start()

    def reaches(self, target):
        self.until(lambda: self.statusword & REACHED and self.at(target), f'position {target}')

    def stop_short_of(self, target, way, stop):
        """Calls STOP when the axis is WAY off TARGET, and waits until it stands, which is before the target."""
        self.until(lambda: abs(self.position - target) < way, 'the motion')
        stop()
        self.until(lambda: abs(self.velocity) < RPM, 'standstill')
        self.expect(abs(self.position - target) > WINDOW, f'a stop before {target}')


def prepare(axis):
    axis.node.sdo.download(0x41B6, 0, AXIS.to_bytes(2, 'little'))  # p8630: parameters of the axis
    axis.parameter(2607, 0, 1)  # no reference cam: the next zero mark
    for i, (number, task, mode, position, value) in enumerate(BLOCKS):
        axis.parameter(2616, number, 2, i)
        axis.parameter(2617, position, 4, i)
        axis.parameter(2618, VELOCITY, 4, i)
        axis.parameter(2621, task, 2, i)
        axis.parameter(2622, value, 4, i)
        axis.parameter(2623, mode, 2, i)


def enable(axis):
    axis.node.nmt.state = 'OPERATIONAL'
    for controlword, state in (0x043E, 0x21), (ENABLED, 0x27):
        axis.command(controlword=controlword, mode=TRACKING)
        axis.until(lambda state=state: axis.statusword & STATE == state, f'state {state:02X}h')


def reference(axis):
    axis.change(set=REFERENCE)
    axis.until(lambda: axis.statusword & REFERENCED, 'bit 14 of 6041h')
    axis.change(clear=REFERENCE)
    print('referenced')


def mdi(axis):
    axis.command(blocks=MDI | ABSOLUTE)
    axis.move(100000)
    axis.reaches(100000)
    print('MDI: position 100000')

    axis.move(0)
    axis.stop_short_of(0, 80000, lambda: axis.command(override=0))
    axis.expect(axis.motion_state & TRAVERSING, 'the task to wait for its override')
    axis.command(override=FULL)
    axis.reaches(0)
    print('override 0 holds, 100 % goes on: position 0')

    axis.move(100000)
    axis.stop_short_of(100000, 80000, lambda: axis.change(clear=NO_STOP))
    axis.expect(axis.motion_state & TRAVERSING, 'the task to wait for the end of the stop')
    axis.change(set=NO_STOP)
    axis.reaches(100000)
    print('intermediate stop and on: position 100000')


def chain(axis):
    axis.command(blocks=BLOCKS[0][0])
    passed = []

    def is_over():
        number = axis.block_state & BLOCK
        if axis.block_state & IN_BLOCKS and number and number not in passed:
            passed.append(number)
        return not axis.motion_state & TRAVERSING and axis.statusword & REACHED and axis.at(30000)

    axis.start()
    axis.until(is_over, 'the end of the last block at position 30000')
    axis.expect(passed == [1, 2, 3, 4], f'blocks 1 to 4 and not {passed}')
    print('blocks 1 to 4: position 30000')


def reject(axis):
    axis.command(blocks=MDI | ABSOLUTE)
    axis.move(-100000)
    axis.stop_short_of(-100000, 120000, lambda: axis.change(clear=NO_REJECT))
    axis.until(lambda: not axis.motion_state & TRAVERSING, 'the end of the task')
    axis.change(set=NO_REJECT)
    print('reject: no task is left')


def main(eds):
    network = canopen.Network()
    node = network.add_node(NODE, eds)
    network.connect(channel='vcan0', interface='socketcan')
    try:
        node.sdo.RESPONSE_TIMEOUT = 1
        node.emcy.add_callback(lambda error: print(f'EMCY {error.code:04X}h', error.data.hex()))
        axis = Positioner(node)
        for step in prepare, enable, reference, mdi, chain, reject:
            step(axis)
        axis.command(controlword=0x0406)
        axis.until(lambda: axis.statusword & STATE == 0x21, 'OFF1')
    finally:
        network.disconnect()


main(sys.argv[1] if len(sys.argv) > 1 else str(EDS))
