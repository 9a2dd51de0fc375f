"""axisctl and axisd-http before a farm: two hosts, a server, and what is said when one of them is away.

usage: farm_clients.py PROGRAMS
"""
import json
import os
import pathlib
import signal
import subprocess
import sys

import http_client
import programs
from small_farm import PATIENCE, URL, Farm, wait_until


def check_units(farm):
    wait_until(lambda: len(farm.json("units")["units"]) == 2, "both hosts have told what they have")
    units = {unit["unit"]: unit for unit in farm.json("units")["units"]}
    assert {name: unit["host"] for name, unit in units.items()} == {"line1/5": "a", "line1/6": "b"}, units
    assert units["line1/5"]["interface"] == "line1" and units["line1/5"]["nmt_state"] == "Pre-operational", units
    lines = farm.output("units").splitlines()
    assert lines[0].split()[:1] == ["unit"] and "host" in lines[0] and len(lines) == 3, lines
    assert farm.output("-b", "units", farm=None, AXISD_FARM=URL) == farm.output("-b", "units")


def check_unit(farm):
    assert farm.json("--unit", "line1/5", "status")["node_id"] == 5
    assert farm.json("--unit", "6", "status")["node_id"] == 6
    assert farm.json("--interface", "line1", "--node-id", "6", "status")["node_id"] == 6
    five = ("--unit", "line1/5")
    farm.output(*five, "set", "1/p1120", "2.5")
    assert farm.output(*five, "-b", "get", "1/p1120").split()[-1] == "2.5", farm.output(*five, "-b", "get", "1/p1120")
    assert "start (01h)" in farm.output(*five, "explain", "1")
    assert len(farm.json(*five, "list", "1")["parameters"]) > 100  # in pages
    farm.output(*five, "wait", "ready", "--timeout", "20")
    farm.output(*five, "trace", "start", "1/speed", "--length", "0.05")
    wait_until(lambda: farm.json(*five, "trace", "status")["phase"] == "done", "the trace has been recorded")
    assert farm.output(*five, "trace", "read").splitlines()[0].count("1/speed") == 1
    farm.output(*five, "power", "off")
    farm.refused(8, "switched off", *five, "status")
    wait_until(lambda: not farm.json("units")["units"][0]["on"], "the door tells that it is off")
    farm.output(*five, "power", "on")
    farm.output(*five, "wait", "ready", "--timeout", "20")
    print("units of a farm answer as those of a host")


def check_streams(farm):
    assert len(farm.output("--unit", "line1/5", "-b", "watch", "1/speed", "--every", "0.1", "--count", "4").splitlines()) == 4
    for words, units in (((), {"line1/5", "line1/6"}), (("--unit", "line1/6"), {"line1/6"})):
        monitor = subprocess.Popen([os.path.join(farm.folder.bin_folder, "axisctl"), "--farm", URL, "--json", *words, "monitor",
                                    "fault"], env=farm.folder.environment, stdout=subprocess.PIPE, text=True)
        farm.folder.programs.append(monitor)
        seen = []
        os.set_blocking(monitor.stdout.fileno(), False)

        def told():
            for unit in ("line1/5", "line1/6"):
                farm.output("--unit", unit, "fault", "inject", "1", "7860")
                farm.output("--unit", unit, "fault", "ack", "1")
            seen.extend(json.loads(line)["unit"] for line in monitor.stdout.readlines())
            return set(seen) == units

        wait_until(told, f"events of {units}")
        monitor.kill()
        monitor.wait()
    print("events and samples come over the farm")


