"""axisd.Bus and the interface of python-can: frames as they pass."""

import os

import can
import pytest

import axisd


@pytest.fixture
def other(can_bus):
    with axisd.Bus(can_bus.path) as bus:
        yield bus


def test_hands_each_frame_of_others_out_once(can_bus, other):
    for word in ('185#0102', '705#05', '18FF50E5#01', '605#R8', '080#'):
        other.send(word)
    can_bus.send(0x123, b'\x01')
    assert [str(can_bus.recv()) for _ in range(5)] == ['185#0102', '705#05', '18FF50E5#01', '605#R8', '080#']
    assert can_bus.recv(0) is None
    assert str(other.wait_for(0x123)) == '123#01'
    can_bus.close()
    assert [str(frame) for frame in can_bus.frames][:2] == ['185#0102', '705#05']


def test_waits_for_what_is_asked(can_bus, other):
    for word in ('185#0102', '185#0302', '186#0302', '185#0402'):
        other.send(word)
    assert str(can_bus.wait_for(0x185, '03')) == '185#0302'
    assert str(can_bus.wait_for(data='0002', mask='00FF')) == '186#0302'
    assert str(can_bus.wait_for(where=lambda frame: frame.data[0] == 4)) == '185#0402'
    other.send('185#05')
    other.send('187#')
    can_bus.wait_for(0x187)
    other.send('188#')
    with pytest.raises(axisd.Timeout, match=r'^a frame 185h has not come within 0.01 s; '):
        can_bus.wait_for(0x185, timeout=0.01)


def test_keeps_what_it_has_sent_in_its_place(can_bus, other):
    can_bus.send('605#4000100000000000')
    other.wait_for(0x605)
    other.send('585#430010009201FFFF')
    can_bus.wait_for(0x585)
    assert [(str(frame), frame.own) for frame in can_bus.frames] == [
        ('605#4000100000000000', True), ('585#430010009201FFFF', False)]
    first, second = can_bus.candump().splitlines()
    assert first.endswith(') vcan0 605#4000100000000000') and second.endswith(') vcan0 585#430010009201FFFF')
    assert can_bus.candump(last=1) == second
    assert [str(frame) for frame in can_bus.since(1)] == ['585#430010009201FFFF']


def test_passes_over_what_is_old(can_bus, other):
    other.send('185#01')
    other.send('186#')
    can_bus.wait_for(0x186)
    reader = can_bus.reader()
    other.send('185#02')
    assert reader.wait_for(lambda frame: frame.id == 0x185, can_bus.timeout)
    can_bus.skip()
    other.send('185#03')
    assert can_bus.wait_for(0x185).data == b'\x03'


def test_is_the_bus_of_python_can(can_bus):
    with can.Bus(interface='userbus', channel=can_bus.path) as bus:
        bus.send(can.Message(arbitration_id=0x123, data=[1, 2], is_extended_id=False))
        bus.send(can.Message(arbitration_id=0x705, is_remote_frame=True, dlc=1, is_extended_id=False))
        bus.send(can.Message(arbitration_id=0x18FF50E5, data=[3]))
        assert [str(can_bus.recv()) for _ in range(3)] == ['123#0102', '705#R1', '18FF50E5#03']
        can_bus.send('585#430010009201FFFF')
        message = bus.recv(can_bus.timeout)
        assert (message.arbitration_id, message.data.hex(), message.is_extended_id) == (0x585, '430010009201ffff', False)
        assert bus.recv(0) is None
        bus.set_filters([{'can_id': 0x200, 'can_mask': 0x7FF}])
        can_bus.send('185#01')
        can_bus.send('200#02')
        assert bus.recv(can_bus.timeout).arbitration_id == 0x200
        with pytest.raises(can.CanOperationError, match='classical'):
            bus.send(can.Message(arbitration_id=1, is_fd=True, data=bytes(12)))


def test_hears_itself_in_python_can_if_it_is_told_so(can_bus):
    with can.Bus(interface='userbus', channel=can_bus.path, receive_own_messages=True) as bus:
        bus.send(can.Message(arbitration_id=0x123, data=[1, 2], is_extended_id=False))
        message = bus.recv(can_bus.timeout)
        assert (message.arbitration_id, message.is_rx) == (0x123, False)


def test_python_can_says_why_there_is_no_bus(tmp_path):
    path = tmp_path / 'file'
    path.write_text('no bus')
    with pytest.raises(can.CanInitializationError, match=str(path)):
        can.Bus(interface='userbus', channel=str(path))


def test_starts_a_hub_where_none_serves(tmp_path):
    with axisd.Bus(tmp_path / 'bus') as bus, axisd.Bus(tmp_path / 'bus') as other:
        other.send('123#01')
        assert str(bus.recv()) == '123#01'


def test_says_what_is_wrong_with_a_frame(can_bus):
    for wrong, message in ((lambda: can_bus.send('12#01'), 'ID#DATA'), (lambda: can_bus.send(0x123, bytes(9)), 'at most 8 bytes, got 9'),
                           (lambda: can_bus.send(0x123, '0'), 'two a byte, got "0"'),
                           (lambda: can_bus.send(0x800, b'', extended=False), 'expected 0 to 7FFh, got 800h'),
                           (lambda: can_bus.wait_for(0x1, '00', mask='0000'), 'as many bytes as data has, 1, got 2')):
        with pytest.raises(ValueError, match=message):
            wrong()


def test_says_what_is_wrong_with_a_path(tmp_path):
    with pytest.raises(axisd.Error, match='expected a path of at most 107 bytes, got 200'):
        axisd.Bus('/' * 200)
    with pytest.raises(axisd.Error, match='^"no/name" is no name of a CAN interface$'):
        axisd.Bus(tmp_path / 'bus', interface='no/name')


def test_a_hub_that_ends_is_said(can_bus):
    os.kill(can_bus.hub.pid, 9)
    with pytest.raises(axisd.Ended, match='^canhub was ended by SIGKILL'):
        can_bus.wait_for(0x123)


def test_a_bus_with_a_bit_rate():
    with axisd.Bus.private(bit_rate=250_000) as bus:
        assert bus.bit_rate == 250_000


def test_names_the_services():
    words = {'000#0105': 'NMT start: node 5', '000#8200': 'NMT reset communication: all nodes', '080#': 'SYNC', '100#': 'TIME',
             '085#1081810000000000': 'EMCY of node 5: 8110h, error register 81h', '185#3716': 'TPDO 1 of node 5',
             '505#': 'RPDO 4 of node 5', '705#00': 'boot-up of node 5', '705#7F': 'heartbeat of node 5: Pre-operational',
             '705#R1': 'guarding request to node 5', '605#4000100000000000': 'SDO to node 5: read 1000:00',
             '605#2317100000000000': 'SDO to node 5: write 1017:00', '585#8017100002000106': 'SDO from node 5: abort 1017:00, 06010002h',
             '7E5#': '', '18FF50E5#01': ''}
    assert {word: axisd.Frame.parse(word).service for word in words} == words
