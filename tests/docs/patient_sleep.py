"""sleep for blocks that are pasted: patient_sleep.py SECONDS

A reader's machine is idle; that of a test may let any process stand still. Before it sleeps, this waits until what the shell has sent has
come to the unit; afterwards, until what the shell has started in the background serves, and until the unit has run for so long, which
skips cycles when it is kept from running.
"""

import json
import os
import socket
import subprocess
import sys
import time

PATIENCE = 30  # s
MEMBERS = ('candump', 'axisd', 'canopen-zoo', 'example_slave')  # of the bus
STARTING = ('bash', 'with-can')  # will be another program
HTTP = ('127.0.0.1', 8402)


def said_by(*words):
    """What a program prints; nothing if it ends with an error."""
    run = subprocess.run(words, capture_output=True, text=True, check=False, timeout=PATIENCE)
    return run.stdout if run.returncode == 0 else ''


def skipped():
    """What the unit has skipped so far, in s; 0 without a unit."""
    status = json.loads(said_by('axisctl', '--json', 'status') or '{"skipped_cycles": 0, "cycle_ms": 0}')
    return status['skipped_cycles'] * status['cycle_ms'] / 1000


def processes():
    """Process, parent, and name of all in the session of the shell."""
    for entry in filter(str.isdigit, os.listdir('/proc')):
        try:
            with open(f'/proc/{entry}/stat', encoding='utf-8', errors='replace') as file:
                head, _, rest = file.read().rpartition(')')
        except OSError:  # it has just ended
            continue
        state, parent, _, session = rest.split()[:4]
        if int(session) == os.getsid(0) and state != 'Z':
            yield int(entry), int(parent), head.partition('(')[2]


def serves(process, name, members):
    if name == 'axisd-http':
        with socket.socket() as client:
            return client.connect_ex(HTTP) == 0
    return name not in STARTING and (name not in MEMBERS or str(process) in members)


def all_serve():
    there = {process: (parent, name) for process, parent, name in processes()}
    own = os.getpid()
    while own in there:  # this, and the shells that wait for it
        own = there.pop(own)[0]
    members = [word for row in said_by('canhub', '--status').splitlines() for word in row.split()]
    return all(serves(process, name, members) for process, (_, name) in there.items())


def main():
    seconds = float(sys.argv[1])
    said_by('canhub', '--status')
    before = skipped()
    time.sleep(seconds)
    end = time.monotonic() + PATIENCE
    while not all_serve() and time.monotonic() < end:
        time.sleep(0.05)
    made_up = 0
    while (missing := skipped() - before - made_up) > 0 and time.monotonic() < end:
        time.sleep(missing)
        made_up += missing


main()
