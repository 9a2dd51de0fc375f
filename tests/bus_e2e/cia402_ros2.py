"""What the CiA 402 driver of ros2_canopen does with a bus.yml, without it, before axisd:
cia402_ros2.py BIN-FOLDER EDS BUS.YML [AXISD.JSON]

Writes what the file configures, as dcfgen orders it, and then goes through the services of each axis: init (fault reset, enable,
homing, no mode), position_mode, cyclic_position_mode, velocity_mode, interpolated_position_mode, halt, shutdown. AXISD.JSON is
the configuration of several nodes.
"""

import json
import os
import sys
import time

import cia402_unit as unit
import programs
from bus_file import configure, slaves_of
from cia402_process_image import ProcessImage
from cia402_unit import (ACKNOWLEDGED, ATTAINED, AXIS_STEP, CYCLIC_POSITION, DISABLED, ENABLE, ENABLED, ERROR, HALT, HOMING,
                         IMMEDIATELY, NO_MODE, PROFILE_POSITION, PROFILE_VELOCITY, REACHED, READY, RESET, SHUTDOWN, START,
                         SWITCH_ON, SWITCHED_ON, Cia402Master, Watched, can)

PERIOD = 0.01  # s, of SYNC and of the driver
PATIENCE = 2 * programs.PATIENCE
INTERPOLATED = 7
QUICK_STOP = 0x02
RADIAN = 65536 / 6.283185307179586
RAMP = 40  # periods
NEAR = RADIAN / 50


class Axis:
    """One axis of the driver: its controlword, and the mode that it writes in each period."""

    def __init__(self, image, channel=0):
        self.image = image
        self.offset = AXIS_STEP * channel
        self.controlword = 0
        self.mode = NO_MODE
        self.target = self.last = None
        self.homes = False
        self.resets = True

    def read(self, index):
        return self.image.get(index + self.offset)

    def set(self, index, value):
        """By RPDO where it is mapped, else by SDO."""
        if self.image.is_sent(index + self.offset):
            self.image.set(index + self.offset, value)
        else:
            sub_index = 1 if index == 0x60C1 else 0
            self.image.master.put(index + self.offset, value, sub_index)

    def is_in(self, state):
        word = self.read(0x6041)
        return word is not None and unit.is_in(state, word)

    def command(self):
        """Bits of the controlword by the mode; None: there is no target, which means halt."""
        if self.mode == HOMING:
            return START if self.homes else None
        if self.mode == NO_MODE or self.target is None:
            return None
        if self.mode == PROFILE_POSITION:
            if not self.read(0x6041) & ACKNOWLEDGED:
                is_new = self.target != self.last
                if is_new:
                    self.set(0x607A, round(self.target))
                    self.last = self.target
                return IMMEDIATELY | (START if is_new else self.controlword & START)
            return IMMEDIATELY
        index = {PROFILE_VELOCITY: 0x60FF, INTERPOLATED: 0x60C1, CYCLIC_POSITION: 0x607A}[self.mode]
        self.set(index, round(self.target))
        return START if self.mode == INTERPOLATED else 0

    def write(self):
        self.controlword |= HALT
        if self.is_in(ENABLED):
            bits = self.command() if self.read(0x6061) == self.mode else None
            self.controlword = self.controlword & ~0x270 | (bits or 0)
            if bits is not None:
                self.controlword &= ~HALT
        self.set(0x6040, self.controlword & ~RESET if self.resets else self.controlword)
        self.resets = False


class Driver:
    """All axes of a bus, and SYNC."""

    def __init__(self, bus, axes):
        self.bus = bus
        self.axes = axes
        self.due = time.monotonic()

    def cycle(self):
        self.bus.send(can.Message(arbitration_id=unit.SYNC, is_extended_id=False))
        self.due = max(self.due, time.monotonic() - PERIOD) + PERIOD
        while (left := self.due - time.monotonic()) > 0:
            self.bus.recv(left)
        while self.bus.recv(0) is not None:
            pass
        for axis in self.axes:
            axis.write()

    def until(self, holds, what):
        """Periods until it holds of every axis."""
        deadline = time.monotonic() + PATIENCE
        while not all(holds(axis) for axis in self.axes):
            assert time.monotonic() < deadline, (what, [f'{axis.read(0x6041) or 0:04X}h' for axis in self.axes],
                                                 [axis.read(0x6064) for axis in self.axes])
            self.cycle()

    def each(self, action):
        for axis in self.axes:
            action(axis)

    def to_enabled(self):
        commands = ((lambda axis: axis.is_in(DISABLED), SHUTDOWN), (lambda axis: axis.is_in(READY), SWITCH_ON),
                    (lambda axis: axis.is_in(SWITCHED_ON), ENABLE), (lambda axis: (axis.read(0x6041) or 0) & 0x4F == 8, RESET))

        def lead(axis):
            for holds, command in commands:
                if axis.read(0x6041) is not None and holds(axis):
                    axis.controlword = axis.controlword & ~0x8F | command
            return axis.is_in(ENABLED)

        self.until(lead, 'Operation enabled')

    def switch_mode(self, mode):
        """The driver forgets the target of the former mode, so that it halts."""
        def select(axis):
            axis.mode, axis.target, axis.last, axis.homes = mode, None, None, False
            axis.set(0x6060, mode)

        self.each(select)
        self.until(lambda axis: axis.read(0x6061) == mode, f'mode {mode}')

    def stay(self):
        """With the halt set nothing may move, whatever 607Ah has."""
        for _ in range(10):
            self.cycle()
        before = [axis.read(0x6064) for axis in self.axes]
        assert all(axis.controlword & HALT for axis in self.axes)
        for _ in range(20):
            self.cycle()
        after = [axis.read(0x6064) for axis in self.axes]
        assert all(abs(new - old) < NEAR for new, old in zip(after, before)), (before, after)


