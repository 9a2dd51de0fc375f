"""Runs the blocks of one kind of blocks.txt: run_rows.py KIND BIN-FOLDER SOURCE-FOLDER

frames and python need a bus: with-can --private -- python3 run_rows.py ..."""

import json
import os
import subprocess
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, 'bus_e2e'))
import control_client  # noqa: E402  pylint: disable=wrong-import-position
import frames  # noqa: E402  pylint: disable=wrong-import-position
import programs  # noqa: E402  pylint: disable=wrong-import-position
import rows  # noqa: E402  pylint: disable=wrong-import-position

GOES_ON = 'goes on'  # in place of a configuration: the unit of the block before


def where(row, block):
    return f'{row.page}:{block.line}'


def run_config(bin_folder, source):
    """--check-config takes each configuration."""
    with programs.Folder(bin_folder) as folder:
        for row, block in rows.blocks(source, 'config'):
            text = row.detail.replace('%', '\n'.join(block.lines))
            with open(folder.path('axisd.json'), 'w', encoding='utf-8') as file:
                file.write(text)
            run = subprocess.run([os.path.join(bin_folder, 'axisd'), '--check-config', '--config', folder.path('axisd.json')],
                                 capture_output=True, text=True, env=folder.environment, check=False, timeout=programs.PATIENCE)
            assert run.returncode == 0, f'{where(row, block)}: {run.stderr}'
            yield where(row, block)


def run_json(_, source):
    for row, block in rows.blocks(source, 'json'):
        json.loads('\n'.join(block.lines))
        yield where(row, block)


def objects_of(text):
    """The JSON objects that stand one behind the other."""
    decoder, place = json.JSONDecoder(), 0
    while place < len(text):
        value, place = decoder.raw_decode(text, place)
        yield value
        while place < len(text) and text[place].isspace():
            place += 1


def run_control(bin_folder, source):
    """Requests are answered as the page says, or with a result where it says nothing."""
    with programs.Folder(bin_folder) as folder:
        socket = folder.path('axisd.sock')
        unit = folder.start('axisd', '--interface', f'unix:{folder.path("bus")}', '--node-id', '5', '--control', socket)
        unit.expect('ready: node 5')
        for row, block in rows.blocks(source, 'control'):
            client = control_client.ControlClient(socket, programs.PATIENCE)
            said = list(objects_of('\n'.join(block.lines)))
            for request, expected in zip(said, said[1:] + [None]):
                if 'method' not in request:
                    continue
                try:
                    answer = {'result': client.call(request['method'], **request['params'])}
                except control_client.ControlError as refusal:
                    answer = {'error': refusal.args[0]}
                if expected is None or 'method' in expected:
                    assert 'result' in answer, f'{where(row, block)}: {answer}'
                else:
                    expected.pop('id')
                    assert answer == expected, f'{where(row, block)}: {answer}'
            yield where(row, block)


def start_unit(folder, configuration):
    """axisd of that configuration on the bus of with-can, in the state in which the one before has left it."""
    with open(folder.path('axisd.json'), 'w', encoding='ascii') as file:
        file.write(configuration)
    unit = folder.start('axisd', '--interface', f'unix:{os.environ["CAN_BUS"]}', '--config', folder.path('axisd.json'))
    unit.expect('ready: node')
    return unit


def run_frames(bin_folder, source):
    """Frames of a master are sent, and answers come as they are printed; frames.py has the rules."""
    with programs.Folder(bin_folder) as folder:
        unit = None
        for row, block in rows.blocks(source, 'frames'):
            if row.detail != GOES_ON:
                if unit:
                    unit.end()
                dialogue = frames.Dialogue()
                unit = start_unit(folder, row.detail)
            for line in block.lines:
                if line.endswith('the next start'):
                    unit.end()
                    unit = start_unit(folder, row.detail)
                dialogue.take(line, where(row, block))
            dialogue.end(where(row, block))
            yield where(row, block)
        unit.end()


def run_python(bin_folder, source):
    """A program runs to its end on a bus that somebody else talks on."""
    with programs.Folder(bin_folder) as folder:
        bus = os.environ['CAN_BUS']
        folder.start('canhub', '--path', bus).expect('ready')
        folder.environment.update(CAN_BUS=bus, LD_PRELOAD=os.environ['LD_PRELOAD'])
        folder.programs.append(programs.Program(['cangen', 'vcan0', '-g', '20'], folder.environment))
        for row, block in rows.blocks(source, 'python'):
            run = subprocess.run([sys.executable, '-c', '\n'.join(block.lines)], capture_output=True, text=True, check=False,
                                 env={**folder.environment, 'LD_PRELOAD': ''}, timeout=programs.PATIENCE)
            assert run.returncode == 0, f'{where(row, block)}: {run.stderr}'
            print(run.stdout)
            yield where(row, block)


RUNS = {'config': run_config, 'json': run_json, 'control': run_control, 'frames': run_frames, 'python': run_python}


def main():
    kind, bin_folder, source = sys.argv[1:]
    started = time.monotonic()
    count = 0
    for place in RUNS[kind](os.path.abspath(bin_folder), os.path.abspath(source)):
        count += 1
        print(f'{time.monotonic() - started:6.1f} s  {place}')
    assert count, f'no row of tests/docs/blocks.txt is of the kind {kind}'


main()
