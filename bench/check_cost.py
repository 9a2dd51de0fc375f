#!/usr/bin/env python3
"""What a run of canopen-check takes, against slaves on a bus of their own in user space.

usage: check_cost.py BIN [--runs N] [--checks N] [--slave NAME]... [--other PROGRAM]

BIN is the folder of canopen-check, axisd, canopen-zoo and canhub. Prints a Markdown table: for each slave the real time and the processor
time of canopen-check, medians of N runs (3), and what became of the checks; then the N checks (10) that take longest against the first
slave. Ends with 3 if a check fails, or if a run against axisd takes more than ten seconds.

--slave   one of axisd, axisd-cia402, Right, RightDrive, or another one of canopen-zoo, or python: the slave of tests/bus_e2e/foreign_slaves,
          which needs python-can and with-can; may be given several times (axisd, axisd-cia402, Right, RightDrive)
--other   another canopen-check, run in turns with that of BIN: what a change has brought
"""
import argparse
import json
import os
import pathlib
import re
import select
import statistics
import subprocess
import sys
import tempfile
import time

NODE = "5"
PATIENCE = 60  # s, for what a busy machine may delay
LIMIT = 10  # s, of a run against axisd
MISSED = 3  # exit status: measured, and too much
SLAVES = ("axisd", "axisd-cia402", "Right", "RightDrive")
OUTCOMES = ("passed", "deviation", "failed", "skipped", "broken")
FOREIGN = pathlib.Path(__file__).parents[1] / "tests" / "bus_e2e" / "foreign_slaves"


class Slave:
    """A slave on a new bus in `folder`, and with what canopen-check is to be called."""

    def __init__(self, name, binaries, folder):
        self.bus, eds = f"unix:{folder}/bus", folder / "slave.eds"
        self.environment = {**os.environ, "XDG_RUNTIME_DIR": str(folder), "CAN_BUS": f"{folder}/bus"}
        sheets, more = binaries.parent / "share" / "axisd" / "eds", []
        if name in ("axisd", "axisd-cia402"):
            eds = sheets / f"{name}.eds"
            words = [binaries / "axisd", "--interface", self.bus, "--node-id", NODE, "--control", "none", "--state-directory",
                     folder / "state", "--profile", "cia402" if "cia402" in name else "s120"]
            more = ["--deviations", sheets / "axisd-deviations.json"] if name == "axisd" else []
        elif name == "python":
            eds = FOREIGN / "foreign_slave.eds"
            words = [binaries / "with-can", "--", "/usr/bin/python3", FOREIGN / "slave.py", "vcan0", eds]
        else:
            words = [binaries / "canopen-zoo", "--run", name, "--interface", self.bus, "--node", NODE, "--eds", eds]
        self.options = ["--interface", self.bus, "--node", NODE, "--eds", eds, *more]
        self.process = subprocess.Popen([str(word) for word in words], env=self.environment, stdin=subprocess.DEVNULL,
                                        stderr=subprocess.PIPE)
        self.wait_until_ready(name)

    def wait_until_ready(self, name):
        text, deadline = "", time.monotonic() + PATIENCE
        while not re.search("ready", text):
            readable, _, _ = select.select([self.process.stderr], [], [], max(0.0, deadline - time.monotonic()))
            part = os.read(self.process.stderr.fileno(), 4096).decode() if readable else ""
            if not part:
                sys.exit(f"{name} has not started: {text}")
            text += part

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
        self.process.stderr.close()


def check(program, name, binaries):
    """One run of `program` against the slave `name`: seconds, seconds of the processor, and the report."""
    with tempfile.TemporaryDirectory() as path, Slave(name, binaries, pathlib.Path(path)) as slave:
        report = pathlib.Path(path, "report.json")
        begin = time.monotonic()
        # wait4() gives the processor time of this process alone.
        with subprocess.Popen([str(word) for word in (program, *slave.options, "--json", report)], env=slave.environment,
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) as run:
            _, status, usage = os.wait4(run.pid, 0)
            run.returncode = os.waitstatus_to_exitcode(status)
            seconds, complaint = time.monotonic() - begin, run.stderr.read().decode()
        if run.returncode not in (0, 1):
            sys.exit(f"{program} ended with {run.returncode}: {complaint}")
        return seconds, usage.ru_utime + usage.ru_stime, json.loads(report.read_text(encoding="utf-8"))


def measure(programs, name, binaries, runs):
    """The runs of each program, in turns."""
    results = [[] for _ in programs]
    for _ in range(runs):
        for program, found in zip(programs, results):
            found.append(check(program, name, binaries))
    return results


def print_row(name, program, runs):
    times = [seconds for seconds, _, _ in runs]
    counts = runs[-1][2]["counts"]
    print(f"| {name} | {program} | {statistics.median(times):.1f} | {min(times):.1f} to {max(times):.1f} "
          f"| {statistics.median(cpu for _, cpu, _ in runs):.2f} | {' | '.join(str(counts[each]) for each in OUTCOMES)} |", flush=True)


def print_slowest(results, count):
    """The checks that take longest by the first program, beside the times of the other one; medians."""
    times = [{} for _ in results]
    for found, runs in zip(times, results):
        for _, _, report in runs:
            for result in report["results"]:
                found.setdefault(result["id"], []).append(result["seconds"])
    medians = [{check: statistics.median(seconds) for check, seconds in found.items()} for found in times]
    print("\n| check | " + " | ".join("seconds" for _ in results) + " |\n|---|" + "---:|" * len(results))
    for slowest in sorted(medians[0], key=medians[0].get, reverse=True)[:count]:
        print(f"| `{slowest}` | " + " | ".join(f"{found.get(slowest, 0.0):.2f}" for found in medians) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("binaries", metavar="BIN", type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--checks", type=int, default=10)
    parser.add_argument("--slave", action="append", metavar="NAME")
    parser.add_argument("--other", metavar="PROGRAM")
    arguments = parser.parse_args()
    programs = ([arguments.other] if arguments.other else []) + [arguments.binaries / "canopen-check"]
    names = ["other", "this"] if arguments.other else ["this"]
    print("| slave | canopen-check | real time (s) | least to most (s) | processor (s) | " + " | ".join(OUTCOMES) + " |")
    print("|---|---|---:|---:|---:|" + "---:|" * len(OUTCOMES))
    results = {}
    for slave in arguments.slave or SLAVES:
        results[slave] = measure(programs, slave, arguments.binaries, arguments.runs)
        for name, runs in zip(names, results[slave]):
            print_row(slave, name, runs)
    if arguments.checks > 0:
        print_slowest(next(iter(results.values())), arguments.checks)
    counts = [report["counts"] for found in results.values() for _, _, report in found[-1]]
    fine = all(each["failed"] + each["broken"] == 0 for each in counts)
    if "axisd" in results:
        median = statistics.median(seconds for seconds, _, _ in results["axisd"][-1])
        print(f"\nagainst axisd at most {LIMIT} s: {median:.1f} s, {'passed' if median <= LIMIT else 'FAILED'}")
        fine = fine and median <= LIMIT
    return 0 if fine else MISSED


if __name__ == "__main__":
    sys.exit(main())
