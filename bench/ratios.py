# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""The ratios of a benchmark: how it passes them on, the committed table of them, and what counts as worse.

Only ratios are kept: of two things measured in turn in one run, or of a count to a limit. A time by itself says more
about the machine than about glidercc.
"""

import csv
import dataclasses
import os
import sys

FIELDS = ("bench", "case", "ratio", "better", "runs", "seed", "commit")
# A case is worse if it is so many times as bad as the table says.
WORSE = 1.2
# scripts/bench names the file that a bench adds its rows to.
ENVIRONMENT = "GLIDER_BENCH_RATIOS"


@dataclasses.dataclass(frozen=True)
class Row:
    """One ratio; `better` is "lower" or "higher"."""

    bench: str
    case: str
    ratio: float
    better: str
    runs: str
    seed: str
    commit: str = ""

    @property
    def key(self):
        return self.bench, self.case


def note(bench, case, ratio, better="lower", runs="1", seed="none"):
    """Adds a row to the file that scripts/bench asks for; does nothing if a bench runs by itself."""
    path = os.environ.get(ENVIRONMENT)
    if path:
        with open(path, "a", newline="", encoding="utf-8") as file:
            csv.writer(file).writerow((bench, case, f"{ratio:.4g}", better, runs, seed, ""))


def read(path):
    """The rows of a table with or without a head; ValueError names the line that is wrong."""
    rows = []
    with open(path, newline="", encoding="utf-8") as file:
        for number, fields in enumerate(csv.reader(file), 1):
            if not fields or fields[0].startswith("#") or tuple(fields) == FIELDS:
                continue
            try:
                row = Row(fields[0], fields[1], float(fields[2]), *fields[3:7])
            except (IndexError, TypeError, ValueError):
                row = None
            if row is None or row.better not in ("lower", "higher") or not 0 < row.ratio < float("inf"):
                raise ValueError(f"{path}:{number}: not a row of {','.join(FIELDS)}")
            rows.append(row)
    return rows


def write(path, rows, head):
    with open(path, "w", newline="", encoding="utf-8") as file:
        file.writelines(f"# {line}\n" for line in head)
        table = csv.writer(file, lineterminator="\n")
        table.writerow(FIELDS)
        table.writerows((r.bench, r.case, f"{r.ratio:.4g}", r.better, r.runs, r.seed, r.commit) for r in rows)


def times_worse(before, now):
    """How many times as bad as `before` a row is; 1 is as good."""
    return now.ratio / before.ratio if before.better == "lower" else before.ratio / now.ratio


def findings(committed, measured):
    """Lines about what is worse by WORSE, or is no longer measured, of the benches that were measured."""
    now = {row.key: row for row in measured}
    benches = {row.bench for row in measured}
    for before in committed:
        if before.bench not in benches:
            continue
        if before.key not in now:
            yield f"{before.bench}: {before.case}: in the table ({before.ratio:.4g}), but no longer measured"
        elif times_worse(before, now[before.key]) >= WORSE:
            yield (f"{before.bench}: {before.case}: {now[before.key].ratio:.4g}, was {before.ratio:.4g} at "
                   f"{before.commit or 'an unknown commit'} ({before.better} is better): "
                   f"{100 * (times_worse(before, now[before.key]) - 1):.0f} % worse")


def print_beside(committed, measured, out=sys.stdout):
    """Every measured ratio beside the committed one."""
    before = {row.key: row for row in committed}
    print(f"{'bench':<10}{'case':<66}{'ratio':>10}{'table':>10}", file=out)
    for row in measured:
        old = before.get(row.key)
        print(f"{row.bench:<10}{row.case:<66}{row.ratio:>10.4g}{f'{old.ratio:.4g}' if old else 'new':>10}", file=out)
