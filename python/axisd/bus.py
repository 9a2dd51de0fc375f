"""A member of a user-space CAN bus."""

from __future__ import annotations

import collections
import json
import os
import shutil
import socket
from typing import Any, Callable, Iterator, Mapping, Sequence

from . import bus_clock, hub_protocol, report
from .background import background, changed
from .errors import Ended, Error, Refused, Timeout
from .fault import Fault, to_fault
from .frame import Frame
from .programs import Program, Session, find

__tracebackhide__ = True  # a failed test shows its own lines

#: What `data` of a frame is given as: bytes, or their hexadecimal digits with blanks between them.
Data = bytes | bytearray | str
_KEPT_FRAMES = 100_000
_TOLD_FRAMES = 20  # in an error
_START_PATIENCE = 10.0  # s


def to_bytes(data: Data) -> bytes:
    """The bytes that `data` means; ValueError."""
    if isinstance(data, str):
        try:
            return bytes.fromhex(data)
        except ValueError:
            raise ValueError(f'data: expected hexadecimal digits, two a byte, got "{data}"') from None
    return bytes(data)


def join_or_start(path: str, interface: str) -> tuple[socket.socket, int]:
    """A member of the bus at `path`, whose hub is started if there is none, and the bit rate; OSError, Error."""
    try:
        return hub_protocol.join(path, interface)
    except (FileNotFoundError, ConnectionRefusedError):
        folder = os.path.dirname(path)
        if folder == f'/tmp/can-bus-{os.geteuid()}':
            os.makedirs(folder, 0o700, exist_ok=True)
        hub = Program([find('canhub'), '--on-demand', '--path', path])
        if hub.process.wait(_START_PATIENCE) != 0:
            raise hub.ended() from None
        hub.end()
        return hub_protocol.join(path, interface)


