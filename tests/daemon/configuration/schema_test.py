#!/usr/bin/env python3
"""Holds daemon/axisd.schema.json against the reader of configurations.

usage: schema_test.py CHECK_LINES SOURCE_FOLDER

Everything that the schema says of is asked of the reader: the keys of each object, and of each value what it may be.
Needs python3-jsonschema.
"""
import json
import pathlib
import re
import subprocess
import sys
import unittest

import jsonschema

CHECK_LINES, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
SCHEMA = json.loads((SOURCE / "daemon/axisd.schema.json").read_text())
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)

INDUCTION_MOTOR = "1le1003-2k2"

# What is tried of every value: something of each kind.
KINDS = [True, False, None, "text", "", [], [1], [[0, 1]], {}, {"no_such_key": 1}]
NUMBERS = [-1e300, -1, -0.5, 0, 1e-9, 0.5, 1, 1.5, 2, 7, 100, 1e300]
STEP = 1e-3

def resolved(node):
    """Without references: keys beside a reference count too."""
    if "$ref" not in node:
        return node
    target = SCHEMA
    for part in node["$ref"].lstrip("#/").split("/"):
        target = target[part]
    return {**resolved(target), **{key: value for key, value in node.items() if key != "$ref"}}


def alternatives(node):
    """A node, and those of which its value may be one."""
    node = resolved(node)
    yield node
    for key in ("oneOf", "anyOf"):
        for other in node.get(key, []):
            yield from alternatives(other)


def sample(node):
    """A value that the schema allows."""
    for other in alternatives(node):
        if "const" in other:
            return other["const"]
        if other.get("type") is None and "enum" in other:
            return other["enum"][0]
        if other.get("type") in ("number", "integer"):
            if "examples" in other:
                return other["examples"][0]
            return max(1, other.get("minimum", 1))
        if other.get("type") == "boolean":
            return True
        if other.get("type") == "string":
            return "text"
        if other.get("type") == "array":
            if "prefixItems" in other:
                return [sample(item) for item in other["prefixItems"]]
            item = sample(other["items"])
            return [[0] * len(item), item] if isinstance(item, list) else [item]
        if "properties" in other:
            return {key: sample(other["properties"][key]) for key in other.get("required", [])}
        if other.get("type") == "object":
            return {}
    raise ValueError(f"no sample of {node}")


def objects(node, build, path=""):
    """Every object with keys: its path, node, how it is put into a configuration, and what it must have."""
    for other in alternatives(node):
        choices = [choice.get("required", []) for choice in other.get("oneOf", [{}])]
        for choice in choices if "properties" in other else []:
            required = other.get("required", []) + choice
            excluded = {key for keys in choices for key in keys} - set(choice)
            needed = {key: sample(other["properties"][key]) for key in required}
            yield path or "/", other, build, needed
            for key, value in other["properties"].items():
                inner = lambda x, key=key, build=build, needed=needed: build({**needed, key: x})
                if key not in excluded:
                    yield from objects(value, inner, f"{path}/{key}")
        if other.get("type") == "array" and "items" in other:
            yield from objects(other["items"], lambda x, build=build: build([x]), f"{path}/0")


OBJECTS = list(objects(SCHEMA, lambda x: x))
# (path, node, configuration with a value there)
VALUES = [
    (f"{path.rstrip('/')}/{key}", value, lambda x, key=key, build=build, needed=needed: build({**needed, key: x}))
    for path, node, build, needed in OBJECTS
    for key, value in node["properties"].items()
    if not any(key in choice["required"] for choice in node.get("oneOf", [])) or key in needed
]


READER = subprocess.Popen([CHECK_LINES], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)


def tearDownModule():
    READER.stdin.close()
    assert READER.wait() == 0, READER.returncode


def answers(configurations):
    """What the reader says of each."""
    said = []
    for configuration in configurations:
        READER.stdin.write(json.dumps(configuration) + "\n")
        READER.stdin.flush()
        said.append(READER.stdout.readline().rstrip("\n"))
        assert said[-1], configuration
    return said


