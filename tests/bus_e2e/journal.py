"""What axisd tells the journal, heard at the journal's socket: journal.py BIN-FOLDER

To be run by own_journal.sh, in which /run/systemd/journal is free. Lines have the fields UNIT, AXIS, FAULT and COB_ID that
`journalctl` finds them by, and somebody who floods the unit does not flood the journal; nobody reads it meanwhile, and the unit goes on
answering.
"""

import os
import select
import socket
import subprocess
import sys
import time

import programs
from control_client import ControlClient

JOURNAL = '/run/systemd/journal/socket'
FLOOD = 100


class Journal:
    def __init__(self):
        os.makedirs(os.path.dirname(JOURNAL))
        self.socket = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
        self.socket.bind(JOURNAL)
        self.entries = []

    def drain(self):
        """What has come and was not looked at."""
        while select.select([self.socket], [], [], 0)[0]:
            self.take()
        return self.entries

    def take(self):
        lines = self.socket.recv(65536).decode().rstrip('\n').split('\n')
        self.entries.append(dict(line.split('=', 1) for line in lines))

    def expect(self, **fields):
        """Waits for an entry behind the last one with FIELDS, MESSAGE being a part of its text."""
        deadline = time.monotonic() + programs.PATIENCE
        while True:
            while self.entries:
                entry = self.entries.pop(0)
                if all(text in entry.get(name, '') if name == 'MESSAGE' else entry.get(name) == text
                       for name, text in fields.items()):
                    return entry
            ready, _, _ = select.select([self.socket], [], [], max(0, deadline - time.monotonic()))
            assert ready, f'nothing has come with {fields}'
            self.take()


def main():
    bin_folder = sys.argv[1]
    journal = Journal()
    with programs.Folder(bin_folder) as folder:
        control = folder.path('control.sock')
        read_end, write_end = os.pipe()
        stream = os.fstat(write_end)
        environment = {**folder.environment, 'JOURNAL_STREAM': f'{stream.st_dev}:{stream.st_ino}'}
        bus = f'unix:{os.environ["CAN_BUS"]}'
        unit = subprocess.Popen([os.path.join(bin_folder, 'axisd'), '--interface', bus, '--node-id', '5', '--control', control,
                                 '--state-directory', folder.path('state')], env=environment, stderr=write_end)
        os.close(write_end)
        folder.programs.append(unit)

        def axisctl(*words):
            return folder.output_of('axisctl', '--socket', control, *words)

        ready = journal.expect(MESSAGE='ready: node 5', PRIORITY='6', SYSLOG_IDENTIFIER='axisd')
        name = ready['UNIT']
        assert name.endswith('/5'), ready
        axisctl('fault', 'inject', '1', '7860')
        journal.expect(MESSAGE='F07860', PRIORITY='4', UNIT=name, AXIS='1', FAULT='F07860')
        axisctl('fault', 'ack', '1')
        journal.expect(MESSAGE='is gone', PRIORITY='6', UNIT=name, AXIS='1', FAULT='F07860')
        subprocess.run(['cansend', 'vcan0', '705#7F'], check=True, timeout=programs.PATIENCE)
        journal.expect(MESSAGE='duplicate node-ID', PRIORITY='4', UNIT=name, COB_ID='705')
        client = ControlClient(control, programs.PATIENCE)
        for _ in range(FLOOD):
            client.call('fault.inject', axis=1, number=7861)
            client.call('fault.ack', axis=1)
        flood = [entry for entry in journal.drain() if entry.get('FAULT') == 'F07861']
        assert 0 < len(flood) < FLOOD, f'{len(flood)} entries'
        axisctl('quit')
        assert unit.wait(programs.PATIENCE) == 0
        journal.expect(MESSAGE='power-off', UNIT=name)
        with open(read_end, 'rb') as standard_error:
            assert standard_error.read() == b'', 'what the journal has is on standard error too'


main()
