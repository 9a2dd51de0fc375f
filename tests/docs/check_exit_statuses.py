"""Holds docs/reference/exit-statuses.md against the programs: check_exit_statuses.py BIN-FOLDER SOURCE-FOLDER

The table of each program is what its --help says, and every program ends with 2 for an option that it does not have; so do the
scripts. A program that has no table is missed."""

import os
import re
import subprocess
import sys

import pages

PAGE = 'docs/reference/exit-statuses.md'
USAGE = 2
SCRIPTS = ('demo.sh', 'test.sh', 'vcan-vm')


def tables(text):
    """Status and meaning by the heading above."""
    found = {}
    for section in text.split('\n## ')[1:]:
        heading, _, rest = section.partition('\n')
        found[heading] = re.findall(r'^\| (\d+) \| (.*) \|$', rest, re.MULTILINE)
    return found


def run(*words):
    return subprocess.run(words, capture_output=True, text=True, timeout=60, check=False, stdin=subprocess.DEVNULL)


def said(program):
    """Status and meaning as the help has them."""
    text = run(program, '--help').stdout.partition('Exit status:')[2]
    return re.findall(r'^ *(\d+)  (\S.*)$', text, re.MULTILINE)


def main():
    bin_folder, source = sys.argv[1:]
    wrong = []
    of_page = tables(pages.read(os.path.join(source, PAGE)))
    programs = [name for name in sorted(os.listdir(bin_folder)) if os.access(os.path.join(bin_folder, name), os.X_OK)
                and os.path.isfile(os.path.join(bin_folder, name)) and is_installed(name, source)]
    if len(programs) < 6:
        wrong.append(f'only these programs were found: {" ".join(programs)}')
    for name in programs:
        path = os.path.join(bin_folder, name)
        expected = said(path)
        if not expected:
            wrong.append(f'{name} --help says nothing of its exit status')
        if of_page.get(name) != expected:
            wrong.append(f'{name}: the page has {of_page.get(name)}\n  and the program {expected}')
        wrong += ends_with_usage(path, name)
    for name in SCRIPTS:
        wrong += ends_with_usage(os.path.join(source, 'scripts', name), name)
    print('\n'.join(wrong))
    return 1 if wrong else 0


def is_installed(name, source):
    """Whether the program is for users: a folder of its own says so."""
    return name in ('axisd', 'axisd-http', 'axisd-nats', 'axisd-agent') or os.path.isdir(os.path.join(source, 'tools', name))


def ends_with_usage(path, name):
    status = run(path, '--no-such-option').returncode
    return [] if status == USAGE else [f'{name} --no-such-option ends with {status}, not {USAGE}']


sys.exit(main())
