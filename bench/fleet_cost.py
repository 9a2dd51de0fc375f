#!/usr/bin/env python3
"""What many units of one axis in one program cost, on a bus in user space.

usage: fleet_cost.py BIN [--units N] [--threads N] [--seconds S]

BIN is the folder of axisd and with-can. Prints the time to the last boot-up message, the memory of a further unit, and the
share of one processor with all units Operational and a SYNC every 100 ms, first with the axes off, then with all of them
turning; beside it the share of the hub. A share is CPU time over wall-clock time, so the machine should be quiet.
"""
import argparse
import json
import os
import pathlib
import re
import socket
import struct
import subprocess
import sys
import tempfile
import time

SYNC_PERIOD = 0.1
PACE = 16  # frames between two pauses: a unit looks at its process data every 4 ms


def master(units, stages):
    """The master, on a CAN socket: NMT start, SYNC, and the way to Operation enabled when it is told to."""
    can = socket.socket(socket.PF_CAN, socket.SOCK_RAW, socket.CAN_RAW)
    can.bind(("vcan0",))
    can.setsockopt(socket.SOL_CAN_RAW, socket.CAN_RAW_FILTER, b"")

    def send(identifier, data):
        can.send(struct.pack("=IB3x8s", identifier, len(data), data))

    def send_to_all(identifier, data_of):
        for node in range(1, units + 1):
            send(identifier + node, data_of(node))
            if node % PACE == 0:
                time.sleep(0.01)
        time.sleep(0.1)

    send(0x000, b"\x01\x00")
    for stage in stages:
        if stage == "turn":
            for word in (b"\x06\x00", b"\x07\x00", b"\x0f\x00"):
                send_to_all(0x200, lambda _, word=word: word)
            send_to_all(0x300, lambda node: b"\x0f\x00" + struct.pack("<i", 70_000_000 + node * 100_000))
        print(stage, flush=True)
        due = time.monotonic()
        while not os.path.exists(os.path.join(os.environ["STAGES"], stage)):
            send(0x080, b"")
            due += SYNC_PERIOD
            time.sleep(max(0.0, due - time.monotonic()))


def ask(path, requests):
    with socket.socket(socket.AF_UNIX) as control:
        control.connect(path)
        lines = control.makefile("rw")
        for number, request in enumerate(requests):
            lines.write(json.dumps({"id": number, **request}) + "\n")
            lines.flush()
            yield json.loads(lines.readline())["result"]


def cpu_seconds(process):
    fields = pathlib.Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def resident_kilobytes(process):
    return int(re.search(r"VmRSS:\s+(\d+)", pathlib.Path(f"/proc/{process}/status").read_text())[1])


def hub_of(bus):
    for entry in pathlib.Path("/proc").glob("[0-9]*/cmdline"):
        words = entry.read_bytes().split(b"\0")
        if words[0].endswith(b"canhub") and str(bus).encode() in words:
            return int(entry.parent.name)
    return None


def start(binaries, folder, units, threads):
    """axisd with so many units; the process, its control socket and the seconds to the last boot-up message."""
    configuration = folder / "units.json"
    entry = {"interface": f"unix:{folder}/bus", "node_id": {"from": 1, "to": units}}
    configuration.write_text(json.dumps({"threads": threads, "units": [entry]}))
    begun = time.monotonic()
    process = subprocess.Popen([binaries / "axisd", "--config", configuration, "--state-directory", folder / "state"],
                               env={**os.environ, "XDG_RUNTIME_DIR": str(folder)}, stderr=subprocess.PIPE, text=True)
    ready = 0
    while ready < units:
        line = process.stderr.readline()
        if not line:
            sys.exit("axisd has ended")
        ready += "ready:" in line
    return process, str(folder / "axisd.sock"), time.monotonic() - begun


def measure(binaries, units, threads, seconds):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        alone, _, _ = start(binaries, folder, 1, 1)
        one = resident_kilobytes(alone.pid)
        alone.terminate()
        alone.wait()
        process, control, booted = start(binaries, folder, units, threads)
        print(f"last boot-up after {booted:.2f} s; {resident_kilobytes(process.pid) / 1024:.1f} MB, "
              f"{(resident_kilobytes(process.pid) - one) / 1024 / max(1, units - 1):.2f} MB a further unit")
        hub = hub_of(folder / "bus")
        bus_master = subprocess.Popen([binaries / "with-can", "--bus", folder / "bus", "--", sys.executable, __file__,
                                       "--master", str(units)], env={**os.environ, "STAGES": name},
                                      stdout=subprocess.PIPE, text=True)
        for stage in ("idle", "turn"):
            bus_master.stdout.readline()
            time.sleep(8 if stage == "turn" else 1)  # ramps
            before, begun = (cpu_seconds(process.pid), cpu_seconds(hub)), time.monotonic()
            time.sleep(seconds)
            elapsed = time.monotonic() - begun
            shares = [100 * (now - then) / elapsed for now, then in zip((cpu_seconds(process.pid), cpu_seconds(hub)), before)]
            found = list(ask(control, [{"method": "status", "params": {"unit": str(n)}} for n in range(1, units + 1)]))
            turning = sum(abs(unit["axes"][0]["speed_rpm"]) > 100 for unit in found)
            print(f"{sum(unit['nmt_state'] == 'Operational' for unit in found)} units Operational, {turning} turning: "
                  f"axisd {shares[0]:.1f} %, hub {shares[1]:.1f} % of a processor; "
                  f"{sum(unit['skipped_cycles'] for unit in found)} cycles skipped, "
                  f"{sum(unit['bus']['dropped'] for unit in found)} frames lost")
            (folder / stage).touch()
        bus_master.wait()
        process.terminate()
        process.wait()


def main():
    if sys.argv[1:2] == ["--master"]:
        return master(int(sys.argv[2]), ["idle", "turn"])
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("binaries", type=pathlib.Path)
    parser.add_argument("--units", type=int, default=127)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--seconds", type=float, default=10.0)
    words = parser.parse_args()
    measure(words.binaries.resolve(), words.units, words.threads, words.seconds)


if __name__ == "__main__":
    main()
