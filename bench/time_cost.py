#!/usr/bin/env python3
"""What virtual time costs: time_cost.py BIN [--seconds N] [--axes M].

BIN is the folder of axisd. Prints a Markdown table: an hour (--seconds) of a unit with eight turning axes (--axes) under a
master of npm with a SYNC every 100 ms, and under a program that only sleeps, with its axes at rest and turning; seconds of
the machine, and what the processes have taken of its processors. Beside it what the cycles of the unit take by themselves,
measured before and after by BIN/cycle_speed if that is built. Needs the npm packages of the master: NODE_PATH, or
build/master/node_modules.
"""
import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
CYCLE = 0.004  # s, cycle of a unit with many axes: r0110
QUIET_CYCLE = "unit: 8 axes at speed, a cycle of 4 ms, no PDO"  # a row of cycle_speed
MASTER = ROOT / "bench" / "time" / "hour.js"
PATIENCE = 600  # s
TICK = os.sysconf("SC_CLK_TCK")  # of processor times, 1/s


def parse_arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("binaries", type=pathlib.Path)
    parser.add_argument("--seconds", type=int, default=3600)
    parser.add_argument("--axes", type=int, default=8)
    return parser.parse_args()


class Bus:
    """A bus in virtual time with a unit on it, whose time stands until a program comes."""

    def __init__(self, binaries, axes):
        self.folder = tempfile.TemporaryDirectory(prefix="time_cost")
        self.path = f"{self.folder.name}/bus"
        self.binaries = binaries
        words = [binaries / "canhub", "--path", self.path, "--time", "virtual"]
        self.hub = subprocess.Popen(words, stderr=subprocess.PIPE, text=True)
        if "ready" not in self.hub.stderr.readline():
            sys.exit("canhub has not started")
        words = [binaries / "axisd", "--interface", f"unix:{self.path}", "--node-id", "5", "--axes", str(axes),
                 "--state-directory", f"{self.folder.name}/state", "--control", f"{self.folder.name}/control"]
        self.unit = subprocess.Popen([str(word) for word in words], stderr=subprocess.DEVNULL,
                                     env={**os.environ, "XDG_RUNTIME_DIR": self.folder.name})

    def run(self, *command):
        """Runs a program to its end: what it has printed, seconds, and those of processor that unit and hub have taken."""
        modules = os.environ.get("NODE_PATH", str(ROOT / "build" / "master" / "node_modules"))
        words = [self.binaries / "with-can", "--bus", self.path, "--time", "virtual", "--", *command]
        taken = self.processor_seconds()
        begin = time.perf_counter()
        done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, text=True, timeout=PATIENCE,
                              env={**os.environ, "NODE_PATH": modules}, check=True)
        seconds = time.perf_counter() - begin
        return done.stdout, seconds, *(after - before for before, after in zip(taken, self.processor_seconds()))

    def processor_seconds(self):
        def of(process):
            fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()
            return (int(fields[11]) + int(fields[12])) / TICK  # utime, stime: proc(5)
        return [of(process) for process in (self.unit, self.hub)]

    def end(self):
        for process in (self.unit, self.hub):
            process.terminate()
            process.wait(PATIENCE)
        self.folder.cleanup()


def measure(options, *commands):
    """What the last of @p commands has printed and needed, one after the other on one bus."""
    bus = Bus(options.binaries, options.axes)
    found = [bus.run(*command) for command in commands]
    bus.end()
    return found[-1]


def cycle_microseconds(binaries):
    """Of a unit of eight turning axes, in the lanes that it takes by itself; None without cycle_speed."""
    program = binaries / "cycle_speed"
    if not program.exists():
        return None
    rows = subprocess.run([program, "11"], stdout=subprocess.PIPE, text=True, check=True).stdout.splitlines()
    return min(float(row.split("|")[3]) for row in rows if QUIET_CYCLE in row)


def main():
    options = parse_arguments()
    before = cycle_microseconds(options.binaries)
    at_rest = measure(options, ["sleep", options.seconds])
    turning = measure(options, ["node", MASTER, options.axes, 0], ["sleep", options.seconds])
    after = cycle_microseconds(options.binaries)
    under_master = measure(options, ["node", MASTER, options.axes, options.seconds])
    print("| bus | s | processor: unit | hub |")
    print("|---|---:|---:|---:|")
    for name, (_, seconds, unit, hub) in (("alone, at rest", at_rest), ("alone, turning", turning),
                                              ("turning, SYNC every 100 ms", under_master)):
        print(f"| {options.seconds} s, {options.axes} axes {name} | {seconds:.1f} | {unit:.1f} | {hub:.1f} |")
    heard = json.loads(under_master[0])
    print(f"\n{heard['syncs']} SYNC, {heard['pdos']} PDOs heard, {heard['milliseconds'] / 1000:.1f} s of the bus")
    if options.axes == 8 and before is not None:
        cycle = (before + after) / 2
        needed = options.seconds / CYCLE * cycle / 1e6
        print(f"cycles of eight turning axes by themselves: {needed:.1f} s ({cycle:.2f} us each); unit alone, turning: "
              f"{turning[2] / needed:.2f} times as much")


main()
