"""What every CANopen master may expect of a drive of CiA 402, before axisd: cia402_all.py BIN-FOLDER EDS

Boot-up and heartbeat, segmented SDO, refusals, mappings of eight objects and place holders; homing to a switch, a positioning,
and set-points of mode 8 with SYNC. The unit does not count missing set-points, for a machine may stand still for a while.
"""

import struct
import sys
import time

import cia402_unit as unit
import programs
from cia402_unit import (ATTAINED, CYCLIC_POSITION, ENABLE, ERROR, FOLLOWS, HEARTBEAT, HOMED, OPERATIONAL, PRE_OPERATIONAL,
                         PROFILE_POSITION, REACHED, REVOLUTION, RPDO, START, SYNC, TPDO)
from master import NODE

INVALID, NO_RTR = 0x80000000, 0x40000000
SET_POINT, DEMAND = 0x3E0, 0x1E0  # COB-IDs
READ_ONLY, NO_VALUE, NOT_MAPPABLE = 0x06010002, 0x06090030, 0x06040041
HOME_FROM, HOME_TO = 2, 4  # revolutions
BEHIND_THE_RISING_EDGE = 24  # method: home switch, from below
T = 0.1  # s, 60C2h; set-points come five times as often
SWITCHES = [{'role': 'home', 'from': HOME_FROM, 'to': HOME_TO}, {'role': 'negative', 'from': -1000, 'to': -10},
            {'role': 'positive', 'from': 20, 'to': 1000}]


def boot_up(master):
    """A reset of communication: one boot-up; then the heartbeat tells each state, Pre-operational in the end."""
    master.send(0x000, f'82{NODE:02x}')
    master.expect(HEARTBEAT + NODE, '00')
    master.put(0x1017, 50)
    for command, state in (0x01, OPERATIONAL), (0x80, PRE_OPERATIONAL):
        master.send(0x000, f'{command:02x}{NODE:02x}')
        master.receive(HEARTBEAT + NODE, lambda data, state=state: data[0] == state)
    master.put(0x1017, 0)


def objects(master):
    assert master.upload_segmented(0x1008) == b'axisd CiA 402 axis'
    for index, data in (0x6041, b'\0\0'), (0x1000, b'\0\0\0\0'), (0x6064, b'\0\0\0\0'), (0x6502, b'\0\0\0\0'):
        assert master.refused(index, 0, data) == READ_ONLY, f'{index:04X}h'
    for index, value in (0x6060, b'\x05'), (0x6098, b'\x0F'):
        assert master.refused(index, 0, value) == NO_VALUE, f'{index:04X}h'


def map_pdo(master, index, cob_id, entries, kind):
    master.put(index, cob_id | INVALID, 1)
    master.put(index + 0x200, 0, 0)
    for number, entry in enumerate(entries, 1):
        master.put(index + 0x200, entry, number)
    master.put(index + 0x200, len(entries), 0)
    master.put(index, kind, 2)
    master.put(index, cob_id, 1)


def mappings(master):
    """PDOs of eight bytes by eight entries, place holders among those that are received; and those of follow()."""
    map_pdo(master, 0x1405, SET_POINT, [0x607A0020], 1)
    map_pdo(master, 0x1805, DEMAND | NO_RTR, [0x60620020, 0x60F40020], 1)
    map_pdo(master, 0x1807, INVALID | NO_RTR, [0x60410010], 1)
    master.put(0x1A07, 0)
    assert master.refused(0x1A07, 1, struct.pack('<I', 0x00050008)) == NOT_MAPPABLE
    map_pdo(master, 0x1406, 0x3F0, [0x00050008, 0x00050008, 0x00060010, 0x00050008, 0x60980008, 0x00050008, 0x60600008], 0xFF)
    map_pdo(master, 0x1806, 0x1F0 | NO_RTR, [0x60610008, 0x10010008] * 4, 1)
    master.operational()
    master.send(0x3F0, '0102030405230601')
    assert (master.get(0x6098), master.get(0x6060), master.get(0x6061)) == (0x23, 1, 1)
    master.send(0x3F0, '0102030405220600')
    assert (master.get(0x6098), master.get(0x6060), master.get(0x6061)) == (0x22, 0, 0)
    master.send(SYNC, '')
    assert len(master.receive(0x1F0)) == 8


def home(master):
    seen = master.home(BEHIND_THE_RISING_EDGE)
    assert seen[0] == 0 and seen[-1] == ATTAINED | REACHED and set(seen) <= {0, ATTAINED, ATTAINED | REACHED}, seen
    assert master.get(0x6041) & HOMED
    assert 0 < master.get(0x6064) < REVOLUTION // 4  # it brakes behind the edge, which is 0


def position(master):
    master.put(0x6060, PROFILE_POSITION)
    master.put(0x6081, 20 * REVOLUTION)
    for target in 3 * REVOLUTION, -REVOLUTION:
        master.position(target)


def follow(master):
    """Set-points of a triangle with SYNC: the demand trails them, never before the newest, and ends on the last one."""
    master.put(0x60C2, 100, 1)
    master.put(0x60C2, -3, 2)
    master.put(0x6060, CYCLIC_POSITION)
    assert not master.get(0x6041) & FOLLOWS
    held = master.get(0x6062)

    def exchange(target):
        master.send(SET_POINT, struct.pack('<i', target).hex())
        master.send(SYNC, '')
        return struct.unpack('<ii', master.receive(DEMAND))

    assert exchange(held)[0] == held and master.get(0x6041) & FOLLOWS
    steps = [*range(50), *range(50, 0, -1)]
    due = time.monotonic()
    highest = held
    for step in steps:
        target = held + step * REVOLUTION // 25
        highest = max(highest, target)
        demand, error = exchange(target)
        assert held <= demand <= highest and abs(error) < REVOLUTION, (held, demand, highest, error)
        due = max(due, time.monotonic() - T / 5) + T / 5
        time.sleep(max(0, due - time.monotonic()))
    while exchange(held)[0] != held:
        time.sleep(T / 5)


def silent_statusword(master):
    """6041h alone in a TPDO is sent when it changes, and not else."""
    master.put(0x6060, PROFILE_POSITION)
    master.put(0x607A, REVOLUTION)
    words = []

    def take(patience):
        message = master.bus.recv(patience)
        if message is not None and message.arbitration_id == TPDO + NODE:
            words.append(struct.unpack('<H', message.data)[0])
        return message

    master.send(RPDO + NODE, f'{ENABLE | START:02x}00')
    master.send(RPDO + NODE, f'{ENABLE:02x}00')
    deadline = time.monotonic() + programs.PATIENCE
    while not (len(words) >= 3 and words[-1] & REACHED):
        assert time.monotonic() < deadline, [f'{word:04X}h' for word in words]
        take(0.1)
    while take(0.3):
        pass
    assert not any(word & ERROR for word in words)
    assert all(new != old for new, old in zip(words[1:], words)), [f'{word:04X}h' for word in words]


def course(master):
    for step in boot_up, objects, mappings:
        step(master)
    master.enable()
    for step in home, position, follow, silent_statusword:
        step(master)
        print(step.__name__)


unit.run(*sys.argv[1:], course, axes=[{'switches': SWITCHES}], missed_setpoints=0)
