"""One bus over three hosts while the wire is cut in every way: the history of all members is that of one bus, and the hubs count what is lost.

usage: hosts_cut.py PROGRAMS [--gates]

Prints how long it took until members were told, and until frames passed again; --gates asserts that too, which only a machine
without other work can keep.
"""

import pathlib
import signal
import subprocess
import sys
import time

from history import SECOND, History, Log
from hosts import PATIENCE, Bench, Host, Network, Server, wait_until
from relay import RelayProcess

RATE = 200  # frames a second of each sender
CUT = 3  # s
SLOW = 14  # s
STALL = 0.3  # s: too short for a cut
DELAY = 0.05  # s
NOTICED, BACK = 1.0, 0.5  # s, the gates
TROUBLES = ("stall_server", "stop_server", "kill_server", "lose_store", "cut_network", "pull_cable", "delay", "hold_back", "hold_there",
            "break_connection", "stop_hub", "stop_listener")
MEMBER = pathlib.Path(__file__).with_name("bus_member.py")


class Station:
    """A host with a sender and a reader."""

    def __init__(self, bench, network, name, port, number):
        self.namespace = network.add()
        self.host = Host(bench, name, f"nats://{network.SELF}:{port}/lab", "--plain", network=self.namespace)
        self.name, self.number, self.sender, self.logs = name, number, None, []
        self.bench = bench

    def add(self, name, *options):
        path = self.bench.folder / f"{self.name}-{name}.member"
        process = self.host.start("/usr/bin/python3", MEMBER, path, *options, stdout=subprocess.DEVNULL)
        wait_until(path.exists, "the member's log")
        self.logs.append(Log(path, self.name, process.pid, int(options[0]) if options else 0))
        wait_until(lambda: process.pid in self.host.status().members, "the member is on the bus")
        return process

    def read(self):
        for log in self.logs:
            log.read()


