#!/usr/bin/env python3
"""What `axisctl run --html` leaves of scenarios: pages with verdict, recordings and what units tell.

usage: scenario_html.py PROGRAM_FOLDER
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from html_pages import BLANK, END, EVENT, FRAME, frame_of, recording_of, session_of

PROGRAMS = sys.argv[1]
AXISCTL = PROGRAMS + "/axisctl"
UNIT = {"name": "drive", "node_id": 5}
NOT_FULFILLED, FAILED = 11, 1
PATIENCE_S = 60
FAULT = 6  # kind of an event
# A program that kills whoever serves the control socket of the unit.
KILLER = """import os, signal, socket, struct
client = socket.socket(socket.AF_UNIX)
client.connect(os.environ["AXISD_SOCKET_drive"])
os.kill(struct.unpack("=iII", client.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, 12))[0], signal.SIGKILL)
"""
FAILS = {"units": [UNIT], "steps": [
    {"nmt": "start"}, {"turn_on": 1}, {"call": "fault.inject", "params": {"axis": 1, "number": 7860}, "name": "blow"},
    {"expect": {"signal": "1/r0063", "at_least": 5000}, "within_ms": 50, "about": "it never will"}, {"nmt": "stop"}]}
PASSES = {"units": [UNIT], "steps": [{"nmt": "start"}, {"expect": {"nmt_state": "operational"}}]}


class Pages(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.pages = self.folder / "new" / "pages"
        self.blank = self.folder / "blank.html"
        self.blank.write_text(BLANK, encoding="ascii")

    def run_scenarios(self, scenarios, *options):
        files = []
        for name, scenario in scenarios.items():
            files.append(self.folder / f"{name}.json")
            files[-1].write_text(json.dumps({"title": f"The trial <{name}>", **scenario}), encoding="utf-8")
        words = [AXISCTL, "run", "--html", str(self.pages), "--template", str(self.blank), *options, *map(str, files)]
        environment = {**os.environ, "XDG_RUNTIME_DIR": str(self.folder)}
        return subprocess.run(words, capture_output=True, text=True, env=environment, timeout=PATIENCE_S, check=False)

    def session(self, name):
        return session_of(self.pages / f"{name}.html")

    def assert_only(self, *names):
        self.assertEqual(sorted(path.name for path in self.pages.iterdir()), sorted(f"{name}.html" for name in names))

    def test_a_scenario_that_fails_leaves_what_has_happened(self):
        done = self.run_scenarios({"fails": FAILS, "passes": PASSES})
        self.assertEqual(done.returncode, NOT_FULFILLED, done.stderr)
        self.assert_only("fails")
        self.assertIn(f"axisctl: {self.pages}/fails.html shows what has happened\n", done.stderr)
        session = self.session("fails")
        self.assertEqual(session["title"], "The trial <fails>")
        self.assertFalse(session["verdict"]["passed"])
        self.assertTrue(done.stdout.startswith(session["verdict"]["text"]))
        self.check_unit(session["units"][0])
        self.check_report(session)

    def check_unit(self, unit):
        self.assertEqual(unit["name"], "drive")
        self.assertTrue(unit["unit"].endswith("/5"), unit["unit"])
        self.assertEqual([fault["number"] for fault in unit["resources"][""]["axes"][0]["faults"]], [7860])
        self.assertIn("axes/1/parameters", unit["resources"])
        self.assertIn("[FileInfo]", unit["eds"])
        head, records = recording_of(unit)
        self.assertEqual([signal["name"] for signal in head["signals"]],
                         ["1/speed", "1/speed_setpoint", "1/torque", "1/current", "1/r0063[0]"])
        frames = [frame_of(content) for kind, _, content in records if kind == FRAME]
        self.assertEqual(frames[0], ("sent", "705", "00"))
        self.assertIn(("received", "000", "0105"), frames)
        self.assertIn(FAULT, [content[0] for kind, _, content in records if kind == EVENT])
        self.assertEqual(records[-1][0], END)

    def check_report(self, session):
        report = session["report"]
        self.assertEqual((report["scenario"], report["passed"]), ("fails", False))
        steps = report["steps"]
        self.assertEqual([step["number"] for step in steps], [1, 2, 3, 4, 5])
        self.assertEqual([step["passed"] for step in steps], [True, True, True, False, False])
        self.assertEqual([step["run"] for step in steps], [True, True, True, True, False])
        self.assertEqual(steps[0]["text"], "nmt start")
        self.assertRegex(steps[3]["remark"], "^not within 50 ms, there is ")
        self.assertEqual((steps[2]["name"], steps[3]["about"]), ("blow", "it never will"))
        self.assertIsNone(steps[4]["t_s"])
        _, records = recording_of(session["units"][0])
        fault = next(time for kind, time, content in records if kind == EVENT and content[0] == FAULT) / 1e9
        start = next(time for kind, time, content in records
                     if kind == FRAME and frame_of(content) == ("received", "000", "0105")) / 1e9
        self.assertLessEqual(steps[0]["t_s"], start)
        # A step has ended when its frame or call is on its way or answered; the unit tells of it at one of its next cycles.
        self.assertLessEqual(start, steps[2]["t_s"])  # the axis is turned on by frames behind that of the start
        self.assertLessEqual(steps[2]["t_s"], fault)

    def test_those_that_pass_leave_theirs_if_asked_for(self):
        done = self.run_scenarios({"passes": PASSES}, "--html-all")
        self.assertEqual(done.returncode, 0, done.stderr)
        session = self.session("passes")
        self.assertTrue(session["verdict"]["passed"])
        self.assertEqual(session["units"][0]["resources"][""]["nmt_state"], "Operational")

    def test_a_unit_that_has_died_has_its_files(self):
        kill = {"name": "killer", "command": ["python3", "-c", KILLER], "by_step": True}
        done = self.run_scenarios({"dies": {"units": [UNIT, {"name": "other", "node_id": 6}], "programs": [kill], "steps": [
            {"nmt": "start", "unit": "drive"}, {"wait_ms": 300, "about": "records are written each 50 ms"}, {"start": "killer"},
            {"wait_ms": 30000}]}})
        self.assertEqual(done.returncode, NOT_FULFILLED, done.stderr)
        session = self.session("dies")
        self.assertIn("unit drive has ended with status 137", session["verdict"]["text"])
        drive, other = session["units"]
        self.assertEqual((drive["name"], drive["resources"]), ("drive", {}))
        _, records = recording_of(drive)
        self.assertIn(("received", "000", "0105"), [frame_of(content) for kind, _, content in records if kind == FRAME])
        self.assertEqual((other["name"], other["resources"][""]["node_id"]), ("other", 6))

    def test_a_unit_that_was_off_has_both_lives(self):
        done = self.run_scenarios({"lives": {"units": [UNIT], "steps": [
            {"nmt": "start"}, {"power": "off"}, {"wait_ms": 20}, {"power": "on"}, {"expect": {"nmt_state": "pre-operational"}},
            {"wait_ms": 0}]}}, "--html-all")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        session = self.session("lives")
        first, second = (recording_of(session["units"][0], place)[0]["wall_clock_ns"] for place in (0, 1))
        self.assertLess(first, second)
        times = [step["t_s"] for step in session["report"]["steps"]]
        self.assertGreater(times[2], times[0])
        self.assertLess(times[5], times[3] + 0.02 + (second - first) / 1e9)

    def test_recordings_of_the_scenario_itself_stay_its_own(self):
        done = self.run_scenarios({
            "calls": {"units": [UNIT], "steps": [{"call": "record.start", "params": {"name": "mine"}}, {"nmt": "start"},
                                                 {"call": "record.stop", "result": {"name": "mine"}}]},
            "configures": {"units": [{**UNIT, "config": {"record": {"name": "own"}}}], "steps": [
                {"call": "record.status", "result": {"name": "own", "signals": []}}]}}, "--html-all")
        self.assertEqual(done.returncode, 0, done.stdout)
        for name, recording in (("calls", "mine"), ("configures", "own")):
            recordings = self.session(name)["units"][0]["recordings"]
            self.assertEqual([one["name"] for one in recordings], [f"{recording}.axrec"])

    def test_a_signal_that_is_not_there_changes_nothing(self):
        steps = {"units": [UNIT], "steps": [{"expect": {"signal": "1/no_such", "is": 1}, "within_ms": 20}]}
        done = self.run_scenarios({"signal": steps})
        self.assertEqual(done.returncode, NOT_FULFILLED, done.stderr)
        session = self.session("signal")
        self.assertIn("no_such", session["report"]["steps"][0]["remark"])
        self.assertEqual(len(recording_of(session["units"][0])[0]["signals"]), 4)

    def test_scenarios_of_one_name_have_numbers(self):
        (self.folder / "a").mkdir()
        other = self.folder / "a" / "passes.json"
        other.write_text(json.dumps({"title": "other", "steps": []}), encoding="ascii")
        done = self.run_scenarios({"passes": PASSES}, "--html-all", str(other))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_only("passes", "passes-2")

    def test_a_folder_that_cannot_be_made_is_told_at_once(self):
        self.pages = self.blank / "pages"
        done = self.run_scenarios({"passes": PASSES})
        self.assertEqual((done.returncode, done.stdout), (FAILED, ""))
        self.assertRegex(done.stderr, r"^axisctl: .*blank.html/pages: Not a directory\n$")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
