"""Runs a master of examples/masters against axisd:
master_example.py BIN-FOLDER [--module NAME] [--cia402] [--axis JSON] PATTERN COMMAND...

What the command prints has to match PATTERN from its beginning to its end. Without the Python module NAME the test is
skipped: exit status 77. With --cia402 the unit has that profile. JSON adds to the axis of the configuration.
"""

import json
import re
import subprocess
import sys

import cia402_unit
import programs

SKIPPED = 77


def skip_without(module, python):
    if subprocess.run([python, '-c', f'import {module}'], stderr=subprocess.DEVNULL).returncode != 0:
        print(f'skipped: {python} has no module {module}; docs/how-to/masters.md says how to install it')
        sys.exit(SKIPPED)


def main():
    bin_folder, *words = sys.argv[1:]
    module = axis = None
    if words[0] == '--module':
        _, module, *words = words
    is_cia402 = words[0] == '--cia402'
    words = words[is_cia402:]
    if words[0] == '--axis':
        _, axis, *words = words
    pattern, *command = words
    if module:
        skip_without(module, command[0])
    with programs.Folder(bin_folder) as folder:
        if is_cia402:
            unit = cia402_unit.start_unit(folder, [json.loads(axis)] if axis else [])
        else:
            unit = programs.start_unit(folder, axis and json.loads(axis))
        run = subprocess.run(command, stdout=subprocess.PIPE, text=True, timeout=6 * programs.PATIENCE)
        print(run.stdout, end='')
        assert run.returncode == 0, f'exit status {run.returncode}'
        assert re.fullmatch(pattern, run.stdout.strip()), f'that does not match {pattern}'
        assert unit.end() == 0


main()
