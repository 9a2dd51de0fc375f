"""canrec on a NATS server: a bus of two hubs recorded, exported against candump, imported, played; damage and failures.

usage: canrec.py PROGRAMS UNREAD_HEADER_LIBRARY
"""
import json
import os
import pathlib
import re
import signal
import socket
import subprocess
import sys
import tempfile
import time

programs, unread_header = map(pathlib.Path, sys.argv[1:])
folder = pathlib.Path(tempfile.mkdtemp(dir="/dev/shm" if os.access("/dev/shm", os.W_OK) else None))
processes = []
SERVER = "nats://localhost"


def start(*words, **options):
    process = subprocess.Popen([str(word) for word in words], **options)
    processes.append(process)
    return process


def wait_until(condition, what, seconds=30):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, f"not within {seconds} s: {what}"
        time.sleep(0.01)


def canrec(*words, status=0, says="", **environment):
    """What it prints; STATUS and SAYS are how it has to end and what it has to say in one line of standard error."""
    done = subprocess.run([programs / "canrec", *map(str, words)], capture_output=True, text=True, timeout=120,
                          env=dict(os.environ, **environment))
    assert done.returncode == status and says in done.stderr, (words, done)
    assert status == 0 or done.stderr.count("\n") == 1, done.stderr
    return done.stdout


class Server:
    def __init__(self, *words):
        self.words = words or ("-c", folder / "server.conf")
        (folder / "server.conf").write_text(f"listen: 127.0.0.1:4222\njetstream {{ store_dir: {folder}/store }}\n")
        self.begin()

    def begin(self):
        self.process = start("nats-server", *self.words, stderr=subprocess.DEVNULL)
        wait_until(self.answers, "the server answers")

    def answers(self):
        try:
            with socket.create_connection(("127.0.0.1", 4222), timeout=1) as connection:
                return connection.recv(4) == b"INFO"
        except OSError:
            return False

    def end(self):
        self.process.kill()
        self.process.wait()


class Bus:
    """A bus in user space, and candump on it from the beginning. Joined: its hub is one of several."""

    def __init__(self, name, joined=False):
        self.path, self.log, self.dump = (folder / f"{name}{end}" for end in ("", ".log", ".dump"))
        self.url = f"unix:{self.path}"
        join = ["--join", "nats://127.0.0.1/lab"] if joined else []
        self.hub = start(programs / "canhub", "--path", self.path, *join, stderr=self.log.open("w"))
        wait_until(lambda: ("joined" if joined else "ready") in self.log.read_text(), "the hub serves")
        self.dump.touch()
        self.reader = start(programs / "with-can", "candump", "-D", "-L", "can0", env=dict(os.environ, CAN_BUS=str(self.path)),
                            stdout=self.dump.open("a"), stderr=subprocess.DEVNULL)
        wait_until(self.has_reader, "candump reads")

    def has_reader(self):
        status = subprocess.run([programs / "canhub", "--status", "--path", self.path], capture_output=True, text=True, check=True)
        return re.search(rf"^raw +{self.reader.pid} ", status.stdout, re.MULTILINE)

    def lines(self):
        return [line for line in self.dump.read_text().split("\n")[:-1] if line]

    def forget(self):
        """candump goes on behind what was there; the lines from here on are new."""
        self.dump.write_text("")


def log_file(name, frames, interval=0.001, interface="can0"):
    path = folder / name
    path.write_text("".join(f"({1700000000 + number * interval:.6f}) {interface} {frame}\n"
                            for number, frame in enumerate(frames)))
    return path


def frames_of(lines):
    return [line.split()[2] for line in lines]


def stamps_of(lines):
    return [float(line[1:line.index(")")]) for line in lines]


def recordings():
    return {each["name"]: each for each in json.loads(canrec("list", SERVER, "--json"))["recordings"]}


def publish(data):
    with socket.create_connection(("127.0.0.1", 4222)) as connection:
        connection.sendall(b'CONNECT {"verbose":false}\r\nPUB can.lab.wire %d\r\n%s\r\nPING\r\n' % (len(data), data))
        answer = b""
        while b"PONG" not in answer:
            answer += connection.recv(4096)


def send_from(*buses):
    """Frames of every kind from all buses at once; how many."""
    count = 0
    players = []
    for number, bus in enumerate(buses):
        frames = [f"{number + 1:X}{i:02X}#{i:016X}" for i in range(150)]
        frames += [f"1{number:X}ABCD{i:02X}#{i:02X}" for i in range(50)] + ["7FF#", "7FE#R", "123#R4", "00000001#R8", "000#00"]
        log = log_file(f"send{number}.log", frames, interval=0.002)
        players.append(start(programs / "canrec", "play", log, "--onto", bus.url, "--speed", "2", stderr=subprocess.DEVNULL))
        count += len(frames)
    for player in players:
        assert player.wait(60) == 0
    return count


