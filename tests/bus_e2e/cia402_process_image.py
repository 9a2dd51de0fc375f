"""The PDOs of one slave as its bus.yml has them: values of objects that are sent and received."""

import struct

from bus_file import RPDO, TPDO, auto_cob_id
from eds_file import FORMATS


class ProcessImage:
    """Objects by index; an RPDO leaves whenever one of its objects is set, for it is event-driven."""

    def __init__(self, master, slave):
        self.master = master
        self.sent = self._layouts(slave['rpdo'], RPDO)
        self.received = self._layouts(slave['tpdo'], TPDO)
        self.values = {index: 0 for entries in self.sent.values() for index, _ in entries}

    def _layouts(self, pdos, communication):
        """COB-ID -> (index, struct format) of each object."""
        eds = self.master.eds
        layouts = {}
        for number, pdo in pdos.items():
            if not pdo['enabled']:
                continue
            cob_id = pdo.get('cob_id', 'auto')
            cob_id = auto_cob_id(communication, number, eds.node) if cob_id == 'auto' else cob_id
            layouts[cob_id] = [(entry['index'], FORMATS[int(eds.entry(entry['index'], entry['sub_index'])['DataType'], 0)])
                               for entry in pdo['mapping']]
        return layouts

    def is_sent(self, index):
        return index in self.values

    def set(self, index, value):
        self.values[index] = value
        for cob_id, entries in self.sent.items():
            if any(index == mapped for mapped, _ in entries):
                data = b''.join(struct.pack(form, self.values[mapped]) for mapped, form in entries)
                self.master.send(cob_id, data.hex())

    def get(self, index):
        """What the last TPDO said; None before the first one."""
        for cob_id, entries in self.received.items():
            data = self.master.bus.latest.get(cob_id)
            for mapped, form in entries:
                if data is not None and mapped == index:
                    return struct.unpack(form, data[:struct.calcsize(form)])[0]
                data = data and data[struct.calcsize(form):]
        return None