def with_induction_motor(configuration):
    """The same with the other type of motor, which has a plant of its own."""
    units = configuration.get("units") if isinstance(configuration, dict) else None
    if isinstance(units, list):
        return {**configuration, "units": [with_induction_motor(unit) for unit in units]}
    axes = configuration.get("axes") if isinstance(configuration, dict) else None
    axis = axes[0] if isinstance(axes, list) and axes else None
    if not isinstance(axis, dict) or "plant" not in axis:
        return configuration
    return {**configuration, "axes": [{**axis, "motor": INDUCTION_MOTOR}, *axes[1:]]}


def of_the_other_profile(configuration):
    """The same as a CiA 402 device, which has keys of its own."""
    if not isinstance(configuration, dict) or "profile" in configuration:
        return configuration
    if isinstance(configuration.get("units"), list):
        return {**configuration, "units": [of_the_other_profile(unit) for unit in configuration["units"]]}
    return {**configuration, "profile": "cia402"}


# What keys may belong to: each of these knows others.
VARIANTS = [lambda c: c, with_induction_motor, of_the_other_profile]


def verdicts(configurations):
    """What the reader says of each: "accepted" if it is in one of the variants, else what one says that knows the key."""
    said = list(zip(*(answers([variant(c) for c in configurations]) for variant in VARIANTS)))
    return [min(messages, key=lambda message: (message != "accepted", "unknown key" in message or "a unit with" in message))
            for messages in said]


def candidates(node):
    """Values around what @p node allows, right and wrong ones."""
    found = [*KINDS, *NUMBERS]
    for other in alternatives(node):
        found += other.get("enum", []) + other.get("examples", [])
        found += [other[key] for key in ("const", "default") if key in other]
        for key in ("minimum", "maximum", "exclusiveMinimum"):
            if key in other:
                found += [other[key], other[key] - 1, other[key] - STEP, other[key] + STEP, other[key] + 1]
    return found


def configurations_in(text):
    """Every JSON object in a source or page."""
    decoder = json.JSONDecoder()
    for match in re.finditer(r"(?:R\"\(|^ {4}|^)(\{)", text, re.MULTILINE):
        try:
            yield decoder.raw_decode(text, match.start(1))[0]
        except json.JSONDecodeError:
            continue