def record(a, b):
    """The recording is what candump shows on both hosts, to the time stamp; the lines of its log."""
    canrec("record", f"{SERVER}/nobus", "night", status=4, says="there is no bus nobus, no hub has joined it")
    canrec("record", f"{SERVER}/lab", "night")
    canrec("record", f"{SERVER}/lab", "night", status=4, says="there is a recording night already")
    count = send_from(a, b)
    for bus in (a, b):
        wait_until(lambda: len(bus.lines()) == count, "all frames on both hosts")
    assert recordings()["night"]["state"] == "running", recordings()
    canrec("stop", f"{SERVER}/night", says="messages of bus lab are in night")
    last = log_file("last.log", ["7FD#AA"])
    canrec("play", last, "--onto", a.url, says="1 frames sent")
    wait_until(lambda: len(b.lines()) == count + 1, "the frame behind the recording")

    canrec("export", f"{SERVER}/night", folder / "night.log", says=f"canrec: {count} frames, none missed\n")
    lines = (folder / "night.log").read_text().split("\n")[:-1]
    for bus in (a, b):
        assert [line.replace(" can0 ", " lab ") for line in bus.lines()[:-1]] == lines
    assert canrec("export", f"{SERVER}/night", "--interface", "can0").split("\n")[:-1] == a.lines()[:-1]
    night = recordings()["night"]
    assert night["state"] == "stopped" and night["bus"] == "lab" and night["bytes"] > 0, night
    # Stamps are cut off to microseconds, and a double of today has a quarter of one.
    assert night["from"] <= stamps_of(lines)[0] + 2e-6 and stamps_of(lines)[-1] <= night["to"] + 2e-6, night
    assert re.search(r"^night +lab +stopped +\d+ +\d+  \d{4}-\d\d-\d\d \d\d:\d\d:\d\d\.\d{3}Z  \d{4}-", canrec("list", SERVER), re.M)
    return lines


def play(lines):
    """The same frames in the same order, none before its time."""
    for source in (f"{SERVER}/night", f"{SERVER}/copy", folder / "night.log"):
        for speed in (None, 10, 1):
            if speed == 1 and source == folder / "night.log":
                continue
            bus.forget()
            begin = time.time()
            words = ["--fast"] if speed is None else ["--speed", speed]
            canrec("play", source, "--onto", bus.url, *words, says=f"canrec: {len(lines)} frames sent in ")
            wait_until(lambda: len(bus.lines()) >= len(lines), "all frames")
            assert frames_of(bus.lines()) == frames_of(lines), (source, speed)
            if speed is None:
                continue
            first = stamps_of(lines)[0]
            for was, played in zip(stamps_of(lines), stamps_of(bus.lines())):
                assert played - begin >= (was - first) / speed - 1e-3, (source, speed, was, played)


def play_parts(lines):
    stamp = lines[100].split(")")[0][1:]
    behind = [line for line in lines if line.split(")")[0][1:] >= stamp]
    bus.forget()
    canrec("play", folder / "night.log", "--onto", bus.url, "--fast", "--from", f"@{stamp}",
           says=f"canrec: {len(behind)} frames sent")
    wait_until(lambda: len(bus.lines()) == len(behind), "the frames from a time stamp on")
    assert frames_of(bus.lines()) == frames_of(behind)
    canrec("play", f"{SERVER}/night", "--onto", bus.url, "--fast", "--to", "0", says="canrec: 0 frames sent")


def copy(lines):
    """A log that is imported is exported as it was."""
    canrec("import", folder / "night.log", f"{SERVER}/copy", says=f"{len(lines)} frames of lab are in copy")
    canrec("import", folder / "night.log", f"{SERVER}/copy", status=4, says="there is a recording copy already")
    assert canrec("export", f"{SERVER}/copy").split("\n")[:-1] == lines
    entry = recordings()["copy"]
    assert entry["log"] == "lab" and entry["state"] == "stopped", entry
    assert abs(entry["from"] - stamps_of(lines)[0]) < 1e-5 and abs(entry["to"] - stamps_of(lines)[-1]) < 1e-5, entry
    error = log_file("error.log", ["123#11", "20000004#000C000000000000", "124#"])
    canrec("import", error, f"{SERVER}/errors")
    assert canrec("export", f"{SERVER}/errors") == error.read_text()
    canrec("play", f"{SERVER}/errors", "--onto", bus.url, says="; 1 error frames left out")


def without_memory(lines):
    """A frame whose time cannot be read gets no other one."""
    preloaded = {"LD_PRELOAD": str(unread_header), "UNREAD_HEADER": "Can-Time"}
    assert canrec("export", f"{SERVER}/copy", status=3, says="copy: No Memory", **preloaded) == ""
    assert canrec("export", f"{SERVER}/copy", LD_PRELOAD=str(unread_header)).split("\n")[:-1] == lines


