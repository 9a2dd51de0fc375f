#!/usr/bin/env python3
"""What axisd-http costs, and the unit behind it, with many viewers and clients.

usage: with-can --private -- http_load.py BIN [--viewers N] [--clients N] [--pause S] [--seconds S]

BIN is the folder of axisd and axisd-http. One axis turns. Half of the viewers see events, half samples of two signals every 100 ms; each
client asks for the status of the unit, waits for PAUSE and asks again. Prints requests and events a second, the longest answer, the
share of one processor of both programs, the memory of the gateway, and the cycles that the unit has skipped.
"""
import argparse
import asyncio
import json
import os
import pathlib
import re
import socket
import struct
import subprocess
import tempfile
import time

NODE = 5
TICKS = os.sysconf("SC_CLK_TCK")


def turn():
    """The master: NMT start, Operation enabled, a speed."""
    can = socket.socket(socket.PF_CAN, socket.SOCK_RAW, socket.CAN_RAW)
    can.bind(("vcan0",))
    frames = [(0x000, b"\x01\x00")] + [(0x200 + NODE, word) for word in (b"\x06\x00", b"\x07\x00", b"\x0f\x00")]
    for identifier, data in frames + [(0x300 + NODE, b"\x0f\x00" + struct.pack("<i", 70_000_000))]:
        can.send(struct.pack("=IB3x8s", identifier, len(data), data))
        time.sleep(0.1)


def start(words, environment, pattern):
    """A program, when it has written PATTERN to standard error, and what was found."""
    program = subprocess.Popen(words, env=environment, stderr=subprocess.PIPE, text=True)
    for line in program.stderr:
        if found := re.search(pattern, line):
            return program, found
    raise SystemExit(f"{words[0]} has not started")


def processor_time(process):
    fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text(encoding="ascii").rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / TICKS


def memory(process):
    return int(re.search(r"VmRSS:\s+(\d+)", pathlib.Path(f"/proc/{process.pid}/status").read_text(encoding="ascii"))[1])


async def get(reader, writer, path):
    writer.write(f"GET {path} HTTP/1.1\r\nHost: localhost\r\n\r\n".encode())
    head = await reader.readuntil(b"\r\n\r\n")
    assert head.startswith(b"HTTP/1.1 200 "), head
    return head


class Load:
    """All viewers and clients, and what they count."""

    def __init__(self, port, unit, arguments):
        self.port, self.unit, self.arguments = port, unit, arguments
        self.requests, self.events, self.longest, self.ended = 0, 0, 0.0, 0
        self.end = time.monotonic() + arguments.seconds

    async def status(self):
        reader, writer = await asyncio.open_connection("127.0.0.1", self.port)
        head = await get(reader, writer, self.unit)
        body = await reader.readexactly(int(re.search(rb"Content-Length: (\d+)", head)[1]))
        writer.close()
        return json.loads(body)

    async def client(self):
        reader, writer = await asyncio.open_connection("127.0.0.1", self.port)
        while time.monotonic() < self.end:
            begin = time.monotonic()
            head = await get(reader, writer, self.unit)
            await reader.readexactly(int(re.search(rb"Content-Length: (\d+)", head)[1]))
            self.longest = max(self.longest, time.monotonic() - begin)
            self.requests += 1
            await asyncio.sleep(self.arguments.pause)
        writer.close()

    async def viewer(self, path):
        reader, writer = await asyncio.open_connection("127.0.0.1", self.port)
        await get(reader, writer, path)
        while (left := self.end - time.monotonic()) > 0:
            try:
                line = await asyncio.wait_for(reader.readline(), left)
            except asyncio.TimeoutError:
                break
            self.events += line.startswith(b"data:")
            self.ended += not line or b"cut-off" in line
            if not line:
                break
        writer.close()

    async def run(self):
        paths = ["/api/v1/events", f"{self.unit}/samples?signals=1/speed,dc_voltage&period_ms=100"]
        work = [self.viewer(paths[n % 2]) for n in range(self.arguments.viewers)]
        await asyncio.gather(*work, *(self.client() for _ in range(self.arguments.clients)))


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("\n")[2][len("usage: "):])
    parser.add_argument("bin", type=pathlib.Path)
    parser.add_argument("--viewers", type=int, default=100)
    parser.add_argument("--clients", type=int, default=100)
    parser.add_argument("--pause", type=float, default=0.5)
    parser.add_argument("--seconds", type=float, default=60)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="http-load-") as folder:
        environment = {"PATH": os.environ["PATH"], "HOME": folder, "XDG_RUNTIME_DIR": folder}
        unit, _ = start([arguments.bin / "axisd", "--interface", f"unix:{os.environ['CAN_BUS']}", "--node-id", str(NODE)],
                        environment, "ready: node")
        gateway, found = start([arguments.bin / "axisd-http", "--listen", "127.0.0.1:0", "--read-only"], environment,
                               r"ready: http://127.0.0.1:(\d+)/")
        try:
            turn()
            listing = json.loads(subprocess.run(["curl", "-s", f"http://127.0.0.1:{found[1]}/api/v1/units"], check=True,
                                                capture_output=True).stdout)
            load = Load(int(found[1]), f"/api/v1/units/{listing['units'][0]['unit']}", arguments)
            before = asyncio.run(load.status())
            alone = memory(gateway)
            times = {process: processor_time(process) for process in (gateway, unit)}
            begin = time.monotonic()
            load.end = begin + arguments.seconds
            asyncio.run(load.run())
            passed = time.monotonic() - begin
            share = {process: (processor_time(process) - before_it) / passed for process, before_it in times.items()}
            after = asyncio.run(load.status())
            loaded = memory(gateway)
        finally:
            for process in (gateway, unit):
                process.terminate()
                process.wait()
    print(f"{arguments.viewers} viewers, {arguments.clients} clients, {passed:.0f} s, axis at "
          f"{after['axes'][0]['speed_rpm']:.0f} rpm")
    print(f"requests       {load.requests / passed:.0f} a second, the longest answer {load.longest * 1000:.0f} ms")
    print(f"events         {load.events / passed:.0f} a second, streams ended {load.ended}")
    print(f"axisd-http     {share[gateway]:.1%} of a processor, memory {alone / 1024:.1f} MB alone, {loaded / 1024:.1f} MB with them")
    print(f"axisd          {share[unit]:.1%} of a processor")
    print(f"skipped_cycles {before['skipped_cycles']} before, {after['skipped_cycles']} after")


if __name__ == "__main__":
    main()
