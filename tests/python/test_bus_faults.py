"""Faults of the bus: what passes, what is counted, and that nothing of them stays."""

import pytest

import axisd


@pytest.fixture
def other(can_bus):
    with axisd.Bus(can_bus.path) as bus:
        yield bus


def test_loses_the_frames_that_are_named(can_bus, other):
    fault = can_bus.inject('bus.drop', id=0x185, after=1, times=2)
    for word in ('185#01', '185#02', '186#02', '185#03', '185#04'):
        other.send(word)
    assert [str(can_bus.recv()) for _ in range(3)] == ['185#01', '186#02', '185#04']
    assert (fault.state, fault.hits) == ('over', 2)


def test_is_taken_back_at_the_end_of_its_block(can_bus, other):
    with other.inject('bus.drop', id=0x185) as fault:
        other.send('185#01')
    other.send('185#02')
    assert can_bus.wait_for(0x185).data == b'\x02'
    assert (fault.state, fault.hits, can_bus.faults()) == ('removed', 1, [])


def test_a_unit_on_it_loses_an_answer(drive):
    drive.bus.wait_for(0x705)
    with drive.bus.inject('bus.drop', id=0x585, times=1):
        with pytest.raises(axisd.Timeout, match='no answer under 585h'):
            drive.sdo_read(0x1000, timeout=0.01)
        assert drive.sdo_read(0x1000, as_type=int) == 0xFFFF0192
        assert 'injected 1: bus.drop id=0x585 times=1: over, 1 hits' in drive.bus.report()
    assert drive.bus.remove_faults() == 0


def test_says_what_is_wrong_with_one(can_bus):
    with pytest.raises(axisd.Refused, match='expected bus.drop, .* got "bus.drip"'):
        can_bus.inject('bus.drip')
