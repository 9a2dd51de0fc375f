"""Each slave of canopen-zoo on a user-space bus of its own, before canopen-check: zoo.py BIN-FOLDER

A wrong slave is found by each of the checks that the list names, and a right one by none of them. Both measure by the clock of a machine
that may stand still meanwhile: what comes out otherwise is looked at again. tests/tools/canopen-check asserts it in simulated time.
"""

import concurrent.futures
import json
import os
import signal
import subprocess
import sys

import programs

SIDE_BY_SIDE = 12  # they wait for times to pass, most of them
NODE = '7'  # not that of the tests in simulated time
# Without these a slave without boot-up messages is waited for longer than it takes to find that.
LIMITS = ['--timeout', '2000', '--boot-limit', '4000']
TRIES = 10


def check(folder, slave, checks):
    """Runs canopen-check on SLAVE with CHECKS: which of them have found something, which have not been judged, and the whole output."""
    bus = f'unix:{folder.path(slave["name"] + ".bus")}'
    eds, report = folder.path(slave['name'] + '.eds'), folder.path(slave['name'] + '.json')
    program = programs.Program([os.path.join(folder.bin_folder, 'canopen-zoo'), '--run', slave['name'], '--interface', bus,
                                '--node', NODE, '--eds', eds], folder.environment)
    try:
        program.expect(f'ready: node {NODE} on ')
        run = subprocess.run([os.path.join(folder.bin_folder, 'canopen-check'), '--interface', bus, '--node', NODE,
                              '--eds', eds, '--json', report, '--allow-store', '--allow-motion', '--only', ','.join(checks), *LIMITS],
                             env=folder.environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                             timeout=6 * programs.PATIENCE)
        status = program.end()
    finally:
        program.kill()
    assert status == 0, f'{slave["name"]} ends with {status}'
    with open(report, encoding='utf-8') as file:
        results = json.load(file)['results']
    judged = {result['id'] for result in results}
    return {result['id'] for result in results if result['findings']} & set(checks), set(checks) - judged, run.stdout


def judge(folder, slave, checks):
    """Nothing, or in which way the checks have found what they should not, or not what they should."""
    wrong = set(checks)
    for _ in range(TRIES):
        expected = wrong & set(slave['found_by'])
        found, missing, output = check(folder, slave, sorted(wrong))
        wrong = found ^ expected | missing
        if not wrong:
            return ''
    return f'{slave["name"]}: found by {sorted(found)}, not judged by {sorted(missing)}\n{output}'


def jobs(slaves):
    """Each slave with the checks that find it; the right ones, which take longest, with those of all others."""
    every = {check for slave in slaves for check in slave['found_by']}
    lss = {check for check in every if check.startswith('lss.')}
    right = [slave for slave in slaves if not slave['found_by']]
    return [(slave, sorted(lss if 'Lss' in slave['name'] else every - lss)) for slave in right] + [
        (slave, slave['found_by']) for slave in slaves if slave['found_by']]


def main():
    with programs.Folder(sys.argv[1]) as folder:
        slaves = json.loads(folder.output_of('canopen-zoo', '--list', '--json'))
        with concurrent.futures.ThreadPoolExecutor(SIDE_BY_SIDE) as pool:
            complaints = [text for text in pool.map(lambda job: judge(folder, *job), jobs(slaves)) if text]
    assert not complaints, '\n'.join(complaints)
    print(f'{len(slaves)} slaves, each found by what is meant to find it')


signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
main()
