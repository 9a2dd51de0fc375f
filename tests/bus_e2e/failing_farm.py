"""The dialogues of failing_calls.py with a door and with an agent of a farm, before a NATS server.

Calls fail in the door and in the agent themselves: an agent gives its LD_PRELOAD to no program that it starts. Whichever call
fails, one that goes on does all of its work in the end.
"""

import contextlib
import json
import os
import pathlib
import signal
import subprocess
import time

import control_client
import nats_client
import programs
from failing_dialogues import unit_options
from fleet_hosts import URL, Fleet
from hosts import Bench

UNIT, SUBJECT = 'line1.5', 'axisd.lab.line1.5.rpc'
WISH = {'configuration': {'axes': [{}]}}
PARAMETER, VALUE = '1/p1121', 7.5
ANSWER = 1  # s, before a question is asked once more; the one who was asked may have ended
LONGEST = 20  # s, for the work of a program that goes on


class Farm:
    """A server with nothing on it, and a client of it."""

    def __init__(self, bin_folder):
        self.bench = Bench(bin_folder)

    def __enter__(self):
        self.bench.__enter__()
        self.fleet = Fleet(self.bench, ANSWER)
        return self

    def __exit__(self, *rest):
        self.bench.__exit__(*rest)

    def forget(self):
        """Removes all that the server keeps."""
        self.fleet.connect()  # what has come late for the one before is nobody's
        for stream in self.fleet.client.ask_jetstream('STREAM.NAMES')['streams'] or []:
            self.fleet.client.ask_jetstream(f'STREAM.DELETE.{stream}')


def until(program, condition, what):
    """Waits until CONDITION holds; False if PROGRAM has ended before."""
    end = time.monotonic() + LONGEST
    while program.process.poll() is None:
        if condition():
            return True
        if time.monotonic() > end:
            program.process.kill()
            raise AssertionError(f'it goes on, but not within {LONGEST} s: {what}')
        time.sleep(0.02)
    return False


@contextlib.contextmanager
def what_is_said_by(program):
    """What goes wrong is told with what PROGRAM has said. Nobody else writes there any more."""
    try:
        yield
    except AssertionError as wrong:
        program.kill()
        raise AssertionError(f'{wrong}\n{program.rest()}') from wrong


def ask_to_end(program):
    """Ends PROGRAM if it runs; its exit status. What it has written is not asked for: its units may still write there."""
    if program.process.poll() is None:
        program.process.terminate()
    try:
        return program.process.wait(programs.PATIENCE)
    except subprocess.TimeoutExpired as late:
        raise AssertionError(f'it has not ended {programs.PATIENCE} s after SIGTERM') from late


def with_door(run, farm):
    """A unit that is asked, saves and is sampled over its farm."""
    farm.forget()
    unit = run.start('axisd', *unit_options(run), '--bus', 'line1', fails=False)
    unit.expect('ready: node 5')
    door = run.start('axisd-nats', '--farm', URL, '--host', 'a', '--socket', run.folder.path('axisd.sock'))
    with what_is_said_by(door):
        if ask_over_farm(door, farm):
            assert list(pathlib.Path(run.folder.path('state')).rglob('parameters.bin')), 'what was saved is not there'
        status = ask_to_end(door)
        assert unit.process.poll() is None, 'the unit has ended with its door'
    return status, door.rest()


def is_kept(status):
    """Whether a save has ended, by the STATUS of the store."""
    return not status['is_saving'] and status['last_kept']


def ask_over_farm(door, farm):
    """Whether the unit has saved; the door may end at any time."""
    def answer(method, deliver=None, **params):
        request = {'id': 1, 'method': method, 'params': params} | ({'deliver': deliver} if deliver else {})
        return json.loads(farm.fleet.request_all([(SUBJECT, request)])[0] or '{}').get('result')

    def subscribe():
        return answer('samples.subscribe', 'mine.5', signals=['1/speed'], period_ms=20)

    return (until(door, lambda: answer('status'), 'status')
            and until(door, lambda: answer('parameter.write', parameter=PARAMETER, value=VALUE) is not None, 'parameter.write')
            and until(door, lambda: answer('store') is not None, 'store')
            and until(door, lambda: is_kept(answer('store.status') or {'is_saving': True}), 'store.status')
            and until(door, lambda: has_sample(subscribe), 'a sample'))


