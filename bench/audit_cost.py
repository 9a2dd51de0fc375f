#!/usr/bin/env python3
"""What canopen-audit takes to judge a log of a million frames, and how much memory however long a log is.

usage: audit_cost.py BIN [--frames N] [--long N] [--runs N] [--write FILE]

BIN is the folder of canopen-audit. The log is that of a master of eight drives of CiA 402 in profile velocity: it configures them over SDO,
starts them, and has a cycle of 10 ms with SYNC, an RPDO to each and a TPDO of each, one SDO upload, and heartbeats. It breaks no rule. Prints a
Markdown table: medians of N runs (3) over --frames frames (1,000,000), without any EDS and with one for each drive, and one run over --long
frames (10,000,000), whose file takes 42 bytes a frame. Ends with 3 if a million frames take more than two seconds, or more memory is needed
than 16 MB.

--write   writes the log to FILE and ends
"""
import argparse
import os
import pathlib
import re
import statistics
import struct
import subprocess
import sys
import tempfile
import time

DRIVES = range(1, 9)
CYCLE = 0.010  # s
HEARTBEAT = 100  # ms
WAY = 0.0003  # s: from a frame to the next one
LIMIT = 2.0  # s, of a log of a million frames
MOST_MEMORY = 16.0  # MB, of a log of whatever length
BETWEEN_LOOKS = 0.01  # s
MISSED = 3  # exit status: measured, and too much
MILLION = 1_000_000
VELOCITY, SYNCHRONOUS, NO_PDO = 3, 1, 1 << 31
#: Index, sub-index, bytes and value of what each drive is told; the node-ID is added to a COB-ID.
SETTING = (
    (0x1800, 1, 4, NO_PDO | 0x180), (0x1A00, 0, 1, 0), (0x1A00, 1, 4, 0x60410010), (0x1A00, 2, 4, 0x606C0020), (0x1A00, 0, 1, 2),
    (0x1800, 2, 1, SYNCHRONOUS), (0x1800, 1, 4, 0x180),
    (0x1400, 1, 4, NO_PDO | 0x200), (0x1600, 0, 1, 0), (0x1600, 1, 4, 0x60400010), (0x1600, 2, 4, 0x60FF0020), (0x1600, 0, 1, 2),
    (0x1400, 2, 1, SYNCHRONOUS), (0x1400, 1, 4, 0x200),
    (0x6060, 0, 1, VELOCITY), (0x1017, 0, 2, HEARTBEAT),
)
COB_IDS = (0x1400, 0x1800)
#: Controlword and the statusword that it leads to.
STEPS = ((0x06, 0x0631), (0x07, 0x0633), (0x0F, 0x0637))


class Log:
    """Lines as `candump -l` writes them."""

    def __init__(self):
        self.now, self.lines = 1_700_000_000.0, []

    def add(self, identifier, data, way=WAY):
        self.now += way
        self.lines.append(f"({self.now:.6f}) can0 {identifier:03X}#{data.hex().upper()}\n")

    def write(self, node, index, sub_index, size, value):
        at = struct.pack("<HB", index, sub_index)
        self.add(0x600 + node, bytes([0x23 | (4 - size) << 2]) + at + struct.pack("<I", value))
        self.add(0x580 + node, b"\x60" + at + bytes(4))

    def read(self, node, index, size, value):
        at = struct.pack("<HB", index, 0)
        self.add(0x600 + node, b"\x40" + at + bytes(4))
        self.add(0x580 + node, bytes([0x43 | (4 - size) << 2]) + at + struct.pack("<I", value))

    def taken(self):
        lines, self.lines = self.lines, []
        return lines


def configure(log):
    for node in DRIVES:
        log.add(0x700 + node, b"\0")
    for node in DRIVES:
        log.read(node, 0x1000, 4, 0x00020192)
        for index, sub_index, size, value in SETTING:
            is_of_node = index in COB_IDS and sub_index == 1
            log.write(node, index, sub_index, size, value + node if is_of_node else value)
        log.read(node, 0x6061, 1, VELOCITY)
    for node in DRIVES:
        log.add(0, bytes([1, node]))


