"""Checks that the pages below a folder hang together: check_links.py FOLDER [INDEX [EXTERNAL]]

Every link leads to a file, and one with # to a heading of it. Every page of docs/ is reachable from INDEX by links, and in
one list of docs/README.md. Links to other hosts are those of the file EXTERNAL, a line each.
"""

import collections
import os
import sys

import pages

FEWEST_LINKS = 100  # fewer: they were not found


def is_external(link):
    return '://' in link


def check(folder, index, external):
    """What is wrong, a line each."""
    links, wrong = 0, []
    leads_to, outside = collections.defaultdict(set), set()
    texts = {page: pages.read(os.path.join(folder, page)) for page in pages.pages_below(folder)}
    anchors = {page: pages.anchors_of(text) for page, text in texts.items()}
    for page, text in texts.items():
        for link in pages.links_of(text):
            links += 1
            if is_external(link):
                outside.add(link)
                continue
            name, _, anchor = link.partition('#')
            target = os.path.normpath(os.path.join(os.path.dirname(page), name)) if name else page
            if not os.path.exists(os.path.join(folder, target)):
                wrong.append(f'{page} points to {link}, which is not there')
            elif anchor and anchor not in anchors.get(target, set()):
                wrong.append(f'{page} points to {link}, which is no heading of {target}')
            leads_to[page].add(os.path.join(target, 'README.md') if target + '/README.md' in texts else target)
    if index:
        seen, ahead = set(), [index]
        while ahead:
            page = ahead.pop()
            if page in texts and page not in seen:
                seen.add(page)
                ahead += leads_to[page]
        wrong += [f'{page} is not reachable from {index}' for page in texts if page not in seen and page.startswith('docs/')]
        wrong += not_listed_once(texts)
    if external is not None:
        wrong += [f'{link} is no link that {sys.argv[3]} lists' for link in sorted(outside - external)]
        wrong += [f'{link} is listed in {sys.argv[3]}, but no page has it' for link in sorted(external - outside)]
    if links < FEWEST_LINKS:
        wrong.append(f'only {links} links were found')
    print(f'{len(texts)} pages, {links} links, {len(outside)} of them to other hosts')
    return wrong


def not_listed_once(texts):
    """Pages of docs/ that are not in exactly one line of the lists of docs/README.md."""
    listed = collections.Counter()
    for line in texts['docs/README.md'].split('\n'):
        if line.startswith('- '):
            listed.update(os.path.normpath(os.path.join('docs', link)) for link in pages.links_of(line)[:1])
    return [f'{page} is in {listed[page]} lists of docs/README.md, not in one'
            for page in texts if page.startswith('docs/') and page != 'docs/README.md' and listed[page] != 1]


def main():
    folder, *rest = sys.argv[1:]
    external = set(pages.read(rest[1]).split()) if len(rest) > 1 else None
    wrong = check(folder, rest[0] if rest else '', external)
    print('\n'.join(wrong))
    return 1 if wrong else 0


sys.exit(main())
