"""What goes wrong, as exceptions: all are Error."""

from __future__ import annotations

from typing import Any, Mapping


class Error(Exception):
    """Anything that this package raises by itself."""


class Missing(Error):
    """A program of axisd was not found; the message says where it was looked for."""


class Ended(Error):
    """A daemon or hub has ended although it is needed; the message has the last lines of its log."""


class Refused(Error):
    """The unit or the hub has refused a request.

    code: as in docs/reference/control.md, such as "out-of-range"; details: what else the answer has (`limits`, `abort_code`).
    """

    def __init__(self, message: str, code: str = '', details: Mapping[str, Any] | None = None):
        super().__init__(message)
        self.code = code
        self.details = dict(details or {})


class Abort(Refused):
    """An SDO transfer was aborted by the server; abort_code is what it has sent."""

    def __init__(self, message: str, abort_code: int):
        super().__init__(message, 'abort', {'abort_code': f'0x{abort_code:08X}'})
        self.abort_code = abort_code


class Timeout(Error, TimeoutError):
    """Something has not come in time; the message says what was awaited, and what was seen last."""
