# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""A mission's text as tokens and as the parts that faults are planted in: cases, states, calls with arguments.

Reads only missions that `glidercc check` has accepted, so it is not a parser: it finds brackets and words.
"""

import dataclasses
import re

TOKEN = re.compile(r"""
    (?P<space>\s+|\#[^\n]*|//[^\n]*|/\*.*?\*/)
  | (?P<text>"[^"\n]*")
  | (?P<number>(?:\d+\.(?!\.)\d*|\.\d+|\d+)(?:[eE][+-]?\d+)?)
  | (?P<name>[A-Za-z_][A-Za-z_0-9]*)
  | (?P<mark>&&|\|\||<=|>=|==|!=|\.\.|[-+*/<>!=(),:\[\]%])
""", re.VERBOSE | re.DOTALL)
UNITS = {"mm", "cm", "m", "km", "nmi", "ft", "s", "min", "h", "day", "rad", "deg", "degC", "kn", "bar", "dbar", "V", "A",
         "J", "kJ", "MJ", "Ah", "N", "S", "E", "W"}
SPEED_UNITS = {("m", "s"), ("cm", "s"), ("S", "m"), ("degC", "m")}
TRANSITIONS = ("goto", "call", "return", "exit", "stay", "done")


@dataclasses.dataclass
class Token:
    kind: str  # number, name, text, mark; a unit after a number is one token of kind "unit"
    text: str
    begin: int
    end: int


@dataclasses.dataclass
class Case:
    where: str  # "always", the state's name, or "profile NAME"
    first: int  # token numbers: `case`
    guard: tuple  # [from, to)
    action: tuple  # of `do … end`, or None
    transition: int  # the word
    end: int  # past the last token


@dataclasses.dataclass
class Part:
    name: str
    first: int  # `state`, `flightprofile` or `always`
    end: int  # past its `end`


@dataclasses.dataclass
class Call:
    name: str
    at: int  # the name
    arguments: list  # of [from, to)


class Mission:
    """name: what mutants are called after; path: of the file; text: what it holds."""

    def __init__(self, name, path, text):
        self.name, self.path, self.text = name, path, text
        self.tokens = list(_tokens(text))
        self.states, self.profiles, self.cases = [], [], []
        self._read()

    def word(self, i):
        return self.tokens[i].text if 0 <= i < len(self.tokens) else ""

    def kind(self, i):
        return self.tokens[i].kind if 0 <= i < len(self.tokens) else ""

    def source(self, first, end):
        """The text of tokens [first, end)."""
        return self.text[self.tokens[first].begin:self.tokens[end - 1].end] if first < end else ""

    def line(self, i):
        return self.text.count("\n", 0, self.tokens[i].begin) + 1

    def closing(self, i):
        """The bracket that closes the one at i."""
        depth = 0
        for j in range(i, len(self.tokens)):
            depth += self.word(j) in "([" and self.kind(j) == "mark"
            depth -= self.word(j) in ")]" and self.kind(j) == "mark"
            if depth == 0:
                return j
        raise ValueError(f"{self.path}: a bracket is not closed")

    def block_end(self, i):
        """Past the `end` of the `begin`, `do` or `if` at i."""
        depth = 0
        for j in range(i, len(self.tokens)):
            depth += self.word(j) in ("begin", "do", "if")
            depth -= self.word(j) == "end"
            if depth == 0:
                return j + 1
        raise ValueError(f"{self.path}: `{self.word(i)}` has no `end`")

    def calls(self, names=None):
        """What looks like `name(…)`, all of them or those of `names`."""
        for i in range(len(self.tokens) - 1):
            if self.kind(i) == "name" and self.word(i + 1) == "(" and (names is None or self.word(i) in names):
                yield Call(self.word(i), i, self._arguments(i + 1))

    def within(self, part):
        return [c for c in self.cases if part.first <= c.first < part.end]

    def declared(self, word):
        """Names and types of `word NAME : TYPE` (var, param, const)."""
        for i, token in enumerate(self.tokens):
            if token.text == word and self.kind(i + 1) == "name":
                yield i, self.word(i + 1), self.word(i + 3) if self.word(i + 2) == ":" else ""

    def _arguments(self, opening):
        closing, found, start, depth = self.closing(opening), [], opening + 1, 0
        for j in range(opening + 1, closing + 1):
            depth += self.word(j) in ("(", "[")
            if (self.word(j) == "," and depth == 0) or j == closing:
                if j > start:
                    found.append((start, j))
                start = j + 1
            depth -= self.word(j) in (")", "]")
        return found

    def _read(self):
        i, where = 0, None
        while i < len(self.tokens):
            word = self.word(i)
            if word == "always":
                where = "always"
            elif word == "state" or (word == "flightprofile" and self._opens_profile(i)):
                begin = next(j for j in range(i, len(self.tokens)) if self.word(j) == "begin")
                part = Part(self.word(i + 1), i, self.block_end(begin))
                (self.states if word == "state" else self.profiles).append(part)
                where = part.name if word == "state" else "profile " + part.name
                i = begin
            elif word == "case":
                case = self._case(i, where)
                self.cases.append(case)
                i = case.end - 1
            i += 1

    def _opens_profile(self, i):
        after = self.closing(i + 2) + 1 if self.word(i + 2) == "(" else i + 2
        return self.word(after) == "begin"

    def _case(self, first, where):
        i, depth = first + 1, 0
        while depth > 0 or self.word(i) not in ("do", *TRANSITIONS):
            depth += (self.word(i) in ("(", "[")) - (self.word(i) in (")", "]"))
            i += 1
        guard, action = (first + 1, i), None
        if self.word(i) == "do":
            action = (i, self.block_end(i))
            i = action[1]
        end = i + 2 if self.word(i) in ("goto", "call") else i + 1
        if end > i + 1 and self.word(end) == "(":
            end = self.closing(end) + 1
        return Case(where, first, guard, action, i, end)


def _tokens(text):
    """Tokens, a unit after a number as one of kind "unit" (`m/s` too)."""
    raw, at = [], 0
    while at < len(text):
        match = TOKEN.match(text, at)
        if match is None:
            raise ValueError(f"no token at `{text[at:at + 20]}`")
        if match.lastgroup != "space":
            raw.append(Token(match.lastgroup, match[0], match.start(), match.end()))
        at = match.end()
    i = 0
    while i < len(raw):
        token = raw[i]
        if i > 0 and raw[i - 1].kind == "number" and (token.text in UNITS or token.text == "%"):
            token.kind = "unit"
            if i + 2 < len(raw) and raw[i + 1].text == "/" and (token.text, raw[i + 2].text) in SPEED_UNITS:
                token = Token("unit", text[token.begin:raw[i + 2].end], token.begin, raw[i + 2].end)
                i += 2
        yield token
        i += 1
