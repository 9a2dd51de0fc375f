"""The messages of the user-space bus (docs/reference/user-space-bus-protocol.md)."""

from __future__ import annotations

import errno
import mmap
import os
import select
import socket
import struct

from .errors import Error
from .frame import ERROR_FLAG, EXTENDED_FLAG, REMOTE_FLAG, Frame

HELLO, BIND, SET_OPTION, INTERFACE_INDEX, INJECT, TIME, STEP = 0, 1, 3, 6, 11, 14, 15
LOOPBACK, OWN_MESSAGES, ERROR_FILTER = 0, 1, 2
LONGEST_MESSAGE = 8192
LONGEST_PATH = 107  # bytes
_FRAME = struct.Struct('=IB3x8s')
_TRAILER = struct.Struct('=iIqII')
_ALL_ERRORS = 0x1FFFFFFF
# The time of a bus that has one of its own (can/userbus/time.hpp).
JOIN, WAIT = 0, 1
TOUCHED, LEAVES = 1, 2
REAL, SCALED, VIRTUAL, STEPPED = range(4)
NO_INSTANT = 2**63 - 1
_TIME_MESSAGE = struct.Struct('=IIqqii')
_TURN = struct.Struct('=qqII')
_TIME_PAGE = struct.Struct('=IIdqqqq')
_TIME_PAGE_SIZE = 4096
_NS = 1_000_000_000


def default_path() -> str:
    """Where a bus is that nobody has named: $CAN_BUS, else `can-bus` in the runtime folder of the user."""
    named = os.environ.get('CAN_BUS')
    if named:
        return named
    folder = os.environ.get('XDG_RUNTIME_DIR') or ('/run' if os.geteuid() == 0 else f'/tmp/can-bus-{os.geteuid()}')
    return os.path.join(folder, 'can-bus')


_PATIENCE = 10.0  # s, for the answer of a hub


def _request(member: socket.socket, operation: int, value: int, payload: bytes,
             patience: float | None) -> tuple[int, int, bytes, list[int]]:
    select.select([], [member], [], patience)
    mine, its = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    with mine:
        with its:
            socket.send_fds(member, [struct.pack('=IiI', operation, value, len(payload)) + payload], [its.fileno()])
        mine.settimeout(patience)
        reply, passed, _, _ = socket.recv_fds(mine, LONGEST_MESSAGE, 1)
    if len(reply) < 12:
        raise ConnectionResetError(errno.ECONNRESET, 'the hub has gone')
    error, result, size = struct.unpack_from('=iiI', reply)
    return error, result, reply[12:12 + size], passed


def request(member: socket.socket, operation: int, value: int = 0, payload: bytes = b'', *,
            patience: float | None = _PATIENCE) -> tuple[int, int, bytes]:
    """The reply to a request: errno, value, payload; OSError if there is none."""
    error, result, answer, passed = _request(member, operation, value, payload, patience)
    for descriptor in passed:
        os.close(descriptor)
    return error, result, answer


def ask(member: socket.socket, operation: int, value: int = 0, payload: bytes = b'') -> tuple[int, bytes]:
    """Value and payload of the reply to a request; OSError with the errno that the hub gives."""
    error, result, answer = request(member, operation, value, payload)
    if error:
        raise OSError(error, os.strerror(error))
    return result, answer


def _greeted(path: str, kind: bytes) -> tuple[socket.socket, int]:
    """A connection of a kind that the hub knows, and the bit rate."""
    member = socket.socket(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    try:
        while True:
            try:
                member.bind(b'\0can-bus.1/' + kind + b'/' + os.urandom(8).hex().encode())
                break
            except OSError as taken:
                if taken.errno != errno.EADDRINUSE:
                    raise
        member.connect(path)
        user = struct.unpack('3i', member.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, 12))[1]
        if user not in (os.geteuid(), 0):
            raise Error(f'{path}: the bus is served by user {user}, expected your own or root')
        bit_rate, _ = ask(member, HELLO)
        return member, bit_rate
    except BaseException:
        member.close()
        raise


