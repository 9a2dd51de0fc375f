"""Modbus TCP beside a CANopen master: modbus.py BIN-FOLDER CLIENT

CLIENT is mbpoll, pymodbus, jsmodbus or tshark; where it is missing the test is skipped: exit status 77. "turn" moves
the axis, "taken" starts another axisd at the same port. To be run by with-can, on a bus of its own.
"""

import contextlib
import json
import os
import re
import shutil
import socket
import struct
import subprocess
import sys
import threading
import time

import programs
from control_client import ControlClient
from master import BOOT_UP, Master, can

SKIPPED = 77
DEVICE_TYPE, STATUSWORD = 0x1000, 0x6041
FIRST = 40001


def skip(reason):
    print(f'skipped: {reason} (scripts/setup.sh)')
    sys.exit(SKIPPED)


@contextlib.contextmanager
def served_unit(folder, **keys):
    """axisd as node 5 with Modbus TCP at a free port of loopback; the port."""
    with open(folder.path('axisd.json'), 'w', encoding='ascii') as file:
        json.dump({'modbus': {'port': 0}, 'parameters': {'p2040': 0}, **keys}, file)
    unit = folder.start('axisd', '--interface', f'unix:{os.environ["CAN_BUS"]}', '--node-id', '5',
                        '--config', folder.path('axisd.json'), '--control', folder.path('control.sock'))
    port = int(unit.expect(r'Modbus TCP on 127\.0\.0\.1:(\d+)').group(1))
    unit.expect('ready: node 5 on')
    yield port
    assert unit.end() == 0


class Plain:
    """Requests as bytes, without anybody's library; what goes over the connection is kept."""

    def __init__(self, port):
        self.socket = socket.create_connection(('127.0.0.1', port), timeout=programs.PATIENCE)
        self.log = []

    def ask(self, pdu):
        request = struct.pack('>HHHB', len(self.log) + 1 & 0xFFFF, 0, len(pdu) + 1, 0x11) + pdu
        self.socket.sendall(request)
        head = self._take(7)
        answer = head + self._take(struct.unpack('>H', head[4:6])[0] - 1)
        self.log += [(True, request), (False, answer)]
        return answer[7:]

    def read(self, register, count=1):
        answer = self.ask(struct.pack('>BHH', 3, register - FIRST, count))
        assert answer[:2] == bytes((3, 2 * count)), answer.hex()
        return list(struct.unpack(f'>{count}H', answer[2:]))

    def write(self, register, *values):
        head = struct.pack('>BHHB', 16, register - FIRST, len(values), 2 * len(values))
        answer = self.ask(head + struct.pack(f'>{len(values)}H', *values))
        assert answer[:5] == head[:5], answer.hex()

    def _take(self, count):
        data = b''
        while len(data) < count:
            part = self.socket.recv(count - len(data))
            assert part, 'the connection was closed'
            data += part
        return data


def wait_for(what, read, is_there):
    """Reads until the value is what it should be."""
    end = time.monotonic() + programs.PATIENCE
    while not is_there(value := read()):
        assert time.monotonic() < end, f'{what} stays {value}'
        time.sleep(0.01)
    return value


def run(words, **options):
    return subprocess.run(words, text=True, capture_output=True, timeout=3 * programs.PATIENCE, check=False, **options)


def with_mbpoll(port, _folder):
    if not shutil.which('mbpoll'):
        skip('no mbpoll')

    def mbpoll(*words):
        return run(['mbpoll', '-m', 'tcp', '-o', '10', '-p', str(port), '-0', '-1', '-q', *words[:-1], '127.0.0.1', *words[-1]])

    answer = mbpoll('-r', str(40324 - FIRST), '-c', '1', [])
    assert answer.returncode == 0 and re.search(r'3000', answer.stdout), answer
    answer = mbpoll('-r', str(40322 - FIRST), ['1500', '1200'])
    assert answer.returncode == 0, answer
    assert Plain(port).read(40322, 2) == [1500, 1200]
    answer = mbpoll('-r', str(40340 - FIRST), ['1'])
    assert answer.returncode != 0 or 'failed' in answer.stderr, answer


def with_pymodbus(port, _folder):
    try:
        from pymodbus.client import ModbusTcpClient
    except ImportError as missing:
        skip(missing)
    client = ModbusTcpClient('127.0.0.1', port=port, timeout=programs.PATIENCE)
    assert client.connect()
    assert client.read_holding_registers(40324 - FIRST, 1, slave=17).registers == [3000]
    assert not client.write_register(40322 - FIRST, 700, slave=17).isError()
    assert not client.write_registers(40322 - FIRST, [800, 900], slave=17).isError()
    assert client.read_holding_registers(40322 - FIRST, 2, slave=17).registers == [800, 900]
    refused = client.write_register(40340 - FIRST, 1, slave=17)
    assert refused.isError() and refused.exception_code == 4, refused
    assert client.read_holding_registers(40499 - FIRST, 1, slave=17).registers == [1]
    assert client.read_input_registers(0, 1, slave=17).exception_code == 1
    assert client.read_holding_registers(40722 - FIRST, 2, slave=17).exception_code == 2
    client.close()


JSMODBUS = '''
const net = require('net'), modbus = require('jsmodbus');
const socket = new net.Socket(), client = new modbus.client.TCP(socket, 17);
socket.on('connect', async () => {
  const values = async (...place) => (await client.readHoldingRegisters(...place)).response.body.valuesAsArray;
  const reference = await values(323, 1);
  await client.writeSingleRegister(321, 700);
  await client.writeMultipleRegisters(321, [800, 900]);
  const ramps = await values(321, 2);
  const code = await client.writeSingleRegister(339, 1).then(() => 0, (error) => error.response.body.code);
  console.log(JSON.stringify({reference, ramps, code}));
  socket.end();
});
socket.connect({host: '127.0.0.1', port: Number(process.argv[1])});
'''


