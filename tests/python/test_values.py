"""Parameters and objects of a unit, over its control socket and over the bus."""

import threading

import pytest

import axisd


def test_parameters_and_objects_over_the_control_socket(drive):
    drive.write('p1120', 2.5)
    assert drive.read('p1120') == 2.5
    assert drive.read('1/p1120') == drive.read('p1120', axis=1) == 2.5
    assert drive.read('r0722.3', axis=0) == 0
    assert drive.read(0x1018, 1) == drive.read('1018:01')
    drive.write(0x6083, 1000)
    assert drive.read('6083') == 1000


def test_a_refusal_has_its_code_and_limits(drive):
    with pytest.raises(axisd.Refused, match='p1120') as refused:
        drive.write('p1120', -1)
    assert refused.value.code == 'out-of-range'
    assert refused.value.details['limits']['minimum'] == 0
    with pytest.raises(axisd.Refused) as unknown:
        drive.call('status.of.the.art')
    assert unknown.value.code == 'unknown-method'


def test_objects_over_the_bus(drive):
    assert drive.sdo_read(0x1000) == bytes.fromhex('9201FFFF')
    assert drive.sdo_read(0x1000, as_type=int) == 0xFFFF0192
    assert drive.sdo_read(0x1008, as_type=str) == 'SINAMICS'  # two segments
    assert drive.bus.wait_for(0x585).data.hex() == '430010009201ffff'
    drive.sdo_write(0x1017, 0, 250, size=2)
    assert drive.sdo_read(0x1017) == b'\xFA\x00'
    drive.sdo_write(0x1017, 0, '0000')
    assert drive.sdo_read(0x1017, as_type=int) == 0


def test_an_abort_has_the_code_of_the_server(drive):
    with pytest.raises(axisd.Abort, match=r'^SDO 6041:00: read-only object \(06010002h\)$') as abort:
        drive.sdo_write(0x6041, 0, 1, size=2)
    assert abort.value.abort_code == 0x06010002
    with pytest.raises(axisd.Abort, match='length does not match|too (long|short)'):
        drive.sdo_write(0x1017, 0, bytes(9))


def test_a_server_that_is_not_there(drive):
    drive.wait(frame=0x705)  # it would be told as what came instead
    with pytest.raises(axisd.Timeout, match=r'^SDO 1000:00: no answer under 586h within 0.01 s; nothing came$'):
        axisd.SdoClient(drive.bus, 6, timeout=0.01).read(0x1000)


def test_a_wrong_toggle_bit_ends_the_transfer(drive):
    """A server by hand beside the unit, at identifiers of its own."""
    with axisd.Bus(drive.bus.path) as server:
        def serve():
            server.wait_for(0x607)
            server.send(0x587, '4100100009000000')
            server.wait_for(0x607)
            server.send(0x587, '1041424344454647')  # the toggle bit is set
        thread = threading.Thread(target=serve)
        thread.start()
        with pytest.raises(axisd.Abort, match='aborted by the client: toggle bit not alternated'):
            axisd.SdoClient(drive.bus, 7, timeout=drive.timeout).read(0x1000)
        thread.join()
        assert server.wait_for(0x607).data.hex() == '8000100000000305'


def test_a_number_needs_its_size(drive):
    with pytest.raises(ValueError, match='^size: expected'):
        drive.sdo_write(0x1017, 0, 250)
