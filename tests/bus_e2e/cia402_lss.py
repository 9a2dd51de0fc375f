"""Two CiA 402 devices without node-ID on one bus, which LSS finds and tells apart: cia402_lss.py BIN-FOLDER

To be run by with-can, on a bus of its own.
"""

import json
import os
import pathlib
import struct
import sys

import control_client
import programs

try:
    import can
except ImportError as missing:
    sys.exit(f'{missing}: install python3-can (scripts/setup.sh)')

TO_SLAVES, TO_MASTER = 0x7E5, 0x7E4
WAITING, CONFIGURATION = 0, 1
FASTSCAN, IDENTIFIED = 0x51, 0x4F
# How long nobody answers before nobody was meant (s); on a machine that is too slow for one, the next is tried.
SILENCES = (0.02, 0.1, 0.5, 2.0)


class Unclear(Exception):
    """Answers have come later than they were waited for."""


class LssMaster:
    """The master of CiA 305 on a bus of python-can."""

    def __init__(self, bus):
        self.bus = bus

    def send(self, *data):
        self.bus.send(can.Message(arbitration_id=TO_SLAVES, is_extended_id=False, data=bytes(data).ljust(8, b'\0')))

    def answer(self, patience):
        """The next one, or None."""
        while (message := self.bus.recv(patience)) is not None:
            if message.arbitration_id == TO_MASTER:
                return message.data
        return None

    def ask(self, *data):
        self.send(*data)
        answer = self.answer(programs.PATIENCE)
        assert answer is not None and answer[0] == data[0], (bytes(data).hex(), answer)
        return answer

    def switch(self, mode):
        self.send(0x04, mode)

    def is_answered(self, silence, number, bit, sub, following):
        """Whether anybody answers to a fastscan; all that are meant do."""
        self.send(FASTSCAN, *struct.pack('<I', number), bit, sub, following)
        answers = 0
        while (answer := self.answer(silence)) is not None:
            assert answer[0] == IDENTIFIED, answer.hex()
            answers += 1
        return answers > 0

    def scan(self, silence):
        if not self.is_answered(silence, 0, 0x80, 0, 0):
            return None
        identity = []
        for sub in range(4):
            number = 0
            for bit in range(31, -1, -1):
                if not self.is_answered(silence, number, bit, sub, sub):
                    number |= 1 << bit
            if not self.is_answered(silence, number, 0, sub, (sub + 1) % 4):
                raise Unclear(f'{sub}: {number:08X}h')
            identity.append(number)
        return identity

    def find(self):
        """The identity of a device without node-ID, now in the state configuration; None if there is none."""
        for silence in SILENCES:
            try:
                identity = self.scan(silence)
            except Unclear:
                continue
            if identity is not None:
                return identity
        return None

    def inquire(self, command):
        return struct.unpack_from('<I', self.ask(command), 1)[0]

    def configure(self, node_id):
        assert self.ask(0x11, node_id)[1] == 0
        assert self.ask(0x17)[1] == 0


def start(folder, serial):
    name = folder.path(f'device-{serial}.json')
    with open(name, 'w', encoding='ascii') as file:
        json.dump({'profile': 'cia402', 'node_id': 255, 'serial': serial}, file)
    device = folder.start('axisd', '--interface', f'unix:{os.environ["CAN_BUS"]}', '--config', name)
    device.expect('ready: the node without node-ID on')
    return device


def sockets(folder):
    return {path.name.partition('unconfigured')[2]: str(path)
            for path in pathlib.Path(folder.folder.name).glob('axisd-*-unconfigured*.sock')}


def check_names(folder):
    names = sockets(folder)
    assert sorted(names) == ['-77.sock', '.sock'], names
    for path in names.values():
        status = control_client.ControlClient(path, programs.PATIENCE).call('status')
        assert (status['profile'], status['node_id']) == ('cia402', 255), status
        assert status['nmt_state'] == 'Unconfigured', status['nmt_state']


def check_a_third_of_the_same_name(folder):
    name = folder.path('device-77.json')
    third = folder.start('axisd', '--interface', f'unix:{os.environ["CAN_BUS"]}', '--config', name)
    third.expect('node unconfigured-77 is served by another axisd')
    assert third.process.wait(programs.PATIENCE) != 0


def boot_up_of(bus, node_id):
    while True:
        message = bus.recv(programs.PATIENCE)
        assert message is not None, f'no boot-up of node {node_id}'
        if message.arbitration_id == 0x700 + node_id and bytes(message.data) == b'\0':
            return


def check_both_are_found(bus):
    """Each is given a node-ID, with which it boots; the one that has one takes part no longer."""
    lss = LssMaster(bus)
    lss.switch(WAITING)
    serials = {}
    for node_id in (11, 12):
        identity = lss.find()
        assert identity is not None, serials
        assert lss.inquire(0x5A) == identity[0] and lss.inquire(0x5D) == identity[3], identity
        lss.configure(node_id)
        lss.switch(WAITING)
        boot_up_of(bus, node_id)
        serials[identity[3]] = node_id
    assert sorted(serials) == [1, 77], serials
    assert lss.find() is None
    return serials


def check_a_kept_node_id(folder, device, bus, node_id):
    """After the next switch-on the node-ID is there; state and socket keep their names."""
    assert device.end() == 0
    name = folder.path('device-77.json')
    folder.start('axisd', '--interface', f'unix:{os.environ["CAN_BUS"]}', '--config', name)
    boot_up_of(bus, node_id)
    found = sockets(folder)
    assert sorted(found) == ['-77.sock', '.sock'], found
    status = control_client.ControlClient(found['-77.sock'], programs.PATIENCE).call('status')
    assert status['node_id'] == node_id, status


def main():
    with programs.Folder(sys.argv[1]) as folder:
        devices = [start(folder, serial) for serial in (1, 77)]
        check_names(folder)
        check_a_third_of_the_same_name(folder)
        with can.Bus(interface='socketcan', channel='vcan0') as bus:
            serials = check_both_are_found(bus)
            check_a_kept_node_id(folder, devices[1], bus, serials[77])


main()
