# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""The operators: each finds the places of a source where it can plant its fault.

An operator yields (begin, end, replacement): text[begin:end] is replaced. `OPERATORS` lists
them by name, in the order of the tables; its docstring says what an operator does.
"""

import re

from mutants_code_parts.operators_structure import STRUCTURE
from mutants_code_parts.operators_text import arguments, top_level


def boundary(source):
    """a bound loses or gains its equality: < and <=, > and >="""
    other = {"<": "<=", "<=": "<", ">": ">=", ">=": ">"}
    for m in re.finditer(r"(?<= )(<=|>=|<|>)(?= )", source.code):
        if not re.search(r"template $", source.code[max(0, m.start() - 12):m.start()]):
            yield m.start(), m.end(), other[m[0]]


def equality(source):
    """== and != change places"""
    for m in re.finditer(r"(?<= )(==|!=)(?= )", source.code):
        yield m.start(), m.end(), "!=" if m[0] == "==" else "=="


def arithmetic(source):
    """+ and -, * and /, += and -= change places"""
    other = {"+": "-", "-": "+", "*": "/", "/": "*", "+=": "-=", "-=": "+=", "*=": "/=", "/=": "*="}
    for m in re.finditer(r"(?<=[\w)\]] )([-+*/]=?)(?= [\w(!-])", source.code):
        yield m.start(), m.end(), other[m[0]]


def sign(source):
    """a sign is lost"""
    for m in re.finditer(r"(?:(?<=[(,=?:*/] )|(?<=[(\[{])|(?<=return ))-(?=[\w(])(?!-)", source.code):
        yield m.start(), m.end(), ""


def logic(source):
    """&& and || change places"""
    for m in re.finditer(r"(?<=[ \n])(&&|\|\|)(?=[ \n])", source.code):
        yield m.start(), m.end(), "||" if m[0] == "&&" else "&&"


def negate(source):
    """the condition of an if is turned round"""
    for m in re.finditer(r"\bif \(", source.code):
        close = source.closing(m.end() - 1)
        inside = source.code[m.end():close]
        if close > 0 and ";" not in inside and not re.search(r"(?<![=!<>])=(?!=)", inside):
            yield m.end(), close, f"!({source.text[m.end():close]})"


def operand(source):
    """one side of && or || is left out"""
    for begin, end in _conditions(source):
        for word in ("&&", "||"):
            if word == "&&" and top_level(source.code, begin, end, "||"):
                continue
            parts = top_level(source.code, begin, end, word)
            if not parts:
                continue
            edges = [begin] + [p for at in parts for p in (at, at + 2)] + [end]
            spans = [(edges[i], edges[i + 1]) for i in range(0, len(edges), 2)]
            for i, (b, e) in enumerate(spans):
                if i == 0:
                    yield b, spans[1][0], ""
                else:
                    yield spans[i - 1][1], e, ""


def _conditions(source):
    for m in re.finditer(r"\b(?:if|while) \(", source.code):
        close = source.closing(m.end() - 1)
        if close > 0:
            yield m.end(), close
    for m in re.finditer(r"\breturn (?=[^;]*(?:&&|\|\|))|(?<= )= (?=[^;{}]*(?:&&|\|\|))", source.code):
        end = source.code.find(";", m.end())
        if end > 0 and not re.search(r"[{}?]", source.code[m.end():end]):
            yield m.end(), end


def constant(source):
    """a number is off by one, or becomes 0"""
    for m in re.finditer(r"(?<![\w.'])(\d[\d']*(?:\.\d*)?(?:e[+-]?\d+)?)([uU]?[lL]{0,2}|f)(?![\w.'])", source.code):
        digits = m[1].replace("'", "")
        if "e" in digits:
            continue
        if "." in digits:
            value = float(digits)
            changed = ["0.0", repr(value * 2)] if value else ["1.0"]
        else:
            value = int(digits)
            changed = [str(value + 1)] + (["0"] if value > 1 else []) + ([str(value - 1)] if value > 0 else [])
        for new in changed:
            yield m.start(1), m.end(1), new


def power(source):
    """a number with an exponent is twice as big, or one more where a double tells that apart"""
    for m in re.finditer(r"(?<![\w.'])\d+(?:\.\d+)?e[+-]?\d+(?![\w.'])|(?<![\w.'])0x1p\d+(?![\w.'])", source.code):
        yield m.start(), m.end(), f"({m[0]} * 2)"
        value = float.fromhex(m[0]) if m[0].startswith("0x") else float(m[0])
        if value + 1.0 != value:
            yield m.start(), m.end(), f"({m[0]} + 1)"


def term(source):
    """a term of a sum is left out"""
    for m in re.finditer(r" [-+] (?:[\w.:]|->)+(?=[;,) ])(?! [*/])", source.code):
        yield m.start(), m.end(), ""


def extremes(source):
    """min and max change places"""
    for m in re.finditer(r"\b(?:std::|f)(min|max)(?=[(<])", source.code):
        yield m.start(1), m.end(1), "max" if m[1] == "min" else "min"


def check_of_number(source):
    """abs, isnan, isfinite are left out"""
    always = {"isnan": "false", "isinf": "false", "isfinite": "true", "isNan": "false", "isFinite": "true",
              "isKnown": "true", "isUnknown": "false", "hookIsFinite": "true", "hookIsFloorKnown": "true",
              "hookIsPositionKnown": "true"}
    for m in re.finditer(r"\b(?:std::)?(isnan|isinf|isfinite|isNan|isFinite|isKnown|isUnknown|hookIsFinite|hookIsFloorKnown"
                         r"|hookIsPositionKnown|hookMagnitude|abs|fabs)\(", source.code):
        close = source.closing(m.end() - 1)
        before = source.code[max(0, m.start() - 8):m.start()]
        if close < 0 or re.search(r"(bool|double) $", before):
            continue
        yield m.start(), close + 1, always.get(m[1], f"({source.text[m.end():close]})")


def swap(source):
    """two arguments that stand side by side change places"""
    for m in re.finditer(r"(?<=\w)\(", source.code):
        if re.search(r"\b(if|for|while|switch|return|sizeof|decltype)$| (?:if|for|while|switch) $",
                     source.code[max(0, m.start() - 9):m.start()]):
            continue
        spans = arguments(source, m.start())
        for (b1, e1), (b2, e2) in zip(spans, spans[1:]):
            one, two = source.text[b1:e1], source.text[b2:e2]
            if one != two and "{" not in one + two and "\n" not in one + two and " " not in source.code[b1:e1].strip():
                yield b1, e2, two + source.text[e1:b2] + one


def either(source):
    """the two branches of ?: change places"""
    for m in re.finditer(r"\? ([^?:;{}\n]+) : ([^?:;{}\n,]+)(?=[;,)])", source.code):
        one, two = m[1].strip(), m[2].strip()
        if all(t.count("(") == t.count(")") for t in (one, two)):
            yield m.start(1), m.end(2), f"{source.text[m.start(2):m.end(2)]} : {source.text[m.start(1):m.end(1)]}"


VALUES = {f.__name__.replace("_", "-"): f for f in (
    boundary, equality, arithmetic, sign, logic, negate, operand, constant, power, term, extremes, check_of_number, swap,
    either)}
OPERATORS = {**VALUES, **STRUCTURE}
