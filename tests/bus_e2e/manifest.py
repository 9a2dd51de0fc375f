"""The manifest for Kubernetes of examples/fleet: the commands of its pods, on one machine, run the units of the file beside it.

usage: manifest.py PROGRAMS EXAMPLES
"""

import json
import os
import pathlib
import sys

import yaml

from fleet_hosts import Fleet
from hosts import PATIENCE, Bench, wait_until


def containers_of(pod):
    """Its containers, of which each names volumes that there are."""
    volumes = {volume["name"] for volume in pod["volumes"]}
    for container in pod["containers"]:
        assert {mount["name"] for mount in container["volumeMounts"]} <= volumes, container
    return pod["containers"]


class Pod:
    """What runs of the containers of a stateful set that is called NAME, with the volumes as folders."""

    def __init__(self, bench, name, containers):
        self.run = bench.folder / f"run-{name}"
        state = bench.folder / f"state-{name}"
        self.run.mkdir()
        self.programs = [bench.start(*self.words(bench, container, name), env={
            **os.environ, "RUNTIME_DIRECTORY": str(self.run), "STATE_DIRECTORY": str(state)}) for container in containers]

    @staticmethod
    def words(bench, container, name):
        assert container["env"] == [{"name": "HOST", "valueFrom": {"fieldRef": {"fieldPath": "metadata.name"}}}], container
        program, *words = container["command"]
        return bench.program(program), *(word.replace("$(HOST)", name).replace("//nats/", "//127.0.0.1/") for word in words)

    def end(self):
        """As a pod ends: all of its containers are told at once."""
        for program in self.programs:
            program.terminate()
        for program in self.programs:
            assert program.wait(2 * PATIENCE) == 0, program.args


def run(bench, examples):
    documents = list(yaml.safe_load_all((examples / "kubernetes.yaml").read_text(encoding="utf-8")))
    by_name = {(document["kind"], document["metadata"]["name"]): document for document in documents}
    assert len(by_name) == len(documents) == 3, by_name.keys()
    server, hosts = (by_name["StatefulSet", name]["spec"] for name in ("nats", "axisd-host"))
    assert by_name["Service", "nats"]["spec"]["ports"][0]["port"] == 4222
    assert "--jetstream" in containers_of(server["template"]["spec"])[0]["args"]
    containers = containers_of(hosts["template"]["spec"])
    fleet = Fleet(bench)
    pods = []
    try:
        pods += [Pod(bench, f"axisd-host-{number}", containers) for number in range(hosts["replicas"])]
        fleet.axisctl("fleet", "apply", examples / "units.json")
        units = [row["unit"].replace("/", ".") for row in json.loads(fleet.axisctl("--json", "fleet", "list"))["units"]]
        assert len(units) == 17, units
        fleet.await_units(units, 3 * PATIENCE)
        shares = {place["host"] for place in fleet.places(units).values()}
        assert shares == {f"axisd-host-{number}" for number in range(3)}, shares
        pods.pop().end()
        wait_until(lambda: "axisd-host-2" not in {place.get("host") for place in fleet.places(units).values()}, "its units are elsewhere")
        fleet.await_units(units, 3 * PATIENCE)
    finally:
        for pod in pods:
            pod.end()
    print("the pods of the manifest run its units")


if __name__ == "__main__":
    with Bench(sys.argv[1]) as test_bench:
        run(test_bench, pathlib.Path(sys.argv[2]))
