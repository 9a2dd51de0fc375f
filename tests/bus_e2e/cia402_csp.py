"""examples/masters/cia402/csp.py with eight axes before axisd: cia402_csp.py BIN-FOLDER EDS-OF-EIGHT-AXES CSP.PY

On the bus of with-can, or on SocketCAN's vcan0, with a SYNC less often there: a machine that has it may be emulated. It asserts
nothing that a machine could not keep which stands still for a while: missing set-points and following errors are no fault
here, and an axis that has missed some catches up at no more than 607Fh; each SYNC has its answers, and all axes end where they
began.
"""

import os
import re
import subprocess
import sys

import cia402_unit as unit
import programs
from cia402_unit import READY, REVOLUTION
from master import NODE

AXES = 8
SECONDS, WAY = 2, 1  # revolutions, in one second: at most pi / 2 revolutions/s
FASTEST = 4 * REVOLUTION
WINDOW = REVOLUTION // 8  # the axes run out without torque
PERIOD = 1 if 'CAN_BUS' in os.environ else 50  # ms
NO_MONITORING = 0xFFFFFFFF  # of the following error, 6065h


def course(master, script):
    # Cyclic frames are not for this master.
    master.bus.bus.set_filters([{'can_id': 0x580 + NODE, 'can_mask': 0x7FF}])
    for axis in range(1, AXES + 1):
        master.put(0x6065, NO_MONITORING, axis=axis)
        master.put(0x607F, FASTEST, axis=axis)
    before = [master.get(0x6064, axis=axis) for axis in range(1, AXES + 1)]
    for motion in 'sin2', 'trapezoid':
        run = subprocess.run([sys.executable, script, '--axes', str(AXES), '--seconds', str(SECONDS), '--way', str(WAY),
                              '--motion', motion, '--period', str(PERIOD)],
                             stdout=subprocess.PIPE, text=True, timeout=8 * programs.PATIENCE, check=False)
        print(run.stdout)
        assert run.returncode == 0, f'exit status {run.returncode}'
        assert re.search(rf'^\d+ SYNCs to {AXES} axes', run.stdout, re.MULTILINE)
        assert re.search('^answers that did not come: 0;', run.stdout, re.MULTILINE)
        while master.bus.recv(0.1) is not None:  # what csp.py has asked for
            pass
        for axis, position in enumerate(before, 1):
            assert unit.is_in(READY, master.get(0x6041, axis=axis)) and master.get(0x603F, axis=axis) == 0
            seen = master.get(0x6064, axis=axis)
            assert abs(seen - position) <= WINDOW, f'axis {axis}: {seen}, began at {position}'


def main():
    bin_folder, eds_path, script = sys.argv[1:]
    unit.run(bin_folder, eds_path, lambda master: course(master, script), axes=[{}] * AXES, missed_setpoints=0)


main()
