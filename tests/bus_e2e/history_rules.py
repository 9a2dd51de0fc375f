"""That history.py finds what it looks for: logs that are right, and each of them spoilt in one way.

usage: history_rules.py [PROGRAMS]
"""

import pathlib
import tempfile

from history import History, Log

# Two hosts: 1 sends on a, where r reads too; 2 sends on b, which is cut between its frames 2 and 4. Times in ms.
A = ["S 1 0 10", "R 1 1 1 12 0 13", "R 2 1 0 22 0 23", "R 2 2 0 32 0 33", "S 2 0 40", "R 1 2 1 42 0 43", "S 3 0 50", "R 1 3 1 52 0 53",
     "R 2 4 0 72 0 73"]
R = [line.replace(" 1 12", " 0 12").replace(" 1 42", " 0 42").replace(" 1 52", " 0 52") for line in A if line[0] == "R"]
B = ["R 1 1 0 12 0 13", "S 1 0 20", "R 2 1 1 22 0 23", "S 2 0 30", "R 2 2 1 32 0 33", "S 3 0 39", "D 45", "S 0 100 46",
     "R 1 3 0 52 0 53", "S 4 0 70", "R 2 4 1 72 0 73"]


def spoil(lines, old, new):
    assert old in lines, old
    return [part for line in lines for part in ((new if isinstance(new, list) else [new]) if line == old else [line])]


# What is spoilt, and what must be said of it; nothing: the logs are right.
CASES = [
    ("nothing is wrong", A, R, B, None),
    ("a frame is missing", A, spoil(R, "R 2 1 0 22 0 23", []), B, "1 frames are missing from (2, 1) on, 0 are counted"),
    ("a frame is lost and counted", A, spoil(R[:-1], "R 1 2 0 42 0 43", [])[:3] + ["R 1 3 0 52 1 53", "R 2 4 0 72 1 73"], B, None),
    ("a loss is counted that is none", A, R[:-1] + ["R 2 4 0 72 1 73"], B, "0 frames are missing"),
    ("two frames change places", A, [R[1], R[0], *R[2:]], B, "(1, 1) behind (2, 1)"),
    ("a frame comes twice", A, R[:2] + R[1:], B, "(2, 1) a second time"),
    ("a frame comes twice behind another one", A, R[:3] + R[1:], B, "(2, 1) behind (2, 2)"),
    ("times differ", A, spoil(R, "R 2 1 0 22 0 23", "R 2 1 0 21 0 23"), B, "elsewhere"),
    ("a frame of nobody", A, R + ["R 2 9 0 80 0 81"], B, "was sent by nobody"),
    ("it could not be sent", A, R, spoil(B, "S 4 0 70", "S 4 105 70"), "could not be sent: errno 105"),
    ("a frame is old", A, R, spoil(B, "S 4 0 70", "S 4 0 -2000"), "s after it was sent"),
    ("a frame from before the cut", A + ["R 2 3 0 74 0 75"], R + ["R 2 3 0 74 0 75"], B + ["R 2 3 1 74 0 75"], "was sent before the cut"),
    ("a confirmation is missing", spoil(A, "R 1 2 1 42 0 43", "R 1 2 0 42 0 43"), R, B, "a frame of 1 is not confirmed"),
    ("a frame of another one is confirmed", A, R[:-1] + ["R 2 4 1 72 0 73"], B, "a frame of 2 is confirmed"),
]


def log_of(folder, name, host, sender, lines):
    path = folder / name
    path.write_text("".join(f"{in_nanoseconds(line)}\n" for line in lines))
    return Log(path, host, 0, sender).read()


def in_nanoseconds(line):
    words = line.split()
    places = {"S": [3], "R": [4, 6], "D": [1]}[words[0]]
    return " ".join(word + "000000" if place in places else word for place, word in enumerate(words))


def main():
    with tempfile.TemporaryDirectory() as name:
        for case, a, r, b, expected in CASES:
            folder = pathlib.Path(name)
            logs = [log_of(folder, "a", "a", 1, a), log_of(folder, "r", "a", 0, r), log_of(folder, "b", "b", 2, b)]
            problems = History(logs).problems
            if expected is None:
                assert not problems, (case, problems)
            else:
                assert any(expected in problem for problem in problems), (case, problems)


main()
