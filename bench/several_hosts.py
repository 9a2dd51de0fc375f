#!/usr/bin/env python3
"""What a bus of several hosts carries over a NATS server, beside the floor: a sequencer over TCP that does nothing else.

usage: several_hosts.py BIN [--quick] [--runs N] [--only TEXT] [--storage KIND]

BIN is the folder of sequencer, trunk_hub, trunk_member and with-can. Three network namespaces with a hub and a member each, joined by
a bridge, where the server is; nothing leaves this program's own network. The same code of the hub runs over both servers, alternately,
and measures how long frames take to come back. Prints Markdown tables with medians of N runs (3), then the gates and whether they are
passed; ends with 1 if one is not.

--quick  one run of some seconds, with fewer frames: for a busy machine
--only   the measurements whose name has TEXT in it; then without gates of others
--storage  memory: the stream was made before, so that the server keeps it in its memory; else the hubs make it: file
"""
import argparse
import collections
import contextlib
import json
import os
import pathlib
import socket
import statistics
import subprocess
import sys
import tempfile
import time

HOSTS = ("a", "b", "c")
SERVER = "10.0.0.254"
PATIENCE = 120  # s, for everything that a busy machine may delay
ATTEMPTS = 10
AGE = 5  # s, of a stream in memory
TICKS = os.sysconf("SC_CLK_TCK")

Measure = collections.namedtuple("Measure", "name members batch rate count quick")
# Frames a message at most; frames a second of all hosts together, 0: as many as go; frames of all hosts together, in a quick run.
MEASURES = (
    Measure("1 000 frames/s", True, 64, 1000, 10_000, 2_000),
    Measure("10 000 frames/s", True, 64, 10_000, 100_000, 10_000),
    Measure("most, hub to hub, one frame a message", False, 1, 0, 600_000, 60_000),
    Measure("most, hub to hub, in batches", False, 64, 0, 3_000_000, 150_000),
    Measure("most, through members, one frame a message", True, 1, 0, 300_000, 30_000),
    Measure("most, through members, in batches", True, 64, 0, 1_000_000, 60_000),
)
ENGINES = ("sequencer", "NATS")

Gate = collections.namedtuple("Gate", "measure text value limit is_least unit")
Result = collections.namedtuple("Result", "rate median p99 member_median member_p99 lost hashes hub server member")


def gates():
    slow, fast, hubs, hub_batches, members, order = (measure.name for measure in MEASURES)
    return (
        Gate(order, "different orders of frames", lambda own, floor: max(own.hashes) - 1, 0, False, ""),
        Gate(order, "frames missing or twice", lambda own, floor: sum(own.lost), 0, False, ""),
        Gate(slow, "own echo, median", lambda own, floor: own.median[0], 200, False, "µs"),
        Gate(slow, "the same over that of the sequencer", lambda own, floor: own.median[0] / floor.median[0], 4, False, ""),
        Gate(slow, "own echo, 99 %", lambda own, floor: own.p99[0], 1000, False, "µs"),
        Gate(fast, "frames missing or twice", lambda own, floor: sum(own.lost), 0, False, ""),
        Gate(fast, "own echo, 99 %", lambda own, floor: own.p99[0], 5000, False, "µs"),
        Gate(hubs, "frames a second", lambda own, floor: own.rate[0], 50_000, True, ""),
        Gate(hub_batches, "frames a second", lambda own, floor: own.rate[0], 250_000, True, ""),
        Gate(members, "frames a second", lambda own, floor: own.rate[0], 25_000, True, ""),
        Gate(order, "frames a second", lambda own, floor: own.rate[0], 60_000, True, ""),
    )


class Disturbed(Exception):
    """What was measured does not count."""


def run(*words):
    subprocess.run([str(word) for word in words], check=True)


def build_network():
    """A namespace a host, each with an address, and the bridge between them, with that of the server."""
    run("mount", "-t", "tmpfs", "none", "/run")
    run("ip", "link", "set", "lo", "up")
    run("ip", "link", "add", "wire", "type", "bridge")
    run("ip", "addr", "add", f"{SERVER}/24", "dev", "wire")
    run("ip", "link", "set", "wire", "up")
    for number, host in enumerate(HOSTS, 1):
        run("ip", "netns", "add", host)
        run("ip", "link", "add", f"to-{host}", "type", "veth", "peer", "name", "eth0", "netns", host)
        run("ip", "link", "set", f"to-{host}", "master", "wire", "up")
        run("ip", "-n", host, "addr", "add", f"10.0.0.{number}/24", "dev", "eth0")
        run("ip", "-n", host, "link", "set", "eth0", "up")
        run("ip", "-n", host, "link", "set", "lo", "up")


def wait_until(condition, what):
    end = time.monotonic() + PATIENCE
    while not condition():
        if time.monotonic() > end:
            raise Disturbed(f"not within {PATIENCE} s: {what}")
        time.sleep(0.01)


def is_listening(port):
    with socket.socket() as probe:
        return probe.connect_ex((SERVER, port)) == 0


