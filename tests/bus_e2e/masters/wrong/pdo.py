"""Mistakes with PDOs and SYNC."""

from .mistake import NODE, breaks


# PDO

@breaks('pdo.mapping-while-valid')
def maps_what_is_in_use(bus):
    bus.read(NODE, 0x1400, 1)
    bus.try_to_write(NODE, 0x1600, 0, 0, 1)


@breaks('pdo.mapping-counted')
def maps_without_emptying(bus):
    bus.write(NODE, 0x1400, 1, 0x80000205, 4)
    bus.read(NODE, 0x1600, 0)
    bus.try_to_write(NODE, 0x1600, 1, 0x60400010, 4)
    bus.write(NODE, 0x1400, 1, 0x00000205, 4)


@breaks('pdo.mapping-long')
def maps_more_than_a_frame_has(bus):
    bus.write(NODE, 0x1401, 1, 0x80000305, 4)
    bus.write(NODE, 0x1601, 0, 0, 1)
    for sub, entry in enumerate((0x60FF0020, 0x60420010, 0x60400010, 0x60710010), 1):
        bus.write(NODE, 0x1601, sub, entry, 4)
    bus.try_to_write(NODE, 0x1601, 0, 4, 1)


@breaks('pdo.not-mappable')
def maps_the_device_type(bus):
    bus.write(NODE, 0x1400, 1, 0x80000205, 4)
    bus.write(NODE, 0x1600, 0, 0, 1)
    bus.try_to_write(NODE, 0x1600, 1, 0x10000020, 4)


@breaks('pdo.cob-id-while-valid')
def moves_a_pdo_in_use(bus):
    bus.read(NODE, 0x1400, 1)
    bus.try_to_write(NODE, 0x1400, 1, 0x306, 4)


@breaks('pdo.restricted')
def gives_a_pdo_the_identifier_of_the_heartbeat(bus):
    bus.write(NODE, 0x1800, 1, 0xC0000185, 4)
    bus.try_to_write(NODE, 0x1800, 1, 0x40000705, 4)


@breaks('pdo.reserved-type')
def takes_a_reserved_type(bus):
    bus.write(NODE, 0x1800, 1, 0xC0000185, 4)
    bus.try_to_write(NODE, 0x1800, 2, 245, 1)


@breaks('pdo.inhibit-while-valid')
def changes_the_inhibit_time_in_use(bus):
    bus.map(NODE, 1, [(0x6041, 0, 16)], is_receive=False)
    bus.try_to_write(NODE, 0x1800, 3, 100, 2)


@breaks('pdo.set-in-operational')
def configures_a_running_node(bus):
    bus.start(NODE)
    bus.try_to_write(NODE, 0x1401, 1, 0x80000305, 4)


@breaks('pdo.left-invalid')
def forgets_to_put_a_pdo_into_use(bus):
    bus.write(NODE, 0x1400, 1, 0x80000205, 4)
    bus.write(NODE, 0x1600, 0, 0, 1)
    bus.write(NODE, 0x1600, 1, 0x60400010, 4)
    bus.write(NODE, 0x1600, 0, 1, 1)
    bus.start(NODE)


@breaks('pdo.short')
def sends_half_a_controlword(bus):
    bus.map(NODE, 1, [(0x6040, 0, 16)], is_receive=True)
    bus.start(NODE)
    bus.send(0x205, '00')
    bus.wait(0.1)


@breaks('pdo.long')
def sends_more_than_is_mapped(bus):
    bus.map(NODE, 1, [(0x6040, 0, 16)], is_receive=True)
    bus.start(NODE)
    bus.send(0x205, '0000000000000000')
    bus.wait(0.1)


@breaks('pdo.before-operational')
def sends_set_points_to_a_node_that_waits(bus):
    bus.write(NODE, 0x1017, 0, 100, 2)
    bus.expect(0x705, lambda data: data == b'\x7F')
    bus.wait(0.2)
    bus.send(0x205, '0600')
    bus.wait(0.1)


@breaks('pdo.remote')
def asks_for_a_pdo_that_does_not_allow_it(bus):
    bus.write(NODE, 0x1800, 1, 0xC0000185, 4)
    bus.write(NODE, 0x1800, 1, 0x40000185, 4)
    bus.start(NODE)
    bus.send(0x185, remote=True)
    bus.wait(0.1)


# SYNC

@breaks('sync.jitter')
def sends_sync_when_it_likes(bus):
    for pause in [0.01] * 12 + [0.016]:
        bus.send(0x080)
        bus.wait(pause)
    bus.send(0x080)


@breaks('sync.counter')
def miscounts_sync(bus):
    for count in (1, 2, 3, 5):
        bus.send(0x080, f'{count:02X}')
        bus.wait(0.01)


@breaks('sync.length')
def counts_sometimes(bus):
    for data in ('', '', '03'):
        bus.send(0x080, data)
        bus.wait(0.01)


@breaks('sync.missing')
def forgets_sync(bus):
    bus.write(NODE, 0x1800, 1, 0xC0000185, 4)
    bus.write(NODE, 0x1800, 2, 1, 1)
    bus.write(NODE, 0x1800, 1, 0x40000185, 4)
    bus.start(NODE)
    bus.wait(5)
