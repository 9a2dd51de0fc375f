"""Fixtures of pytest: `drive_unit` (and `drive`, the same), `can_bus`; frames and units in the report of a test that fails.

`@pytest.mark.axisd(axes=2, inject=[...])` has the keys of axisd.Unit. Every test has a bus and a daemon of its own, so that
tests run side by side (`-n auto`).
"""

from __future__ import annotations

import inspect
import os
from typing import Any, Iterator

import pytest

from . import pages, report
from .bus import Bus
from .errors import Error
from .unit import Unit

__tracebackhide__ = True  # a failed test shows its own lines

_KEYS = [key for key in inspect.signature(Unit).parameters if key != 'bus']
_OF_THE_BUS = ('bit_rate', 'time')


def pytest_addoption(parser: pytest.Parser) -> None:
    """--axisd-frames, --axisd-html."""
    group = parser.getgroup('axisd', 'simulated drive units')
    group.addoption(
        '--axisd-frames', type=_count, default=report.frames_told, metavar='N',
        help='frames of each bus in the report of a test that fails (%(default)s)')
    group.addoption('--axisd-html', metavar='FOLDER',
                    help='record the units, and write a page for a browser to FOLDER for each one of a test that fails')


def pytest_configure(config: pytest.Config) -> None:
    """The marker, the number of frames, and the folder of pages."""
    config.addinivalue_line('markers', f'axisd({", ".join(_KEYS)}): the drive unit of the test, by keys of axisd.Unit')
    report.frames_told = config.getoption('--axisd-frames')
    folder = config.getoption('--axisd-html')
    pages.folder = os.path.abspath(folder) if folder else None


def _count(text: str) -> int:
    if not text.isdecimal():
        raise ValueError
    return int(text)


def _keys(request: pytest.FixtureRequest) -> dict[str, Any]:
    """The keys of all markers; that of the test counts before those of its class and module."""
    keys: dict[str, Any] = {}
    for marker in reversed(list(request.node.iter_markers('axisd'))):
        wrong = [repr(word) for word in marker.args] + [key for key in marker.kwargs if key not in _KEYS]
        if wrong:
            pytest.fail(f'pytest.mark.axisd: expected keys, some of {", ".join(_KEYS)}; got {wrong[0]}', pytrace=False)
        keys.update(marker.kwargs)
    return keys


def _start(bus: Bus, keys: dict[str, Any]) -> tuple[Unit | None, str]:
    """The unit, or why there is none."""
    try:
        return Unit(bus=bus, **keys), ''
    except (Error, ValueError) as error:
        return None, str(error)


@pytest.fixture
def can_bus(request: pytest.FixtureRequest) -> Iterator[Bus]:
    """A private bus, that of `drive_unit` where the test has one."""
    keys = _keys(request)
    with Bus.private(**{key: keys[key] for key in _OF_THE_BUS if key in keys}) as bus:
        yield bus


@pytest.fixture
def drive_unit(request: pytest.FixtureRequest, can_bus: Bus) -> Iterator[Unit]:  # pylint: disable=redefined-outer-name
    """A unit that has sent its boot-up, with one axis unless the marker `axisd` says otherwise."""
    keys = {key: value for key, value in _keys(request).items() if key not in _OF_THE_BUS}
    unit, why = _start(can_bus, keys)
    if unit is None:
        pytest.fail(f'the drive unit has not started: {why}', pytrace=False)
    with unit:
        yield unit


@pytest.fixture
def drive(drive_unit: Unit) -> Unit:  # pylint: disable=redefined-outer-name
    """The same as drive_unit."""
    return drive_unit


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item: pytest.Item) -> None:
    """What an earlier test has left is none of this one's."""
    report.begin()
    pages.begin(item.nodeid)


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport() -> Iterator[None]:
    """Adds the sections to the report of what has failed, while units and buses are still there."""
    outcome = yield
    result = outcome.get_result()  # type: ignore[attr-defined]
    if result.failed and result.when != 'teardown':
        result.sections.extend(report.sections())
    elif result.passed and result.when == 'call':
        pages.remove_early()
