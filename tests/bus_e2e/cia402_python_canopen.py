"""What canopen.profiles.p402 of python-canopen does, without it, before axisd: cia402_python_canopen.py BIN-FOLDER EDS

BaseNode402 takes 6041h from the TPDO that has it, and from SDO where it has to be sure; it waits 0.4 s for a state and 0.5 s
for a mode. Here the first answer behind a write has to show either, for a machine of others is slow.
"""

import sys
import time

import cia402_unit as unit
import programs
from cia402_unit import ACKNOWLEDGED, ATTAINED, DISABLED, ENABLED, ERROR, HOMING, NO_MODE, PROFILE_POSITION, REACHED, REVOLUTION
from master import NODE

INDEX_POSITIVE, PRESENT = 34, 35
TRANSITIONS = {0x40: 0x06, 0x21: 0x07, 0x23: 0x0F, 0x07: 0x00, 0x08: 0x80}  # state & 4Fh or 6Fh -> command that leads on
TPDO, RPDO = unit.TPDO + NODE, unit.RPDO + NODE
IN_PROGRESS, INTERRUPTED, HOMING_MASK = 0x0000, 0x0400, 0x3400


class Node402:
    """A node with 6041h in TPDO 1 and 6061h in TPDO 2, 6040h in RPDO 1 and 6040h, 6060h in RPDO 2: its first places."""

    def __init__(self, master):
        self.master = master

    def read_pdos(self):
        """pdo.read(): each PDO of the EDS, over SDO."""
        count = 0
        for communication in 0x1400, 0x1800:
            for number in range(512):
                if f'{communication + number:04X}' not in self.master.eds.sections:
                    continue
                self.master.get(communication + number, 1)
                self.master.get(communication + number, 2)
                entries = self.master.get(communication + number + 0x200, 0)
                for entry in range(1, entries + 1):
                    self.master.get(communication + number + 0x200, entry)
                count += 1
        return count

    def clear_targets(self):
        for index in 0x60FF, 0x607A, 0x6071:
            self.master.put(index, 0)

    @property
    def statusword(self):
        """The last one of TPDO 1, as state and is_faulted() see it."""
        while self.master.bus.recv(0) is not None:
            pass
        return int.from_bytes(self.master.bus.latest.get(TPDO, b'\0\0')[:2], 'little')

    @property
    def state(self):
        word = self.statusword
        return word & (0x6F if word & 0x20 else 0x4F)

    def check_statusword(self):
        """An event-driven TPDO does not count as new; SDO does."""
        return self.master.get(0x6041)

    def control(self, controlword):
        self.master.send(RPDO, controlword.to_bytes(2, 'little').hex())

    def select(self, mode):
        """op_mode: RPDO 2 has a controlword of its own, which is 0; the axis has to be enabled again."""
        supported = self.master.get(0x6502)
        assert mode == NO_MODE or supported >> (mode - 1) & 1, f'{supported:X}h'
        self.master.send(RPDO + 0x100, f'0000{mode:02x}')
        assert self.master.get(0x6061) == mode
        assert unit.is_in(DISABLED, self.check_statusword())
        while self.master.bus.latest[TPDO + 0x100][2] != mode:
            self.master.receive(TPDO + 0x100)

    def switch_to_enabled(self):
        """The setter of state: one command a state, and the next as soon as the TPDO tells it."""
        deadline = time.monotonic() + programs.PATIENCE
        while (state := self.state) != ENABLED:
            assert time.monotonic() < deadline, f'{state:02X}h'
            assert state in TRANSITIONS, f'no way on from {state:02X}h'
            self.control(TRANSITIONS[state])
            assert not self.check_statusword() & 0x08, 'fault'
            self.master.until(lambda now, former=state: now & 0x6F != former, f'a way on from {state:02X}h')

    def homing(self):
        """homing(): 001Fh, then 6041h & 3400h has to be one of three until it is over; the positions of the motor meanwhile."""
        self.select(HOMING)
        self.switch_to_enabled()
        self.control(0x1F)
        seen = set()
        deadline = time.monotonic() + 30 + programs.PATIENCE
        while (status := self.check_statusword() & HOMING_MASK) not in (ATTAINED, ATTAINED | REACHED):
            assert status == IN_PROGRESS, f'unable to home: {status:04X}h'
            assert time.monotonic() < deadline, 'unable to home, timeout reached'
            seen.add(self.master.get(0x606C))
        return seen


def set_up(node):
    """setup_402_state_machine() in Pre-operational, and the targets that it zeroes: nothing may move."""
    assert node.read_pdos() == 16
    before = node.master.get(0x6064)
    node.master.operational()
    node.clear_targets()
    node.switch_to_enabled()
    assert node.master.get(0x6061) == NO_MODE
    node.clear_targets()
    for _ in range(50):
        assert abs(node.master.get(0x6064) - before) < 10 and node.master.get(0x6062) == before


def home(node):
    master = node.master
    node.select(HOMING)
    assert node.check_statusword() & HOMING_MASK == INTERRUPTED  # is_homed(): not yet
    master.put(0x6099, REVOLUTION, 2)  # a revolution at most, until the index comes
    master.put(0x6098, INDEX_POSITIVE)
    assert max(node.homing()) > 0
    master.until(lambda now: now & HOMING_MASK == ATTAINED | REACHED, 'rest behind the index')
    node.control(0x0F)
    assert master.get(0x6041) & HOMING_MASK == ATTAINED | REACHED
    node.select(NO_MODE)
    node.select(HOMING)
    node.switch_to_enabled()
    assert node.check_statusword() & HOMING_MASK == ATTAINED | REACHED  # is_homed() after another mode
    master.put(0x6098, PRESENT)
    node.homing()
    assert abs(master.get(0x6064)) < REVOLUTION // 100
    node.control(0x0F)


def position(node):
    master = node.master
    node.select(PROFILE_POSITION)
    node.switch_to_enabled()
    master.put(0x6081, 20 * REVOLUTION)
    master.put(0x6083, 200 * REVOLUTION)
    master.put(0x6084, 200 * REVOLUTION)
    for target in 5 * REVOLUTION, -REVOLUTION:
        master.put(0x607A, target)
        node.control(0x1F)
        statusword = node.check_statusword()
        assert statusword & ACKNOWLEDGED and not statusword & (REACHED | ERROR), f'{statusword:04X}h'
        node.control(0x0F)
        assert not node.check_statusword() & ACKNOWLEDGED
        master.until(lambda now: now & REACHED, f'position {target}')
        assert abs(master.get(0x6064) - target) <= master.get(0x6067)


def reset(node):
    """reset_from_fault(): 0080h is an edge behind 0000h. The fault is that of a node taken out of Operational."""
    master = node.master
    master.bus.expected.add(0x8130)
    master.bus.expected.add(0x0000)
    master.send(0x000, '8005')
    master.until(lambda now: now & 0x4F == 0x08, 'the fault')
    master.operational()
    assert master.get(0x603F) == 0x8130, f'{master.get(0x603F):04X}h'
    node.control(0x00)
    assert node.check_statusword() & 0x4F == 0x08
    node.control(0x80)
    statusword = node.check_statusword()
    assert statusword & 0x4F == 0x40, f'{statusword:04X}h'
    node.switch_to_enabled()


def course(master):
    node = Node402(master)
    for step in set_up, home, position, reset:
        step(node)
        print(step.__name__)


if __name__ == '__main__':
    unit.run(*sys.argv[1:], course)
