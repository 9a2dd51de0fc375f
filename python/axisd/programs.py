"""The programs of axisd: where they are, how they are started, and that nothing of them is left behind."""

from __future__ import annotations

import atexit
import collections
import ctypes
import os
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import tempfile
import threading
import warnings
from typing import Mapping, Sequence

from .background import await_change, background, changed
from .bus_clock import Clock
from .errors import Ended, Missing, Timeout

__tracebackhide__ = True  # a failed test shows its own lines

_PR_SET_PDEATHSIG = 1
_prctl = ctypes.CDLL(None, use_errno=True).prctl
_LOG_LINES = 200  # that are kept of a program
_TOLD_LINES = 10  # of them, in an error
_LONGEST_END = 5.0  # s, from SIGTERM to SIGKILL
#: What would make a daemon take something of the caller for its own.
_NOT_INHERITED = ('NOTIFY_SOCKET', 'WATCHDOG_USEC', 'WATCHDOG_PID', 'STATE_DIRECTORY', 'RUNTIME_DIRECTORY', 'CAN_BUS', 'CAN_TIME')


def find(name: str) -> str:
    """The path of a program: in $AXISD_BIN_DIR, else in the build that the package belongs to, else in PATH; Missing."""
    folder = os.environ.get('AXISD_BIN_DIR')
    if folder:
        path = os.path.join(folder, name)
        if os.access(path, os.X_OK):
            return path
        raise Missing(f'{name}: not in $AXISD_BIN_DIR ({folder})')
    package = pathlib.Path(__file__).absolute().parent
    # In a build beside its folder python, in the sources, in an installation above lib/python3/dist-packages.
    for above in (package.parents[1] / 'bin', package.parents[1] / 'build' / 'release' / 'bin', package.parents[3] / 'bin'):
        if os.access(above / name, os.X_OK):
            return str(above / name)
    found = shutil.which(name)
    if found:
        return found
    raise Missing(f'{name}: not beside the package ({package}) and not in PATH; '
                  'install axisd and can-userbus, or name their folder in $AXISD_BIN_DIR')


class Session:
    """The folder of this process for sockets and states, and the guard that removes it when the process is gone."""

    _current: Session | None = None
    _lock = threading.Lock()

    def __init__(self) -> None:
        self.process = os.getpid()
        self.folder = tempfile.mkdtemp(prefix='axisd-')
        # It reads until the last writer has gone, however that ended; signals of a terminal are not for it.
        self._guard = subprocess.Popen(
            ['/bin/sh', '-c', 'read -r end; rm -rf -- "$1"', 'axisd-guard', self.folder],
            stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True, cwd='/')
        atexit.register(self.end)

    @classmethod
    def current(cls) -> Session:
        """That of this process; made when it is first needed."""
        with cls._lock:
            if cls._current is None or cls._current.process != os.getpid():
                cls._current = cls()
            return cls._current

    def new_folder(self) -> str:
        """A folder in it."""
        return tempfile.mkdtemp(dir=self.folder, prefix='')

    def end(self) -> None:
        """Removes the folder and ends the guard; of a forked child nothing."""
        if self.process != os.getpid():
            return
        shutil.rmtree(self.folder, ignore_errors=True)
        self._guard.kill()
        self._guard.wait()
        if self._guard.stdin:
            self._guard.stdin.close()
        Session._current = None


class Program:
    """A running program and the last lines that it has written to standard error.

    It ends with this process, whatever ends that, and is left alone by the keys of the terminal.
    """

    def __init__(self, words: Sequence[str], environment: Mapping[str, str] | None = None, clock: Clock | None = None) -> None:
        """clock: that of the bus by whose time it lives."""
        self.name = os.path.basename(words[0])
        self.lines: collections.deque[str] = collections.deque(maxlen=_LOG_LINES)
        self.has_ended = False
        self._begun = ''
        self._clock = clock or Clock()
        parent = os.getpid()

        def end_with_parent() -> None:
            _prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)
            if os.getppid() != parent:
                os._exit(1)

        def start(part: socket.socket | None) -> subprocess.Popen[bytes]:
            # Newer versions warn of what another thread may hold; what is called in the child takes nothing.
            with warnings.catch_warnings():
                warnings.simplefilter('ignore', DeprecationWarning)
                return subprocess.Popen(  # pylint: disable=consider-using-with
                    list(words), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                    start_new_session=True, preexec_fn=end_with_parent, pass_fds=() if part is None else (part.fileno(),),
                    env={**{name: value for name, value in os.environ.items() if name not in _NOT_INHERITED},
                         **(environment or {})})

        part = self._clock.part()
        try:
            self.process = background().run(lambda: start(part))
        except OSError as error:
            raise Missing(f'{words[0]}: {error.strerror}') from None
        finally:
            if part is not None:
                part.close()
        assert self.process.stderr
        self._log = self.process.stderr.fileno()
        os.set_blocking(self._log, False)
        background().watch(self._log, self._read)

    @property
    def pid(self) -> int:
        """Its process identifier."""
        return self.process.pid

    def expect(self, pattern: str, timeout: float) -> str:
        """The first line that matches; Ended with the log if there will be none, Timeout after `timeout` s of its clock."""
        def look() -> str | None:
            for line in self.lines:
                if re.search(pattern, line):
                    return line
            return '' if self.has_ended else None
        found = self._clock.await_change(look, timeout)
        if found:
            return found
        if found is None:
            raise Timeout(f'{self.name} has not written "{pattern}" within {timeout:g} s; {self._told()}')
        raise self.ended()

    def ended(self) -> Ended:
        """The error that says that it has ended, with its log."""
        await_change(lambda: self.has_ended or None, _LONGEST_END)
        try:
            status = self.process.wait(_LONGEST_END)
        except subprocess.TimeoutExpired:
            return Ended(f'{self.name} has closed its connections; {self._told()}')
        how = f'was ended by {signal.Signals(-status).name}' if status < 0 else f'has ended with status {status}'
        return Ended(f'{self.name} {how}; {self._told()}')

    def end(self) -> int:
        """Ends it by SIGTERM, by SIGKILL if it takes long; its exit status."""
        self.process.terminate()
        try:
            status = self._clock.await_end(self.process, _LONGEST_END)
        except subprocess.TimeoutExpired:
            self.process.kill()
            status = self.process.wait()
        except KeyboardInterrupt:
            self.process.kill()
            self.process.wait()
            raise
        finally:
            background().unwatch(self._log)
            if self.process.stderr:
                self.process.stderr.close()
        return status

    def _told(self) -> str:
        if not self.lines:
            return 'it has written nothing'
        return 'its log: ' + '\n'.join(list(self.lines)[-_TOLD_LINES:])

    def _read(self) -> None:
        try:
            part = os.read(self._log, 65536)
        except BlockingIOError:
            return
        with changed:
            if not part:
                self.has_ended = True
                if self._begun:
                    self.lines.append(self._begun)
                background().unwatch(self._log)
            *whole, self._begun = (self._begun + part.decode(errors='replace')).split('\n')
            self.lines.extend(whole)
            changed.notify_all()
