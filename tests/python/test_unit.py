"""axisd.Unit: its start and end, states, messages, events, and what it says when something is wrong."""

import os
import signal

import pytest

import axisd

SHORT_RAMPS = {'parameters': {'p1120': 0.5, 'p1121': 0.5}}


def test_begins_with_its_boot_up(drive):
    assert str(drive.bus.recv()) == '705#00'
    assert drive.status['nmt_state'] == 'Pre-operational'


@pytest.mark.axisd(axes=2, node_id=9, config={'axes': [{'name': 'left'}, {'name': 'right'}]})
def test_takes_a_configuration(drive):
    drive.wait(frame=0x709)
    assert [axis['name'] for axis in drive.status['axes']] == ['left', 'right']


def test_two_units_share_a_bus(drive):
    with axisd.Unit(node_id=6, bus=drive) as other:
        other.wait(frame=0x706)
        other.nmt('start')
        other.wait(nmt='operational')
        assert drive.status['nmt_state'] == 'Pre-operational'
    assert drive.status['nmt_state'] == 'Pre-operational'


@pytest.mark.axisd(axes=[SHORT_RAMPS])
def test_turns(drive):
    drive.nmt('start')
    drive.wait(nmt='operational')
    drive.switch_on()
    trace = drive.trace(['1/speed', '1/torque'], length_s=0.2, every=0.01, trigger='rising signal=1/speed level=100')
    drive.bus.send(0x305, '0F00 0000800C')
    assert drive.wait(value='1/speed', ge=2990) >= 2990
    assert drive.wait(value=0x606C, ge=209_000_000) >= 209_000_000
    speeds = trace.wait().column('1/speed')
    assert len(speeds) == 20 and speeds == sorted(speeds)


def test_sees_a_state_that_passes(drive):
    drive.nmt('start')
    drive.wait(nmt='operational')
    drive.switch_on()
    drive.call('fault.inject', axis=1, number=7860)
    drive.wait(message='F07860')
    drive.wait(state='fault')
    drive.call('fault.ack', axis=1)
    drive.wait(gone='F07860')
    drive.wait(event='fault', where=lambda event: not event['active'])
    assert [event['active'] for event in drive.events('fault')] == [True, False]
    assert drive.messages() == []


def test_tells_what_it_has_awaited_and_what_it_saw(drive):
    drive.sdo_read(0x1000)  # the boot-up, too, has passed the bus then
    with pytest.raises(axisd.Timeout) as late:
        drive.wait(state='operation-enabled', timeout=0.01)
    assert str(late.value).startswith(
        'state operation-enabled of axis 1 has not come within 0.01 s; seen last: Switch on disabled; axis 1: ')
    with pytest.raises(axisd.Timeout, match=r'^F07860 has not come within 0.01 s; seen last: no message'):
        drive.wait(message='F07860', timeout=0.01)
    with pytest.raises(axisd.Timeout, match=r'^1/speed ge 100 has not come within 0.01 s; it was 0.0 last'):
        drive.wait(value='1/speed', ge=100, timeout=0.01)
    with pytest.raises(axisd.Timeout, match=r'^an event emcy has not come within 0.01 s; there was none$'):
        drive.wait(event='emcy', timeout=0.01)
    with pytest.raises(axisd.Timeout, match=r'^a frame 199h with 01 has not come within 0.01 s; seen last: 705#00 585#430010009201FFFF$'):
        drive.wait(frame=0x199, data='01', timeout=0.01)


@pytest.mark.parametrize('wish, message', [
    ({}, 'expected one of state, nmt, message, gone, value, frame, event; got none'),
    ({'state': 'fault', 'nmt': 'stopped'}, 'got state, nmt'),
    ({'state': 'running'}, 'expected one of Not ready to switch on, '),
    ({'nmt': 'fault'}, 'expected one of Initialising, '),
    ({'state': 'fault', 'axis': 3}, 'the unit has no axis 3'),
    ({'message': 'X1'}, 'expected a number such as F07860'),
    ({'value': '1/speed'}, 'expected a comparison'),
    ({'value': '1/speed', 'above': 3}, 'expected for a value one of lt, '),
    ({'event': 'party'}, 'expected one of power, boot-up, '),
    ({'state': 'fault', 'ge': 3}, 'expected for a value one of lt, ')])
def test_refuses_a_wish_without_sense(drive, wish, message):
    with pytest.raises((TypeError, ValueError), match=message):
        drive.wait(**wish)


@pytest.mark.parametrize('keys, message', [
    ({'axes': 9}, r'^axes: expected 1 to 8, got 9$'),
    ({'config': {'axis': []}}, r'^configuration: /axis: unknown key, expected one of'),
    ({'axes': [{'motor': 'none'}]}, r'^configuration: /axes/0/motor: '),
    ({'node_id': 128}, '128'),
    ({'options': ['--hurry']}, '--hurry')])
def test_says_in_one_line_why_it_does_not_start(keys, message):
    with pytest.raises((axisd.Error, ValueError), match=message) as wrong:
        axisd.Unit(**keys)
    assert '\n' not in str(wrong.value)


def test_says_where_programs_were_looked_for(monkeypatch, tmp_path):
    monkeypatch.setenv('AXISD_BIN_DIR', str(tmp_path))
    with pytest.raises(axisd.Missing, match=f'^axisd: not in .AXISD_BIN_DIR .{tmp_path}.$'):
        axisd.Unit()


def test_tells_the_log_of_a_daemon_that_has_ended(drive):
    os.kill(drive.pid, signal.SIGKILL)
    for use in (lambda: drive.wait(nmt='stopped'), lambda: drive.status):
        with pytest.raises(axisd.Ended, match='^axisd was ended by SIGKILL; its log: axisd: ready: node 5 on unix:'):
            use()


def test_is_not_there_behind_its_end():
    with axisd.Unit() as unit:
        folder, bus = unit.folder, unit.bus
    assert not os.path.exists(unit.control_path)
    with pytest.raises(axisd.Ended, match='^the unit with node-ID 5 was closed$'):
        unit.call('status')
    with pytest.raises(axisd.Ended, match='closed'):
        bus.send('000#0105')
    unit.close()
    assert not os.path.exists(os.path.join(folder, 'control'))
