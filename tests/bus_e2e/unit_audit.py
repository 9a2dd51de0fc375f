"""A unit that judges its master, and what axisctl tells of that: unit_audit.py BIN-FOLDER"""

import re
import subprocess
import sys
import unittest

import programs
from masters import can_master

BIN = sys.argv[1]
NODE = 5
REFUSED = 3  # exit status


def axisctl(folder, *words):
    """What it prints, what it complains of, and its exit status."""
    ran = subprocess.run([f'{BIN}/axisctl', *words], env=folder.environment, capture_output=True, text=True,
                         timeout=programs.PATIENCE, check=False)
    return ran.stdout, ran.stderr, ran.returncode


class AuditedUnit(unittest.TestCase):
    def setUp(self):
        self.folder = self.enterContext(programs.Folder(BIN))
        self.master = can_master.CanMaster()
        self.addCleanup(self.master.socket.close)

    def test_tells_what_its_master_has_done_wrong_with_the_frames(self):
        programs.start_unit(self.folder, audit=True)
        master = self.master
        master.start(NODE)
        for _ in range(3):
            master.send(0x205, '06')
            master.wait(0.01)
        master.try_to_write(NODE, 0x1000, 0, 0x12345678, 4)
        printed, _, status = axisctl(self.folder, 'audit')
        self.assertEqual(status, 0)
        self.assertRegex(printed, r'error +object[.]read-only [(]CiA 301 7[.]4[.]2[)]: .*, once\n'
                                  r' +node 5: 1000h:00 [(]Device Type[)] = 12345678h [(]4 bytes[)], abort 06010002h [(]read only[)]\n'
                                  r' +[(]\d+[.]\d{6}[)] can0 605#2300100078563412\n'
                                  r' +[(]\d+[.]\d{6}[)] can0 585#8000100002000106\n')
        self.assertRegex(printed, r'error +pdo[.]short .*, 3 times\n')
        self.assertRegex(printed, r'\n\d+ frames; errors 4, warnings 0\n$')
        of_one, _, _ = axisctl(self.folder, 'audit', 'pdo.short')
        self.assertEqual(len(re.findall(r'can0 205#06\n', of_one)), 3)
        reasons, _, _ = axisctl(self.folder, 'explain', '1')
        self.assertIn('The master has broken rules of CANopen 4 times since the start: axisctl audit shows which.\n', reasons)

    def test_that_judges_nobody_says_so(self):
        programs.start_unit(self.folder)
        self.master.try_to_write(NODE, 0x1000, 0, 0, 4)
        printed, complaint, status = axisctl(self.folder, 'audit')
        self.assertEqual((printed, status), ('', REFUSED))
        self.assertIn('the unit is not audited: expected "audit": true in its configuration', complaint)
        self.assertNotIn('The master', axisctl(self.folder, 'explain', '1')[0])


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1])
