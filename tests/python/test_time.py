"""A unit on a bus that has a time of its own."""

import time

import pytest

import axisd


def run_up(unit):
    """What a master would do, and what has passed then: frames with their times, and where the drive is."""
    unit.nmt('start')
    unit.wait(nmt='operational')
    unit.sdo_write(0x1017, 0, 100, size=2)
    unit.switch_on()
    unit.bus.send(0x305, '0F00 0000800C')
    unit.wait(value='1/speed', ge=500)
    unit.bus.pass_time(0.5)
    return unit.bus.candump(), unit.signal('1/speed'), unit.bus.now


@pytest.mark.axisd(time='stepped')
class TestStepped:
    def test_stands_until_it_is_stepped(self, drive):
        drive.wait(frame=0x705)
        begin = drive.bus.now
        assert drive.status['nmt_state'] == 'Pre-operational'
        assert drive.bus.now == begin
        assert drive.bus.step(0.25) == pytest.approx(begin + 0.25, abs=1e-9)

    def test_has_frames_when_they_come(self, drive):
        drive.sdo_write(0x1017, 0, 100, size=2)
        drive.bus.step(0.05)
        place = drive.bus.count
        drive.bus.step(1.0)
        beats = [frame.time for frame in drive.bus.since(place) if frame.id == 0x705]
        assert len(beats) == 10
        assert [round(later - sooner, 6) for sooner, later in zip(beats, beats[1:])] == [0.1] * 9

    def test_steps_while_it_waits(self, drive):
        drive.sdo_write(0x1017, 0, 1000, size=2)
        drive.wait(frame=0x705, data='7F')
        begin = drive.bus.now
        drive.wait(frame=0x705, data='7F')
        assert drive.bus.now - begin == pytest.approx(1, abs=0.001)

    def test_gives_up_by_its_own_clock(self, drive):
        begin = drive.bus.now
        with pytest.raises(axisd.Timeout, match='within 3 s'):
            drive.wait(frame=0x123, timeout=3)
        assert drive.bus.now - begin == pytest.approx(3, abs=1e-6)


@pytest.mark.axisd(time='virtual')
class TestVirtual:
    def test_stands_while_the_test_acts(self, drive):
        begin = drive.bus.now
        assert drive.status['nmt_state'] == 'Pre-operational'
        assert drive.read('p0304') is not None
        assert drive.bus.now == begin

    def test_passes_at_once(self, drive):
        begin = drive.bus.now
        drive.bus.pass_time(3600)
        assert drive.bus.now - begin == pytest.approx(3600, abs=1e-6)
        assert drive.status['uptime_s'] == pytest.approx(drive.bus.now, abs=1)

    def test_gives_up_by_the_clock_of_the_bus(self, drive):
        begin = drive.bus.now
        with pytest.raises(axisd.Timeout, match='within 60 s'):
            drive.wait(state='operation-enabled', timeout=60)
        assert drive.bus.now - begin == pytest.approx(60, abs=1e-6)

    def test_is_shared_by_all_of_the_test(self, drive):
        with axisd.Unit(node_id=6, bus=drive) as other, axisd.Bus(drive.bus.path) as listener:
            other.nmt('start')
            other.wait(nmt='operational')
            assert listener.wait_for(0).data == b'\x01\x06'
            assert listener.now == drive.bus.now == other.bus.now


@pytest.mark.parametrize('mode', ['stepped', 'virtual'])
def test_is_the_same_every_time(mode):
    runs = []
    for _ in range(2):
        with axisd.Unit(time=mode) as unit:
            runs.append(run_up(unit))
    assert runs[0] == runs[1]


@pytest.mark.axisd(time='scaled=20')
def test_runs_quicker(drive):
    begin, machine = drive.bus.now, time.monotonic()
    drive.sdo_write(0x1017, 0, 2000, size=2)
    drive.wait(frame=0x705, data='7F')
    drive.wait(frame=0x705, data='7F')
    of_the_machine = time.monotonic() - machine
    passed = drive.bus.now - begin
    assert passed >= 2
    assert passed >= 20 * of_the_machine - 1e-6


@pytest.mark.axisd(inject=[{'kind': 'boot-up.late', 'delay_ms': 5000}], time='virtual')
def test_waits_for_a_late_start(drive):
    drive.wait(frame=0x705, data='00')
    assert drive.bus.now > 4.9


def test_steps_no_other_time(drive):
    with pytest.raises(axisd.Refused, match='the time of the bus is not stepped'):
        drive.bus.step(1)


def test_refuses_what_is_no_time():
    with pytest.raises(axisd.Ended, match='scaled=K'):
        axisd.Bus.private(time='sometimes')


def test_tells_of_a_unit_that_does_not_start():
    with pytest.raises(axisd.Error, match='motr'):
        axisd.Unit(axes=[{'motr': 1}], time='virtual')
