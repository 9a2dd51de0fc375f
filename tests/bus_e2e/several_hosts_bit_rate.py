"""Hubs of three hosts on one bus with a bit rate: arbitration between them, and an arbiter that dies or stands still.

usage: several_hosts_bit_rate.py PROGRAMS
"""
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time

here = pathlib.Path(__file__).parent
sys.path.insert(0, str(here.parent / "can" / "hub" / "medium"))
from bit_time import length_on_wire  # noqa: E402

RATE = 125000
SENDERS = 20  # of a burst on each host
BABBLERS = 16  # with frames for a quarter of a second
ROUNDS = 10
programs = pathlib.Path(sys.argv[1])
folder = pathlib.Path(tempfile.mkdtemp(dir="/dev/shm" if os.access("/dev/shm", os.W_OK) else None))
processes = []


def start(*words, **options):
    process = subprocess.Popen([str(word) for word in words], **options)
    processes.append(process)
    return process


def wait_until(condition, what, seconds=30):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, f"not within {seconds} s: {what}"
        time.sleep(0.01)


class Host:
    """A hub with its bus, and candump on it from the beginning."""

    def __init__(self, name, *options):
        self.name = name
        self.path, self.log, self.dump = (folder / f"{name}{end}" for end in ("", ".log", ".dump"))
        self.environment = dict(os.environ, CAN_BUS=str(self.path), PYTHONDONTWRITEBYTECODE="1")
        self.hub = start(programs / "canhub", "--path", self.path, "--join", "nats://127.0.0.1/lab", *options,
                         stderr=self.log.open("w"))
        wait_until(lambda: "ready" in self.log.read_text(), "the hub serves")

    def listen(self):
        self.run("candump", "-D", "-L", "can0", stdout=self.dump.open("w"), stderr=subprocess.STDOUT)
        wait_until(lambda: re.search(r"^raw .* (any|can0) ", self.status(), re.MULTILINE), "candump listens")

    def run(self, *words, **options):
        return start(programs / "with-can", *words, env=self.environment, **options)

    def send(self, frame):
        """False: the network is down."""
        done = subprocess.run([str(programs / "with-can"), "cansend", "can0", frame], env=self.environment, capture_output=True,
                              text=True)
        assert done.returncode == 0 or "Network is down" in done.stderr, done.stderr
        return done.returncode == 0

    def canhub(self, *words):
        return subprocess.run([str(programs / "canhub"), *words, "--path", str(self.path)], capture_output=True, text=True,
                              check=True).stdout

    def status(self):
        return self.canhub("--status")

    def told(self, text):
        return self.log.read_text().count(text)

    def under_way(self):
        return int(re.search(r"(\d+) under way;", self.status()).group(1))

    def cuts(self):
        """How often its bus has been cut; nothing while it is."""
        found = re.search(r"lab: whole, cut (\d+) times$", self.status(), re.MULTILINE)
        return int(found.group(1)) if found else None

    def is_arbiter(self):
        return f"arbiter at {RATE} bit/s: this hub, term " in self.status()

    def frames(self):
        """(time in microseconds, frame) of each whole line."""
        found = re.findall(r"^\((\d+)\.(\d{6})\) can0 (\S+)(?: [RT])?$", self.dump.read_text(), re.MULTILINE)
        return [(int(seconds) * 10**6 + int(rest), frame) for seconds, rest, frame in found]


def bit_time(frame):
    """In microseconds."""
    identifier, data = frame.split("#")
    data = bytes.fromhex(data)
    return 10**6 / RATE * length_on_wire(int(identifier, 16), False, False, len(data), data)


def find_arbiter(hosts):
    found = []

    def is_found():
        found[:] = [host for host in hosts if host.is_arbiter()]
        return len(found) == 1
    wait_until(is_found, "one of them is the arbiter")
    return found[0]


def burst(hosts, arbiter, number):
    """All hosts ask for frames at once while something has the bus to itself; how many waited until it was over."""
    arbiter.canhub(*(word for identifier in range(BABBLERS) for word in ("--inject", f"bus.babble id={identifier:X} length=8")))
    identifiers = [0x100 + (7 * place + 11 * number) % 0x600 for place in range(len(hosts) * SENDERS)]
    data = f"{number:02X}"
    bursts = [host.run(sys.executable, here / "hosts_sender.py", "burst", data, *identifiers[place::len(hosts)])
              for place, host in enumerate(hosts)]
    for sender in bursts:
        assert sender.wait(30) == 0
    wait_until(lambda: all(host.under_way() >= SENDERS for host in hosts) or count(arbiter, data) > 0, "all have asked")
    arbiter.canhub("--take-back", "all")
    wait_until(lambda: all(count(host, data) == len(identifiers) for host in hosts), "the bursts have passed everywhere")
    frames = hosts[0].frames()
    last = max(place for place, (_, frame) in enumerate(frames) if int(frame[:3], 16) < BABBLERS)
    behind = [frame for frame in frames[last:] if frame[1].endswith(f"#{data}")]
    texts = [frame for _, frame in behind]
    assert texts == sorted(texts), texts
    for (before, _), (after, frame) in zip(behind, behind[1:]):
        assert abs(after - before - bit_time(frame)) <= 2, (before, after, frame)
    return len(behind)


