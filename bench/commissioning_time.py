#!/usr/bin/env python3
"""Ten minutes of commissioning in virtual time, and in real time: commissioning_time.py BIN [--real] [--seconds N].

BIN is the folder of axisd. examples/masters/npm/commission.js measures motor and load (p1910, p1960), saves, and turns the
axis; the unit is powered off and on, turn.js turns it again, and it runs on until --seconds of the bus have passed since the
beginning (600). Prints what the masters have printed and a Markdown table; with --real a run by the machine's clock too, which
takes as long as it says, and whether both have printed the same. Needs the npm packages of the masters: NODE_PATH, or
build/master/node_modules.
"""
import argparse
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
MASTERS = ROOT / "examples" / "masters" / "npm"
PATIENCE = 900  # s
PLANT = {"stator_resistance": 1.2, "d_inductance": 0.85, "q_inductance": 0.85, "magnet_flux": 1.1}
CONFIGURATION = {"axes": [{"parameters": {"p1120": 0.5, "p1121": 0.5}, "plant": PLANT, "load": {"inertia": 0.00604}}]}
# What is run by one clock: sh -c with the folder of the programs, that of the run and the seconds of the bus.
COURSE = """
set -e
begin=$(date +%s%N)
unit() { "$1/axisd" --interface "unix:$CAN_BUS" --node-id 5 --config "$2/axisd.json" --state-directory "$2/state" 2>>"$2/axisd.log" & }
unit "$1" "$2"
"$1/axisctl" wait ready --timeout 60
node "$3/commission.js"
kill $!; wait $! || true
unit "$1" "$2"
"$1/axisctl" wait ready --timeout 60
node "$3/turn.js"
passed=$(( ($(date +%s%N) - begin) / 1000000 ))
echo "passed $passed ms"
[ "$passed" -ge "$4" ] || sleep "$(( ($4 - passed) / 1000 )).$(printf %03d $(( ($4 - passed) % 1000 )))"
kill $!; wait $! || true
"""


def run(binaries, mode, seconds):
    """What the masters have printed, the ms of the bus they took, and s of the machine."""
    modules = os.environ.get("NODE_PATH", str(ROOT / "build" / "master" / "node_modules"))
    with tempfile.TemporaryDirectory(prefix="commissioning_time") as folder:
        pathlib.Path(folder, "axisd.json").write_text(json.dumps(CONFIGURATION), encoding="ascii")
        words = [binaries / "with-can", "--bus", f"{folder}/bus", "--time", mode, "--", "/bin/bash", "-c", COURSE, "course",
                 binaries, folder, MASTERS, str(seconds * 1000)]
        begin = time.perf_counter()
        done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, text=True, timeout=PATIENCE, check=False,
                              env={**os.environ, "NODE_PATH": modules, "XDG_RUNTIME_DIR": folder})
        taken = time.perf_counter() - begin
        if done.returncode:
            sys.exit(done.stdout + pathlib.Path(folder, "axisd.log").read_text(encoding="utf8"))
    passed = re.search(r"passed (\d+) ms\n", done.stdout)
    return done.stdout.replace(passed[0], ""), int(passed[1]), taken


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("binaries", type=pathlib.Path)
    parser.add_argument("--real", action="store_true")
    parser.add_argument("--seconds", type=int, default=600)
    options = parser.parse_args()
    binaries = options.binaries.resolve()
    runs = {mode: run(binaries, mode, options.seconds) for mode in ["virtual", *(["real"] if options.real else [])]}
    print(runs["virtual"][0])
    print("| time | masters, s of the bus | all, s of the bus | s of the machine |\n|---|---:|---:|---:|")
    for mode, (_, passed, taken) in runs.items():
        print(f"| {mode} | {passed / 1000:.3f} | {max(options.seconds, passed / 1000):.0f} | {taken:.2f} |")
    if options.real:
        print("\nboth have printed", "the same" if runs["real"][0] == runs["virtual"][0] else f"different:\n{runs['real'][0]}")


main()
