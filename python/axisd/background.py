"""The one thread of the package: it starts programs, and reads what they, the buses and the units send.

Programs end with the thread that has started them (PR_SET_PDEATHSIG counts threads), so this is one that ends with
the process alone, whichever thread of the caller asks for a program.
"""

from __future__ import annotations

import collections
import os
import selectors
import socket
import sys
import threading
import time
from typing import Any, Callable, TypeVar

__tracebackhide__ = True  # a failed test shows its own lines

Result = TypeVar('Result')

#: Guards whatever the thread has read; notified after each change of it.
changed = threading.Condition()


def await_change(look: Callable[[], Result | None], timeout: float) -> Result | None:
    """What `look` gives, as soon as that is not None; it is asked under `changed`, after each change. None after `timeout` s."""
    deadline = time.monotonic() + timeout
    with changed:
        while True:
            result = look()
            if result is not None:
                return result
            left = deadline - time.monotonic()
            if left <= 0:
                return None
            changed.wait(left)


class Background:
    """A thread that watches descriptors and does jobs. Use background()."""

    def __init__(self) -> None:
        self._selector = selectors.DefaultSelector()
        self._wake, self._woken = socket.socketpair()
        self._woken.setblocking(False)
        self._selector.register(self._woken, selectors.EVENT_READ)
        self._jobs: collections.deque[Callable[[], None]] = collections.deque()
        self._thread = threading.Thread(target=self._serve, name='axisd', daemon=True)
        self._thread.start()

    def run(self, job: Callable[[], Result]) -> Result:
        """The result of `job`, done on the thread; what it raises is raised here."""
        if threading.current_thread() is self._thread:
            return job()
        outcome: dict[str, Any] = {}
        done = threading.Event()

        def attempt() -> None:
            try:
                outcome['result'] = job()
            except BaseException as error:  # pylint: disable=broad-except
                outcome['error'] = error
            done.set()

        self._jobs.append(attempt)
        self._wake.send(b'!')
        done.wait()
        if 'error' in outcome:
            raise outcome['error']
        result: Result = outcome['result']
        return result

    def watch(self, descriptor: int, readable: Callable[[], None]) -> None:
        """Has `readable` called under `changed`, on the thread or in read_all(), whenever there may be something to read."""
        with changed:
            self._selector.register(descriptor, selectors.EVENT_READ, readable)

    def unwatch(self, descriptor: int) -> None:
        """Ends watch(); of a descriptor that is not watched nothing."""
        with changed:
            try:
                self._selector.unregister(descriptor)
            except (KeyError, ValueError):
                pass

    def read_all(self) -> None:
        """Returns when nothing is left to read."""
        with changed:
            while ready := [key for key, _ in self._selector.select(0) if key.fileobj is not self._woken]:
                for key in ready:
                    self._read(key)

    def _drain(self) -> None:
        try:
            while self._woken.recv(4096):
                pass
        except BlockingIOError:
            pass
        while self._jobs:
            self._jobs.popleft()()

    def _serve(self) -> None:
        while True:
            for key, _ in self._selector.select():
                if key.fileobj is self._woken:
                    self._drain()
                    continue
                with changed:
                    self._read(key)

    def _read(self, key: selectors.SelectorKey) -> None:
        if self._selector.get_map().get(key.fileobj) is not key:
            return  # it is no longer watched
        try:
            key.data()
        except Exception:  # pylint: disable=broad-except
            # The others go on; this descriptor would be ready for ever.
            threading.excepthook(threading.ExceptHookArgs((*sys.exc_info(), self._thread)))
            self.unwatch(key.fd)


_instance: Background | None = None
_making = threading.Lock()


def background() -> Background:
    """The thread of this process."""
    global _instance  # pylint: disable=global-statement
    with _making:
        if _instance is None:
            _instance = Background()
        return _instance


def _forget() -> None:
    """A forked child has the objects, but no thread."""
    global _instance, _making  # pylint: disable=global-statement
    _instance = None
    _making = threading.Lock()
    changed.__init__()  # type: ignore[misc]  # pylint: disable=unnecessary-dunder-call  # a thread that is not here may hold it


os.register_at_fork(after_in_child=_forget)
