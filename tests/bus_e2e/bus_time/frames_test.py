"""What a test of a program on a CAN bus may look like; pytest runs it."""

import threading
import time

import can
import pytest


@pytest.fixture(name='bus')
def make_bus():
    with can.Bus('vcan0', interface='socketcan') as bus:
        yield bus


@pytest.fixture(name='echo')
def make_echo():
    """Answers each frame below 100h by one of 100h more, 10 ms later."""
    with can.Bus('vcan0', interface='socketcan', can_filters=[{'can_id': 0, 'can_mask': 0x700}]) as echo:
        ending = threading.Event()

        def answer():
            while not ending.is_set():
                seen = echo.recv(0.1)
                if seen is not None:
                    time.sleep(0.01)
                    seen.arbitration_id += 0x100
                    echo.send(seen)

        thread = threading.Thread(target=answer)
        thread.start()
        yield
        ending.set()
        thread.join()


@pytest.mark.parametrize('number', range(8))
def test_answers(bus, echo, number):
    del echo
    bus.send(can.Message(arbitration_id=number, is_extended_id=False, data=[number] * number))

    answer = bus.recv(2)

    assert answer is not None and answer.arbitration_id == 0x100 + number
    assert bytes(answer.data) == bytes([number] * number)


def test_is_silent_otherwise(bus):
    assert bus.recv(0.3) is None
