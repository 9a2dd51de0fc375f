"""Hubs, doors, agents and a server with TLS, users and an account each for two farms: who is let in, and what is said to the others.

usage: hosts_secured.py PROGRAMS SOURCES
"""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

programs, sources = (pathlib.Path(word) for word in sys.argv[1:3])
folder = pathlib.Path(tempfile.mkdtemp(dir="/dev/shm" if os.access("/dev/shm", os.W_OK) else None))
certificates, others = folder / "tls", folder / "others"
processes = []


def start(*words, **options):
    process = subprocess.Popen([str(word) for word in words], **options)
    processes.append(process)
    return process


def wait_until(condition, what, seconds=20):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, f"not within {seconds} s: {what}"
        time.sleep(0.01)


def make_certificates():
    for place, names in ((certificates, ("localhost", "127.0.0.1")), (others, ("elsewhere.example",))):
        subprocess.run([sources / "examples/fleet/certificates.sh", place, *names], check=True)


def start_server():
    """The example's server, on the loopback address."""
    text = (sources / "examples/fleet/nats-server.conf").read_text()
    text = text.replace("0.0.0.0:4222", "127.0.0.1:4222").replace("/dev/shm/nats", f"{folder}/store")
    (folder / "server.conf").write_text(text.replace('"tls/', f'"{certificates}/'))
    log = folder / "server.log"
    start("nats-server", "-c", folder / "server.conf", stderr=log.open("w"))
    wait_until(lambda: "Server is ready" in log.read_text(), "the server serves")


def user(line, name="user"):
    path = folder / name
    path.write_text(line)
    return path


class Host:
    """A hub that joins tls://HOST/lab."""

    count = 0

    def __init__(self, credentials, authority=certificates / "ca.crt", host="localhost"):
        Host.count += 1
        self.path, self.log = folder / f"hub{Host.count}", folder / f"hub{Host.count}.log"
        self.environment = dict(os.environ, CAN_BUS=str(self.path))
        self.hub = start(programs / "canhub", "--path", self.path, "--join", f"tls://{host}/lab", "--tls-ca", authority,
                         "--credentials", credentials, stderr=self.log.open("w"))

    def says(self, text):
        wait_until(lambda: text in self.log.read_text(), f"{text!r} in {self.log.name}")

    def program(self, *words, **options):
        return [str(word) for word in (programs / "with-can", *words)]


def frames_pass_within_an_account():
    a, b = Host(user("lab-host:change-me-host\n", "a")), Host(user("lab-host:change-me-host", "b"))
    plant = Host(user("plant-host:change-me-plant\n", "plant"))
    dumps = {}
    for host in (a, b, plant):
        host.says("joined")
        dumps[host] = folder / f"{host.path.name}.dump"
        start(*host.program("candump", "-L", "can0"), env=host.environment, stdout=dumps[host].open("w"))

    # The reader may not listen yet when the first frame comes: the last one counts.
    def arrives():
        subprocess.run(a.program("cansend", "can0", "123#11"), env=a.environment, check=True, stderr=subprocess.DEVNULL)
        return "123#11" in dumps[b].read_text()

    wait_until(arrives, "a frame from host to host")
    assert subprocess.run(plant.program("cansend", "can0", "456#22"), env=plant.environment, check=True)
    wait_until(lambda: "456#22" in dumps[plant].read_text(), "a frame on the other farm's bus of that name")
    assert "456" not in dumps[a].read_text() + dumps[b].read_text(), "two accounts are two buses"
    assert "123" not in dumps[plant].read_text(), "two accounts are two buses"


def others_are_refused():
    wrong = Host(user("lab-host:guessed\n", "wrong"))
    wrong.says("uthorization")
    nobody = Host(folder / "there is no such file")
    nobody.says("there is no such file: no credentials can be read there")
    garbage = Host(user("\0\1 no credentials\n", "garbage"))
    garbage.says("garbage: expected a line NAME:PASSWORD, or a user's JWT and key")
    stranger = Host(user("lab-host:change-me-host\n", "a"), authority=others / "ca.crt")
    stranger.says("SSL")
    viewer = Host(user("lab-viewer:change-me-viewer\n", "viewer"))
    viewer.says("stream CAN_lab")
    for host in (wrong, nobody, garbage, stranger, viewer):
        assert host.hub.poll() is None, "it tries again"
        assert "joined" not in host.log.read_text()
        # One line for one reason, however often it is tried.
        lines = [line for line in host.log.read_text().splitlines() if "ready" not in line]
        assert len(lines) == len(set(lines)), lines


