"""What a lely-core master does with a bus.yml, without it, before axisd: cia402_lely.py BIN-FOLDER EDS BUS.YML

Finds the node by LSS, compares 1000h and 1018h with the EDS, writes what dcfgen makes of the file, keeps 1020h, and takes and
gives PDOs as they were configured.
"""

import struct
import sys
import time

import cia402_unit as unit
from bus_file import configure, slaves_of, writes_of
from cia402_process_image import ProcessImage
from cia402_unit import ENABLED, HEARTBEAT, HOMING, NO_MODE, OPERATIONAL, PRE_OPERATIONAL, STEPS
from master import NODE

LSS_REQUEST, LSS_ANSWER = 0x7E5, 0x7E4
LSS_TIME_OUT = 0.1  # s
WAITING = 0
SERIAL = 7
PROFILE_VELOCITY = 3


def lss(master, service, value=0, size=4, answer=None):
    """An LSS service; the value that its answer has."""
    master.send(LSS_REQUEST, (struct.pack('<B', service) + value.to_bytes(size, 'little')).ljust(8, b'\0').hex())
    if answer is None:
        return None
    data = master.receive(LSS_ANSWER)
    assert data[0] == answer and len(data) == 8, data.hex()
    return int.from_bytes(data[1:5], 'little')


def expect_silence(master, identifier):
    """As long as an LSS master waits."""
    deadline = time.monotonic() + LSS_TIME_OUT
    while (left := deadline - time.monotonic()) > 0:
        message = master.bus.recv(left)
        assert message is None or message.arbitration_id != identifier, message


def find_by_lss(master):
    """Switch selective by the identity, then what can be inquired."""
    identity = [master.get(0x1018, sub_index) for sub_index in (1, 2, 3, 4)]
    assert identity == [0, 0x402, 0x10000, SERIAL], identity
    for service, value in zip((0x40, 0x41, 0x42), identity):
        lss(master, service, value)
    lss(master, 0x43, identity[3], answer=0x44)
    assert [lss(master, service, answer=service) for service in (0x5A, 0x5B, 0x5C, 0x5D)] == identity
    assert lss(master, 0x5E, answer=0x5E) == NODE
    lss(master, 0x04, WAITING, 1)
    lss(master, 0x5E)
    expect_silence(master, LSS_ANSWER)
    for service, value in zip((0x46, 0x47, 0x48, 0x49, 0x4A), (*identity[:3], identity[2], identity[3])):
        lss(master, service, value)
    lss(master, 0x4B, identity[3], answer=0x4F)


def compare(master):
    """What the master compares with the EDS before it configures a node."""
    assert master.get(0x1000) == master.eds.default(0x1000)
    for sub_index in 1, 2, 3:
        assert master.get(0x1018, sub_index) == master.eds.default(0x1018, sub_index)


def keep_date(master, slave):
    """1020h stays until a stored object is written."""
    date = [9999, 1234]
    for sub_index, value in enumerate(date, 1):
        master.put(0x1020, value, sub_index)
    assert [master.get(0x1020, sub_index) for sub_index in (1, 2)] == date
    for index, sub_index, value in writes_of(master.eds, slave):
        read = master.get(index, sub_index) & 0x3FFFFFFF if sub_index == 1 and 0x1400 <= index < 0x1A00 else None
        assert read in (None, value & 0x3FFFFFFF), f'{index:04X}h:{sub_index:02X} is {read:X}h'
    master.put(0x6083, master.get(0x6083))
    assert [master.get(0x1020, sub_index) for sub_index in (1, 2)] == [0, 0]


def exchange(master, slave):
    """PDOs as configured: states and modes by RPDO and TPDO, the latter with SYNC."""
    image = ProcessImage(master, slave)

    def synchronize(index, holds, what):
        """SYNC until the TPDO says so, which it does with the first one."""
        master.send(unit.SYNC, '')
        master.get(0x1000)
        assert holds(image.get(index)), f'{what}: {image.get(index)}'

    synchronize(0x6041, lambda word: word is not None, 'TPDO')
    for controlword, state in STEPS:
        image.set(0x6040, controlword)
        synchronize(0x6041, lambda word, state=state: unit.is_in(state, word), f'state {state:02X}h')
    for mode in HOMING, PROFILE_VELOCITY, NO_MODE:
        image.set(0x6060, mode)
        synchronize(0x6061, lambda shown, mode=mode: shown == mode, f'mode {mode}')
    assert unit.is_in(ENABLED, image.get(0x6041))


def main():
    bin_folder, eds_path, bus_path = sys.argv[1:]
    (slave,) = slaves_of(bus_path).values()

    def course(master):
        find_by_lss(master)
        master.send(0x000, f'82{NODE:02x}')
        master.expect(HEARTBEAT + NODE, '00')
        compare(master)
        count = configure(master, master.eds, slave)
        master.receive(HEARTBEAT + NODE, lambda data: data[0] == PRE_OPERATIONAL)
        keep_date(master, slave)
        master.operational()
        master.receive(HEARTBEAT + NODE, lambda data: data[0] == OPERATIONAL)
        exchange(master, slave)
        print(f'{count} SDO writes taken')

    unit.run(bin_folder, eds_path, course, serial=SERIAL)


main()
