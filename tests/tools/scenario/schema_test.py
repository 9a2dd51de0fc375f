#!/usr/bin/env python3
"""Holds the schema of scenarios against their reader, and the complaints of the reader against what they have to say.

usage: schema_test.py AXISCTL SCHEMA FOLDER

Every scenario of FOLDER and every bad example below goes through both. Needs python3-jsonschema.
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import jsonschema

AXISCTL, SCHEMA_FILE, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
SCHEMA = json.loads(SCHEMA_FILE.read_text())
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)

UNIT = {"name": "drive", "node_id": 5}


def with_steps(*steps, units=None, **keys):
    return {"title": "t", "units": [UNIT] if units is None else units, "steps": list(steps), **keys}


SEND = {"send": "000#0105"}
# (scenario, what the reader says of it behind the name of the file, whether the schema refuses it too: it knows no names
# and no values of faults)
BAD = [
    ([], "/: expected an object, got []", True),
    ({"steps": []}, "/title: expected, is missing", True),
    ({"title": "t"}, "/steps: expected, is missing", True),
    ({"title": "", "steps": []}, '/title: expected a text, got ""', True),
    (with_steps(about=[1]), "/about: expected a text or a list of texts, got [1]", True),
    (with_steps(sead=1), "/sead: unknown key, expected one of: $schema, title, about, references, seed, limit_s, bus, units, "
     "programs, steps", True),
    (with_steps(seed=-1), "/seed: expected an integer 0 to 9007199254740991, got -1", True),
    (with_steps(limit_s=0), "/limit_s: expected a number 0.1 to 3600, got 0", True),
    (with_steps(limit_s=3601), "/limit_s: expected a number 0.1 to 3600, got 3601", True),
    (with_steps(bus=125000), "/bus: expected an object, got 125000", True),
    (with_steps(bus={"bit_rate": 1000001}), "/bus/bit_rate: expected an integer 0 to 1000000, got 1000001", True),
    (with_steps(units={}), "/units: expected a list of at most 1000, got {}", True),
    (with_steps(units=[1]), "/units/0: expected an object, got 1", True),
    (with_steps(units=[{"name": "a b", "node_id": 5}]), '/units/0/name: expected a name of letters, digits, - and _, got "a b"', True),
    (with_steps(units=[{"name": "a", "node_id": 0}]), "/units/0/node_id: expected an integer 1 to 127, got 0", True),
    (with_steps(units=[UNIT, UNIT]), '/units/1/name: expected a name of its own, got "drive"', False),
    (with_steps(units=[{**UNIT, "inject": [{"kind": "sdo.lat"}]}]), "/units/0/inject/0/kind: expected sdo.deaf, ", True),
    (with_steps(units=[{**UNIT, "config": 1}]), "/units/0/config: expected an object, got 1", True),
    (with_steps(programs=[{"name": "p"}]), "/programs/0/command: expected, is missing", True),
    (with_steps(programs=[{"name": "p", "command": "x", "exit_status": 256}]),
     "/programs/0/exit_status: expected an integer 0 to 255, got 256", True),
    (with_steps(1), "/steps/0: expected an object, got 1", True),
    (with_steps({}), "/steps/0: expected one of the keys send, cyclic, stop, nmt, read, write, set, turn_on, inject, remove, "
     "power, call, wait_ms, expect, never, always, start, kill, got {}", True),
    (with_steps({"sned": "000#0105"}), "/steps/0: expected one of the keys send, ", True),
    (with_steps({**SEND, "nmt": "start"}), "/steps/0/nmt: unknown key, expected one of: send, times, name, about, at_ms, "
     "after_ms, on", True),
    (with_steps({"send": "000"}), '/steps/0/send: expected a frame as candump prints it, such as 205#0F00 or 705#R, got "000"', True),
    (with_steps({"send": "800#"}), "/steps/0/send: expected a frame as candump prints it, ", True),
    (with_steps({"send": "205#0F0"}), "/steps/0/send: expected a frame as candump prints it, ", True),
    (with_steps({"send": "205#0102030405060708FF"}), "/steps/0/send: expected a frame as candump prints it, ", True),
    (with_steps({"send": "205#xx"}), "/steps/0/send: expected a frame as candump prints it, ", True),
    (with_steps({**SEND, "times": 0}), "/steps/0/times: expected an integer 1 to 100000, got 0", True),
    (with_steps({**SEND, "at_ms": "1"}), '/steps/0/at_ms: expected a number 0 to 3600000, got "1"', True),
    (with_steps({**SEND, "on": {}}), "/steps/0/on: expected one of the keys frame, nmt_state, drive_state, signal, fault, no_fault, "
     "bus_state, hits, ended, got {}", True),
    (with_steps({"cyclic": "080#", "as": "s"}), "/steps/0/every_ms: expected, is missing", True),
    (with_steps({"stop": "s"}), "/steps/0/stop: expected the name of a cyclic frame before, there is none", False),
    (with_steps({"nmt": "go"}), "/steps/0/nmt: expected one of start, stop, pre-operational, reset-node, "
     'reset-communication, got "go"', True),
    (with_steps({"nmt": "start", "unit": "drives"}), '/steps/0/unit: expected a unit: drive; got "drives"', False),
    (with_steps({"nmt": "start"}, units=[UNIT, {"name": "b", "node_id": 6}]),
     "/steps/0/unit: expected the name of a unit, is missing and there are 2 units", False),
    (with_steps({"read": "60411"}), '/steps/0/read: expected an object in hexadecimal, such as 6041 or 1018:04, got "60411"', True),
    (with_steps({"read": "1000", "answer": "no"}), '/steps/0/answer: expected one of none, malformed, got "no"', True),
    (with_steps({"write": "1017"}), "/steps/0/value: expected, is missing", True),
    (with_steps({"write": "1017", "value": 1, "bytes": 9}), "/steps/0/bytes: expected an integer 1 to 8, got 9", True),
    (with_steps({"turn_on": 9}), "/steps/0/turn_on: expected an integer 1 to 8, got 9", True),
    (with_steps({"inject": {"kind": "sdo.late"}}), "/steps/0/inject/delay_ms: expected ", False),
    (with_steps({"inject": {"kind": "sdo.silent", "delay_ms": 5}}), "/steps/0/inject/delay_ms: expected ", False),
    (with_steps({"inject": {"kind": "sdo.silent", "probability": 2}}), "/steps/0/inject/probability: expected ", False),
    (with_steps({"inject": {"kind": "sdo.silent", "evry": 2}}), "/steps/0/inject/evry: expected ", True),
    (with_steps({"inject": "sdo.silent"}), "/steps/0/inject: expected ", True),
    (with_steps({"remove": "x"}), "/steps/0/remove: expected the name of a fault that was injected before, there is none", False),
    (with_steps({"power": "of"}), '/steps/0/power: expected one of on, off, got "of"', True),
    (with_steps({"call": "load.sett"}), '/steps/0/call: expected a method of the control socket, got "load.sett"', False),
    (with_steps({"call": "load.set", "params": {"axis": 1}}), "/steps/0/params: ", False),
    (with_steps({"wait_ms": -1}), "/steps/0/wait_ms: expected a number 0 to 3600000, got -1", True),
    (with_steps({"expect": {"frame": "18"}}), "/steps/0/expect/frame: expected a frame such as 185, 185#37xx or 585#80*, where x is "
     'any digit, got "18"', True),
    (with_steps({"expect": {"frame": "185", "mask": "F"}}), "/steps/0/expect/mask: expected at most eight bytes in hexadecimal, such "
     'as 4F00, got "F"', True),
    (with_steps({"expect": {"drive_state": "enabled"}}), "/steps/0/expect/drive_state: expected one of not-ready-to-switch-on, ", True),
    (with_steps({"expect": {"hits": "x"}}), "/steps/0/expect/hits: expected the name of a fault that was injected before, there is none",
     False),
    (with_steps({"expect": {"ended": "x"}}), "/steps/0/expect/ended: expected a program, there is none", False),
    (with_steps({"always": {"frame": "185"}}), "/steps/0/always: expected one of the keys nmt_state, ", True),
    (with_steps({"never": {"frame": "185"}, "until": "x"}), "/steps/0/until: expected the name of a step, there is none", False),
    (with_steps({"never": {"frame": "185"}, "until": "x", "for_ms": 1}, {**SEND, "name": "x"}),
     "/steps/0/until: expected either for_ms or until, got both", False),
    (with_steps({**SEND, "name": "x"}, {**SEND, "name": "x"}), '/steps/1/name: expected a name of its own, got "x"', False),
    (with_steps({"kill": "x"}), "/steps/0/kill: expected a program, there is none", False),
]
# Texts that are no scenario at all.
TEXTS = [
    ("", "line 1, column 1: expected valid JSON"),
    ('{"title": "t",\n "steps": [}', "line 2, column 12: expected valid JSON"),
    ('{"title": "t", "title": "u", "steps": []}', "/title: expected once, is there twice"),
    ("[" * 33 + "]" * 33, "line 1, column 33: expected at most 32 levels of objects and arrays"),
]


def said_of(text):
    """Exit status and message of the reader, behind the name of the file."""
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        file.write(text)
        file.flush()
        done = subprocess.run([AXISCTL, "run", "--check", file.name], capture_output=True, text=True, check=False)
        return done.returncode, done.stderr.removeprefix(f"axisctl: {file.name}: ")


class Scenarios(unittest.TestCase):
    def test_schema_is_one(self):
        jsonschema.Draft202012Validator.check_schema(SCHEMA)

    def test_ready_ones_are_accepted_by_both(self):
        files = sorted(FOLDER.glob("*.json"))
        self.assertGreaterEqual(len(files), 20)
        for file in files:
            with self.subTest(file.name):
                text = file.read_text()
                self.assertEqual(said_of(text), (0, ""))
                VALIDATOR.validate(json.loads(text))

    def test_bad_ones_are_refused_with_what_is_wrong(self):
        for scenario, message, _ in BAD:
            with self.subTest(message):
                status, said = said_of(json.dumps(scenario))
                self.assertEqual(status, 2, said)
                self.assertTrue(said.startswith(message), said)
                self.assertEqual(said.count("\n"), 1)

    def test_schema_refuses_what_it_can_know(self):
        for scenario, message, known in BAD:
            with self.subTest(message):
                self.assertEqual(VALIDATOR.is_valid(scenario), not known)

    def test_what_is_no_json_is_refused_with_its_place(self):
        for text, message in TEXTS:
            with self.subTest(message):
                self.assertEqual(said_of(text), (2, message + "\n"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
