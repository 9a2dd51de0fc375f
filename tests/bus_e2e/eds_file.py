"""What a master takes from an EDS."""

import configparser
import struct

FORMATS = {2: '<b', 3: '<h', 4: '<i', 5: '<B', 6: '<H', 7: '<I'}  # by CiA 301 data type


class Eds:
    """The entries of an EDS, as they are on a node."""

    def __init__(self, path, node):
        self.node = node
        self.sections = configparser.RawConfigParser(strict=True)
        self.sections.optionxform = str
        with open(path, encoding='ascii') as file:
            self.sections.read_file(file)

    def entry(self, index, sub_index=0):
        name = f'{index:04X}sub{sub_index:X}'
        return self.sections[name if name in self.sections else f'{index:04X}']

    def default(self, index, sub_index=0):
        text = self.entry(index, sub_index)['DefaultValue']
        if not text.startswith('$NODEID+'):
            return int(text, 0)
        return self.node + int(text.removeprefix('$NODEID+'), 0)

    def packed(self, index, sub_index, value):
        return struct.pack(FORMATS[int(self.entry(index, sub_index)['DataType'], 0)], value)

    def bits(self, index, sub_index):
        return 8 * len(self.packed(index, sub_index, 0))

    def is_mappable(self, index, sub_index):
        return self.entry(index, sub_index).get('PDOMapping') == '1'
