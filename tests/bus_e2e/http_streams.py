"""Streams of axisd-http against what axisctl sees: http_streams.py BIN-FOLDER"""

import json
import select
import subprocess
import sys
import time

import http_client
import programs


def values(event):
    """What of an event does not depend on who is told."""
    return {key: value for key, value in event.items() if key != 't'}


def check_events(folder, gateway, unit):
    """Viewers and axisctl are told the same."""
    name = unit.split('/units/')[1]
    monitor = subprocess.Popen([f'{folder.bin_folder}/axisctl', '--json', 'monitor'], env=folder.environment,
                               stdout=subprocess.PIPE, text=True)
    with gateway.stream('/api/v1/events') as all_events, \
            gateway.stream(f'/api/v1/events?kinds=fault&unit={name}') as faults, \
            gateway.stream('/api/v1/events?unit=nowhere/7') as nothing:
        for stream in (all_events, faults, nothing):
            assert stream.expect('units')['units'] == [name]
        # Until both listen: what is written is told to whoever listens by then.
        number = 0.5
        while not select.select([monitor.stdout], [], [], 0.2)[0]:
            number += 0.25
            assert gateway.request('PUT', f'{unit}/parameters/p1121', {'value': number})[0] == 200
        while json.loads(monitor.stdout.readline()).get('value') != number:
            pass
        all_events.expect('event', parameter='p1121[0]', value=number)
        folder.output_of('axisctl', 'fault', 'inject', '1', '7860')
        folder.output_of('axisctl', 'fault', 'ack', '1')
        assert gateway.request('PUT', f'{unit}/parameters/p1120', {'value': 7})[0] == 200
        theirs, mine = [], []
        while not theirs or theirs[-1].get('parameter') != 'p1120[0]':
            theirs.append(json.loads(monitor.stdout.readline()))
        while not mine or mine[-1].get('parameter') != 'p1120[0]':
            mine.append(all_events.expect('event'))
        assert [values(event) for event in mine] == [values(event) for event in theirs], (mine, theirs)
        of_faults = [values(event) for event in mine if event['kind'] == 'fault']
        assert [values(faults.expect('event')) for _ in of_faults] == of_faults and len(of_faults) == 2
        nothing.socket.settimeout(0.5)
        try:
            assert nothing.next() is None
        except TimeoutError:
            pass
    monitor.kill()
    monitor.wait()


def read_values(folder, signals):
    read = json.loads(folder.output_of('axisctl', '--json', 'signal', 'read', *signals))
    return [each['value'] for each in read['signals']]


def check_samples(folder, gateway, unit):
    """Samples are what the signals are."""
    signals = ['1/speed', 'dc_voltage']
    with gateway.stream(f'{unit}/samples?signals={",".join(signals)}&period_ms=20') as stream:
        assert stream.expect('signals')['signals'] == signals
        samples = [stream.expect('sample') for _ in range(5)]
        deadline = time.monotonic() + programs.PATIENCE
        # When the unit has come to rest, they are the same.
        while samples[-1]['values'] != (values_read := read_values(folder, signals)):
            assert time.monotonic() < deadline, (samples, values_read)
            samples.append(stream.expect('sample'))
    assert all(later['t'] > earlier['t'] for earlier, later in zip(samples, samples[1:])), samples
    assert gateway.code('GET', f'{unit}/samples?signals=1/dance&period_ms=20') == (404, 'not-found')
    assert gateway.code('GET', f'{unit}/samples?signals=1/speed') == (400, 'bad-parameter')


def check_coming_and_going(folder, gateway, unit, daemon):
    """A daemon that ends and comes back is there again, and viewers are told."""
    with gateway.stream('/api/v1/events') as events, \
            gateway.stream(f'{unit}/samples?signals=1/speed&period_ms=20') as samples:
        assert events.expect('units')['units']
        samples.expect('sample')
        assert gateway.request('POST', f'{unit}/quit')[0] == 200
        samples.expect('ended')
        assert events.expect('units')['units'] == []
        assert gateway.code('GET', unit) == (503, 'no-daemon')
        assert daemon.process.wait(programs.PATIENCE) == 0  # its names are free again
        programs.start_unit(folder)
        assert events.expect('units')['units']
        assert gateway.request('GET', unit)[2]['nmt_state'] == 'Pre-operational'
        assert gateway.request('POST', f'{unit}/axes/1/faults', {'number': 7860})[0] == 200
        assert events.expect('event', kind='fault')['number'] == 7860


def main():
    with programs.Folder(sys.argv[1]) as folder:
        daemon = programs.start_unit(folder)
        gateway = http_client.Gateway(folder)
        unit = gateway.unit()
        check_events(folder, gateway, unit)
        check_samples(folder, gateway, unit)
        check_coming_and_going(folder, gateway, unit, daemon)
        assert gateway.program.end() == 0


if __name__ == '__main__':
    main()
