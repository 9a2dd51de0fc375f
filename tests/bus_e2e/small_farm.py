"""A farm of two hosts on this machine, with a server of its own."""
import json
import os
import pathlib
import subprocess
import tempfile
import time

import programs

PATIENCE = programs.PATIENCE
URL = "nats://127.0.0.1:4222/lab"


def wait_until(condition, what):
    end = time.monotonic() + PATIENCE
    while not condition():
        assert time.monotonic() < end, f"not within {PATIENCE} s: {what}"
        time.sleep(0.05)


class Farm:
    """A server, a hub, a unit on each of hosts a and b, and their doors."""

    def __init__(self, folder):
        self.folder = folder
        self.store = tempfile.mkdtemp(dir="/dev/shm" if os.access("/dev/shm", os.W_OK) else folder.folder.name)
        self.start_server()
        self.bus = folder.path("line1")
        folder.start("canhub", "--path", self.bus).expect("ready")
        self.units, self.doors = {}, {}
        for host, node in (("a", 5), ("b", 6)):
            control = folder.path(f"{host}.sock")
            unit = folder.start("axisd", "--interface", f"unix:{self.bus}", "--bus", "line1", "--node-id", str(node), "--control",
                                control, "--state-directory", folder.path(host))
            unit.expect(f"ready: node {node} on")
            self.units[host] = unit
            self.start_door(host)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stop_server()
        subprocess.run(["rm", "-rf", self.store], check=True)

    def start_door(self, host, *options):
        self.doors[host] = self.folder.start("axisd-nats", "--farm", URL, "--host", host, "--socket", self.folder.path(f"{host}.sock"),
                                             *options)

    def start_server(self, *options):
        config = self.folder.path("server.conf")
        pathlib.Path(config).write_text(f"listen: 127.0.0.1:4222\njetstream {{ store_dir: {self.store} }}\n" + "\n".join(options))
        log = self.folder.path("server.log")
        with open(log, "w", encoding="utf-8") as file:
            self.server = subprocess.Popen(["nats-server", "-c", config], stderr=file)
        self.folder.programs.append(self.server)
        wait_until(lambda: "Server is ready" in pathlib.Path(log).read_text(encoding="utf-8"), "the server serves")

    def stop_server(self):
        self.server.kill()
        self.server.wait()

    def run(self, *words, farm=URL, **environment):
        """axisctl before the farm."""
        words = [os.path.join(self.folder.bin_folder, "axisctl"), *([f"--farm={farm}"] if farm else []), *words]
        return subprocess.run(words, env={**self.folder.environment, **environment}, capture_output=True, text=True,
                              timeout=60, check=False)

    def output(self, *words, **options):
        done = self.run(*words, **options)
        assert done.returncode == 0, (words, done)
        return done.stdout

    def json(self, *words):
        return json.loads(self.output("--json", *words))

    def refused(self, status, text, *words, **options):
        """One line with TEXT, and STATUS."""
        done = self.run(*words, **options)
        assert done.returncode == status and text in done.stderr, (words, status, text, done)
        assert done.stdout == "" and done.stderr.startswith("axisctl: "), (words, done)
        return done.stderr
