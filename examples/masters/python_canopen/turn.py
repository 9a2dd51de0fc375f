"""Turns the axis of node 5 to 3000 rpm and stops it again: turn.py [EDS], with python-canopen"""

import pathlib
import queue
import sys

import canopen

NODE = 5
RPM_3000 = 209_715_200  # increments/s
STATE = 0x6F  # the bits of the statusword that tell the state
PATIENCE = 20  # s
EDS = pathlib.Path(__file__).parents[3] / 'eds/axisd.eds'


def main(eds):
    network = canopen.Network()
    node = network.add_node(NODE, eds)
    network.connect(channel='vcan0', interface='socketcan')
    try:
        turn(node)
    finally:
        network.disconnect()


def turn(node):
    node.sdo.RESPONSE_TIMEOUT = 1
    node.emcy.add_callback(lambda error: print(f'EMCY {error.code:04X}h', error.data.hex()))
    print('device', node.sdo[0x1008].raw, node.sdo[0x100A].raw)

    command, answer = node.rpdo[2], node.tpdo[2]  # controlword and target velocity; statusword and actual velocity
    command.read()
    answer.read()
    received = queue.Queue()  # a frame that comes between two looks is not lost
    answer.add_callback(lambda pdo: received.put((pdo['Statusword'].raw, pdo['Velocity Actual Value'].raw)))

    def send(controlword, velocity):
        command['Controlword'].raw = controlword
        command['Target Velocity'].raw = velocity
        command.transmit()

    def wait(holds):
        while not holds(*received.get(timeout=PATIENCE)):
            pass

    node.nmt.state = 'OPERATIONAL'
    for controlword, state in (0x06, 0x21), (0x07, 0x23), (0x0F, 0x27):  # shutdown, switch on, enable operation
        send(controlword, 0)
        wait(lambda statusword, _: statusword & STATE == state)
    send(0x0F, RPM_3000)
    wait(lambda _, velocity: abs(velocity - RPM_3000) < RPM_3000 / 1000)
    print('actual velocity', node.sdo[0x606C].raw)
    send(0x06, 0)  # OFF1: ramp down
    wait(lambda statusword, _: statusword & STATE == 0x21)


main(sys.argv[1] if len(sys.argv) > 1 else str(EDS))
