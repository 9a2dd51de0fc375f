"""Sends and receives by python-can in the ways in which it does: in the program's thread, in one of a Notifier, cyclically."""

import threading
import time

import can
from can.broadcastmanager import ThreadBasedCyclicSendTask


def message(identifier, *data):
    return can.Message(arbitration_id=identifier, is_extended_id=False, data=data)


def main():
    with can.Bus('vcan0', interface='socketcan') as bus, can.Bus('vcan0', interface='socketcan') as other:
        # A second thread answers.
        notifier = can.Notifier(other, [lambda seen: other.send(message(0x200 + seen.arbitration_id, *seen.data))
                                        if seen.arbitration_id < 0x200 else None])
        for number in range(5):
            bus.send(message(0x100 + number, number))
            answer = bus.recv(5)
            assert answer is not None and answer.arbitration_id == 0x300 + number, answer
            time.sleep(0.05)
        cycle = ThreadBasedCyclicSendTask(bus, threading.Lock(), message(0x280, 1, 2, 3), 0.1)
        time.sleep(0.55)
        cycle.stop()
        time.sleep(0.2)
        notifier.stop()


main()
