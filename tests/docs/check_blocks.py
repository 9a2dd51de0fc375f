"""Whether a test runs every block of code of the documentation, or blocks.txt says why not:
check_blocks.py BUILD-FOLDER SOURCE-FOLDER

A block has one row of blocks.txt, or is pasted by run_block.py; a row has a block, and names a test that there is."""

import os
import subprocess
import sys

import pages
import rows
import run_block


def tests_of(build):
    """Names of the tests of the build."""
    listed = subprocess.run(['ctest', '--test-dir', build, '-N', '-L', '^(bus|package)$'], capture_output=True, text=True,
                            check=True, timeout=120)
    return {line.split(': ', 1)[1] for line in listed.stdout.split('\n') if ': ' in line}


def pasted():
    """Page and beginning of the blocks that run_block.py takes."""
    return [(blocks.page, start) for blocks in run_block.BLOCKS.values()
            for start in [*blocks.starts, *blocks.saved.values()]]


def main():
    build, source = sys.argv[1:]
    table, wrong, count = rows.read(source), [], 0
    used = set()
    by_hand = pasted()
    for page in pages.pages_below(source):
        for block in pages.blocks_of(pages.read(os.path.join(source, page)))[0]:
            count += 1
            fitting = [number for number, row in enumerate(table) if row.page == page and row.fits(block)]
            is_pasted = any(page == other and block.lines[0].startswith(start) for other, start in by_hand)
            used.update(fitting)
            if len(fitting) + is_pasted != 1:
                wrong.append(f'{page}:{block.line}: expected one row of tests/docs/blocks.txt or run_block.py that says how this '
                             f'block is run, found {len(fitting) + is_pasted}: {block.lines[0]}')
    for number, row in enumerate(table):
        where = f'tests/docs/blocks.txt: {row.page} | {row.start}'
        if number not in used:
            wrong.append(f'{where}: there is no such block')
        if row.kind not in rows.KINDS:
            wrong.append(f'{where}: {row.kind} is no kind')
        word = row.detail.split(':')[0]
        if row.kind == 'needs' and not all(reason in rows.REASONS for reason in word.split(' and ')):
            wrong.append(f'{where}: expected {", ".join(rows.REASONS)}, found {word}')
        if row.kind == 'shown' and not row.detail:
            wrong.append(f'{where}: what is shown there?')
    named = {row.detail.split(':')[0] for row in table if row.kind == 'tested'}
    wrong += [f'tests/docs/blocks.txt: there is no test {name}' for name in sorted(named - tests_of(build))]
    kinds = {kind: sum(row.kind == kind for row in table) for kind in rows.KINDS}
    print(f'{count} blocks; pasted {len(by_hand)}; rows: ' + ', '.join(f'{number} {kind}' for kind, number in kinds.items()))
    print('\n'.join(wrong))
    return 1 if wrong else 0


sys.exit(main())
