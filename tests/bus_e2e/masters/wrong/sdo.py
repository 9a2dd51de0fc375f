"""Mistakes over SDO: of transfers, with objects, with storage."""

from ..can_master import Aborted
from .mistake import NODE, breaks


# Transfers and objects

@breaks('sdo.overlap')
def asks_before_the_answer(bus):
    bus.send(0x607, '4000100000000000')  # a node that is there might answer between them
    bus.send(0x607, '4001100000000000')
    bus.wait(0.2)


@breaks('sdo.unaborted')
def gives_up_without_a_word(bus):
    bus.send(0x607, '4000100000000000')  # nobody has that node-ID
    bus.wait(0.5)
    bus.send(0x607, '4000100000000000')
    bus.wait(0.5)
    bus.send(0x607, '8000100000000405')


@breaks('sdo.length')
def sends_short_requests(bus):
    bus.send(0x605, '40001000')
    bus.wait(0.2)


@breaks('sdo.command')
def sends_an_unknown_command(bus):
    bus.read(NODE, 0x1000)
    bus.request(NODE, 'E000100000000000')


@breaks('sdo.segment-alone')
def asks_for_a_segment_of_nothing(bus):
    bus.read(NODE, 0x1000)
    bus.request(NODE, '6000000000000000')


@breaks('sdo.toggle')
def does_not_toggle(bus):
    assert bus.request(NODE, '4008100000000000')[0] == 0x41
    bus.request(NODE, '6000000000000000')
    bus.request(NODE, '6000000000000000')


@breaks('sdo.left-open')
def reads_the_first_segment_alone(bus):
    bus.request(NODE, '4008100000000000')
    bus.request(NODE, '6000000000000000')
    bus.read(NODE, 0x1001)


@breaks('sdo.abort-code')
def aborts_with_the_bytes_in_the_wrong_order(bus):
    bus.send(0x607, '4000100000000000')
    bus.wait(0.5)
    bus.send(0x607, '8000100005040000')


@breaks('sdo.abort-alone')
def aborts_what_has_ended(bus):
    bus.request(NODE, '2B171000F4010000')
    bus.send(0x605, '8017100000000405')
    bus.wait(0.1)


@breaks('sdo.size-untold')
def does_not_tell_the_size(bus):
    bus.request(NODE, '22171000F4010000')


@breaks('object.read-only')
def writes_the_device_type(bus):
    bus.try_to_write(NODE, 0x1000, 0, 0x20192, 4)


@breaks('object.missing')
def asks_for_what_is_not_there(bus):
    try:
        bus.read(NODE, 0x1004)
    except Aborted:
        pass


@breaks('object.length')
def writes_four_bytes_into_two(bus):
    bus.try_to_write(NODE, 0x1017, 0, 1000, 4)


# Storage

@breaks('storage.signature')
def stores_with_the_letters_turned_round(bus):
    bus.try_to_write(NODE, 0x1010, 1, 0x73617665, 4)


@breaks('storage.operational')
def stores_while_it_runs(bus):
    bus.start(NODE)
    bus.write(NODE, 0x1010, 1, 0x65766173, 4)


@breaks('storage.often')
def stores_all_the_time(bus):
    for _ in range(5):
        bus.write(NODE, 0x1010, 1, 0x65766173, 4)
        bus.wait(2)
