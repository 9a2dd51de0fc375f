"""Runs a test with canopen-audit beside it: audited.py BIN-FOLDER NAME [NODE:EDS]... -- COMMAND...

To be run by with-can, or where there is a vcan0. The exit status is that of the test; 1 if that is 0 and the auditor has found
something that audited/NAME.json does not name, or has not found what that names.
"""

import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile

import programs

KNOWN = pathlib.Path(__file__).with_name('audited')
LISTENS = r'listening on .*\n'
JUDGED = (0, 1)  # exit statuses of canopen-audit behind which there is a report
# Tests of what others do under a master that is wrong on purpose: what is found is printed, and does not count.
UNJUDGED = {
    'can_programs': 'frames of cangen, canplayer and cansequence, whatever they mean',
    'canopen_check': 'canopen-check asks a slave for what no master may ask for',
    'drive': 'frames that a person sends without a look, to show what a drive does about each',
    'foreign_slaves_node': 'canopen-check asks a slave for what no master may ask for',
    'foreign_slaves_python': 'canopen-check asks a slave for what no master may ask for',
    'frames_in_one': 'requests without a wait between them, to see each frame arrive',
    'moved_cia402_1': 'canopen-check asks a drive for what no master may ask for',
    'moved_cia402_2': 'canopen-check asks a drive for what no master may ask for',
    'moved_s120_1': 'canopen-check asks a drive for what no master may ask for',
    'moved_s120_2': 'canopen-check asks a drive for what no master may ask for',
    'wire_faults': 'frames one by one, to show what each fault of the wire does to them',
}
# In the machine's time a master comes late where the machine stands still, which says nothing of the master.
OF_THE_MACHINE = {'sync.jitter', 'sync.period', 'sync.window', 'error-control.heartbeat-late', 'error-control.life-time',
                  'error-control.lost', 'drive.set-point-missing'}


def read(path):
    with open(path, encoding='utf-8') as file:
        return json.load(file)


def options(name, sheets):
    known = KNOWN / f'{name}.json'
    listed = ['--known', str(known)] if known.exists() else []
    return [*listed, *(word for sheet in sheets for word in ('--eds', sheet))]


def start_auditor(bin_folder, words, output):
    """canopen-audit on the bus of with-can, which listens."""
    environment = {key: value for key, value in os.environ.items() if key != 'LD_PRELOAD'}
    interface = f'unix:{os.environ["CAN_BUS"]}' if 'CAN_BUS' in os.environ else 'vcan0'
    auditor = programs.Program([os.path.join(bin_folder, 'canopen-audit'), '--interface', interface, *words],
                               environment, output)
    auditor.expect(LISTENS)
    return auditor


def faults_in(name, report):
    """What of the report speaks against the test."""
    if name in UNJUDGED:
        return []
    ignored = set() if os.environ.get('CAN_TIME') == 'virtual' else OF_THE_MACHINE
    found = [finding['rule'] for finding in report['findings'] if 'known' not in finding]
    return [*report['not_found'], *(rule for rule in found if rule not in ignored)]


def main():
    bin_folder, name, *words = sys.argv[1:]
    end = words.index('--')
    with tempfile.TemporaryFile('w+', encoding='utf-8') as output, tempfile.NamedTemporaryFile('r', encoding='utf-8') as report:
        auditor = start_auditor(bin_folder, ['--json', report.name, *options(name, words[:end])], output)
        status = subprocess.run(words[end + 1:], check=False).returncode
        auditor.process.send_signal(signal.SIGINT)
        judged = auditor.process.wait(programs.PATIENCE)
        output.seek(0)
        print(f'\n{output.read()}{auditor.rest()}')
        if status != 0:
            sys.exit(status)
        assert judged in JUDGED, f'canopen-audit: exit status {judged}'
        if faults := faults_in(name, json.load(report)):
            sys.exit(f'the master is not what it should be: {faults}')


if __name__ == '__main__':
    main()
