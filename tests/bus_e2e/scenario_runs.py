#!/usr/bin/env python3
"""What `axisctl run` says and leaves behind when a scenario does not go as it says, and when it is ended from outside.

usage: scenario_runs.py PROGRAM_FOLDER
"""
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree

PROGRAMS = sys.argv[1]
AXISCTL = PROGRAMS + "/axisctl"
UNIT = {"name": "drive", "node_id": 5}
NOT_FULFILLED, USAGE, FAILED, NOT_THERE = 11, 2, 1, 4
PATIENCE_S = 60
# Behind it no boot-up message of the start can come any more.
BOOT_UP_SEEN = {"read": "1000"}


def master(*lines):
    """A program under test that sends and receives frames as any SocketCAN program does."""
    head = ["import socket, struct, sys", "s = socket.socket(socket.AF_CAN, socket.SOCK_RAW, socket.CAN_RAW)", "s.bind(('vcan0',))",
            "s.settimeout(10)", "frame = lambda id, data: struct.pack('=IB3x8s', id, len(data), data)"]
    return ["python3", "-c", "\n".join([*head, *lines])]


class Run(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.runtime = pathlib.Path(self.folder.name) / "runtime"
        self.runtime.mkdir(mode=0o700)

    def command(self, scenario, *options):
        file = pathlib.Path(self.folder.name) / "trial.json"
        file.write_text(json.dumps({"title": "a trial", **scenario}))
        return [AXISCTL, *[o for o in options if o == "--json"], "run", *[o for o in options if o != "--json"], str(file)]

    def environment(self):
        return {**os.environ, "XDG_RUNTIME_DIR": str(self.runtime)}

    def run_scenario(self, scenario, *options):
        return subprocess.run(self.command(scenario, *options), capture_output=True, text=True, env=self.environment(),
                              timeout=PATIENCE_S, check=False)

    def report_of(self, scenario, *options):
        done = self.run_scenario(scenario, "--json", *options)
        return done.returncode, json.loads(done.stdout.splitlines()[0])["scenarios"][0]

    def assert_nothing_is_left(self):
        deadline = time.monotonic() + PATIENCE_S
        while True:
            # Whoever takes part in a run has the path of its folder among its words.
            users = [pid for pid in os.listdir("/proc") if pid.isdigit() and self.names_the_runtime(pid)]
            files = list(self.runtime.iterdir())
            if not users and not files:
                return
            self.assertLess(time.monotonic(), deadline, f"processes {users}, files {files}")
            time.sleep(0.01)

    def names_the_runtime(self, pid):
        try:
            return str(self.runtime).encode() in pathlib.Path(f"/proc/{pid}/cmdline").read_bytes()
        except OSError:
            return False

    def test_a_failure_names_the_step_and_shows_the_last_frames(self):
        done = self.run_scenario({"units": [UNIT], "steps": [
            {"nmt": "start"}, {"expect": {"frame": "185#4016"}}, {"expect": {"frame": "185#3116"}, "within_ms": 50}, {"nmt": "stop"}]})
        self.assertEqual(done.returncode, NOT_FULFILLED)
        self.assertIn("axisctl: 1 of 1 scenarios failed", done.stderr)
        self.assertRegex(done.stdout, r"✗   3  expect frame 185#3116 within_ms 50  \[not within 50 ms, there is none\]")
        self.assertRegex(done.stdout, r"-   4  nmt stop\n")
        self.assertRegex(done.stdout, r"-> 000#0105 +NMT start\n")
        self.assertRegex(done.stdout, r"<- 185#4016 +TPDO1\n")
        self.assert_nothing_is_left()

    def test_what_must_never_be_fails_the_step_that_said_so(self):
        status, report = self.report_of({"units": [UNIT], "steps": [
            BOOT_UP_SEEN, {"never": {"frame": "705#00"}, "name": "quiet"}, {"wait_ms": 20}, {"nmt": "reset-node"}, {"wait_ms": 3000000}]})
        self.assertEqual(status, NOT_FULFILLED)
        self.assertEqual([step["outcome"] for step in report["steps"]], ["passed", "failed", "passed", "passed", "not run"])
        self.assertIn("705#00", report["steps"][1]["text"])
        self.assertIn("in step 5", report["steps"][1]["text"])

    def test_what_must_always_be_fails_when_it_ends(self):
        status, report = self.report_of({"units": [UNIT], "steps": [
            {"always": {"nmt_state": "pre-operational"}, "until": "end"}, {"nmt": "start"}, {"wait_ms": 3000000},
            {"wait_ms": 0, "name": "end"}]})
        self.assertEqual(status, NOT_FULFILLED)
        self.assertEqual(report["steps"][0]["outcome"], "failed")
        self.assertIn("operational", report["steps"][0]["text"])

    def test_a_watch_ends_with_the_step_that_it_names(self):
        status, _ = self.report_of({"units": [UNIT], "steps": [
            {"never": {"nmt_state": "operational"}, "until": "start"}, {"wait_ms": 20}, {"nmt": "start", "name": "start"},
            {"expect": {"nmt_state": "operational"}}]})
        self.assertEqual(status, 0)

    def test_steps_begin_at_their_time_or_event(self):
        status, report = self.report_of({"units": [UNIT], "steps": [
            {"send": "000#0105", "at_ms": 100}, {"send": "205#0600", "on": {"nmt_state": "operational"}},
            {"send": "205#0700", "on": {"frame": "185#3116"}, "after_ms": 30}, {"expect": {"frame": "185#3316"}}]})
        self.assertEqual(status, 0)
        begin = [step["t"] for step in report["steps"]]
        self.assertGreaterEqual(begin[0], 0.1)
        self.assertGreaterEqual(begin[2], 0.13)

    def test_a_scenario_that_never_ends_has_a_limit(self):
        status, report = self.report_of({"limit_s": 0.3, "steps": [{"wait_ms": 0}, {"wait_ms": 3000000}]})
        self.assertEqual(status, NOT_FULFILLED)
        self.assertEqual(report["steps"][1]["text"], "step 2 was waited for when the scenario had taken 0.3 s, its limit")

    def test_the_configuration_of_a_unit_is_bad_input(self):
        done = self.run_scenario({"units": [{**UNIT, "config": {"axes": [{"motr": "1fk7063"}]}}], "steps": []})
        self.assertEqual(done.returncode, USAGE)
        self.assertRegex(done.stderr, r"trial.json: /units/0/config/axes/0/motr: unknown key, expected one of: ")
        self.assertEqual(done.stdout, "")
        self.assert_nothing_is_left()

    def test_a_program_under_test_meets_the_unit(self):
        command = master("s.send(frame(0, bytes([1, 5])))", "while s.recv(16)[:4] != struct.pack('=I', 0x185): pass")
        scenario = {"units": [UNIT], "programs": [{"name": "master", "command": command, "exit_status": 0}],
                    "steps": [{"expect": {"nmt_state": "operational"}, "within_ms": 30000},
                              {"expect": {"ended": "master"}, "within_ms": 30000}]}
        done = self.run_scenario(scenario)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assert_nothing_is_left()

    def test_a_program_with_the_wrong_exit_status_fails_the_scenario(self):
        command = ["sh", "-c", "echo gave up; exit 3"]
        status, report = self.report_of({"programs": [{"name": "master", "command": command, "exit_status": 0}],
                                         "steps": [{"expect": {"ended": "master"}, "within_ms": 30000}]})
        self.assertEqual(status, NOT_FULFILLED)
        self.assertEqual(report["problem"], "program master: exit status 3: gave up")

    def test_a_program_is_started_and_killed_by_steps(self):
        scenario = {"programs": [{"name": "sleeper", "command": ["sleep", "1000"], "by_step": True}],
                    "steps": [{"start": "sleeper"}, {"wait_ms": 10}, {"kill": "sleeper"},
                              {"expect": {"ended": "sleeper", "exit_status": 128 + signal.SIGKILL}}]}
        self.assertEqual(self.run_scenario(scenario).returncode, 0)

    def test_a_bus_that_is_there_is_used(self):
        path = self.runtime / "other-bus"
        hub = subprocess.Popen([PROGRAMS + "/canhub", "--path", str(path)], stderr=subprocess.PIPE, text=True)
        try:
            self.assertIn("ready", hub.stderr.readline())
            status, report = self.report_of({"units": [UNIT], "steps": [{"nmt": "start"}, {"expect": {"frame": "185"}}]},
                                            "--bus", f"unix:{path}")
            self.assertEqual((status, report["bus"]), (0, f"unix:{path}"))
        finally:
            hub.terminate()
            hub.wait()
            hub.stderr.close()

    def test_junit_has_a_case_a_step(self):
        file = pathlib.Path(self.folder.name) / "report.xml"
        self.run_scenario({"units": [UNIT], "steps": [{"nmt": "start"}, {"expect": {"fault": 1}, "within_ms": 1}, {"wait_ms": 1}]},
                          "--junit", str(file))
        suites = xml.etree.ElementTree.parse(file).getroot()
        self.assertEqual((suites.get("tests"), suites.get("failures"), suites.get("skipped")), ("3", "1", "1"))
        cases = suites.findall("testsuite/testcase")
        self.assertEqual([case.get("name") for case in cases], ["01 nmt start", "02 expect fault 1 within_ms 1", "03 wait_ms 1"])
        self.assertEqual(cases[1].find("failure").get("message"), "not within 1 ms, there is no fault")

    def test_files_are_kept_if_asked_for(self):
        done = self.run_scenario({"units": [UNIT], "steps": []}, "--keep")
        kept = pathlib.Path(done.stderr.removeprefix("axisctl: files are kept in ").strip())
        self.assertEqual(json.loads((kept / "drive.json").read_text())["node_id"], 5)
        self.assertTrue((kept / "drive.log").exists())

    def end_by(self, number):
        process = subprocess.Popen(self.command({"units": [UNIT], "programs": [{"name": "p", "command": ["sleep", "1000"]}],
                                                 "steps": [{"nmt": "start"}, {"wait_ms": 3000000}]}),
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=self.environment())
        deadline = time.monotonic() + PATIENCE_S
        while not list(self.runtime.glob("*/p.log")):  # the last that is started
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.01)
        process.send_signal(number)
        output, errors = process.communicate(timeout=PATIENCE_S)
        self.assert_nothing_is_left()
        return process.returncode, output, errors

    def test_an_interrupt_ends_everything_and_is_told(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            status, output, errors = self.end_by(number)
            self.assertEqual((status, errors), (FAILED, "axisctl: interrupted\n"))
            self.assertIn("[interrupted]", output)

    def test_nothing_outlives_a_kill(self):
        self.assertEqual(self.end_by(signal.SIGKILL)[0], -signal.SIGKILL)

    def hits(self, *options):
        scenario = {"seed": 11, "units": [UNIT], "steps": [
            {"inject": {"kind": "sdo.silent", "probability": 0.3}, "as": "a"}, {"inject": {"kind": "heartbeat.gap", "probability": 0.5}, "as": "b"},
            {"send": "605#4000100000000000", "times": 40}, {"send": "705#R"},
            {"expect": {"frame": "705#7F"}, "about": "the requests have been heard, all of them"},
            # Over SDO the write could be one of those that are not answered.
            {"call": "object.write", "params": {"index": "1017", "value": 5}},
            {"expect": {"hits": "b", "at_least": 16}, "within_ms": 30000}]}
        _, report = self.report_of(scenario, *options)
        self.assertTrue(report["passed"], report)
        return report["seed"], {fault["name"]: fault["hit_at"] for fault in report["faults"]}

    def test_the_same_seed_gives_the_same_hits(self):
        first, second, other = self.hits(), self.hits(), self.hits("--seed", "12")
        self.assertEqual(first, second)
        self.assertEqual((first[0], other[0]), (11, 12))
        self.assertNotEqual(first[1], other[1])
        self.assertNotEqual(first[1]["a"], first[1]["b"])
        self.assertGreater(len(first[1]["a"]), 4)

    def test_a_scenario_that_is_not_there(self):
        done = subprocess.run([AXISCTL, "run", "no-such-scenario"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, NOT_THERE)
        self.assertIn("no-such-scenario: cannot be read: No such file or directory; axisctl run --list", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
