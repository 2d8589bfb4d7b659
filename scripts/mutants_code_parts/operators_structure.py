# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""Operators that change what is done, not with which values: statements, branches, cases, lists, joins."""

import re

from mutants_code_parts.operators_text import arguments

_STATEMENT = re.compile(
    r"^[ ]+(?!return\b|break\b|continue\b|using\b|const\b|auto\b|constexpr\b|case\b|default\b|static\b|delete\b)"
    r"(?:\(void\))?(?:\+\+|--)?[\w:.>\-\[\]*()]+(?:(?: [-+*/|&^]?= )|\(|(?:\+\+|--);)", re.MULTILINE)


def delete(source):
    """a statement is left out: an assignment or a call"""
    for m in _STATEMENT.finditer(source.code):
        before = source.code[:m.start()].rstrip()
        if before[-1:] not in "{};:)" or before.endswith("::"):
            continue
        end = _end_of_statement(source, m.start())
        if end > 0 and re.search(r"[=(]|\+\+|--", source.code[m.start():end]) and "{" not in source.code[m.start():end]:
            begin = m.start() + len(m[0]) - len(m[0].lstrip())
            yield begin, end, ";"


def _end_of_statement(source, at):
    depth = 0
    for i in range(at, len(source.code)):
        c = source.code[i]
        if c in "([{":
            depth += 1
        elif c in ")]}":
            depth -= 1
        elif c == ";" and depth == 0:
            return i + 1
        if depth < 0:
            return -1
    return -1


def returns(source):
    """true is returned for false, false for true, a constant for a comparison"""
    for m in re.finditer(r"\breturn (true|false);", source.code):
        yield m.start(1), m.end(1), "false" if m[1] == "true" else "true"
    for m in re.finditer(r"\breturn ([^;{}]*(?: [<>]=? | [=!]= | && | \|\| )[^;{}]*);", source.code):
        if "?" not in m[1] and not re.search(r"<<|>>", m[1]):
            yield m.start(1), m.end(1), "true"
            yield m.start(1), m.end(1), "false"


_ENUMERATOR = re.compile(r"\b([A-Z]\w+)::([A-Z]\w*)\b(?![(<:{])")
# C's constants: kHookGuardTooDeep is one of HookGuard. The longest type that fits is theirs.
_C_ENUMERATOR = re.compile(r"\bk(Hook(?:DepthReading|HeadingMode|PitchMode|PumpMode|Answer|Control|Doing|Guard|Lateral|State|Vertical|Way)"
                           r"|Stage)([A-Z]\w*)\b")


def enumerator(source):
    """an enumerator becomes its neighbour among those of its type in the file"""
    pattern = _C_ENUMERATOR if source.path.endswith(".c") else _ENUMERATOR
    members = {}
    for m in pattern.finditer(source.code):
        members.setdefault(m[1], [])
        if m[2] not in members[m[1]]:
            members[m[1]].append(m[2])
    for m in pattern.finditer(source.code):
        others = members[m[1]]
        if len(others) > 1 and not re.search(r"case (?:\w+::)*$", source.code[max(0, m.start() - 40):m.start()]):
            yield m.start(2), m.end(2), others[(others.index(m[2]) + 1) % len(others)]


def case(source):
    """a case of a switch loses its label"""
    for m in re.finditer(r"\bcase [\w:]+:(?!:)", source.code):
        yield m.start(), m.end(), ""


def row(source):
    """a row of a .def list is left out"""
    if source.path.endswith(".def"):
        for m in re.finditer(r"^[A-Z_]+\([^\n]*\)\n", source.code, re.MULTILINE):
            yield m.start(), m.end(), "\n"


def leave(source):
    """a break or continue is lost; not that of a last case, which changes nothing"""
    for m in re.finditer(r"\b(break|continue);(?!\s*\})", source.code):
        yield m.start(), m.end(), ";"


def element(source):
    """a list in braces loses one of its elements"""
    for m in re.finditer(r"(?:(?<=[=(:] )|(?<=return )|(?<=\())\{", source.code):
        spans = arguments(source, m.start())
        if len(spans) < 2 or ";" in source.code[m.start():source.closing(m.start())]:
            continue
        for i, (b, e) in enumerate(spans):
            yield (b, spans[1][0], "") if i == 0 else (spans[i - 1][1], e, "")


def key(source):
    """a key that is made of several parts loses one of them"""
    for m in re.finditer(r"\bstd::(?:tuple|tie|make_tuple)\(", source.code):
        spans = arguments(source, m.end() - 1)
        for i, (b, e) in enumerate(spans if len(spans) > 1 else ()):
            yield (b, spans[1][0], "") if i == 0 else (spans[i - 1][1], e, "")


def join(source):
    """what joins two paths keeps but one of them"""
    for m in re.finditer(r"\b(?:\w+::)?(?:join|joined|merge|merged|unite|hull|both|either|widen)\(", source.code):
        spans = arguments(source, m.end() - 1)
        close = source.closing(m.end() - 1)
        if len(spans) == 2 and source.code[m.start() - 1] not in ".>":
            for b, e in spans:
                yield m.start(), close + 1, source.text[b:e]


def order(source):
    """two assignments that stand one below the other change places; what was simultaneous becomes one after the other"""
    pattern = re.compile(r"^( +)([\w.\[\]>-]+ = [^;\n{}]+;)\n\1([\w.\[\]>-]+ = [^;\n{}]+;)$", re.MULTILINE)
    for m in pattern.finditer(source.code):
        one, two = m[2], m[3]
        if one.split(" = ")[0] in two.split(" = ", 1)[1] or two.split(" = ")[0] in one.split(" = ", 1)[1]:
            yield m.start(2), m.end(3), (source.text[m.start(3):m.end(3)] + "\n" + m[1] +
                                         source.text[m.start(2):m.end(2)])


def branch(source):
    """an else goes the way of the if, or is not gone at all"""
    for m in re.finditer(r"\} else \{", source.code):
        yield m.start(), m.end(), "} if (false) {"
        yield m.start(), m.end(), "} {"


STRUCTURE = {f.__name__: f for f in (delete, returns, enumerator, case, row, leave, element, key, join, order, branch)}
