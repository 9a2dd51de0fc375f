"""Mistakes with identifiers, the TIME message and LSS."""

from .mistake import NODE, breaks


# Identifiers, TIME

@breaks('bus.unknown')
def sends_with_an_identifier_of_nobody(bus):
    bus.send(0x050, '01')


@breaks('bus.extended')
def sends_with_29_bits(bus):
    bus.send(0x205, '0600', extended=True)


@breaks('bus.time-length')
def sends_half_a_time(bus):
    bus.send(0x100, '00000000')


# LSS, on a bus on which nobody takes it

@breaks('lss.order')
def configures_nobody(bus):
    bus.send(0x7E5, '1107000000000000')
    bus.wait(0.1)


@breaks('lss.length')
def sends_short_lss_commands(bus):
    bus.send(0x7E5, '0400')


@breaks('lss.left-open')
def leaves_nodes_in_configuration(bus):
    bus.send(0x7E5, '0401000000000000')
    bus.wait(4)
    bus.read(NODE, 0x1001)
