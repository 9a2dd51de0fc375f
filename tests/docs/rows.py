"""The rows of blocks.txt: how each block of the documentation is run, or why not."""

import dataclasses
import os

import pages

KINDS = ('config', 'frames', 'control', 'json', 'python', 'tested', 'shown', 'needs')
REASONS = ('root', 'systemd', 'network', 'package')


@dataclasses.dataclass
class Row:
    """What is to be done with the blocks of a page that begin with START."""
    page: str
    start: str
    kind: str
    detail: str

    def fits(self, block):
        first = block.lines[0]
        return first == self.start[:-1] if self.start.endswith('$') else first.startswith(self.start)


def read(source):
    """The rows, in their order."""
    found = []
    for line in pages.read(os.path.join(source, 'tests/docs/blocks.txt')).split('\n'):
        if line.strip() and not line.startswith('#'):
            parts = [part.strip() for part in line.split(' | ', 3)]
            parts[-1] = parts[-1].removesuffix('|').strip()
            found.append(Row(*(parts + [''])[:4]))
    return found


def blocks(source, kind):
    """Row and lines of each block of KIND, page by page."""
    for row in read(source):
        if row.kind == kind:
            for block in pages.blocks_of(pages.read(os.path.join(source, row.page)))[0]:
                if row.fits(block):
                    yield row, block
