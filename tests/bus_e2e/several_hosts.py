"""Hubs that a NATS server joins: candump and cansend on each, while the server stands still, dies and comes back.

usage: several_hosts.py PROGRAMS
"""

import re
import signal
import subprocess
import sys
import time

from hosts import Bench, Host, Server, wait_until

URL = "nats://127.0.0.1/lab"


def cuts(host):
    """How often its bus was cut, or -1 while it is; its log, which says that too, may leave lines out."""
    found = re.search(r"^nats://127\.0\.0\.1:4222/lab: whole, cut (\d+) times$", host.status().text, re.MULTILINE)
    return int(found[1]) if found else -1


def run(bench):
    server = Server(bench)
    a, b = Host(bench, "a", URL), Host(bench, "b", URL)
    for host in (a, b):
        wait_until(lambda: cuts(host) >= 0, "joined")
    dump_of = {host: host.dump() for host in (a, b)}

    assert a.send("123#11") and b.send("456#22")
    for host in (a, b):
        wait_until(lambda: dump_of[host].sees("11", "22"), "both frames on both hosts")
    assert [line[0] for line in dump_of[a].frames()] == ["TX", "RX"], dump_of[a].frames()
    assert [line[0] for line in dump_of[b].frames()] == ["RX", "TX"], dump_of[b].frames()

    # The server stands still: the bus is cut, nothing of what is sent meanwhile comes later, the sockets go on.
    server.process.send_signal(signal.SIGSTOP)
    wait_until(lambda: not a.send("123#33"), "sending fails while the bus is cut")
    wait_until(lambda: not b.send("123#33"), "sending fails while the bus is cut")
    for host in (a, b):
        wait_until(lambda: "interface down" in dump_of[host].text(), "candump is told")
    time.sleep(1)
    server.process.send_signal(signal.SIGCONT)
    for host in (a, b):
        wait_until(lambda: cuts(host) >= 1, "joined again")
    wait_until(lambda: a.send("123#44"), "a sends again")
    for host in (a, b):
        wait_until(lambda: dump_of[host].frames()[-1][2] == "44", "the frame behind the return")

    # The server dies, and another one begins with nothing. (A machine that has much to do may have cut the bus once more before.)
    cuts_before = {host: cuts(host) for host in (a, b)}
    server.kill()
    wait_until(lambda: not a.send("123#55"), "sending fails while the bus is cut")
    server.forget()
    server.begin()
    for host in (a, b):
        wait_until(lambda: cuts(host) > cuts_before[host], "joined again")
    wait_until(lambda: b.send("456#66"), "b sends again")
    for host in (a, b):
        wait_until(lambda: dump_of[host].frames()[-1][2] == "66", "the frame behind the return")
    # Those with 33 and 55 that were sent before the cut showed may not have passed on one host and be missing on another.
    seen = [[line[2] for line in dump.frames()] for dump in dump_of.values()]
    assert seen[0] == seen[1], seen
    status = a.status().text
    assert re.search(rf"^\S+ \(canhub {b.hub.pid}\) +yes +\d+ +0$", status, re.MULTILINE), status
    print("one bus over two hubs, before and after the server stood still and died")


def refuse(bench):
    for words, text in ((["--join", "nats://192.0.2.1/lab"], "is another host, and everybody on the way can read and write there"),
                        (["--join", "nats://localhost"], "expected nats://HOST[:PORT]/NAME"),
                        (["--join", "nats://localhost/a.b"], "a name of 1 to 32 letters"),
                        (["--join", "nats://u:p@localhost/lab"], "no user in the URL"),
                        (["--join", "nats://localhost:0/lab"], "a port 1 to 65535"),
                        (["--plain"], "go with --join"),
                        (["--join", "nats://localhost/lab", "--tls-key", "x"], "go with each other"),
                        (["--join", "nats://localhost/lab", "--on-demand"], "whose failure nobody would see")):
        done = subprocess.run([str(bench.program("canhub")), "--path", str(bench.folder / "x"), *words], capture_output=True, text=True)
        assert done.returncode == 2 and text in done.stderr, (words, done)
        assert done.stderr.count("\n") == 1, done.stderr


with Bench(sys.argv[1]) as bench:
    refuse(bench)
    run(bench)
