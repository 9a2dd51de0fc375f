"""A card with two controllers on one wire, made interfaces by a script of examples/emulators:
two_controllers.py BIN-FOLDER DEVICE SCRIPT

To be run by with-can, on a bus of its own.
"""

import os
import sys

from guest import EXAMPLES, Guest, write_script
import programs

# One asks the unit for its device type; the other one hears the question, and both hear the answer. The controllers share an
# interrupt, and qemu takes it back when one of them has been served: the other's frame may wait for the next one.
ASKING = r'''
set -eu
. ./$1
for can in can0 can1; do ip link set $can up type can bitrate 500000; done
candump -L any >log &
until grep -qE '^ *any ' /proc/net/can/rcvlist_all; do sleep 0.1; done
heard() { grep -q "$1" log; }
until heard 'can0 605#4000100000000000' && heard 'can0 585#430010009201FFFF' && heard 'can1 585#430010009201FFFF'; do
  cansend can1 605#4000100000000000
  sleep 1
done
'''


def main():
    _, bin_folder, device, script = sys.argv
    with programs.Folder(bin_folder) as folder:
        programs.start_unit(folder)
        options = ('--device', device, '--file', os.path.join(EXAMPLES, script))
        with Guest(bin_folder, write_script(folder, 'ask.sh', ASKING), script, options=options) as guest:
            guest.output()


main()
