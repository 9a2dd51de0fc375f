"""A bus.yml of lely-core or ros2_canopen, and what dcfgen makes of it: the SDO writes that configure a slave, in their order."""

import sys

from master import Abort

try:
    import yaml
except ImportError as missing:
    sys.exit(f'{missing}: install python3-yaml (scripts/setup.sh)')

INVALID = 0x80000000
RPDO, TPDO = 0x1400, 0x1800
OF_THE_BUS = ('master', 'options', 'defaults')


def slaves_of(path):
    """The slaves of a bus.yml of either form by name, each with its defaults."""
    with open(path, encoding='ascii') as file:
        bus = yaml.safe_load(file)
    nodes = bus.get('nodes') or {name: node for name, node in bus.items() if name not in OF_THE_BUS}
    return {name: {**bus.get('defaults', {}), **node} for name, node in nodes.items()}


def auto_cob_id(communication, number, node):
    assert number <= 4, f'PDO {number} has no COB-ID of its own'
    return (0x180 if communication == TPDO else 0x200) + 0x100 * (number - 1) + node


def mapping_writes(eds, index, mapping):
    room = int(eds.entry(index, 0)['HighLimit'], 0)
    assert len(mapping) <= room, f'{index:04X}h: the unit takes {room} entries, not {len(mapping)}'
    yield index, 0, 0
    bits = 0
    for number, entry in enumerate(mapping, 1):
        mapped = entry['index'], entry['sub_index']
        assert eds.is_mappable(*mapped), f'{mapped[0]:04X}h:{mapped[1]:02X} cannot be mapped'
        bits += eds.bits(*mapped)
        yield index, number, mapped[0] << 16 | mapped[1] << 8 | eds.bits(*mapped)
    assert bits <= 64, f'{index:04X}h: {bits} bits'
    yield index, 0, len(mapping)


def pdo_writes(eds, communication, number, pdo):
    """(index, sub-index, value) of one PDO, as dcfgen orders them."""
    index = communication + number - 1
    cob_id = pdo.get('cob_id', 'auto')
    if cob_id == 'auto':
        cob_id = auto_cob_id(communication, number, eds.node)
    yield index, 1, cob_id | INVALID
    if 'transmission' in pdo and pdo['transmission'] != eds.default(index, 2):
        yield index, 2, pdo['transmission']
    if 'mapping' in pdo:
        yield from mapping_writes(eds, index + 0x200, pdo['mapping'])
    if pdo['enabled']:
        yield index, 1, cob_id


def writes_of(eds, slave):
    if 'heartbeat_producer' in slave:
        yield 0x1017, 0, slave['heartbeat_producer']
    for key, communication in (('rpdo', RPDO), ('tpdo', TPDO)):
        for number, pdo in slave[key].items():
            yield from pdo_writes(eds, communication, number, pdo)
    for entry in slave.get('sdo', []):
        yield entry['index'], entry['sub_index'], entry['value']


def configure(master, eds, slave):
    """Writes it all; the number of writes."""
    count = 0
    for index, sub_index, value in writes_of(eds, slave):
        try:
            master.write(index, sub_index, eds.packed(index, sub_index, value))
        except Abort as abort:
            raise AssertionError(f'{index:04X}h:{sub_index:02X} = {value:X}h: {abort.args[0]:08X}h') from abort
        count += 1
    return count
