"""What Unit.wait waits for."""

from __future__ import annotations

import operator
import re
from typing import TYPE_CHECKING, Any, Callable

from .control import Control, Event
from .errors import Refused, Timeout

if TYPE_CHECKING:
    from .unit import Unit

__tracebackhide__ = True  # a failed test shows its own lines

COMPARISONS: dict[str, Callable[[float, float], bool]] = {
    'lt': operator.lt, 'le': operator.le, 'eq': operator.eq, 'ne': operator.ne, 'ge': operator.ge, 'gt': operator.gt}
#: Kinds of events, as in docs/reference/control.md.
EVENTS = ('power', 'boot-up', 'nmt', 'link', 'bus', 'drive-state', 'fault', 'alarm', 'emcy', 'parameter', 'object', 'refusal', 'store',
          'restore', 'control')
_TOLD_EVENTS = 5
_SAMPLE_MS = 5  # between two looks at a value
_OBJECT = re.compile(r'(0x)?[0-9A-Fa-f]{4}h?(:[0-9A-Fa-f]{1,2}h?)?')


def essence(text: str) -> str:
    """Letters and digits alone: "operation-enabled" is "Operation enabled"."""
    return ''.join(filter(str.isalnum, text)).lower()


def place_in(status: dict[str, Any], axis: int | str) -> dict[str, Any]:
    """The part of a status that `axis` means, a number from 1 on or `infeed`; ValueError."""
    places: list[dict[str, Any]] = [*status['axes'], *([{**status['infeed'], 'axis': 'infeed'}] if 'infeed' in status else [])]
    for place in places:
        if place['axis'] == axis:
            return place
    raise ValueError(f'axis: the unit has no axis {axis}')


def wait_for_state(unit: Unit, kind: str, wanted: str, axis: int | str, timeout: float) -> None:
    """An NMT state (`kind` nmt) or the state of a drive (drive-state), also one that is over again."""
    def now() -> str:
        status = unit.status
        return str(status['nmt_state'] if kind == 'nmt' else place_in(status, axis)['state'])
    what = f'NMT state {wanted}' if kind == 'nmt' else f'state {wanted} of axis {axis}'
    names = unit.state_names(kind)
    if essence(wanted) not in map(essence, names):
        raise ValueError(f'state: expected one of {", ".join(names)}; got "{wanted}"')

    def is_it(event: Event) -> bool:
        return event['kind'] == kind and (kind == 'nmt' or event.get('axis') == axis) and essence(event['state']) == essence(wanted)
    _wait(unit, what, lambda: essence(now()) == essence(wanted), is_it, now, timeout, None if kind == 'nmt' else axis)


def wait_for_message(unit: Unit, wanted: str | int, is_active: bool, axis: int | str | None, timeout: float) -> None:
    """A fault or alarm (`F07860`, `A07991`, or the number of either) that is there, or is gone."""
    match = re.fullmatch(r'([FA]?)0*(\d+)', str(wanted).upper())
    if not match:
        raise ValueError(f'message: expected a number such as F07860, A07991 or 7860, got "{wanted}"')
    letter, number = match[1], int(match[2])

    def codes() -> list[str]:
        params = {} if axis is None else {'axis': axis}
        return [message['code'] for message in unit.call('fault.list', **params)['messages']
                if letter in ('', message['code'][0]) and int(message['code'][1:]) == number]

    def is_it(event: Event) -> bool:
        return (event['kind'] in ('fault', 'alarm') and event['number'] == number and letter in ('', event['name'][0])
                and event['active'] == is_active and axis in (None, event.get('axis')))

    def seen() -> str:
        return ', '.join(message['code'] for message in unit.call('fault.list')['messages']) or 'no message'
    name = f'{letter or "message "}{number:05}' if letter else f'message {number}'
    what = name if is_active else f'the end of {name}'
    # Something may still be there when one event of its end has come: of another axis.
    _wait(unit, what, lambda: bool(codes()) == is_active, is_it if is_active else lambda event: is_it(event) and not codes(),
          seen, timeout)


