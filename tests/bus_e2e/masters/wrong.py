"""Masters with one mistake each, and the rule of canopen-audit that it breaks."""

from .can_master import Aborted

NODE = 5
MASTERS = {}


def breaks(rule, profile='s120'):
    """Marks a master that breaks RULE and no other on a unit of PROFILE."""
    def keep(master):
        MASTERS[master.__name__] = (rule, profile, master)
        return master
    return keep


# SDO

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
    bus.read(NODE, 0x1000)
    bus.send(0x605, '8000100000000405')
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


# Error control, EMCY

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


# Storage, bus

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


# CiA 402

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
