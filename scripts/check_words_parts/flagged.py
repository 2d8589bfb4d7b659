# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""The words and phrases that scripts/check_words reports, and what to write instead."""

import re

# A pattern (case does not matter; a blank stands for any white space) and its replacement.
_TABLE = (
    # One term for each thing: docs/glossary.md.
    (r"the house\b", "architecture"),
    (r"\bepitaphs?\b", "exit reason"),
    (r"\bshoe-?box\b", "simulator"),
    (r"\bclotheslines?\b", "flight-science link"),
    (r"(?<!great\s)\bcircles\b", "strongly connected components"),
    (r"\bfences?\b", "geofence"),
    (r"\bbounces?\b", "livelock, chattering"),
    (r"\b(thins|thinned) (a|the|out|lines|to)\b", "downsample"),
    (r"(?<!sea\s)\btrials\b", "sampling"),
    (r"\blegs that overshoot\b", "inflection overshoot"),
    (r"\b(assumed|prover's) world\b", "environment model"),
    (r"\bthe world fail(s|ed)\b|\bthe world's failures?\b", "I/O or system error"),
    (r"\b(hand|hands|handed|handing|give|gives|given|giving|gave)(\s+|-)back\b", "release control"),
    (r"\b(hand|hands|handed|handing|give|gives|given|giving|gave) (control|it|itself|the vehicle|the glider) back\b",
     "release control"),
    (r"\bhand-?backs?\b", "release of control"),
    (r"\blets? go\b", "release control"),
    (r"\bmistakes?\b", "error (the pilot's), bug (ours)"),
    (r"\bjudg(e|es|ed|ing)\b(?!\.def)", "check; reference, test oracle"),
    (r"\bspell(s|ed|ing)? out\b", "concretize, write in full"),
    (r"\bwrong usage\b", "usage error"),
    (r"\blayered control (then )?flies on\b", "the layered control takes over"),
    (r"\bmissions? (flies|fly) on\b", "continues"),
    (r"\bguards? climbs?\b", "a guard makes the vehicle climb"),
    # Word for word from another language.
    (r"\bhas (\{\d\}|[\d,.]+) (bytes|KiB|MiB)\b", "is … long"),
    (r"\b(a|only) blanks?\b(?! line)", "space, white space"),
    (r"\b(built|compiled) again\b", "rebuilt, recompiled"),
    (r"\b(after|with|from) another (status|parameters)\b", "a different …"),
    (r"\bis searched in\b", "is looked up in"),
    (r"\bstands? at\b", "appears at"),
    # Archaic words.
    (r"\banew\b", "again, from the start"),
    (r"\bbesides\b", "also"),
    (r"\bmend(s|ed|ing)?\b", "fix"),
    (r"\bway out\b", "suggested fix"),
    (r"\boftener\b", "more often"),
    (r"\bto and fro\b", "back and forth"),
    (r"\bbut for\b", "except for"),
    (r"(?<!dead[-\s])\breckon(s|ed)?\b", "assume, estimate, account for"),
    (r"\ball the same\b", "anyway, nevertheless"),
    (r"\bin the same breath\b", "at once"),
    # Inverted and clipped clauses.
    (r"(?<!there\s)\b(is|are|was|were) no (?!longer\b|more\b|less\b|deeper\b|faster\b|further\b|later\b|greater\b)\w+",
     "is not a"),
    (r"\bwhatever\b", "for any …, in any …"),
    (r"\bnobody\b", "passive voice, no one"),
    (r"\bcounts? for nothing\b", "is ignored"),
    (r"\bsays? so\b", "reports it"),
    (r"\b(is|are|was|were|be|been) told\b|\btold (so|of|once)\b", "is reported"),
    (r"\bstands? still\b|\bstood still\b", "stops responding, does not advance, does not change"),
    (r"\bstands? (in|there|beside)\b", "is in"),
    (r"\b(is|was) dark\b", "has no power"),
    (r"\bcomes? of (it|them|that|a)\b", "results from"),
    (r"\bworks? out\b|\bworked out\b", "evaluate, compute"),
    (r"\b(hold|holds|held) (\w+ ){0,3}against\b", "compare with, check against"),
    (r"\bproved of\b", "proved about"),
    (r"\blevels? off short\b", "does not go all the way"),
    (r"\bwithout a word\b", "without a message"),
    (r"\bthis is not so\b", "requirement violated"),
    (r"\bbelongs here\b", "expected …"),
    # Machines do not hear and want.
    (r"\b(hear|hears|heard)\b", "receive"),
    (r"\b(wants|wanted)\b", "needs, expects, requires"),
)

PHRASES = tuple((re.compile(pattern.replace(" ", r"\s+"), re.IGNORECASE), instead) for pattern, instead in _TABLE)

# Names in code that have a name in the field; counted by --all.
IDENTIFIERS = frozenset(
    "ConcreteRun Dice Ground Inherited Moment Onlooker Possible Relevance RuleWriter Watch bounces circles clothesline Clothesline "
    "epitaph epitaph_ fences greatestSet spellOut".split()
)
