"""A bus.yml of lely-core or ros2_canopen against axisd, without these: bus_yml.py BIN-FOLDER EDS BUS.YML

Writes to the unit, in the order of lely's dcfgen, what the file configures, and then does what the CiA 402 driver of
ros2_canopen does. It shows that the unit takes the file, not that the tools do.
"""

import math
import struct
import sys
import time

import programs
from bus_file import configure, slaves_of
from eds_file import Eds
from master import NODE, Abort, Master, can

PERIOD = 0.01  # s
NO_OBJECT = 0x06020000
TARGET = 10.0  # rad/s
HELD = 20  # frames in which a position would have passed TARGET
PROFILE_VELOCITY = 3
HALT = 0x0100  # the driver sets it until it has a target
STATES = ((0x06, 0x21), (0x07, 0x23), (0x0F, 0x27))


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
    (slave,) = slaves_of(bus_path).values()
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
