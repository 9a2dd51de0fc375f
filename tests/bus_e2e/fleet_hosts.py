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
ANSWER_PATIENCE = 5  # s; a request to a unit that is just being started again may get none
# Units that are asked for at a time while others start: asking all of them again and again would take the processor from these.
ASKED_AT_ONCE = 10


class Fleet:
    """A server, and a client of it that sees what lies in the buckets and asks units. PATIENCE (s): for the answer of a unit."""

    def __init__(self, bench, patience=ANSWER_PATIENCE):
        self.bench, self.patience, self.hosts = bench, patience, {}
        self.server = self.serve()
        wait_until(self.connect, "the server serves")

    def serve(self):
        return Server(self.bench)

    def connect(self):
        try:
            self.client = nats_client.Client(("127.0.0.1", 4222), no_responders=True)
        except OSError:
            return False
        self.asked = 0  # requests of request_all(), over this connection
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

    def is_kept(self, unit, file):
        """Whether what UNIT has saved lies on the server; it is copied into FILE."""
        words = [self.bench.program("axisctl"), "--farm", URL, "fleet", "state", "export", unit.replace(".", "/"), file]
        return subprocess.run(words, capture_output=True).returncode == 0

    def want(self, unit, document):
        """UNIT, "line1.5", is wanted as DOCUMENT says, a text or an object; None: it is wanted no more."""
        if document is None:
            return self.client.request(f"$KV.axisd_lab_units.{unit}", headers={"KV-Operation": "DEL"})
        return self.put("axisd_lab_units", unit, document)

    def put(self, bucket, key, document):
        text = document if isinstance(document, str) else json.dumps(document)
        return self.client.request(f"$KV.{bucket}.{key}", text.encode())

    def request_all(self, requests):
        """The answers to REQUESTS, (subject, data) each, that are asked at the same time; b"" where nobody listens, or answers in time."""
        if not self.asked:
            self.client.sub("answers.*")
        answers = {f"answers.{self.asked + number}": None for number, _ in enumerate(requests)}
        self.asked += len(requests)
        for (subject, data), reply in zip(requests, answers):
            self.client.pub(subject, json.dumps(data).encode(), reply)
        try:
            for _ in answers:
                answer = self.client.next(self.patience)
                answers[answer.subject] = answer.data
        except TimeoutError:
            self.connect()  # what comes late is nobody's
        return [answer or b"" for answer in answers.values()]

    def places(self, units):
        """What lies in the bucket of places for each of UNITS, {} if that is nothing."""
        def content(answer):
            return json.loads(base64.b64decode(json.loads(answer or "{}").get("message", {}).get("data", "")) or "{}")

        # nats-server 2.9 crashes if it is asked for a message of a stream that it is just making.
        held = json.loads(self.request_all([("$JS.API.STREAM.INFO.KV_axisd_lab_places", {})])[0] or "{}")
        if not held.get("state", {}).get("messages"):
            return {unit: {} for unit in units}
        subject = "$JS.API.STREAM.MSG.GET.KV_axisd_lab_places"
        answers = self.request_all([(subject, {"last_by_subj": f"$KV.axisd_lab_places.{unit}"}) for unit in units])
        return {unit: content(answer) for unit, answer in zip(units, answers)}

    def place(self, unit):
        return self.places([unit])[unit]

    def ask_all(self, units, method, **params):
        """The answers of UNITS to METHOD; None of those for which nobody answers."""
        answers = self.request_all([(f"axisd.lab.{unit}.rpc", {"id": 1, "method": method, "params": params}) for unit in units])
        return [json.loads(answer) if answer else None for answer in answers]

    def ask(self, unit, method, **params):
        return self.ask_all([unit], method, **params)[0]

    def silent(self, units):
        """Those of UNITS that are not reached, or do not run as they are wanted."""
        reached = [unit for unit, answer in zip(units, self.ask_all(units, "status")) if "result" in (answer or {})]
        good = {unit for unit, place in self.places(reached).items() if place.get("host") and "problem" not in place}
        return [unit for unit in units if unit not in good]

    def await_units(self, units, seconds=PATIENCE):
        """Waits until all UNITS answer; how long that was (s)."""
        begin, missing = time.monotonic(), list(units)
        while missing:
            missing[:ASKED_AT_ONCE] = silent = self.silent(missing[:ASKED_AT_ONCE])
            assert time.monotonic() < begin + seconds, ("do not answer", list(self.places(silent).items())[:5])
            if silent:
                time.sleep(0.1)
        return time.monotonic() - begin

    def units_of(self, host):
        """Those whose place is HOST."""
        return [unit for unit, place in self.places(list(self.hosts[host].running())).items() if place.get("host") == host]

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
        """The numbers of those of PROGRAM that serve on this host, whoever has started them."""
        found, path = [], str(self.bench.program(program))
        for number in (int(entry.name) for entry in pathlib.Path("/proc").iterdir() if entry.name.isdigit()):
            words = self.words_of(number)
            is_here = any(word.startswith(f"{self.run}/") for word in words) and "--check-config" not in words
            if is_here and path in words:
                found.append(number)
        return found

    @staticmethod
    def words_of(number):
        """The words that process NUMBER was started with; none if it is no more."""
        try:
            return set(pathlib.Path(f"/proc/{number}/cmdline").read_text().split("\0"))
        except OSError:
            return set()

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