def init(driver):
    driver.each(lambda axis: setattr(axis, 'controlword', 0) or setattr(axis, 'resets', True))
    driver.to_enabled()
    modes = {axis.image.master.get(0x6502, axis=1 + axis.offset // AXIS_STEP) for axis in driver.axes}
    assert modes == {0x3EF}, modes
    driver.switch_mode(HOMING)
    driver.until(lambda axis: axis.read(0x6041) & (ERROR | REACHED), 'bit 10 before homing')

    def start(axis):
        assert axis.image.master.get(0x6098, axis=1 + axis.offset // AXIS_STEP) != 0
        assert not axis.read(0x6041) & ERROR
        axis.homes = True

    def is_over(axis):
        assert not axis.read(0x6041) & ERROR, 'error of homing'
        return axis.read(0x6041) & ATTAINED and axis.read(0x6041) & REACHED

    driver.each(start)
    driver.until(lambda axis: axis.read(0x6041) & (ERROR | ATTAINED | REACHED) != REACHED, 'start of homing')
    driver.until(is_over, 'end of homing')
    driver.switch_mode(NO_MODE)
    driver.stay()


def positions(driver):
    driver.switch_mode(PROFILE_POSITION)
    driver.stay()
    for radians in 6, -3:
        driver.each(lambda axis: setattr(axis, 'target', radians * RADIAN))
        driver.until(lambda axis: abs(axis.read(0x6064) - axis.target) < NEAR and axis.read(0x6041) & REACHED, 'target')
    # A target on the way replaces the one that runs, for bit 5 is always set.
    driver.each(lambda axis: setattr(axis, 'target', 20 * RADIAN))
    driver.until(lambda axis: axis.read(0x6064) > 3 * RADIAN, 'motion')
    driver.each(lambda axis: setattr(axis, 'target', 2 * RADIAN))
    driver.until(lambda axis: abs(axis.read(0x6064) - axis.target) < NEAR and axis.read(0x6041) & REACHED, 'new target')


def follow(driver, mode):
    """A controller that begins where the axis stands, as those of ros2_control do, and moves on by a radian."""
    driver.switch_mode(mode)
    driver.stay()
    starts = [axis.read(0x6064) for axis in driver.axes]
    for step in range(RAMP + 1):
        for axis, start in zip(driver.axes, starts):
            axis.target = start + RADIAN * step / RAMP
        driver.cycle()
    driver.until(lambda axis: abs(axis.read(0x6064) - axis.target) < NEAR and axis.read(0x6041) & ACKNOWLEDGED, 'set-point')


def velocities(driver):
    driver.switch_mode(PROFILE_VELOCITY)
    driver.stay()
    for speed in 20 * RADIAN, 0:
        driver.each(lambda axis: setattr(axis, 'target', speed))
        driver.until(lambda axis: abs(axis.read(0x606C) - axis.target) < RADIAN and axis.read(0x6041) & REACHED, 'speed')


def halt_and_shutdown(driver):
    """halt is a quick stop, which ends in Switch on disabled (605Ah = 2); recover enables again; shutdown leaves no mode."""
    driver.each(lambda axis: setattr(axis, 'controlword', axis.controlword & ~0x8F | QUICK_STOP))
    driver.until(lambda axis: axis.is_in(DISABLED), 'the end of the quick stop')
    driver.to_enabled()
    driver.switch_mode(NO_MODE)
    driver.each(lambda axis: setattr(axis, 'controlword', axis.controlword & ~0x8F))
    driver.until(lambda axis: axis.is_in(DISABLED), 'Switch on disabled')


def go_through(bus, masters, slaves):
    count = 0
    axes = []
    for master, slave in zip(masters, slaves):
        count += configure(master, master.eds, slave)
        master.operational()
        image = ProcessImage(master, slave)
        axes += [Axis(image, channel) for channel in range(slave.get('num_channels', 1))]
    print(f'{count} SDO writes taken, {len(axes)} axes')
    driver = Driver(bus, axes)
    for name, action in (('init', init), ('position_mode', positions),
                         ('cyclic_position_mode', lambda driver: follow(driver, CYCLIC_POSITION)),
                         ('velocity_mode', velocities),
                         ('interpolated_position_mode', lambda driver: follow(driver, INTERPOLATED)),
                         ('halt, recover, shutdown', halt_and_shutdown)):
        action(driver)
        print(name, *(f'{axis.read(0x6064) / RADIAN:.2f}' for axis in axes))


def main():
    bin_folder, eds_path, bus_path, *configuration = sys.argv[1:]
    slaves = list(slaves_of(bus_path).values())
    with programs.Folder(bin_folder) as folder, can.Bus('vcan0', interface='socketcan') as raw:
        bus = Watched(raw)
        if configuration:
            with open(configuration[0], encoding='ascii') as file:
                text = file.read().replace('vcan0', f'unix:{os.environ["CAN_BUS"]}')
            with open(folder.path('axisd.json'), 'w', encoding='ascii') as file:
                file.write(json.dumps(json.loads(text)))
            daemon = folder.start('axisd', '--config', folder.path('axisd.json'), '--state-directory', folder.path('state'))
            for slave in slaves:
                daemon.expect(f'ready: node {slave["node_id"]} on')
        else:
            daemon = unit.start_unit(folder, [{}] * slaves[0].get('num_channels', 1))
        go_through(bus, [Cia402Master(bus, eds_path, slave['node_id']) for slave in slaves], slaves)
        assert daemon.end() == 0


main()
