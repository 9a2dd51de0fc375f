"""Hubs of several hosts, the NATS server that joins them, and the networks between them, for tests."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

PATIENCE = 20  # s, for what should come at once: machines of others are slow


def wait_until(condition, what, seconds=PATIENCE):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, f"not within {seconds} s: {what}"
        time.sleep(0.01)


class Bench:
    """The folder of a test, and the programs that are started in it. Their logs are printed if the test fails."""

    PIPE = subprocess.PIPE

    def __init__(self, programs):
        self.programs = pathlib.Path(programs).resolve()
        self.processes = []

    def __enter__(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="axisd-test-", dir="/dev/shm" if os.access("/dev/shm", os.W_OK) else None))
        return self

    def __exit__(self, kind, *_):
        for process in reversed(self.processes):
            process.kill()
            process.wait()
        if kind is not None or os.environ.get('SHOW'):
            for path in sorted(self.folder.glob("*.log")) + sorted(self.folder.glob("*.dump")):
                print(f"--- {path.name}\n{path.read_text()[-6000:]}", file=sys.stderr)
        subprocess.run(["rm", "-rf", self.folder], check=True)

    def start(self, *words, **options):
        process = subprocess.Popen([str(word) for word in words], **options)
        self.processes.append(process)
        return process

    def program(self, name):
        return self.programs / name


class Server:
    """nats-server at ADDRESS; what SETTINGS say stands in its configuration, with what JETSTREAM says of that."""

    def __init__(self, bench, address="127.0.0.1:4222", settings="", jetstream=""):
        self.bench, self.address = bench, address
        self.store = bench.folder / f"store-{address.split(':')[1]}"
        self.restart_with(settings, jetstream)

    def configure(self, settings="", jetstream=""):
        self.file = self.bench.folder / f"server-{self.address.split(':')[1]}.conf"
        self.file.write_text(f"listen: {self.address}\n{settings}\n{jetstream}\n")

    def begin(self):
        log = self.bench.folder / f"server-{self.address.split(':')[1]}.log"
        self.process = self.bench.start("nats-server", "-c", self.file, stderr=log.open("a"))

    def kill(self):
        self.process.kill()
        self.process.wait()

    def restart_with(self, settings="", jetstream=""):
        self.configure(settings, f"jetstream {{ store_dir: {self.store}\n{jetstream} }}")
        self.begin()

    def forget(self):
        """Removes all that it has stored."""
        subprocess.run(["rm", "-rf", self.store], check=True)


class Network:
    """Networks of hosts, beside the one that the test runs in: each has eth0 on one bridge. SELF is the test's address there."""

    SELF = "10.77.0.1"

    def __init__(self, bench):
        self.bench = bench
        run("ip", "link", "add", "bus0", "type", "bridge")
        run("ip", "addr", "add", f"{self.SELF}/24", "dev", "bus0")
        run("ip", "link", "set", "bus0", "up")
        self.count = 0

    def add(self):
        self.count += 1
        return Namespace(self.bench, self.count)


class Namespace:
    """A network of its own, held by a process; words() go before a command that shall run in it."""

    def __init__(self, bench, number):
        self.cable = f"cable{number}"
        self.holder = bench.start("unshare", "--net", "sleep", "infinity")
        own = os.readlink("/proc/self/ns/net")
        wait_until(lambda: os.readlink(f"/proc/{self.holder.pid}/ns/net") != own, "a network of its own")
        run("ip", "link", "add", self.cable, "type", "veth", "peer", "name", "eth0", "netns", self.holder.pid)
        run("ip", "link", "set", self.cable, "master", "bus0", "up")
        for words in (("addr", "add", f"10.77.0.{number + 1}/24", "dev", "eth0"), ("link", "set", "lo", "up"),
                      ("link", "set", "eth0", "up")):
            run(*self.words(), "ip", *words)

    def words(self):
        return ["nsenter", f"--net=/proc/{self.holder.pid}/ns/net"]

    def set_interface(self, state):
        """eth0 goes "down" or "up", as the host itself sees it."""
        run(*self.words(), "ip", "link", "set", "eth0", state)

    def set_cable(self, state):
        """The other end of it goes "down" or "up": the cable is out."""
        run("ip", "link", "set", self.cable, state)


def run(*words):
    subprocess.run([str(word) for word in words], check=True)


