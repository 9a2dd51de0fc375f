"""Pages of axisctl: a page to fill in, what a page holds, and a recording read by docs/reference/recording.md."""

import base64
import json
import re
import struct
import zlib

TAG = '<script type="application/json" id="session">'
BLANK = f'<!doctype html><title>page</title>{TAG}null</script><p>end</p>\n'
FRAME, EVENT, SAMPLES, END = 1, 2, 3, 5


def session_of(path):
    """The session in the page at PATH; nothing else of the page has changed."""
    with open(path, encoding='utf-8') as file:
        page = file.read()
    before, after = BLANK.split('null')
    assert page.startswith(before) and page.endswith(after), page[:200]
    text = page[len(before):len(page) - len(after)]
    assert '<' not in text
    session = json.loads(text)
    assert (session['format'], session['version']) == ('axisd-session', 1), session['format']
    assert re.fullmatch(r'axisctl \d+\.\d+\.\d+', session['made_by']), session['made_by']
    assert re.fullmatch(r'\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ', session['made_at']), session['made_at']
    return session


def records_in(content):
    """Head and records (type, ns, content) of a recording, by docs/reference/recording.md and not by a program of the project.

    What is cut at its end is left out.
    """
    assert content[:8] == b'AXISREC\n'
    version, zero, length = struct.unpack_from('<HHI', content, 8)
    assert (version, zero) == (1, 0)
    text = content[16:16 + length]
    assert struct.unpack_from('<I', content, 16 + length) == (zlib.crc32(text),)
    records, at = [], 16 + length + 4
    while at + 12 <= len(content):
        kind, size, time = struct.unpack_from('<HHq', content, at)
        record = content[at:at + 12 + size]
        if at + 12 + size + 4 > len(content):
            break
        assert struct.unpack_from('<I', content, at + 12 + size) == (zlib.crc32(record),)
        records.append((kind, time, record[12:]))
        at += 12 + size + 4
    return json.loads(text), records


def recording_of(unit, place=-1):
    """Head and records of a recording of a unit in a session."""
    return records_in(base64.b64decode(unit['recordings'][place]['data'], validate=True))


def frame_of(content):
    """Direction, identifier and data of the content of a frame record, as axisctl record show has them."""
    flags, length, identifier = struct.unpack_from('<BBI', content)
    return 'sent' if flags & 1 else 'received', f'{identifier:03X}', content[6:6 + length].hex().upper()
