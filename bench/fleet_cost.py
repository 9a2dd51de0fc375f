#!/usr/bin/env python3
"""What many units in one program cost, on buses in user space.

usage: fleet_cost.py BIN [--units N] [--axes M] [--buses B] [--threads T] [--seconds S] [--sync MS] [--default-pdos]
                         [--curve | --processes]

BIN is the folder of axisd. Prints a Markdown table: seconds to the last boot-up message, and the processor time until then;
memory; the share of one processor of axisd and of the hubs with all units Operational and a SYNC every 100 ms that every unit
answers with its statuswords, first with the axes off, then with all of them turning; frames a second and how much of 1 Mbit/s
they would take on each bus; cycles skipped while all turned. Then what a further unit and a further axis take of memory.
--curve does that for 1 to 127 units of 1 and of 8 axes on one bus. A share is CPU time over wall-clock time, with what skipped
cycles would have cost: it survives other programs on the machine.
--processes gives every unit a process of its own, and tells beside it the floor: as many processes that do nothing but wake in
every cycle.
"""
import argparse
import pathlib
import subprocess
import sys
import tempfile
import threading
import time

from fleet.bus_master import BusMaster
from fleet.daemon import Daemon, Processes
from fleet.wire import mean_bits

BIT_RATE = 1_000_000
MOST_NODES = 127
CURVE = [(units, axes) for axes in (1, 8) for units in (1, 8, 32, 64, 127)]
CYCLE = 0.004  # s, p8848 of a new unit
RAMPS = 8.0  # s, until all have the speed that was asked for
TURNS = 100  # rpm
HEAD = ("units", "axes", "buses", "threads", "boot-up (s)", "its CPU (s)", "RSS, booted (MB)", "PSS, booted (MB)", "off: axisd (%)",
        "off: hubs (%)", "turning: axisd (%)", "turning: hubs (%)", "frames/s", "bus load (%)", "skipped")


class Sync(threading.Thread):
    """SYNC on all buses, every `period` seconds."""

    def __init__(self, masters, period):
        super().__init__(daemon=True)
        self.masters, self.period, self.has_ended = masters, period, threading.Event()

    def run(self):
        due = time.monotonic()
        while not self.has_ended.wait(max(0.0, due - time.monotonic())):
            for master in self.masters:
                master.sync()
            due += self.period

    def end(self):
        self.has_ended.set()
        self.join()


def skipped_cycles(statuses):
    return sum(unit["skipped_cycles"] for unit in statuses)


def share(daemon, masters, seconds):
    """Percents of axisd and of the hubs, frames a second and cycles skipped, over `seconds`. What skipped cycles would have
    cost is added: a machine that is busy otherwise shows what a quiet one would."""
    def now():
        return time.monotonic(), *daemon.cpu(), sum(master.statistics()[0] for master in masters)

    units = daemon.statuses()
    before = now()
    time.sleep(seconds)
    elapsed, axisd, hubs, frames = (after - then for after, then in zip(now(), before))
    skipped = skipped_cycles(daemon.statuses()) - skipped_cycles(units)
    done = max(0.01, 1 - skipped * CYCLE / (elapsed * len(units)))
    return 100 * axisd / elapsed / done, 100 * hubs / elapsed, frames / elapsed, skipped


def enable(masters, period):
    """Leads all axes to Operation enabled and gives them their speeds."""
    for word in (0x06, 0x07, 0x0F):
        for master in masters:
            master.command(word)
        time.sleep(3 * period + 0.1)
    for master in masters:
        master.set_speeds()