def with_jsmodbus(port, _folder):
    if not shutil.which('node') or run(['node', '-e', "require('jsmodbus')"]).returncode != 0:
        skip('node has no module jsmodbus')
    answer = run(['node', '-e', JSMODBUS, str(port)])
    assert answer.returncode == 0, answer.stderr
    assert json.loads(answer.stdout) == {'reference': [3000], 'ramps': [800, 900], 'code': 4}, answer.stdout


def with_tshark(port, folder):
    """What goes over the connection, decoded by a program that knows nothing of axisd."""
    if not shutil.which('tshark') or not shutil.which('text2pcap'):
        skip('no tshark')
    client = Plain(port)
    client.read(40301)
    client.read(40001, 125)
    client.write(40322, 1500, 1600)
    client.write(40601, 1, 0x2F0A, 0x8001, 0x0101, 0x1001, 0x0002, 0x0000)
    wait_for('40601', lambda: client.read(40601)[0], lambda control: control == 2)
    assert client.read(40602, 4)[:3] == [0x2F08, 0x8001, 0x0101], client.read(40602, 4)
    for pdu in (b'\x04\0\0\0\1', b'\x03\0\0\0\x7e', b'\x03\x02\xd2\0\1', b'\x06\1\x53\0\1'):
        answer = client.ask(pdu)
        assert answer[0] == pdu[0] | 0x80, answer.hex()
    with open(folder.path('dump'), 'w', encoding='ascii') as dump:
        for is_request, data in client.log:
            dump.write(f'{"I" if is_request else "O"}\n000000 {data.hex(" ")}\n')
    done = run(['text2pcap', '-q', '-D', '-T', '40000,502', '-4', '127.0.0.1,127.0.0.2', folder.path('dump'),
                folder.path('pcap')])
    assert done.returncode == 0, done.stderr
    decoded = run(['tshark', '-r', folder.path('pcap'), '-d', 'tcp.port==502,mbtcp', '-V',
                   '-o', 'tcp.desegment_tcp_streams:FALSE'])
    assert decoded.returncode == 0, decoded.stderr
    assert decoded.stdout.count('Modbus/TCP') == len(client.log), decoded.stdout[-2000:]
    assert 'Malformed' not in decoded.stdout
    for text in ('Exception Code: Illegal function (1)', 'Exception Code: Illegal data value (3)',
                 'Exception Code: Illegal data address (2)', 'Write Multiple Registers (16)'):
        assert text in decoded.stdout, text


def start_another(port, folder):
    """A second axisd at the same port: one line, exit status 1."""
    with open(folder.path('other.json'), 'w', encoding='ascii') as file:
        json.dump({'modbus': {'port': port}}, file)
    other = run([os.path.join(folder.bin_folder, 'axisd'), '--interface', f'unix:{os.environ["CAN_BUS"]}', '--node-id', '6',
                 '--config', folder.path('other.json'), '--control', 'none', '--state-directory', folder.path('other')])
    assert other.returncode == 1, other
    assert other.stderr == (f'axisd: modbus 127.0.0.1:{port}: Address already in use: expected a port that nobody '
                            'serves\n'), other.stderr


CLIENTS = {'mbpoll': with_mbpoll, 'pymodbus': with_pymodbus, 'jsmodbus': with_jsmodbus,
           'tshark': with_tshark, 'taken': start_another}


def turn(port, folder, master):
    """The axis runs by process data over Modbus while a CANopen master looks on."""
    ControlClient(folder.path('control.sock'), programs.PATIENCE).call('parameter.write', axis=1, parameter='p0922', value=1)
    client = Plain(port)
    client.write(40100, 0x047E, 0)
    wait_for('ZSW1', lambda: client.read(40110)[0], lambda word: word & 0x6F == 0x21)
    client.write(40100, 0x047F, 0x1000)
    wait_for('NIST', lambda: client.read(40111)[0], lambda word: abs(word - 0x1000) < 0x40)
    statusword = int.from_bytes(master.upload(STATUSWORD)[:2], 'little')
    assert statusword & 0x6F == 0x27, hex(statusword)
    client.write(40100, 0x047E, 0)
    wait_for('NIST', lambda: client.read(40111)[0], lambda word: word < 0x40 or word > 0xFFC0)


def main():
    bin_folder, name = sys.argv[1:]
    with programs.Folder(bin_folder) as folder, can.Bus('vcan0', interface='socketcan') as bus:
        master = Master(bus)
        ramps = {'p1120': 0.2, 'p1121': 0.2}
        if name == 'turn':
            with served_unit(folder, axes=[{'parameters': ramps}]) as port:
                master.expect(*BOOT_UP)
                turn(port, folder, master)
            return
        with served_unit(folder) as port:
            master.expect(*BOOT_UP)
            over = threading.Event()

            def look():
                while not over.is_set():
                    assert master.read(DEVICE_TYPE) & 0xFFFF == 0x0192

            looking = threading.Thread(target=look)
            looking.start()
            try:
                CLIENTS[name](port, folder)
            finally:
                over.set()
                looking.join()
            assert master.read(DEVICE_TYPE) & 0xFFFF == 0x0192


if __name__ == '__main__':
    main()
