"""Every n-th call of a program fails, each in turn.

failing_calls.py BIN-FOLDER LIBRARY [--every N] [--first M] [--program NAME] [--kinds K,...]

To be run by with-can, and for the programs of a farm, which have a server, in a network of its own (own_network.sh). For each kind of
calls (tests/support/failing_calls.h) that PROGRAM makes in a dialogue, the first one fails, then the second one, and so on; with --every N
each N-th, from the M-th on, so that several can share the work. The program goes on, or ends as its exit statuses say with one line on
standard error; it is ended by no signal, and what was saved is there whole when it starts again. The dialogues are in
failing_dialogues.py and failing_farm.py. The last line has the number of calls that failed.
"""

import argparse
import contextlib
import errno
import json
import mmap
import os
import re
import signal
import struct
import sys

import failing_dialogues
import failing_farm
import programs

HEADER = open(os.path.join(os.path.dirname(__file__), '../support/failing_calls.h'), encoding='ascii').read()
KINDS = re.findall(r'X\((\w+)\)', HEADER)[1:]
ERRORS = {'open': errno.EMFILE, 'read': errno.EIO, 'write': errno.ENOSPC, 'short_write': 0, 'fsync': errno.EIO,
          'rename': errno.EIO, 'unlink': errno.EACCES, 'mkdir': errno.EACCES, 'socket': errno.EMFILE, 'bind': errno.EADDRINUSE,
          'listen': errno.EADDRINUSE, 'connect': errno.ECONNREFUSED, 'accept': errno.EMFILE, 'send': errno.ENOBUFS,
          'receive': errno.ENOMEM, 'epoll': errno.ENOMEM, 'wait': errno.EINTR, 'timer': errno.EMFILE, 'eventfd': errno.EMFILE,
          'map': errno.ENOMEM, 'thread': errno.EAGAIN, 'spawn': errno.EAGAIN, 'pipe': errno.EMFILE, 'inotify': errno.ENOSPC,
          'memory': errno.ENOMEM}
SIZE_OF_COUNTS = int(re.search(r'FAILING_CALLS_FILE_SIZE (\d+)', HEADER)[1])
# With what each is talked to, made of the folder of the programs, and the dialogue.
DIALOGUES = {'axisd': (failing_dialogues.Master, failing_dialogues.with_axisd),
             'canhub': (contextlib.nullcontext, failing_dialogues.with_canhub),
             'axisd-http': (contextlib.nullcontext, failing_dialogues.with_gateway),
             'axisd-nats': (failing_farm.Farm, failing_farm.with_door),
             'axisd-agent': (failing_farm.Farm, failing_farm.with_agent)}


class Run:
    """One run of a program in which one call fails, or none."""

    def __init__(self, arguments, kind=None, number=0):
        self.arguments, self.kind, self.number = arguments, kind, number
        self.folder = programs.Folder(arguments.bin)

    def __enter__(self):
        self.folder.__enter__()
        self.counts_file = self.folder.path('counts')
        with open(self.counts_file, 'wb') as file:
            file.truncate(SIZE_OF_COUNTS)
        return self

    def __exit__(self, *rest):
        self.folder.__exit__(*rest)

    def start(self, name, *options, fails=True):
        environment = dict(self.folder.environment, CAN_BUS=os.environ['CAN_BUS'])
        if fails:
            environment |= {'LD_PRELOAD': self.arguments.library, 'FAIL_COUNTS': self.counts_file}
            if self.kind:
                environment['FAIL_CALL'] = f'{self.kind} {self.number} {ERRORS[self.kind]}'
        program = programs.Program([os.path.join(self.arguments.bin, name), *options], environment)
        self.folder.programs.append(program)
        return program

    def counts(self):
        with open(self.counts_file, 'r+b') as file, mmap.mmap(file.fileno(), SIZE_OF_COUNTS) as page:
            return dict(zip(KINDS, struct.unpack_from(f'<{len(KINDS)}Q', page)))


def lines_of(program, said):
    return [line for line in said.splitlines() if line.startswith(f'{program}: ')]


def judge(program, status, said, usual):
    """PROGRAM has ended as it may: by itself, and its last word, none of the USUAL ones, says why if it has failed."""
    where = f'exit status {status}\n{said}'
    assert status in (0, 1, 2), where
    assert 'Sanitizer' not in said and 'terminate called' not in said, where
    lines = lines_of(program, said)
    assert status == 0 or lines and lines[-1] not in usual, where


def fail_each(arguments, program):
    make_partner, dialogue = DIALOGUES[program]
    with make_partner(arguments.bin) as partner:
        with Run(arguments) as run:
            status, said = dialogue(run, partner)
            assert status == 0, said
            counts, usual = run.counts(), lines_of(program, said)
        tried, wrong = {}, 0
        for kind in arguments.kinds or KINDS:
            for number in range(arguments.first, counts[kind] + 1, arguments.every):
                try:
                    with Run(arguments, kind, number) as run:
                        judge(program, *dialogue(run, partner), usual)
                except AssertionError as error:
                    wrong += 1
                    print(f'{program}: {kind} {number}: {error}', flush=True)
                tried[kind] = tried.get(kind, 0) + 1
    print(f'{program}: ' + ', '.join(f'{kind} {count} of {counts[kind]}' for kind, count in tried.items()), flush=True)
    return sum(tried.values()), wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('bin')
    parser.add_argument('library')
    parser.add_argument('--every', type=int, default=1)
    parser.add_argument('--first', type=int, default=1)
    parser.add_argument('--program', choices=DIALOGUES)
    parser.add_argument('--kinds', type=lambda text: text.split(','))
    arguments = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    results = [fail_each(arguments, program) for program in ([arguments.program] if arguments.program else DIALOGUES)]
    tried, wrong = map(sum, zip(*results))
    print(json.dumps({'failed_calls': tried, 'wrong': wrong}))
    sys.exit(1 if wrong else 0)


main()
