"""The clock of the machine is set, forwards and backwards, under units that run: clock_steps.py BIN-FOLDER [--steps N] [--seed N]

Of the virtual machine of vcan-vm alone (VCAN_VM=1). To be run on its vcan0, or by with-can. A step goes by seconds, hours or years,
also to 1970 and beyond 2038. Behind each the heartbeats and the event-driven TPDO come on as before, by the clock that is never set; a
request is answered, and a save too; axisctl and a page of axisd-http are answered. In the end the unit starts again, in the
year 1970, with what was saved last. The seed is printed; the last line has the number of steps and of what was lost.
"""

import argparse
import os
import random
import re
import struct
import subprocess
import sys
import time

import programs
from http_client import Gateway
from sdo_client import ANSWER, SAVE, Client

NODE = 5
RAMP_UP_TIME = '1/p1120'  # s, what is saved each time
PERIOD = 0.1  # s, of the heartbeat and of the event timer of TPDO 1
WATCHED = 5  # periods
DAY = 86_400  # s
STEPS = [0.5, 3, 3600, DAY, 3650 * DAY]  # s
LATEST = 8_000_000_000  # s; the kernel takes times to 2232
PLACES = [0, 2**31 - 2, 2**32 - 2, 4_000_000_000]  # s since 1970


def earliest():
    """What the kernel takes: not before the machine has started."""
    return time.monotonic() + 1


def set_clock(draw):
    """Steps the clock somewhere; what was done."""
    now = time.time()
    to = draw.choice([now + draw.choice([-1, 1]) * draw.choice(STEPS)] * 3 + [draw.choice(PLACES)])
    to = min(max(to, earliest()), LATEST)
    time.clock_settime(time.CLOCK_REALTIME, to)
    return f'from {now:.3f} to {to:.3f}'


def identifiers(client, seconds):
    """The identifiers of the frames that come in so many SECONDS."""
    found = []
    end = time.monotonic() + seconds
    while (left := end - time.monotonic()) > 0:
        client.socket.settimeout(left)
        try:
            found.append(struct.unpack('<I', client.socket.recv(16)[:4])[0])
        except TimeoutError:
            break
    return found


def drained(client):
    """Since when frames may wait that are read from now on: what came before is no burst."""
    begin = time.monotonic()
    client.drain()
    return begin


def check_cyclic(client, begin):
    """Cyclic messages come neither in a burst nor late: the time for so many of them has passed since BEGIN."""
    seen = []
    while min(seen.count(0x700 + NODE), seen.count(0x180 + NODE)) < WATCHED:
        assert time.monotonic() < begin + ANSWER + WATCHED * PERIOD, f'{len(seen)} frames in {time.monotonic() - begin:.1f} s'
        seen += identifiers(client, PERIOD)
    most = (time.monotonic() - begin) / PERIOD + 2
    for identifier in (0x700 + NODE, 0x180 + NODE):
        assert seen.count(identifier) <= most, f'{seen.count(identifier)} of {identifier:X} where {most:.0f} are due'


def write(client, command, index, sub_index, value):
    client.request(NODE, command, index, sub_index, value)
    answers = client.answers(ANSWER)
    assert answers and answers[0][1][0] == 0x60, f'{index:04X}: {answers}'


def check_step(folder, client, gateway, begin, value):
    check_cyclic(client, begin)
    folder.output_of('axisctl', 'set', RAMP_UP_TIME, str(value))
    write(client, 0x23, 0x1010, 1, SAVE)
    assert gateway.request('GET', '/api/v1/units')[0] == 200


def start_unit(folder):
    bus = os.environ.get('CAN_BUS')
    unit = folder.start('axisd', '--interface', f'unix:{bus}' if bus else 'vcan0', '--node-id', str(NODE),
                        '--state-directory', folder.path('state'))
    unit.expect(f'ready: node {NODE}')
    return unit


def make_cyclic(client):
    write(client, 0x2B, 0x1017, 0, round(PERIOD * 1000))
    write(client, 0x2B, 0x1800, 5, round(PERIOD * 1000))
    client.socket.send(struct.pack('<IB3x8s', 0, 2, bytes([1, NODE])))


def play(arguments, folder):
    draw = random.Random(arguments.seed)
    client = Client()
    unit = start_unit(folder)
    gateway = Gateway(folder)
    gateway.unit()
    make_cyclic(client)
    check_cyclic(client, drained(client))
    lost = 0
    for step in range(1, arguments.steps + 1):
        begin = drained(client)
        done = set_clock(draw)
        try:
            check_step(folder, client, gateway, begin, step)
        except (AssertionError, subprocess.CalledProcessError) as error:
            lost += 1
            print(f'step {step}, {done}: {error}', flush=True)
    assert gateway.program.end() == 0 and unit.end() == 0
    time.clock_settime(time.CLOCK_REALTIME, earliest())
    start_unit(folder)
    found = re.search(r'"value":([0-9.]+)', folder.output_of('axisctl', '--json', 'get', RAMP_UP_TIME))[1]
    assert float(found) == arguments.steps, f'{RAMP_UP_TIME} is {found} after the last start'
    return lost


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('bin')
    parser.add_argument('--steps', type=int, default=20)
    parser.add_argument('--seed', type=int, default=random.SystemRandom().randrange(1_000_000))
    arguments = parser.parse_args()
    if os.environ.get('VCAN_VM') != '1':
        sys.exit('only the clock of the virtual machine is set: scripts/vcan-vm')
    print(f'seed {arguments.seed}', flush=True)
    with programs.Folder(arguments.bin) as folder:
        lost = play(arguments, folder)
    print(f'{arguments.steps} steps, lost {lost}')
    sys.exit(1 if lost else 0)


main()
