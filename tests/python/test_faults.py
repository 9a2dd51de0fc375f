"""Faults that are injected into a unit: what the bus sees, what is counted, and that nothing of them stays."""

import pytest

import axisd


def test_strikes_when_it_is_told(drive):
    fault = drive.inject('sdo.abort', code=0x08000000, object=0x1000, after=1, times=2)
    assert fault.state == 'waiting'
    drive.sdo_read(0x1000)
    for _ in range(2):
        with pytest.raises(axisd.Abort) as abort:
            drive.sdo_read(0x1000)
        assert abort.value.abort_code == 0x08000000
    assert (fault.state, fault.hits, fault.hit_at) == ('over', 2, [1, 2])
    assert drive.sdo_read(0x1000, as_type=int) == 0xFFFF0192


def test_is_taken_back_at_the_end_of_its_block(drive):
    with drive.inject('sdo.silent') as fault:
        with pytest.raises(axisd.Timeout, match='no answer under 585h'):
            drive.sdo_read(0x1000, timeout=0.01)
        fault.wait(hits=1)
    drive.sdo_read(0x1000)
    assert (fault.state, fault.hits) == ('removed', 1)
    assert drive.faults() == []
    fault.remove()


def test_is_in_force_while_a_state_holds(drive):
    with drive.inject('nmt.deaf', while_='pre-operational') as fault:
        drive.nmt('start')
        fault.wait()
        assert drive.status['nmt_state'] == 'Pre-operational'
    drive.nmt('start')
    drive.wait(nmt='operational')


def test_a_reset_brings_a_second_boot_up(drive):
    drive.wait(frame=0x705, data='00')
    drive.inject('node.reset')
    drive.wait(frame=0x705, data='00')
    drive.wait(event='boot-up')
    drive.wait(nmt='pre-operational')


@pytest.mark.axisd(inject=[{'kind': 'boot-up.missing'}, {'kind': 'heartbeat.late', 'delay_ms': 20}])
def test_is_loaded_at_the_start(drive):
    missing, late = drive.faults()
    assert (missing.kind, missing.hits, late.kind, late.arguments) == ('boot-up.missing', 1, 'heartbeat.late', {'delay_ms': 20})
    assert drive.bus.frames == []
    assert drive.remove_faults() == 2
    drive.nmt('reset-node')
    drive.wait(frame=0x705, data='00')


def hits_of(seed):
    with axisd.Unit(seed=seed) as unit:
        fault = unit.inject('sdo.abort', code=0x08000000, probability=0.5)
        for _ in range(32):
            try:
                unit.sdo_read(0x1000)
            except axisd.Abort:
                pass
        return fault.opportunities, fault.hit_at


def test_the_same_seed_strikes_at_the_same_places():
    first = hits_of(7)
    assert first == hits_of(7) != hits_of(8)
    assert first[0] == 32 and 1 < len(first[1]) < 17


@pytest.mark.parametrize('kind, keys, message', [
    ('sdo.abrot', {}, 'expected sdo.deaf, .* got "sdo.abrot"'), ('sdo.abort', {}, 'code: expected'),
    ('sdo.abort', {'code': 1, 'kode': 1}, 'kode: unknown key, expected one of'),
    ('tpdo.late', {'delay_ms': 0}, 'delay_ms: expected a whole number from 1 to 3600000, got 0'),
    ('sync.deaf', {'until': 'soon'}, 'until: ')])
def test_says_what_is_wrong_with_one(drive, kind, keys, message):
    with pytest.raises(axisd.Refused, match=message) as wrong:
        drive.inject(kind, **keys)
    assert '\n' not in str(wrong.value)
    assert drive.faults() == []


def test_says_what_is_wrong_with_one_of_the_start():
    with pytest.raises(axisd.Error, match='^configuration: /inject/0.*: expected sdo.deaf'):
        axisd.Unit(inject=[{'kind': 'sdo.abrot'}])


def test_tells_what_a_fault_was_waited_for(drive):
    fault = drive.inject('sync.deaf', times=2)
    with pytest.raises(axisd.Timeout, match=r'^hit 1 of fault 1 has not come within 0.01 s; it is sync.deaf times=2: '
                                            '(waiting|active), 0 hits, 0 opportunities$'):
        fault.wait(timeout=0.01)
    for _ in range(3):
        drive.bus.send('080#')
    fault.wait_over()
    assert 'sync.deaf times=2: over, 2 hits' in drive.report()
