"""A TCP relay: it delays what passes, holds it back, and breaks connections: relay.py HOST PORT TARGET-HOST TARGET-PORT

As a program, it does what Relay can, with a word a line on standard input; a test has it by RelayProcess.
"""

import collections
import socket
import sys
import threading
import time


class RelayProcess:
    """The relay as a process of BENCH: what the test does meanwhile makes it no slower."""

    def __init__(self, bench, address, target):
        self.process = bench.start("/usr/bin/python3", __file__, *address, *target, stdin=bench.PIPE, stdout=bench.PIPE, text=True)
        assert self.process.stdout.readline() == "ready\n"

    def tell(self, *words):
        """Has Relay's method of that name called, with numbers behind it."""
        self.process.stdin.write(" ".join(map(str, words)) + "\n")
        self.process.stdin.flush()
        assert self.process.stdout.readline() == "done\n"


class Relay:
    """Listens at ADDRESS and passes to TARGET, both (host, port)."""

    def __init__(self, address, target):
        self.target, self.added = target, 0.0
        self.there, self.back = threading.Event(), threading.Event()
        self.release()
        self.lines = set()
        self.listener = socket.create_server(address)
        threading.Thread(target=self._accept, daemon=True).start()

    def delay(self, seconds):
        """Adds so much on each way."""
        self.added = float(seconds)

    def hold(self):
        """Nothing passes any more: it waits here."""
        self.there.clear()
        self.back.clear()

    def hold_there(self):
        """Nothing passes to the target any more, but what comes from there does."""
        self.there.clear()

    def release(self):
        """What was held back passes, and what comes behind it."""
        self.there.set()
        self.back.set()

    def cut(self):
        """Breaks all connections."""
        for line in list(self.lines):
            line.close()

    def _accept(self):
        while True:
            try:
                near, _ = self.listener.accept()
            except OSError:
                return
            try:
                far = socket.create_connection(self.target)
            except OSError:
                near.close()
                continue
            Line(self, near, far)


class Line:
    """One connection, with what is on its way in each direction."""

    def __init__(self, relay, near, far):
        self.relay, self.ends = relay, (near, far)
        relay.lines.add(self)
        for end in self.ends:
            end.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        for source, sink, flow in ((near, far, relay.there), (far, near, relay.back)):
            way = Way(flow)
            threading.Thread(target=self._take, args=(source, way), daemon=True).start()
            threading.Thread(target=self._give, args=(sink, way), daemon=True).start()

    def close(self):
        self.relay.lines.discard(self)
        for end in self.ends:
            try:
                end.shutdown(socket.SHUT_RDWR)
            except OSError:
                pass  # the other end was faster
            end.close()

    def _take(self, source, way):
        try:
            while data := source.recv(1 << 16):
                way.put(time.monotonic() + self.relay.added, data)
        except OSError:
            pass
        way.put(time.monotonic() + self.relay.added, None)

    def _give(self, sink, way):
        while True:
            due, data = way.get()
            time.sleep(max(0, due - time.monotonic()))
            way.flow.wait()
            if data is None:
                return self.close()
            try:
                sink.sendall(data)
            except OSError:
                return self.close()


class Way:
    """Data on their way in one direction, in their order; they go on while FLOW is set."""

    def __init__(self, flow):
        self.flow = flow
        self.items = collections.deque()
        self.count = threading.Semaphore(0)

    def put(self, due, data):
        self.items.append((due, data))
        self.count.release()

    def get(self):
        self.count.acquire()
        return self.items.popleft()


def main():
    host, port, target_host, target_port = sys.argv[1:]
    relay = Relay((host, int(port)), (target_host, int(target_port)))
    print("ready", flush=True)
    for line in sys.stdin:
        name, *numbers = line.split()
        getattr(relay, name)(*numbers)
        print("done", flush=True)


if __name__ == "__main__":
    main()
