# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""A C++ source as the operators see it: comments and texts blanked out, statements and functions found."""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
TAG = re.compile(r"\b(?:HB|HP)-\d+\b")
_TOKENS = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(?P<raw>[^(\s]*)\(.*?\)(?P=raw)"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])\'', re.DOTALL)
_FUNCTION = re.compile(r"^(?: {2})?(?!return|else|if|for|while|switch|case|using|namespace|#|public|private|typedef)"
                       r"(?=[\w\[:~<]).*?(?P<name>~?[\w:]*\w)\(", re.DOTALL)


def _blank(match):
    return re.sub(r"[^\n]", " ", match[0])


class Source:
    """`text` as it stands; `code` the same length, with spaces for comments, texts and what is never mutated."""

    def __init__(self, path, text=None):
        self.path = str(path)
        self.text = (ROOT / path).read_text(encoding="utf-8") if text is None else text
        self.code = _without_debug(_TOKENS.sub(_blank, self.text))
        self._starts = [0] + [m.end() for m in re.finditer("\n", self.text)]
        self.lines = self.text.split("\n")
        self._functions = self._find_functions()
        self.tags = self._find_tags()

    def line_of(self, at):
        """The number of the line that holds the character `at`, from 1."""
        low, high = 0, len(self._starts)
        while high - low > 1:
            middle = (low + high) // 2
            low, high = (middle, high) if self._starts[middle] <= at else (low, middle)
        return low + 1

    def start_of(self, line):
        return self._starts[line - 1]

    def function_at(self, line):
        """The name of the function that line `line` lies in, or the file's top."""
        return self._functions[line - 1]

    def functions(self):
        """The names of all functions."""
        return set(self._functions)

    def closing(self, at):
        """The place of the bracket that closes the one at `at`; -1 where none does."""
        pairs = {"(": ")", "[": "]", "{": "}"}
        wanted = []
        for i in range(at, len(self.code)):
            c = self.code[i]
            if c in pairs:
                wanted.append(pairs[c])
            elif c in ")]}":
                if not wanted or wanted.pop() != c:
                    return -1
                if not wanted:
                    return i
        return -1

    def _find_functions(self):
        found, current = [], ""
        code_lines = self.code.split("\n")
        for line in code_lines:
            match = _FUNCTION.match(line)
            if match and not line.rstrip().endswith(";"):
                current = match["name"]
            found.append(current)
        return found

    def _find_tags(self):
        """Line number → the requirements that a comment there, or in the lines of comment above its statement, names."""
        tags, pending = {}, set()
        until, pending_until = 0, set()
        for number, line in enumerate(self.lines, 1):
            comment = line.find("//")
            named = set(TAG.findall(line[comment:])) if comment >= 0 else set()
            if line.strip().startswith("//"):
                pending |= named
                continue
            here = set(named)
            if pending and line.strip():
                pending_until, until, pending = pending, self._statement_end(number), set()
            if number <= until:
                here |= pending_until
            if here:
                tags[number] = here
        return tags

    def _statement_end(self, line):
        """The last line of the statement or block that begins in line `line`."""
        depth = 0
        for at in range(self.start_of(line), len(self.code)):
            c = self.code[at]
            if c in "([{":
                depth += 1
            elif c in ")]}":
                depth -= 1
                if depth < 0:
                    return line
                if depth == 0 and c == "}":
                    return self.line_of(at)
            elif c == ";" and depth == 0:
                return self.line_of(at)
        return line


def _without_debug(code):
    """Blanks preprocessor lines, what stands under NDEBUG, static assertions and the checks of our own bugs."""
    lines, kept, hidden = code.split("\n"), [], 0
    continued = False
    for line in lines:
        stripped = line.lstrip()
        if stripped.startswith("#") or continued:
            continued = line.rstrip().endswith("\\")
            if re.match(r"#\s*if.*NDEBUG", stripped):
                hidden = 1
            elif hidden and re.match(r"#\s*if", stripped):
                hidden += 1
            elif hidden and re.match(r"#\s*endif", stripped):
                hidden -= 1
            kept.append(" " * len(line))
        else:
            kept.append(" " * len(line) if hidden else line)
    code = "\n".join(kept)
    return re.sub(r"\b(?:static_assert|GLIDER_STATIC_ASSERT|CHECK|assert)\s*\((?:[^;\"]|\n)*?\);", _blank, code)
