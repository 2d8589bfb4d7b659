# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""What several operators read of the text: lists of arguments, words outside brackets."""


def top_level(code, begin, end, word):
    """The positions of `word` in code[begin:end] outside all brackets."""
    depth, found, at = 0, [], begin
    while at < end:
        if code[at] in "([{":
            depth += 1
        elif code[at] in ")]}":
            depth -= 1
        elif depth == 0 and code.startswith(word, at):
            found.append(at)
            at += len(word) - 1
        at += 1
    return found


def arguments(source, bracket):
    """The spans of the arguments in the bracket at `bracket`, without the spaces around them; none for a template's `<,>`."""
    close = source.closing(bracket)
    if close < 0:
        return []
    edges = [bracket] + top_level(source.code, bracket + 1, close, ",") + [close]
    spans = []
    for b, e in zip(edges, edges[1:]):
        b += 1
        while b < e and source.code[b].isspace() and source.text[b].isspace():
            b += 1
        while e > b and source.text[e - 1].isspace():
            e -= 1
        if source.text[b:e].count("<") != source.text[b:e].count(">") or b == e:
            return []
        spans.append((b, e))
    return spans