def wait_for_value(unit: Unit, name: str | int, comparison: tuple[str, float] | None, where: Callable[[Any], bool] | None,
                   timeout: float) -> Any:
    """A signal, parameter or object that compares with a number; its value then."""
    if comparison is not None:
        compare, right = COMPARISONS[comparison[0]], comparison[1]
        what = f'{name_of(name)} {comparison[0]} {right:g}'
    elif where is not None:
        what = f'{name_of(name)} as a function asks for it'
    else:
        raise ValueError(f'value: expected a comparison, one of {", ".join(COMPARISONS)}, or where')

    def holds(value: Any) -> bool:
        return where(value) if where is not None else value is not None and compare(value, right)
    look = _look_at_object if is_object(name) else _look_at_signal
    return look(unit, name, holds, what, timeout)


def wait_for_event(unit: Unit, kind: str, where: Callable[[Event], bool] | None, timeout: float) -> Event:
    """An event of this kind for which `where` holds, the first one since the start of the unit."""
    if kind not in EVENTS:
        raise ValueError(f'event: expected one of {", ".join(EVENTS)}; got "{kind}"')
    place = 0

    def look() -> Event | Unit | None:
        nonlocal place
        for event in unit.event_source.since(place):
            place += 1
            if event['kind'] == kind and (where is None or where(event)):
                return event
        return unit if unit.event_source.has_ended else None
    found = unit.clock.await_change(look, timeout)
    if isinstance(found, dict):
        return found
    if found is not None:
        raise unit.ended()
    seen = unit.events(kind)[-_TOLD_EVENTS:]
    raise Timeout(f'an event {kind}{" that is asked for by a function" if where else ""} has not come within {timeout:g} s; '
                  + (f'seen last: {seen}' if seen else 'there was none'))


def is_object(name: str | int) -> bool:
    """An index, with or without a sub-index, and no signal."""
    return isinstance(name, int) or bool(_OBJECT.fullmatch(name))


def name_of(name: str | int) -> str:
    """As a person writes it."""
    return f'{name:04X}h' if isinstance(name, int) else name


def _look_at_object(unit: Unit, name: str | int, holds: Callable[[Any], bool], what: str, timeout: float) -> Any:
    deadline = unit.clock.now() + timeout
    while True:
        value = unit.read(name)
        if holds(value):
            return value
        if unit.clock.now() >= deadline:
            raise Timeout(f'{what} has not come within {timeout:g} s; it was {value} last{reason(unit)}')
        unit.clock.await_change(lambda: None, _SAMPLE_MS / 1000)


def _look_at_signal(unit: Unit, name: str | int, holds: Callable[[Any], bool], what: str, timeout: float) -> Any:
    deadline = unit.clock.now() + timeout
    value = unit.signal(str(name))
    if holds(value):
        return value
    samples = Control(unit.control_path, unit.timeout, unit.ended, unit.clock)
    try:
        samples.call('samples.subscribe', {'signals': [str(name)], 'period_ms': _SAMPLE_MS})
        while True:
            line = samples.line(deadline)
            if line is None:
                raise Timeout(f'{what} has not come within {timeout:g} s; it was {value} last{reason(unit)}')
            if 'sample' in line:
                value = line['sample']['values'][0]
                if holds(value):
                    return value
    finally:
        samples.close()


def _wait(unit: Unit, what: str, holds: Callable[[], bool], is_it: Callable[[Event], bool], seen: Callable[[], str],
          timeout: float, axis: int | str | None = None) -> None:
    """Returns when `holds`, or when an event from now on is the one. Between events nothing is asked."""
    events = unit.event_source
    place = events.count
    if holds():
        return

    def look() -> bool | None:
        nonlocal place
        new = events.since(place)
        place += len(new)
        # Outside of the lock nothing may be asked, so that is_it of an end comes again behind this.
        if new or events.has_ended:
            pending.extend(new)
            return True
        return None

    deadline = unit.clock.now() + timeout
    pending: list[Event] = []
    while True:
        if unit.clock.await_change(look, deadline - unit.clock.now()) is None:
            raise Timeout(f'{what} has not come within {timeout:g} s; seen last: {seen()}{reason(unit, axis)}')
        if any(is_it(event) for event in pending):
            return
        pending.clear()
        if events.has_ended:
            raise unit.ended()


def reason(unit: Unit, axis: int | str | None = None) -> str:
    """What the unit says of an axis, or of all, that do not turn, behind a semicolon."""
    try:
        axes = unit.call('explain')['axes']
    except Refused:
        return ''
    return ''.join(f'; axis {entry["axis"]}: {entry["reasons"][0]}' for entry in axes
                   if entry['reasons'] and axis in (None, entry['axis']))
