# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""Which missions are taken, and which mutants are made of them."""

import dataclasses
import hashlib
import itertools
import pathlib
import re

from mutants_parts.kind import edited
from mutants_parts.kinds import KINDS
from mutants_parts.mission_text import Mission

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


@dataclasses.dataclass(frozen=True)
class Mutant:
    name: str  # mission/kind/number
    mission: str
    kind: str
    line: int
    change: str  # the first line that differs: before → after
    text: str


def missions():
    """The good missions: those that ship, README's, and those that stand here for this."""
    readme = re.search(r"```mission\n(mission tracker.*?)```", (ROOT / "README.md").read_text(), re.DOTALL)
    found = [Mission("tracker", "README.md", readme[1])]
    for folder in ("missions", "missions/gallery", "tests/mutants/missions"):
        for path in sorted((ROOT / folder).glob("*.mission")):
            found.append(Mission(path.stem, str(path.relative_to(ROOT)), path.read_text()))
    return found


def promises():
    """The requirements that the good missions keep, by the name of the mission."""
    kept = {}
    for path in ("tests/proofs/properties.txt", "tests/mutants/promises.txt"):
        for line in (ROOT / path).read_text().splitlines():
            parts = [part.strip() for part in line.split("|")] if not line.startswith("#") else []
            if len(parts) == 2 or (len(parts) == 3 and parts[1] == "proved"):
                kept.setdefault(pathlib.Path(parts[0]).name, []).append(parts[-1])
    return kept


def promising(text, requirements):
    """The text of a mission that makes these requirements."""
    return text + "".join(f"\nrequire {requirement}" for requirement in requirements) + "\n"


def mutants(mission):
    """Every mutant of a mission, in the order of the list of kinds and of the text."""
    for kind, places in KINDS.items():
        number = 0
        for at, edits in places(mission):
            text = edited(mission, edits)
            if text.split() != mission.text.split():
                number += 1
                yield Mutant(f"{mission.name}/{kind}/{number}", mission.name, kind, mission.line(at),
                             _change(mission.text, text), text)


def pick(found, count, seed):
    """`count` of the mutants: from each kind in turn the next in an order that the seed gives. A mission more or less
    changes the choice little, for the order hangs on the mutant alone."""

    def rank(mutant):
        return hashlib.sha256(f"{seed}/{mutant.name}/{mutant.change}".encode()).digest()

    by_kind = [sorted((m for m in found if m.kind == kind), key=rank) for kind in KINDS]
    in_turn = (m for row in itertools.zip_longest(*by_kind) for m in row if m is not None)
    chosen = {m.name for m in itertools.islice(in_turn, count)}
    return [m for m in found if m.name in chosen]


def _change(before, after):
    for one, two in zip(before.splitlines(), after.splitlines()):
        if one != two:
            return " ".join(one.split()) + "  →  " + (" ".join(two.split()) or "(nothing)")
    return ""
