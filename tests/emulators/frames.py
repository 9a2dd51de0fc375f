"""What passes between a guest and the bus: frames of every kind, and floods: frames.py BIN-FOLDER

To be run by with-can, on a bus of its own.
"""

import sys

from guest import Guest, LISTENING, PATIENCE, write_script
import programs
from master import can

FLOOD = 2000
SENT = ['18FF1234#1122', '123#', '00000123#0102030405060708', '321#R', '321#R4', '18FF1234#R']
ANSWERING = LISTENING + rf'''
for frame in {' '.join(SENT)}; do cansend can0 "$frame"; done
until heard 1EE#; do sleep 0.1; done
sed 's/.* //' log
echo end
cangen can0 -g 0 -p 10 -n {FLOOD} -I 100 -L 8 -D i
until heard 1EF#; do sleep 0.1; done
cansend can0 1F0#
'''
RECEIVED = [
    can.Message(arbitration_id=0x01ABCDEF, data=[1, 2]),
    can.Message(arbitration_id=0x456, is_extended_id=False, data=range(8)),
    can.Message(arbitration_id=0x321, is_extended_id=False, is_remote_frame=True),
    can.Message(arbitration_id=0x01ABCDEF, is_remote_frame=True),
    can.Message(arbitration_id=0x004, is_error_frame=True, data=[0, 0x30, 0, 0, 0, 0, 0, 0]),
]
SHOWN = ['01ABCDEF#0102', '456#0001020304050607', '321#R', '01ABCDEF#R']  # an error frame is none for the controller


def as_sent(message):
    """A message of python-can as cansend writes it."""
    identifier = f'{message.arbitration_id:0{8 if message.is_extended_id else 3}X}'
    if message.is_remote_frame:
        return f'{identifier}#R{message.dlc or ""}'
    return f'{identifier}#{message.data.hex().upper()}'


def receive(bus):
    message = bus.recv(PATIENCE)
    assert message, 'nothing has come from the guest'
    return message


def main():
    with programs.Folder(sys.argv[1]) as folder, can.Bus('vcan0', interface='socketcan') as bus:
        with Guest(sys.argv[1], write_script(folder, 'answer.sh', ANSWERING)) as guest:
            came = [as_sent(receive(bus)) for _ in SENT]
            assert came == SENT, f'the bus has carried {came}'
            for message in RECEIVED:  # not more at once than the controller has room for
                bus.send(message)
            bus.send(can.Message(arbitration_id=0x1EE, is_extended_id=False))
            shown = []
            while not shown or shown[-1] != 'end':
                shown.append(guest.line())
            assert shown == [*SENT, *SHOWN, '1EE#', 'end'], f'the guest has seen {shown}'
            numbers = [int.from_bytes(receive(bus).data, 'little') for _ in range(FLOOD)]
            assert numbers == list(range(FLOOD)), 'frames of the guest were lost, or are not in order'
            # More at once than the controller has room for: it loses some, and goes on.
            for number in range(FLOOD):
                bus.send(can.Message(arbitration_id=0x300, is_extended_id=False, data=number.to_bytes(2, 'little')))
            answer = None
            while not answer:
                bus.send(can.Message(arbitration_id=0x1EF, is_extended_id=False))
                answer = bus.recv(1)
            assert as_sent(answer) == '1F0#', f'the guest has sent {answer}'
            guest.output()


main()
