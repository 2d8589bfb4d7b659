# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""Which files are taken, which mutants there are, and which of them a run tries."""

import csv
import dataclasses
import hashlib
import itertools
import subprocess

from mutants_code_parts.operators import OPERATORS
from mutants_code_parts.source import ROOT, Source
from mutants_code_parts.suites import SUITES, suites_of

FOLDERS = sorted({prefix.split("/")[0] for prefix in SUITES})
EXEMPT = ROOT / "tests/mutants_code/exempt.csv"


@dataclasses.dataclass(frozen=True)
class Mutant:
    path: str
    function: str
    line: int
    operator: str
    before: str  # the lines as they stand, in one line
    after: str
    begin: int
    end: int
    replacement: str
    tags: frozenset

    @property
    def key(self):
        """Names the fault wherever in the file its line stands."""
        return " | ".join((self.path, self.function, self.operator, self.before, self.after))

    @property
    def folder(self):
        return self.path.rsplit("/", 1)[0]


def files(only=()):
    """The sources and headers of the folders that have tests here; `only`: files or folders."""
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", *FOLDERS], capture_output=True, text=True, check=True).stdout
    chosen = [f for f in listed.splitlines() if f.endswith((".cpp", ".h", ".c", ".def")) and suites_of(f)]
    if only:
        chosen = [f for f in chosen if any(f == o or f.startswith(o.rstrip("/") + "/") for o in only)]
    return [f for f in chosen if (ROOT / f).is_file()]


def mutants_of(source):
    """Every mutant of a source, in the order of the operators."""
    seen = set()
    for name, operator in OPERATORS.items():
        for begin, end, replacement in operator(source):
            whole_begin = source.start_of(source.line_of(begin))
            whole_end = source.text.find("\n", end)
            whole_end = len(source.text) if whole_end < 0 else whole_end
            before = " ".join(source.text[whole_begin:whole_end].split())
            after = " ".join((source.text[whole_begin:begin] + replacement + source.text[end:whole_end]).split())
            line = source.line_of(begin)
            if before == after or (line, after) in seen:
                continue
            seen.add((line, after))
            tags = frozenset(t for n in range(line, source.line_of(end) + 1) for t in source.tags.get(n, ()))
            yield Mutant(source.path, source.function_at(line), line, name, before, after, begin, end, replacement, tags)


def all_mutants(paths):
    return [m for path in paths for m in mutants_of(Source(path))]


def pick(found, count, seed):
    """`count` of the mutants (0: all): from each operator in turn the next in an order that the seed gives. The order
    hangs on the fault alone, so that a line more or less elsewhere changes little."""

    def rank(mutant):
        return hashlib.sha256(f"{seed}/{mutant.key}".encode()).digest()

    by_operator = [sorted((m for m in found if m.operator == o), key=rank) for o in OPERATORS]
    in_turn = [m for row in itertools.zip_longest(*by_operator) for m in row if m is not None]
    return in_turn[:count] if count else in_turn


def exempt():
    """Key → (verdict, reason) of what cannot or need not die: `equivalent`, or `accepted` with a reason."""
    return {" | ".join((r["file"], r["function"], r["operator"], r["before"], r["after"])): (r["verdict"], r["reason"])
            for r in _exempt_rows()}


def _exempt_rows():
    with EXEMPT.open(newline="", encoding="utf-8") as table:
        return list(csv.DictReader(table))


def unknown_names(table, named):
    """What a table names and the sources do not have. `named`: pairs of a file and a function in it."""
    functions = {}
    for path, function in named:
        functions.setdefault(path, set()).add(function)
    for path, names in functions.items():
        if not (ROOT / path).is_file():
            yield f"{table}: there is no file {path}"
            continue
        for name in sorted(names - Source(path).functions()):
            yield f"{table}: {path} has no function {name}"


def unknown_exempt():
    """The files and functions of exempt.csv that are not there."""
    return unknown_names(EXEMPT.relative_to(ROOT), ((row["file"], row["function"]) for row in _exempt_rows()))


def outlived(found, paths):
    """Exempt faults of these files that are not among all that there are: their lines have changed."""
    there = {m.key for m in found}
    return [key for key in exempt() if key.split(" | ")[0] in paths and key not in there]


def planted(mutant):
    """The text of the file with the fault."""
    text = (ROOT / mutant.path).read_text(encoding="utf-8")
    return text[:mutant.begin] + mutant.replacement + text[mutant.end:]
