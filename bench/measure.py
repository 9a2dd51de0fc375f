#!/usr/bin/env python3
"""Measures what stands between marks of docs/explanation/performance.md, and writes it there.

usage: measure.py [--build DIR] [--document FILE] [PART]...

DIR has the programs (build/release); everything but the unit tests has to be built. Without a PART all are measured, one after
the other, which takes an hour; a quiet machine tells more. The part `goals` alone measures nothing. What a part prints replaces
what stands in the document between
`<!-- PART: command -->` and `<!-- end of PART -->`. Then the goals are judged by what stands there now, measured this time or
before, and written into the part `goals`. Ends with 1 if a part could not be measured or a goal is not reached.
"""
import argparse
import datetime
import pathlib
import platform
import re
import subprocess
import sys

from goals import GOALS, judge

ROOT = pathlib.Path(__file__).resolve().parents[1]
DOCUMENT = ROOT / "docs" / "explanation" / "performance.md"
MISSED = 3  # exit status of a part: measured, and a goal not reached
#: What each part runs; {build} and {bin} are the build and the folder of its programs.
PARTS = {
    "physics": "{bin}/axes_speed",
    "cycles": "{bin}/cycle_speed",
    "start": "bench/start_cost.py {bin}",
    "check": "bench/check_cost.py {bin} --checks 0",
    "audit": "bench/audit_cost.py {bin}",
    "hub": "bench/hub_cost.sh --build {build}",
    "units": "bench/fleet_cost.py {bin} --curve",
    "many": "bench/fleet_cost.py {bin} --units 127",
    "processes": "bench/fleet_cost.py {bin} --units 127 --processes",
    "flood": "bench/flood.sh --build {build}",
    "bus": "bench/bus_cost.sh --build {build} --quick",
    "instructions": "bench/callgrind.sh --build {build}",
}
TOLD = {"build": "build/release", "bin": "build/release/bin"}


def processor():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.machine()


def measured(part, build):
    """What the part has printed; None if it failed."""
    words = PARTS[part].format(build=build, bin=f"{build}/bin").split()
    run = subprocess.run(words, cwd=ROOT, stdout=subprocess.PIPE, text=True, check=False)
    if run.returncode not in (0, MISSED) or not run.stdout.strip():
        print(f"measure.py: {part}: {' '.join(words)} ended with {run.returncode}", file=sys.stderr)
        return None
    return f"{run.stdout.strip()}\n\n{processor()}, {datetime.date.today().isoformat()}"


def replaced(text, part, content):
    """The document with `content` as that part."""
    told = PARTS.get(part, "bench/goals.py").format(**TOLD)
    block = f"<!-- {part}: {told} -->\n\n{content}\n\n<!-- end of {part} -->"
    found = re.compile(rf"<!-- {part}: [^\n]* -->.*?<!-- end of {part} -->", re.DOTALL)
    if not found.search(text):
        sys.exit(f"measure.py: the document has no part {part}")
    return found.sub(lambda _: block, text, count=1)


def content_of(text, part):
    found = re.search(rf"<!-- {part}: [^\n]* -->\n(.*?)<!-- end of {part} -->", text, re.DOTALL)
    return found[1].strip() if found else ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release")
    parser.add_argument("--document", type=pathlib.Path, default=DOCUMENT)
    parser.add_argument("parts", metavar="PART", nargs="*", help=", ".join(PARTS))
    words = parser.parse_args()
    unknown = [part for part in words.parts if part not in PARTS and part != "goals"]
    if unknown:
        parser.error(f"no part {unknown[0]}: expected {', '.join(PARTS)} or goals")
    wanted, failed = [part for part in words.parts if part != "goals"] if words.parts else list(PARTS), False
    for part in (*wanted, "goals"):
        replaced(words.document.read_text(), part, "")  # ends here, and not after an hour, if it has no such part
    for part in wanted:
        print(f"-- {part}", file=sys.stderr, flush=True)
        content = measured(part, words.build.resolve())
        failed = failed or content is None
        if content is not None:
            print(content, flush=True)
            words.document.write_text(replaced(words.document.read_text(), part, content))
    text = words.document.read_text()
    table, reached = judge({part: content_of(text, part) for part in PARTS}, GOALS)
    print(table)
    words.document.write_text(replaced(text, "goals", table))
    return 0 if reached and not failed else 1


if __name__ == "__main__":
    sys.exit(main())
