"""python-can's socketcand bus against axisd, over the hub's server: python_can_socketcand.py BIN-FOLDER SIDE

SIDE is `unix`, where axisd is a member of the hub's bus, or `client`, where it is a client of the server too, and the
hub goes and comes once. To be run in a network of its own (own_network.sh).
"""

import sys

import programs
from master import BOOT_UP, Master, can, drive

HOST, PORT = '127.0.0.1', 29536


def start_hub(folder):
    hub = folder.start('canhub', '--path', folder.path('bus'), '--socketcand', f'{HOST}:{PORT}')
    hub.expect('ready')
    return hub


def connect():
    return can.Bus(interface='socketcand', channel='vcan0', host=HOST, port=PORT)


def main():
    bin_folder, side = sys.argv[1:]
    with programs.Folder(bin_folder) as folder:
        url = f'unix:{folder.path("bus")}' if side == 'unix' else f'socketcand://{HOST}:{PORT}/vcan0'
        hub = start_hub(folder)
        with connect() as bus:
            unit = folder.start('axisd', '--interface', url, '--node-id', '5')
            unit.expect('ready: node 5 on')
            master = Master(bus)
            master.expect(*BOOT_UP)
            drive(master)
        if side == 'client':
            hub.kill()
            unit.expect('is down')
            start_hub(folder)
            with connect() as bus:
                unit.expect('is up again')
                master = Master(bus)
                master.send(0x000, '8105')
                master.expect(*BOOT_UP)
        assert unit.end() == 0


main()