def count(host, data):
    return sum(frame.endswith(f"#{data}") for _, frame in host.frames())


def compete(hosts):
    arbiter = find_arbiter(hosts)
    most = 0
    for number in range(1, ROUNDS + 1):
        most = max(most, burst(hosts, arbiter, number))
        if most == len(hosts) * SENDERS:
            break
    assert most > len(hosts) * SENDERS // 2, most
    for host in hosts[1:]:
        assert host.frames() == hosts[0].frames()
    frames = hosts[0].frames()
    for (before, _), (after, frame) in zip(frames, frames[1:]):
        assert after - before >= bit_time(frame) - 2, (before, after, frame)
    print(f"{len(frames)} frames, the same on all hosts; {most} frames of three hosts waited and passed by their identifiers")


def stand_still(hosts):
    """The arbiter stops for 3 s, while all send: nothing comes twice, nothing late."""
    arbiter = find_arbiter(hosts)
    logs = [folder / f"{host.name}.numbers" for host in hosts]
    senders = [host.run(sys.executable, here / "hosts_sender.py", "numbers", str(place), log)
               for place, (host, log) in enumerate(zip(hosts, logs))]
    wait_until(lambda: all(log.exists() and log.read_text().count("R ") > 50 for log in logs), "all hear each other")
    arbiter.hub.send_signal(signal.SIGSTOP)
    others = [host for host in hosts if host is not arbiter]
    wait_until(lambda: all(host.cuts() == 1 for host in others), "the others go on")
    assert all(host.told("cut: no arbiter has been heard for 500 ms") == 1 for host in others)
    time.sleep(3)
    arbiter.hub.send_signal(signal.SIGCONT)
    wait_until(lambda: arbiter.cuts() == 1, "the old arbiter has joined again")
    assert not arbiter.is_arbiter()
    ends = [len(log.read_text()) for log in logs]
    wait_until(lambda: all(log.read_text()[end:].count("R ") > 50 for end, log in zip(ends, logs)), "all hear each other again")
    for sender in senders:
        sender.send_signal(signal.SIGTERM)
        assert sender.wait(30) == 0
    sent = {(place, int(words[1])): int(words[2]) for place, log in enumerate(logs) for words in lines(log) if words[0] == "S"}
    for log in logs:
        seen = [(int(words[1]), int(words[2]), int(words[3])) for words in lines(log) if words[0] == "R"]
        for place in range(len(hosts)):
            numbers = [number for sender, number, _ in seen if sender == place]
            assert numbers == sorted(set(numbers)), (log, place)
        late = [(sender, number) for sender, number, at in seen if at - sent[sender, number] > 2 * 10**9]
        assert not late, (log, late)
    print("an arbiter that stood still: nothing late, nothing twice, another one went on")


def lines(log):
    return [line.split() for line in log.read_text().splitlines()]


def die(hosts):
    """The arbiter is killed: the others are cut, and go on."""
    arbiter = find_arbiter(hosts)
    others = [host for host in hosts if host is not arbiter]
    before = [host.cuts() for host in others]
    arbiter.hub.kill()
    wait_until(lambda: [host.cuts() for host in others] == [number + 1 for number in before], "the others go on")
    find_arbiter(others)
    wait_until(lambda: others[0].send("123#DEAD"), "one of them sends")
    for host in others:
        wait_until(lambda: host.frames()[-1][1] == "123#DEAD", "all hear it")


def refuse(hosts):
    for name, words, text in (("faster", ["--bitrate", "500000"], "bit/s, this hub is to have it at 500000 bit/s"),
                              ("without", [], "bit/s, this hub is to have it without a bit rate")):
        late = Host(name, *words)
        wait_until(lambda: late.told(text) == 1, "it says that it does not join")
        time.sleep(0.5)
        assert "lab: cut," in late.status()
        late.hub.terminate()
        assert late.hub.wait(20) == 0
    for host in hosts:
        assert host.told("cut:") == 0


def run():
    (folder / "server.conf").write_text(f"listen: 127.0.0.1:4222\njetstream {{ store_dir: {folder}/store }}\n")
    start("nats-server", "-c", folder / "server.conf", stderr=subprocess.DEVNULL)
    hosts = [Host(name, "--bitrate", RATE) for name in "abc"]
    for host in hosts:
        wait_until(lambda: host.told("joined") == 1, "joined")
        host.listen()
    refuse(hosts)
    compete(hosts)
    stand_still(hosts)
    die(hosts)
    print("one bus with a bit rate over three hubs")


try:
    run()
except BaseException:
    for name in sorted(folder.glob("*.log")) + sorted(folder.glob("*.dump")):
        print(f"--- {name.name}\n{name.read_text()[-4000:]}", file=sys.stderr)
    raise
finally:
    for process in processes:
        process.kill()
        process.wait()
    subprocess.run(["rm", "-rf", folder], check=True)
