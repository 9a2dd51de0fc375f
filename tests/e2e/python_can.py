"""A master made with python-can, interface socketcan, against a running axisd of node 5.

    python_can.py INTERFACE        prints a line a step; exit status 0 if every step passed
"""
import sys
import time

import can

NODE = 5
PATIENCE = 10.0  # s


def message(identifier, data=(), **more):
    return can.Message(arbitration_id=identifier, data=bytes(data), is_extended_id=False, **more)


def wait_for(bus, identifier, wanted=lambda data: True):
    """The next message under an identifier whose data are wanted."""
    end = time.monotonic() + PATIENCE
    while (left := end - time.monotonic()) > 0:
        received = bus.recv(left)
        if received and received.arbitration_id == identifier and wanted(received.data):
            return received
    raise AssertionError(f"nothing wanted under {identifier:03X}h")


def sdo_upload(bus):
    bus.send(message(0x600 + NODE, [0x40, 0x00, 0x10, 0, 0, 0, 0, 0]))
    answer = wait_for(bus, 0x580 + NODE)
    assert answer.data.hex() == "430010009201ffff", answer


def nmt_start(bus):
    bus.send(message(0x000, [0x82, NODE]))
    assert wait_for(bus, 0x700 + NODE).data == b"\0"
    bus.send(message(0x000, [0x01, NODE]))
    wait_for(bus, 0x180 + NODE)


def received_time(bus):
    before = time.time()
    bus.send(message(0x600 + NODE, [0x40, 0x08, 0x10, 0, 0, 0, 0, 0]))
    answer = wait_for(bus, 0x580 + NODE)
    assert before <= answer.timestamp <= time.time(), (before, answer.timestamp)


def periodic_controlword(bus):
    """The broadcast manager sends the controlword; the drive follows each change of it."""
    task = bus.send_periodic(message(0x200 + NODE, [0x06, 0x00]), 0.02)
    for controlword, state in ((0x06, 0x31), (0x07, 0x33), (0x06, 0x31)):
        task.modify_data(message(0x200 + NODE, [controlword, 0x00]))
        wait_for(bus, 0x180 + NODE, lambda data, low=state: data[0] == low)
    task.stop()
    task.start()
    task.stop()


def periodic_for_a_time(bus):
    """Three messages, sent by the broadcast manager for a given time, arrive as they were sent."""
    with can.Bus(interface="socketcan", channel=bus.channel) as listener:
        bus.send_periodic(message(0x555, [0x11, 0x22]), 0.01, duration=0.03)
        for _ in range(2):
            assert wait_for(listener, 0x555).data.hex() == "1122"


def filters(bus):
    with can.Bus(interface="socketcan", channel=bus.channel,
                 can_filters=[{"can_id": 0x580 + NODE, "can_mask": 0x7FF, "extended": False}]) as narrow:
        bus.send(message(0x7FF))
        bus.send(message(0x600 + NODE, [0x40, 0x00, 0x10, 0, 0, 0, 0, 0]))
        assert narrow.recv(PATIENCE).arbitration_id == 0x580 + NODE


def own_messages(bus):
    with can.Bus(interface="socketcan", channel=bus.channel, receive_own_messages=True) as own:
        own.send(message(0x7FF, [1]))
        received = wait_for(own, 0x7FF)
        assert not received.is_rx and received.channel == bus.channel, received


def notifier(bus):
    reader = can.BufferedReader()
    watcher = can.Notifier(bus, [reader])
    bus.send(message(0x600 + NODE, [0x40, 0x00, 0x10, 0, 0, 0, 0, 0]))
    assert wait_for(type("Queue", (), {"recv": staticmethod(reader.get_message)}), 0x580 + NODE)
    watcher.stop()


STEPS = (sdo_upload, nmt_start, received_time, periodic_controlword, periodic_for_a_time, filters, own_messages, notifier)


def main():
    with can.Bus(interface="socketcan", channel=sys.argv[1]) as bus:
        for step in STEPS:
            step(bus)
            print(step.__name__, flush=True)


main()
