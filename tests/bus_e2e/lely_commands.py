"""Command files for lely's coctl (CiA 309-3) against axisd, without coctl: lely_commands.py BIN-FOLDER FILE...

Sends the SDO requests of the files, and after each controlword waits for the state that it leads to. What is between two files
is a pause for the ramp: the first one must have left a target that the axis reaches, and its speed is read in the next one.
"""

import struct
import sys
import time

import programs
from master import Abort, Master, NODE, can
from programs import PATIENCE

FORMATS = {'i8': '<b', 'i32': '<i', 'u16': '<H', 'u32': '<I'}
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


def velocity(master, index):
    return struct.unpack('<i', master.upload(index))[0]


def wait_for_speed(master):
    """Until the axis turns as fast as it is asked to, within a thousandth; fails where that is standstill."""
    target = velocity(master, 0x60FF)
    assert target != 0, 'no target velocity'
    deadline = time.monotonic() + PATIENCE
    while abs((seen := velocity(master, 0x606C)) - target) > abs(target) // 1000:
        assert time.monotonic() < deadline, f'{seen} of {target} increments/s'


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
        wait_for_state(master, STATES[value])
    return 'OK'


def main():
    bin_folder, *paths = sys.argv[1:]
    speeds = []
    with programs.Folder(bin_folder) as folder, can.Bus('vcan0', interface='socketcan') as bus:
        unit = programs.start_unit(folder)
        master = Master(bus)
        master.send(0x000, f'01{NODE:02x}')
        for path in paths:
            if path != paths[0]:
                wait_for_speed(master)
            for words in commands(path):
                try:
                    answer = run(master, words)
                except Abort as abort:
                    raise AssertionError(f'{" ".join(words)}: {abort.args[0]:08X}h') from abort
                print(*words, '->', answer)
                if words[:2] == ['r', '0x606C']:
                    speeds.append(int(answer))
        assert speeds and all(abs(speed - 209715200) < 209716 for speed in speeds), f'{speeds} increments/s'
        assert unit.end() == 0


main()
