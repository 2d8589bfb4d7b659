# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""What a run prints and writes."""

import collections
import csv
import dataclasses
import json

OUTCOMES = ("refused", "equivalent", "accepted", "killed", "alive")


@dataclasses.dataclass
class Fate:
    key: str
    path: str
    line: int
    operator: str
    before: str
    after: str
    tags: list
    outcome: str  # of OUTCOMES
    by: str = ""  # the test that failed, or why the mutant is exempt


def fate_of(mutant, outcome, by=""):
    return Fate(mutant.key, mutant.path, mutant.line, mutant.operator, mutant.before, mutant.after, sorted(mutant.tags),
                outcome, by)


def rows(fates, column):
    table = collections.defaultdict(collections.Counter)
    for fate in fates:
        table[column(fate)][fate.outcome] += 1
    return [(name, table[name]) for name in sorted(table)]


def folder(fate):
    parts = fate.path.split("/")
    return "/".join(parts[:2]) if len(parts) > 2 else parts[0]


def print_table(fates, column, title):
    """Planted are those that compile; per cent: the living of those that could die."""
    print(f"{title:<24} planted  not compiled  equivalent  accepted  killed  alive  alive %")
    listed = rows(fates, column)
    total = sum((c for _, c in listed), collections.Counter())
    for name, c in listed + [("all", total)]:
        planted = sum(c.values()) - c["refused"]
        could = c["killed"] + c["alive"]
        share = f"{100 * c['alive'] / could:7.1f}" if could else "      -"
        print(f"{name:<24} {planted:>7}  {c['refused']:>12}  {c['equivalent']:>10}  {c['accepted']:>8}  {c['killed']:>6}  "
              f"{c['alive']:>5}  {share}")


def print_living(fates):
    for f in fates:
        if f.outcome == "alive":
            tags = f" [{' '.join(f.tags)}]" if f.tags else ""
            print(f"\n{f.path}:{f.line}: {f.operator}{tags}\n  - {f.before}\n  + {f.after}")


def write_csv(fates, path):
    with open(path, "w", newline="", encoding="utf-8") as out:
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(("file", "line", "operator", "outcome", "by", "before", "after"))
        writer.writerows((f.path, f.line, f.operator, f.outcome, f.by, f.before, f.after) for f in fates)


def write_json(fates, path):
    with open(path, "w", encoding="utf-8") as out:
        json.dump([dataclasses.asdict(f) for f in fates], out, indent=1)


class Journal:
    """The fates of a run as they are known, one a line, for another run that goes on."""

    def __init__(self, path):
        self.path = path
        self.known = {}
        if path and path.is_file():
            for line in path.read_text(encoding="utf-8").splitlines():
                try:
                    fate = Fate(**json.loads(line))
                except (ValueError, TypeError):
                    continue  # the line that was being written when the run was killed
                self.known[fate.key] = fate

    def add(self, fate):
        if self.path:
            with self.path.open("a", encoding="utf-8") as out:
                out.write(json.dumps(dataclasses.asdict(fate)) + "\n")
