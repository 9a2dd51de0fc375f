"""Tests of a CANopen master against a simulated drive, each on a bus of its own: with-can -- pytest test_drive.py"""
import subprocess

import can
import pytest

NODE = 5


@pytest.fixture
def bus(tmp_path, monkeypatch):
    path = tmp_path / "bus"
    monkeypatch.setenv("CAN_BUS", str(path))  # where the CAN sockets of this process lead
    with can.Bus("vcan0", interface="socketcan") as bus:
        drive = subprocess.Popen(["axisd", "--interface", f"unix:{path}", "--node-id", str(NODE), "--control", "none",
                                  "--state-directory", str(tmp_path)], stderr=subprocess.DEVNULL)
        expect(bus, 0x700 + NODE)  # boot-up
        yield bus
        drive.terminate()
        assert drive.wait() == 0


def expect(bus, identifier):
    """The data of the next frame with this identifier."""
    while message := bus.recv(timeout=10):
        if message.arbitration_id == identifier:
            return message.data.hex()
    pytest.fail(f"no frame {identifier:03X}h")


def send(bus, identifier, data):
    bus.send(can.Message(arbitration_id=identifier, data=bytes.fromhex(data), is_extended_id=False))


def test_device_type(bus):
    send(bus, 0x600 + NODE, "4000100000000000")
    assert expect(bus, 0x580 + NODE) == "430010009201ffff"


def test_switches_on(bus):
    send(bus, 0x000, f"01{NODE:02x}")  # NMT: start the node
    for controlword, statusword in ("0600", "3116"), ("0700", "3316"), ("0f00", "3716"):
        send(bus, 0x200 + NODE, controlword)
        while expect(bus, 0x180 + NODE) != statusword:
            pass


def test_sync_by_the_broadcast_manager(bus):
    send(bus, 0x600 + NODE, "2f00180201000000")  # 1800h:02 = 1: TPDO 1 with every SYNC
    assert expect(bus, 0x580 + NODE) == "6000180200000000"
    send(bus, 0x000, f"01{NODE:02x}")
    sync = bus.send_periodic(can.Message(arbitration_id=0x080, is_extended_id=False), period=0.01)
    assert [expect(bus, 0x180 + NODE) for _ in range(5)] == ["4016"] * 5
    sync.stop()
