#!/usr/bin/env python3
"""What a start of axisd costs, on a user-space bus that is there already.

usage: start_cost.py BIN [--runs N]

BIN is the folder of axisd. Prints a Markdown table: milliseconds from the start of the program until it tells the service
manager that it is ready, median of N runs (15); then, three seconds after that, memory and shared libraries.
"""
import argparse
import os
import pathlib
import socket
import statistics
import subprocess
import sys
import tempfile
import time

from fleet.daemon import memory

PATIENCE = 30.0  # s
SETTLED = 3.0  # s after READY, when what only the start needs has been given back


def end(process):
    process.terminate()
    process.wait()


def served(binaries, bus):
    """The hub of `bus`, which is ready."""
    hub = subprocess.Popen([binaries / "canhub", "--path", bus], stderr=subprocess.PIPE, text=True)
    if "ready" not in hub.stderr.readline():
        sys.exit("canhub has not started")
    return hub


def started(binaries, bus, folder, axes):
    """axisd in `folder`, and the seconds until it was ready."""
    folder.mkdir()
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as manager:
        manager.bind(str(folder / "notify"))
        manager.settimeout(PATIENCE)
        words = (binaries / "axisd", "--interface", f"unix:{bus}", "--node-id", 5, "--axes", axes,
                 "--state-directory", folder / "state", "--control", folder / "control")
        environment = {**os.environ, "XDG_RUNTIME_DIR": str(folder), "NOTIFY_SOCKET": f"{folder}/notify"}
        begun = time.perf_counter()
        process = subprocess.Popen([str(word) for word in words], env=environment, stderr=subprocess.DEVNULL)
        try:
            while b"READY=1" not in manager.recv(4096):
                pass
        except TimeoutError:
            end(process)
            sys.exit(f"axisd was not ready within {PATIENCE:.0f} s")
        return process, time.perf_counter() - begun


def libraries(process):
    """Names of the shared libraries of it, without the loader."""
    mapped = {line.split()[-1] for line in pathlib.Path(f"/proc/{process}/maps").read_text().splitlines()}
    return {name for name in mapped if ".so" in name and "/ld-" not in name}


def measure(binaries, axes, runs):
    times = []
    with tempfile.TemporaryDirectory() as name:
        bus = pathlib.Path(name, "bus")
        hub = served(binaries, bus)
        try:
            for run in range(runs):
                process, seconds = started(binaries, bus, pathlib.Path(name, str(run)), axes)
                times.append(1000 * seconds)
                if run == runs - 1:
                    time.sleep(SETTLED)
                    held, count = memory(process.pid), len(libraries(process.pid))
                end(process)
        finally:
            end(hub)
    print(f"| {axes} | {statistics.median(times):.1f} | {held[0]:.1f} | {held[1]:.1f} | {count} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("binaries", metavar="BIN", type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("--runs", type=int, default=15)
    arguments = parser.parse_args()
    if arguments.runs < 1:
        parser.error("--runs: expected 1 or more")
    print("| axes | to READY (ms) | RSS (MB) | PSS (MB) | shared libraries |\n|---:|---:|---:|---:|---:|")
    for axes in (1, 8):
        measure(arguments.binaries, axes, arguments.runs)


if __name__ == "__main__":
    sys.exit(main())
