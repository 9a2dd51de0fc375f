"""Whether the page on masters that were judged has what the tests know of them, and nothing else: audited_page.py PAGE"""

import pathlib
import re
import sys

import audited


FRAME = r'`[\dA-F]{3}#[\dA-FR]*`'
ROW = re.compile(rf'^\| `(\w+)` \| `([\w.-]+)` \| {FRAME}(?:, {FRAME})* \| .+ \|$', re.MULTILINE)


def known():
    """(test, rule) of each finding that a test knows."""
    return {(path.stem, finding['rule']) for path in audited.KNOWN.glob('*.json') for finding in audited.read(path)}


def main():
    with open(sys.argv[1], encoding='utf-8') as file:
        page = file.read()
    rows = ROW.findall(page)
    written = set(rows)
    assert len(rows) == len(written), 'a row is there twice'
    assert written == known(), f'not on the page: {known() - written}, not known: {written - known()}'
    unjudged = set(re.findall(r'`(\w+)`', page.split('\n## Masters that are not judged\n')[1]))
    assert unjudged == audited.UNJUDGED.keys(), unjudged ^ audited.UNJUDGED.keys()
    for rule in audited.OF_THE_MACHINE:
        assert f'`{rule}`' in page, rule
    print(f'{len(rows)} findings')


main()
