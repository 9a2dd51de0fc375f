#!/usr/bin/env python3
"""Runs every ready scenario, some side by side.

usage: scenarios.py PROGRAM_FOLDER SCENARIO_FOLDER
"""
import concurrent.futures
import pathlib
import subprocess
import sys

AXISCTL, FOLDER = sys.argv[1] + "/axisctl", pathlib.Path(sys.argv[2])
SIDE_BY_SIDE = 4
LIMIT_S = 120


def run(file):
    # By its name: it has to be among the installed ones.
    return file.stem, subprocess.run([AXISCTL, "run", file.stem], capture_output=True, text=True, timeout=LIMIT_S, check=False)


def main():
    files = sorted(FOLDER.glob("*.json"))
    failed = []
    with concurrent.futures.ThreadPoolExecutor(SIDE_BY_SIDE) as pool:
        for name, done in pool.map(run, files):
            if done.returncode != 0:
                failed.append(name)
                print(done.stdout, done.stderr, sep="")
    print(f"{len(files) - len(failed)} of {len(files)} scenarios passed")
    listed = subprocess.run([AXISCTL, "-b", "run", "--list"], capture_output=True, text=True, check=True).stdout
    names = [line.split()[0] for line in listed.splitlines()]
    assert names == [file.stem for file in files], names
    return 1 if failed or len(files) < 20 else 0


if __name__ == "__main__":
    sys.exit(main())