def damage():
    cut = folder / "cut.log"
    cut.write_text("(1700000000.000000) can0 123#11\n(1700000000.001000) can0 124#22\n(1700000000.00")
    canrec("import", cut, f"{SERVER}/cut", status=5, says=f'canrec: {cut}:3: expected (SECONDS.MICROSECONDS) at the beginning, got')
    canrec("play", cut, "--onto", bus.url, status=5, says=f"canrec: {cut}:3: expected")
    assert "cut" not in recordings()
    canrec("import", cut, f"{SERVER}/cut", "--skip-damaged", says="1 damaged lines are left out")
    assert frames_of(canrec("export", f"{SERVER}/cut").split("\n")[:-1]) == ["123#11", "124#22"]
    canrec("import", folder / "cut", f"{SERVER}/x", status=1, says=": No such file or directory")
    canrec("export", f"{SERVER}/night", "/dev/full", status=1, says="/dev/full: No space left on device")
    canrec("export", f"{SERVER}/night", folder / "none" / "x.log", status=1, says=": No such file or directory")
    for word in ("export", "stop", "remove"):
        canrec(word, f"{SERVER}/nothing", status=4, says="there is no recording nothing")
    canrec("remove", f"{SERVER}/cut")
    assert "cut" not in recordings()


def limits(a):
    """Messages that are none; the oldest make room."""
    canrec("record", f"{SERVER}/lab", "small", "--max-bytes", "20k")
    canrec("record", f"{SERVER}/lab", "young", "--max-age", "1s")
    canrec("record", f"{SERVER}/lab", "noise")
    publish(b"noise")
    canrec("play", log_file("many.log", [f"123#{i:04X}" for i in range(3000)]), "--onto", a.url, "--speed", "3")
    canrec("stop", f"{SERVER}/noise")
    canrec("export", f"{SERVER}/noise", "/dev/null", says="canrec: 3000 frames, none missed; 1 messages that are none of a hub")
    first = recordings()["young"]["from"]
    wait_until(lambda: recordings()["young"].get("from", 0) > first + 1, "what is old is forgotten")
    small = recordings()["small"]
    assert 0 < small["bytes"] <= 20 * 1024, small


def failures(server, a):
    """A server that begins anew with what it had; one that stands still, is not there, has no JetStream."""
    canrec("record", f"{SERVER}/lab", "long")
    canrec("play", log_file("one.log", ["111#01"]), "--onto", a.url)
    wait_until(lambda: "111#01" in canrec("export", f"{SERVER}/long"), "the frame is in the recording")
    server.process.terminate()  # it writes what it has
    server.process.wait()
    server.begin()
    wait_until(lambda: a.log.read_text().count("joined again") == 1, "the hub is back")
    canrec("play", log_file("two.log", ["111#02"]), "--onto", a.url)
    wait_until(lambda: "111#02" in canrec("export", f"{SERVER}/long"), "the recording goes on")
    assert frames_of(canrec("export", f"{SERVER}/long").split("\n")[:-1]) == ["111#01", "111#02"]

    hour = log_file("hour.log", ["111#03", "111#04"], interval=3600)
    player = start(programs / "canrec", "play", hour, "--onto", a.url, stderr=subprocess.PIPE, text=True)
    wait_until(lambda: "111#03" in a.dump.read_text(), "the first frame")
    server.process.send_signal(signal.SIGSTOP)
    canrec("list", SERVER, status=3, says="no answer in time")
    assert player.wait(30) == 7
    assert player.stderr.read() == f"canrec: {a.url} is down, 1 frames had been sent\n"
    server.process.send_signal(signal.SIGCONT)
    server.end()
    canrec("list", SERVER, status=3, says="nats://localhost:4222: No server available for connection")
    plain = Server("-a", "127.0.0.1")
    for words in (["list", SERVER], ["record", f"{SERVER}/lab", "x"], ["export", f"{SERVER}/night"], ["import", hour, f"{SERVER}/x"]):
        canrec(*words, status=3, says="nats://localhost:4222: the server has no JetStream")
    plain.end()


def interrupted():
    """A signal ends it, and what was sent is said."""
    bus.forget()
    hour = log_file("hour.log", ["111#05", "111#06"], interval=3600)
    player = start(programs / "canrec", "play", hour, "--onto", bus.url, stderr=subprocess.PIPE, text=True)
    wait_until(lambda: len(bus.lines()) == 1, "the first frame")
    player.send_signal(signal.SIGINT)
    assert player.wait(30) == -signal.SIGINT
    assert player.stderr.read().startswith("canrec: 1 frames sent in ")
    player = start(programs / "canrec", "play", hour, "--onto", bus.url, stderr=subprocess.PIPE, text=True)
    wait_until(lambda: len(bus.lines()) == 2, "the first frame")
    bus.hub.kill()
    assert player.wait(30) == 7, player.stderr.read()


try:
    server = Server()
    assert canrec("list", SERVER) == "no recordings\n"
    hubs = Bus("a", joined=True), Bus("b", joined=True)
    bus = Bus("c")
    recorded = record(*hubs)
    copy(recorded)
    without_memory(recorded)
    play(recorded)
    play_parts(recorded)
    damage()
    limits(hubs[0])
    failures(server, hubs[0])
    interrupted()
    print(f"{len(recorded)} frames of two hubs recorded, exported, imported and played")
except BaseException:
    for name in sorted(folder.glob("*.log")) + sorted(folder.glob("*.dump")):
        text = name.read_text()
        print(f"--- {name.name}\n{text[:2000]}", file=sys.stderr)
    raise
finally:
    for process in processes:
        process.kill()
        process.wait()
    subprocess.run(["rm", "-rf", folder], check=True)