def check_refusals(farm):
    assert farm.refused(5, "the farm has no unit on line1 with node-ID 9", "--unit", "line1/9", "status").count("\n") == 1
    farm.refused(5, "has no unit with node-ID 9", "--unit", "9", "status")
    assert farm.refused(2, "several units fit", "status").splitlines()[1:] == ["  line1/5 (host a)", "  line1/6 (host b)"]
    for words in (("run", "drive-dies-in-motion"), ("record", "start"), ("record", "--html", "x.html")):
        assert farm.refused(2, "not with --farm", *words).count("\n") == 1
    farm.refused(3, "a farm is not ended", "--unit", "line1/5", "quit")
    farm.refused(3, "", "--unit", "line1/5", "set", "1/r0063", "1")
    for url, text in (("nats://192.0.2.1/lab", "is another host, and everybody on the way can read and write there"),
                      ("nats://localhost", "expected nats://HOST[:PORT]/NAME")):
        assert farm.refused(2, text, "units", farm=url).count("\n") == 1
    farm.refused(2, "AXISD_FARM: expected", "units", farm=None, AXISD_FARM="lab")
    farm.refused(2, "go with --farm", "--plain", "units", farm=None)
    farm.refused(2, "expected --farm URL", "fleet", "list", farm=None)
    print("what cannot be is refused in one line")


def check_fleet(farm):
    file = farm.folder.path("fleet.json")
    document = {"units": [{"bus": "line1", "node_id": 5, "host": "a"},
                          {"bus": "line9", "node_id": {"from": 1, "to": 3}, "axes": [{}, {}]}],
                "buses": {"line9": {"bitrate": 500000}}}

    def apply(status=0, text=""):
        pathlib.Path(file).write_text(json.dumps(document), encoding="ascii")
        if status:
            return farm.refused(status, text, "fleet", "apply", file)
        applied = farm.json("fleet", "apply", file)
        return [unit["effect"] for unit in applied["units"]] + [bus["effect"] for bus in applied["buses"]]

    assert apply() == ["created"] * 5
    document["units"][0]["sdo_block"] = True
    assert apply() == ["changed"] + ["unchanged"] * 4
    document["units"][1]["axes"] = [{"motor": "none"}]
    assert f"{file}: /units/1/axes/0/motor" in apply(2, "expected")
    document["units"][1] = {"bus": "line1", "node_id": {"from": 5, "to": 6}}
    apply(2, f"{file}: /units/1: line1/5 is wanted by {file}: /units/0 already")
    rows = {row["unit"]: row for row in farm.json("fleet", "list")["units"]}
    assert rows["line1/5"]["state"] == "running" and rows["line1/5"]["hosts"] == ["a"], rows
    assert rows["line1/6"]["state"] == "not wanted" and rows["line9/2"]["state"] == "waiting", rows
    farm.output("fleet", "move", "line1/5", "b")
    assert farm.json("fleet", "list")["units"][0]["hosts"] == ["b"]
    farm.refused(4, "line8/1: not wanted in this farm", "fleet", "move", "line8/1", "b")
    assert farm.output("fleet", "remove", "line9/*").splitlines() == [f"line9/{node} removed" for node in (1, 2, 3)]
    farm.refused(4, "line9/1: not wanted in this farm", "fleet", "remove", "line9/1")
    for word in ("drain", "undrain"):
        farm.output("fleet", word, "a")
    assert farm.json("fleet", "hosts")["hosts"] == []
    saved = farm.folder.path("saved")
    farm.refused(4, "keeps nothing", "fleet", "state", "export", "line1/5", saved)
    pathlib.Path(saved).write_bytes(b"\0\1\n" * 100000)
    farm.output("fleet", "state", "import", "line1/5", saved)
    farm.output("fleet", "state", "export", "line1/5", saved + "2")
    assert pathlib.Path(saved).read_bytes() == pathlib.Path(saved + "2").read_bytes()
    print("a fleet is wanted, changed and looked at")


def check_gateway(farm):
    gateway = http_client.Gateway(farm.folder, "--farm", URL)
    gateway.wait_for_units(lambda units: units == ["line1/5", "line1/6"])
    unit = "/api/v1/units/line1/5"
    _, _, units = gateway.request("GET", "/api/v1/units")
    assert [each["host"] for each in units["units"]] == ["a", "b"] and units["daemons"][0]["socket"] == URL, units
    _, _, overview = gateway.request("GET", "/api/v1/overview")
    assert [(each["unit"], each["host"], each["node_id"]) for each in overview["units"]] == [
        ("line1/5", "a", 5), ("line1/6", "b", 6)], overview
    assert 'axisd_up{unit="line1/6"} 1' in gateway.request("GET", "/metrics")[2]
    assert gateway.request("GET", unit)[2]["node_id"] == 5
    assert gateway.code("PUT", f"{unit}/parameters/p1120?axis=1", {"value": 3}, token=False) == (401, "token-missing")
    with gateway.stream("/api/v1/events") as events, gateway.stream(f"{unit}/samples?signals=1/speed&period_ms=20") as samples:
        samples.expect("sample", unit="line1/5")
        events.expect("units")
        number = 3
        while True:  # until the subscription is there
            number += 0.25
            assert gateway.request("PUT", f"{unit}/parameters/p1120?axis=1", {"value": number})[0] == 200
            if events.expect("event", parameter="p1120[0]")["value"] == number:
                break
    assert gateway.request("GET", f"{unit}/parameters/p1120?axis=1")[2]["parameters"][0]["value"] == number
    assert gateway.code("GET", "/api/v1/units/line1/9")[0] == 404
    return gateway


