# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""What a row of the platform file is compared with, and the verdict."""

import dataclasses
import datetime

MOST, LEAST = "at most", "at least"
ROWS = {}  # (table, key) -> Method, in the order in which they are defined


@dataclasses.dataclass(frozen=True)
class Seen:
    """A measured value, and where it is."""
    value: float
    log: str
    time: float  # UTC, s


@dataclasses.dataclass(frozen=True)
class Method:
    """How a row is measured."""
    measure: callable  # of a log and the platform: yields pairs (value, UTC s)
    limit: str
    needs: str  # what a log must contain for it

    @property
    def text(self):
        return " ".join(self.measure.__doc__.split())


@dataclasses.dataclass(frozen=True)
class Line:
    """A line of the table."""
    row: str
    assumed: float | str | None  # a range is text
    seen: Seen | None
    margin: float | None
    verdict: str


HOLDS, BROKEN, NOT_HERE = "holds", "BROKEN", "not in these logs"


def row(table, key, limit, needs):
    """Declares the function below it as the method of a row: it yields pairs (value, UTC s) from one log."""
    def declare(measure):
        ROWS[table, key] = Method(measure, limit, needs)
        return measure
    return declare


def worst(limit, logs, pairs_of):
    """The worst value that `pairs_of` yields from any of the logs; None if it yields nothing."""
    seen = [Seen(value, log.name, time) for log in logs for value, time in pairs_of(log)]
    choose = min if limit == LEAST else max
    return choose(seen, key=lambda s: s.value) if seen else None


def judge(name, assumed, limit, seen, needs):
    """The line of a row that must not be broken."""
    if seen is None:
        return Line(name, assumed, None, None, f"{NOT_HERE}: {needs}")
    margin = seen.value - assumed if limit == LEAST else assumed - seen.value
    return Line(name, assumed, seen, margin, HOLDS if margin >= 0 else BROKEN)


def number(value):
    return value if isinstance(value, str) else "" if value is None else f"{value:.4g}"


def place(seen):
    if seen is None:
        return "", ""
    time = datetime.datetime.fromtimestamp(seen.time, datetime.timezone.utc)
    return seen.log, time.strftime("%Y-%m-%d %H:%M:%S")


def table(lines):
    """The lines as text, in columns."""
    cells = [("row", "assumed", "worst seen", "log", "UTC", "margin", "verdict")]
    cells += [(x.row, number(x.assumed), number(x.seen and x.seen.value), *place(x.seen), number(x.margin), x.verdict)
              for x in lines]
    widths = [max(map(len, column)) for column in zip(*cells)]
    right = (1, 2, 5)
    return "\n".join(
        "  ".join(cell.rjust(w) if i in right else cell.ljust(w) for i, (cell, w) in enumerate(zip(line, widths))).rstrip()
        for line in cells)