class Schema(unittest.TestCase):
    def test_is_a_schema(self):
        jsonschema.Draft202012Validator.check_schema(SCHEMA)

    def test_has_the_keys_of_the_reader(self):
        self.assertGreater(len(OBJECTS), 15)
        asked = [build({**needed, "no_such_key": 1}) for _, _, build, needed in OBJECTS]
        said = zip(*(answers([variant(c) for c in asked]) for variant in VARIANTS))
        for (path, node, _, _), messages in zip(OBJECTS, said):
            named = [re.search(r"/no_such_key: unknown key, expected one of: (.*)$", message) for message in messages]
            known = [set(match[1].split(", ")) for match in named if match]
            self.assertTrue(known, f"{path}: the reader knows no object here")
            if path.endswith("/inject/0"):  # those of one kind
                self.assertLess(known[0], set(node["properties"]), path)
            else:  # of one variant, or of both motors
                self.assertIn(set(node["properties"]), [*known, set.union(*known)], path)
            self.assertIs(node.get("additionalProperties"), False, path)

    def test_has_the_keys_of_all_kinds_of_faults(self):
        keys = SCHEMA["$defs"]["unit"]["properties"]["inject"]["items"]["properties"]
        asked = [{"inject": [{"kind": kind, "no_such_key": 1}]} for kind in keys["kind"]["enum"]]
        said = {key for message in answers(asked) for key in message.split("expected one of: ")[1].split(", ")}
        self.assertEqual(set(keys), said)

    def test_has_the_objects_of_the_reader(self):
        for (path, node, _), said in zip(VALUES, verdicts([build({"no_such_key": 1}) for _, node, build in VALUES])):
            is_object = any("properties" in other for other in alternatives(node))
            self.assertEqual("/no_such_key: unknown key" in said or "key type" in said, is_object, f"{path}: {said}")

    def test_has_the_choices_of_the_reader(self):
        choices = {}  # of a path: all of them, and a configuration with another one
        for path, node, build in VALUES:
            node = resolved(node)
            if "enum" in node or "const" in node:
                known, _ = choices.get(path, (set(), None))
                choices[path] = known | set(node.get("enum", [node.get("const")])), build
        self.assertGreater(len(choices), 3)
        said = verdicts([build("no such choice") for _, build in choices.values()])
        for (path, (known, _)), message in zip(choices.items(), said):
            named = re.search(r": expected (.*), got \"no such choice\"$", message)
            self.assertIsNotNone(named, f"{path}: {message}")
            self.assertEqual(known, set(re.split(r", | or ", named[1])), path)

    def test_refuses_nothing_that_the_reader_accepts(self):
        tried = [(path, build(value)) for path, node, build in VALUES for value in candidates(node)]
        self.assertGreater(len(tried), 1000)
        tried += [(path, of_the_other_profile(configuration)) for path, configuration in tried]
        for (path, configuration), said in zip(tried, answers([c for _, c in tried])):
            if said == "accepted":
                self.assertTrue(VALIDATOR.is_valid(configuration), f"{path}: {configuration}")

    def test_gives_no_profile_the_keys_of_the_other(self):
        refused = 0
        for profile in ("s120", "cia402"):
            tried = [{"profile": profile, **build(sample(node))} for path, node, build in VALUES
                     if re.fullmatch(r"(/axes/0)?/[a-z0-9_]+", path) and path not in ("/profile", "/units", "/threads")]
            for configuration, said in zip(tried, answers(tried)):
                if "expected a unit with" in said:
                    refused += 1
                    self.assertFalse(VALIDATOR.is_valid(configuration), f"{configuration}: {said}")
        self.assertGreater(refused, 10)

    def test_accepts_nothing_of_another_kind_than_the_reader(self):
        for path, node, build in VALUES:
            for value, said in zip(KINDS, verdicts([build(value) for value in KINDS])):
                if said != "accepted" and any(VALIDATOR.is_valid(variant(build(value))) for variant in VARIANTS):
                    self.assertIsInstance(value, str, f"{path}: {value}: {said}")

    def test_has_defaults_that_the_reader_accepts(self):
        defaults = [(path, build(resolved(node)["default"])) for path, node, build in VALUES
                    if "default" in resolved(node)]
        self.assertGreater(len(defaults), 30)
        for (path, configuration), said in zip(defaults, verdicts([c for _, c in defaults])):
            self.assertEqual(said, "accepted", path)
            self.assertTrue(any(VALIDATOR.is_valid(variant(configuration)) for variant in VARIANTS), path)

    def test_has_limits_that_are_those_of_the_reader(self):
        """A limit itself is accepted, and what is just beyond is refused."""
        tried = []
        for path, node, build in VALUES:
            limits = resolved(node)
            for key, outside in (("minimum", -1), ("maximum", 1)):
                if key in limits:
                    tried.append((path, limits[key], build(limits[key]), True))
                    tried.append((path, limits[key], build(limits[key] + outside), False))
        self.assertGreater(len(tried), 60)
        for (path, limit, configuration, right), said in zip(tried, verdicts([c for _, _, c, _ in tried])):
            self.assertEqual(said == "accepted", right, f"{path}: {'' if right else 'beyond '}{limit}: {said}")

    def test_allows_the_configurations_of_pages_examples_and_tests(self):
        files = [*SOURCE.glob("*.md"), *SOURCE.glob("docs/**/*.md"), *SOURCE.glob("examples/**/*.md"),
                 *SOURCE.glob("tests/daemon/configuration/*.cpp"), *SOURCE.glob("tests/e2e/*.cpp")]
        found = [(file, configuration) for file in files for configuration in configurations_in(file.read_text())]
        accepted = 0
        for (file, configuration), said in zip(found, verdicts([c for _, c in found])):
            if said == "accepted":
                accepted += 1
                self.assertTrue(any(VALIDATOR.is_valid(variant(configuration)) for variant in VARIANTS),
                                f"{file}: {configuration}")
        self.assertGreater(accepted, 10)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
