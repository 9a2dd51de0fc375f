"""The pages of Markdown below a folder: their blocks of code, headings and links."""

import dataclasses
import os
import re

NO_PAGES = {'build', 'node_modules', '.git', '__pycache__'}


@dataclasses.dataclass
class Block:
    """A block of code: indented, or between fences."""
    line: int  # of its first line, from 1
    language: str  # of the fence; '' of an indented one
    lines: list


def pages_below(folder):
    """Paths of all pages, from FOLDER on."""
    found = []
    for place, folders, files in os.walk(folder):
        folders[:] = [name for name in folders if name not in NO_PAGES and not name.startswith('build-')]
        found += [os.path.relpath(os.path.join(place, name), folder) for name in files if name.endswith('.md')]
    return sorted(found)


def read(path):
    with open(path, encoding='utf-8') as file:
        return file.read()


def blocks_of(text):
    """The blocks of a page. Indented lines in a list are no block: those begin behind an empty line at four blanks."""
    blocks, prose = [], []
    lines = text.split('\n')
    fence, current, in_list = None, None, False
    for number, line in enumerate(lines, 1):
        if fence is not None:
            if line.startswith('```'):
                blocks.append(fence)
                fence = None
            else:
                fence.lines.append(line)
            continue
        if line.startswith('```'):
            fence, current = Block(number + 1, line[3:].strip(), []), None
            continue
        indented = line.startswith('    ')
        if current is not None and (indented or not line.strip()):
            current.lines.append(line[4:])
            continue
        if current is not None:
            current = None
        if indented and not in_list and (number == 1 or not lines[number - 2].strip()):
            current = Block(number, '', [line[4:]])
            blocks.append(current)
            continue
        if line.strip() and not indented:
            in_list = bool(re.match(r'\s*([-*]|\d+\.) ', line)) or (in_list and line.startswith(' '))
        prose.append(line)
    for block in blocks:
        while block.lines and not block.lines[-1].strip():
            block.lines.pop()
    return blocks, '\n'.join(prose)


def anchors_of(text):
    """What `#...` may name on a page: its headings, as hosts of Markdown make them to names."""
    anchors = set()
    for heading in re.findall(r'^#+ +(.*?) *$', blocks_of(text)[1], re.MULTILINE):
        plain = re.sub(r'\[([^]]*)\]\([^)]*\)', r'\1', heading).replace('`', '')
        name = re.sub(r'[^\w\- ]', '', plain.lower()).replace(' ', '-')
        unique, count = name, 0
        while unique in anchors:
            count += 1
            unique = f'{name}-{count}'
        anchors.add(unique)
    return anchors


def links_of(text):
    """Targets of the links and pictures of a page, without what stands in code."""
    prose = re.sub(r'`[^`]*`', '', blocks_of(text)[1])
    return re.findall(r'\]\(([^)\s]+)\)', prose) + re.findall(r'<(https?://[^>]+)>', prose)
