# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""Faults in states, cases, transitions, statements and commands."""

from mutants_parts.kind import kind


def transitions(m, *words):
    """Cases of `always` and of states (not of profiles) that end with one of `words`."""
    return [c for c in m.cases if m.word(c.transition) in words and not c.where.startswith("profile")]


def deleted(m, cases):
    return [(c.first, [(c.first, c.end, "")]) for c in cases]


def other(names, name):
    """The name after `name`, counted round; None if there is no other."""
    names = list(dict.fromkeys(names))
    after = names[(names.index(name) + 1) % len(names)] if name in names else None
    return None if after == name else after


@kind("deleted-exit")
def deleted_exit(m):
    """a case that exits is not there"""
    yield from deleted(m, transitions(m, "exit"))


@kind("deleted-goto-or-call")
def deleted_goto_or_call(m):
    """a case of a state that goes to or calls another is not there"""
    yield from deleted(m, [c for c in transitions(m, "goto", "call") if c.where != "always"])


@kind("dropped-return")
def dropped_return(m):
    """a case that returns is not there"""
    yield from deleted(m, transitions(m, "return"))


@kind("deleted-always")
def deleted_always(m):
    """a case of `always` is not there"""
    yield from deleted(m, [c for c in m.cases if c.where == "always"])


@kind("deleted-stay")
def deleted_stay(m):
    """a case that stays or is done is not there"""
    yield from deleted(m, [c for c in m.cases if m.word(c.transition) in ("stay", "done")])


@kind("goto-for-call")
def goto_for_call(m):
    """`goto` where `call` was meant"""
    for c in transitions(m, "call"):
        yield c.transition, [(c.transition, c.transition + 1, "goto")]


@kind("call-for-goto")
def call_for_goto(m):
    """`call` where `goto` was meant"""
    for c in transitions(m, "goto"):
        yield c.transition, [(c.transition, c.transition + 1, "call")]


@kind("return-for-goto")
def return_for_goto(m):
    """`return` where `goto` was meant"""
    for c in transitions(m, "goto"):
        yield c.transition, [(c.transition, c.end, "return")]


@kind("goto-for-return")
def goto_for_return(m):
    """a goto to the state that calls where `return` was meant"""
    for c in transitions(m, "return"):
        callers = [d.where for d in transitions(m, "call") if m.word(d.transition + 1) == c.where]
        back = callers[0] if callers and callers[0] != "always" else m.states[0].name
        yield c.transition, [(c.transition, c.end, "goto " + back)]


@kind("exit-for-return")
def exit_for_return(m):
    """`exit` where `return` was meant"""
    for c in transitions(m, "return"):
        yield c.transition, [(c.transition, c.end, "exit")]


@kind("return-for-exit")
def return_for_exit(m):
    """`return` where `exit` was meant"""
    for c in transitions(m, "exit"):
        yield c.transition, [(c.transition, c.end, "return")]


@kind("stay-for-transition")
def stay_for_transition(m):
    """`stay` where the state was to be left"""
    for c in transitions(m, "goto", "call", "return", "exit"):
        yield c.transition, [(c.transition, c.end, "stay")]


@kind("wrong-target")
def wrong_target(m):
    """another state of the mission as target"""
    for c in transitions(m, "goto", "call"):
        target = other([s.name for s in m.states], m.word(c.transition + 1))
        if target:
            yield c.transition, [(c.transition + 1, c.transition + 2, target)]


@kind("misspelt-state")
def misspelt_state(m):
    """a target with its last letter twice, which no state is called"""
    for c in transitions(m, "goto", "call"):
        name = m.word(c.transition + 1)
        yield c.transition, [(c.transition + 1, c.transition + 2, name + name[-1])]


@kind("duplicated-state")
def duplicated_state(m):
    """a state is duplicated"""
    for s in m.states:
        yield s.first, [(s.first, s.end, m.source(s.first, s.end) + " " + m.source(s.first, s.end))]


@kind("deleted-state")
def deleted_state(m):
    """a state is not there, what names it is"""
    for s in m.states:
        yield s.first, [(s.first, s.end, "")]


@kind("case-moved")
def case_moved(m):
    """two neighbouring cases of a list have changed places"""
    for one, two in zip(m.cases, m.cases[1:]):
        if one.where == two.where and one.end == two.first:
            both = m.source(two.first, two.end) + " " + m.source(one.first, one.end)
            yield one.first, [(one.first, two.end, both)]


@kind("deleted-entry")
def deleted_entry(m):
    """an `entry` block is not there"""
    for i in range(len(m.tokens)):
        if m.word(i) == "entry" and m.word(i + 1) == "do":
            yield i, [(i, m.block_end(i + 1), "")]


@kind("deleted-set")
def deleted_set(m):
    """a `set` is not there"""
    for i in range(len(m.tokens)):
        if m.word(i) == "set":
            yield i, [(i, expression_end(m, i + 3), "")]


@kind("deleted-route")
def deleted_route(m):
    """a flightroute is not there"""
    for i in range(len(m.tokens)):
        if m.word(i) == "flightroute" and m.word(i + 1) != "noheading":
            end = m.closing(i + 2) + 1 if m.word(i + 2) == "(" else i + 2
            yield i, [(i, end, "")]


COMMANDS = ("descend", "ascend", "hover", "surface", "steer", "steer_to", "drift", "fin", "pump", "battery")


@kind("deleted-command")
def deleted_command(m):
    """a command to the vehicle is not there"""
    for call in m.calls(COMMANDS):
        yield call.at, [(call.at, m.closing(call.at + 1) + 1, "")]


@kind("command-swapped")
def command_swapped(m):
    """`ascend` for `descend`, or the other way round"""
    for call in m.calls(("descend", "ascend")):
        yield call.at, [(call.at, call.at + 1, other(["descend", "ascend"], call.name))]


def expression_end(m, i):
    """Past the expression of a statement that begins at i: where the next statement or the end stands."""
    depth = 0
    while depth > 0 or m.word(i) not in ("set", "log", "if", "else", "end", *COMMANDS):
        depth += (m.word(i) in ("(", "[")) - (m.word(i) in (")", "]"))
        i += 1
    return i
