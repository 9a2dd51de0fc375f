"""canopen-audit on a bus that goes down: audit_bus_down.py BIN-FOLDER

To be run by with-can. It says so in one message, reports what it has heard until then, and ends as docs/reference/exit-statuses.md has it.
"""

import os
import re
import signal
import sys
import tempfile

import programs
from masters.can_master import CanMaster

BIN = sys.argv[1]
RIGHT = (0x185, '00')    # none of these means anything else when time passes between them
WARNING = (0x050, '01')
ERROR = (0x000, '01')

# Frames, options, rules that are broken, exit status.
CASES = [
    ([RIGHT], [], [], 3),
    ([RIGHT, WARNING], [], ['bus.unknown'], 3),
    ([RIGHT, WARNING], ['--strict'], ['bus.unknown'], 1),
    ([RIGHT, ERROR], [], ['nmt.length'], 1),
]


def send(frames):
    """Sends FRAMES on the bus in $CAN_BUS. A hub that has given the last one to a member gives it to all before it ends."""
    sender, witness = CanMaster(), CanMaster()
    with sender.socket, witness.socket:
        for identifier, data in frames:
            sender.send(identifier, data)
        if frames:
            witness.expect(frames[-1][0])


def audit(frames, options=(), time='real', is_stopped=False):
    """The report and the exit status of an auditor that has heard FRAMES when its bus goes down; IS_STOPPED: before it reads them."""
    with programs.Folder(BIN) as folder, tempfile.TemporaryFile('w+', encoding='utf-8') as output:
        bus = os.environ['CAN_BUS'] = folder.path('bus')
        hub = folder.start('canhub', '--path', bus, '--time', time)
        hub.expect('ready')
        auditor = programs.Program([os.path.join(BIN, 'canopen-audit'), '--interface', f'unix:{bus}', *options],
                                   folder.environment, output)
        folder.programs.append(auditor)
        auditor.expect('listening on .*\n')
        if is_stopped:
            auditor.process.send_signal(signal.SIGSTOP)
            os.waitpid(auditor.process.pid, os.WUNTRACED)
        send(frames)
        assert hub.end() == 0
        auditor.process.send_signal(signal.SIGCONT)
        status = auditor.process.wait(programs.PATIENCE)
        said = auditor.rest()
        assert said == f'canopen-audit: unix:{bus} has gone down\n', said
        output.seek(0)
        return output.read(), status


def check(case, **circumstances):
    frames, options, rules, expected = case
    report, status = audit(frames, options, **circumstances)
    assert status == expected, f'{case}, {circumstances}: {status}\n{report}'
    assert re.findall(r': (\d+) frames in ', report) == [str(len(frames))], f'{case}, {circumstances}: {report}'
    assert re.findall(r'^(?:error|warning) +(\S+)', report, re.MULTILINE) == rules, f'{case}, {circumstances}: {report}'


def main():
    for case in CASES:
        check(case)
        check(case, is_stopped=True)
        check(case, time='virtual')
    nothing = audit([])
    assert nothing == ('', 3), nothing


main()