class Lab:
    """Three hosts; c reaches the server over a relay. What is done to them, and what came of it."""

    def __init__(self, bench):
        network = Network(bench)
        self.server = Server(bench, f"{network.SELF}:4222")
        self.relay = RelayProcess(bench, (network.SELF, 4223), (network.SELF, 4222))
        self.stations = [Station(bench, network, name, port, number)
                         for name, port, number in (("a", 4222, 1), ("b", 4222, 2), ("c", 4223, 3))]
        self.a, self.b, self.c = self.stations
        for station in self.stations:
            wait_until(lambda station=station: self.knows_all(station), "joined by all")
        for station in self.stations:
            station.add("reader")
        self.slow = self.a.add("slow")
        for station in self.stations:
            station.sender = station.add("sender", station.number, RATE)
        self.results = []

    def knows_all(self, station):
        status = station.host.status()
        return status.is_whole and sum(on_bus for on_bus, _, _ in status.hubs.values()) == len(self.stations) - 1

    def logs(self):
        return [log for station in self.stations for log in station.logs]

    def cuts(self):
        for station in self.stations:
            station.read()
        return {log: len(log.cuts) for log in self.logs()}

    def trouble(self, name, stations, begin, end, notices=True):
        """Does BEGIN, and END a while later; members of STATIONS are told of a cut, with NOTICES meanwhile, else then."""
        print(f"{name} ...", flush=True)
        wait_until(lambda: self.is_back(self.logs(), 0), "no host is cut, as of a machine that stood still")
        before, began = self.cuts(), time.time_ns()
        affected = [log for station in stations for log in station.logs]
        begin()
        if notices:
            self.wait_for_cuts(affected, before)
        time.sleep(max(0, CUT - (time.time_ns() - began) / SECOND))
        ended = time.time_ns()
        end()
        self.wait_for_cuts(affected, before)
        wait_until(lambda: self.is_back(affected, ended), f"{name}: frames pass again")
        noticed = max(log.cuts[before[log]].time for log in affected) - (began if notices else ended)
        back = max(next(seen.time for seen in log.seen if seen.time > ended and seen.part > before[log]) for log in affected) - ended
        others = sum(self.cuts().values()) - sum(before.values()) - len(affected)
        self.results.append((name, noticed / SECOND, back / SECOND, others))
        time.sleep(0.5)  # the bus is used between two troubles

    def wait_for_cuts(self, logs, before):
        wait_until(lambda: all(now > before[log] for log, now in self.cuts().items() if log in logs), "members are told of the cut")

    def is_back(self, logs, since):
        self.cuts()
        return all(log.seen[-1].time > since and log.seen[-1].part == len(log.cuts) for log in logs)

    def quiet(self):
        """Nobody sends any more, and all logs end with the same frames."""
        for station in self.stations:
            station.sender.send_signal(signal.SIGUSR1)
        time.sleep(0.2)
        end = time.monotonic() + 60
        while not self.ends_alike():
            assert time.monotonic() < end, "the logs do not end with the same frames"
            for station in self.stations:
                station.sender.send_signal(signal.SIGUSR2)
            time.sleep(1)

    def ends_alike(self):
        for station in self.stations:
            station.read()
        ends = [[(seen.sender, seen.number) for seen in log.seen[-len(self.stations):]] for log in self.logs()]
        return {sender for sender, _ in ends[0]} == {1, 2, 3} and all(end == ends[0] for end in ends)

    # -- what happens to them

    def stop_server(self):
        self.trouble("server stopped", self.stations, lambda: self.server.process.send_signal(signal.SIGSTOP),
                     lambda: self.server.process.send_signal(signal.SIGCONT))

    def kill_server(self):
        self.trouble("server killed, restarted with its store", self.stations, self.server.kill, self.server.begin)

    def lose_store(self):
        def begin():
            self.server.forget()
            self.server.begin()
        self.trouble("server killed, restarted without its store", self.stations, self.server.kill, begin)

    def cut_network(self):
        self.trouble("interface of b down", [self.b], lambda: self.b.namespace.set_interface("down"),
                     lambda: self.b.namespace.set_interface("up"))

    def pull_cable(self):
        self.trouble("cable of b out", [self.b], lambda: self.b.namespace.set_cable("down"),
                     lambda: self.b.namespace.set_cable("up"))

    def hold_back(self):
        self.trouble("all of c held back on its way", [self.c], lambda: self.relay.tell("hold"), lambda: self.relay.tell("release"))

    def hold_there(self):
        """The others are heard all the time, and hear nothing."""
        self.trouble("all that c sends held back on its way", [self.c], lambda: self.relay.tell("hold_there"),
                     lambda: self.relay.tell("release"))

    def break_connection(self):
        self.trouble("connection of c broken", [self.c], lambda: None, lambda: self.relay.tell("cut"), notices=False)

    def stop_hub(self):
        self.trouble("hub of b stopped", [self.b], lambda: self.b.host.hub.send_signal(signal.SIGSTOP),
                     lambda: self.b.host.hub.send_signal(signal.SIGCONT), notices=False)

    def calm(self, name, before):
        """What was done since the cuts BEFORE is no reason for one."""
        self.results.append((name, None, None, sum(self.cuts().values()) - sum(before.values())))

    def stall_server(self):
        before = self.cuts()
        self.server.process.send_signal(signal.SIGSTOP)
        time.sleep(STALL)
        self.server.process.send_signal(signal.SIGCONT)
        time.sleep(1)
        self.calm(f"server stopped for {STALL} s", before)

    def delay(self):
        before = self.cuts()
        self.relay.tell("delay", DELAY)
        time.sleep(CUT)
        self.relay.tell("delay", 0)
        time.sleep(1)
        self.calm(f"{1000 * DELAY:.0f} ms delay of c each way", before)

    def stop_listener(self):
        before = self.cuts()
        self.slow.send_signal(signal.SIGSTOP)
        time.sleep(SLOW)
        wait_until(lambda: self.a.host.status().members[self.slow.pid][2] > 0, "the hub has no more room for what it does not read", 60)
        self.slow.send_signal(signal.SIGCONT)
        log = next(log for log in self.a.logs if log.process == self.slow.pid)
        wait_until(lambda: self.cuts() and log.seen[-1].dropped > 0 and log.seen[-1].time - log.seen[-1].stamp < SECOND,
                   "the slow reader has read what waited, and is told what it has lost")
        self.calm(f"listener of a stopped for {SLOW} s", before)


def judge(lab):
    history = History(lab.logs())
    assert not history.problems, "\n".join([f"{len(history.problems)} problems", *history.problems[:20]])
    end = time.monotonic() + PATIENCE  # the hubs tell each other of the last frames with their next beat
    while differences := history.compare(statuses(lab)):
        assert time.monotonic() < end, "\n".join(differences)
        time.sleep(0.1)
    return history


def statuses(lab):
    return {station.name: station.host.status() for station in lab.stations}


def report(lab, history, gates):
    print(f"{len(history.order)} frames in one order; {sum(len(log.taken()) for log in lab.logs())} were sent")
    for station in lab.stations:
        status = station.host.status()
        print(f"host {station.name}: {status.sent} confirmed, {status.dropped} lost under way, {status.lost} sent while it was cut, "
              f"{status.missed} of others missed, {status.late} late, {status.cuts} cuts")
    print(f"{'':<44} {'noticed':>8} {'back':>8}  other cuts")
    for name, noticed, back, more in lab.results:
        times = f"{noticed:8.3f} {back:8.3f}" if noticed is not None else f"{'':>17}"
        print(f"{name:<44} {times}  {more}")
        if gates:
            assert more == 0, f"{name}: cut where nothing was wrong"
            assert noticed is None or (noticed <= NOTICED and back <= BACK), f"{name}: too late"


def main():
    with Bench(sys.argv[1]) as bench:
        lab = Lab(bench)
        chosen = sys.argv[2:] and [name for name in sys.argv[2:] if not name.startswith("-")]
        for name in chosen or TROUBLES:
            getattr(lab, name)()
        lab.quiet()
        history = judge(lab)
        report(lab, history, "--gates" in sys.argv)


main()
