"""The user-space bus for python-can: `can.Bus(interface='userbus', channel='/tmp/bus')`; without a channel that of `with-can`."""

from __future__ import annotations

import select
import socket
import time
from typing import Any

import can

from . import hub_protocol
from .bus import join_or_start
from .errors import Error
from .frame import Frame


class UserBus(can.BusABC):
    """A member of the bus at `channel`, the path of its socket.

    receive_own_messages: whether it hears what it has sent. Everything else is as python-can says of every bus.
    """

    def __init__(self, channel: str | None = None, receive_own_messages: bool = False, **kwargs: Any) -> None:
        path = channel or hub_protocol.default_path()
        try:
            self._member, self.bit_rate = join_or_start(path, 'vcan0')
        except (Error, OSError) as error:
            raise can.CanInitializationError(f'{path}: {error}') from error
        self.channel = path
        self.channel_info = f'user-space bus {path}'
        self._hears_itself = receive_own_messages
        self._member.setblocking(False)
        super().__init__(channel=path, **kwargs)

    def fileno(self) -> int:
        """The descriptor that can be read when a frame has come."""
        return self._member.fileno()

    def send(self, msg: can.Message, timeout: float | None = None) -> None:
        """Sends a frame; waits for room for `timeout` s, without end if not given. can.CanOperationError."""
        if msg.is_fd:
            raise can.CanOperationError('the user-space bus has classical frames only')
        message = hub_protocol.encode(Frame(
            msg.arbitration_id, b'' if msg.is_remote_frame else bytes(msg.data), extended=msg.is_extended_id,
            remote=msg.is_remote_frame, error=msg.is_error_frame, length=msg.dlc))
        deadline = None if timeout is None else time.monotonic() + timeout
        while True:
            try:
                self._member.send(message)
                return
            except BlockingIOError:
                left = None if deadline is None else max(0.0, deadline - time.monotonic())
                if not select.select([], [self._member], [], left)[1]:
                    raise can.CanOperationError('the bus is full') from None
            except OSError as error:
                raise can.CanOperationError(f'the hub has gone: {error}') from error

    def _recv_internal(self, timeout: float | None) -> tuple[can.Message | None, bool]:
        deadline = None if timeout is None else time.monotonic() + timeout
        while True:
            left = None if deadline is None else max(0.0, deadline - time.monotonic())
            if not select.select([self._member], [], [], left)[0]:
                return None, False
            try:
                message = self._member.recv(hub_protocol.LONGEST_MESSAGE)
            except BlockingIOError:
                continue
            except OSError as error:
                raise can.CanOperationError(f'the hub has gone: {error}') from error
            if not message:
                raise can.CanOperationError('the hub has gone')
            frame = hub_protocol.decode(message)
            if frame is not None and (self._hears_itself or not frame.own):
                return self._to_message(frame), False

    def _to_message(self, frame: Frame) -> can.Message:
        return can.Message(
            timestamp=frame.time, arbitration_id=frame.id, is_extended_id=frame.extended, is_remote_frame=frame.remote,
            is_error_frame=frame.error, dlc=frame.length, data=frame.data, channel=self.channel, is_rx=not frame.own)

    def shutdown(self) -> None:
        """Leaves the bus."""
        super().shutdown()
        self._member.close()

    @staticmethod
    def _detect_available_configs() -> list[dict[str, Any]]:
        """The bus of the user, if somebody serves it."""
        path = hub_protocol.default_path()
        try:
            with socket.socket(socket.AF_UNIX, socket.SOCK_SEQPACKET) as member:
                member.connect(path)
        except OSError:
            return []
        return [{'interface': 'userbus', 'channel': path}]
