"""Mistakes with NMT commands and error control."""

from .mistake import NODE, breaks


# NMT

@breaks('nmt.before-boot-up')
def starts_a_node_that_boots(bus):
    bus.nmt(0x81, NODE)
    bus.nmt(1, NODE)
    bus.wait(3)


@breaks('nmt.sdo-before-boot-up')
def asks_a_node_that_boots(bus):
    bus.nmt(0x81, NODE)
    bus.send(0x605, '4000100000000000')
    bus.wait(3)


@breaks('nmt.sdo-when-stopped')
def asks_a_node_that_is_stopped(bus):
    bus.nmt(2, NODE)
    bus.wait(0.1)
    bus.send(0x605, '4000100000000000')
    bus.wait(0.3)
    bus.send(0x605, '8000100000000405')


@breaks('nmt.repeated')
def starts_and_starts(bus):
    bus.start(NODE)
    for _ in range(4):
        bus.nmt(1, NODE)
        bus.wait(0.2)


@breaks('nmt.command')
def sends_an_unknown_nmt_command(bus):
    bus.nmt(3, NODE)


@breaks('nmt.length')
def sends_a_command_for_nobody(bus):
    bus.send(0, '01')


@breaks('nmt.node-id')
def starts_node_133(bus):
    bus.nmt(1, 133)


@breaks('nmt.reset-in-transfer')
def resets_before_the_answer(bus):
    bus.send(0x605, '4000100000000000')
    bus.nmt(0x81, NODE)
    bus.wait(3)


# Error control

@breaks('error-control.both')
def sets_heartbeat_and_guarding(bus):
    bus.write(NODE, 0x100C, 0, 1000, 2)
    bus.write(NODE, 0x100D, 0, 3, 1)
    bus.try_to_write(NODE, 0x1017, 0, 500, 2)


@breaks('error-control.guards-heartbeat')
def guards_a_node_that_sends_heartbeats(bus):
    bus.write(NODE, 0x1017, 0, 500, 2)
    bus.send(0x705, remote=True)
    bus.wait(0.2)


@breaks('error-control.life-time')
def guards_too_seldom(bus):
    bus.write(NODE, 0x100C, 0, 100, 2)
    bus.write(NODE, 0x100D, 0, 3, 1)
    for pause in (0.1, 0.1, 0.5):
        bus.send(0x705, remote=True)
        bus.wait(pause)
    bus.send(0x705, remote=True)
    bus.wait(0.1)
