"""Runs examples/faults/faults.py and holds what it says of each master and fault against what the page says:
masters_faults.py BIN-FOLDER FAULTS.PY
"""

import os
import re
import subprocess
import sys

import programs

PATIENCE = 2 * programs.PATIENCE  # s, after which a master is said to wait
# What is said of a master and a fault; a machine that is slow changes none of it.
WANTED = {
    'none: npm': ['npm ends after .* exit status 0', 'left in Ready to switch on'],
    'none: python-can': ['python-can ends after .* exit status 0', 'left in Ready to switch on'],
    'dies in motion: npm': ['npm still waits', 'left in Switch on disabled', ' 705 .* 00$'],
    'dies in motion: python-can': ['TimeoutError: the heartbeat is lost', ' 705 .* 00$'],
    'SDO abort in the boot sequence: npm': ['npm ends after .* exit status 1', 'SdoError: .*0x1008', ' 585 .* 80 08 10 00 22 00 00 08$'],
    'SDO abort in the boot sequence: python-can': ['RuntimeError: SDO abort 08000022h', ' 585 .* 80 18 10 01 22 00 00 08$'],
    'SDO answer after the time-out: npm': ['npm ends after .* exit status 1', 'SdoError: SDO protocol timed out'],
    # One answer is enough for the master to go on; the other two come before or behind its next request.
    'SDO answer after the time-out: python-can': [
        r'(?s)(?: 585 .*43 18 10 01 53 00 00 06.*){3}', r'(?s) 585 .* 43 18 10 01 .* 605 .* 2B 17 10 00'],
    'reboots in configuration: npm': ['hits 1', ' 705 .* 00$'],
    'reboots in configuration: python-can': ['TimeoutError: ', ' 705 .* 00$'],
    'frozen feedback: npm': ['npm still waits', 'left in Operation enabled at 3000 rpm'],
    'frozen feedback: python-can': ['waited in vain for 3000 rpm', 'left in Operation enabled at 3000 rpm'],
}


def main():
    bin_folder, script = sys.argv[1:]
    environment = {**os.environ, 'PATH': f'{bin_folder}:/usr/bin:{os.environ["PATH"]}'}
    run = subprocess.run([sys.executable, script, '--patience', str(PATIENCE)], env=environment, stdin=subprocess.DEVNULL,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=340, check=False)
    print(run.stdout)
    assert run.returncode == 0, f'exit status {run.returncode}'
    said = dict(part.split('\n', 1) for part in re.split(r'^## ', run.stdout, flags=re.MULTILINE)[1:])
    assert said.keys() == WANTED.keys(), sorted(said)
    for name, patterns in WANTED.items():
        for pattern in patterns:
            assert re.search(pattern, said[name], re.MULTILINE), f'{name}: nothing matches "{pattern}"'


main()