def counts_of(units, buses):
    """How many units each bus has."""
    return [units // buses + (number < units % buses) for number in range(buses)]


def check(statuses, axes, masters):
    """Says if not all units are Operational, not all axes turn or frames were lost."""
    operational = sum(unit["nmt_state"] == "Operational" for unit in statuses)
    turning = sum(abs(axis["speed_rpm"]) > TURNS for unit in statuses for axis in unit["axes"])
    lost = sum(unit["bus"]["dropped"] for unit in statuses) + sum(master.statistics()[1] for master in masters)
    if (operational, turning, lost) != (len(statuses), len(statuses) * axes, 0):
        print(f"{operational} of {len(statuses)} units Operational, {turning} of {len(statuses) * axes} axes turn, "
              f"{lost} frames lost", file=sys.stderr)


def started(words, name, units, axes):
    """The units, in a folder called `name`, all of which have booted."""
    counts, folder = counts_of(units, words.buses), pathlib.Path(name)
    if words.processes:
        return Processes(words.binaries.resolve(), folder, counts, axes)
    return Daemon(words.binaries.resolve(), folder, counts, axes, words.threads)


def measure(words, units, axes):
    """A row of the table, and RSS and PSS after the boot-up (MB)."""
    counts, period = counts_of(units, words.buses), words.sync / 1000
    with tempfile.TemporaryDirectory() as name, started(words, name, units, axes) as daemon:
        held = daemon.memory()
        masters = [BusMaster(bus, count, axes) for bus, count in zip(daemon.buses, counts)]
        for master in masters:
            if not words.default_pdos:
                master.map_all()
            master.start()
        sync = Sync(masters, period)
        sync.start()
        off = share(daemon, masters, words.seconds)
        enable(masters, period)
        time.sleep(RAMPS)
        turning = share(daemon, masters, words.seconds)
        sample = [frame for master in masters for frame in master.sample(2 * period)]
        sync.end()
        statuses = daemon.statuses()
        check(statuses, axes, masters)
        load = 100 * turning[2] / words.buses * mean_bits(sample) / BIT_RATE
        return (units, axes, words.buses, words.threads, f"{daemon.booted:.2f}", f"{daemon.boot_cpu:.2f}",
                *(f"{part:.1f}" for part in (*held, *off[:2], *turning[:2])), f"{turning[2]:.0f}", f"{load:.1f}",
                turning[3]), held


def memory_of(words, units, axes):
    """RSS and PSS of the program with so many units that have booted (MB)."""
    with tempfile.TemporaryDirectory() as name, started(words, name, units, axes) as daemon:
        return daemon.memory()


def print_further(words, held):
    """What a further unit and a further axis take of memory."""
    if words.units == words.buses:
        return
    one = memory_of(words, words.buses, words.axes)
    unit = [(all_of - few) / (words.units - words.buses) for all_of, few in zip(held, one)]
    print(f"\na further unit of {words.axes}: {unit[0]:.2f} MB RSS, {unit[1]:.2f} MB PSS")
    if words.axes > 1:
        single = memory_of(words, words.units, 1)
        axis = [(all_of - few) / (words.units * (words.axes - 1)) for all_of, few in zip(held, single)]
        print(f"a further axis: {axis[0]:.3f} MB RSS, {axis[1]:.3f} MB PSS")


def print_floor(words):
    """What as many processes take that only wake."""
    wakers = words.binaries / "wakers"
    answer = subprocess.run([wakers, str(words.units), str(round(1000 * CYCLE)), str(max(1, round(words.seconds)))],
                            stdout=subprocess.PIPE, text=True, check=True).stdout.strip()
    print(f"\n{words.units} processes that only wake every {1000 * CYCLE:.0f} ms: {answer} % of a processor")


def print_row(cells):
    print("| " + " | ".join(str(cell) for cell in cells) + " |", flush=True)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("binaries", type=pathlib.Path)
    parser.add_argument("--units", type=int, default=127)
    parser.add_argument("--axes", type=int, default=1, choices=range(1, 9), metavar="1..8")
    parser.add_argument("--buses", type=int, default=1)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--seconds", type=float, default=10.0, help="of each share")
    parser.add_argument("--sync", type=float, default=100.0, metavar="MS")
    parser.add_argument("--default-pdos", action="store_true",
                        help="PDOs as in a new unit: event-driven TPDOs in every cycle of 4 ms that changes them")
    how = parser.add_mutually_exclusive_group()
    how.add_argument("--curve", action="store_true", help="1 to 127 units of 1 and of 8 axes")
    how.add_argument("--processes", action="store_true", help="a process for each unit")
    words = parser.parse_args()
    if words.processes and words.threads > 1:
        parser.error("--threads: a process has one unit, and one thread for it")
    if not words.buses <= words.units <= words.buses * MOST_NODES:
        parser.error(f"--units: expected {words.buses} to {words.buses * MOST_NODES} on {words.buses} buses")
    return words


def main():
    words = arguments()
    print_row(HEAD)
    print_row("---:" for _ in HEAD)
    if words.curve:
        for units, axes in CURVE:
            print_row(measure(words, units, axes)[0])
        return
    row, held = measure(words, words.units, words.axes)
    print_row(row)
    if words.processes:
        print_floor(words)
    else:
        print_further(words, held)


if __name__ == "__main__":
    main()
