"""CAN frames: as candump prints them, and what they are on a CANopen network."""

from __future__ import annotations

import dataclasses
import re
import struct

EXTENDED_FLAG = 0x80000000
REMOTE_FLAG = 0x40000000
ERROR_FLAG = 0x20000000
_LARGEST_BASE = 0x7FF
_LARGEST_EXTENDED = 0x1FFFFFFF
_TEXT = re.compile(r'([0-9A-Fa-f]{3}|[0-9A-Fa-f]{8})#(?:(R)([0-8])?|((?:[0-9A-Fa-f]{2}\.?){0,8}))')


@dataclasses.dataclass(frozen=True)
class Frame:
    """A classical CAN frame.

    id: identifier; extended: of 29 bits; remote: a request for `length` bytes; error: an error frame.
    time: end of the frame on the bus, s since 1970; own: this member has sent it; dropped: frames that this member had lost by then.
    """
    id: int
    data: bytes = b''
    extended: bool = False
    remote: bool = False
    error: bool = False
    time: float = 0.0
    own: bool = False
    length: int = -1
    dropped: int = 0

    def __post_init__(self) -> None:
        if not 0 <= self.id <= (_LARGEST_EXTENDED if self.extended or self.error else _LARGEST_BASE):
            raise ValueError(f'identifier: expected 0 to {_LARGEST_EXTENDED if self.extended else _LARGEST_BASE:X}h, '
                             f'got {self.id:X}h')
        if len(self.data) > 8:
            raise ValueError(f'data: expected at most 8 bytes, got {len(self.data)}')
        if self.length < 0:
            object.__setattr__(self, 'length', len(self.data))

    @classmethod
    def parse(cls, text: str) -> Frame:
        """From `185#3716`, `000#`, `705#R`, `18FF50E5#0102`; ValueError."""
        match = _TEXT.fullmatch(text.strip())
        if not match:
            raise ValueError(f'frame: expected ID#DATA as cansend takes it, got "{text}"')
        identifier, remote, length, data = match.groups()
        return cls(int(identifier, 16), bytes.fromhex((data or '').replace('.', '')), extended=len(identifier) == 8,
                   remote=bool(remote), length=int(length or 0) if remote else -1)

    def __str__(self) -> str:
        identifier = f'{self.id:08X}' if self.extended or self.error else f'{self.id:03X}'
        return f'{identifier}#{"R" + str(self.length or "") if self.remote else self.data.hex().upper()}'

    def candump(self, interface: str = 'vcan0') -> str:
        """The line of `candump -L`."""
        return f'({self.time:.6f}) {interface} {self}'

    @property
    def service(self) -> str:
        """What it is in the predefined connection set of CiA 301, with node and content as far as the frame tells."""
        return _service(self)


_NMT_COMMANDS = {1: 'start', 2: 'stop', 128: 'enter Pre-operational', 129: 'reset node', 130: 'reset communication'}
_NMT_STATES = {4: 'Stopped', 5: 'Operational', 127: 'Pre-operational'}
_NODE_SERVICES = {0x180: 'TPDO 1', 0x200: 'RPDO 1', 0x280: 'TPDO 2', 0x300: 'RPDO 2', 0x380: 'TPDO 3', 0x400: 'RPDO 3',
                  0x480: 'TPDO 4', 0x500: 'RPDO 4'}


def _service(frame: Frame) -> str:
    if frame.error:
        return 'error frame'
    if frame.extended:
        return ''
    if frame.id == 0:
        return _nmt(frame.data)
    if frame.id == 0x080:
        return 'SYNC'
    if frame.id == 0x100:
        return 'TIME'
    function, node = frame.id & 0x780, frame.id & 0x7F
    if function == 0x080 and node and len(frame.data) == 8:
        code, register = struct.unpack_from('<HB', frame.data)
        return f'EMCY of node {node}: {"no error" if code == 0 else f"{code:04X}h"}, error register {register:02X}h'
    if function == 0x700 and node:
        return _error_control(frame, node)
    if function in (0x580, 0x600) and node:
        return _sdo(frame.data, function == 0x580, node)
    name = _NODE_SERVICES.get(function)
    return f'{name} of node {node}' if name and node else ''


def _nmt(data: bytes) -> str:
    if len(data) != 2:
        return 'NMT command of a wrong length'
    return f'NMT {_NMT_COMMANDS.get(data[0], f"command {data[0]:02X}h")}: {f"node {data[1]}" if data[1] else "all nodes"}'


def _error_control(frame: Frame, node: int) -> str:
    if frame.remote:
        return f'guarding request to node {node}'
    if frame.data == b'\0':
        return f'boot-up of node {node}'
    if len(frame.data) != 1:
        return f'error control of node {node}, of a wrong length'
    state = _NMT_STATES.get(frame.data[0] & 0x7F, f'state {frame.data[0] & 0x7F:02X}h')
    return f'heartbeat of node {node}: {state}'


_REQUESTS = {0: 'download segment', 1: 'write', 2: 'read', 3: 'upload segment', 4: 'abort', 5: 'block upload', 6: 'block download'}
_RESPONSES = {0: 'segment', 1: 'segment written', 2: 'value', 3: 'written', 4: 'abort', 5: 'block download', 6: 'block upload'}


def _sdo(data: bytes, is_response: bool, node: int) -> str:
    who = f'SDO {"from" if is_response else "to"} node {node}'
    if len(data) != 8:
        return f'{who}, of a wrong length'
    command = data[0] >> 5
    if is_response:
        name = _RESPONSES.get(command, f'{data[0]:02X}h')
        has_object = command in (2, 3, 4)
    else:
        name = _REQUESTS.get(command, f'{data[0]:02X}h')
        has_object = command in (1, 2, 4)
    if not has_object:
        return f'{who}: {name}'
    index, sub_index, value = struct.unpack('<HBI', data[1:])
    text = f'{who}: {name} {index:04X}:{sub_index:02X}'
    return f'{text}, {value:08X}h' if command == 4 else text
