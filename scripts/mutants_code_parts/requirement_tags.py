# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""The requirements of hookbeh and hookprog, and the code that implements them.

tests/mutants_code/requirements.csv names the functions; a comment in the code that names a requirement adds its line, or the
statement below it.
"""

import csv
import functools
import re

from mutants_code_parts.planting_code import unknown_names
from mutants_code_parts.source import ROOT, Source

FOLDERS = ("hooks/hookbeh", "hooks/hookprog")
TABLE = ROOT / "tests/mutants_code/requirements.csv"


def listed():
    """Requirement → its row's text, of the tables of both READMEs."""
    found = {}
    for folder in FOLDERS:
        for m in re.finditer(r"^\| ((?:HB|HP)-\d+) \| ([^|]*)\|", (ROOT / folder / "README.md").read_text(), re.MULTILINE):
            found[m[1]] = m[2].strip()
    return found


@functools.cache
def implementers():
    """(file, function) → the requirements that it implements."""
    found = {}
    with TABLE.open(newline="", encoding="utf-8") as table:
        for row in csv.DictReader(table):
            for function in row["functions"].split():
                found.setdefault((row["file"], function), set()).add(row["requirement"])
    return found


def unknown():
    """The files and functions of requirements.csv that are not there."""
    return unknown_names(TABLE.relative_to(ROOT), implementers())


def of(mutant):
    """The requirements that the mutant's line implements."""
    return mutant.tags | implementers().get((mutant.path, mutant.function), set())


def findings(paths):
    """What is wrong between tables and tags: a requirement that no code is named for, a tag that no table has."""
    named = {}
    for path in paths:
        for line, tags in Source(path).tags.items():
            for tag in tags:
                named.setdefault(tag, f"{path}:{line}")
    for (path, function), requirements in implementers().items():
        for requirement in requirements:
            named.setdefault(requirement, f"{path}: {function}")
    known = listed()
    for name in sorted(known.keys() - named.keys()):
        yield f"{name} ({known[name]}): no code is named for it"
    for name in sorted(named.keys() - known.keys()):
        yield f"{named[name]}: {name} is in no table"
