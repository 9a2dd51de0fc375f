"""Hosts of a farm on this machine, each with folders of its own: an agent, a door, and what the agent has started there."""

import base64
import json
import os
import pathlib
import re
import signal
import socket
import struct
import subprocess
import time

import nats_client
from hosts import PATIENCE, Server, wait_until

URL = "nats://127.0.0.1:4222/lab"


class Fleet:
    """A server, and a client of it that sees what lies in the buckets and asks units."""

    def __init__(self, bench):
        self.bench = bench
        self.server = Server(bench)
        wait_until(self.connect, "the server serves")
        self.hosts, self.asked = {}, 0

    def connect(self):
        try:
            self.client = nats_client.Client(("127.0.0.1", 4222), no_responders=True)
        except OSError:
            return False
        return True

    def add(self, name, *options):
        self.hosts[name] = Host(self.bench, name, *options)
        return self.hosts[name]

    def axisctl(self, *words):
        """Its standard output."""
        done = subprocess.run([str(word) for word in (self.bench.program("axisctl"), "--farm", URL, *words)], capture_output=True,
                              text=True, timeout=300)
        assert done.returncode == 0, (words, done)
        return done.stdout

    def want(self, unit, document):
        """UNIT, "line1.5", is wanted as DOCUMENT says, a text or an object; None: it is wanted no more."""
        subject, text = f"$KV.axisd_lab_units.{unit}", document if isinstance(document, str) else json.dumps(document)
        if document is None:
            return self.client.request(subject, headers={"KV-Operation": "DEL"})
        return self.client.request(subject, text.encode())

    def place(self, unit):
        """What lies in the bucket of places for UNIT; nothing if that is nothing."""
        try:
            found = self.client.ask_jetstream("STREAM.MSG.GET.KV_axisd_lab_places",
                                              last_by_subj=f"$KV.axisd_lab_places.{unit}")
        except nats_client.Refused:
            return {}
        return json.loads(base64.b64decode(found["message"].get("data", "")) or "{}")

    def ask(self, unit, method, **params):
        """The answer of UNIT to METHOD; None if nobody answers for it."""
        request = json.dumps({"id": 1, "method": method, "params": params})
        data = self.client.request(f"axisd.lab.{unit}.rpc", request.encode()).data
        return json.loads(data) if data else None

    def ask_all(self, units, method):
        """What UNITS answer, asked at the same time."""
        self.client.sub("answers.>") if not self.asked else None
        self.asked += len(units)
        for number, unit in enumerate(units):
            self.client.pub(f"axisd.lab.{unit}.rpc", json.dumps({"id": number, "method": method}).encode(), f"answers.{number}")
        return [json.loads(self.client.next().data or "{}") for _ in units]

    def answers(self, unit):
        """Whether UNIT is reached at the host that its place says, and runs as it is wanted."""
        place = self.place(unit)
        if not place.get("host") or "problem" in place:
            return False
        return unit in self.hosts[place["host"]].running() and "result" in (self.ask(unit, "status") or {})

    def await_units(self, units, seconds=PATIENCE):
        """Waits until all UNITS answer; how long that was (s)."""
        begin, missing = time.monotonic(), list(units)
        while missing := [unit for unit in missing if not self.answers(unit)]:
            assert time.monotonic() < begin + seconds, ("do not answer", {unit: self.place(unit) for unit in missing[:5]})
            time.sleep(0.05)
        return time.monotonic() - begin

    def units_of(self, host):
        """Those whose place is HOST."""
        return [unit for unit in self.hosts[host].running() if self.place(unit).get("host") == host]

    def await_problem(self, unit, text):
        wait_until(lambda: text in self.place(unit).get("problem", ""), f"{unit}: {text}: {self.place(unit)}")

    def end(self):
        """Ends all that agents have started."""
        for host in self.hosts.values():
            host.kill()


class Host:
    def __init__(self, bench, name, *options):
        self.bench, self.name, self.options = bench, name, options
        self.run, self.log = bench.folder / f"run-{name}", bench.folder / f"{name}.log"
        self.run.mkdir()
        self.start_agent()
        self.start_door()

    def start_agent(self, *options):
        self.agent = self.bench.start(self.bench.program("axisd-agent"), "--farm", URL, "--host", self.name, "--runtime-directory",
                                      self.run, "--state-directory", self.bench.folder / f"state-{self.name}", *self.options, *options,
                                      stderr=self.log.open("a"))

    def start_door(self):
        self.door = self.bench.start(self.bench.program("axisd-nats"), "--farm", URL, "--host", self.name, stderr=self.log.open("a"),
                                     env={**os.environ, "RUNTIME_DIRECTORY": str(self.run)})

    def told(self, text):
        return self.log.read_text(encoding="utf-8").count(text)

    def processes(self, program):
        """The numbers of those of PROGRAM that this host has, whoever has started them."""
        found = []
        for entry in pathlib.Path("/proc").iterdir():
            try:
                words = (entry / "cmdline").read_bytes().split(b"\0") if entry.name.isdigit() else [b""]
            except OSError:
                continue
            if words[0].endswith(b"/" + program.encode()) and any(word.startswith(bytes(self.run) + b"/") for word in words):
                found.append(int(entry.name))
        return found

    def running(self):
        """The process of each unit here, by its control socket."""
        units = {}
        for path in self.run.glob("axisd-*.sock"):
            name = re.fullmatch(r"axisd-(.+)-([^-]+)\.sock", path.name)
            with socket.socket(socket.AF_UNIX) as client:
                try:
                    client.connect(str(path))
                except OSError:
                    continue
                peer = client.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, struct.calcsize("3i"))
                units[f"{name[1]}.{name[2]}"] = struct.unpack("3i", peer)[0]
        return units

    def kill(self):
        """All of it at once, as if the machine had lost its power."""
        self.agent.kill()
        self.door.kill()
        for process in self.processes("canhub") + self.processes("axisd"):
            try:
                os.kill(process, signal.SIGKILL)
            except ProcessLookupError:
                pass
        self.agent.wait()
        self.door.wait()
