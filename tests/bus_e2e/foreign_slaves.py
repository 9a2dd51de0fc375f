"""canopen-check against slaves that are built on nothing of this project:
foreign_slaves.py BIN-FOLDER EDS CASES COMMAND...

COMMAND INTERFACE EDS [MANNER] runs a slave. CASES is the name of a table below: for each manner the checks that find it, and
nothing else may be found. Both measure by the clock of a machine that may stand still meanwhile: what comes out otherwise is looked at again.
"""

import json
import os
import subprocess
import sys

import programs

# What every run needs not do again: how a slave bears thousands of frames is the same for every manner.
QUICK = ['--timeout', '1000', '--boot-limit', '4000', '--skip', 'device.other-objects,robustness']
TRIES = 10


class Case:
    """A manner, the options of the run, the checks that find something, and texts that the output has."""

    def __init__(self, manner, found=(), texts=(), options=(), without=()):
        self.manner, self.found, self.texts, self.options = manner, set(found), texts, list(options)
        self.without = without  # texts that the output has not

    def again(self, checks):
        """The same for CHECKS alone."""
        at = self.options.index('--only') if '--only' in self.options else len(self.options)
        options = [*self.options[:at], *self.options[at + 2:], '--only', ','.join(sorted(checks))]
        return Case(self.manner, self.found & checks, options=options)


PYTHON = [
    Case(None, texts=['the EDS calls no transmission type writable', 'which maps nothing, cannot be enabled'],
         options=['--verbose']),
    Case('late-abort', options=['--only', 'device', '--verbose'], texts=['answers no request']),
    Case('empty-segments', ['device.readable'], options=['--only', 'device'],
         texts=['2003h:00: expected a value, found an upload does not end: 8 segments without data']),
    Case('oversize', ['device.readable'], options=['--only', 'device'],
         texts=['2003h:00: expected a value, found an upload does not end after the 4 bytes that are announced']),
    Case('consumer-crash', ['device.write-back'], options=['--only', 'device.write-back,nmt,sdo'],
         texts=['1016h:01: expected the node behind the check', 'further checks: the node is gone since device.write-back']),
    Case('no-boot-up', ['nmt.boot-up-after-reset-node', 'nmt.boot-up-after-reset-communication'],
         options=['--only', 'nmt.boot-up,nmt.pre,nmt.reset'], texts=['the node sends no boot-up message']),
]
NODE = [
    Case(None),
    Case('long-commands', options=['--only', 'nmt.wrong-length,nmt.other,nmt.unknown', '--verbose'],
         texts=['note: a Stop of 8 bytes is obeyed']),
    Case('short-requests', options=['--only', 'sdo.short-request,sdo.remote-request,sdo.other-nodes', '--verbose'],
         texts=['note: requests of 0, 1, 2, 3, 4, 5, 6, 7 bytes are answered']),
    Case('pending-error', ['nmt.operational'], options=['--only', 'nmt.operational,nmt.transitions,nmt.no,pdo,emcy'],
         texts=['the slave refuses Operational: it is in Pre-operational, EMCY 5000h pending, 1001h = 01h']),
    Case('echoed-aborts', ['sdo.client-abort'], options=['--only', 'sdo,device']),
    Case('ends-on-reset', ['nmt.boot-up-after-reset-node'], options=['--only', 'nmt,sdo,pdo'],
         texts=['further checks: the node is gone since nmt.boot-up-after-reset-node'], without=['broken    ']),
    Case('ends-on-reset', options=['--only', 'nmt.transitions,nmt.reset,error-control', '--no-reset']),
]
TABLES = {'python': PYTHON, 'node': NODE}


def check(folder, eds, case):
    """Runs canopen-check: its status, its output, and its report."""
    report = folder.path('report.json')
    run = subprocess.run([os.path.join(folder.bin_folder, 'canopen-check'), '--interface', f'unix:{os.environ["CAN_BUS"]}',
                          '--node', '5', '--eds', eds, '--json', report, *QUICK, *case.options],
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=6 * programs.PATIENCE)
    with open(report, encoding='utf-8') as file:
        return run.returncode, run.stdout, json.load(file)


def judge(folder, eds, command, case):
    """A case for the next try, and what was wrong; nothing if all is as it should be."""
    slave = programs.Program([*command, 'vcan0', eds, *([case.manner] if case.manner else [])], os.environ)
    try:
        slave.expect('ready')
        status, output, report = check(folder, eds, case)
    finally:
        slave.kill()
    found = {result['id'] for result in report['results'] if result['findings']}
    print(f'{case.manner or "right"}: {report["counts"]}, {report["seconds"]:.1f} s', flush=True)
    wrong = [f'no "{text}"' for text in case.texts if text not in output] + [f'"{text}"' for text in case.without if text in output]
    if wrong:
        return case, f'{case.manner}: {wrong}\n{output}'
    if found != case.found:
        return case.again(found ^ case.found), f'{case.manner}: found {sorted(found)}\n{output}'
    assert status == (1 if found else 0), f'{case.manner}: exit status {status}\n{output}'
    return None, ''


def main():
    bin_folder, eds, table, *command = sys.argv[1:]
    with programs.Folder(bin_folder) as folder:
        for case in TABLES[table]:
            for _ in range(TRIES):
                case, complaint = judge(folder, eds, command, case)
                if case is None:
                    break
            assert case is None, complaint


main()
