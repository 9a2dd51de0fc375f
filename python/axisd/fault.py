"""Faults that are injected: values that go to a unit or a hub, and what has become of them."""

from __future__ import annotations

from typing import Any, Callable, Mapping, Protocol

from .bus_clock import Clock
from .errors import Error, Timeout

__tracebackhide__ = True  # a failed test shows its own lines

_LOOK_AGAIN = 0.01  # s: nothing tells that a count has changed


def to_fault(kind: str | Mapping[str, Any], arguments: Mapping[str, Any], seed: int | None = None) -> dict[str, Any]:
    """The fault as an object of JSON: `kind` and its arguments, or a whole one with further arguments.

    An underscore behind a word that Python keeps for itself is left out (`while_`). `seed` is that of a fault with a probability
    that has none.
    """
    fault = dict(kind) if isinstance(kind, Mapping) else {'kind': kind}
    fault.update((key.rstrip('_'), value) for key, value in arguments.items() if value is not None)
    if seed is not None and 'probability' in fault and 'seed' not in fault:
        fault['seed'] = seed
    return fault


class Holder(Protocol):  # pylint: disable=too-few-public-methods
    """Who has faults: a unit or a bus."""

    @property
    def clock(self) -> Clock:
        """That of its bus."""

    def fault_rows(self) -> list[dict[str, Any]]:
        """A row a fault, as `inject.list` has them."""

    def remove_fault(self, number: int) -> None:
        """Takes one back."""


class Fault:
    """A fault that was injected. As a context manager it is taken back at the end of the block."""

    def __init__(self, holder: Holder, number: int, fault: Mapping[str, Any]) -> None:
        self.id = number
        self.kind: str = fault['kind']
        self.arguments = {key: value for key, value in fault.items() if key != 'kind'}
        self._holder = holder
        self._last: dict[str, Any] = {}
        self._is_removed = False

    def __enter__(self) -> Fault:
        return self

    def __exit__(self, *_: object) -> None:
        self.remove()

    def __repr__(self) -> str:
        return f'<axisd.Fault {self.id} {describe(self.look())}>'

    def look(self) -> dict[str, Any]:
        """Its row now; behind remove() the last one."""
        if not self._is_removed:
            for row in self._holder.fault_rows():
                if row['id'] == self.id:
                    self._last = row
                    return row
            if not self._last:
                raise Error(f'fault {self.id} ({self.kind}) is no longer there')
            self._is_removed = True
        return self._last

    @property
    def state(self) -> str:
        """`waiting`, `active` or `over`; `removed`."""
        row = self.look()
        return 'removed' if self._is_removed else str(row['state'])

    @property
    def hits(self) -> int:
        """How often it has struck."""
        return int(self.look()['hits'])

    @property
    def opportunities(self) -> int:
        """How often it could have."""
        return int(self.look()['opportunities'])

    @property
    def hit_at(self) -> list[int]:
        """The numbers of the first 16 opportunities at which it has struck."""
        return list(self.look().get('hit_at', ()))

    def wait(self, hits: int = 1, timeout: float = 10.0) -> None:
        """Returns when it has struck so often; Timeout."""
        self._wait(lambda row: bool(row['hits'] >= hits), f'hit {hits}', timeout)

    def wait_over(self, timeout: float = 10.0) -> None:
        """Returns when it is over; Timeout."""
        self._wait(lambda row: bool(row['state'] == 'over'), 'the end', timeout)

    def remove(self) -> None:
        """Takes it back. What it has done is still told; a second time it does nothing."""
        if self._is_removed:
            return
        self.look()
        if not self._is_removed:
            self._holder.remove_fault(self.id)
            self._is_removed = True

    def _wait(self, holds: Callable[[dict[str, Any]], bool], what: str, timeout: float) -> None:
        deadline = self._holder.clock.now() + timeout
        while not holds(row := self.look()):
            if self._holder.clock.now() >= deadline:
                raise Timeout(f'{what} of fault {self.id} has not come within {timeout:g} s; it is {describe(row)}')
            self._holder.clock.await_change(lambda: None, _LOOK_AGAIN)


def describe(row: Mapping[str, Any]) -> str:
    """A row in a line: kind, arguments, and what has become of it."""
    words = [f'{key}={value}' for key, value in row['fault'].items() if key != 'kind']
    return f'{" ".join([row["fault"]["kind"], *words])}: {row["state"]}, {row["hits"]} hits, {row["opportunities"]} opportunities'
