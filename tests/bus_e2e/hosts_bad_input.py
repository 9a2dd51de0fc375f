"""Hubs of several hosts before servers that are not as they should be, and before messages that are none.

usage: hosts_bad_input.py PROGRAMS

Each time one line says what is wrong, frames that are lost are counted, and the hub joins when the trouble is over.
"""

import contextlib
import re
import signal
import socket
import struct
import subprocess
import sys
import threading
import time

from hosts import Bench, Host, Server, wait_until
from nats_client import Client

PORTS = iter(range(4300, 4400))
MORE = "max_file_store: 100M"


def lines_of(host):
    """What the hub has written, but for that it serves, and that others are on the bus or no more."""
    lines = [line.split(": ", 2)[2] for line in host.log.read_text().splitlines()[1:]]
    return [line for line in lines if "is on the bus" not in line]


def expect(host, *patterns):
    """The lines of HOST are those."""
    wait_until(lambda: len(lines_of(host)) >= len(patterns), f"{host.name} writes {patterns[-1]}")
    lines = lines_of(host)
    assert len(lines) == len(patterns), (host.name, lines, patterns)
    for line, pattern in zip(lines, patterns):
        assert re.search(pattern, line), (host.name, line, pattern)


def stay(host, *patterns):
    """The same, and a while later still: what does not change is said once."""
    expect(host, *patterns)
    time.sleep(1.5)
    expect(host, *patterns)
    assert not host.status().is_whole
    assert not host.send("123#01"), "sending fails"


