"""The clock of a bus, by which everything here is waited for (docs/explanation/bus-time.md)."""

from __future__ import annotations

import os
import select
import socket
import struct
import subprocess
import time
from typing import Callable, TypeVar

from . import hub_protocol
from .background import await_change, background, changed
from .errors import Ended, Refused

__tracebackhide__ = True  # a failed test shows its own lines

Result = TypeVar('Result')
_NS = 1_000_000_000
_STEP_NS = 1_000_000  # of stepped time, between two looks
_LONGEST_STEP_NS = 100_000_000  # in which nothing is read
_LOOK_AGAIN = 0.001  # s of the machine
_LONGEST_PART = 65536  # bytes


class Clock:
    """That of the machine, `scale` times as quick."""

    scale = 1.0

    def now(self) -> float:
        """s since some moment: in real time CLOCK_MONOTONIC, else since the beginning of the bus."""
        return time.monotonic()

    def await_change(self, look: Callable[[], Result | None], timeout: float) -> Result | None:
        """What `look` gives, as soon as that is not None; it is asked under `changed`. None after `timeout` s."""
        return await_change(look, timeout / self.scale)

    def pass_time(self, seconds: float) -> None:
        """Returns when so much time has passed."""
        time.sleep(seconds / self.scale)

    def receive(self, stream: socket.socket, timeout: float, is_answer: bool) -> bytes | None:
        """What comes next, empty at the end; None after `timeout` s. is_answer: of a unit that was just asked; OSError."""
        del is_answer
        stream.settimeout(max(timeout / self.scale, 1e-6))
        try:
            return stream.recv(_LONGEST_PART)
        except (TimeoutError, BlockingIOError):
            return None

    def await_room(self, member: socket.socket, timeout: float) -> bool:
        """Whether it can be written to within `timeout` s."""
        return bool(select.select([], [member], [], max(timeout / self.scale, 0.0))[1])

    def step(self, seconds: float) -> None:
        """Lets stepped time go on; Refused."""
        raise Refused(f'step {seconds:g}: the time of the bus is not stepped', 'refused')

    def part(self) -> socket.socket | None:
        """The part of a program that is about to be started, which inherits it; None where none is needed."""
        return None

    def await_end(self, process: subprocess.Popen[bytes], timeout: float) -> int:
        """The exit status of a program that was asked to end; subprocess.TimeoutExpired after `timeout` s of the machine."""
        return process.wait(timeout)

    def close(self) -> None:
        """Leaves the time of the bus."""


class ScaledClock(Clock):
    """That of a bus in scaled time."""

    def __init__(self, page: hub_protocol.TimePage) -> None:
        self.scale = page.scale
        self._begin = page.machine_begin_ns / _NS

    def now(self) -> float:
        return self.scale * (time.monotonic() - self._begin)


class ToldClock(Clock):
    """One that the hub tells: what is readable at an instant is read before it is looked at."""

    def __init__(self, path: str, page: hub_protocol.TimePage) -> None:
        self.path = path
        self._page = page

    def now(self) -> float:
        return (self._page.now_ns - self._page.begin_ns) / _NS

    def await_change(self, look: Callable[[], Result | None], timeout: float) -> Result | None:
        deadline_ns = self._page.now_ns + round(timeout * _NS)
        self._begin_to_wait()
        while True:
            background().read_all()
            with changed:
                result = look()
            if result is not None or self._page.now_ns >= deadline_ns:
                return result
            self._go_on(deadline_ns)

    def pass_time(self, seconds: float) -> None:
        deadline_ns = self._page.now_ns + round(seconds * _NS)
        self._begin_to_wait()
        while self._page.now_ns < deadline_ns:
            self._go_on(deadline_ns, _LONGEST_STEP_NS)
            background().read_all()

    def receive(self, stream: socket.socket, timeout: float, is_answer: bool) -> bytes | None:
        stream.settimeout(0)

        def look() -> bytes | None:
            try:
                return stream.recv(_LONGEST_PART)
            except BlockingIOError:
                return None
        return self.await_change(look, timeout)

    def await_room(self, member: socket.socket, timeout: float) -> bool:
        return bool(self.await_change(lambda: select.select([], [member], [], 0)[1] or None, timeout))

    def part(self) -> socket.socket | None:
        return hub_protocol.join_clock(self.path, 0)

    def _begin_to_wait(self) -> None:
        """What the caller has done is over."""

    def _go_on(self, deadline_ns: int, longest_ns: int = _STEP_NS) -> None:
        """Lets time pass, at most until then; Ended."""
        raise NotImplementedError


