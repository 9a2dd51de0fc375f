"""Mistakes with a drive of CiA 402."""

from .mistake import NODE, breaks


@breaks('drive.step-skipped', 'cia402')
def enables_at_once(bus):
    bus.status_until(NODE, 0x4F, 0x40)
    bus.write(NODE, 0x6040, 0, 0x0F, 2)


@breaks('drive.too-fast', 'cia402')
def does_not_look_at_the_statusword(bus):
    bus.status_until(NODE, 0x4F, 0x40)
    for word in (0x06, 0x07):
        bus.write(NODE, 0x6040, 0, word, 2)
        bus.wait(0.1)


@breaks('drive.mode-unread', 'cia402')
def does_not_look_at_the_mode(bus):
    bus.write(NODE, 0x6060, 0, 3, 1)
    bus.enable(NODE)
    bus.write(NODE, 0x6040, 0, 0x06, 2)


@breaks('drive.set-point-handshake', 'cia402')
def gives_a_position_before_the_last_one_was_taken(bus):
    bus.write(NODE, 0x6060, 0, 1, 1)
    bus.read(NODE, 0x6061)
    bus.enable(NODE)
    bus.write(NODE, 0x607A, 0, 100000, 4)
    bus.write(NODE, 0x6040, 0, 0x1F, 2)
    bus.status_until(NODE, 0x1000, 0x1000)
    bus.write(NODE, 0x6040, 0, 0x0F, 2)
    bus.write(NODE, 0x607A, 0, 200000, 4)
    bus.write(NODE, 0x6040, 0, 0x1F, 2)
    bus.wait(0.1)


@breaks('drive.mode-unsupported', 'cia402')
def chooses_a_mode_that_is_not_there(bus):
    bus.read(NODE, 0x6502)
    bus.try_to_write(NODE, 0x6060, 0, 5, 1)


@breaks('drive.two-sources', 'cia402')
def commands_over_two_ways(bus):
    bus.map(NODE, 1, [(0x6040, 0, 16)], is_receive=True)
    bus.start(NODE)
    bus.send(0x205, '0000')
    bus.wait(0.05)
    bus.write(NODE, 0x6040, 0, 0, 2)


@breaks('drive.halt', 'cia402')
def gives_set_points_to_a_halted_drive(bus):
    bus.write(NODE, 0x6060, 0, 3, 1)
    bus.read(NODE, 0x6061)
    bus.enable(NODE)
    bus.write(NODE, 0x6040, 0, 0x010F, 2)
    for speed in range(100, 700, 100):
        bus.write(NODE, 0x60FF, 0, speed, 4)
        bus.read(NODE, 0x6041)
