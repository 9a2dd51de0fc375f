"""Two guests on one bus hear each other and a unit: two_guests.py BIN-FOLDER

To be run by with-can, on a bus of its own.
"""

import re
import sys

from guest import Guest, LISTENING, write_script
import programs
from master import can

FRAMES = 20  # of each guest
# A guest sends until it hears the other one, then a frame for each of the other's, so that neither overruns the other; then it
# asks the unit for its vendor. $1: its own identifier, $2: that of the other.
SPEAKING = LISTENING + rf"""
until heard $2#.*; do cansend can0 $1#; sleep 0.2; done
for ((n = 0; n < {FRAMES}; ++n)); do
  number=$(printf %02X $n)
  cansend can0 $1#$number
  until heard $2#$number; do sleep 0.01; done
done
cansend can0 605#4018100100000000
until [[ $(grep -c ' 585#43181001' log) == 2 ]]; do sleep 0.1; done
cat log
"""
IDENTIFIERS = ('111', '222')


def frames_on(bus):
    """What the bus has carried, as cansend writes it."""
    while message := bus.recv(0):
        yield f'{message.arbitration_id:03X}#{message.data.hex().upper()}'


def main():
    with programs.Folder(sys.argv[1]) as folder, can.Bus('vcan0', interface='socketcan') as bus:
        programs.start_unit(folder)
        script = write_script(folder, 'speak.sh', SPEAKING)
        with Guest(sys.argv[1], script, *IDENTIFIERS) as one, Guest(sys.argv[1], script, *reversed(IDENTIFIERS)) as other:
            logs = one.output(), other.output()
        carried = list(frames_on(bus))
    for log, own, foreign in zip(logs, IDENTIFIERS, reversed(IDENTIFIERS)):
        heard = [line.split()[2] for line in log if re.match(r'\(\d', line)]
        numbers = [frame for frame in heard if re.fullmatch(foreign + '#[0-9A-F]{2}', frame)]
        assert numbers == [f'{foreign}#{number:02X}' for number in range(FRAMES)], f'{own} has heard {numbers}'
        # A controller shows its own frames when it has sent them; those of all others come in the order of the bus.
        before = next(n for n, frame in enumerate(carried) if frame == numbers[0])
        others = [frame for frame in carried[before:] if not frame.startswith((own, '605'))]
        theirs = [frame for frame in heard if not frame.startswith((own, '605'))]
        theirs = theirs[theirs.index(numbers[0]):]
        assert theirs == others[:len(theirs)], f'{own} has heard {theirs}, the bus carried {others}'


main()