class Process:
    """One that takes lines from here and writes its own to a file."""

    def __init__(self, words, log, host=None):
        self.log = log
        inside = ["ip", "netns", "exec", host] if host else []
        with log.open("w", encoding="utf-8") as output:
            self.process = subprocess.Popen([str(word) for word in inside + words], stdin=subprocess.PIPE, stdout=output,
                                            stderr=subprocess.STDOUT)
        self.before = 0

    def has(self, text, times=1):
        return self.log.read_text(encoding="utf-8").count(text) >= times

    def go(self):
        self.before = self.processor_time()
        self.process.stdin.write(b"go\n")
        self.process.stdin.flush()

    def processor_time(self):
        fields = pathlib.Path(f"/proc/{self.process.pid}/stat").read_text(encoding="ascii").rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / TICKS

    def lasted(self):
        """Processor time since the start of the measurement (s)."""
        return self.processor_time() - self.before

    def finish(self):
        """What it says at its end: the lines that are JSON."""
        self.process.stdin.close()
        self.process.wait(PATIENCE)
        return [json.loads(line) for line in self.log.read_text(encoding="utf-8").splitlines() if line.startswith("{")]

    def kill(self):
        self.process.kill()
        self.process.wait()


def make_stream_in_memory():
    """The stream of the bus as an operator makes it beforehand, who wants it in the memory of the server, and short."""
    config = {"name": "CAN_bench", "subjects": ["can.bench.wire"], "storage": "memory", "max_age": AGE * 10**9, "no_ack": True,
              "retention": "limits", "max_consumers": -1, "max_msgs": -1, "max_bytes": -1, "discard": "old", "num_replicas": 1,
              "duplicate_window": 10**8}
    text = json.dumps(config)
    with socket.create_connection((SERVER, 4222), PATIENCE) as server:
        server.sendall(f'CONNECT {{"verbose":false}}\r\nSUB answer 1\r\n'
                       f"PUB $JS.API.STREAM.CREATE.CAN_bench answer {len(text)}\r\n{text}\r\n".encode())
        heard = b""
        while b"MSG answer" not in heard or not heard.endswith(b"}\r\n"):
            heard += server.recv(65536)
    if b'"error"' in heard:
        sys.exit(f"the stream was refused: {heard.decode()}")


class Bus:
    """A server, and a hub with a member on each host."""

    def __init__(self, programs, engine, measure, count, storage, stack):
        self.measure, self.stack, self.count = measure, stack, count
        self.folder = pathlib.Path(stack.enter_context(tempfile.TemporaryDirectory(dir="/dev/shm")))
        url = self.start_server(programs, engine)
        if engine == "NATS" and storage == "memory":
            make_stream_in_memory()
        of_hubs = 0 if measure.members else count
        self.hubs = [self.start(f"hub-{host}", [programs / "trunk_hub", url, self.folder / host, measure.batch, len(HOSTS), number,
                                                of_hubs], host) for number, host in enumerate(HOSTS)]
        for hub in self.hubs:
            wait_until(lambda hub=hub: hub.has("is on the bus", len(HOSTS) - 1), "every hub knows the others")
        self.members = [self.start(f"member-{host}", [programs / "with-can", "--bus", self.folder / host, "--", programs / "trunk_member",
                                                      "vcan0", len(HOSTS), number, count, measure.rate], host)
                        for number, host in enumerate(HOSTS) if measure.members]
        for member in self.members:
            wait_until(lambda member=member: member.has("ready"), "every member is on its bus")

    def start(self, name, words, host=None):
        process = Process(words, self.folder / f"{name}.log", host)
        self.stack.callback(process.kill)
        return process

    def start_server(self, programs, engine):
        if engine == "sequencer":
            port, url, words = 4223, f"tcp://{SERVER}:4223", [programs / "sequencer", f"{SERVER}:4223"]
        else:
            configuration = self.folder / "server.conf"
            configuration.write_text(f"listen: {SERVER}:4222\njetstream {{ store_dir: {self.folder}/store }}\n", encoding="utf-8")
            port, url, words = 4222, f"nats://{SERVER}:4222/bench", ["nats-server", "-c", configuration]
        self.server = self.start("server", words)
        wait_until(lambda: is_listening(port), f"{engine} listens")
        return url

    def run(self):
        self.server.before = self.server.processor_time()
        senders = self.members or self.hubs
        for process in {*self.hubs, *self.members} - {*senders}:
            process.before = process.processor_time()
        for process in senders:
            process.go()
        for process in senders:
            wait_until(lambda process=process: self.has_passed(process), "all frames have passed")
        return self.result()

    def has_passed(self, sender):
        """Whether all frames have come back to SENDER; what was cut does not count, and never ends."""
        for hub in self.hubs:
            for line in hub.log.read_text(encoding="utf-8").splitlines():
                if "cut:" in line:
                    raise Disturbed(line)
        return sender.has("heard" if self.members else "complete")

    def result(self):
        frames = self.count * len(HOSTS)
        times = [sum(process.lasted() for process in group) * 1e6 / frames / max(1, len(group))
                 for group in (self.hubs, [self.server], self.members)]
        members = [member.finish()[-1] for member in self.members]
        hubs = [hub.finish() for hub in self.hubs]
        for trunk, _ in hubs:
            if trunk["cuts"]:
                raise Disturbed("the bus was cut")
        tallies = [member["tally"] for member in members] or [tally for _, tally in hubs]
        back = [trunk["back_after_ns"] for trunk, _ in hubs]
        echo = [member["echo_ns"] for member in members] or [{"median": 0, "p99": 0}]
        return Result(rate=statistics.median((tally["heard"] - 1) / tally["seconds"] for tally in tallies),
                      median=max(row["median"] for row in back) / 1000, p99=max(row["p99"] for row in back) / 1000,
                      member_median=max(row["median"] for row in echo) / 1000, member_p99=max(row["p99"] for row in echo) / 1000,
                      lost=sum(frames - tally["heard"] + 2 * tally["repeated"] for tally in tallies),
                      hashes=len({tally["hash"] for tally in tallies}), hub=times[0], server=times[1], member=times[2])


