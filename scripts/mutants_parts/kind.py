# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""What a kind of fault is: a function over a Mission; its docstring is the rule, one line.

It yields the places where a fault of its kind can be planted: (token whose line identifies it, edits). An edit is
(first token, past the last token, replacement).
"""

KINDS = {}


def kind(name):
    def register(function):
        KINDS[name] = function
        return function

    return register


def rule(name):
    return KINDS[name].__doc__.strip()


def edited(mission, edits):
    """The mission's text with the edits made; lines keep their numbers."""
    text = mission.text
    for first, end, new in sorted(edits, reverse=True):
        begin = mission.tokens[first].begin
        after = mission.tokens[end - 1].end if end > first else begin
        kept = "\n" * (text.count("\n", begin, after) - new.count("\n"))
        text = text[:begin] + new + kept + text[after:]
    return text
