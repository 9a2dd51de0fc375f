"""Homes the axis of node 5, which has "profile": "cia402", and positions it: move.py [EDS], with python-canopen"""

import pathlib
import sys
import time

import canopen
from canopen.profiles.p402 import BaseNode402

NODE = 5
REVOLUTION = 65536  # position units, as delivered
SPEED = 10 * REVOLUTION  # units/s
INDEX_POSITIVE = 34  # homing method: the next index of the encoder in positive direction
START, IMMEDIATELY = 0x10, 0x20  # controlword, mode 1
REACHED, ACKNOWLEDGED = 1 << 10, 1 << 12  # statusword
PATIENCE = 20  # s
EDS = pathlib.Path(__file__).parents[4] / 'eds/axisd-cia402.eds'


def until(node, holds, what):
    """Waits until the statusword, as SDO tells it now, says so."""
    end = time.monotonic() + PATIENCE
    while not holds(node.check_statusword()):
        if time.monotonic() > end:
            raise SystemExit(f'waited in vain for {what}')


def map_pdos(node):
    """Controlword and mode in one RPDO: BaseNode402 writes 6060h by the first one that has it, with all else that is mapped
    there, and in RPDO 2 as delivered that is a controlword of 0."""
    node.rpdo.read()
    node.rpdo[2].enabled = False
    node.rpdo[1].clear()
    node.rpdo[1].add_variable('Controlword')
    node.rpdo[1].add_variable('Modes of operation')
    node.rpdo[1].enabled = True
    node.rpdo[2].save()
    node.rpdo[1].save()


def home(node):
    node.sdo['Homing method'].raw = INDEX_POSITIVE
    node.sdo['Homing speeds'][2].raw = REVOLUTION
    if not node.homing(timeout=PATIENCE):
        raise SystemExit('homing has failed')
    until(node, lambda statusword: statusword & REACHED, 'rest')
    node.controlword = 0x0F
    print('homed')


def move(node, target):
    """The handshake of mode 1."""
    node.sdo['Target position'].raw = target
    node.controlword = 0x0F | START | IMMEDIATELY
    until(node, lambda statusword: statusword & ACKNOWLEDGED, 'bit 12 of 6041h')
    node.controlword = 0x0F
    until(node, lambda statusword: statusword & REACHED, f'position {target}')
    print('position', round(node.sdo['Position actual value'].raw / REVOLUTION, 2))


def run(node):
    node.sdo.RESPONSE_TIMEOUT = 1
    node.emcy.add_callback(lambda error: print(f'EMCY {error.code:04X}h', error.data.hex()))
    print('device', node.sdo[0x1008].raw)
    map_pdos(node)
    node.setup_402_state_machine()  # in Pre-operational: it reads all PDOs over SDO
    node.nmt.state = 'OPERATIONAL'
    node.sdo['Profile velocity'].raw = SPEED
    home(node)  # selects mode 6 and enables the axis
    node.op_mode = 'PROFILED POSITION'
    for revolutions in 10, -2:
        move(node, revolutions * REVOLUTION)
    node.state = 'READY TO SWITCH ON'


def main(eds):
    network = canopen.Network()
    node = BaseNode402(NODE, eds)
    network.add_node(node)
    network.connect(channel='vcan0', interface='socketcan')
    try:
        node.nmt.state = 'PRE-OPERATIONAL'
        run(node)
    finally:
        network.disconnect()


main(sys.argv[1] if len(sys.argv) > 1 else str(EDS))
