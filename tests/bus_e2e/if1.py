"""A controller on IF1 beside a CANopen master: if1.py BIN-FOLDER

The axis is led by telegram 1 over the control socket, while the master on the bus reads what it does and finds its own
controlword without effect. To be run by with-can, on a bus of its own.
"""

import json
import os
import sys
import time

import programs
from control_client import ControlClient, ControlError
from master import BOOT_UP, NODE, Abort, Master, can

AXIS = 2  # its drive object


def main():
    with programs.Folder(sys.argv[1]) as folder, can.Bus('vcan0', interface='socketcan') as bus:
        path = folder.path('control.sock')
        # Nobody watches the controller until it is to be missed: a machine may stand still for longer than 100 ms.
        with open(folder.path('axisd.json'), 'w', encoding='ascii') as file:
            json.dump({'parameters': {'p2040': 0}}, file)
        unit = folder.start('axisd', '--interface', f'unix:{os.environ["CAN_BUS"]}', '--node-id', str(NODE),
                            '--config', folder.path('axisd.json'), '--control', path, '--state-directory', folder.path('state'))
        unit.expect('ready')
        master = Master(bus)
        control = ControlClient(path, programs.PATIENCE)

        def exchange(*words):
            return control.call('if1.exchange', do=AXIS, received=list(words))['sent']

        def exchange_until(words, wanted):
            """Exchanges until what is sent is WANTED."""
            deadline = time.monotonic() + programs.PATIENCE
            while True:
                sent = exchange(*words)
                if wanted(sent):
                    return sent
                assert time.monotonic() < deadline, (words, [hex(word) for word in sent])
                time.sleep(0.01)

        def parameter(name, value):
            control.call('parameter.write', axis=1, parameter=name, value=value)

        parameter('p1120', 0.5)
        parameter('p1121', 0.5)
        parameter('p1135', 0.5)
        parameter('p0922', 1)
        for held in ('p0840', 'p1070', 'p8790', 'p2079'):
            try:
                parameter(held, 0)
                raise AssertionError(f'{held} is not locked')
            except ControlError as refused:
                assert 'locked' in refused.args[0]['message'], refused
        master.write(0x41B6, 0, b'\x02\x00')  # p8630[0] = 2
        try:
            master.write(0x2348, 0, b'\x00\x00\x00\x00')  # p0840
            raise AssertionError('p0840 is not locked over SDO')
        except Abort as refused:
            assert refused.args[0] == 0x08000022, hex(refused.args[0])
        [reasons] = [axis['reasons'] for axis in control.call('explain')['axes']]
        assert any('IF1 commands the axis (p0922 = 1)' in reason for reason in reasons), reasons

        exchange_until((0x047E, 0), lambda sent: sent == [0xEB31, 0])
        master.send(0x000, '0105')
        master.send(0x205, '0f00')  # 6040h has no effect
        exchange_until((0x047E, 0), lambda sent: sent == [0xEB31, 0])
        exchange_until((0x047F, 0), lambda sent: sent[0] == 0xEB37)
        exchange_until((0x047F, 0x1000), lambda sent: sent[0] == 0xEF37 and abs(sent[1] - 0x1000) < 0x29)
        deadline = time.monotonic() + programs.PATIENCE
        # 750 rpm; 606Ch is smoothed, and follows.
        while abs((velocity := int.from_bytes(master.upload(0x606C), 'little', signed=True)) - 52428800) >= 524288:
            assert time.monotonic() < deadline, velocity
        exchange_until((0x047B, 0x1000), lambda sent: sent[0] & 0x0060 == 0x0040 and sent[1] < 0x10)  # OFF3
        exchange_until((0x047E, 0), lambda sent: sent[0] == 0xEB31)
        control.call('fault.inject', axis=1, number=7860)
        exchange_until((0x047E, 0), lambda sent: sent[0] & 0x0008)
        exchange_until((0x04FE, 0), lambda sent: not sent[0] & 0x0008)

        # The controller falls silent: p2040 = 100 ms.
        exchange_until((0x047E, 0), lambda sent: sent[0] == 0xEB31)
        control.call('parameter.write', axis=0, parameter='p2040', value=100)
        exchange(0x047E, 0)
        deadline = time.monotonic() + programs.PATIENCE
        while True:
            messages = control.call('fault.list', axis=1)
            if '1910' in str(messages):
                break
            assert time.monotonic() < deadline, messages
            time.sleep(0.05)

        # Records and the parameter channel see the same parameters.
        record = control.call('parameter.record', request='01010201100107D00000')
        assert record['response'] == '010102010801453B8000', record
        channel = control.call('pkw.exchange', do=AXIS, request='1000008000000000')
        assert channel['response'] == '20000080453B8000', channel
        assert unit.end() == 0


if __name__ == '__main__':
    main()
