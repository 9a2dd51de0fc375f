"""An SDO client (CiA 301, 7.2.4): expedited and segmented transfers."""

from __future__ import annotations

import struct

from .bus import Bus, told
from .errors import Abort, Timeout
from .frame import Frame

__tracebackhide__ = True  # a failed test shows its own lines

_TOGGLE = 0x10
#: What is told of an abort code; others are told by their number.
ABORT_TEXTS = {
    0x05030000: 'toggle bit not alternated', 0x05040000: 'SDO protocol timed out', 0x05040001: 'command specifier unknown',
    0x05040004: 'CRC error', 0x05040005: 'out of memory', 0x06010000: 'unsupported access', 0x06010001: 'write-only object',
    0x06010002: 'read-only object', 0x06020000: 'object does not exist', 0x06040041: 'object cannot be mapped',
    0x06040042: 'PDO length exceeded', 0x06040043: 'parameter incompatible', 0x06070010: 'length does not match',
    0x06070012: 'too long', 0x06070013: 'too short', 0x06090011: 'sub-index does not exist', 0x06090030: 'value out of range',
    0x06090031: 'value too high', 0x06090032: 'value too low', 0x08000000: 'general error',
    0x08000020: 'cannot be transferred', 0x08000021: 'local control', 0x08000022: 'present device state',
}


class SdoClient:
    """Transfers with the default server of a node, or with the one at the given identifiers."""

    def __init__(self, bus: Bus, node_id: int, *, request_id: int | None = None, response_id: int | None = None,
                 timeout: float = 1.0) -> None:
        self.timeout = timeout  #: s that an answer may take
        self._bus = bus
        self._request_id = request_id if request_id is not None else 0x600 + node_id
        self._response_id = response_id if response_id is not None else 0x580 + node_id

    def read(self, index: int, sub_index: int = 0) -> bytes:
        """The bytes of an object; Abort, Timeout."""
        answer = self._ask(struct.pack('<BHB4x', 0x40, index, sub_index), 2, index, sub_index)
        if answer[0] & 2:
            return answer[4:8 - (answer[0] >> 2 & 3) if answer[0] & 1 else 8]
        result, toggle = b'', 0
        while True:
            answer = self._ask(bytes([0x60 | toggle]).ljust(8, b'\0'), 0, index, sub_index)
            if answer[0] & _TOGGLE != toggle:
                raise self._abort(index, sub_index, 0x05030000)
            result += answer[1:8 - (answer[0] >> 1 & 7)]
            if answer[0] & 1:
                return result
            toggle ^= _TOGGLE

    def write(self, index: int, sub_index: int, data: bytes) -> None:
        """Writes the bytes of an object; Abort, Timeout."""
        if 1 <= len(data) <= 4:
            self._ask(struct.pack('<BHB', 0x23 | (4 - len(data)) << 2, index, sub_index) + data.ljust(4, b'\0'),
                      3, index, sub_index)
            return
        self._ask(struct.pack('<BHBI', 0x21, index, sub_index, len(data)), 3, index, sub_index)
        toggle = 0
        for at in range(0, max(len(data), 1), 7):
            part = data[at:at + 7]
            last = 1 if at + 7 >= len(data) else 0
            answer = self._ask(bytes([toggle | (7 - len(part)) << 1 | last]) + part.ljust(7, b'\0'), 1, index, sub_index)
            if answer[0] & _TOGGLE != toggle:
                raise self._abort(index, sub_index, 0x05030000)
            toggle ^= _TOGGLE

    def _ask(self, request: bytes, command: int, index: int, sub_index: int) -> bytes:
        """The next response; Abort unless it is the `command` that is expected."""
        place = self._bus.count
        reader = self._bus.reader()
        self._bus.send(Frame(self._request_id, request))
        frame = reader.wait_for(lambda frame: frame.id == self._response_id and not frame.error, self.timeout)
        if frame is None:
            raise Timeout(f'SDO {index:04X}:{sub_index:02X}: no answer under {self._response_id:03X}h within '
                          f'{self.timeout:g} s; {told(self._bus.since(place))}')
        answer = frame.data.ljust(8, b'\0')
        if answer[0] == 0x80:
            code = struct.unpack_from('<I', answer, 4)[0]
            raise Abort(f'SDO {index:04X}:{sub_index:02X}: {ABORT_TEXTS.get(code, "aborted")} ({code:08X}h)', code)
        is_other = command in (2, 3) and answer[1:4] != struct.pack('<HB', index, sub_index)
        if answer[0] >> 5 != command or is_other:
            raise self._abort(index, sub_index, 0x05040001, f'; it was answered by {answer.hex().upper()}')
        return answer

    def _abort(self, index: int, sub_index: int, code: int, more: str = '') -> Abort:
        """Tells the server, and is the error for the caller."""
        self._bus.send(Frame(self._request_id, struct.pack('<BHBI', 0x80, index, sub_index, code)))
        return Abort(f'SDO {index:04X}:{sub_index:02X}: aborted by the client: {ABORT_TEXTS[code]}{more}', code)