def has_sample(subscribe):
    """Whether a sample comes to mine.5 if one asks for it."""
    listener = nats_client.Client(('127.0.0.1', 4222), ANSWER)
    listener.sub('mine.5')
    listener.flush()
    subscribe()
    try:
        return b'sample' in listener.next(ANSWER).data
    except TimeoutError:
        return False
    finally:
        listener.close()


class Unit:
    """The unit that the agent of a run has started, and its hub."""

    def __init__(self, run):
        self.folder, self.control = run.folder.folder.name, run.folder.path('run/axisd-line1-5.sock')
        self.file = pathlib.Path(run.folder.path('state/line1-5/parameters.bin'))

    def has_saved(self):
        """Has it save; False if it does not serve, or ends, or the save has failed."""
        try:
            client = control_client.ControlClient(self.control, ANSWER)
            client.call('parameter.write', parameter=PARAMETER, value=VALUE)
            client.call('store')
            while (status := client.call('store.status'))['is_saving']:
                time.sleep(0.01)
            return is_kept(status)
        except (OSError, ValueError, control_client.ControlError):  # it is not there, or not on its bus yet
            return False

    def is_on_server(self, fleet, saved):
        file = self.file.parent / 'exported'
        return fleet.is_kept(UNIT, file) and file.read_bytes() == saved

    def processes(self):
        """Those of this run, whoever has started them."""
        found = []
        for entry in pathlib.Path('/proc').iterdir():
            try:
                words = (entry / 'cmdline').read_text().split('\0') if entry.name.isdigit() else ['']
            except OSError:  # it has ended
                continue
            is_here = any(word.startswith(f'{self.folder}/') for word in words)
            if is_here and os.path.basename(words[0]) in ('axisd', 'canhub') and '--check-config' not in words:
                found.append(int(entry.name))
        return found

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for process in self.processes():
            try:
                os.kill(process, signal.SIGKILL)
            except ProcessLookupError:
                pass


def with_agent(run, farm):
    """A unit that is wanted, saves, and is wanted no more. What it has saved is on the server, or the next agent brings it there."""
    farm.forget()
    unit = Unit(run)
    options = ['--farm', URL, '--host', 'a', '--runtime-directory', run.folder.path('run'), '--state-directory', run.folder.path('state')]
    agent = run.start('axisd-agent', *options)
    with what_is_said_by(agent), unit:
        saved = have_unit(agent, farm.fleet, unit)
        status = ask_to_end(agent)
        if saved and not unit.is_on_server(farm.fleet, saved):
            following = run.start('axisd-agent', *options, fails=False)
            assert until(following, lambda: unit.is_on_server(farm.fleet, saved), 'what was saved is on the server')
        assert not saved or unit.file.read_bytes() == saved, 'what was saved is here no more'
    return status, agent.rest()


def have_unit(agent, fleet, unit):
    """What the unit has saved; None if the agent has ended before."""
    def is_wanted(document):
        return lambda: b'"seq"' in fleet.want(UNIT, document).data

    if not (until(agent, is_wanted(WISH), 'its buckets are there') and until(agent, unit.has_saved, 'the unit runs, and saves')):
        return None
    saved = unit.file.read_bytes()
    if (until(agent, lambda: unit.is_on_server(fleet, saved), 'what was saved is on the server')
            and until(agent, is_wanted(None), 'the server takes it')
            and until(agent, lambda: not unit.processes(), 'the unit and its hub have ended')):
        until(agent, lambda: not fleet.place(UNIT).get('host'), 'its place is released')
    return saved
