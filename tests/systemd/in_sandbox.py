"""Runs a program as a unit file has it confined: in_sandbox.py [--errors] [--survives CALL,...] UNIT-FILE -- PROGRAM [OPTION]...

A system call that the unit refuses ends the program by SIGSYS; with --errors it fails as it does under systemd, and so do those of
--survives in any case: a name, or socket:AF_... for a family of addresses. `strace -f` in front of all shows which call it was.
"""

import argparse
import os

import sandbox


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--errors', action='store_true')
    parser.add_argument('--survives', default='')
    parser.add_argument('unit')
    parser.add_argument('program', nargs='+')
    arguments = parser.parse_args()
    survived = filter(None, arguments.survives.split(','))
    sandbox.Sandbox(sandbox.Unit(arguments.unit), survived, arguments.errors).apply()
    os.execv(arguments.program[0], arguments.program)


main()
