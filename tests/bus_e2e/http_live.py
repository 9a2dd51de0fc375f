"""Polls of axisd-http for samples, frames and events: http_live.py BIN-FOLDER

To be run by with-can, on a bus of its own."""

import json
import os
import re
import subprocess
import sys
import threading
import time

import http_client
import programs

PROBE = 0x7FF
SAMPLES = 'signals=1/speed,dc_voltage&period_ms=1'
WANTED = 400  # samples in a row


class Reader:
    """Who asks again and again, every PAUSE seconds."""

    def __init__(self, gateway, unit, query, pause=0.1):
        self.gateway, self.path, self.pause = gateway, f'{unit}/live?{query}', pause
        self.cursor = None
        self.lost = 0

    def ask(self):
        """Status and answer of the next poll."""
        path = self.path if self.cursor is None else f'{self.path}&after={self.cursor}'
        status, _, answer = self.gateway.request('GET', path)
        if status == 200:
            self.cursor = answer['cursor']
            self.lost += answer['lost']
        return status, answer

    def begin(self):
        status, answer = self.ask()
        assert (status, answer['samples'], answer['frames'], answer['lost'], answer['restarted']) == (200, [], [], 0, False), answer

    def lines(self, key):
        """The lines from now on, poll by poll; the test fails if none come."""
        deadline = time.monotonic() + programs.PATIENCE
        while time.monotonic() < deadline:
            status, answer = self.ask()
            assert status == 200 and not answer['restarted'], answer
            if answer[key]:
                deadline = time.monotonic() + programs.PATIENCE
            yield from answer[key]
            time.sleep(self.pause)
        raise AssertionError(f'no {key} come')


class Samples:
    """Samples that a reader has seen: each once and in its order, and none is missing but those that were said to be lost."""

    def __init__(self):
        self.times, self.values, self.in_a_row, self.missing, self.lost = [], [], 0, 0, 0

    def take(self, line, lost_lines):
        assert len(line['values']) == 2 and {len(values) for values in line['values']} == {len(line['t'])}, line
        self.lost += line['lost']
        for instant in line['t']:
            step = round((instant - self.times[-1]) * 1000, 3) if self.times else 1
            assert step >= 1 and step == int(step), (step, self.times[-3:], line)
            self.missing += 0 if lost_lines else step - 1
            assert self.missing <= self.lost, (self.missing, self.lost, self.times[-3:], line)
            lost_lines = 0
            self.in_a_row = self.in_a_row + 1 if step == 1 else 1
            self.times.append(instant)
        self.values += zip(*line['values'])


def read_samples(reader, seen):
    reader.begin()
    lost = 0
    for line in reader.lines('samples'):
        seen.take(line, reader.lost - lost)
        lost = reader.lost
        if seen.in_a_row >= WANTED:
            return


def check_samples(gateway, unit):
    """Two readers, one ten times as fast as the other one, see each sample once, in its order, and the same."""
    both = [(Reader(gateway, unit, SAMPLES, pause), Samples()) for pause in (0.02, 0.2)]
    threads = [threading.Thread(target=read_samples, args=pair) for pair in both]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    fast, slow = (dict(zip(seen.times, seen.values)) for _, seen in both)
    assert min(len(fast), len(slow)) >= WANTED, (len(fast), len(slow))
    common = fast.keys() & slow.keys()
    assert common and all(fast[instant] == slow[instant] for instant in common), 'they have seen different values'
    assert all(voltage > 0 for _, voltage in fast.values()), 'no DC link voltage'


def frames_in(log):
    """The frames that candump has seen, without the probes."""
    with open(log, encoding='ascii') as file:
        return [frame for frame in re.findall(r' ([0-9A-F]{3,8}#[0-9A-FR]*)$', file.read(), re.MULTILINE)
                if not frame.startswith(f'{PROBE:03X}')]


def send(*frames):
    for frame in frames:
        subprocess.run(['cansend', 'vcan0', frame], check=True, timeout=programs.PATIENCE)


