"""The tables of docs/reference/scenarios.md, which are made of the schema of scenarios:
scenario_keys.py SCHEMA PAGE [--update]

Says whether the page has them; with --update, writes them."""

import json
import re
import sys

BEGIN, END = '<!-- keys of {} -->\n', '<!-- end of {} -->\n'


def form_of(node):
    """What a value is, in a few words."""
    if '$ref' in node:
        name = node['$ref'].rsplit('/', 1)[1]
        return f'[{name}](#{name}s)'.replace('#buss', '#bus').replace('#states', '#conditions')
    if 'anyOf' in node:
        return 'text or texts'
    if 'enum' in node:
        return ', '.join(f'`{choice}`' for choice in node['enum'])
    kind = node['type']
    if kind == 'array':
        return f"list of {form_of(node['items'])}"
    if 'maximum' in node:
        return f"{kind} {node['minimum']:g} to {node['maximum']:.16g}".replace(' 0 to 9007199254740991', ' from 0 on')
    if isinstance(kind, list):
        return ', '.join(kind)
    return 'text' if kind == 'string' else kind


def rows_of(node, keys):
    needed = node.get('required', [])
    for key in keys:
        value = node['properties'][key]
        yield f"| `{key}` | {form_of(value)}{'' if key in needed else ', optional'} | {value['description']} |\n"


def table_of(node):
    return ''.join(['| key | value | meaning |\n|---|---|---|\n', *rows_of(node, node['properties'])])


def alternatives_of(node, common):
    """A row a row of the table: its key, and what stands beside it."""
    text = '| key | value | meaning | beside it |\n|---|---|---|---|\n'
    for other in node['oneOf']:
        first, *rest = [key for key in other['properties'] if key not in common]
        value = other['properties'][first]
        beside = '; '.join(f"`{key}`{'' if key in other['required'] else ' (optional)'}: {other['properties'][key]['description']}"
                           for key in rest)
        text += f"| `{first}` | {form_of(value)} | {value['description']} | {beside} |\n"
    return text


def tables(schema):
    parts = schema['$defs']
    steps = parts['step']['oneOf']
    common = [key for key in steps[0]['properties'] if all(key in step['properties'] for step in steps)]
    head = {'properties': {key: steps[0]['properties'][key] for key in common}}
    return {'scenario': table_of(schema), 'bus': table_of(parts['bus']), 'unit': table_of(parts['unit']),
            'program': table_of(parts['program']), 'step': table_of(head), 'actions': alternatives_of(parts['step'], common),
            'conditions': alternatives_of(parts['condition'], [])}


def main():
    schema, page = sys.argv[1:3]
    with open(schema, encoding='utf-8') as file:
        made = tables(json.load(file))
    with open(page, encoding='utf-8') as file:
        text = was = file.read()
    for name, table in made.items():
        pattern = re.escape(BEGIN.format(name)) + '.*?' + re.escape(END.format(name))
        assert len(re.findall(pattern, text, re.DOTALL)) == 1, f'{page}: expected one table of {name}'
        text = re.sub(pattern, lambda _, name=name, table=table: BEGIN.format(name) + table + END.format(name), text, flags=re.DOTALL)
    if '--update' in sys.argv:
        with open(page, 'w', encoding='utf-8') as file:
            file.write(text)
    elif text != was:
        print(f'{page}: its tables are not those of the schema; run {sys.argv[0]} with --update')
        return 1
    return 0


if __name__ == '__main__':
    sys.exit(main())
