"""Three hubs that a NATS server joins, and a member of each that sends: all three hear the same frames in the same order.

usage: one_order.py PROGRAMS
"""
import os
import pathlib
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import time

HOSTS = ("a", "b", "c")
FRAMES = 7000  # of each member
AHEAD = 200  # of the member that is farthest behind: more than a hub keeps for a member are lost
FIRST_IDENTIFIER = 0x100
FRAME = struct.Struct("=IB3xII")


def member(number):
    """Sends, and prints all frames that it hears, its own included."""
    signal.alarm(120)
    can = socket.socket(socket.PF_CAN, socket.SOCK_RAW, socket.CAN_RAW)
    can.setsockopt(socket.SOL_CAN_RAW, socket.CAN_RAW_RECV_OWN_MSGS, 1)
    can.bind(("vcan0",))
    print("ready", flush=True)
    sys.stdin.readline()
    sent, heard, log = 0, [0] * len(HOSTS), []
    while sum(heard) < FRAMES * len(HOSTS):
        while sent < min(FRAMES, min(heard) + AHEAD):
            can.send(FRAME.pack(FIRST_IDENTIFIER + number, 8, sent, 0))
            sent += 1
        identifier, _, counter, _ = FRAME.unpack(can.recv(FRAME.size))
        heard[identifier - FIRST_IDENTIFIER] += 1
        log.append(f"{identifier:X} {counter}")
    print("\n".join(log))


def start(*words, **options):
    process = subprocess.Popen([str(word) for word in words], **options)
    processes.append(process)
    return process


def wait_until(condition, what, seconds=60):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, f"not within {seconds} s: {what}"
        time.sleep(0.01)


def run(programs, folder):
    (folder / "server.conf").write_text(f"listen: 127.0.0.1:4222\njetstream {{ store_dir: {folder}/store }}\n")
    start("nats-server", "-c", folder / "server.conf", stderr=subprocess.DEVNULL)
    for host in HOSTS:
        start(programs / "canhub", "--path", folder / host, "--join", "nats://127.0.0.1/lab", stderr=(folder / f"{host}.log").open("w"))
    for host in HOSTS:
        wait_until(lambda host=host: (folder / f"{host}.log").read_text().count("is on the bus") == len(HOSTS) - 1,
                   f"{host} knows the others")
    members = [start(programs / "with-can", "--bus", folder / host, "--", sys.executable, __file__, "--member", number,
                     stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) for number, host in enumerate(HOSTS)]
    for process in members:
        assert process.stdout.readline() == "ready\n"
    for process in members:
        process.stdin.write("go\n")
        process.stdin.flush()
    logs = [process.stdout.read().splitlines() for process in members]

    for number in range(len(HOSTS)):
        own = [line for line in logs[0] if line.startswith(f"{FIRST_IDENTIFIER + number:X} ")]
        assert own == [f"{FIRST_IDENTIFIER + number:X} {counter}" for counter in range(FRAMES)], f"frames of {HOSTS[number]}"
    for host, log in zip(HOSTS, logs):
        assert log == logs[0], f"{host} and {HOSTS[0]} have heard different orders"
    print(f"{len(logs[0])} frames of {len(HOSTS)} senders, in one order on all hosts")


if sys.argv[1:2] == ["--member"]:
    member(int(sys.argv[2]))
    sys.exit()

processes = []
place = pathlib.Path(tempfile.mkdtemp(dir="/dev/shm" if os.access("/dev/shm", os.W_OK) else None))
try:
    run(pathlib.Path(sys.argv[1]), place)
except BaseException:
    for name in sorted(place.glob("*.log")):
        print(f"--- {name.name}\n{name.read_text()}", file=sys.stderr)
    raise
finally:
    for process in processes:
        process.kill()
        process.wait()
    subprocess.run(["rm", "-rf", place], check=True)