class Bus:
    """A member of the bus at `path`, and all frames that pass there from now on.

    Without `path` it is the bus that `with-can` and `axisd --interface unix:` take; `Bus.private()` makes one of its own.
    A hub is started where none serves. Frames are read as they come, by a thread; the last 100000 are kept in `frames`.
    `recv` and `wait_for` hand each frame of other members out once, in their order.
    """

    def __init__(self, path: str | os.PathLike[str] | None = None, *, interface: str = 'vcan0', timeout: float = 10.0) -> None:
        self.path = os.fspath(path) if path is not None else hub_protocol.default_path()
        self.interface = interface
        self.timeout = timeout  #: s that wait_for waits unless it is told
        self.hub: Program | None = None  #: of a private bus
        self._frames: collections.deque[Frame] = collections.deque(maxlen=_KEPT_FRAMES)
        self._count = 0
        self._next = 0
        self._has_ended = False
        self._is_open = True
        self._process = os.getpid()
        try:
            self._member, self.bit_rate = join_or_start(self.path, interface)
            self.clock = bus_clock.join(self.path, self._member)  #: what waits here are measured by
        except OSError as error:
            raise Error(f'{self.path}: the bus cannot be joined: {error.strerror}') from None
        self._member.setblocking(False)
        background().watch(self._member.fileno(), self._read)
        report.note(self)

    @classmethod
    def private(cls, *, bit_rate: int | None = None, time: str | None = None, interface: str = 'vcan0', timeout: float = 10.0,
                hub_options: Sequence[str] = ()) -> Bus:
        """A bus of its own in a new folder, which goes with it.

        bit_rate: in bit/s, 0: frames take no time, which is so in real time if it is not given. time: whose it has, as `canhub
        --time` takes it: `real`, `scaled=K`, `virtual` or `stepped`.
        """
        path = os.path.join(Session.current().new_folder(), 'bus')
        if bit_rate is None and time in (None, 'real'):
            bit_rate = 0
        hub = Program([find('canhub'), '--path', path, *(() if bit_rate is None else ('--bitrate', str(bit_rate))),
                       *(() if time is None else ('--time', time)), *hub_options])
        try:
            hub.expect(r'^canhub: ready', _START_PATIENCE)
            bus = cls(path, interface=interface, timeout=timeout)
        except BaseException:
            hub.end()
            raise
        bus.hub = hub
        return bus

    def __enter__(self) -> Bus:
        return self

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        if kind is not None:
            report.keep(self)
        self.close()

    def __repr__(self) -> str:
        return f'<axisd.Bus {self.path}, {self._count} frames>'

    def close(self) -> None:
        """Leaves the bus, and ends that of private()."""
        if not self._is_open or os.getpid() != self._process:
            return
        self._is_open = False
        background().unwatch(self._member.fileno())
        self.clock.close()
        self._member.close()
        if self.hub:
            self.hub.end()
            shutil.rmtree(os.path.dirname(self.path), ignore_errors=True)

    # Time.

    @property
    def now(self) -> float:
        """s on the clock of the bus, from its beginning; in real time on CLOCK_MONOTONIC of the machine."""
        return self.clock.now()

    def step(self, seconds: float) -> float:
        """Lets stepped time go on, and reads what has come; the present then. Refused where time is not stepped."""
        self.clock.step(seconds)
        return self.now

    def pass_time(self, seconds: float) -> float:
        """Lets so much time of the bus pass, whosever it is; the present then."""
        self.clock.pass_time(seconds)
        return self.now

    # Frames.

    @property
    def frames(self) -> list[Frame]:
        """The frames so far, the oldest first, those sent here among them."""
        with changed:
            return list(self._frames)

    @property
    def count(self) -> int:
        """How many there have been; the first one has the place 0."""
        with changed:
            return self._count

    @property
    def dropped(self) -> int:
        """Frames that the hub has not kept for this member because they were not read in time."""
        with changed:
            return self._frames[-1].dropped if self._frames else 0

    def since(self, place: int) -> list[Frame]:
        """The frames from a `count` on."""
        with changed:
            return list(self._from(place))

    def send(self, frame: Frame | int | str, data: Data = b'', *, extended: bool | None = None, remote: bool = False) -> None:
        """Sends a frame: a Frame, an identifier with `data`, or a text as cansend takes it: `send("205#0F00")`.

        extended: by the size of the identifier if not given. Timeout while the bus has no room; Ended without a hub.
        """
        if isinstance(frame, str):
            frame = Frame.parse(frame)
        elif isinstance(frame, int):
            frame = Frame(frame, to_bytes(data), extended=frame > 0x7FF if extended is None else extended, remote=remote)
        message = hub_protocol.encode(frame)
        deadline = self.now + self.timeout
        while True:
            try:
                self._member.send(message)
                return
            except BlockingIOError:
                if not self.clock.await_room(self._member, max(0.0, deadline - self.now)):
                    raise Timeout(f'{frame} was not taken within {self.timeout:g} s: the bus is full') from None
            except OSError as error:
                raise self._ended(error.strerror) from None

    def recv(self, timeout: float | None = None) -> Frame | None:
        """The next frame of another member; None after `timeout` s (that of the bus if not given)."""
        return self._take(lambda frame: True, self.timeout if timeout is None else timeout)

    def wait_for(self, id: int | None = None, data: Data | None = None, *,  # pylint: disable=redefined-builtin
                 mask: Data | None = None, where: Callable[[Frame], bool] | None = None,
                 timeout: float | None = None) -> Frame:
        """The next frame of another member with this identifier, whose bytes begin with `data` where `mask` has ones, and
        for which `where` holds; those before it are passed over. Timeout with what came instead.
        """
        accepts = matcher(id, data, mask, where)
        limit = self.timeout if timeout is None else timeout
        place = self._next
        frame = self._take(accepts, limit)
        if frame is not None:
            return frame
        wanted = describe(id, data, mask, where)
        raise Timeout(f'{wanted} has not come within {limit:g} s; ' + told(self.since(place)))

    def skip(self) -> None:
        """Passes over all that has come so far: recv and wait_for begin behind it."""
        with changed:
            self._next = self._count

    def candump(self, last: int | None = None) -> str:
        """The frames so far, or the last ones of them, as `candump -L` writes them."""
        frames = self.frames
        first = len(frames) - last if last is not None else 0
        return '\n'.join(frame.candump(self.interface) for frame in frames[max(first, 0):])

    def reader(self) -> Reader:
        """Looks at the frames from now on, apart from recv and wait_for."""
        return Reader(self, self.count)

    # Faults of the bus.

    def call(self, method: str, params: Mapping[str, Any]) -> dict[str, Any]:
        """The result of `inject.add`, `inject.list`, `inject.remove` or `inject.kinds` of the hub; Refused with its message."""
        text = json.dumps({'method': method, 'params': params}).encode()
        try:
            error, _, answer = hub_protocol.request(self._member, hub_protocol.INJECT, payload=text)
        except OSError as gone:
            raise self._ended(gone.strerror or str(gone)) from None
        if error:
            told = json.loads(answer)['message'] if answer else 'the hub has no faults; it is of another version'
            raise Refused(f'{method}: {told}', 'bad-parameter')
        result: dict[str, Any] = json.loads(answer)
        return result

    def inject(self, kind: str | Mapping[str, Any], **arguments: Any) -> Fault:
        """Injects a fault of the bus (docs/reference/bus-faults.md): `inject("bus.drop", id=0x185, times=1)`; Refused."""
        fault = to_fault(kind, arguments)
        return Fault(self, self.call('inject.add', {'fault': fault})['id'], fault)

    def faults(self) -> list[Fault]:
        """The faults of the bus, those that are over among them."""
        return [Fault(self, row['id'], row['fault']) for row in self.fault_rows()]

    def fault_rows(self) -> list[dict[str, Any]]:
        """The rows of `inject.list`."""
        rows: list[dict[str, Any]] = []
        while True:
            page = self.call('inject.list', {'behind': len(rows)})
            rows += page['faults']
            if not page['faults'] or len(rows) >= page['rows']:
                return rows

    def remove_fault(self, number: int) -> None:
        """Takes one back by its number."""
        self.call('inject.remove', {'id': number})

    def remove_faults(self) -> int:
        """Takes all back; how many there were."""
        return int(self.call('inject.remove', {})['removed'])

    def report_title(self) -> str:
        """What it is called in a report."""
        return f'axisd: frames of {self.path}'

    def report(self) -> str:
        """The last frames, a line each, with what they are, and the faults of the bus."""
        try:
            faults = self.fault_rows()
        except Error:
            faults = []
        lost = [f'{self.dropped} frames were lost, as they were not read in time'] if self.dropped else []
        return '\n'.join([report.frame_lines(self.frames, report.frames_told), *lost, *report.fault_lines(faults)])

    def _from(self, place: int) -> Iterator[Frame]:
        """To be called under `changed`."""
        first = self._count - len(self._frames)
        for at in range(max(place - first, 0), len(self._frames)):
            yield self._frames[at]

    def _take(self, accepts: Callable[[Frame], bool], timeout: float) -> Frame | None:
        found, self._next = self._look_for(self._next, accepts, timeout)
        return found

    def _look_for(self, place: int, accepts: Callable[[Frame], bool], timeout: float) -> tuple[Frame | None, int]:
        """The first frame of another member from `place` on that is accepted, None after `timeout` s; and the place behind."""
        def look() -> list[Frame] | None:
            """The frame in a list; an empty one if the hub has gone."""
            nonlocal place
            place = max(place, self._count - len(self._frames))
            for frame in self._from(place):
                place += 1
                if not frame.own and accepts(frame):
                    return [frame]
            place = self._count
            return [] if self._has_ended else None
        found = self.clock.await_change(look, timeout)
        if found == []:
            raise self._ended('the hub has gone')
        return (found[0] if found else None), place

    def _ended(self, why: str) -> Ended:
        if not self._is_open:
            return Ended(f'{self.path}: the bus was closed')
        return self.hub.ended() if self.hub else Ended(f'{self.path}: {why}')

    def _read(self) -> None:
        with changed:
            while True:
                try:
                    message = self._member.recv(hub_protocol.LONGEST_MESSAGE)
                except BlockingIOError:
                    break
                except OSError:
                    message = b''
                if not message:
                    self._has_ended = True
                    background().unwatch(self._member.fileno())
                    break
                frame = hub_protocol.decode(message)
                if frame is not None:
                    self._frames.append(frame)
                    self._count += 1
            changed.notify_all()


