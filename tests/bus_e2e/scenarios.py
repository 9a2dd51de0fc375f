#!/usr/bin/env python3
"""Runs every ready scenario in virtual time, some side by side, and a few in real time.

usage: scenarios.py PROGRAM_FOLDER SCENARIO_FOLDER
"""
import concurrent.futures
import pathlib
import subprocess
import sys

AXISCTL, FOLDER = sys.argv[1] + "/axisctl", pathlib.Path(sys.argv[2])
SIDE_BY_SIDE = 4
LIMIT_S = 120
# Of each kind one: a master that acts, motion, the bus under load, its plug, what does not come.
IN_REAL_TIME = ("master-dies", "drive-dies-in-motion", "bus-load", "cable-out-and-back", "lost-sync")


def run(name, time):
    # By its name: it has to be among the installed ones.
    return name, time, subprocess.run([AXISCTL, "run", "--time", time, name], capture_output=True, text=True, timeout=LIMIT_S,
                                      check=False)


def main():
    ready = sorted(file.stem for file in FOLDER.glob("*.json"))
    runs = [(name, "real") for name in IN_REAL_TIME] + [(name, "virtual") for name in ready]
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(SIDE_BY_SIDE) as pool:
        for name, time, done in pool.map(lambda what: run(*what), runs):
            if done.returncode != 0:
                failed += 1
                print(f"{name} in {time} time:", done.stdout, done.stderr, sep="\n")
    print(f"{len(runs) - failed} of {len(runs)} runs of {len(ready)} scenarios passed")
    listed = subprocess.run([AXISCTL, "-b", "run", "--list"], capture_output=True, text=True, check=True).stdout
    names = [line.split()[0] for line in listed.splitlines()]
    assert names == ready, names
    return 1 if failed or len(ready) < 20 else 0


if __name__ == "__main__":
    sys.exit(main())
