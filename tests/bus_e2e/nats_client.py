"""A client of a NATS server: publishes, subscribes, asks, with headers. The protocol is lines of text, and bytes behind them."""

import collections
import itertools
import json
import socket

Message = collections.namedtuple("Message", "subject reply headers data")


class Refused(Exception):
    """The server has refused something; args[0] is what it says."""


class Client:
    """A connection to the server at ADDRESS, (host, port), by TLS if a context is given; OPTIONS go with CONNECT: user, pass, name."""

    def __init__(self, address, patience=20, tls=None, **options):
        self.socket = socket.create_connection(address, patience)
        self.stream = self.socket.makefile("rb")
        self.numbers = itertools.count(1)
        self.waiting = collections.deque()  # messages that have come while something else was waited for
        self.info = json.loads(self.stream.readline()[len("INFO "):])
        if tls:
            self.socket = tls.wrap_socket(self.socket, server_hostname="localhost")
            self.stream = self.socket.makefile("rb")
        self._send(f"CONNECT {json.dumps({'verbose': False, 'headers': True, **options})}")
        self.flush()

    def close(self):
        self.socket.close()

    def pub(self, subject, data=b"", reply="", headers=None):
        """Publishes DATA; what the server says of it comes with the next call that waits."""
        if headers is None:
            return self._send(f"PUB {subject} {reply} {len(data)}", data)
        head = "".join(["NATS/1.0\r\n", *(f"{name}: {value}\r\n" for name, value in headers.items()), "\r\n"]).encode()
        return self._send(f"HPUB {subject} {reply} {len(head)} {len(head) + len(data)}", head + data)

    def sub(self, subject):
        """Subscribes; next() gives the messages. The number that unsub() takes."""
        number = next(self.numbers)
        self._send(f"SUB {subject} {number}")
        return number

    def unsub(self, number):
        self._send(f"UNSUB {number}")

    def next(self, patience=20):
        """The next message of any subscription; TimeoutError if none comes within PATIENCE (s)."""
        self.socket.settimeout(patience)
        while not self.waiting:
            self._read()
        return self.waiting.popleft()

    def flush(self):
        """Waits until the server has taken everything."""
        self._send("PING")
        while self._read() != "PONG":
            pass

    def request(self, subject, data=b"", headers=None):
        """Publishes DATA and waits for the answer."""
        inbox = f"_INBOX.{id(self)}.{next(self.numbers)}"
        number = self.sub(inbox)
        self.pub(subject, data, inbox, headers)
        while not self.waiting or self.waiting[-1].subject != inbox:
            self._read()
        self.unsub(number)
        return self.waiting.pop()

    def ask_jetstream(self, method, **document):
        """The answer of JetStream's METHOD, such as STREAM.INFO.name; raises Refused."""
        answer = json.loads(self.request(f"$JS.API.{method}", json.dumps(document).encode() if document else b"").data)
        if "error" in answer:
            raise Refused(answer["error"]["description"])
        return answer

    def _send(self, line, data=None):
        self.socket.sendall(line.encode() + b"\r\n" + (b"" if data is None else data + b"\r\n"))

    def _read(self):
        """Takes what the server says next: its verb."""
        line = self.stream.readline().decode()
        verb, *words = line.split() or [""]
        if verb == "PING":
            self._send("PONG")
        elif verb == "-ERR" or not verb:
            raise Refused(line.strip() or "the server has closed the connection")
        elif verb in ("MSG", "HMSG"):
            head = int(words[-2]) if verb == "HMSG" else 0
            data = self.stream.read(int(words[-1]))
            self.stream.readline()
            reply = words[2] if len(words) == (5 if head else 4) else None
            headers = dict(field.split(": ", 1) for field in data[:head].decode().split("\r\n")[1:] if field)
            self.waiting.append(Message(words[0], reply, headers, data[head:]))
        return verb
