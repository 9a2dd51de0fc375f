#!/usr/bin/env python3
"""What the streams of a web page cost, of axisd-http and of the unit behind it: fast samples and every frame.

usage: with-can --private -- page_load.py BIN [--viewers N] [--signals N] [--frames RATE] [--polls RATE] [--seconds S]

BIN is the folder of axisd and axisd-http. One axis turns while a master sends RATE frames a second to it. Each viewer sees signals of its own
every millisecond in batches of 50 ms, and all frames of the unit: by two streams, or with --polls by RATE requests a second for what has come since. Prints what came, what was lost, streams that were cut off, the share of one
processor of both programs with the frames alone and with the viewers, and the cycles that the unit has skipped.
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
import sys
import tempfile
import time
import urllib.request

import http_load

BURSTS = 200  # a second


def send_frames(rate, seconds):
    """The master: RPDO1 with Operation enabled, in bursts."""
    can = socket.socket(socket.PF_CAN, socket.SOCK_RAW, socket.CAN_RAW)
    can.setsockopt(socket.SOL_CAN_RAW, socket.CAN_RAW_FILTER, b"")
    can.bind(("vcan0",))
    frame = struct.pack("=IB3x8s", 0x200 + http_load.NODE, 2, b"\x0f\x00")
    begin, sent = time.monotonic(), 0
    while (passed := time.monotonic() - begin) < seconds:
        while sent < passed * rate:
            can.send(frame)
            sent += 1
        time.sleep(1 / BURSTS)
    print(sent)


class Streams:
    """What the viewers of one kind count."""

    def __init__(self):
        self.events, self.items, self.lost, self.bytes, self.ended = 0, 0, 0, 0, 0

    def count(self, data, key):
        self.events += 1
        self.items += len(data[key])
        self.lost += data["lost"]

    def take(self, line, key):
        self.bytes += len(line)
        if not line.startswith(b"data: {") or f'"{key}":['.encode() not in line:
            self.ended += b"were read" in line
            return
        self.count(json.loads(line[len("data: "):]), key)


async def view(port, path, key, streams, seconds):
    reader, writer = await asyncio.open_connection("127.0.0.1", port, limit=1 << 20)
    await http_load.get(reader, writer, path)
    end = time.monotonic() + seconds
    while (left := end - time.monotonic()) > 0:
        try:
            line = await asyncio.wait_for(reader.readline(), left)
        except asyncio.TimeoutError:
            break
        if not line:
            break
        streams.take(line, key)
    writer.close()


class Polls:
    """What all who ask again and again count."""

    def __init__(self):
        self.answers, self.bytes, self.lost, self.longest = 0, 0, 0, 0.0

    def __str__(self):
        return (f"polls          {self.answers} answers of {self.bytes / max(self.answers, 1) / 1024:.1f} KB, lines lost {self.lost}, "
                f"longest {self.longest * 1000:.1f} ms")


async def poll(port, path, streams, polls, arguments):
    reader, writer = await asyncio.open_connection("127.0.0.1", port, limit=1 << 20)
    after, end = "", time.monotonic() + arguments.seconds
    while (begin := time.monotonic()) < end:
        head = await http_load.get(reader, writer, path + after)
        body = await reader.readexactly(int(re.search(rb"Content-Length: (\d+)", head)[1]))
        polls.longest = max(polls.longest, time.monotonic() - begin)
        answer = json.loads(body)
        after = f"&after={answer['cursor']}"
        polls.answers, polls.bytes, polls.lost = polls.answers + 1, polls.bytes + len(body), polls.lost + answer["lost"]
        for stream, key, items in zip(streams, ("samples", "frames"), ("t", "frames")):
            for line in answer[key]:
                stream.count(line, items)
        await asyncio.sleep(max(0.0, begin + 1 / arguments.polls - time.monotonic()))
    writer.close()


async def view_all(port, unit, signals, arguments):
    """All viewers; what came of samples and of frames."""
    samples, frames, polls = Streams(), Streams(), Polls()
    work = []
    for viewer in range(arguments.viewers):
        own = ",".join(signals[viewer * arguments.signals:(viewer + 1) * arguments.signals])
        if arguments.polls:
            path = f"{unit}/live?signals={own}&period_ms=1&frames=true"
            work.append(poll(port, path, (samples, frames), polls, arguments))
            continue
        work.append(view(port, f"{unit}/samples?signals={own}&period_ms=1&batch_ms=50", "t", samples, arguments.seconds))
        work.append(view(port, f"{unit}/frames", "frames", frames, arguments.seconds))
    await asyncio.gather(*work)
    if arguments.polls:
        print(polls)
    return samples, frames


def measured(programs, master, what):
    """The share of a processor that each of PROGRAMS had while WHAT was done and the MASTER sent, and the result of WHAT."""
    master = subprocess.Popen(master, stdout=subprocess.PIPE, text=True)
    before = [http_load.processor_time(program) for program in programs]
    begin = time.monotonic()
    result = what()
    passed = time.monotonic() - begin
    shares = [(http_load.processor_time(program) - used) / passed for program, used in zip(programs, before)]
    master.terminate()
    master.wait()
    return shares, result, passed


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("\n")[2][len("usage: "):])
    parser.add_argument("bin", type=pathlib.Path, nargs="?")
    parser.add_argument("--viewers", type=int, default=6)
    parser.add_argument("--signals", type=int, default=8)
    parser.add_argument("--frames", type=float, default=20000)
    parser.add_argument("--polls", type=float, default=0)
    parser.add_argument("--seconds", type=float, default=20)
    parser.add_argument("--master", action="store_true", help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.master:
        return send_frames(arguments.frames, arguments.seconds)
    with tempfile.TemporaryDirectory(prefix="page-load-") as folder:
        environment = {"PATH": os.environ["PATH"], "HOME": folder, "XDG_RUNTIME_DIR": folder}
        unit, _ = http_load.start([arguments.bin / "axisd", "--interface", f"unix:{os.environ['CAN_BUS']}", "--node-id",
                                   str(http_load.NODE)], environment, "ready: node")
        gateway, found = http_load.start([arguments.bin / "axisd-http", "--listen", "127.0.0.1:0", "--read-only"], environment,
                                         r"ready: http://127.0.0.1:(\d+)/")
        try:
            http_load.turn()
            port = int(found[1])

            def get(path):
                with urllib.request.urlopen(f"http://127.0.0.1:{port}{path}", timeout=20) as answer:
                    return json.load(answer)

            path = f"/api/v1/units/{get('/api/v1/units')['units'][0]['unit']}"
            signals = [signal["signal"] for signal in get(f"{path}/signals?search=1/&count=200")["signals"]]
            master = [sys.executable, __file__, "--master", "--frames", str(arguments.frames), "--seconds", "1e6"]
            programs = (gateway, unit)
            alone, _, _ = measured(programs, master, lambda: time.sleep(arguments.seconds))
            before = get(path)
            with_viewers, (samples, frames), passed = measured(
                programs, master, lambda: asyncio.run(view_all(port, path, signals, arguments)))
            after = get(path)
        finally:
            for program in (gateway, unit):
                program.terminate()
                program.wait()
    received = (after["bus"]["received"] - before["bus"]["received"]) / passed
    print(f"{arguments.viewers} viewers of {arguments.signals} signals each, {passed:.0f} s, axis at "
          f"{after['axes'][0]['speed_rpm']:.0f} rpm, {received:.0f} frames a second to the unit")
    for name, streams in (("samples", samples), ("frames", frames)):
        size = f"events of {streams.bytes / max(streams.events, 1) / 1024:.1f} KB" if streams.bytes else "lines"
        print(f"{name:<14} {streams.items / passed:.0f} a second in {streams.events / passed:.0f} {size}, lost {streams.lost}, streams cut off {streams.ended}")
    print(f"axisd-http     {alone[0]:.1%} of a processor without viewers, {with_viewers[0]:.1%} with them")
    print(f"axisd          {alone[1]:.1%} of a processor without viewers, {with_viewers[1]:.1%} with them")
    print(f"skipped_cycles {before['skipped_cycles']} before, {after['skipped_cycles']} after")
    return None


if __name__ == "__main__":
    main()