def add_cycle(log, cycle, begin):
    """A SYNC and what comes of it: the statusword is that of the controlword of the cycle before."""
    log.now = begin + cycle * CYCLE
    log.add(0x80, b"", 0.0)
    commanded, _ = STEPS[min(cycle // 10, len(STEPS) - 1)]
    is_enabled = commanded == STEPS[-1][0]
    reached = STEPS[min((cycle - 1) // 10, len(STEPS) - 1)][1] if cycle > 0 else 0x0650
    speed = min(cycle, 5000) * 10 if is_enabled else 0
    for node in DRIVES:
        log.add(0x180 + node, struct.pack("<Hi", reached, speed))
    for node in DRIVES:
        log.add(0x200 + node, struct.pack("<Hi", commanded, min(cycle + 1, 5000) * 10 if is_enabled else 0))
    log.read(cycle % len(DRIVES) + 1, 0x6064, 4, cycle)
    if cycle % (HEARTBEAT // 10) < len(DRIVES):
        log.add(0x700 + cycle % (HEARTBEAT // 10) + 1, b"\x05")


def lines_of(count):
    """The lines of the log, many at a time."""
    log, cycle, written = Log(), 0, 0
    configure(log)
    begin = log.now + CYCLE
    while written < count:
        while len(log.lines) < 10_000:
            add_cycle(log, cycle, begin)
            cycle += 1
        lines = log.taken()[:count - written]
        written += len(lines)
        yield "".join(lines).encode()


def write_log(path, count):
    with path.open("wb") as file:
        for part in lines_of(count):
            file.write(part)


def peak_memory(process):
    """The most memory that it has had, in MB; 0 when it has ended."""
    try:
        found = re.search(r"VmHWM:\s+(\d+) kB", pathlib.Path(f"/proc/{process}/status").read_text(encoding="ascii"))
    except OSError:
        return 0.0
    return int(found[1]) / 1024 if found else 0.0


def audit(program, words):
    """Seconds, seconds of the processor and MB of a run."""
    begin, memory = time.monotonic(), 0.0
    with tempfile.TemporaryFile() as output, subprocess.Popen([str(word) for word in (program, *words)], stdin=subprocess.DEVNULL,
                                                              stdout=output, stderr=subprocess.STDOUT) as run:
        # The memory of wait4() would be that of this program before exec.
        while os.waitid(os.P_PID, run.pid, os.WEXITED | os.WNOWAIT | os.WNOHANG) is None:
            memory = peak_memory(run.pid) or memory
            time.sleep(BETWEEN_LOOKS)
        seconds = time.monotonic() - begin
        _, status, usage = os.wait4(run.pid, 0)
        run.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        said = output.read(2000).decode()
    if run.returncode != 0 or "no rule is broken" not in said:
        sys.exit(f"{program} ended with {run.returncode}: {said}")
    return seconds, usage.ru_utime + usage.ru_stime, memory


def print_row(name, count, runs):
    seconds, processor, memory = (statistics.median(column) for column in zip(*runs))
    print(f"| {name} | {count:,} | {seconds:.2f} | {processor:.2f} | {count / processor / 1000:.0f} | {memory:.1f} |", flush=True)
    return seconds <= LIMIT * count / MILLION and memory <= MOST_MEMORY


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("binaries", metavar="BIN", type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("--frames", type=int, default=MILLION)
    parser.add_argument("--long", type=int, default=10 * MILLION)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--write", metavar="FILE", type=pathlib.Path)
    arguments = parser.parse_args()
    if arguments.write:
        write_log(arguments.write, arguments.frames)
        return 0
    program, sheet = arguments.binaries / "canopen-audit", arguments.binaries.parent / "share" / "axisd" / "eds" / "axisd-cia402.eds"
    sheets = [word for node in DRIVES for word in ("--eds", f"{node}:{sheet}")]
    print("| log | frames | real time (s) | processor (s) | thousand frames/s | RSS (MB) |\n|---|---:|---:|---:|---:|---:|")
    fine = True
    rows = (("without EDS", arguments.frames, [], arguments.runs), ("with 8 EDS", arguments.frames, sheets, arguments.runs),
            ("with 8 EDS, long", arguments.long, sheets, 1))
    with tempfile.TemporaryDirectory() as folder:
        log, written = pathlib.Path(folder, "drives.log"), 0
        for name, count, words, runs in rows:
            if count != written:
                write_log(log, count)
                written = count
            fine = print_row(name, count, [audit(program, [log, *words]) for _ in range(runs)]) and fine
    print(f"\na million frames in at most {LIMIT:.0f} s, and at most {MOST_MEMORY:.0f} MB: {'passed' if fine else 'FAILED'}")
    return 0 if fine else MISSED


if __name__ == "__main__":
    sys.exit(main())
