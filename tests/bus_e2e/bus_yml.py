"""A bus.yml of lely-core or ros2_canopen against axisd, without these: bus_yml.py BIN-FOLDER EDS BUS.YML

Writes to the unit, in the order of lely's dcfgen, what the file configures, and then does what the CiA 402 driver of
ros2_canopen does. It shows that the unit takes the file, not that the tools do.
"""

import math
import struct
import sys
import time

import programs
from eds_file import Eds
from master import NODE, Abort, Master, can

try:
    import yaml
except ImportError as missing:
    sys.exit(f'{missing}: install python3-yaml (scripts/setup.sh)')

INVALID = 0x80000000
RPDO, TPDO = 0x1400, 0x1800
PERIOD = 0.01  # s
NO_OBJECT = 0x06020000
TARGET = 10.0  # rad/s
HELD = 20  # frames in which a position would have passed TARGET
PROFILE_VELOCITY = 3
HALT = 0x0100  # the driver sets it until it has a target
STATES = ((0x06, 0x21), (0x07, 0x23), (0x0F, 0x27))


def slave_of(bus):
    """The only slave of a bus.yml of either form."""
    nodes = bus.get('nodes') or {name: node for name, node in bus.items() if name not in ('master', 'options')}
    (slave,) = nodes.values()
    return slave


def auto_cob_id(communication, number):
    return (0x180 if communication == TPDO else 0x200) + 0x100 * (number - 1) + NODE


def mapping_writes(eds, index, mapping):
    assert len(mapping) <= 4, f'{index:04X}h: the unit takes four entries, not {len(mapping)}'
    yield index, 0, 0
    bits = 0
    for number, entry in enumerate(mapping, 1):
        mapped = entry['index'], entry['sub_index']
        assert eds.is_mappable(*mapped), f'{mapped[0]:04X}h:{mapped[1]:02X} cannot be mapped'
        bits += eds.bits(*mapped)
        yield index, number, mapped[0] << 16 | mapped[1] << 8 | eds.bits(*mapped)
    assert bits <= 64, f'{index:04X}h: {bits} bits'
    yield index, 0, len(mapping)


def pdo_writes(eds, communication, number, pdo):
    """(index, sub-index, value) of one PDO, as dcfgen orders them."""
    index = communication + number - 1
    assert pdo.get('cob_id', 'auto') == 'auto'
    cob_id = auto_cob_id(communication, number)
    yield index, 1, cob_id | INVALID
    if 'transmission' in pdo and pdo['transmission'] != eds.default(index, 2):
        yield index, 2, pdo['transmission']
    if 'mapping' in pdo:
        yield from mapping_writes(eds, index + 0x200, pdo['mapping'])
    if pdo['enabled']:
        yield index, 1, cob_id


def writes_of(eds, slave):
    yield 0x1017, 0, slave['heartbeat_producer']
    for key, communication in (('rpdo', RPDO), ('tpdo', TPDO)):
        for number, pdo in slave[key].items():
            yield from pdo_writes(eds, communication, number, pdo)
    for entry in slave.get('sdo', []):
        yield entry['index'], entry['sub_index'], entry['value']


def configure(master, eds, slave):
    count = 0
    for index, sub_index, value in writes_of(eds, slave):
        try:
            master.write(index, sub_index, eds.packed(index, sub_index, value))
        except Abort as abort:
            raise AssertionError(f'{index:04X}h:{sub_index:02X} = {value:X}h: {abort.args[0]:08X}h') from abort
        count += 1
    return count


def command(master, controlword, mode):
    master.send(0x200 + NODE, struct.pack('<Hb', controlword, mode).hex())


def wait_for_state(master, state):
    return master.receive(0x180 + NODE, lambda data: struct.unpack('<Hb', data)[0] & 0x6F == state)


def wait_for_speed(master, from_device):
    """Waits until the speed stays at TARGET; the speed in rad/s."""
    deadline = time.monotonic() + programs.PATIENCE
    near = 0
    while near < HELD:
        assert time.monotonic() < deadline, 'TPDO 2 does not show the speed'
        speed = struct.unpack('<i', master.receive(0x280 + NODE))[0] * from_device
        near = near + 1 if math.isclose(speed, TARGET, rel_tol=0.01) else 0
    return speed


def turn(master, to_device, from_device):
    """What the CiA 402 driver does for init, velocity_mode and target."""
    modes = struct.unpack('<I', master.upload(0x6502))[0]
    assert modes >> (PROFILE_VELOCITY - 1) & 1, f'{modes:X}h'
    for controlword, state in STATES:
        command(master, controlword | HALT, 0)
        wait_for_state(master, state)
    command(master, 0x0F | HALT, PROFILE_VELOCITY)
    master.receive(0x180 + NODE, lambda data: data[2] == PROFILE_VELOCITY)
    master.send(0x300 + NODE, struct.pack('<i', int(TARGET * to_device)).hex())
    command(master, 0x0F, PROFILE_VELOCITY)
    speed = wait_for_speed(master, from_device)
    command(master, 0x06 | HALT, PROFILE_VELOCITY)
    wait_for_state(master, 0x21)
    return speed


def position_is_missing(master):
    try:
        master.upload(0x6064)
    except Abort as abort:
        return abort.args[0] == NO_OBJECT
    return False


def main():
    bin_folder, eds_path, bus_path = sys.argv[1:]
    with open(bus_path, encoding='ascii') as file:
        slave = slave_of(yaml.safe_load(file))
    assert slave['node_id'] == NODE
    per_radian = 4194304 / (2 * math.pi)
    to_device = slave.get('scale_vel_to_dev', per_radian)
    from_device = slave.get('scale_vel_from_dev', 1 / per_radian)
    assert math.isclose(to_device, per_radian, rel_tol=1e-6) and math.isclose(to_device * from_device, 1, rel_tol=1e-6)
    with programs.Folder(bin_folder) as folder, can.Bus('vcan0', interface='socketcan') as bus:
        unit = programs.start_unit(folder)
        master = Master(bus)
        count = configure(master, Eds(eds_path, NODE), slave)
        assert position_is_missing(master)
        master.send(0x000, f'01{NODE:02x}')
        sync = bus.send_periodic(can.Message(arbitration_id=0x080, is_extended_id=False), PERIOD)
        velocity = turn(master, to_device, from_device)
        sync.stop()
        assert unit.end() == 0
    print(f'{count} SDO writes taken, {velocity:.2f} rad/s reached')


main()