def another_name_is_refused():
    """A server whose certificate is for somebody else, of an authority that is trusted."""
    text = (folder / "server.conf").read_text().replace("127.0.0.1:4222", "127.0.0.1:4333")
    text = text.replace(f'"{certificates}/', f'"{others}/').replace(f"{folder}/store", f"{folder}/other-store")
    (folder / "other.conf").write_text(text)
    log = folder / "other.log"
    start("nats-server", "-c", folder / "other.conf", stderr=log.open("w"))
    wait_until(lambda: "Server is ready" in log.read_text(), "the other server serves")
    Host(user("lab-host:change-me-host\n", "a"), authority=others / "ca.crt", host="localhost:4333").says("SSL")


def on_farm(name, credentials, authority=certificates / "ca.crt"):
    """The options by which a program is told of the farm NAME."""
    return ("--farm", f"tls://localhost/{name}", "--tls-ca", authority, "--credentials", credentials)


def axisctl(*words):
    return subprocess.run([str(word) for word in (programs / "axisctl", *words)], capture_output=True, text=True, check=False)


def start_host_of_farm(options):
    """An agent and a door, with nothing of this machine in common but the programs."""
    runtime = folder / "run"
    runtime.mkdir()
    environment = dict(os.environ, XDG_RUNTIME_DIR=str(runtime), XDG_STATE_HOME=str(folder / "state"))
    for name in ("axisd-agent", "axisd-nats"):
        start(programs / name, *options, "--host", "a", env=environment, stderr=(folder / f"{name}.log").open("w"))


def end_what_agents_started():
    """Units and hubs go on without their agent; all of them were told of the folder."""
    for process in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            if str(folder) in (process / "cmdline").read_text() and process.name != str(os.getpid()):
                os.kill(int(process.name), signal.SIGKILL)
        except OSError:  # has ended
            pass


def a_farm_is_reached_by_its_users_alone():
    """A unit that an agent runs, through the door of its host, over TLS."""
    host = user("lab-host:change-me-host", "host")
    start_host_of_farm(on_farm("lab", host))
    unit = (*on_farm("lab", host), "--unit", "cell/5")
    units = folder / "units.json"
    units.write_text('{"units": [{"bus": "cell", "node_id": 5}]}')
    wait_until(lambda: axisctl(*on_farm("lab", host), "fleet", "apply", units).returncode == 0, "a unit is wanted", 60)
    wait_until(lambda: axisctl(*unit, "set", "1/p1120", "2.5").returncode == 0, "a parameter is set", 60)
    assert "2.5" in axisctl(*unit, "get", "1/p1120").stdout
    plant = axisctl(*on_farm("plant", user("plant-host:change-me-plant", "plant")), "--unit", "cell/5", "status")
    assert plant.returncode == 5 and len(plant.stderr.splitlines()) == 1, plant
    for reason, options in (("uthorization", on_farm("lab", user("lab-host:guessed", "wrong"))), ("SSL", on_farm("lab", host, others / "ca.crt"))):
        refused = axisctl(*options, "--unit", "cell/5", "status")
        assert refused.returncode == 5 and reason in refused.stderr and len(refused.stderr.splitlines()) == 1, refused


try:
    make_certificates()
    start_server()
    frames_pass_within_an_account()
    others_are_refused()
    another_name_is_refused()
    a_farm_is_reached_by_its_users_alone()
    print("TLS, users and accounts: who may is on the bus, who may not is told why")
except BaseException:
    for name in sorted(folder.glob("*.log")):
        print(f"--- {name.name}\n{name.read_text()}", file=sys.stderr)
    raise
finally:
    for process in processes:
        process.kill()
        process.wait()
    end_what_agents_started()
    subprocess.run(["rm", "-rf", folder], check=True)