def measure_once(programs, engine, measure, frames, storage):
    """A run that counts: one in which the bus was cut, as it is when the machine has no time for a hub, does not."""
    for attempt in range(ATTEMPTS):
        try:
            with contextlib.ExitStack() as stack:
                return Bus(programs, engine, measure, frames // len(HOSTS), storage, stack).run()
        except Disturbed as reason:
            print(f"{engine}, {measure.name}: {reason}", file=sys.stderr)
            if attempt == ATTEMPTS - 1:
                sys.exit("too often: is the machine too busy?")


def measure_all(programs, measures, runs, is_quick, storage):
    """By measurement and engine, a Result whose fields are lists: the median first, then all values."""
    found = collections.defaultdict(list)
    for number in range(runs):
        for measure in measures:
            for engine in ENGINES:
                print(f"run {number + 1} of {runs}: {measure.name}, {engine}", file=sys.stderr)
                frames = measure.quick if is_quick else measure.count
                found[measure.name, engine].append(measure_once(programs, engine, measure, frames, storage))
    return {key: Result(*([statistics.median(values), *values] for values in zip(*results))) for key, results in found.items()}


def print_speed(measures, found):
    print("| | over | frames/s | own echo p50 (µs) | p99 (µs) | seen by the member p50 (µs) | p99 (µs) | missing or twice | order |")
    print("|---|---|---:|---:|---:|---:|---:|---:|---|")
    for measure in measures:
        for engine in ENGINES:
            row = found[measure.name, engine]
            seen = f"{row.member_median[0]:.0f} | {row.member_p99[0]:.0f}" if measure.members else " | "
            order = "one" if max(row.hashes) == 1 else "differs"
            print(f"| {measure.name} | {engine} | {row.rate[0]:,.0f} | {row.median[0]:.0f} | {row.p99[0]:.0f} | {seen} | "
                  f"{sum(row.lost):.0f} | {order} |")


def print_cost(measures, found):
    print("\n| processor time a frame (µs) | over | each hub | the server | each member | all |")
    print("|---|---|---:|---:|---:|---:|")
    for measure in measures:
        for engine in ENGINES:
            row = found[measure.name, engine]
            whole = row.server[0] + len(HOSTS) * (row.hub[0] + row.member[0])
            member = f"{row.member[0]:.1f}" if measure.members else ""
            print(f"| {measure.name} | {engine} | {row.hub[0]:.1f} | {row.server[0]:.1f} | {member} | {whole:.1f} |")


def judge(found):
    """Prints the gates; true if all are passed."""
    is_passed = True
    print()
    for gate in gates():
        if (gate.measure, "NATS") not in found:
            continue
        value = gate.value(found[gate.measure, "NATS"], found[gate.measure, "sequencer"])
        good = value >= gate.limit if gate.is_least else value <= gate.limit
        is_passed = is_passed and good
        unit = f" {gate.unit}" if gate.unit else ""
        form = ".2f" if value < 10 and value != int(value) else ",.0f"
        print(f"{'PASS' if good else 'FAIL'} {gate.measure}: {gate.text}: {value:{form}}{unit}, "
              f"at {'least' if gate.is_least else 'most'} {gate.limit:,}{unit}")
    return is_passed


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("\n")[2][len("usage: "):])
    parser.add_argument("bin", type=pathlib.Path)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--runs", type=int)
    parser.add_argument("--only", default="")
    parser.add_argument("--storage", choices=("file", "memory"), default="file")
    arguments = parser.parse_args()
    if os.environ.get("SEVERAL_HOSTS_NETWORK") != "own":
        user = [] if os.getuid() == 0 else ["--map-root-user"]
        os.environ["SEVERAL_HOSTS_NETWORK"] = "own"
        os.execvp("unshare", ["unshare", *user, "--net", "--mount", sys.executable, *sys.argv])
    build_network()
    measures = [measure for measure in MEASURES if arguments.only in measure.name]
    runs = arguments.runs or (1 if arguments.quick else 3)
    found = measure_all(arguments.bin.resolve(), measures, runs, arguments.quick, arguments.storage)
    print_speed(measures, found)
    print_cost(measures, found)
    sys.exit(0 if judge(found) else 1)


if __name__ == "__main__":
    main()
