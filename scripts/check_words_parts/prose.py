# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""The prose of a file: what people read of it, in its place; code is blanked out.

Code becomes NUL characters, which no pattern crosses; what only separates words of one text (comment signs, quotes of
adjacent literals) becomes blanks, so that a phrase is found across lines. Line breaks stay.
"""

import re

_CPP_TOKEN = re.compile(
    r'(?P<include>#[ \t]*include[^\n]*)|(?P<comment>//[^\n]*|/\*.*?\*/)|(?P<raw>R"(?P<mark>\w*)\(.*?\)(?P=mark)")|(?P<string>"(?:\\.|[^"\\\n])*")'
    r"|(?P<char>'(?:\\.|[^'\\\n])+')", re.DOTALL)
_SCRIPT_TOKEN = re.compile(r'(?P<doc>""".*?""")|(?P<string>"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\')|(?P<comment>#[^\n]*)',
                           re.DOTALL)
_DATA_TOKEN = re.compile(r'(?P<string>"(?:\\.|[^"\\\n])*")|(?P<comment>(?:#|//)[^\n]*)')
_DATA = (".mission", ".toml", ".mi")
_CPP = (".cpp", ".h", ".c", ".def")
_CODE_SPAN = re.compile(r"`[^`\n]*`")


def _hidden(text):
    return re.sub(r"[^\n]", "\0", text)


def _quotes_gone(text):
    """A literal or comment without its signs."""
    return re.sub(r'^(R"\w*\(|"|//+|/\*+|#+)|("|\*/)$|^[ \t]*(\*|//+|#+)(?=\s)', lambda m: " " * len(m[0]), text,
                  flags=re.MULTILINE)


def _kept(text, token, wanted):
    """`text` with all hidden but the tokens of the `wanted` kinds; code between two of them that is only white space is a blank."""
    out, end, joined = [], 0, False
    for match in token.finditer(text):
        if match.lastgroup == "mark":
            kind = "raw"
        else:
            kind = match.lastgroup
        between = text[end:match.start()]
        if kind in wanted:
            out.append(between if joined and not between.strip() else _hidden(between))
            out.append(_CODE_SPAN.sub(lambda span: _hidden(span[0]), _quotes_gone(match[0])))
            joined = True
        else:
            out.append(_hidden(between) + _hidden(match[0]))
            joined = False
        end = match.end()
    return "".join(out) + _hidden(text[end:])


def _markdown(text):
    lines, fenced = [], False
    for line in text.split("\n"):
        fence = line.lstrip().startswith("```")
        lines.append(_hidden(line) if fenced or fence or line.startswith("    ") else line)
        fenced ^= fence
    return _CODE_SPAN.sub(lambda span: _hidden(span[0]), "\n".join(lines))


def prose_of(path, text, comments):
    """The prose of the file `path` with this `text`; comments of C++ only if `comments`."""
    if path.suffix == ".md":
        return _markdown(text)
    if path.suffix == ".3":
        return text
    if path.suffix in _DATA:
        return _kept(text, _DATA_TOKEN, ("comment", "string"))
    if path.suffix in _CPP:
        return _kept(text, _CPP_TOKEN, ("string", "raw", "comment") if comments else ("string", "raw"))
    if path.suffix == ".py" or text.startswith("#!"):
        return _kept(text, _SCRIPT_TOKEN, ("doc", "comment", "string"))
    return ""


def identifiers(text):
    """The names in C++ code, outside comments and strings."""
    return re.findall(r"[A-Za-z_]\w*", _CPP_TOKEN.sub(" ", text))
