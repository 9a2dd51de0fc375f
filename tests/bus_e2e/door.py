"""The door of a host on a farm: requests, events, status, deliveries, what is no request, and what dies beside it.

usage: door.py PROGRAMS
"""
import json
import os
import signal
import subprocess
import sys

import nats_client
import programs
from small_farm import PATIENCE, URL, Farm, wait_until

SERVER = ("127.0.0.1", 4222)
FIVE, SIX, SEVEN = "axisd.lab.line1.5", "axisd.lab.line1.6", "axisd.lab.line1.7"
REQUESTS, UNDER_WAY = 10_000, 200
RUBBISH = (b"", b"hello", b"\xff\xfe\0", b"[]", b"{}", b'{"method": 5}', b"[" * 5000, b'{"method": "status", "params": []}', b"x" * 70_000,
           b'{"method": "fly"}', b'{"method": "quit"}', b'{"method": "samples.subscribe", "params": {"signals": "1/speed"}}')


class Client(nats_client.Client):
    def ask(self, unit, method, deliver=None, **params):
        """The answer, an object."""
        request = {"id": 7, "method": method, "params": params, **({"deliver": deliver} if deliver else {})}
        answer = json.loads(self.request(f"{unit}.rpc", json.dumps(request).encode()).data)
        assert answer["id"] == 7, answer
        return answer

    def code(self, unit, method, **options):
        return self.ask(unit, method, **options)["error"]["code"]

    def until(self, subject, condition):
        """The first message on SUBJECT that CONDITION likes, others are left out."""
        while True:
            message = self.next(PATIENCE)
            if message.subject == subject and condition(json.loads(message.data)):
                return json.loads(message.data)


def check_who_is_there(farm):
    client = Client(SERVER)
    client.sub("axisd_host.lab.*.door")
    beats = {}
    while len(beats) < 2:
        client.pub("axisd_host.lab.who")
        beat = json.loads(client.next().data)
        beats[beat["host"]] = beat
    assert [(each["unit"], each["on"], each["axes"], each["profile"], each["node_id"]) for each in beats["a"]["units"]] == [
        ("line1/5", True, 1, "s120", 5)], beats
    assert beats["a"]["instance"] != beats["b"]["instance"]
    units = client.ask(SIX, "units")["result"]["units"]
    assert [(each["unit"], each["host"]) for each in units] == [("line1/6", "b")], units
    services = {}
    client.sub("_INBOX.ping")
    client.pub("$SRV.PING.axisd", b"", "_INBOX.ping")
    while len(services) < 2:
        message = client.next()
        if message.subject == "_INBOX.ping":
            services[json.loads(message.data)["metadata"]["host"]] = json.loads(message.data)
    info = json.loads(client.request(f"$SRV.INFO.axisd.{services['b']['id']}").data)
    assert [each["subject"] for each in info["endpoints"]] == [f"{SIX}.rpc"], info
    lines = farm.output("-b", "units").splitlines()
    assert len(lines) == 2, lines
    print("it says who is there")


def check_what_is_told(farm):
    client = Client(SERVER)
    client.sub(f"{FIVE}.status")
    client.sub(f"{FIVE}.event")
    status = client.until(f"{FIVE}.status", lambda each: True)
    assert (status["unit"], status["host"], status["node_id"]) == ("line1/5", "a", 5), status
    farm.output("--unit", "line1/5", "set", "1/p1120", "3.5")
    event = client.until(f"{FIVE}.event", lambda each: each["kind"] == "parameter")
    assert (event["unit"], event["parameter"], event["value"]) == ("line1/5", "p1120[0]", 3.5), event
    print("status and events come by themselves")


