"""Units as resources of labgrid: switched off and on as its power drivers do, and asked by axisctl.

`imports: [axisd.labgrid_plugin]` in the environment of labgrid has it; needs labgrid, which nothing else of this package does.
"""

from __future__ import annotations

import json
import subprocess
import time
from typing import Any

import attr
from labgrid.driver.common import Driver
from labgrid.driver.exception import ExecutionError
from labgrid.factory import target_factory
from labgrid.protocol import PowerProtocol
from labgrid.resource.common import Resource
from labgrid.step import step

from .programs import find

_LONGEST_CALL = 60.0  # s, of axisctl


def _texts(_: Any, attribute: attr.Attribute, value: Any) -> None:
    if not isinstance(value, list) or not all(isinstance(each, str) for each in value):
        raise TypeError(f'{attribute.name}: a list of texts was expected, got {value!r}')


@target_factory.reg_resource
@attr.s(eq=False)
class AxisdUnit(Resource):
    """A unit of a daemon of this machine, or of a farm.

    unit: its name, BUS/NODE; farm: URL of the farm, empty: this machine; options: further ones of axisctl, such as
    ['--tls-ca', 'ca.crt', '--credentials', 'user'].
    """

    unit = attr.ib(validator=attr.validators.instance_of(str))
    farm = attr.ib(default='', validator=attr.validators.instance_of(str))
    options = attr.ib(factory=list, validator=_texts)


@target_factory.reg_driver
@attr.s(eq=False)
class AxisdUnitDriver(Driver, PowerProtocol):
    """Power of a unit, and what axisctl says of it.

    delay: how long cycle() leaves it off (s). All methods raise ExecutionError with the message of axisctl where it fails.
    """

    bindings = {'unit': AxisdUnit}
    delay = attr.ib(default=1.0, validator=attr.validators.instance_of(float))

    @Driver.check_active
    @step()
    def on(self) -> None:
        """Switches the unit on: it boots."""
        self._axisctl('power', 'on')

    @Driver.check_active
    @step()
    def off(self) -> None:
        """Switches the unit off: what was not saved is lost, as on the real one."""
        self._axisctl('power', 'off')

    @Driver.check_active
    @step()
    def cycle(self) -> None:
        """Switches the unit off and, after the delay, on."""
        self.off()
        time.sleep(self.delay)
        self.on()

    @Driver.check_active
    @step(result=True)
    def get(self) -> bool:
        """Whether the unit is on."""
        for unit in json.loads(self._axisctl('--json', 'units', unit=False))['units']:
            if unit['unit'] == self.unit.unit:
                return bool(unit['on'])
        raise ExecutionError(f'{self.unit.unit}: there is no such unit')

    @Driver.check_active
    @step(args=['words'], result=True)
    def call(self, *words: str) -> Any:
        """The result of a command of axisctl on the unit: call('get', '1/p1120')."""
        return json.loads(self._axisctl('--json', *words))

    def _axisctl(self, *words: str, unit: bool = True) -> str:
        command = [find('axisctl'), *(['--farm', self.unit.farm] if self.unit.farm else []), *self.unit.options,
                   *(['--unit', self.unit.unit] if unit else []), *words]
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=_LONGEST_CALL, check=False)
        except subprocess.TimeoutExpired:
            raise ExecutionError(f'axisctl {" ".join(words)}: no answer within {_LONGEST_CALL:g} s') from None
        if done.returncode != 0:
            raise ExecutionError(f'axisctl {" ".join(words)}: {done.stderr.strip()}')
        return done.stdout
