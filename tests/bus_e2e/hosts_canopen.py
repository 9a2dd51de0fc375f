"""A CANopen master on one host, and eight units on two others: one bus over a NATS server, also after it was cut.

usage: hosts_canopen.py PROGRAMS EDS [--gates]; the unit's deviations are known by axisd-deviations.json beside its EDS

Prints how long an SDO upload takes; --gates asserts it, which only a machine without other work can keep.
"""

import json
import pathlib
import subprocess
import sys
import time

from hosts import PATIENCE, Bench, Host, Network, Server, wait_until
from relay import RelayProcess

UNITS = 8
UPLOADS = 100  # of each unit
DELAY = 0.005  # s, each way
CUT = 3  # s
# The gates (s): a master waits so long for an answer at least; the median over two hubs and a server.
MASTERS_PATIENCE, MEDIAN = 0.05, 0.005
TRIES = 5
MASTER = pathlib.Path(__file__).with_name("hosts_master.py")
# What goes to and fro in time. All objects, and thousands of frames, need no other host, and take long.
CHECKED = "nmt,sdo,error-control"


class Unit:
    def __init__(self, bench, host, number):
        self.log = bench.folder / f"unit-{number}.log"
        self.process = bench.start(*host.words, bench.program("axisd"), "--interface", f"unix:{host.path}", "--node-id", number,
                                   "--control", bench.folder / f"unit-{number}.sock", "--state-directory", bench.folder / f"unit-{number}",
                                   "--config", bench.folder / "unit.json", env=host.environment, stderr=self.log.open("w"))
        wait_until(lambda: "ready: node" in self.log.read_text(), f"unit {number} is ready")


class Master:
    def __init__(self, host):
        self.process = host.start("/usr/bin/python3", MASTER, 1, UNITS, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        assert self.answer() == "ready"

    def answer(self):
        found = json.loads(self.process.stdout.readline())
        assert not (isinstance(found, dict) and "error" in found), found
        return found

    def tell(self, *words):
        self.process.stdin.write(" ".join(map(str, words)) + "\n")
        self.process.stdin.flush()
        return self.answer()


class Lab:
    """Units 1 to 4 on a, 5 to 8 on b, the master on c, which reaches the server over a relay."""

    def __init__(self, bench):
        self.bench, network = bench, Network(bench)
        self.server = Server(bench, f"{network.SELF}:4222")
        self.relay = RelayProcess(bench, (network.SELF, 4223), (network.SELF, 4222))
        self.namespaces = [network.add() for _ in "abc"]
        self.a, self.b, self.c = (Host(bench, name, f"nats://{network.SELF}:{port}/lab", "--plain", network=namespace)
                                  for name, port, namespace in zip("abc", (4222, 4222, 4223), self.namespaces))
        for host in (self.a, self.b, self.c):
            wait_until(lambda host=host: host.told("joined"), "joined")
        self.master = Master(self.c)
        (bench.folder / "unit.json").write_text(json.dumps({"axes": [{"parameters": {"p1120": 0.5, "p1121": 0.5}}]}))
        self.on_a, self.on_b = range(1, UNITS // 2 + 1), range(UNITS // 2 + 1, UNITS + 1)
        self.units = [Unit(bench, self.a if number in self.on_a else self.b, number) for number in range(1, UNITS + 1)]
        self.master.tell("boot", *range(1, UNITS + 1))

    def cuts(self):
        return sum(host.status().cuts for host in (self.a, self.b, self.c))

    def undisturbed(self, *words):
        """Has the master do it, and once more if a cut came between that nobody has made."""
        for _ in range(TRIES):
            before = self.cuts()
            try:
                return self.master.tell(*words)
            except AssertionError as error:
                if self.cuts() == before:
                    raise
                print(f"again, a hub was cut by itself: {error}", flush=True)
        raise AssertionError(f"{words}: cut each time")

    def print_times(self, what):
        times = sorted(self.undisturbed("times", UPLOADS))
        print(f"SDO upload {what}: " + ", ".join(f"{name} {1000 * times[min(int(share * len(times)), len(times) - 1)]:.2f} ms"
              for name, share in (("median", 0.5), ("90 %", 0.9), ("99 %", 0.99), ("longest", 1))), flush=True)
        return times

    def drive(self):
        self.undisturbed("start")
        self.undisturbed("heard")
        self.master.tell("stop")
        print(f"{UNITS} units: mapped, started, enabled, turned, stopped", flush=True)

    def cut_host(self):
        """The units on a are cut off: the master misses their heartbeats, and they boot when they are back."""
        self.master.tell("heard")
        self.namespaces[0].set_interface("down")
        missing = self.master.tell("lost", *self.on_a)
        time.sleep(CUT)
        self.namespaces[0].set_interface("up")
        self.master.tell("boot", *self.on_a)
        print(f"host a cut: heartbeats missed after {missing:.2f} s, its units have booted", flush=True)

    def kill_server(self):
        """All are cut, and all boot; some before the master's host is back."""
        self.drive()
        self.master.tell("told")
        self.server.kill()
        wait_until(lambda: self.master.tell("told") > 0, "the master is told that the network is down")
        time.sleep(1)
        self.server.begin()
        self.master.tell("anew")
        print("server killed and begun anew: all units have booted", flush=True)

    def check(self, eds):
        """canopen-check of the last unit, behind which identifiers are free, from the host of the master. It measures by the clock: what fails is looked at again."""
        known = ["--deviations", pathlib.Path(eds).with_name("axisd-deviations.json")]
        options = ["--only", CHECKED]
        for _ in range(TRIES):
            begin, report = time.monotonic(), self.bench.folder / "report.json"
            output = self.c.run(self.bench.program("canopen-check"), "--interface", f"unix:{self.c.path}", "--node", UNITS, "--eds", eds,
                                "--json", report, *known, *options, patience=10 * PATIENCE).stdout
            results = json.loads(report.read_text())["results"]
            wrong = [result["id"] for result in results if result["outcome"] not in ("passed", "skipped", "deviation")]
            passed = sum(result["outcome"] == "passed" for result in results)
            print(f"canopen-check: {passed} passed, {len(wrong)} failed {wrong or ''} in {time.monotonic() - begin:.0f} s", flush=True)
            if not wrong:
                return
            options = ["--only", ",".join(wrong)]
        raise AssertionError(output)


def main():
    gates = "--gates" in sys.argv
    with Bench(sys.argv[1]) as bench:
        lab = Lab(bench)
        near = lab.print_times("over two hubs")
        lab.relay.tell("delay", DELAY)
        far = lab.print_times(f"with {1000 * DELAY:.0f} ms more each way")
        if gates:
            assert near[len(near) // 2] <= MEDIAN and far[-1] <= MASTERS_PATIENCE, "too slow"
        lab.drive()
        lab.relay.tell("delay", 0)
        lab.drive()
        lab.cut_host()
        lab.kill_server()
        lab.drive()
        lab.check(sys.argv[2])


if __name__ == "__main__":
    main()