class Reader:
    """A second look at the frames of a bus, from a place on."""

    def __init__(self, bus: Bus, place: int) -> None:
        self._bus = bus
        self._place = place

    def wait_for(self, accepts: Callable[[Frame], bool], timeout: float) -> Frame | None:
        """The next frame of another member that is accepted; None after `timeout` s."""
        # pylint: disable-next=protected-access
        found, self._place = self._bus._look_for(self._place, accepts, timeout)
        return found


def matcher(identifier: int | None, data: Data | None, mask: Data | None,
            where: Callable[[Frame], bool] | None) -> Callable[[Frame], bool]:
    """The test that wait_for makes."""
    wanted = to_bytes(data) if data is not None else b''
    ones = to_bytes(mask) if mask is not None else b'\xFF' * len(wanted)
    if len(ones) != len(wanted):
        raise ValueError(f'mask: expected as many bytes as data has, {len(wanted)}, got {len(ones)}')

    def accepts(frame: Frame) -> bool:
        return ((identifier is None or frame.id == identifier) and not (frame.error and identifier is not None)
                and len(frame.data) >= len(wanted)
                and all((got ^ want) & one == 0 for got, want, one in zip(frame.data, wanted, ones))
                and (where is None or where(frame)))
    return accepts


def describe(identifier: int | None, data: Data | None, mask: Data | None, where: object) -> str:
    """What wait_for awaits, in words."""
    text = 'a frame' if identifier is None else f'a frame {identifier:03X}h'
    if data is not None:
        text += f' with {to_bytes(data).hex().upper()}'
    if mask is not None:
        text += f' (mask {to_bytes(mask).hex().upper()})'
    return text + (' that is asked for by a function' if where else '')


def told(frames: Sequence[Frame]) -> str:
    """What has come instead."""
    others = [frame for frame in frames if not frame.own][-_TOLD_FRAMES:]
    return 'seen last: ' + ' '.join(map(str, others)) if others else 'nothing came'
