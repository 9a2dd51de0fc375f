"""Traces of a unit (docs/reference/trace.md)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Sequence

from .errors import Timeout

if TYPE_CHECKING:
    from .unit import Unit

__tracebackhide__ = True  # a failed test shows its own lines

_LOOK_AGAIN = 0.02  # s: no event tells the end of a trace


class Trace:
    """A trace that has begun."""

    def __init__(self, unit: Unit, signals: Sequence[str], keys: dict[str, Any]) -> None:
        self.signals = list(signals)
        self._unit = unit
        unit.call('trace.start', signals=self.signals, **keys)

    @property
    def status(self) -> dict[str, Any]:
        """The result of `trace.status`."""
        status: dict[str, Any] = self._unit.call('trace.status')
        return status

    def wait(self, timeout: float | None = None) -> Trace:
        """Returns when it is done; Timeout."""
        limit = self._unit.timeout if timeout is None else timeout
        deadline = self._unit.clock.now() + limit
        while (status := self.status)['phase'] != 'done':
            if self._unit.clock.now() >= deadline:
                raise Timeout(f'the trace is not done within {limit:g} s; it is {status["phase"]}, trigger {status["trigger"]}, '
                              f'{status["recorded"]} samples')
            self._unit.clock.await_change(lambda: None, _LOOK_AGAIN)
        return self

    def stop(self) -> Trace:
        """Ends it; what there is can be read."""
        self._unit.call('trace.stop')
        return self

    def read(self, part: str = 'samples') -> list[Any]:
        """All items of `samples` (instant and a value a signal), `frames` or `events` of the last result."""
        items: list[Any] = []
        while True:
            page = self._unit.call('trace.read', part=part, from_=len(items))
            items += page['items']
            if 'next' not in page:
                return items

    def column(self, signal: str) -> list[float]:
        """The values of one signal."""
        at = 1 + self.signals.index(signal)
        return [sample[at] for sample in self.read()]