def check_silence(farm, gateway):
    farm.doors["b"].process.send_signal(signal.SIGSTOP)
    wait_until(lambda: farm.run("--unit", "line1/6", "status").returncode == 5, "host b is silent")
    assert [unit["unit"] for unit in farm.json("units")["units"]] == ["line1/5"]
    wait_until(lambda: gateway.code("GET", "/api/v1/units/line1/6")[0] == 503, "the gateway sees it, too")
    assert gateway.request("GET", "/api/v1/units/line1/5")[0] == 200
    farm.doors["b"].process.send_signal(signal.SIGCONT)
    farm.output("--unit", "line1/6", "wait", "ready", "--timeout", "20")
    wait_until(lambda: gateway.code("GET", "/api/v1/units/line1/6")[0] == 200, "the gateway sees it again")
    print("a host that is silent keeps nobody waiting")


def check_server(farm, gateway):
    monitor = subprocess.Popen([os.path.join(farm.folder.bin_folder, "axisctl"), "--farm", URL, "--json", "monitor"],
                               env=farm.folder.environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    farm.folder.programs.append(monitor)
    farm.output("--unit", "line1/5", "set", "1/p1120", "1.25")
    events = gateway.stream("/api/v1/events")
    farm.stop_server()
    line = farm.refused(5, "nats://127.0.0.1:4222/lab: ", "units")
    assert line.count("\n") == 1, line
    farm.refused(5, "nats://127.0.0.1:4222/lab: ", "fleet", "list")
    assert monitor.wait(PATIENCE) in (5, 7), monitor
    assert monitor.stderr.read().count("\n") == 1
    wait_until(lambda: gateway.code("GET", "/api/v1/units/line1/5")[0] == 503, "the gateway says that it is away")
    farm.start_server()
    wait_until(lambda: gateway.code("GET", "/api/v1/units/line1/5")[0] == 200, "the gateway is back")
    number = 5

    def told():
        nonlocal number
        number += 0.25
        gateway.request("PUT", "/api/v1/units/line1/5/parameters/p1120?axis=1", {"value": number})
        return True

    wait_until(told, "written")
    while events.expect("event", kind="parameter")["value"] < 5.25:
        pass
    events.__exit__()
    print("a server that is away is said in one line, and one that is back is used again")


def check_credentials(farm):
    farm.stop_server()
    farm.start_server("authorization { users = [{user: me, password: right}] }")
    password = farm.folder.path("password")
    pathlib.Path(password).write_text("me:wrong\n", encoding="ascii")
    assert farm.refused(5, "uthorization", "--credentials", password, "units").count("\n") == 1
    assert farm.refused(5, "uthorization", "units").count("\n") == 1
    pathlib.Path(password).write_text("me:right\n", encoding="ascii")
    assert farm.json("--credentials", password, "units") == {"units": []}
    farm.doors["a"].end()
    farm.start_door("a", "--credentials", password)
    farm.output("--credentials", password, "--unit", "line1/5", "wait", "ready", "--timeout", "20")
    print("who is not let in is told so")


with programs.Folder(sys.argv[1]) as test_folder, Farm(test_folder) as lab:
    check_units(lab)
    check_unit(lab)
    check_streams(lab)
    check_refusals(lab)
    check_fleet(lab)
    server = check_gateway(lab)
    check_silence(lab, server)
    check_server(lab, server)
    check_credentials(lab)
