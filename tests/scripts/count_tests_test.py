"""scripts/count-tests: what it prints for runs that went well, badly, and not at all."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

COUNT_TESTS = Path(__file__).parents[2] / "scripts" / "count-tests"


def junit(**statuses):
    return "<testsuite>" + "".join(f'<testcase name="{name}" status="{status}"/>' for name, status in statuses.items()) + "</testsuite>"


def report(*results):
    """Of GoogleTest; each of `results` is completed, failed, skipped or disabled."""
    cases = {
        "completed": '<testcase name="A" status="run" result="completed"/>',
        "failed": '<testcase name="A" status="run" result="completed"><failure message="no"/></testcase>',
        "skipped": '<testcase name="A" status="run" result="skipped"><skipped message="no"/></testcase>',
        "disabled": '<testcase name="A" status="notrun" result="suppressed"/>',
    }
    return "<testsuites><testsuite>" + "".join(cases[result] for result in results) + "</testsuite></testsuites>"


class CountTests(unittest.TestCase):
    def counted(self, account, programs=(), reports=None, printed=None):
        """The lines that it prints."""
        with tempfile.TemporaryDirectory() as folder:
            folder = Path(folder)
            if account is not None:
                (folder / "junit").write_text(account)
            for name, text in (reports or {}).items():
                (folder / f"{name}.xml").write_text(text)
            options = []
            if printed is not None:
                (folder / "printed").write_text(printed)
                options = ["--printed", folder / "printed"]
            return subprocess.run([sys.executable, COUNT_TESTS, *options, folder / "junit", folder, *programs], check=True,
                                  capture_output=True, text=True).stdout.splitlines()

    def test_one_a_test_of_ctest(self):
        self.assertEqual(self.counted(junit(a="run", b="run")), ["2 0"])

    def test_the_tests_within_a_program_stand_for_it(self):
        self.assertEqual(self.counted(junit(a="run", b="run"), ["b"], {"b": report("completed", "completed")}), ["3 0"])

    def test_a_test_that_did_not_pass_is_named(self):
        self.assertEqual(self.counted(junit(a="fail", b="notrun", c="disabled", d="run")),
                         ["a: fail", "b: notrun", "c: disabled", "1 3"])

    def test_failures_within_a_program_are_counted_once(self):
        self.assertEqual(self.counted(junit(a="fail"), ["a"], {"a": report("completed", "failed", "skipped", "disabled")}),
                         ["a: 3 of 4 tests failed", "1 3"])

    def test_a_program_that_failed_after_its_tests_has_failed(self):
        self.assertEqual(self.counted(junit(a="fail"), ["a"], {"a": report("completed", "completed")}),
                         ["a: 2 tests passed, but the program ended with a failure", "2 1"])

    def test_a_program_without_a_report_has_failed(self):
        self.assertEqual(self.counted(junit(a="run"), ["a"]), ["a: has left no count of its tests", "0 1"])
        self.assertEqual(self.counted(junit(a="run"), ["a"], {"a": "<testsuites>"}),
                         ["a: has left no count of its tests", "0 1"])

    def test_a_program_without_a_test_has_failed(self):
        self.assertEqual(self.counted(junit(a="run"), ["a"], {"a": report()}), ["a: has no test", "0 1"])

    def test_a_program_that_was_not_run_has_failed(self):
        self.assertEqual(self.counted(junit(b="run"), ["a"], {"a": report("completed")}), ["a: was not run", "1 1"])

    def test_a_test_that_passed_when_repeated_is_named_and_has_passed(self):
        printed = ("1/3 Test #1: a.one ....   Passed    0.01 sec\n2/3 Test #2: b.two ....***Failed    0.01 sec\n"
                   "    Test #2: b.two ....***Timeout   0.01 sec\n    Test #2: b.two ....   Passed    0.01 sec\n"
                   "3/3 Test #3: c ....***Failed    0.01 sec\n")
        account = junit(**{"a.one": "run", "b.two": "run", "c": "fail"})
        self.assertEqual(self.counted(account, printed=printed),
                         ["c: fail", "b.two: failed, and passed when it was repeated", "2 1"])
        self.assertEqual(self.counted(junit(a="run"), printed=""), ["1 0"])

    def test_a_run_of_nothing_has_failed(self):
        self.assertEqual(self.counted(junit()), ["no test was run", "0 1"])
        self.assertTrue(self.counted(None)[0].startswith("ctest has left no account of its run: "))
        self.assertEqual(self.counted(None)[1:], ["0 1"])


if __name__ == "__main__":
    unittest.main()
