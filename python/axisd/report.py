"""What a reader of a failed test wants to see: the last frames, and what the units are up to."""

from __future__ import annotations

import weakref
from typing import TYPE_CHECKING, Any, Sequence

from . import pages
from .fault import describe
from .frame import Frame

if TYPE_CHECKING:
    from .bus import Bus
    from .unit import Unit

_LOG_LINES = 5
_REASONS = 2  # of those why an axis does not turn
_live: weakref.WeakSet[Any] = weakref.WeakSet()
_kept: list[tuple[str, str]] = []
frames_told = 20  #: frames of a bus in a report


def note(thing: Bus | Unit) -> None:
    """Has it in the reports while it is open."""
    _live.add(thing)


def keep(thing: Bus | Unit) -> None:
    """Keeps its report, as it is about to be closed by an exception."""
    _kept.append(section(thing, early=True))


def begin() -> None:
    """Forgets what was kept."""
    _kept.clear()


def sections() -> list[tuple[str, str]]:
    """Title and text, of those that were kept and of all that are open."""
    there = sorted((thing for thing in _live if thing._is_open), key=lambda thing: str(thing.report_title()))  # pylint: disable=protected-access
    found = dict(_kept)
    for thing in there:
        title, text = section(thing)
        found.setdefault(title, text)
    return list(found.items())


def section(thing: Bus | Unit, early: bool = False) -> tuple[str, str]:
    """Title and text of a bus or a unit. early: the test goes on, and may yet pass."""
    try:
        text = thing.report()
    except Exception as error:  # pylint: disable=broad-except
        # The test has failed for another reason, which is to be seen.
        text = f'{type(error).__name__}: {error}'
    page = pages.write(thing, early) if hasattr(thing, 'control_path') else ''
    return thing.report_title(), f'{text}\n{page}' if page else text


def frame_lines(frames: Sequence[Frame], count: int) -> str:
    """A line a frame: seconds since the first one there was, who sent it (> here), identifier, bytes, service."""
    if not frames or not count:
        return 'no frames' if not frames else f'{len(frames)} frames'
    told = frames[-count:]
    first = frames[0].time
    lines = [f'the last {len(told)} of {len(frames)}:'] if len(told) < len(frames) else []
    for frame in told:
        identifier, data = str(frame).split('#')
        bytes_ = data if frame.remote else ' '.join(data[at:at + 2] for at in range(0, len(data), 2))
        lines.append(f'{frame.time - first:10.6f} {">" if frame.own else " "} {identifier:>8}  {bytes_:<23}  {frame.service}'.rstrip())
    return '\n'.join(lines)


def unit_lines(status: dict[str, Any], explanation: dict[str, Any], faults: Sequence[dict[str, Any]], log: Sequence[str]) -> str:
    """What a unit does, why its axes do not turn, which faults are injected, and the end of its log."""
    bus, reasons = status['bus'], {axis['axis']: axis['reasons'] for axis in explanation.get('axes', ())}
    lines = [f'NMT state {status["nmt_state"]}, controller {bus["state"]}, received {bus["received"]}, sent {bus["sent"]}']
    lines += [f'control unit: {text}' for text in _messages(status['control_unit'])]
    for axis in status['axes']:
        lines.append(f'axis {axis["axis"]} {axis["name"]}: {axis["state"]}, controlword {axis["controlword"]}, '
                     f'statusword {axis["statusword"]}, {axis["speed_rpm"]:.0f} rpm')
        lines += [f'  {text}' for text in _messages(axis)]
        lines += [f'  {reason}' for reason in reasons.get(axis['axis'], ())[:_REASONS]]
    lines += fault_lines(faults)
    lines += [f'log: {line}' for line in list(log)[-_LOG_LINES:]]
    return '\n'.join(lines)


def fault_lines(faults: Sequence[dict[str, Any]]) -> list[str]:
    """A line a fault that is injected."""
    return [f'injected {fault["id"]}: {describe(fault)}' for fault in faults]


def _messages(place: dict[str, Any]) -> list[str]:
    return [f'{letter}{message["number"]:05} {message["text"]}'
            for letter, kind in (('F', 'faults'), ('A', 'alarms')) for message in place.get(kind, ())]
