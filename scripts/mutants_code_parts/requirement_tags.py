# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""The requirements of hookbeh and hookprog, and the lines of code whose comments name them."""

import re

from source import ROOT, Source

FOLDERS = ("hooks/hookbeh", "hooks/hookprog")


def listed():
    """Requirement → its row's text, of the tables of both READMEs."""
    found = {}
    for folder in FOLDERS:
        for m in re.finditer(r"^\| ((?:HB|HP)-\d+) \| ([^|]*)\|", (ROOT / folder / "README.md").read_text(), re.MULTILINE):
            found[m[1]] = m[2].strip()
    return found


def findings(paths):
    """What is wrong between tables and tags: a requirement that no line is tagged with, a tag that no table has."""
    tagged = {}
    for path in paths:
        for line, tags in Source(path).tags.items():
            for tag in tags:
                tagged.setdefault(tag, f"{path}:{line}")
    known = listed()
    for name in sorted(known.keys() - tagged.keys()):
        yield f"{name} ({known[name]}): no line of code is tagged with it"
    for name in sorted(tagged.keys() - known.keys()):
        yield f"{tagged[name]}: {name} is in no table"
