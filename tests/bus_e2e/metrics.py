"""What axisd-http serves at /metrics against what candump has seen: metrics.py BIN-FOLDER

To be run by with-can, on a bus of its own. A unit is asked, switched on, turned, given faults and switched off again; when it rests,
the counters have to be those of the frames on the bus.
"""

import collections
import http.client
import os
import re
import subprocess
import sys
import time

import programs

NODE = 5
# What the test sends; everything else on the bus is the unit's.
OF_MASTER = {0x000, 0x200 + NODE, 0x300 + NODE, 0x600 + NODE}
SDO_RESPONSE = 0x580 + NODE
CONTROLWORDS = ('0600', 'Ready to switch on'), ('0700', 'Switched on'), ('0F00', 'Operation enabled')
PROBE = 0x7FF


def samples_of(text):
    """Every sample of an exposition: its name and labels as they stand there, and its value."""
    samples = {}
    for line in text.splitlines():
        if line.startswith('#'):
            continue
        name, value = line.rsplit(' ', 1)
        assert name not in samples, f'{name} comes twice'
        samples[name] = float(value)
    return samples


def frames_in(log):
    """Identifiers and data of the frames, without the probes."""
    with open(log, encoding='ascii') as file:
        found = re.findall(r' ([0-9A-F]{3})#([0-9A-F]*)$', file.read(), re.MULTILINE)
    return [(int(identifier, 16), bytes.fromhex(data)) for identifier, data in found if int(identifier, 16) != PROBE]


def send(*frames):
    for frame in frames:
        subprocess.run(['cansend', 'vcan0', frame], check=True, timeout=programs.PATIENCE)


def expected(frames, unit):
    """The samples that FRAMES stand for."""
    name = f'{{unit="{unit}"'
    by_master = sum(identifier in OF_MASTER for identifier, _ in frames)
    wanted = {f'axisd_frames_received_total{name}}}': by_master,
              f'axisd_frames_sent_total{name}}}': len(frames) - by_master}
    results = collections.Counter(
        f'0x{int.from_bytes(data[4:], "little"):08X}' if data[0] == 0x80 else 'ok'
        for identifier, data in frames if identifier == SDO_RESPONSE)
    for result, count in results.items():
        wanted[f'axisd_sdo_response_frames_total{name},server="0",result="{result}"}}'] = count
    return wanted


def main():
    bin_folder = sys.argv[1]
    with programs.Folder(bin_folder) as folder:
        log = folder.candump(PROBE)
        control = folder.path('control.sock')
        unit = folder.start('axisd', '--interface', f'unix:{os.environ["CAN_BUS"]}', '--node-id', str(NODE), '--control', control,
                            '--state-directory', folder.path('state'))
        unit.expect(f'ready: node {NODE} on')
        gateway = folder.start('axisd-http', '--listen', '127.0.0.1:0', '--socket', control, '--token-file', folder.path('token'))
        port = int(gateway.expect(r'http://127[.]0[.]0[.]1:([0-9]+)')[1])

        def metrics():
            connection = http.client.HTTPConnection('127.0.0.1', port, timeout=programs.PATIENCE)
            connection.request('GET', '/metrics')
            answer = connection.getresponse()
            text = answer.read().decode()
            assert answer.status == 200, text
            assert answer.getheader('Content-Type').startswith('text/plain; version=0.0.4'), answer.getheader('Content-Type')
            return samples_of(text)

        def wait_for(wanted, what):
            deadline = time.monotonic() + programs.PATIENCE
            while True:
                present = metrics()
                missing = {name: (value, present.get(name)) for name, value in wanted().items() if present.get(name) != value}
                if not missing:
                    return present
                assert time.monotonic() < deadline, f'{what}: expected and shown: {missing}'
                time.sleep(0.1)

        deadline = time.monotonic() + programs.PATIENCE
        while not (found := re.search(r'axisd_up\{unit="([^"]+)"\}', '\n'.join(metrics()))):
            assert time.monotonic() < deadline, 'the gateway has not found the unit'
        name = found[1]
        axis = f'{{unit="{name}",axis="1",name="X"'
        send('605#4000100000000000', '605#40F0FF0000000000', '605#40F0FF0000000000', '605#2B41600001000000', '000#0105')
        for word, state in CONTROLWORDS:
            send(f'205#{word}')
            wait_for(lambda state=state: {f'axisd_axis_state{axis},state="{state}"}}': 1}, state)
        send('305#0F0000002000')  # 30 rpm
        wait_for(lambda: {f'axisd_axis_state{axis},state="Operation enabled"}}': 1,
                          f'axisd_nmt_state{{unit="{name}",state="Operational"}}': 1}, 'on')
        for _ in range(3):
            folder.output_of('axisctl', '--socket', control, 'fault', 'inject', '1', '7860')
            folder.output_of('axisctl', '--socket', control, 'fault', 'ack', '1')
        folder.output_of('axisctl', '--socket', control, 'fault', 'inject', '1', '7861')
        shown = wait_for(lambda: {
            f'axisd_axis_state{axis},state="Fault"}}': 1,
            f'axisd_messages_active{{unit="{name}",axis="1",kind="fault"}}': 1,
            f'axisd_messages_total{{unit="{name}",drive_object="2",kind="fault",code="F07860"}}': 3,
            f'axisd_messages_total{{unit="{name}",drive_object="2",kind="fault",code="F07861"}}': 1}, 'faults')
        assert shown[f'axisd_cycles_total{{unit="{name}"}}'] > 0
        turns = shown[f'axisd_cycle_duration_seconds_count{{unit="{name}"}}']
        assert turns == shown[f'axisd_cycle_duration_seconds_bucket{{unit="{name}",le="+Inf"}}'] > 0
        folder.output_of('axisctl', '--socket', control, 'fault', 'ack', '1')
        # Motor and bus come to rest; then all that has been sent has been seen.
        final = wait_for(lambda: expected(frames_in(log), name), 'frames')
        results = {re.search('result="([^"]+)"', key)[1]: value for key, value in final.items() if key.startswith('axisd_sdo')
                   and 'server="0"' in key}
        assert results == {'ok': 1, '0x06020000': 2, '0x06010002': 1}, results
        assert gateway.end() == 0
        assert wait_until_gone(unit, folder, control) == 0


def wait_until_gone(unit, folder, control):
    folder.output_of('axisctl', '--socket', control, 'quit')
    return unit.process.wait(programs.PATIENCE)


main()
