"""A recording has the frames of the bus in their order, and who has written what: recording.py BIN-FOLDER

To be run by with-can, on a bus of its own.
"""

import glob
import json
import os
import re
import struct
import sys

import html_pages
import programs
from html_pages import EVENT, END, FRAME, frame_of
from master import BOOT_UP, NODE, Master, can

PARAMETER = 9  # kind of an event
BY_SDO, BY_CONTROL = 1, 2
LINE = re.compile(r'\((\d+\.\d{6})\) can0 ([0-9A-F]{3})#([0-9A-F]*)')


def records_of(path):
    """Head and records of the recording at PATH."""
    with open(path, 'rb') as file:
        return html_pages.records_in(file.read())


def writes_in(records):
    """(who, parameter, value, before) of every parameter that was written."""
    for kind, _, content in records:
        if kind == EVENT and content[0] == PARAMETER:
            number, _, _, value, before = struct.unpack_from('<HHIdd', content, 6)
            yield content[1], number, value, before


def main():
    with programs.Folder(sys.argv[1]) as folder, can.Bus('vcan0', interface='socketcan') as bus:
        with open(folder.path('axisd.json'), 'w', encoding='ascii') as file:
            json.dump({'record': {'name': 'run', 'signals': ['1/r0063'], 'every_s': 0.01}}, file)
        socket = folder.path('control.sock')
        unit = folder.start('axisd', '--interface', f'unix:{os.environ["CAN_BUS"]}', '--node-id', str(NODE),
                            '--config', folder.path('axisd.json'), '--control', socket,
                            '--state-directory', folder.path('state'))
        unit.expect('ready')
        master = Master(bus)
        master.expect(*BOOT_UP)
        heard = [(f'{BOOT_UP[0]:03X}', BOOT_UP[1].upper())]
        for identifier, data, answer in ((0x600 + NODE, '2bb6410002000000', 0x580 + NODE),  # p8630[0] = 2
                                         (0x600 + NODE, '236024000000a040', 0x580 + NODE),  # p1120 = 5.0
                                         (0x600 + NODE, '4000100000000000', 0x580 + NODE)):
            master.send(identifier, data)
            heard.append((f'{identifier:03X}', data.upper()))
            heard.append((f'{answer:03X}', master.receive(answer).hex().upper()))
        folder.output_of('axisctl', '--socket', socket, 'set', 'p1120', '2.5')
        assert unit.end() == 0

        [recording] = glob.glob(folder.path('state/*/recordings/run.axrec'))
        head, records = records_of(recording)
        assert head['node_id'] == NODE, head
        assert records[-1][0] == END, records[-1]
        frames = [(time, *frame_of(content)[1:]) for kind, time, content in records if kind == FRAME]
        assert [frame[1:] for frame in frames] == heard, (frames, heard)
        assert list(writes_in(records)) == [(BY_SDO, 8630, 2.0, 0.0), (BY_SDO, 1120, 5.0, 10.0),
                                            (BY_CONTROL, 1120, 2.5, 5.0)], list(writes_in(records))

        with open(recording.replace('.axrec', '.log'), encoding='ascii') as log:
            lines = [LINE.fullmatch(line.rstrip('\n')) for line in log]
        assert [line.group(2, 3) for line in lines] == heard
        for line, (time, *_) in zip(lines, frames):
            microseconds = (head['wall_clock_ns'] + time) // 1000
            assert line.group(1) == f'{microseconds // 10**6}.{microseconds % 10**6:06}', line.group(0)


main()