class Cases:
    def __init__(self, bench):
        self.bench = bench
        self.servers = []

    def server(self, port, **options):
        self.servers.append(Server(self.bench, f"127.0.0.1:{port}", **options))
        return self.servers[-1]

    def host(self, name, port, *options):
        return Host(self.bench, name, f"nats://127.0.0.1:{port}/lab", *options)

    def end(self):
        for server in self.servers:
            server.kill()
        self.servers.clear()

    def not_there(self):
        port = next(PORTS)
        host = self.host("not-there", port)
        stay(host, "127.0.0.1 cannot be reached: Connection refused")
        self.server(port)
        wait_until(lambda: host.told("joined"), "joined")

    def no_such_name(self):
        host = Host(self.bench, "no-such-name", "nats://nowhere.invalid/lab", "--plain")
        stay(host, "nowhere.invalid cannot be reached: ")

    def says_nothing(self):
        port = next(PORTS)
        with socket.create_server(("127.0.0.1", port)):
            host = self.host("says-nothing", port)
            stay(host, "no answer in time")

    def says_something_else(self):
        port = next(PORTS)
        with socket.create_server(("127.0.0.1", port)) as listener:
            threading.Thread(target=greet, args=(listener,), daemon=True).start()
            host = self.host("something-else", port)
            stay(host, "got '220' instead of 'INFO'")
            listener.shutdown(socket.SHUT_RDWR)
        self.server(port)
        wait_until(lambda: host.told("joined"), "joined")

    def without_jetstream(self):
        port = next(PORTS)
        server = self.server(port)
        server.kill()
        server.configure()
        server.begin()
        host = self.host("without-jetstream", port)
        wait_until(lambda: host.told("stream CAN_lab: the server has no JetStream") == 1, "told")
        server.kill()
        server.restart_with(jetstream=MORE)
        wait_until(lambda: host.told("joined"), "joined")

    def full_at_first(self):
        port = next(PORTS)
        server = self.server(port, jetstream="max_file_store: 100")
        host = self.host("full-at-first", port)
        wait_until(lambda: host.told("nothing that this hub sends comes back: the server is full") == 1, "told")
        time.sleep(2)
        assert host.told("nothing that this hub sends comes back") == 1 and not host.status().is_whole
        server.kill()
        server.restart_with(jetstream=MORE)
        wait_until(lambda: host.told("joined"), "joined")

    def full_later(self):
        port = next(PORTS)
        server = self.server(port, jetstream="max_file_store: 64K")
        host = self.host("full-later", port)
        wait_until(lambda: host.told("joined"), "joined")
        dump = host.dump()
        sent = 0
        while host.status().cuts == 0:
            done = host.run("cangen", "can0", "-g", "1", "-n", "200", "-I", "123", "-L", "8")
            assert done.returncode == 0 or "Network is down" in done.stderr, done
            sent += 1
            assert sent < 100, "the server does not get full"
        wait_until(lambda: "interface down" in dump.text(), "candump is told")
        status = host.status()
        assert status.dropped > 0 and status.under_way == 0, status.text
        wait_until(lambda: host.told("the server is full") == 1, "told")
        server.kill()
        server.restart_with(jetstream=MORE)
        wait_until(lambda: host.told("joined again") == 1, "joined again")
        assert host.send("124#AA")
        wait_until(lambda: dump.frames()[-1][2] == "AA", "frames pass again")

    def stopped(self):
        port = next(PORTS)
        server = self.server(port)
        self.answered(port)
        server.process.send_signal(signal.SIGSTOP)
        host = self.host("stopped", port)
        stay(host, "no answer in time")
        server.process.send_signal(signal.SIGCONT)
        wait_until(lambda: host.told("joined"), "joined")

    def wrong_credentials(self):
        port = next(PORTS)
        server = self.server(port, settings="authorization { user: u, password: p }")
        self.answered(port)
        (self.bench.folder / "garbage.creds").write_text("garbage")
        hosts = [self.host("no-credentials", port), self.host("garbage", port, "--credentials", self.bench.folder / "garbage.creds"),
                 self.host("no-file", port, "--credentials", self.bench.folder / "nothing")]
        for host, pattern in zip(hosts, ("Authorization Violation", "garbage.creds: expected a line NAME:PASSWORD", "nothing: no credentials can be read there")):
            stay(host, pattern)
        server.kill()
        server.restart_with()
        wait_until(lambda: hosts[0].told("joined"), "joined")

    def may_not_publish(self):
        port = next(PORTS)
        server = self.server(port, settings="authorization { users: [{user: u, password: p, permissions: {publish: {deny: \"can.>\"}}}] }\nno_auth_user: u")
        host = self.host("may-not-publish", port)
        wait_until(lambda: host.told("does not let it publish") == 1, "told")
        server.kill()
        server.restart_with()
        wait_until(lambda: host.told("joined"), "joined")

    def another_stream(self):
        port = next(PORTS)
        self.server(port)
        self.answered(port)
        client = Client(("127.0.0.1", port))
        client.ask_jetstream("STREAM.CREATE.CAN_lab", name="CAN_lab", subjects=["another"], storage="memory")
        host = self.host("another-stream", port)
        stay(host, "stream CAN_lab is there and is no bus: expected the subject can.lab.wire, found another")
        client.ask_jetstream("STREAM.DELETE.CAN_lab")
        wait_until(lambda: host.told("joined"), "joined")

    def stream_deleted(self):
        port = next(PORTS)
        self.server(port)
        self.answered(port)
        host = self.host("stream-deleted", port)
        wait_until(lambda: host.told("joined"), "joined")
        Client(("127.0.0.1", port)).ask_jetstream("STREAM.DELETE.CAN_lab")
        wait_until(lambda: host.told("joined again") == 1, "joined again")
        expect(host, "^joined$", "cut: nothing has come back for 500 ms", "joined again")

    def no_frames(self):
        port = next(PORTS)
        self.server(port)
        a, b = self.host("a", port), self.host("b", port)
        for host in (a, b):
            wait_until(lambda host=host: host.told("joined"), "joined")
        dumps = [host.dump() for host in (a, b)]
        client = Client(("127.0.0.1", port))
        client.sub("can.lab.wire")
        wait_until(lambda: a.send("123#01"), "a frame")
        whole = frames_on(client)
        wrong = [b"", b"x", b"\0" * 40, b"\1" * 1000, whole[:-1], whole + b"\0", b"\2" + whole[1:], whole[:1] + b"\7" + whole[2:],
                 whole[:2] + struct.pack("<H", 65) + whole[4:], whole[:4] + b"\0" * 4 + whole[8:], whole[:44] + b"\x09" + whole[45:]]
        for data in wrong:
            client.pub("can.lab.wire", data)
        client.pub("can.lab.wire", whole, headers={"Nats-Msg-Id": "1"})  # that has been there
        client.flush()
        assert b.send("124#02")
        for host, dump in zip((a, b), dumps):
            wait_until(lambda dump=dump: dump.sees("01", "02"), "the frames, and nothing else")
            status = host.status()
            assert status.is_whole and status.cuts == 0, status.text
            assert status.neighbours[f"nats://127.0.0.1:{port}/lab"][3] == len(wrong), status.text
            assert 1 <= host.told("message ") <= 10 and host.told("is of another version"), host.log.read_text()

    def one_name(self):
        """Hubs in containers of one name have the same process number."""
        port = next(PORTS)
        self.server(port)
        third = self.host("third", port)
        twins = [Host(self.bench, name, f"nats://127.0.0.1:{port}/lab", before=["unshare", "--pid", "--fork", "--kill-child"]) for name in ("one", "other")]
        for host in (third, *twins):
            wait_until(lambda host=host: host.told("joined"), "joined")
        dumps = [host.dump() for host in twins]
        wait_until(lambda: len(re.findall(r"\(canhub 1\) +yes", third.status().text)) == 2, "both are on the bus")
        assert third.send("123#01")
        for dump in dumps:
            wait_until(lambda dump=dump: dump.sees("01"), "the frame on both")

    def answered(self, port):
        def asks():
            try:
                socket.create_connection(("127.0.0.1", port)).close()
                return True
            except OSError:
                return False
        wait_until(asks, "the server is there")


def greet(listener):
    """What is no NATS server says something to whoever comes, until nobody listens any more."""
    while True:
        try:
            line, _ = listener.accept()
        except OSError:
            return
        with line, contextlib.suppress(OSError):
            line.sendall(b"220 mail.example ready\r\n")
            line.recv(1)


def frames_on(client):
    """The next message with frames."""
    while True:
        data = client.next().data
        if data[1] == 0:
            return data


CASES = ("not_there", "no_such_name", "says_nothing", "says_something_else", "without_jetstream", "full_at_first", "full_later", "stopped",
         "wrong_credentials", "may_not_publish", "another_stream", "stream_deleted", "no_frames", "one_name")


def main():
    with Bench(sys.argv[1]) as bench:
        cases = Cases(bench)
        for name in sys.argv[2:] or CASES:
            getattr(cases, name)()
            cases.end()
            print(f"{name.replace('_', ' ')}: as it should be", flush=True)


main()
