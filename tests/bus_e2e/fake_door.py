"""The door of a host, as far as a client of a farm sees it: answers and beats, for units behind control sockets.

usage: fake_door.py PORT FARM HOST BUS/NODE=SOCKET...
"""
import json
import random
import socket
import sys
import threading
import time

import nats_client

port, farm, host, *units = sys.argv[1:]
instance = random.getrandbits(50)


class Server(nats_client.Client):
    """One that several threads may publish with."""

    sending = threading.Lock()

    def _send(self, line, data=None):
        with self.sending:
            super()._send(line, data)


server = Server(("127.0.0.1", int(port)))


def publish(subject, document):
    server.pub(subject, (document if isinstance(document, str) else json.dumps(document)).encode())


class Lines:
    """A connection to a control socket."""

    def __init__(self, path):
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.connect(path)
        self.stream = self.socket.makefile("r", encoding="utf-8", newline="\n")

    def ask(self, request):
        self.socket.sendall((json.dumps(request) + "\n").encode())

    def next(self):
        return self.stream.readline().rstrip("\n")


class Unit:
    def __init__(self, name, path):
        self.name, self.path = name, path
        self.lines, self.looks = Lines(path), Lines(path)
        self.sessions = {}
        events = Lines(path)
        events.ask({"id": 1, "method": "events.subscribe"})
        threading.Thread(target=self.tell_events, args=(events,), daemon=True).start()

    def subject(self, end):
        return f"axisd.{farm}.{self.name.replace('/', '.')}.{end}"

    def tell_events(self, lines):
        while line := lines.next():
            notice = json.loads(line)
            if "event" in notice:
                publish(self.subject("event"), {**notice["event"], "unit": self.name})

    def deliver(self, subject, lines):
        while line := lines.next():
            notice = json.loads(line)
            if "id" in notice:
                publish(lines.reply, line)
            else:
                for content in notice.values():
                    content["unit"] = self.name
                publish(subject, json.dumps(notice))

    def answer(self, request, reply):
        subject = request.pop("deliver", None)
        if request["method"] == "end":
            if subject in self.sessions:
                self.sessions.pop(subject).socket.shutdown(socket.SHUT_RDWR)
            return publish(reply, {"id": request["id"], "result": {}})
        if request["method"] == "keep":
            known = {"result": {}} if subject in self.sessions else {"error": {"code": "not-found", "message": "deliver"}}
            return publish(reply, {"id": request["id"], **known})
        if subject is None:
            self.lines.ask(request)
            return publish(reply, self.lines.next())
        if subject not in self.sessions:
            self.sessions[subject] = Lines(self.path)
            threading.Thread(target=self.deliver, args=(subject, self.sessions[subject]), daemon=True).start()
        self.sessions[subject].reply = reply
        return self.sessions[subject].ask(request)

    def about(self):
        self.looks.ask({"id": 1, "method": "units"})
        told = json.loads(self.looks.next())["result"]["units"][0]
        return {"unit": self.name, **{key: told[key] for key in ("node_id", "on", "axes", "profile")}}


def beat():
    with beating:
        publish(f"axisd_host.{farm}.{host}.door", {"host": host, "instance": instance, "version": "0",
                                                  "units": [unit.about() for unit in known.values()]})


def beat_on():
    while True:
        beat()
        time.sleep(0.25)


known = {}
beating = threading.Lock()
for word in units:
    name, path = word.split("=")
    unit = Unit(name, path)
    known[unit.subject("rpc")] = unit
    server.sub(unit.subject("rpc"))
server.sub(f"axisd_host.{farm}.who")
threading.Thread(target=beat_on, daemon=True).start()
while True:
    try:
        message = server.next(None)
    except (nats_client.Refused, OSError):
        sys.exit()  # the server has gone
    if message.subject in known:
        known[message.subject].answer(json.loads(message.data), message.reply)
    else:
        beat()
