"""Units of a farm as resources of labgrid: booked, switched on and off and asked as real drives beside them are.

An environment of labgrid has `imports: [axisd.labgrid]`; docs/how-to/fleets.md shows one.
"""
import json
import subprocess

import attr
from labgrid.driver import Driver
from labgrid.driver.exception import ExecutionError
from labgrid.factory import target_factory
from labgrid.protocol import PowerProtocol
from labgrid.resource import Resource
from labgrid.step import step

_KINDS_OF_TEXT = attr.validators.instance_of(str)


@target_factory.reg_resource
@attr.s(eq=False)
class AxisdUnit(Resource):
    """A simulated drive unit.

    unit: its name, "line1/5"
    farm: URL of its farm, "nats://HOST/FARM"; empty: it runs on this machine
    options: further options of axisctl, such as ["--tls-ca", "ca.crt"]
    """

    unit = attr.ib(validator=_KINDS_OF_TEXT)
    farm = attr.ib(default="", validator=_KINDS_OF_TEXT)
    options = attr.ib(factory=list, validator=attr.validators.instance_of(list))


@target_factory.reg_driver
@attr.s(eq=False)
class AxisdUnitDriver(Driver, PowerProtocol):
    """Switches an AxisdUnit on and off, and asks it what axisctl asks.

    program: axisctl
    """

    bindings = {"resource": AxisdUnit}
    program = attr.ib(default="axisctl", validator=_KINDS_OF_TEXT)

    def _words(self):
        farm = ["--farm", self.resource.farm] if self.resource.farm else []
        return [self.program, *farm, *self.resource.options, "--unit", self.resource.unit, "--json"]

    @Driver.check_active
    @step(args=["words"], result=True)
    def axisctl(self, *words):
        """The result of a subcommand of axisctl as an object; ExecutionError with its message if it fails."""
        done = subprocess.run([*self._words(), *words], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise ExecutionError(done.stderr.strip(), stdout=done.stdout.splitlines(), stderr=done.stderr.splitlines())
        return json.loads(done.stdout) if done.stdout.strip() else None

    @Driver.check_active
    @step()
    def on(self):
        self.axisctl("power", "on")

    @Driver.check_active
    @step()
    def off(self):
        self.axisctl("power", "off")

    @Driver.check_active
    @step()
    def cycle(self):
        self.off()
        self.on()

    @Driver.check_active
    def get(self):
        """Whether it is switched on."""
        try:
            self.axisctl("status")
        except ExecutionError as error:
            if '"off"' in "".join(error.stdout or []):
                return False
            raise
        return True
