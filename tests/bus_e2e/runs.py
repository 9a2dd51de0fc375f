#!/usr/bin/env python3
"""axisctl compare, replay and twin with a real axisd: a log of it is made, changed, and held against it.

usage: runs.py PROGRAM_FOLDER
"""
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAMS = sys.argv[1]
DIFFERENT, USAGE, NOT_THERE, NOT_REACHABLE, DAMAGED = 1, 2, 4, 5, 12
PATIENCE_S = 60
# What a busy machine may be late; that times are judged is tested in told time.
LATE = ["--time-band", "10s"]
# A master that looks at the unit, starts it and has an axis ready to be switched on.
MASTER = """
000#8105 705#00 605#4000100000000000 585#43 605#4018100300000000 585#43 605#4008100000000000 585#41 605#4010300000000000 585#80
605#2317100000000000 585#60 000#0105 605#4041600000000000 585#4B 205#0600 605#4041600000000000 585#4B 605#406C600000000000 585#43
""".split()
# A master that starts the unit, switches its axis on, lets it turn for a second, and looks at it.
TURNS = [(0, "000#0105"), (0.1, "605#2B40600006000000"), (0.2, "605#2B40600007000000"), (0.3, "605#2B4060000F000000"),
         (0.8, "605#23FF600000004001"), (1.8, "605#406C600000000000"), (1.9, "605#4041600000000000")]


def takes_interrupts(process):
    """Whether it has a handler of SIGINT: with-can brings it to the bus before it begins itself."""
    caught = re.search(r"^SigCgt:\s*([0-9a-f]+)", pathlib.Path(f"/proc/{process}/status").read_text(encoding="ascii"), re.MULTILINE)
    return int(caught[1], 16) >> (signal.SIGINT - 1) & 1 == 1


