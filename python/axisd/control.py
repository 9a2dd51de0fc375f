"""The control socket of a unit (docs/reference/control.md)."""

from __future__ import annotations

import collections
import json
import socket
import threading
from typing import Any, Callable

from .background import background, changed
from .bus_clock import Clock
from .errors import Error, Refused, Timeout

__tracebackhide__ = True  # a failed test shows its own lines

_KEPT_EVENTS = 10_000
Event = dict[str, Any]


class Control:
    """A connection: requests one after the other, and lines that a subscription brings."""

    def __init__(self, path: str, timeout: float, ended: Callable[[], Error], clock: Clock) -> None:
        self._timeout = timeout
        self._ended = ended
        self._clock = clock
        self._lock = threading.Lock()
        self._number = 0
        self._rest = b''
        self._socket = socket.socket(socket.AF_UNIX)
        try:
            self._socket.settimeout(timeout)
            self._socket.connect(path)
        except OSError as error:
            self._socket.close()
            raise Error(f'{path}: {error.strerror}') from None

    def close(self) -> None:
        """Ends the connection."""
        self._socket.close()

    def call(self, method: str, params: dict[str, Any]) -> Any:
        """The result of a method; Refused with the message of the unit, Timeout, Ended."""
        with self._lock:
            self._number += 1
            number = self._number
            line = json.dumps({'id': number, 'method': method, 'params': params}) + '\n'
            try:
                self._socket.settimeout(self._timeout)
                self._socket.sendall(line.encode())
            except TimeoutError:
                raise Timeout(f'{method}: the unit has taken no request within {self._timeout:g} s') from None
            except OSError:
                raise self._ended() from None
            deadline = self._clock.now() + self._timeout
            while True:
                answer = self.line(deadline, is_answer=True)
                if answer is None:
                    raise Timeout(f'{method}: the unit has not answered within {self._timeout:g} s')
                if answer.get('id') == number:
                    break
        error = answer.get('error')
        if error:
            details = {key: value for key, value in error.items() if key not in ('code', 'message')}
            raise Refused(f'{method}: {error.get("message", "")}', error.get('code', ''),
                          {**details, **(details.get('details') or {})})
        return answer.get('result')

    def line(self, deadline: float, is_answer: bool = False) -> dict[str, Any] | None:
        """The next line; None if there is none before `deadline` of the clock (s)."""
        while b'\n' not in self._rest:
            try:
                part = self._clock.receive(self._socket, max(deadline - self._clock.now(), 0.0), is_answer)
            except OSError:
                part = b''
            if part is None:
                return None
            if not part:
                raise self._ended()
            self._rest += part
        line, self._rest = self._rest.split(b'\n', 1)
        found: dict[str, Any] = json.loads(line)
        return found


class Events:
    """All events of a unit from the start of this on, read as they come; the last 10000 are kept."""

    def __init__(self, path: str, timeout: float, ended: Callable[[], Error], clock: Clock) -> None:
        self._events: collections.deque[Event] = collections.deque(maxlen=_KEPT_EVENTS)
        self._rest = b''
        self.count = 0  #: how many there have been, under `changed`
        self.has_ended = False
        self._control = Control(path, timeout, ended, clock)
        self._control.call('events.subscribe', {})
        self._socket = self._control._socket  # pylint: disable=protected-access
        self._rest = self._control._rest  # pylint: disable=protected-access
        self._socket.setblocking(False)
        background().watch(self._socket.fileno(), self._read)

    def close(self) -> None:
        """Ends the subscription."""
        background().unwatch(self._socket.fileno())
        self._control.close()

    def since(self, place: int = 0) -> list[Event]:
        """The events from a `count` on."""
        with changed:
            first = self.count - len(self._events)
            return list(self._events)[max(place - first, 0):]

    def _read(self) -> None:
        try:
            part = self._socket.recv(65536)
        except BlockingIOError:
            return
        except OSError:
            part = b''
        with changed:
            if not part:
                self.has_ended = True
                background().unwatch(self._socket.fileno())
            *lines, self._rest = (self._rest + part).split(b'\n')
            for line in lines:
                event = json.loads(line).get('event')
                if event is not None:
                    self._events.append(event)
                    self.count += 1
            changed.notify_all()
