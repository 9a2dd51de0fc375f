"""python-can's udp_multicast bus against axisd: python_can_udp.py BIN-FOLDER GROUP

To be run in a network of its own (own_network.sh).
"""

import json
import socket
import sys

import programs
from master import BOOT_UP, Master, can, drive

PORT = 43113


def disturb(group):
    """Sends what is no frame to the group."""
    family = socket.AF_INET6 if ':' in group else socket.AF_INET
    with socket.socket(family, socket.SOCK_DGRAM) as anybody:
        for datagram in (b'', b'\xc1', b'\x91' * 1000, b'\x91' * 9000, b'x' * 100):
            anybody.sendto(datagram, (group, PORT))
    return 5


def main():
    bin_folder, group = sys.argv[1:]
    host = f'[{group}]' if ':' in group else group
    url = f'udp-multicast://{host}:{PORT}'
    # python-can gives up a bus that has received what is no frame, so it joins when that has passed.
    with programs.Folder(bin_folder) as folder:
        unit = folder.start('axisd', '--interface', url, '--node-id', '5')
        unit.expect('ready: node 5 on udp-multicast://')
        disturbances = disturb(group)
        with can.Bus(interface='udp_multicast', channel=group, port=PORT) as bus:
            master = Master(bus)
            master.send(0x000, '8105')
            master.expect(*BOOT_UP)
            drive(master)
        status = json.loads(folder.output_of('axisctl', '--interface', url, '--node-id', '5', '--json', 'status'))
        assert status['interface'] == url, status
        assert status['bus']['dropped'] == disturbances, status['bus']
        assert unit.end() == 0


main()
