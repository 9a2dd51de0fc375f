"""A simulated drive unit: a daemon of its own, on a bus of its own or on one that is given."""

from __future__ import annotations

import json
import os
import re
import shutil
from typing import Any, Callable, Iterable, Mapping, Sequence

from . import conditions, pages, report
from .bus import Bus, Data, to_bytes
from .bus_clock import Clock
from .control import Control, Event, Events
from .errors import Ended, Error, Refused, Timeout
from .fault import Fault, to_fault
from .frame import Frame
from .programs import Program, Session, find
from .sdo import SdoClient
from .trace import Trace

__tracebackhide__ = True  # a failed test shows its own lines

_NMT_COMMANDS = {'start': 1, 'stop': 2, 'pre-operational': 128, 'reset-node': 129, 'reset-communication': 130}
_STATES = {
    'nmt': ('Initialising', 'Pre-operational', 'Operational', 'Stopped'),
    'drive-state': ('Not ready to switch on', 'Switch on disabled', 'Ready to switch on', 'Switched on', 'Operation enabled',
                    'OFF1 braking', 'Quick stop active', 'Fault reaction active', 'STOP2', 'Fault')}
_OBJECTS_OF_AXIS = 0x800  # from those of an axis to those of the next
_CONTROLWORD = 0x6040
_READY = r'^axisd: ready'
_LOOK_AGAIN = 0.005  # s: nothing tells the start of a node that is silent