class Host:
    """A hub that joins URL, with its bus; in NETWORK, a Namespace, if one is given. BEFORE are words before the hub's."""

    def __init__(self, bench, name, url, *options, network=None, before=()):
        self.bench, self.name, self.words = bench, name, network.words() if network else []
        self.path, self.log = bench.folder / name, bench.folder / f"{name}.log"
        self.environment = dict(os.environ, CAN_BUS=str(self.path), PYTHONDONTWRITEBYTECODE="1")
        self.hub = bench.start(*self.words, *before, bench.program("canhub"), "--path", self.path, "--join", url, *options,
                               stderr=self.log.open("w"))
        wait_until(lambda: "ready" in self.log.read_text(), "the hub serves")

    def start(self, *words, **options):
        """A program on its bus."""
        return self.bench.start(*self.words, self.bench.program("with-can"), *words, env=self.environment, **options)

    def dump(self):
        """candump on its bus, which writes to a file from now on."""
        file, before = self.bench.folder / f"{self.name}.dump", self.status().raw_sockets
        self.start("candump", "-D", "-x", "can0", stdout=file.open("w"), stderr=subprocess.STDOUT)
        wait_until(lambda: self.status().raw_sockets > before, "candump listens")
        return Dump(file)

    def run(self, *words, patience=3 * PATIENCE):
        """A program on its bus that ends by itself."""
        return subprocess.run([str(word) for word in (*self.words, self.bench.program("with-can"), *words)], env=self.environment,
                              capture_output=True, text=True, timeout=patience)

    def send(self, frame):
        """False: the network is down."""
        done = self.run("cansend", "can0", frame)
        assert done.returncode == 0 or "Network is down" in done.stderr, done.stderr
        return done.returncode == 0

    def told(self, text):
        """How often the hub has written TEXT."""
        return self.log.read_text().count(text)

    def status(self):
        return Status(subprocess.run([str(self.bench.program("canhub")), "--status", "--path", str(self.path)],
                                     capture_output=True, text=True, check=True).stdout)


class Dump:
    """What candump has written."""

    def __init__(self, file):
        self.file = file

    def text(self):
        return self.file.read_text()

    def frames(self):
        """(RX or TX, identifier, data) each."""
        found = re.findall(r"([RT]X)\s+\S+\s+\S+\s+([0-9A-F]+)\s+\[\d\]\s+(.*)", self.text())
        return [(way, identifier, data.strip()) for way, identifier, data in found]

    def sees(self, *data):
        return [frame[2] for frame in self.frames()] == list(data)


class Status:
    """What `canhub --status` says of a bus of several hosts."""

    def __init__(self, text):
        self.text = text
        self.frames = self._number(r"^bus \S+: .*, (\d+) frames$")
        self.is_whole = re.search(r"^(?:nats|tls)://\S+: whole,", text, re.MULTILINE) is not None
        self.cuts = self._number(r", cut (\d+) times$")
        self.sent = self._number(r"^frames: (\d+) sent")
        self.received = self._number(r"(\d+) received")
        self.under_way = self._number(r"(\d+) under way;")
        self.dropped = self._number(r"^lost: (\d+) under way")
        self.lost = self._number(r"and (\d+) sent while")
        self.missed = self._number(r"(\d+) of others missed")
        self.late = self._number(r"(\d+) of others late")
        rows = re.findall(r"^(.+?) +(yes|no) +(\d+) +(\d+)$", text, re.MULTILINE)
        self.hubs = {name: (on_bus == "yes", int(received), int(missed)) for name, on_bus, received, missed in rows}
        rows = re.findall(r"^(\S+://\S+) +0 \S+ +(\d+) +(\d+) +(\d+) +(\d+)$", text, re.MULTILINE)
        self.neighbours = {row[0]: [int(figure) for figure in row[1:]] for row in rows}  # sent, received, dropped, refused
        rows = re.findall(r"^(raw|port|bcm) +(\d+) [^- ]\S* +(\d+) +(\d+) +(\d+) +(\d+)$", text, re.MULTILINE)
        self.members = {int(row[1]): [int(figure) for figure in row[2:]] for row in rows}  # sent, received, dropped, refused
        self.raw_sockets = sum(row[0] == "raw" for row in rows)  # that are bound

    def _number(self, pattern):
        found = re.search(pattern, self.text, re.MULTILINE)
        assert found, (pattern, self.text)
        return int(found.group(1))
