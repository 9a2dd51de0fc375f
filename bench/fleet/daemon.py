"""axisd with many units or many of it with one, and the hubs of their buses: start, memory, processor time, status."""
import json
import os
import pathlib
import re
import socket
import subprocess
import sys
import time

NS = 1e9


def cpu_seconds(process):
    """Of all threads of it so far."""
    total = 0
    for entry in pathlib.Path(f"/proc/{process}/task").glob("*/schedstat"):
        total += int(entry.read_text().split()[0])
    return total / NS


def memory(process):
    """RSS and PSS in MB."""
    text = pathlib.Path(f"/proc/{process}/smaps_rollup").read_text()
    return tuple(int(re.search(rf"^{name}:\s+(\d+)", text, re.MULTILINE)[1]) / 1024 for name in ("Rss", "Pss"))


def hub_of(bus):
    """The process that serves the bus at the path `bus`."""
    for entry in pathlib.Path("/proc").glob("[0-9]*/cmdline"):
        try:
            words = entry.read_bytes().split(b"\0")
        except OSError:
            continue
        if words[0].endswith(b"canhub") and str(bus).encode() in words:
            return int(entry.parent.name)
    sys.exit(f"no hub serves {bus}")


class Daemon:
    """axisd in `folder` with `counts[i]` units of `axes` axes on bus i; all of them have booted."""

    def __init__(self, binaries, folder, counts, axes, threads):
        self.buses = [folder / f"bus{number}" for number in range(len(counts))]
        entries = [{"interface": f"unix:{bus}", "node_id": {"from": 1, "to": count}, "axes": [{}] * axes}
                   for bus, count in zip(self.buses, counts)]
        configuration = folder / "units.json"
        configuration.write_text(json.dumps({"threads": threads, "units": entries}))
        log = folder / "axisd.log"
        begun = time.monotonic()
        with log.open("w") as output:
            self.process = subprocess.Popen([binaries / "axisd", "--config", configuration, "--state-directory",
                                             folder / "state", "--control", folder / "control.sock"],
                                            env={**os.environ, "XDG_RUNTIME_DIR": str(folder)}, stderr=output)
        self.wait_until_ready(log, sum(counts))
        self.booted = time.monotonic() - begun
        self.boot_cpu = cpu_seconds(self.process.pid)
        self.hubs = [hub_of(bus) for bus in self.buses]
        self.control = socket.socket(socket.AF_UNIX)
        self.control.connect(str(folder / "control.sock"))
        self.lines = self.control.makefile("rw")

    def wait_until_ready(self, log, units):
        while log.read_text().count("ready: ") < units:
            if self.process.poll() is not None:
                sys.exit(f"axisd has ended: {log.read_text()}")
            time.sleep(0.01)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.control.close()
        self.process.terminate()
        self.process.wait()

    def ask(self, method, **params):
        self.lines.write(json.dumps({"id": 1, "method": method, "params": params}) + "\n")
        self.lines.flush()
        answer = json.loads(self.lines.readline())
        if "error" in answer:
            sys.exit(f"{method}: {answer['error']}")
        return answer["result"]

    def statuses(self):
        """Of all units."""
        names, page = [], self.ask("units")
        while True:
            names += [unit["unit"] for unit in page["units"]]
            if "next" not in page:
                break
            page = self.ask("units", **{"from": page["next"]})
        return [self.ask("status", unit=name) for name in names]

    def cpu(self):
        """Seconds of axisd, and those of the hubs together."""
        return cpu_seconds(self.process.pid), sum(cpu_seconds(hub) for hub in self.hubs)

    def memory(self):
        """RSS and PSS in MB."""
        return memory(self.process.pid)


class Processes:
    """The same units with a process each."""

    def __init__(self, binaries, folder, counts, axes):
        self.buses = [folder / f"bus{number}" for number in range(len(counts))]
        self.units, begun = [], time.monotonic()
        try:
            for bus, count in zip(self.buses, counts):
                self.units += (Unit(binaries, folder, bus, node, axes) for node in range(1, count + 1))
            for unit in self.units:
                unit.wait_until_ready()
            self.booted = time.monotonic() - begun
            self.boot_cpu = self.cpu_of_units()
            self.hubs = [hub_of(bus) for bus in self.buses]
        except BaseException:
            self.end()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.end()

    def end(self):
        for unit in self.units:
            unit.process.terminate()
        for unit in self.units:
            unit.process.wait()

    def cpu_of_units(self):
        return sum(cpu_seconds(unit.process.pid) for unit in self.units)

    def cpu(self):
        """Seconds of all units, and those of the hubs together."""
        return self.cpu_of_units(), sum(cpu_seconds(hub) for hub in self.hubs)

    def statuses(self):
        return [unit.status() for unit in self.units]

    def memory(self):
        """RSS and PSS of all, in MB."""
        return tuple(sum(part) for part in zip(*(memory(unit.process.pid) for unit in self.units)))


class Unit:
    """One of them."""

    def __init__(self, binaries, folder, bus, node, axes):
        name = f"{bus.name}-{node}"
        self.log, self.path = folder / f"{name}.log", folder / f"{name}.sock"
        with self.log.open("w") as output:
            self.process = subprocess.Popen(
                [str(word) for word in (binaries / "axisd", "--interface", f"unix:{bus}", "--node-id", node, "--axes", axes,
                                        "--state-directory", folder / name, "--control", self.path)],
                env={**os.environ, "XDG_RUNTIME_DIR": str(folder)}, stderr=output)

    def wait_until_ready(self):
        while "ready: " not in self.log.read_text():
            if self.process.poll() is not None:
                sys.exit(f"axisd has ended: {self.log.read_text()}")
            time.sleep(0.01)

    def status(self):
        with socket.socket(socket.AF_UNIX) as control:
            control.connect(str(self.path))
            lines = control.makefile("rw")
            lines.write('{"id": 1, "method": "status"}\n')
            lines.flush()
            return json.loads(lines.readline())["result"]