def check_frames(folder, gateway, unit):
    """The frames of the unit are those that candump sees, in both directions."""
    reader = Reader(gateway, unit, 'frames=true')
    reader.begin()
    log = folder.candump(PROBE)
    requests = [f'605#{0x40:02X}{index & 0xFF:02X}{index >> 8:02X}{sub:02X}00000000'
                for index, sub in ((0x1000, 0), (0x1018, 0), (0x1018, 1), (0x6041, 0), (0x7FFF, 0))] * 8
    send(*requests, '000#0105', '000#8005', '605#4000100000000000')
    seen = {'R': [], 'S': []}
    for line in reader.lines('frames'):
        assert line['lost'] == 0 and line['frames'], line
        for text in line['frames']:
            instant, direction, frame = text.split()
            assert re.fullmatch(r'\d+[.]\d{6}', instant) and float(instant) <= line['t'] + 1e-6, line
            if not frame.startswith(f'{PROBE:03X}'):
                seen[direction].append(frame)
        if sum(frame.startswith('585') for frame in seen['S']) == len(requests) + 1:
            break
    assert reader.lost == 0
    deadline = time.monotonic() + programs.PATIENCE
    while True:
        there = frames_in(log)
        expected = {'R': [frame for frame in there if frame[:3] in ('605', '000')],
                    'S': [frame for frame in there if frame[:3] not in ('605', '000')]}
        if seen == expected:
            break
        assert time.monotonic() < deadline, (seen, expected)
        time.sleep(0.1)
    assert len(seen['R']) == len(requests) + 3, seen


def check_events(folder, gateway, unit):
    """Events since one was asked, with the numbers of the stream; the unit is named."""
    name = unit.split('/units/')[1]

    def recent(query=''):
        status, _, answer = gateway.request('GET', f'/api/v1/events/recent{query}')
        assert status == 200 and not answer['lost'] and not answer['restarted'], answer
        return answer

    first = recent()
    assert first['units'] == [name], first
    with gateway.stream('/api/v1/events?kinds=fault') as stream:
        stream.expect('units')
        deadline, told = time.monotonic() + programs.PATIENCE, []
        while len(told) < 2:
            # Until it is listened to: what is injected is told to whoever listens by then.
            folder.output_of('axisctl', 'fault', 'inject', '1', '7860')
            folder.output_of('axisctl', 'fault', 'ack', '1')
            told = recent(f'?after={first["last"]}&kinds=fault&unit={name}')['events']
            assert time.monotonic() < deadline, 'no events come'
        event = told[-1]
        assert event['id'] > first['last'] and event['kind'] == 'fault' and event['number'] == 7860, event
        while stream.expect('event', kind='fault')['t'] != event['t']:
            pass
    assert recent(f'?after={first["last"]}&unit=nowhere/7')['events'] == []
    numbers = [each['id'] for each in recent(f'?after={first["last"]}')['events']]
    assert numbers == sorted(set(numbers)) and recent(f'?after={numbers[-1]}')['last'] >= numbers[-1]


def check_restart(folder, gateway, unit, daemon):
    """A daemon that ends is no-daemon; when it is back, polls go on, and are told so."""
    reader = Reader(gateway, unit, f'{SAMPLES}&frames=true')
    reader.begin()
    next(reader.lines('samples'))
    assert gateway.request('POST', f'{unit}/quit')[0] == 200
    assert daemon.process.wait(programs.PATIENCE) == 0
    deadline = time.monotonic() + programs.PATIENCE
    while True:
        status, answer = reader.ask()
        if status != 200:
            break
        assert time.monotonic() < deadline, answer
        time.sleep(0.02)
    assert (status, answer['error']['code']) == (503, 'no-daemon'), answer
    programs.start_unit(folder)
    while True:
        status, answer = reader.ask()
        if status == 200:
            break
        assert time.monotonic() < deadline + programs.PATIENCE, answer
        time.sleep(0.1)
    assert answer['restarted'] and answer['samples'] == [] and answer['frames'] == [], answer
    next(reader.lines('samples'))


def check_refusals(gateway, unit):
    for query, refusal in {'': (400, 'bad-request'), 'frames=true&after=x': (400, 'bad-request'),
                           'signals=1/dance&period_ms=1': (404, 'not-found'),
                           'signals=1/speed': (400, 'bad-parameter'),
                           'signals=1/speed&period_ms=0': (400, 'bad-parameter')}.items():
        assert gateway.code('GET', f'{unit}/live?{query}') == refusal, (query, gateway.code('GET', f'{unit}/live?{query}'))
    assert gateway.code('GET', '/api/v1/units/nowhere/7/live?frames=true') == (404, 'unknown-unit')


def main():
    with programs.Folder(sys.argv[1]) as folder:
        daemon = programs.start_unit(folder)
        gateway = http_client.Gateway(folder)
        unit = gateway.unit()
        check_refusals(gateway, unit)
        check_samples(gateway, unit)
        check_frames(folder, gateway, unit)
        check_events(folder, gateway, unit)
        check_restart(folder, gateway, unit, daemon)
        assert gateway.program.end() == 0


if __name__ == '__main__':
    main()
