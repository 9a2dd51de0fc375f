"""Turns the axis of node 5 to 3000 rpm and stops it again, with python-can alone, as scripts of test benches do it."""

import time

import can

NODE = 5
RPM_3000 = 209_715_200  # increments/s
STATE = 0x6F  # the bits of the statusword that tell the state
PATIENCE = 5  # s, for what the drive has to do
HEARTBEAT = 0.1  # s
LOST = 2  # s without one
ANSWER = 1.5  # s, for an SDO answer


class Drive:
    def __init__(self, bus):
        self.bus = bus
        self.statusword = self.velocity = None
        self.heartbeat = None  # when the last one came

    def hear(self, timeout):
        """The next frame; what it tells is kept."""
        message = self.bus.recv(timeout)
        if message is None:
            return None
        if message.arbitration_id == 0x280 + NODE:
            self.statusword = int.from_bytes(message.data[0:2], 'little')
            self.velocity = int.from_bytes(message.data[2:6], 'little', signed=True)
        if message.arbitration_id == 0x700 + NODE:
            self.heartbeat = time.monotonic()
        if message.arbitration_id == 0x080 + NODE:
            print(f'EMCY {message.data[1]:02X}{message.data[0]:02X}h', flush=True)
        return message

    def send(self, identifier, data):
        self.bus.send(can.Message(arbitration_id=identifier, data=data, is_extended_id=False))

    def sdo(self, request):
        """The answer to a request of eight bytes, which is sent up to three times."""
        for _ in range(3):
            self.send(0x600 + NODE, request)
            end = time.monotonic() + ANSWER
            while (left := end - time.monotonic()) > 0:
                message = self.hear(left)
                if message and message.arbitration_id == 0x580 + NODE:
                    if message.data[0] == 0x80:
                        raise RuntimeError(f'SDO abort {int.from_bytes(message.data[4:8], "little"):08X}h')
                    return message.data
        raise TimeoutError('no SDO answer')

    def read(self, index, sub_index=0):
        return int.from_bytes(self.sdo(bytes([0x40, index & 0xFF, index >> 8, sub_index, 0, 0, 0, 0]))[4:8], 'little')

    def write(self, index, sub_index, size, value):
        command = 0x23 | (4 - size) << 2
        self.sdo(bytes([command, index & 0xFF, index >> 8, sub_index]) + value.to_bytes(4, 'little'))

    def wait(self, what, holds):
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            self.hear(HEARTBEAT)
            if self.statusword is not None and holds():
                return
            if self.heartbeat and time.monotonic() - self.heartbeat > LOST:
                raise TimeoutError('the heartbeat is lost')
        raise TimeoutError(f'waited in vain for {what}')

    def command(self, controlword, velocity):
        self.send(0x300 + NODE, controlword.to_bytes(2, 'little') + velocity.to_bytes(4, 'little'))

    def turn(self):
        print(f'device type {self.read(0x1000):08X}h, vendor {self.read(0x1018, 1):08X}h', flush=True)
        self.write(0x1017, 0, 2, int(HEARTBEAT * 1000))
        self.write(0x1801, 5, 2, 50)  # TPDO 2 every 50 ms, changed or not
        self.send(0x000, [1, NODE])
        for controlword, state in (0x06, 0x21), (0x07, 0x23), (0x0F, 0x27):  # shutdown, switch on, enable operation
            self.command(controlword, 0)
            self.wait(f'state {state:02X}h', lambda: self.statusword & STATE == state)
        self.command(0x0F, RPM_3000)
        self.wait('3000 rpm', lambda: abs(self.velocity - RPM_3000) < RPM_3000 / 1000)
        print(f'actual velocity {self.velocity}', flush=True)
        self.command(0x06, 0)  # OFF1: ramp down
        self.wait('standstill', lambda: self.statusword & STATE == 0x21)
        print('stands', flush=True)


with can.Bus(channel='vcan0', interface='socketcan') as bus_of_node:
    Drive(bus_of_node).turn()