def join(path: str, interface: str) -> tuple[socket.socket, int]:
    """A member of the bus at `path` that hears itself and error frames, bound to `interface`; and the bit rate of the bus.

    OSError where nobody serves, Error where somebody else does.
    """
    if len(os.fsencode(path)) > LONGEST_PATH:
        raise Error(f'{path}: expected a path of at most {LONGEST_PATH} bytes, got {len(os.fsencode(path))}')
    member, bit_rate = _greeted(path, b'port')
    try:
        ask(member, SET_OPTION, payload=struct.pack('=II', OWN_MESSAGES, 1))
        ask(member, SET_OPTION, payload=struct.pack('=II', ERROR_FILTER, _ALL_ERRORS))
        try:
            index, _ = ask(member, INTERFACE_INDEX, payload=interface.encode())
        except OSError as wrong:
            if wrong.errno != errno.ENODEV:
                raise
            raise Error(f'"{interface}" is no name of a CAN interface') from None
        ask(member, BIND, index)
        return member, bit_rate
    except BaseException:
        member.close()
        raise


def join_asking(path: str) -> socket.socket:
    """A connection to the bus at `path` for requests alone; OSError, Error."""
    return _greeted(path, b'port')[0]


def encode(frame: Frame) -> bytes:
    """The message to the hub."""
    identifier = frame.id | (EXTENDED_FLAG if frame.extended else 0) | (REMOTE_FLAG if frame.remote else 0) | (
        ERROR_FLAG if frame.error else 0)
    return _FRAME.pack(identifier, frame.length, frame.data.ljust(8, b'\0'))


def decode(message: bytes) -> Frame | None:
    """The frame in a message of the hub; None if it has none."""
    if len(message) != _FRAME.size + _TRAILER.size:
        return None
    identifier, length, data = _FRAME.unpack_from(message)
    _, flags, time_ns, dropped, _ = _TRAILER.unpack_from(message, _FRAME.size)
    remote = bool(identifier & REMOTE_FLAG)
    return Frame(identifier & 0x1FFFFFFF, b'' if remote else data[:length], extended=bool(identifier & EXTENDED_FLAG),
                 remote=remote, error=bool(identifier & ERROR_FLAG), time=time_ns / _NS,
                 own=bool(flags & socket.MSG_CONFIRM), length=length, dropped=dropped)


class TimePage:
    """The memory in which a hub tells the time of its bus."""

    def __init__(self, memory: mmap.mmap) -> None:
        self._memory = memory
        self.mode, _, self.scale, self.begin_ns, self.machine_begin_ns, _, _ = _TIME_PAGE.unpack_from(memory)

    @property
    def now_ns(self) -> int:
        """The present of virtual and stepped time."""
        return int(_TIME_PAGE.unpack_from(self._memory)[-1])


def time_page(member: socket.socket) -> TimePage | None:
    """The page of a bus that has a time of its own; None if it has the machine's."""
    error, _, _, passed = _request(member, TIME, 0, b'', _PATIENCE)
    if not passed:
        if error and error not in (errno.EINVAL, errno.EOPNOTSUPP):  # an older hub knows nothing of time
            raise OSError(error, os.strerror(error))
        return None
    try:
        return TimePage(mmap.mmap(passed[0], _TIME_PAGE_SIZE, mmap.MAP_SHARED, mmap.PROT_READ))
    finally:
        os.close(passed[0])


def join_clock(path: str, process: int) -> socket.socket:
    """The part of a process in the time of the bus at `path`, 0: of one that is yet to be started. OSError, Error."""
    clock, _ = _greeted(path, b'clock')
    clock.send(_TIME_MESSAGE.pack(JOIN, 0, 0, 0, process, 0))
    return clock


def end_turn(clock: socket.socket, now_ns: int, until_ns: int, flags: int = 0) -> None:
    """There is nothing to do before `until_ns`; OSError without a hub."""
    clock.send(_TIME_MESSAGE.pack(WAIT, flags, now_ns, until_ns, 0, 0))


def take_turn(clock: socket.socket) -> int:
    """Waits for the next turn, and gives its present; OSError without a hub."""
    message = clock.recv(_TURN.size)
    if len(message) != _TURN.size:
        raise ConnectionResetError(errno.ECONNRESET, 'the hub has gone')
    now_ns: int = _TURN.unpack(message)[0]
    return now_ns