class Unit:  # pylint: disable=too-many-public-methods
    """A unit that has sent its boot-up, until the end of the block or close().

    axes: how many, or a list of what the configuration says of each. config: further keys of the configuration
    (docs/reference/configuration.md). inject: faults that are loaded at the start, as objects of JSON. seed: of faults with a
    probability that have none. bus: a Bus, the path of one, or another Unit whose bus it is; without it a private one.
    bit_rate, time: of the private bus, as Bus.private() has them. options: further words of the command line of axisd.
    timeout: s of the bus's time that calls and waits take at most unless they are told.

    Error with the one line of axisd if it does not take the configuration; Missing without the programs.
    """

    def __init__(self, axes: int | Sequence[Mapping[str, Any]] = 1, *, config: Mapping[str, Any] | None = None,
                 inject: Iterable[Mapping[str, Any]] = (), seed: int | None = None, node_id: int = 5,
                 bus: Bus | Unit | str | os.PathLike[str] | None = None, bit_rate: int | None = None, time: str | None = None,
                 options: Sequence[str] = (), timeout: float = 10.0) -> None:
        self.node_id = node_id
        self.seed = seed
        self.timeout = timeout
        self._is_open = False
        self._process = os.getpid()
        program = find('axisd')
        configuration = _configuration(axes, config, [to_fault(fault, {}, seed) for fault in inject])
        pages.add_recording(configuration)
        self._owns_bus = not isinstance(bus, (Bus, Unit))
        self.bus = _bus(bus, bit_rate, time, timeout)  #: the bus that it is on
        try:
            self.folder = Session.current().new_folder()
            self.control_path = os.path.join(self.folder, 'control')
            with open(os.path.join(self.folder, 'axisd.json'), 'w', encoding='utf-8') as file:
                json.dump(configuration, file)
            self._program = Program([
                program, '--config', file.name, '--interface', f'unix:{self.bus.path}', '--node-id', str(node_id),
                '--control', self.control_path, '--state-directory', os.path.join(self.folder, 'state'), *options],
                clock=self.clock)
        except BaseException:
            if self._owns_bus:
                self.bus.close()
            raise
        self._is_open = True
        try:
            try:
                self._await_start(may_be_silent='inject' in configuration)
            except Ended as error:
                raise self._start_error(error, file.name) from None
            self._control = Control(self.control_path, timeout, self.ended, self.clock)
            self.event_source = Events(self.control_path, timeout, self.ended, self.clock)
        except BaseException:
            self.close()
            raise
        report.note(self)

    def __enter__(self) -> Unit:
        return self

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        if kind is not None:
            report.keep(self)
            if self._owns_bus:
                report.keep(self.bus)
        self.close()

    def __repr__(self) -> str:
        return f'<axisd.Unit {self.node_id} on {self.bus.path}{"" if self._is_open else ", closed"}>'

    @property
    def clock(self) -> Clock:
        """That of its bus."""
        return self.bus.clock

    @property
    def pid(self) -> int:
        """Process identifier of the daemon."""
        return self._program.pid

    @property
    def log(self) -> list[str]:
        """The last lines of its log."""
        return list(self._program.lines)

    def close(self) -> None:
        """Ends the daemon and, if it is its own, the bus. A second time it does nothing."""
        if not self._is_open or os.getpid() != self._process:
            return
        self._is_open = False
        for connection in ('event_source', '_control'):
            if hasattr(self, connection):
                getattr(self, connection).close()
        try:
            self._program.end()
        finally:
            shutil.rmtree(self.folder, ignore_errors=True)
            if self._owns_bus:
                self.bus.close()

    def ended(self) -> Error:
        """The error that says why the daemon no longer answers."""
        return self._program.ended() if self._is_open else Ended(f'the unit with node-ID {self.node_id} was closed')

    # What it does.

    def call(self, method: str, **params: Any) -> Any:
        """The result of a method of the control socket (docs/reference/control.md); Refused with the message of the unit."""
        if not self._is_open:
            raise self.ended()
        return self._control.call(method, {key.rstrip('_'): value for key, value in params.items()})

    @property
    def status(self) -> dict[str, Any]:
        """The result of `status`."""
        status: dict[str, Any] = self.call('status')
        return status

    def state(self, axis: int | str = 1) -> str:
        """The state of a drive: `Operation enabled`."""
        return str(conditions.place_in(self.status, axis)['state'])

    def explain(self, axis: int = 1) -> list[str]:
        """Why an axis does not turn, the most important reason first."""
        return list(self.call('explain', axis=axis)['reasons'])

    def messages(self, axis: int | str | None = None) -> list[dict[str, Any]]:
        """Active faults and alarms, as `fault.list` has them."""
        return list(self.call('fault.list', **({} if axis is None else {'axis': axis}))['messages'])

    def events(self, kind: str | None = None) -> list[Event]:
        """What has happened since the start, the oldest first, of one kind or of all."""
        return [event for event in self.event_source.since() if kind in (None, event['kind'])]

    def state_names(self, kind: str) -> Sequence[str]:
        """The states that events of this kind tell."""
        return _STATES[kind]

    # Values.

    def read(self, name: str | int, sub_index: int | None = None, *, axis: int | str | None = None) -> Any:
        """A parameter (`p1120`, `1/r0063`, `r0722.3`) or an object (0x6041, `1018:04`), over the control socket."""
        if conditions.is_object(name):
            params = {} if sub_index is None else {'sub_index': sub_index}
            return self.call('object.read', index=_index(name), **params)['value']
        place = {} if axis is None else {'axis': axis}
        return self.call('parameter.read', parameters=[name], **place)['parameters'][0]['value']

    def write(self, name: str | int, value: Any, sub_index: int | None = None, *, axis: int | str | None = None) -> None:
        """Writes a parameter or an object over the control socket; Refused."""
        if conditions.is_object(name):
            params = {} if sub_index is None else {'sub_index': sub_index}
            self.call('object.write', index=_index(name), value=value, **params)
        else:
            self.call('parameter.write', parameter=name, value=value, **({} if axis is None else {'axis': axis}))

    def signal(self, name: str) -> float | None:
        """A signal (docs/reference/trace.md) as it is now: `1/speed`, `1/r0063`."""
        value: float | None = self.call('signal.read', signals=[name])['signals'][0]['value']
        return value

    def trace(self, signals: str | Sequence[str], **keys: Any) -> Trace:
        """Begins a trace with the keys of docs/reference/trace.md: `length_s`, `every`, `trigger`, ..."""
        return Trace(self, [signals] if isinstance(signals, str) else list(signals), keys)

    # The bus.

    def nmt(self, command: str) -> None:
        """Sends an NMT command to it: start, stop, pre-operational, reset-node, reset-communication."""
        if command not in _NMT_COMMANDS:
            raise ValueError(f'command: expected one of {", ".join(_NMT_COMMANDS)}; got "{command}"')
        self.bus.send(Frame(0, bytes([_NMT_COMMANDS[command], self.node_id])))

    def sdo(self, timeout: float | None = None) -> SdoClient:
        """A client of its default SDO server; an answer may take `timeout` s, that of the unit if not given."""
        return SdoClient(self.bus, self.node_id, timeout=self.timeout if timeout is None else timeout)

    def sdo_read(self, index: int, sub_index: int = 0, as_type: type = bytes, *, signed: bool = False,
                 timeout: float | None = None) -> Any:
        """An object over the bus, as bytes, int (little-endian) or str; Abort, Timeout."""
        data = self.sdo(timeout).read(index, sub_index)
        if as_type is int:
            return int.from_bytes(data, 'little', signed=signed)
        return data.decode('latin-1') if as_type is str else data

    def sdo_write(self, index: int, sub_index: int, value: Data | int, size: int | None = None, *,
                  timeout: float | None = None) -> None:
        """Writes an object over the bus: bytes, hexadecimal digits, or an int of `size` bytes; Abort, Timeout."""
        if isinstance(value, int):
            if size is None:
                raise ValueError('size: expected the number of bytes of the object, as the value is a number')
            value = (value & (1 << 8 * size) - 1).to_bytes(size, 'little')
        self.sdo(timeout).write(index, sub_index, to_bytes(value))

    def controlword(self, value: int, axis: int = 1) -> None:
        """Writes the controlword of an axis, where no master does."""
        self.write(_CONTROLWORD + _OBJECTS_OF_AXIS * (axis - 1), value)

    def switch_on(self, axis: int = 1) -> None:
        """Leads an axis to Operation enabled, where no master does."""
        for word, state in ((0x06, 'ready-to-switch-on'), (0x07, 'switched-on'), (0x0F, 'operation-enabled')):
            self.controlword(word, axis)
            self.wait(state=state, axis=axis)

    # Waiting.

    def wait(self, *, state: str | None = None, nmt: str | None = None, message: str | int | None = None,  # pylint: disable=too-many-arguments
             gone: str | int | None = None, value: str | int | None = None, frame: int | None = None,
             event: str | None = None, axis: int | str | None = None, data: Data | None = None, mask: Data | None = None,
             where: Callable[[Any], bool] | None = None, timeout: float | None = None, **comparison: float) -> Any:
        """Waits for one thing; Timeout says what was seen instead.

        state: of a drive (`axis`, 1 if not given), nmt: of the node; those too that are over again when it looks.
        message: a fault or alarm has come (`F07860`), gone: it has gone.
        value: of a signal, parameter or object, with lt, le, eq, ne, ge or gt, or `where`; the value is returned.
        frame: identifier of the next frame on its bus, with `data`, `mask` and `where` as in Bus.wait_for; it is returned.
        event: the first one of this kind since the start, with `where`; it is returned.
        """
        wanted = [name for name, thing in (('state', state), ('nmt', nmt), ('message', message), ('gone', gone),
                                           ('value', value), ('frame', frame), ('event', event)) if thing is not None]
        if len(wanted) != 1:
            raise TypeError('wait: expected one of state, nmt, message, gone, value, frame, event; got ' + (', '.join(wanted) or 'none'))
        wrong = [name for name in comparison if name not in conditions.COMPARISONS or value is None]
        if wrong or len(comparison) > 1:
            raise TypeError(f'wait: expected for a value one of {", ".join(conditions.COMPARISONS)}; got {", ".join(comparison)}')
        limit = self.timeout if timeout is None else timeout
        if state is not None:
            return conditions.wait_for_state(self, 'drive-state', state, 1 if axis is None else axis, limit)
        if nmt is not None:
            return conditions.wait_for_state(self, 'nmt', nmt, 0, limit)
        if message is not None:
            return conditions.wait_for_message(self, message, True, axis, limit)
        if event is not None:
            return conditions.wait_for_event(self, event, where, limit)
        if gone is not None:
            return conditions.wait_for_message(self, gone, False, axis, limit)
        if value is not None:
            pair = next(iter(comparison.items()), None)
            return conditions.wait_for_value(self, value, pair, where, limit)
        return self.bus.wait_for(frame, data, mask=mask, where=where, timeout=limit)

    # Faults that are injected.

    def inject(self, kind: str | Mapping[str, Any], **arguments: Any) -> Fault:
        """Injects a fault (docs/reference/faults.md); a word of Python's own has an underscore behind it (`while_`). Refused."""
        fault = to_fault(kind, arguments, self.seed)
        return Fault(self, self.call('inject.add', **fault)['id'], fault)

    def faults(self) -> list[Fault]:
        """The faults that are loaded, those that are over among them."""
        return [Fault(self, row['id'], row['fault']) for row in self.fault_rows()]

    def fault_rows(self) -> list[dict[str, Any]]:
        """The result of `inject.list`."""
        return list(self.call('inject.list')['faults'])

    def remove_fault(self, number: int) -> None:
        """Takes one back by its number."""
        self.call('inject.remove', id=number)

    def remove_faults(self) -> int:
        """Takes all back; how many there were."""
        return int(self.call('inject.remove')['removed'])

    # Reports.

    def report_title(self) -> str:
        """What it is called in a report."""
        return f'axisd: unit {self.node_id}'

    def report(self) -> str:
        """What it does, in lines."""
        try:
            rows = self.fault_rows()
        except Refused:
            rows = []
        return report.unit_lines(self.status, self.call('explain'), rows, self.log)

    def _await_start(self, may_be_silent: bool) -> None:
        """Returns when it is ready; where faults may keep the boot-up back, when its node has left Initialising."""
        if not may_be_silent:
            self._program.expect(_READY, self.timeout)
            return
        deadline = self.clock.now() + self.timeout
        while self.clock.now() < deadline:
            try:
                self._program.expect(_READY, _LOOK_AGAIN)
                return
            except Timeout:
                pass
            try:
                control = Control(self.control_path, self.timeout, self.ended, self.clock)
            except Error:
                continue
            try:
                if control.call('status', {})['nmt_state'] != 'Initialising':
                    return
            finally:
                control.close()
        self._program.expect(_READY, 0)

    def _start_error(self, error: Ended, path: str) -> Error:
        """Of a configuration that is not taken the line that says so, without the name of the file."""
        lines = [re.sub(r'^axisd: ', '', line).replace(f'{path}: ', 'configuration: ') for line in self.log]
        return Error(lines[-1]) if lines and self._program.process.returncode == 2 else error


def _configuration(axes: int | Sequence[Mapping[str, Any]], config: Mapping[str, Any] | None,
                   faults: list[dict[str, Any]]) -> dict[str, Any]:
    configuration = dict(config or {})
    if isinstance(axes, int):
        if not 1 <= axes <= 8:
            raise ValueError(f'axes: expected 1 to 8, got {axes}')
        configuration.setdefault('axes', [{} for _ in range(axes)])
    else:
        configuration['axes'] = [dict(axis) for axis in axes]
    if faults:
        configuration['inject'] = [*configuration.get('inject', ()), *faults]
    return configuration


def _bus(bus: Bus | Unit | str | os.PathLike[str] | None, bit_rate: int | None, time: str | None, timeout: float) -> Bus:
    if isinstance(bus, Unit):
        return bus.bus
    if isinstance(bus, Bus):
        return bus
    return Bus.private(bit_rate=bit_rate, time=time, timeout=timeout) if bus is None else Bus(bus, timeout=timeout)


def _index(name: str | int) -> str:
    return f'{name:04X}' if isinstance(name, int) else name
