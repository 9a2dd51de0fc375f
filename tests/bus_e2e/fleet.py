"""A farm of three hosts on this machine that starts, changes and stops the units that are wanted, and loses a host.

usage: fleet.py PROGRAMS [--units N] [--gates]

--gates: 300 units and 10000 requests, and the units of a host that is lost answer elsewhere within 5 s; on a machine that does nothing
else, and has more than two processors for the three hosts.
"""

import argparse
import json
import os
import signal
import subprocess
import time

from fleet_hosts import URL, Fleet
from hosts import PATIENCE, Bench, wait_until

BUSES = ("line1", "line2", "line3")
# Longer than others wait before they take what is lost.
LONGER_THAN_PATIENCE = 3


def name_of(number):
    return f"{BUSES[number % len(BUSES)]}.{number // len(BUSES) + 1}"


def check_start(fleet, units, options):
    file = fleet.bench.folder / "fleet.json"
    file.write_text(json.dumps({"units": [{"bus": unit.split(".")[0], "node_id": int(unit.split(".")[1]), "axes": [{}]}
                                          for unit in units]}))
    fleet.axisctl("fleet", "apply", "--unchecked", file)
    seconds = fleet.await_units(units, options.patience)
    shares = {name: len(fleet.units_of(name)) for name in fleet.hosts}
    assert sum(shares.values()) == len(units) and max(shares.values()) - min(shares.values()) <= 1, shares
    print(f"{len(units)} units run after {seconds:.1f} s: {shares}")


def check_change(fleet, unit):
    host = fleet.hosts[fleet.place(unit)["host"]]
    before = host.running()
    fleet.want(unit, {"configuration": {"axes": [{"parameters": {"p1120": 3.5}}]}})

    def value():
        answer = fleet.ask(unit, "parameter.read", parameters=["1/p1120"]) or {}
        return answer.get("result", {}).get("parameters", [{}])[0].get("value")

    wait_until(lambda: value() == 3.5, f"{unit} follows its document, not {value()}")
    fleet.await_units([unit])
    after = host.running()
    assert after.pop(unit) != before.pop(unit) and after == before, "no other unit was touched"
    print("a unit follows its document")


def save(fleet, unit, value):
    """UNIT saves p1121 = VALUE, and that lies on the server."""
    assert "result" in fleet.ask(unit, "parameter.write", parameter="1/p1121", value=value)
    assert "result" in fleet.ask(unit, "store")
    note = fleet.bench.folder / f"state-{fleet.place(unit)['host']}" / unit.replace(".", "-") / "agent.json"
    wait_until(lambda: "uploaded" in json.loads(note.read_text()), "what was saved lies on the server")


def saved(fleet, unit):
    return fleet.ask(unit, "parameter.read", parameters=["1/p1121"])["result"]["parameters"][0]["value"]


def check_lost_host(fleet, options):
    lost, others = fleet.units_of("a"), {name: fleet.hosts[name].running() for name in "bc"}
    save(fleet, lost[0], 7.5)
    fleet.hosts["a"].kill()
    seconds = fleet.await_units(lost, options.patience)
    hosts = {place["host"] for place in fleet.places(lost).values()}
    assert "a" not in hosts, hosts
    assert saved(fleet, lost[0]) == 7.5, saved(fleet, lost[0])
    assert all({**fleet.hosts[name].running(), **running} == fleet.hosts[name].running() for name, running in others.items())
    assert not options.gates or seconds <= 5, seconds
    print(f"{len(lost)} units of a lost host run on {sorted(hosts)} after {seconds:.1f} s, with what was saved")
    fleet.hosts["a"].start_agent()
    fleet.hosts["a"].start_door()


def start_next_agent(fleet, host, *options):
    """Waits until it has the units of the one before."""
    def instances():
        return {place["instance"] for place in fleet.places(list(host.running())).values()}

    before = instances()
    host.start_agent(*options)
    wait_until(lambda: not before & instances(), "the next agent has them")


def check_lost_agent(fleet):
    host = fleet.hosts["b"]
    before = host.running()
    host.agent.kill()
    host.agent.wait()
    time.sleep(LONGER_THAN_PATIENCE)
    assert host.running() == before, "units run on without an agent"
    assert not fleet.silent(list(before)), "and are reached"
    start_next_agent(fleet, host)
    fleet.await_units(before)
    assert host.running() == before and sorted(host.processes("axisd")) == sorted(before.values()), "the same, none twice"
    print(f"{len(before)} units run on without their agent, and the next one has them")


def check_ends(fleet, units):
    """A unit and a hub that are killed are started again; a bus that gets a bit rate has hubs with it."""
    unit = units[1]
    host = fleet.hosts[fleet.place(unit)["host"]]
    os.kill(host.running()[unit], signal.SIGKILL)
    wait_until(lambda: fleet.place(unit).get("restarts") == 1, "the agent has seen that its unit has ended")
    fleet.await_units([unit])

    def hubs(*words):
        return [hub for hub in host.processes("canhub") if set(words) <= host.words_of(hub)]

    def is_on_bus():
        return fleet.ask(unit, "status")["result"]["bus"]["link"] == "up"

    path = str(host.run / unit.split(".")[0] / "can-bus")
    hub = hubs(path)
    os.kill(hub[0], signal.SIGKILL)
    wait_until(lambda: hubs(path) and hubs(path) != hub and is_on_bus(), "the hub is started again, and the unit is on its bus")
    fleet.put("axisd_lab_buses", unit.split(".")[0], {"bitrate": 500000})
    wait_until(lambda: hubs(path, "--bitrate", "500000") and is_on_bus(), "the bus has a bit rate")
    print("what ends is started again, and a bus gets a bit rate")


