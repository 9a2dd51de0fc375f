"""What measurements are held against: cells of the tables of docs/explanation/performance.md, and their limits."""
import operator
import re
from dataclasses import dataclass

AT_MOST, AT_LEAST = "at most", "at least"
HOLDS = {AT_MOST: operator.le, AT_LEAST: operator.ge}


@dataclass(frozen=True)
class Goal:
    """`relation` to `limit` of the cell in `column` of each row of `part`, `rows` of them at least, in which every pattern of `row`
    is found in some cell; in the table at `place` among those of the part (-1: in any)."""

    what: str
    part: str
    row: tuple
    column: str
    relation: str
    limit: float
    place: int = -1
    rows: int = 1


UNIT, STEP = 0, 1  # tables of `physics`
ALL_HEAR = "members, all hear a frame"
GOALS = (
    Goal("step of an axis, SSE2, times that of each by itself", "physics", ("baseline",),
         "times as fast as each by itself", AT_LEAST, 2.0, STEP),
    Goal("step of an axis, AVX2, likewise", "physics", ("^AVX2$",), "times as fast as each by itself", AT_LEAST, 3.5, STEP),
    Goal("unit of 8 axes, AVX2, times real time", "physics", ("^AVX2$",), "times real time", AT_LEAST, 400, UNIT),
    Goal("cycle of 8 axes, 4 ms, SSE2, of each by itself", "cycles", ("a cycle of 4 ms", "baseline"), "of each by itself",
         AT_MOST, 0.6),
    Goal("cycle of 8 axes, 4 ms, AVX2, likewise", "cycles", ("a cycle of 4 ms", "^AVX2$"), "of each by itself", AT_MOST, 0.45),
    Goal("127 units turning in one process, % of a processor", "many", (), "turning: axisd (%)", AT_MOST, 30),
    *(Goal(f"hub, {count} {ALL_HEAR}, of plain fan-out", "hub", (f"^{count} {ALL_HEAR}$",), "ratio", AT_MOST, 1.10)
      for count in (2, 8, 32, 127)),
    Goal("hub, 127 members, bursts of 32, us a frame", "hub", ("127 members, 32 frames in one message",), "CPU (us)", AT_MOST, 30),
    Goal("hub, a frame that one of 127 hears, of one of 2", "hub", ("a frame that one hears",), "ratio", AT_MOST, 1.5),
    Goal("canopen-check against axisd, s", "check", ("^axisd$", "^this$"), "real time (s)", AT_MOST, 10),
    Goal("canopen-audit, a million frames, s", "audit", ("^1,000,000$",), "real time (s)", AT_MOST, 2, rows=2),
    Goal("canopen-audit, memory, MB", "audit", (), "RSS (MB)", AT_MOST, 16, rows=3),
    Goal("flood of 50,000, lost", "flood", ("^50000$",), "lost", AT_MOST, 0, rows=6),
    Goal("memory of one axis, RSS, MB", "start", ("^1$",), "RSS (MB)", AT_MOST, 4.5),
    Goal("SDO upload on a bus, of poll, read and write", "bus", ("^SDO upload, CPU$",), "axisd", AT_MOST, 1.10),
    Goal("SDO download on a bus, likewise", "bus", ("^SDO download, CPU$",), "axisd", AT_MOST, 1.10),
    Goal("SDO download to eight axes, likewise", "bus", ("^eight axes: SDO download, CPU$",), "axisd", AT_MOST, 1.10),
    Goal("SYNC to 32 TPDOs, likewise", "bus", ("^SYNC to 32 TPDOs, CPU$",), "axisd", AT_MOST, 1.04),
    Goal("idle, likewise", "bus", ("^idle with a heartbeat",), "axisd", AT_MOST, 1.3),
)


def tables(text):
    """Each table as its header and its rows."""
    found, rows, before = [], None, ""
    for line in text.splitlines():
        if not line.startswith("|"):
            rows = None
        elif rows is not None:
            rows.append(cells(line))
        elif re.fullmatch(r"\|[ :|-]+\|", line):
            rows = []
            found.append((cells(before), rows))
        before = line
    return found


def cells(line):
    return [cell.strip() for cell in line[1:-1].split("|")]


def number_of(cell):
    """The number that a cell ends with, or that it has in brackets: a ratio."""
    found = re.search(r"\((-?[\d.,]+)\)$", cell) or re.search(r"(-?[\d.,]+)$", cell)
    return float(found[1].replace(",", "")) if found else None


def values(goal, content):
    """The numbers that `goal` speaks of."""
    found = tables(content)
    for header, rows in found if goal.place < 0 else found[goal.place:goal.place + 1]:
        if goal.column not in header:
            continue
        column = header.index(goal.column)
        for row in rows:
            is_meant = len(row) == len(header) and all(any(re.search(part, cell) for cell in row) for part in goal.row)
            value = number_of(row[column]) if is_meant else None
            if value is not None:
                yield value


def judge(contents, goals):
    """A table of what is reached, and whether all is."""
    lines, reached = ["| | measured | goal | |", "|---|---:|---:|---|"], True
    for goal in goals:
        found = list(values(goal, contents.get(goal.part, "")))
        worst = (max if goal.relation == AT_MOST else min)(found) if len(found) >= goal.rows else None
        holds = worst is not None and HOLDS[goal.relation](worst, goal.limit)
        reached = reached and holds
        told = "not measured" if worst is None else f"{worst:g}"
        verdict = "" if worst is None else "reached" if holds else "**not reached**"
        lines.append(f"| {goal.what} | {told} | {goal.relation} {goal.limit:g} | {verdict} |")
    return "\n".join(lines), reached
