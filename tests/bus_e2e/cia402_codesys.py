"""What the generic CiA 402 axis of CODESYS SoftMotion asks for and exchanges, without it, before axisd:
cia402_codesys.py BIN-FOLDER EDS-OF-TWO-AXES

All objects of both axes in synchronous PDOs, each period of 4 ms: mc_power, then set-points of mode 8 that follow a ramp. The
unit does not count missing set-points, for a machine may stand still for longer than three periods.
"""

import struct
import sys
import time

import cia402_unit as unit
import programs
from bus_file import configure
from cia402_process_image import ProcessImage
from cia402_unit import (AXIS_STEP, CYCLIC_POSITION, DISABLED, ENABLE, ENABLED, FOLLOWS, READY, REVOLUTION, SHUTDOWN, SWITCH_ON,
                         SWITCHED_ON, SYNC)

PERIOD = 0.004
AXES = 2
PDO_STEP = 0x40  # between the PDOs of two axes
RPDOS = (0x6040, 0x6060, 0x607A), (0x60FF, 0x6071, 0x60B8), (0x60B1, 0x60B2)
TPDOS = ((0x6041, 0x6061, 0x6064), (0x6062, 0x60F4), (0x606C, 0x6077, 0x603F), (0x606B, 0x6074, 0x60B9), (0x60BA, 0x60BB),
         (0x60BC, 0x60BD), (0x6078,))
RAMP = 250  # periods for a revolution


def pdos(kind, cob_id):
    """PDOs of both axes by number, in the form of a bus.yml."""
    result = {}
    for axis in range(AXES):
        for number, objects in enumerate(kind):
            result[1 + PDO_STEP * axis + number] = {
                'enabled': True, 'cob_id': cob_id + 16 * axis + number, 'transmission': 1,
                'mapping': [{'index': index + AXIS_STEP * axis, 'sub_index': 0} for index in objects]}
    return result


SLAVE = {'rpdo': pdos(RPDOS, 0x220), 'tpdo': pdos(TPDOS, 0x1A0),
         'sdo': [{'index': 0x60C2 + AXIS_STEP * axis, 'sub_index': sub_index, 'value': value}
                 for axis in range(AXES) for sub_index, value in ((1, 4), (2, -3))]}


def look(master):
    """What the driver reads before it takes a device for its own."""
    assert master.get(0x1000) & 0xFFFF == 0x0192
    for axis in range(1, AXES + 1):
        assert master.get(0x67FF, axis=axis) & 0xFFFF == 0x0192
        assert master.get(0x6502, axis=axis) >> (CYCLIC_POSITION - 1) & 1
        assert master.get(0x605A, axis=axis) in range(9)
        assert master.get(0x6076, axis=axis) > 0
    assert [master.get(0x1018, sub_index) for sub_index in (1, 2)] == [0, 0x402]


class SoftMotion:
    """Both axes, a cycle after the other."""

    def __init__(self, master):
        self.master = master
        self.image = ProcessImage(master, SLAVE)
        self.due = time.monotonic()

    def cycle(self, *values):
        """Writes {index: value} of each axis, sends SYNC, and takes what comes with it."""
        for axis, written in enumerate(values):
            self.image.values.update({index + AXIS_STEP * axis: value for index, value in written.items()})
        for cob_id, entries in self.image.sent.items():
            data = b''.join(struct.pack(form, self.image.values[index]) for index, form in entries)
            self.master.send(cob_id, data.hex())
        self.master.send(SYNC, '')
        self.due = max(self.due, time.monotonic() - PERIOD) + PERIOD
        last = max(self.image.received)
        self.master.receive(last)
        while (left := self.due - time.monotonic()) > 0:
            self.master.bus.recv(left)

    def get(self, index, axis):
        return self.image.get(index + AXIS_STEP * axis)


def power(motion):
    """mc_power: the target is where the axis stands until it is enabled."""
    command = {DISABLED: SHUTDOWN, READY: SWITCH_ON, SWITCHED_ON: ENABLE, ENABLED: ENABLE}
    motion.cycle({}, {})
    controlwords = [0] * AXES
    deadline = time.monotonic() + programs.PATIENCE
    while not all(unit.is_in(ENABLED, motion.get(0x6041, axis)) and motion.get(0x6041, axis) & FOLLOWS for axis in range(AXES)):
        assert time.monotonic() < deadline, [f'{motion.get(0x6041, axis):04X}h' for axis in range(AXES)]
        for axis in range(AXES):
            controlwords[axis] = next(word for state, word in command.items() if unit.is_in(state, motion.get(0x6041, axis)))
        motion.cycle(*({0x6040: controlwords[axis], 0x6060: CYCLIC_POSITION, 0x607A: motion.get(0x6064, axis)}
                       for axis in range(AXES)))
    assert all(motion.get(0x6061, axis) == CYCLIC_POSITION for axis in range(AXES))


def move(motion):
    """The first axis a revolution forwards, the second one backwards; the largest following error."""
    starts = [motion.get(0x6062, axis) for axis in range(AXES)]
    ways = REVOLUTION, -REVOLUTION
    largest = 0
    for step in range(RAMP + 1):
        motion.cycle(*({0x607A: start + way * step // RAMP, 0x60B1: int(way / RAMP / PERIOD) if step < RAMP else 0}
                       for start, way in zip(starts, ways)))
        largest = max(largest, *(abs(motion.get(0x60F4, axis)) for axis in range(AXES)))
    deadline = time.monotonic() + programs.PATIENCE
    while any(motion.get(0x6062, axis) != starts[axis] + ways[axis] or abs(motion.get(0x60F4, axis)) > 64
              for axis in range(AXES)):
        assert time.monotonic() < deadline, [motion.get(0x6062, axis) for axis in range(AXES)]
        motion.cycle({}, {})
    for axis in range(AXES):
        assert motion.get(0x603F, axis) == 0
        assert abs(motion.get(0x6064, axis) - motion.get(0x6062, axis)) <= 64
    return largest


def course(master):
    look(master)
    count = configure(master, master.eds, SLAVE)
    master.operational()
    motion = SoftMotion(master)
    power(motion)
    largest = move(motion)
    print(f'{count} SDO writes taken; following error at most {largest} of {REVOLUTION} units')


unit.run(*sys.argv[1:], course, axes=[{}] * AXES, missed_setpoints=0)
