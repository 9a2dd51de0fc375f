"""Masters with one mistake each, and canopen-audit beside them: wrong_masters.py BIN-FOLDER [MASTER]

Each runs on a bus of its own in virtual time, with a unit; without MASTER all of them do, and each has to be found by
the rule that is meant and by no other.
"""

import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys
import unittest

import programs
from masters import can_master, wrong

BIN = pathlib.Path(sys.argv[1])
EDS = {'s120': 'axisd-servo.eds', 'cia402': 'axisd-cia402.eds'}
LIMIT = 100  # s
AT_ONCE = 4


def audit(name):
    """Runs a master in the time of the bus; what was found goes to standard output."""
    _, profile, master = wrong.MASTERS[name]
    bus = f'unix:{os.environ["CAN_BUS"]}'
    with programs.Folder(BIN) as folder:
        report = folder.path('report.json')
        auditor = folder.start('canopen-audit', '--interface', bus, '--json', report, '--eds',
                               f'5:{BIN.parent}/share/axisd/eds/{EDS[profile]}')
        auditor.expect('listening on ')
        bus_of_master = can_master.CanMaster()
        folder.start('axisd', '--interface', bus, '--node-id', '5', '--profile', profile)
        bus_of_master.expect(0x705, lambda data: data == b'\0', programs.PATIENCE)
        master(bus_of_master)
        bus_of_master.wait(0.2)
        auditor.process.send_signal(2)
        auditor.process.wait(programs.PATIENCE)
        with open(report, encoding='utf-8') as file:
            print(json.dumps(json.load(file)['findings']))


def found_beside(name):
    words = [BIN / 'with-can', '--private', '--time', 'virtual', '--', sys.executable, __file__, BIN, name]
    ran = subprocess.run(words, capture_output=True, text=True, timeout=LIMIT, check=False)
    return json.loads(ran.stdout) if ran.returncode == 0 else ran.stderr


class WrongMasters(unittest.TestCase):
    def test_each_is_found_by_its_rule_alone(self):
        with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
            for name, found in zip(wrong.MASTERS, pool.map(found_beside, wrong.MASTERS)):
                with self.subTest(name):
                    self.assertIsInstance(found, list, found)
                    self.assertEqual({finding['rule'] for finding in found}, {wrong.MASTERS[name][0]}, json.dumps(found, indent=1))

    def test_they_are_many(self):
        self.assertGreaterEqual(len({rule for rule, _, _ in wrong.MASTERS.values()}), 50)


if __name__ == '__main__':
    if len(sys.argv) > 2:
        audit(sys.argv[2])
    else:
        unittest.main(argv=sys.argv[:1])
