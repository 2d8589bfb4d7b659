# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""The table by kind, as text and CSV, and how it is held to one that was committed."""

import collections
import csv

from mutants_parts.kinds import KINDS

OUTCOMES = ("error", "warning", "promise", "flight", "equivalent", "missed", "escape")
COLUMNS = ("planted", "error", "warning", "promise", "flight", "equivalent", "missed", "escapes")


def by_kind(fates):
    """Rows of numbers in the order of COLUMNS, by kind; a missed mutant that misbehaves counts as an escape too."""
    rows = {}
    for kind in KINDS:
        counts = collections.Counter(f.outcome for f in fates if f.mutant.kind == kind)
        if counts:
            escapes = counts["escape"]
            rows[kind] = (sum(counts.values()), counts["error"], counts["warning"], counts["promise"],
                          counts["flight"], counts["equivalent"], counts["missed"] + escapes, escapes)
    rows["all"] = tuple(map(sum, zip(*rows.values())))
    return rows


def print_table(rows):
    print(f"{'kind':<26}" + "".join(f"{name:>11}" for name in COLUMNS))
    for kind, row in rows.items():
        print(f"{kind:<26}" + "".join(f"{number:>11}" for number in row))


def write_table(rows, path):
    with open(path, "w", newline="", encoding="utf-8") as file:
        file.write("# SPDX-FileCopyrightText: 2026 The glidercc authors\n# SPDX-License-Identifier: Apache-2.0\n")
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(("kind", *COLUMNS))
        writer.writerows((kind, *row) for kind, row in rows.items())


def write_each(fates, path):
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(("mutant", "line", "change", "outcome", "diagnostics", "rule", "what", "world"))
        for f in fates:
            world = f"{f.world[0]} seed {f.world[1]}" if f.world else ""
            writer.writerow((f.mutant.name, f.mutant.line, f.mutant.change, f.outcome, " ".join(f.ids), f.rule, f.words,
                             world))


def held(rows, path):
    """What has become worse than the table at `path`: more escapes of a kind or in all, or fewer mutants caught."""
    with open(path, newline="", encoding="utf-8") as file:
        committed = {row["kind"]: row for row in csv.DictReader(line for line in file if not line.startswith("#"))}
    escapes = COLUMNS.index("escapes")
    for kind, row in rows.items():
        before = int(committed[kind]["escapes"]) if kind in committed else 0
        if row[escapes] > before:
            yield f"{kind}: {row[escapes]} escapes, {before} were committed"
    caught_by = ("error", "warning", "promise", "flight")
    caught = sum(int(committed["all"][name]) for name in caught_by)
    now = sum(rows["all"][COLUMNS.index(name)] for name in caught_by)
    if now < caught:
        yield f"all: {now} caught, {caught} were committed"