class SteppedClock(ToldClock):
    """Stepped time, which goes on while something is waited for, but not for an answer."""

    def __init__(self, path: str, page: hub_protocol.TimePage) -> None:
        super().__init__(path, page)
        self._member = hub_protocol.join_asking(path)  # whose requests no frames of the bus are in the way of

    def receive(self, stream: socket.socket, timeout: float, is_answer: bool) -> bytes | None:
        return (Clock if is_answer else ToldClock).receive(self, stream, timeout, is_answer)

    def step(self, seconds: float) -> None:
        self.pass_time(seconds)

    def close(self) -> None:
        self._member.close()

    def _begin_to_wait(self) -> None:
        self._step(0)  # answered when all has been done that is to be done at the present

    def _go_on(self, deadline_ns: int, longest_ns: int = _STEP_NS) -> None:
        self._step(min(longest_ns, deadline_ns - self._page.now_ns))

    def _step(self, length_ns: int) -> None:
        try:  # those who act in it may take their time
            error, _, _ = hub_protocol.request(self._member, hub_protocol.STEP, payload=struct.pack('=q', length_ns), patience=None)
        except OSError:
            raise Ended(f'{self.path}: the hub has gone') from None
        if error:
            raise Refused(f'step {length_ns / _NS:g}: {os.strerror(error)}', 'refused')


class VirtualClock(ToldClock):
    """Virtual time, in which this process takes turns: time stands while it does anything but wait."""

    def __init__(self, path: str, page: hub_protocol.TimePage) -> None:
        super().__init__(path, page)
        self.users = 1
        self._flags = hub_protocol.TOUCHED
        self._clock = hub_protocol.join_clock(path, os.getpid())
        hub_protocol.take_turn(self._clock)

    def await_end(self, process: subprocess.Popen[bytes], timeout: float) -> int:
        deadline = time.monotonic() + timeout
        try:
            while process.poll() is None and time.monotonic() < deadline:
                self._begin_to_wait()
                self._go_on(self._page.now_ns)
                time.sleep(_LOOK_AGAIN)
        except Ended:
            pass
        return process.wait(max(deadline - time.monotonic(), 0.0))

    def close(self) -> None:
        self.users -= 1
        if self.users > 0:
            return
        del _virtual[self.path]
        try:
            hub_protocol.end_turn(self._clock, self._page.now_ns, hub_protocol.NO_INSTANT, hub_protocol.TOUCHED | hub_protocol.LEAVES)
        except OSError:
            pass
        self._clock.close()

    def _begin_to_wait(self) -> None:
        self._flags = hub_protocol.TOUCHED  # the caller may have written to anybody

    def _go_on(self, deadline_ns: int, longest_ns: int = _STEP_NS) -> None:
        try:
            hub_protocol.end_turn(self._clock, self._page.now_ns, deadline_ns, self._flags)
            hub_protocol.take_turn(self._clock)
            self._flags = 0
        except OSError:
            raise Ended(f'{self.path}: the hub has gone') from None


class PreloadedClock(Clock):
    """That of a bus by which this process lives already, under `with-can --time`."""

    def __init__(self, page: hub_protocol.TimePage) -> None:
        self._begin = page.begin_ns / _NS

    def now(self) -> float:
        return time.monotonic() - self._begin


def _is_preloaded() -> bool:
    return 'libcan-preload' in os.environ.get('LD_PRELOAD', '') and os.environ.get('CAN_TIME', 'real') != 'real'


_virtual: dict[str, VirtualClock] = {}  # by path: a process has one part in the time of a bus


def join(path: str, member: socket.socket) -> Clock:
    """The clock of the bus at `path`, of which `member` is one; OSError, Error."""
    page = hub_protocol.time_page(member)
    if page is None:
        return Clock()
    if _is_preloaded():
        return PreloadedClock(page)
    if page.mode == hub_protocol.SCALED:
        return ScaledClock(page)
    if page.mode == hub_protocol.STEPPED:
        return SteppedClock(path, page)
    path = os.path.realpath(path)
    if path in _virtual:
        _virtual[path].users += 1
    else:
        _virtual[path] = VirtualClock(path, page)
    return _virtual[path]


os.register_at_fork(after_in_child=_virtual.clear)