def check_requests(fleet, units, count):
    """Some at the same time, as several clients have them."""
    together = 20
    for begin in range(0, count, together):
        asked = [units[number % len(units)] for number in range(begin, begin + together)]
        refused = [answer for answer in fleet.ask_all(asked, "status") if "result" not in (answer or {})]
        assert not refused, refused
    print(f"{count} requests, all answered")


def check_mistakes(fleet):
    """A document that is no configuration, one that cannot be read, a key that is no unit, a unit that is there already."""
    before = {name: host.running() for name, host in fleet.hosts.items()}
    host = fleet.hosts["b"]
    foreign = fleet.bench.start(fleet.bench.program("axisd"), "--interface", f"unix:{host.run}/line2/can-bus", "--bus", "line2",
                                "--node-id", "126", "--control", host.run / "axisd-line2-126.sock", "--state-directory",
                                fleet.bench.folder / "state-foreign", stderr=subprocess.DEVNULL)
    wait_until(lambda: fleet.ask("line2.126", "status"), "the door tells of a unit that no agent has started")
    fleet.want("line1.125", {"configuration": {"axes": [{"motr": "1fk7063"}]}})
    fleet.want("line2.125", "{")
    fleet.want("line1.nine", {"configuration": {}})
    fleet.want("line2.126", {"configuration": {}})
    fleet.await_problem("line1.125", "configuration: /axes/0/motr: unknown key")
    fleet.await_problem("line2.125", "line2.125: ")
    fleet.await_problem("line2.126", "it is there already, at host b, from a daemon that no agent has started")
    told = {text: sum(host.told(text) for host in fleet.hosts.values())
            for text in ("line1/125: configuration: /axes/0/motr", "line2/125: line2.125: ", "line2/126: it is there already")}
    assert set(told.values()) == {1}, told
    assert all(host.told("line1.nine: expected a key BUS.NODE") == 1 for host in fleet.hosts.values()), "each agent has a line"
    for name, running in before.items():
        assert {**fleet.hosts[name].running(), **running} == fleet.hosts[name].running(), f"units of {name} go on"
    foreign.terminate()
    foreign.wait()
    fleet.await_units(["line2.126"])
    for unit in ("line1.125", "line2.125", "line1.nine", "line2.126"):
        fleet.want(unit, None)
    wait_until(lambda: not any("line2.126" in host.running() for host in fleet.hosts.values()), "a unit that is wanted no more ends")
    print("mistakes are told in a line each, and touch no other unit")


def check_drain(fleet, units, options):
    fleet.axisctl("fleet", "drain", "c")
    wait_until(lambda: not fleet.hosts["c"].running(), "a host gives its units away", options.patience)
    fleet.await_units(units, options.patience)
    fleet.axisctl("fleet", "undrain", "c")
    host = fleet.hosts["b"]
    host.agent.kill()
    host.agent.wait()
    start_next_agent(fleet, host, "--drain-on-stop")
    host.agent.terminate()
    status = host.agent.wait(2 * PATIENCE)
    assert status == 0, f"an agent has given its units away, not {status}"
    left = [host.words_of(process) for process in host.processes("axisd") + host.processes("canhub")]
    assert not left, left
    fleet.await_units(units, options.patience)
    host.start_agent()
    print("hosts give their units away")


def check_server(fleet, units, options):
    """Units whose agents have no contact to the server are stopped, and start again."""
    fleet.server.kill()
    wait_until(lambda: not any(host.running() for host in fleet.hosts.values()), "units without a server are stopped", options.patience)
    fleet.server.begin()
    wait_until(fleet.connect, "the server serves again")
    fleet.await_units(units, options.patience)
    assert all(host.agent.poll() is None for host in fleet.hosts.values())
    print("units are stopped without a server, and start again with it")


def check_forgetful_server(fleet, units, options):
    """A server that comes back without what it had is told it again: documents, places, and what units have saved."""
    save(fleet, units[0], 6.5)
    fleet.server.kill()
    fleet.server.forget()
    fleet.server.begin()
    wait_until(fleet.connect, "the server serves again")
    fleet.await_units(units, options.patience)
    wanted = {row["unit"] for row in json.loads(fleet.axisctl("--json", "fleet", "list"))["units"]}
    assert wanted == {unit.replace(".", "/") for unit in units}, wanted
    file = fleet.bench.folder / "saved.bin"
    wait_until(lambda: fleet.is_kept(units[0], file), "what was saved lies on the server again")
    assert saved(fleet, units[0]) == 6.5, saved(fleet, units[0])
    print("a server without its memory is told what it had")


def run(bench, options):
    units = [name_of(number) for number in range(options.units)]
    fleet = Fleet(bench)
    try:
        for name in "abc":
            fleet.add(name)
        check_start(fleet, units, options)
        check_change(fleet, units[0])
        check_ends(fleet, units)
        check_requests(fleet, units, 10000 if options.gates else 500)
        check_lost_host(fleet, options)
        check_lost_agent(fleet)
        check_mistakes(fleet)
        check_drain(fleet, units, options)
        check_server(fleet, units, options)
        check_forgetful_server(fleet, units, options)
    finally:
        fleet.end()


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("programs")
    parser.add_argument("--units", type=int)
    parser.add_argument("--gates", action="store_true")
    arguments = parser.parse_args()
    arguments.units = arguments.units or (300 if arguments.gates else 9)
    arguments.patience = PATIENCE + arguments.units
    with Bench(arguments.programs) as test_bench:
        run(test_bench, arguments)