def check_deliveries():
    client = Client(SERVER)
    client.sub("mine.5")

    def take(key):
        return client.until("mine.5", lambda line: key in line)[key]

    sampling = {"signals": ["1/speed"], "period_ms": 50}
    assert client.ask(FIVE, "samples.subscribe", "mine.5", **sampling)["result"] == {}
    assert [take("sample")["unit"] for _ in range(3)] == ["line1/5"] * 3
    assert client.ask(FIVE, "frames.subscribe", "mine.5")["result"] == {}
    assert client.ask(FIVE, "events.subscribe", "mine.5", kinds=["parameter"])["result"] == {}
    client.ask(FIVE, "parameter.write", axis=1, parameter="p1120", value=4.5)
    assert take("event")["value"] == 4.5
    assert client.ask(FIVE, "keep", "mine.5")["result"] == {}
    assert client.ask(FIVE, "samples.unsubscribe", "mine.5")["result"] == {}
    assert client.ask(FIVE, "end", "mine.5")["result"] == {}
    assert client.code(FIVE, "end", deliver="mine.5") == "not-found"
    assert client.code(FIVE, "keep", deliver="mine.6") == "not-found"
    for subject in ("axisd.lab.line1.5.rpc", "$SYS.x", "a b", "a.*", ">", "a..b", "x" * 300):
        assert client.code(FIVE, "samples.subscribe", deliver=subject, **sampling) == "bad-parameter", subject
    # A client that says nothing more is gone.
    assert client.ask(FIVE, "samples.subscribe", "mine.5", **sampling)["result"] == {}
    try:
        while True:
            client.next(5)
    except TimeoutError:
        pass
    print("what units deliver comes where it is wanted, until the client ends it or is gone")


def check_rubbish(farm):
    client = Client(SERVER)

    def counted():
        told = json.loads(client.request("$SRV.STATS.axisd").data)
        while told["metadata"]["host"] != "a":
            told = json.loads(client.request("$SRV.STATS.axisd").data)
        return told["endpoints"][0]

    before = counted()
    codes = []
    for data in RUBBISH:
        codes.append(json.loads(client.request(f"{FIVE}.rpc", data).data)["error"]["code"])
        client.pub(f"{FIVE}.rpc", data)  # nobody waits for an answer
        for subject in (f"{FIVE}.event", f"{FIVE}.status", "axisd_host.lab.who", "axisd_host.lab.a.door", "$SRV.PING"):
            client.pub(subject, data)
    assert codes == ["malformed"] * 8 + ["overflow", "unknown-method", "refused", "bad-parameter"], codes
    client.flush()
    wait_until(lambda: counted()["num_errors"] >= before["num_errors"] + 2 * len(RUBBISH), "all of it is counted")
    assert client.ask(FIVE, "status")["result"]["node_id"] == 5
    farm.doors["a"].expect(r"axisd_host\.lab\.a\.door: .* expected valid JSON")
    print("what is no request is answered with an error, or counted")


def check_many():
    client = Client(SERVER)
    client.sub("_INBOX.many.*")
    request = json.dumps({"method": "status"}).encode()
    answers, asked = set(), 0
    while len(answers) < REQUESTS:
        while asked < REQUESTS and asked - len(answers) < UNDER_WAY:
            client.pub(f"{(FIVE, SIX)[asked % 2]}.rpc", request, f"_INBOX.many.{asked}")
            asked += 1
        message = client.next()
        assert json.loads(message.data)["result"]["node_id"] in (5, 6), message
        answers.add(message.subject)
    print(f"{REQUESTS} requests, {len(answers)} answers")


def check_daemons(farm):
    """One that stands still keeps no other waiting; one that dies is gone, and found when it is back."""
    folder = farm.folder
    seven = folder.path("seven.sock")

    def start_seven():
        unit = folder.start("axisd", "--interface", f"unix:{farm.bus}", "--bus", "line1", "--node-id", "7", "--control", seven,
                            "--state-directory", folder.path("seven"))
        unit.expect("ready: node 7 on")
        return unit

    unit = start_seven()
    farm.doors["a"].end()
    farm.start_door("a", "--socket", seven)
    farm.output("--unit", "line1/7", "wait", "ready", "--timeout", "20")
    client = Client(SERVER)
    farm.units["a"].process.send_signal(signal.SIGSTOP)
    client.pub(f"{FIVE}.rpc", b'{"method": "status"}', "_INBOX.none")
    for _ in range(50):
        assert client.ask(SEVEN, "status")["result"]["node_id"] == 7
    farm.units["a"].process.send_signal(signal.SIGCONT)
    farm.output("--unit", "line1/5", "wait", "ready", "--timeout", "20")
    unit.kill()
    wait_until(lambda: "line1/7" not in farm.output("-b", "units"), "a unit that has died is gone")
    farm.refused(5, "", "--unit", "line1/7", "status")
    unit = start_seven()
    wait_until(lambda: farm.run("--unit", "line1/7", "status").returncode == 0, "and reached again")
    unit.end()
    farm.doors["a"].end()
    farm.start_door("a")
    print("a daemon that stands still or dies is alone in it")


