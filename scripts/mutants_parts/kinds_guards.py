# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""Faults in guards: comparisons, thresholds, logic, sensors, clocks."""

from mutants_parts.kind import kind
from mutants_parts.kinds_structure import other
from mutants_parts.platform_sensors import PLAUSIBLE, SENSORS, of_another_unit, of_the_same_unit

CLOCKS = ("missiontime", "statetime", "resumetime")
TURNED = {"<": ">", ">": "<", "<=": ">=", ">=": "<="}


def in_guards(m, wanted):
    """Tokens in guards whose text is one of `wanted`."""
    for c in m.cases:
        for i in range(*c.guard):
            if m.word(i) in wanted:
                yield i


def thresholds(m):
    """(sensor or clock, number): comparisons of a name with a number in guards."""
    for i in in_guards(m, TURNED):
        if m.kind(i - 1) == "name" and m.word(i + 1) == "-" and m.kind(i + 2) == "number":
            yield m.word(i - 1), i + 2
        elif m.kind(i - 1) == "name" and m.kind(i + 1) == "number":
            yield m.word(i - 1), i + 1


def hidden_names(m):
    """Names of the mission's own, which may hide a sensor's."""
    return {name for word in ("var", "param", "const") for _, name, _ in m.declared(word)}


@kind("comparison-turned")
def comparison_turned(m):
    """`<` for `>`, `>=` for `<=`, or the other way round"""
    for i in in_guards(m, TURNED):
        yield i, [(i, i + 1, TURNED[m.word(i)])]


@kind("threshold-out-of-range")
def threshold_out_of_range(m):
    """a sensor is compared with what it never reads"""
    for name, i in thresholds(m):
        if name in SENSORS and name not in hidden_names(m):
            yield i, [(i, i + 1, PLAUSIBLE[SENSORS[name].unit])]


@kind("threshold-sign")
def threshold_sign(m):
    """a minus before a threshold, or one left out"""
    for _, i in thresholds(m):
        if m.word(i - 1) == "-":
            yield i, [(i - 1, i, "")]
        else:
            yield i, [(i, i, "-")]


@kind("zero-added")
def zero_added(m):
    """a threshold ten times as great"""
    for _, i in thresholds(m):
        number = m.word(i)
        if float(number) != 0:
            yield i, [(i, i + 1, f"{float(number) * 10:g}")]


@kind("and-for-or")
def and_for_or(m):
    """`&&` for `||`"""
    for i in in_guards(m, ("||",)):
        yield i, [(i, i + 1, "&&")]


@kind("or-for-and")
def or_for_and(m):
    """`||` for `&&`"""
    for i in in_guards(m, ("&&",)):
        yield i, [(i, i + 1, "||")]


@kind("not-dropped")
def not_dropped(m):
    """a `!` is not there"""
    for i in in_guards(m, ("!",)):
        yield i, [(i, i + 1, "")]


@kind("not-added")
def not_added(m):
    """a whole guard the other way round"""
    for c in m.cases:
        yield c.first, [(*c.guard, f"!({m.source(*c.guard)})")]


@kind("timeout-dropped")
def timeout_dropped(m):
    """an `|| CLOCK > time` is not there"""
    for i in in_guards(m, ("||",)):
        if m.word(i + 1) in CLOCKS and m.word(i + 2) in TURNED:
            end = i + 4 + (m.kind(i + 4) == "unit")
            yield i, [(i, end, "")]


@kind("clock-swapped")
def clock_swapped(m):
    """`statetime` for `missiontime`, or the other way round"""
    for i in in_guards(m, CLOCKS[:2]):
        yield i, [(i, i + 1, other(CLOCKS[:2], m.word(i)))]


@kind("clock-resumed")
def clock_resumed(m):
    """`resumetime` for `statetime`, or the other way round"""
    for i in in_guards(m, CLOCKS[1:]):
        yield i, [(i, i + 1, other(CLOCKS[1:], m.word(i)))]


def sensor_swaps(m, choose):
    """In guards the sensor that `choose` gives for each; the state lists it too, or that alone would tell."""
    for c in m.cases:
        for i in range(*c.guard):
            if m.word(i) not in SENSORS.keys() - hidden_names(m) or not choose(m.word(i)):
                continue
            old, new = m.word(i), choose(m.word(i))
            state = next((s for s in m.states if s.first <= i < s.end), None)
            listed = [j for j in range(state.first, state.end) if m.word(j) == old and j < first_case(m, state)] if state else []
            edits = [(listed[0], listed[0] + 1, f"{old}, {new}")] if listed else []
            yield i, [(i, i + 1, new), *edits]


def first_case(m, state):
    return m.within(state)[0].first


@kind("sensor-of-same-unit")
def sensor_of_same_unit(m):
    """another sensor of the same unit, which the state lists too"""
    yield from sensor_swaps(m, of_the_same_unit)


@kind("sensor-of-other-unit")
def sensor_of_other_unit(m):
    """another sensor of another unit, which the state lists too"""
    yield from sensor_swaps(m, of_another_unit)


@kind("held-dropped")
def held_dropped(m):
    """a condition itself where it was to be held, or to have become true"""
    for call in m.calls(("held", "became")):
        yield call.at, [(call.at, m.closing(call.at + 1) + 1, f"({m.source(*call.arguments[0])})")]


@kind("window-dropped")
def window_dropped(m):
    """a reading itself where its mean, lowest or highest was meant"""
    for call in m.calls(("mean", "lowest", "highest")):
        yield call.at, [(call.at, m.closing(call.at + 1) + 1, m.source(*call.arguments[0]))]
