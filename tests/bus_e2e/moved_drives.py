"""canopen-check --allow-motion against axisd on the bus of with-can: moved_drives.py BIN-FOLDER EDS-FOLDER PROFILE AXES

No check fails (of the unit: of drives, another test has the others), those of drives that the profile offers have run, and every axis is
disabled afterwards with the mode that it had. Both measure by the clock of a machine that may stand still meanwhile: what fails is looked at again.
"""

import json
import os
import subprocess
import sys

import programs

NODE = 5
TRIES = 6
# What the unit does not have: positions, and what is said of a quick stop.
NOT_OF_S120 = {'drive.quick-stop-transitions', 'drive.halt-positioning', 'drive.set-point-acknowledge', 'drive.set-point-edge',
               'drive.target-reached', 'drive.relative', 'drive.change-immediately', 'drive.set-point-order', 'drive.old-set-point',
               'drive.homing', 'drive.homing-method', 'drive.software-limits', 'drive.max-profile-velocity', 'drive.max-motor-speed'}
PROFILES = {'s120': ('axisd', NOT_OF_S120), 'cia402': ('axisd-cia402', set())}


def upload(index):
    """Reads :00 of INDEX over SDO, up to four bytes."""
    request = f'{0x600 + NODE:03X}#40{index & 0xFF:02X}{index >> 8:02X}0000000000'
    listener = subprocess.Popen(['candump', '-L', '-n', '1', '-T', str(1000 * programs.PATIENCE), f'vcan0,{0x580 + NODE:X}:7FF'],
                                stdout=subprocess.PIPE, text=True)
    try:
        while True:
            subprocess.run(['cansend', 'vcan0', request], check=True, timeout=programs.PATIENCE)
            try:
                line = listener.communicate(timeout=0.5)[0]
                break
            except subprocess.TimeoutExpired:
                continue
    finally:
        listener.kill()
    data = bytes.fromhex(line.split('#')[1])
    assert data[0] & 0xE0 == 0x40 and data[1] | data[2] << 8 == index, line
    return int.from_bytes(data[4:8 - (data[0] >> 2 & 3)], 'little')


def check(folder, eds, options):
    """Runs canopen-check: its report, and its output."""
    report = folder.path('report.json')
    run = subprocess.run([os.path.join(folder.bin_folder, 'canopen-check'), '--interface', f'unix:{os.environ["CAN_BUS"]}',
                          '--node', str(NODE), '--eds', eds, '--json', report, '--allow-motion', *options],
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=15 * programs.PATIENCE)
    with open(report, encoding='utf-8') as file:
        return json.load(file), run.stdout


def is_good(name, outcome, absent):
    """Whether the check NAME may end so; of drives, those of ABSENT alone may be skipped."""
    return outcome in ('passed', 'deviation') or (outcome == 'skipped' and (name in absent or not name.startswith('drive.')))


def main():
    bin_folder, eds_folder, profile, axes = sys.argv[1:]
    name, absent = PROFILES[profile]
    eds = os.path.join(eds_folder, f'{name}.eds' if axes == '1' else f'{name}-{axes}-axes.eds')
    options = ['--deviations', os.path.join(eds_folder, 'axisd-deviations.json')] if profile == 's120' else []
    with programs.Folder(bin_folder) as folder:
        with open(folder.path('node.json'), 'w', encoding='utf-8') as file:
            json.dump({'profile': profile, 'node_id': NODE, 'axes': [{} for _ in range(int(axes))]}, file)
        axisd = folder.start('axisd', '--interface', f'unix:{os.environ["CAN_BUS"]}', '--config', folder.path('node.json'),
                             '--control', folder.path('control.sock'), '--state-directory', folder.path('state'))
        axisd.expect('ready')
        modes = [upload(0x6060 + 0x800 * axis) for axis in range(int(axes))]
        doubtful, outcomes = 'drive' if profile == 's120' else '', {}
        for _ in range(TRIES):
            report, output = check(folder, eds, [*(['--only', doubtful] if doubtful else []), *options])
            outcomes.update({result['id']: result['outcome'] for result in report['results']})
            assert not report['not_restored'], report['not_restored']
            doubtful = ','.join(each for each, outcome in outcomes.items() if not is_good(each, outcome, absent))
            if not doubtful:
                break
        assert not doubtful, f'{doubtful}\n{output}'
        for axis in range(int(axes)):
            assert upload(0x6060 + 0x800 * axis) == modes[axis], axis
            assert upload(0x6040 + 0x800 * axis) == 0, axis
            # Leaving Operational behind a check is a fault of the unit.
            assert upload(0x6041 + 0x800 * axis) & 0x4F in ((0x40, 0x08) if profile == 's120' else (0x40,)), axis
    print(f'{len(outcomes)} checks, {sum(outcome == "skipped" for outcome in outcomes.values())} skipped')


main()