def check_death(farm):
    client = Client(SERVER)
    farm.doors["a"].kill()
    wait_until(lambda: farm.run("--unit", "line1/5", "status").returncode == 5, "host a is silent")
    farm.output("--unit", "line1/6", "status")
    farm.start_door("a")
    farm.output("--unit", "line1/5", "wait", "ready", "--timeout", "20")
    read = client.ask(FIVE, "parameter.read", axis=1, parameters="p1120")["result"]["parameters"]
    assert [each["value"] for each in read] == [4.5], "the unit has gone on"
    print("a door that is killed and started again serves the same units")


def check_second(farm):
    first = farm.doors["a"]
    farm.start_door("a")
    second = farm.doors["a"]
    second.expect("another door on the farm lab is called a, too: this one opens when that is gone")
    farm.output("--unit", "line1/5", "status")
    assert first.process.poll() is None and second.process.poll() is None
    assert "another door" not in first.text
    first.kill()
    second.expect("open: a on the farm lab")
    wait_until(lambda: farm.run("--unit", "line1/5", "status").returncode == 0, "the second one serves")
    assert second.end() == 0
    farm.start_door("a", "--read-only")
    wait_until(lambda: farm.run("--unit", "line1/5", "status").returncode == 0, "it serves")
    assert "--read-only" in farm.refused(3, "read", "--unit", "line1/5", "set", "1/p1120", "1")
    assert farm.output("--unit", "line1/5", "-b", "get", "1/p1120").split()[-1] == "4.5"
    print("of two doors with one name the first one is open")


def check_server(farm):
    """Whatever the server does, SIGTERM ends a door at once."""
    farm.server.send_signal(signal.SIGSTOP)
    farm.doors["a"].expect(r"nats://127\.0\.0\.1:4222: ")
    farm.server.send_signal(signal.SIGCONT)
    farm.doors["a"].expect("connected")
    farm.output("--unit", "line1/5", "wait", "ready", "--timeout", "20")
    farm.server.send_signal(signal.SIGSTOP)
    farm.start_door("c")
    farm.doors["c"].expect(r"nats://127\.0\.0\.1:4222: ")
    for host in ("a", "c"):
        assert farm.doors[host].end() == 0
    farm.server.send_signal(signal.SIGCONT)
    farm.stop_server()
    farm.start_door("a")
    farm.doors["a"].expect(r"nats://127\.0\.0\.1:4222: ")
    farm.start_server()
    farm.doors["a"].expect("connected")
    farm.output("--unit", "line1/5", "wait", "ready", "--timeout", "20")
    print("a server that stands still or is away is waited for")


def check_usage(farm):
    for words, text in (((), "--farm: expected the URL of a farm"), (("--farm", "nats://localhost"), "expected nats://HOST[:PORT]/NAME"),
                        (("--farm", "nats://192.0.2.1/lab"), "is another host"), (("--farm", URL, "--host", "a.b"), "--host: expected a name"),
                        (("--farm", URL, "--log-level", "loud"), "--log-level: expected"), (("--fly",), "axisd-nats --help")):
        done = subprocess.run([os.path.join(farm.folder.bin_folder, "axisd-nats"), *words], env=farm.folder.environment,
                              capture_output=True, text=True, timeout=60, check=False)
        assert done.returncode == 2 and text in done.stderr and done.stderr.count("\n") == 1, (words, done)
        assert done.stderr.startswith("axisd-nats: ") and done.stdout == "", done
    print("a wrong command line is said in one line")


with programs.Folder(sys.argv[1]) as test_folder, Farm(test_folder) as lab:
    wait_until(lambda: len(lab.json("units")["units"]) == 2, "both doors are open")
    check_usage(lab)
    check_who_is_there(lab)
    check_what_is_told(lab)
    check_deliveries()
    check_rubbish(lab)
    check_many()
    check_daemons(lab)
    check_death(lab)
    check_second(lab)
    check_server(lab)
