"""Pages for a browser of what units have done, which tests that fail leave (`--axisd-html`)."""

from __future__ import annotations

import glob
import os
import re
import subprocess
import time
from typing import TYPE_CHECKING, Any

from .errors import Error
from .programs import find

if TYPE_CHECKING:
    from .unit import Unit

_SIGNALS = 'speed', 'speed_setpoint', 'torque', 'current'  # of each axis
_MOST_SIGNALS = 16  # of a recording
_MOST_MB = 20  # of a recording: several of them fit into a page
_LONGEST = 60.0  # s, for a page
_LOOK_AGAIN = 0.005  # s

folder: str | None = None  #: where they are put; without one, nothing is recorded and there are none
_test = ''
_early: list[str] = []  # pages of units that an exception has closed, while the test may yet pass


def begin(test: str) -> None:
    """The test that goes on from here."""
    global _test  # pylint: disable=global-statement
    _test = test
    _early.clear()


def add_recording(configuration: dict[str, Any]) -> None:
    """Has a unit recorded from its start on, if there are to be pages and it is not recorded anyway."""
    if folder is None:
        return
    signals = [f'{axis}/{signal}' for axis in range(1, len(configuration['axes']) + 1) for signal in _SIGNALS]
    configuration.setdefault('record', {'name': 'run', 'max_MB': _MOST_MB, 'signals': signals[:_MOST_SIGNALS]})


def write(unit: Unit, early: bool = False) -> str:
    """Writes the page of a unit; a line that says where it is, or why there is none. early: the test may yet pass."""
    if folder is None:
        return ''
    _end_recording(unit)
    recordings = sorted(glob.glob(os.path.join(unit.folder, 'state', '*', 'recordings', '*.axrec')), key=os.path.getmtime)
    name = re.sub(r'[^\w.-]+', '-', _test or 'units').strip('-.')
    path = os.path.join(folder, f'{name}-{unit.node_id}.html')
    try:
        os.makedirs(folder, exist_ok=True)
        done = subprocess.run([find('axisctl'), '--socket', unit.control_path, 'record', '--html', path, '--title', _test or 'axisd',
                               '--from', *recordings], capture_output=True, text=True, check=False, timeout=_LONGEST)
    except (Error, OSError, subprocess.SubprocessError) as error:
        return f'no page: {error}'
    if done.returncode:
        return f'no page: {done.stderr.strip()}'
    if early:
        _early.append(path)
    return f'page: {path}'


def remove_early() -> None:
    """Removes the pages of units that were closed by an exception: the test has passed."""
    for path in _early:
        os.unlink(path)
    _early.clear()


def _end_recording(unit: Unit) -> None:
    """Until it is written; a unit that does not answer has what it has."""
    try:
        unit.call('record.stop')
        deadline = time.monotonic() + unit.timeout
        while unit.call('record.status')['state'] == 'stopping' and time.monotonic() < deadline:
            time.sleep(_LOOK_AGAIN)
    except Error:
        pass
