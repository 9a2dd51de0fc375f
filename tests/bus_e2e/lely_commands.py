"""Command files for lely's coctl (CiA 309-3) against axisd, without coctl: lely_commands.py BIN-FOLDER [cia402] FILE...

Sends the SDO requests of the files, and after each controlword waits for the state that it leads to. What is between two files
is a pause for the ramp or for homing: the axis must do what the former one has left, and its speed is read in the next one.
With cia402 the unit has that profile.
"""

import struct
import sys
import time

import cia402_unit
import programs
from master import Abort, Master, NODE, can
from programs import PATIENCE

FORMATS = {'i8': '<b', 'i32': '<i', 'u16': '<H', 'u32': '<I'}
HOMING = 6
STATES = {0x06: 0x21, 0x07: 0x23, 0x0F: 0x27}


def commands(path):
    """The words of each command."""
    with open(path, encoding='ascii') as file:
        lines = [line.split('#')[0].split() for line in file]
    return [words for words in lines if words]


def wait_for_state(master, state):
    deadline = time.monotonic() + PATIENCE
    while (seen := struct.unpack('<H', master.upload(0x6041))[0]) & 0x6F != state:
        assert time.monotonic() < deadline, f'statusword {seen:04X}h'


def wait_for_homing(master):
    deadline = time.monotonic() + PATIENCE
    while (seen := struct.unpack('<H', master.upload(0x6041))[0]) & 0x3400 != 0x1400:
        assert time.monotonic() < deadline and not seen & 0x2000, f'statusword {seen:04X}h'


def velocity(master, index):
    return struct.unpack('<i', master.upload(index))[0]


def wait_for_speed(master):
    """Until the axis turns as fast as it is asked to, within a thousandth; fails where that is standstill."""
    target = velocity(master, 0x60FF)
    assert target != 0, 'no target velocity'
    deadline = time.monotonic() + PATIENCE
    while abs((seen := velocity(master, 0x606C)) - target) > abs(target) // 1000:
        assert time.monotonic() < deadline, f'{seen} of {target} a second'
    return target


def wait_for_what_is_asked(master):
    """Until the axis is homed or at its speed; the latter."""
    if master.upload(0x6061)[0] == HOMING:
        return wait_for_homing(master)
    return wait_for_speed(master)


def run(master, words):
    """One command; a line on what came of it."""
    if words[0] == 'set':
        assert words[1] != 'node' or int(words[2]) == NODE
        return 'OK'
    index, sub_index, form = int(words[1], 0), int(words[2], 0), FORMATS[words[3]]
    if words[0] == 'r':
        return str(struct.unpack(form, master.upload(index, sub_index))[0])
    assert words[0] == 'w', words
    value = int(words[4], 0)
    master.write(index, sub_index, struct.pack(form, value))
    if index == 0x6040:
        wait_for_state(master, STATES[value & 0x0F])
    return 'OK'


def main():
    bin_folder, *paths = sys.argv[1:]
    start_unit = programs.start_unit
    if paths[0] == 'cia402':
        start_unit = cia402_unit.start_unit
        paths = paths[1:]
    speeds, target = [], None
    with programs.Folder(bin_folder) as folder, can.Bus('vcan0', interface='socketcan') as bus:
        unit = start_unit(folder)
        master = Master(bus)
        master.send(0x000, f'01{NODE:02x}')
        for path in paths:
            if path != paths[0]:
                target = wait_for_what_is_asked(master)
            for words in commands(path):
                try:
                    answer = run(master, words)
                except Abort as abort:
                    raise AssertionError(f'{" ".join(words)}: {abort.args[0]:08X}h') from abort
                print(*words, '->', answer)
                if words[:2] == ['r', '0x606C']:
                    speeds.append((int(answer), target))
        assert speeds and all(abs(speed - wanted) <= wanted // 100 for speed, wanted in speeds), speeds
        assert unit.end() == 0


main()
