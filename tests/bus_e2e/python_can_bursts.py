"""Bursts of python-can, which polls without waiting before each frame: python_can_bursts.py

To be run by with-can, on a bus of its own. 127 frames back to back are one SDO request to every node, which is how
python-canopen looks for them.
"""

import os
import signal
import struct
import sys
import threading

from master import can

BURST = 127
BURSTS = 400
BUSY_PROCESSES = 2 * (os.cpu_count() or 1)


def hub_process():
    """The process that serves the bus."""
    with open(os.environ['CAN_BUS'] + '.lock', encoding='ascii') as lock:
        return int(lock.read())


def send_burst(bus, number):
    for node in range(1, BURST + 1):
        bus.send(can.Message(arbitration_id=0x600 + node, is_extended_id=False, data=struct.pack('<II', 0x40, number)))


def expect_burst(bus, number):
    for node in range(1, BURST + 1):
        message = bus.recv(20)
        assert message is not None, f'burst {number}: nothing came for node {node}'
        seen = (message.arbitration_id - 0x600, struct.unpack('<II', message.data)[1])
        assert seen == (node, number), f'expected node {node} of burst {number}, got {seen}'


def try_bursts(count):
    """The number of COUNT bursts that could not be sent, and were not received whole and in order."""
    failed = 0
    with can.Bus('vcan0', interface='socketcan') as sender, can.Bus('vcan0', interface='socketcan') as receiver:
        for number in range(count):
            try:
                send_burst(sender, number)
                expect_burst(receiver, number)
            except can.CanError as error:
                failed += 1
                print(f'burst {number}: {error}', file=sys.stderr)
                while receiver.recv(0.1) is not None:
                    pass
    return failed


def under_load(action):
    """Does ACTION while other processes use all there is of the processors."""
    children = []
    for _ in range(BUSY_PROCESSES):
        child = os.fork()
        if child == 0:
            while os.getppid() != 1:
                pass
            os._exit(0)
        children.append(child)
    try:
        return action()
    finally:
        for child in children:
            os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)


def burst_to_a_hub_that_stands():
    """A burst longer than every buffer waits for the hub; it does not fail."""
    with can.Bus('vcan0', interface='socketcan') as sender, can.Bus('vcan0', interface='socketcan') as receiver:
        hub = hub_process()
        os.kill(hub, signal.SIGSTOP)
        threading.Timer(0.5, os.kill, (hub, signal.SIGCONT)).start()
        for number in range(16):
            send_burst(sender, number)
        for number in range(16):
            expect_burst(receiver, number)


def main():
    failed = try_bursts(BURSTS) + under_load(lambda: try_bursts(BURSTS))
    assert failed == 0, f'{failed} of {2 * BURSTS} bursts failed'
    burst_to_a_hub_that_stands()


main()