class Runs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.temporary.cleanup)
        cls.folder = pathlib.Path(cls.temporary.name)
        (cls.folder / "runtime").mkdir(mode=0o700)
        cls.environment = {**os.environ, "XDG_RUNTIME_DIR": str(cls.folder / "runtime")}
        for name in ("CAN_BUS", "LD_PRELOAD"):
            cls.environment.pop(name, None)
        cls.bus = f"unix:{cls.folder}/bus"
        cls.start("canhub", "--path", cls.bus[5:])
        cls.start("axisd", "--interface", cls.bus, "--node-id", "5", "--control", str(cls.folder / "unit.sock"), "--state-directory",
                  str(cls.folder / "state"))
        cls.master = cls.write("master.log", "".join(f"({100 + 0.02 * i:.6f}) can0 {frame}{'0' * (20 - len(frame)) if frame[0] == '5' else ''}\n"
                                                     for i, frame in enumerate(MASTER)))
        cls.log = str(cls.folder / "unit.log")
        done = cls.axisctl("replay", cls.master, "--bus", cls.bus, "--record", cls.log)
        assert done.returncode == 0, done.stderr

    @classmethod
    def start(cls, program, *words):
        log = cls.folder / (program + ".txt")
        with log.open("w") as output:
            process = subprocess.Popen([f"{PROGRAMS}/{program}", *words], stdout=output, stderr=output, env=cls.environment)
        cls.addClassCleanup(process.wait)
        cls.addClassCleanup(process.terminate)
        deadline = time.monotonic() + PATIENCE_S
        while "ready" not in log.read_text():
            assert process.poll() is None and time.monotonic() < deadline, log.read_text()
            time.sleep(0.01)

    @classmethod
    def write(cls, name, text):
        (cls.folder / name).write_text(text)
        return str(cls.folder / name)

    @classmethod
    def axisctl(cls, *words):
        return subprocess.run([f"{PROGRAMS}/axisctl", *words], capture_output=True, text=True, env=cls.environment, timeout=PATIENCE_S,
                              check=False)

    def changed(self, pattern, replacement):
        text, count = re.subn(pattern, replacement, pathlib.Path(self.log).read_text(), count=1)
        self.assertEqual(count, 1, pattern)
        return self.write("changed.log", text)

    def twin(self, log, *words):
        done = self.axisctl("--json", "twin", log, *LATE, *words)
        self.assertIn(done.returncode, (0, DIFFERENT), done.stderr)
        return done.returncode, json.loads(done.stdout.splitlines()[0])

    def test_a_replay_waits_for_the_unit_and_compares(self):
        done = self.axisctl("replay", self.log, f"--bus={self.bus}", "--compare", *LATE)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r"11 frames sent in .* s; 9 of 9 answers came")
        self.assertRegex(done.stdout, r"SDO answers +8 +8 +0 +0 +0 +0")

    def test_a_replay_takes_the_bus_from_interface_too(self):
        done = self.axisctl("--interface", self.bus, "--json", "replay", self.log)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(json.loads(done.stdout)["replay"]["unanswered"], 0)

    def test_a_replay_finds_an_answer_that_is_another_one(self):
        done = self.axisctl("replay", self.changed("585#43001000", "585#43001001"), "--bus", self.bus, "--compare", *LATE)
        self.assertEqual(done.returncode, DIFFERENT)
        self.assertIn("value: the log has", done.stdout)

    def test_axisd_is_true_to_itself(self):
        status, report = self.twin(self.log)
        self.assertEqual((status, report["fidelity"]["differences"]), (0, []))
        self.assertEqual(report["node"], 5)
        aspects = report["fidelity"]["aspects"]
        self.assertEqual(aspects["sdo_answers"]["same"], 8)
        self.assertGreater(aspects["pdo_words"]["same"], 0)
        self.assertEqual(aspects["nmt_states"]["same"], 1)
        self.assertEqual(list((self.folder / "runtime").glob("axisctl-run*")), [], "nothing is left")

    def test_a_value_that_is_another_one_is_found(self):
        status, report = self.twin(self.changed("585#4B41600031", "585#4B41600033"))
        self.assertEqual(status, DIFFERENT)
        difference, = report["fidelity"]["differences"]
        self.assertEqual((difference["object"], difference["difference"]), ("6041h:00", "value"))

    def test_a_refusal_is_compared_by_its_code(self):
        status, report = self.twin(self.changed("585#8010300000000206", "585#8010300011000906"))
        self.assertEqual((status, report["fidelity"]["differences"][0]["difference"]), (DIFFERENT, "refusal"))

    def test_an_answer_that_the_log_does_not_have_is_found(self):
        status, report = self.twin(self.changed(r".*585#4300100.*\n", ""))
        self.assertEqual((status, report["fidelity"]["differences"][0]["difference"]), (DIFFERENT, "extra"))

    def test_a_pdo_that_is_missing_is_found(self):
        frame = re.search(r".*(185#\w+)\n", pathlib.Path(self.log).read_text())
        status, report = self.twin(self.changed(re.escape(frame[0]), frame[0] + frame[0].replace(frame[1], "185#FFFF")))
        self.assertEqual(status, DIFFERENT)
        self.assertIn(("pdo_words", "missing"), [(d["aspect"], d["difference"]) for d in report["fidelity"]["differences"]])

    def test_differences_that_the_documentation_names_are_known(self):
        status, report = self.twin(self.changed("585#43181003........", "585#4318100377777777"))
        difference, = report["fidelity"]["differences"]
        self.assertEqual((status, difference["known"][:6]), (0, "AXD-01"))
        self.assertEqual(report["fidelity"]["aspects"]["sdo_answers"]["known"], 1)

    def test_a_configuration_is_that_of_the_unit(self):
        config = self.write("unit.json", json.dumps({"axes": [{}, {}]}))
        status, report = self.twin(self.log, "--config", config)
        self.assertEqual(status, 0, report["fidelity"]["differences"])
        wrong = self.axisctl("twin", self.log, "--config", self.write("wrong.json", json.dumps({"axes": 7})))
        self.assertEqual(wrong.returncode, USAGE)
        self.assertIn("--config: /axes", wrong.stderr)

    def test_pdos_are_taken_apart_by_the_eds(self):
        status, report = self.twin(self.log, "--eds", PROGRAMS + "/../share/axisd/eds/axisd.eds")
        self.assertEqual((status, report["fidelity"]["differences"]), (0, []))
        self.assertGreater(report["fidelity"]["aspects"]["pdo_values"]["same"], 0)

    def unit_that_turns(self, **config):
        """A log of a unit with the configuration @p config whose axis turns, and the tallies when axisd as delivered is held against it."""
        folder = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
        bus = f"unix:{folder}/bus"
        master = self.write("turns.log", "".join(f"({100 + at:.6f}) can0 {frame}\n" for at, frame in TURNS))
        log = str(folder / "unit.log")
        self.start("canhub", "--path", bus[5:], "--time", "virtual")
        self.start("axisd", "--interface", bus, "--node-id", "5", "--control", str(folder / "unit.sock"), "--config",
                   self.write("turning.json", json.dumps(config)), "--state-directory", str(folder / "state"))
        played = self.axisctl("replay", master, "--node", "5", "--bus", bus, "--record", log)
        self.assertEqual(played.returncode, 0, played.stderr)
        done = self.axisctl("--json", "twin", log, "--eds", PROGRAMS + "/../share/axisd/eds/axisd.eds")
        report = json.loads(done.stdout.splitlines()[0])["fidelity"]
        self.assertEqual(done.returncode, DIFFERENT if report["differences"] else 0, done.stderr)
        return {name: tally["different"] for name, tally in report["aspects"].items() if tally["different"]}, report["differences"]

    def test_a_unit_that_turns_as_axisd_does_has_no_differences(self):
        self.assertEqual(self.unit_that_turns(axes=[{}]), ({}, []))

    def test_another_inertia_is_found_in_measured_values(self):
        different, found = self.unit_that_turns(axes=[{"load": {"inertia": 0.05}}])
        self.assertGreater(different["pdo_values"], 10)
        self.assertTrue({"6077h:00", "606Ch:00"} & {difference["object"] for difference in found})

    def test_answers_that_are_late_are_found_one_by_one(self):
        different, found = self.unit_that_turns(axes=[{}], inject=[{"kind": "sdo.late", "delay_ms": 80, "times": 3}])
        self.assertEqual(different["sdo_times"], 3, found)

    def test_a_pdo_that_stands_still_is_found(self):
        different, found = self.unit_that_turns(axes=[{}], inject=[{"kind": "tpdo.frozen", "pdo": 2, "after": 40}])
        self.assertGreater(different["pdo_values"], 10, found)
        self.assertEqual({difference["object"] for difference in found if difference["aspect"] == "pdo_values"}, {"606Ch:00"})

    def replay_under(self, mode):
        """What a replay under with-can has recorded; the unit is there before it begins."""
        folder = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
        master = self.write("turns.log", "".join(f"({100 + at:.6f}) can0 {frame}\n" for at, frame in TURNS))
        script = (f"axisd --interface unix:$CAN_BUS --node-id 5 --control {folder}/unit.sock --state-directory {folder}/state & unit=$!; "
                  f"axisctl --socket {folder}/unit.sock wait ready --timeout 30 && "
                  f"axisctl replay {master} --node 5 --bus unix:$CAN_BUS --record {folder}/run.log; status=$?; kill $unit; wait $unit; exit $status")
        process = subprocess.Popen([f"{PROGRAMS}/with-can", "--private", "--time", mode, "--", "sh", "-c", script], stdout=subprocess.PIPE,
                                   stderr=subprocess.STDOUT, text=True, start_new_session=True,
                                   env={**self.environment, "PATH": f"{PROGRAMS}:{os.environ['PATH']}"})
        try:
            said = process.communicate(timeout=PATIENCE_S)[0]
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            raise
        self.assertEqual(process.returncode, 0, said)
        return (folder / "run.log").read_text()

    def test_a_replay_under_with_can_is_the_same_every_time(self):
        log = self.replay_under("virtual")
        self.assertGreater(len(log.splitlines()), 400)
        self.assertEqual(self.replay_under("virtual"), log)

    def test_a_replay_under_with_can_lives_by_scaled_time(self):
        lines = self.replay_under("scaled=5").splitlines()
        begin, end = (float(re.match(r"\((\S+)\)", line)[1]) for line in (lines[0], lines[-1]))
        self.assertGreaterEqual(end - begin, TURNS[-1][0] - TURNS[0][0])
        self.assertEqual(sum("605#" in line for line in lines), len(TURNS) - 1)

    def test_a_replay_ends_by_a_signal_though_time_stands(self):
        self.expect_interrupted_replay()

    def test_a_replay_under_with_can_ends_by_a_signal_though_time_stands(self):
        self.expect_interrupted_replay(f"{PROGRAMS}/with-can", "--time", "stepped")

    def expect_interrupted_replay(self, *wrapper):
        folder = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
        bus = f"{folder}/bus"
        self.start("canhub", "--path", bus, "--time", "stepped")
        wrapped = [*wrapper, "--bus", bus, "--"] if wrapper else []
        replay = subprocess.Popen([*wrapped, f"{PROGRAMS}/axisctl", "replay", self.log, "--bus", f"unix:{bus}"],
                                  stderr=subprocess.PIPE, text=True, env=self.environment)
        try:
            state = [f"{PROGRAMS}/canhub", "--path", bus, "--status"]
            deadline = time.monotonic() + PATIENCE_S
            while "port " not in (said := subprocess.run(state, capture_output=True, text=True, check=False).stdout) or \
                    not takes_interrupts(replay.pid):
                self.assertLess(time.monotonic(), deadline, said)
            replay.send_signal(signal.SIGINT)
            said = replay.communicate(timeout=PATIENCE_S)[1]
            self.assertEqual((replay.returncode, "interrupted" in said), (DIFFERENT, True), said)
        finally:
            replay.kill()
            replay.communicate()

    def test_a_report_is_written(self):
        report = str(self.folder / "report.txt")
        done = self.axisctl("twin", self.log, *LATE, "--report", report)
        self.assertEqual(pathlib.Path(report).read_text(), done.stdout)

    def test_logs_are_compared(self):
        self.assertEqual(self.axisctl("compare", self.log, self.log).returncode, 0)
        done = self.axisctl("--json", "compare", self.log, self.changed("585#4B41600031", "585#4B41600033"))
        self.assertEqual(done.returncode, DIFFERENT)
        difference = json.loads(done.stdout.splitlines()[0])["difference"]
        self.assertEqual(difference["bytes"], [{"byte": 4, "a": 0x31, "b": 0x33, "bits": 2}])

    def test_exit_statuses_say_what_was_wrong(self):
        damaged = self.write("damaged.log", "(1.0) can0 000#0105\nnothing\n(2.0) can0 001#\n")
        empty = self.write("empty.log", "")
        for status, words in ((NOT_THERE, ["compare", self.log, "/no/such/file"]), (DAMAGED, ["compare", self.log, damaged]),
                              (USAGE, ["compare", self.log, self.log, "--time", "soon"]), (DAMAGED, ["twin", empty]),
                              (USAGE, ["replay", self.log]), (NOT_REACHABLE, ["replay", self.master, "--bus", "no-such-bus"]),
                              (NOT_THERE, ["twin", self.log, "--eds", "/no/such/file"]), (USAGE, ["twin", self.log, "--band", "speed"])):
            with self.subTest(words=words):
                done = self.axisctl(*words)
                self.assertEqual((done.returncode, len(done.stderr.splitlines())), (status, 1), done.stderr)

    def test_what_is_odd_in_a_log_is_said(self):
        text = pathlib.Path(self.log).read_text()
        cut = self.write("cut.log", text[:-7])
        done = self.axisctl("replay", cut, "--bus", self.bus)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, r"cut.log:\d+: the (log is cut|last line has no end)")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
