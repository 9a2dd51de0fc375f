"""A member that floods the bus with error frames does not flood the log: error_frames.py BIN-FOLDER

To be run by with-can, on a bus of its own.
"""

import os
import re
import struct
import sys
import time

import programs
from master import BOOT_UP, NODE, Master, can

CONTROLLER = 0x4  # CAN_ERR_CRTL
STATES = (0x30, 0x40)  # of data[1]: error passive, error active
CHANGES = 3000
MOST_LINES, LOOKED_AT = 20, 10  # so many lines in the seconds that a flood is looked at


def main():
    with programs.Folder(sys.argv[1]) as folder, can.Bus('vcan0', interface='socketcan') as bus:
        unit = folder.start('axisd', '--interface', f'unix:{os.environ["CAN_BUS"]}', '--node-id', str(NODE))
        unit.expect('ready')
        master = Master(bus)
        master.expect(*BOOT_UP)
        begin = time.monotonic()
        for number in range(CHANGES):
            bus.send(can.Message(arbitration_id=CONTROLLER, is_error_frame=True,
                                 data=struct.pack('8B', 0, STATES[number % 2], 0, 0, 0, 0, 0, 0)))
        master.send(0x600 + NODE, '4000100000000000')  # answered when all of them have been seen
        master.receive(0x580 + NODE)
        unit.process.terminate()
        log = unit.text + unit.process.stderr.read().decode()
        most = MOST_LINES * (1 + int((time.monotonic() - begin) / LOOKED_AT))
        written = len(re.findall(': error-(?:passive|active)$', log, re.MULTILINE))
        left_out = sum(int(count) for count in re.findall(r'\.\.\. (\d+) more left out like ".*: error-', log))
        assert written <= most, f'{written} lines for {CHANGES} error frames'
        assert written + left_out == CHANGES, f'{written} written, {left_out} left out: {log}'
        assert unit.process.wait(programs.PATIENCE) == 0


main()
