"""The messages of the user-space bus (docs/reference/user-space-bus-protocol.md)."""

from __future__ import annotations

import errno
import os
import select
import socket
import struct

from .errors import Error
from .frame import ERROR_FLAG, EXTENDED_FLAG, REMOTE_FLAG, Frame

HELLO, BIND, SET_OPTION, INTERFACE_INDEX, INJECT = 0, 1, 3, 6, 11
LOOPBACK, OWN_MESSAGES, ERROR_FILTER = 0, 1, 2
LONGEST_MESSAGE = 8192
LONGEST_PATH = 107  # bytes
_FRAME = struct.Struct('=IB3x8s')
_TRAILER = struct.Struct('=iIqII')
_ALL_ERRORS = 0x1FFFFFFF
_NS = 1_000_000_000


def default_path() -> str:
    """Where a bus is that nobody has named: $CAN_BUS, else `can-bus` in the runtime folder of the user."""
    named = os.environ.get('CAN_BUS')
    if named:
        return named
    folder = os.environ.get('XDG_RUNTIME_DIR') or ('/run' if os.geteuid() == 0 else f'/tmp/can-bus-{os.geteuid()}')
    return os.path.join(folder, 'can-bus')


_PATIENCE = 10.0  # s, for the answer of a hub


def request(member: socket.socket, operation: int, value: int = 0, payload: bytes = b'') -> tuple[int, int, bytes]:
    """The reply to a request: errno, value, payload; OSError if there is none."""
    select.select([], [member], [], _PATIENCE)
    mine, its = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    with mine:
        with its:
            socket.send_fds(member, [struct.pack('=IiI', operation, value, len(payload)) + payload], [its.fileno()])
        mine.settimeout(_PATIENCE)
        reply = mine.recv(LONGEST_MESSAGE)
    if len(reply) < 12:
        raise ConnectionResetError(errno.ECONNRESET, 'the hub has gone')
    error, result, size = struct.unpack_from('=iiI', reply)
    return error, result, reply[12:12 + size]


def ask(member: socket.socket, operation: int, value: int = 0, payload: bytes = b'') -> tuple[int, bytes]:
    """Value and payload of the reply to a request; OSError with the errno that the hub gives."""
    error, result, answer = request(member, operation, value, payload)
    if error:
        raise OSError(error, os.strerror(error))
    return result, answer


def join(path: str, interface: str) -> tuple[socket.socket, int]:
    """A member of the bus at `path` that hears itself and error frames, bound to `interface`; and the bit rate of the bus.

    OSError where nobody serves, Error where somebody else does.
    """
    if len(os.fsencode(path)) > LONGEST_PATH:
        raise Error(f'{path}: expected a path of at most {LONGEST_PATH} bytes, got {len(os.fsencode(path))}')
    member = socket.socket(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    try:
        while True:
            try:
                member.bind(b'\0can-bus.1/port/' + os.urandom(8).hex().encode())
                break
            except OSError as taken:
                if taken.errno != errno.EADDRINUSE:
                    raise
        member.connect(path)
        user = struct.unpack('3i', member.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, 12))[1]
        if user not in (os.geteuid(), 0):
            raise Error(f'{path}: the bus is served by user {user}, expected your own or root')
        bit_rate, _ = ask(member, HELLO)
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
