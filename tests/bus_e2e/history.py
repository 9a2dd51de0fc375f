"""Whether what the members of a bus have seen is the history of one bus, by the logs of bus_member.py and the figures of the hubs.

One order for all, nothing twice, nothing late, a gap only where the member was told of a cut or has lost so much itself, every
frame that was sent confirmed or counted.
"""

import bisect
import collections

# How old a frame may be when it passes: half a second on its way to the hub, which did not run, and half a second
# on its way to the stream.
OLDEST = 1.0  # s
SECOND = 10**9

Sent = collections.namedtuple("Sent", "number errno time line")
Seen = collections.namedtuple("Seen", "sender number own stamp dropped time line part")
Cut = collections.namedtuple("Cut", "time line")


class Log:
    """What a member has written so far; HOST names the hub, PROCESS is the member."""

    def __init__(self, path, host, process, sender=0):
        self.path, self.host, self.process, self.sender = path, host, process, sender
        self.sent, self.seen, self.cuts = [], [], []
        self.position, self.lines = 0, 0

    def name(self):
        return self.path.name

    def read(self):
        """Takes what has been written since."""
        with open(self.path, encoding="ascii") as file:
            file.seek(self.position)
            text = file.read()
        whole = text.rfind("\n") + 1
        self.position += whole
        for line in text[:whole].splitlines():
            self._take(line.split())
        return self

    def _take(self, words):
        kind, numbers = words[0], [int(word) for word in words[1:]]
        self.lines += 1
        if kind == "S":
            self.sent.append(Sent(*numbers, self.lines))
        elif kind == "R":
            self.seen.append(Seen(*numbers, self.lines, len(self.cuts)))
        else:
            self.cuts.append(Cut(*numbers, self.lines))

    def taken(self):
        """Frames that it has sent, with success."""
        return [sent for sent in self.sent if sent.errno == 0]

    def confirmed(self):
        return [seen for seen in self.seen if seen.own]


class History:
    """The logs of all members; `problems` is what is wrong, a line each."""

    def __init__(self, logs):
        self.logs, self.problems = logs, []
        self.sent = {(log.sender, sent.number): (log, sent) for log in logs for sent in log.sent}
        self.order = self._common_order()
        self.places = {frame: place for place, frame in enumerate(self.order)}
        for log in logs:
            self._check_order(log)
            self._check_gaps(log)
            self._check_confirmed(log)
            self._check_return(log)

    def _wrong(self, log, text):
        self.problems.append(f"{log.name()}: {text}")

    def _common_order(self):
        """All frames that anybody has seen, by their time stamps. A message of a hub has one, and the frames of one sender."""
        stamps = {}
        for log in self.logs:
            for seen in log.seen:
                frame = (seen.sender, seen.number)
                if stamps.setdefault(frame, seen.stamp) != seen.stamp:
                    self._wrong(log, f"{frame} has the time {seen.stamp}, elsewhere {stamps[frame]}")
        for frame, stamp in stamps.items():
            self._check_age(frame, stamp)
        return sorted(stamps, key=lambda frame: (stamps[frame], *frame))

    def _check_age(self, frame, stamp):
        if frame not in self.sent:
            self.problems.append(f"{frame} was sent by nobody")
            return
        log, sent = self.sent[frame]
        if sent.errno:
            self._wrong(log, f"{frame} has passed, and could not be sent: errno {sent.errno}")
        age = (stamp - sent.time) / SECOND
        if not 0 <= age <= OLDEST:
            self._wrong(log, f"{frame} has passed {age:.3f} s after it was sent")

    def _check_order(self, log):
        last = -1
        for seen in log.seen:
            place = self.places[(seen.sender, seen.number)]
            if place == last:
                self._wrong(log, f"line {seen.line}: {self.order[place]} a second time")
            elif place < last:
                self._wrong(log, f"line {seen.line}: {self.order[place]} behind {self.order[last]}")
            last = max(last, place)

    def _check_gaps(self, log):
        for before, seen in zip(log.seen, log.seen[1:]):
            if before.part != seen.part:
                continue
            first, last = (self.places[(each.sender, each.number)] for each in (before, seen))
            gap, lost = last - first - 1, seen.dropped - before.dropped
            if gap != lost and last > first:
                self._wrong(log, f"line {seen.line}: {gap} frames are missing from {self.order[first + 1]} on, {lost} are counted")

    def _check_confirmed(self, log):
        for seen in log.seen:
            if bool(seen.own) != (seen.sender == log.sender):
                self._wrong(log, f"line {seen.line}: a frame of {seen.sender} is {'' if seen.own else 'not '}confirmed")

    def _check_return(self, log):
        """Nothing that was sent on this host before a cut showed there comes behind it."""
        times = [cut.time for cut in log.cuts]
        for seen in log.seen:
            sender, sent = self.sent.get((seen.sender, seen.number), (None, None))
            if sender is None or sender.host != log.host or seen.part == 0:
                continue
            is_before = sent.line < log.cuts[seen.part - 1].line if sender is log else bisect.bisect(times, sent.time) < seen.part
            if is_before:
                self._wrong(log, f"line {seen.line}: {(seen.sender, seen.number)} was sent before the cut")

    def compare(self, status_of):
        """What the figures of the hubs, status_of[host], say otherwise, a line each."""
        return [line for host, status in status_of.items() for line in self._compare(host, status, status_of)]

    def _compare(self, host, status, status_of):
        members = [log for log in self.logs if log.host == host]
        taken = sum(len(log.taken()) for log in members)
        confirmed = sum(len(log.confirmed()) for log in members)
        numbered = sum(other.sent + other.dropped for name, other in status_of.items() if name != host)
        whole = max((log for log in members if log.seen[-1].dropped == 0), key=lambda log: len(log.seen))
        own = sum(self.sent[(seen.sender, seen.number)][0].host == host for seen in whole.seen)
        figures = [("under way", status.under_way, 0), ("sent", status.sent, confirmed),
                   ("lost", status.dropped + status.lost, taken - confirmed),
                   ("received", status.received, len(whole.seen) - own),
                   ("of others, received, missed or late", status.received + status.missed + status.late, numbered),
                   ("frames of the bus", status.frames, len(whole.seen))]
        for log in members:
            sent, received, dropped, refused = status.members[log.process]
            figures += [(f"sent by {log.name()}", sent, len(log.taken())), (f"refused of {log.name()}", refused, 0),
                        (f"dropped for {log.name()}", dropped, log.seen[-1].dropped),
                        (f"given to {log.name()}", received, len(log.seen) + len(log.cuts))]
        return [f"host {host}: {what}: the hub counts {counted}, by the logs it is {right}"
                for what, counted, right in figures if counted != right]
