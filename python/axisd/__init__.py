"""A simulated drive unit for tests: `with axisd.Unit() as unit: ...`

Unit starts a daemon on a bus of its own, without privileges; Bus is a member of such a bus. The pytest plug-in
(axisd.pytest_plugin) has both as fixtures, and python-can finds the bus as interface `userbus` (axisd.can_plugin).
"""

from .bus import Bus
from .errors import Abort, Ended, Error, Missing, Refused, Timeout
from .fault import Fault
from .frame import Frame
from .sdo import SdoClient
from .trace import Trace
from .unit import Unit

__all__ = ['Abort', 'Bus', 'Ended', 'Error', 'Fault', 'Frame', 'Missing', 'Refused', 'SdoClient', 'Timeout', 'Trace', 'Unit']
