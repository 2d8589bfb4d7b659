# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""Faults in numbers, units, arguments, positions, sensor lists and variables."""

from mutants_parts.kind import kind
from mutants_parts.kinds_structure import expression_end, other

OTHER_UNITS = {"m": ("cm", "km", "ft"), "km": ("m", "nmi"), "deg": ("rad",), "rad": ("deg",), "h": ("s", "min"),
               "min": ("s", "h"), "s": ("min", "h"), "V": ("A",), "degC": ("m",)}
PROFILES_WITH_DEPTHS = ("yo", "thermotrackyo")
TOO_DEEP, TOO_STEEP = "250 m", "60 deg"


def numbers(m):
    return (i for i in range(len(m.tokens)) if m.kind(i) == "number")


def uses(m):
    """Profiles and routes that states fly, with their arguments."""
    for call in m.calls():
        if m.word(call.at - 1) in ("flightprofile", "flightroute") and not any(p.first == call.at - 1 for p in m.profiles):
            yield call


@kind("unit-changed")
def unit_changed(m):
    """another unit after a number: cm for m, rad for deg, s for h"""
    for i in range(len(m.tokens)):
        if m.kind(i) == "unit":
            for new in OTHER_UNITS.get(m.word(i), ()):
                yield i, [(i, i + 1, new)]


@kind("unit-dropped")
def unit_dropped(m):
    """no unit after a number"""
    for i in range(len(m.tokens)):
        if m.kind(i) == "unit" and m.word(i) not in "NSEW":
            yield i, [(i, i + 1, "")]


@kind("unit-added")
def unit_added(m):
    """deg, cm or min after a bare number"""
    for call in uses(m):
        for first, end in call.arguments:
            if end == first + 1 and m.kind(first) == "number":
                yield first, [(end, end, " deg" if float(m.word(first)) < 1 else " cm")]
    for c in m.cases:
        for i in range(*c.guard):
            if m.kind(i) == "number" and m.kind(i + 1) != "unit" and m.word(i - 2).endswith("time"):
                yield i, [(i, i + 1, m.word(i) + " min")]


@kind("depths-swapped")
def depths_swapped(m):
    """the upper depth of a yo where the lower stands, and the lower where the upper does"""
    for call in uses(m):
        if call.name in PROFILES_WITH_DEPTHS:
            yield call.at, swapped(m, *call.arguments[:2])


@kind("arguments-swapped")
def arguments_swapped(m):
    """two neighbouring arguments have changed places (but the depths of a yo)"""
    for call in m.calls():
        for k, (one, two) in enumerate(zip(call.arguments, call.arguments[1:])):
            depths = call.name in PROFILES_WITH_DEPTHS and k == 0
            if not depths and m.source(*one) != m.source(*two):
                yield call.at, swapped(m, one, two)


@kind("argument-dropped")
def argument_dropped(m):
    """the last of several arguments is not there"""
    for call in m.calls():
        if len(call.arguments) > 1:
            first, end = call.arguments[-1]
            yield call.at, [(first - 1, end, "")]


@kind("argument-sign")
def argument_sign(m):
    """a minus before an argument of a profile, a route or a command"""
    for call in [*uses(m), *m.calls(("descend", "ascend", "hover"))]:
        for first, end in call.arguments:
            if m.kind(first) == "number" and m.word(first - 1) != "-" and end <= first + 2:
                yield first, [(first, first, "-")]


@kind("beyond-envelope")
def beyond_envelope(m):
    """a depth of 250 m, or an angle of 60 deg, in a profile, a constant, or the range of a parameter or variable"""
    arguments = {first for call in uses(m) if m.word(call.at - 1) == "flightprofile" for first, _ in call.arguments}
    for i in numbers(m):
        declared = m.word(i - 1) in ("=", "..") and m.word(i + 1) == "m"
        if m.word(i + 1) in ("m", "deg") and (declared or i in arguments) and float(m.word(i)) < 250:
            yield i, [(i, i + 2, TOO_DEEP if m.word(i + 1) == "m" else TOO_STEEP)]


@kind("hemisphere")
def hemisphere(m):
    """the other hemisphere: E for W, S for N, or the sign of a bare position"""
    for i in range(len(m.tokens)):
        if m.kind(i) == "unit" and m.word(i) in ("N", "S", "E", "W"):
            yield i, [(i, i + 1, {"N": "S", "S": "N", "E": "W", "W": "E"}[m.word(i)])]
    for call in m.calls(("nav",)):
        for first, end in call.arguments:
            if m.word(first) == "-" and end == first + 2:
                yield first, [(first, first + 1, "")]
            elif end == first + 1 and m.kind(first) == "number":
                yield first, [(first, first, "-")]


@kind("letter-dropped")
def letter_dropped(m):
    """decimal degrees without their letter"""
    for i in range(len(m.tokens)):
        if m.kind(i) == "unit" and m.word(i) in ("N", "S", "E", "W"):
            yield i, [(i, i + 1, "")]


@kind("latitude-for-longitude")
def latitude_for_longitude(m):
    """the numbers of latitude and longitude have changed places"""
    for i in numbers(m):
        if m.word(i + 1) in ("N", "S") and m.kind(i + 1) == "unit":
            lon = i + 2 + (m.word(i + 2) == ",")
            yield i, swapped(m, (i, i + 1), (lon, lon + 1))


@kind("degrees-for-minutes")
def degrees_for_minutes(m):
    """decimal degrees where ddmm.mmmm stands, or 75 minutes"""
    for call in m.calls(("nav",)):
        for first, end in call.arguments:
            if m.kind(end - 1) == "number" and float(m.word(end - 1)) > 181:
                degrees, minutes = divmod(float(m.word(end - 1)), 100)
                yield first, [(end - 1, end, f"{degrees + minutes / 60:.4f}")]
                yield first, [(end - 1, end, f"{100 * degrees + 75:g}")]


@kind("sensor-not-listed")
def sensor_not_listed(m):
    """an entry of `sensors` is not there"""
    for i in range(len(m.tokens)):
        if m.word(i) == "sensors":
            j = i + 1
            while m.kind(j) == "name" and m.word(j) not in ("events", "var", "entry"):
                end = j + 1
                if m.word(end) == ",":
                    yield j, [(j, end + 1, "")]
                elif m.word(end) == "every" and m.word(j - 1) == ",":
                    yield j, [(j - 1, end, "")]
                elif m.word(j - 1) == ",":
                    yield j, [(j - 1, end, "")]
                while m.word(end) == "every" or m.kind(end) in ("number", "unit") or m.word(end) == ",":
                    end += 1
                j = end


@kind("clamp-dropped")
def clamp_dropped(m):
    """a value itself where `clamp`, `min` or `max` bounded it"""
    for call in m.calls(("clamp", "min", "max")):
        yield call.at, [(call.at, m.closing(call.at + 1) + 1, m.source(*call.arguments[0]))]


@kind("wrong-variable")
def wrong_variable(m):
    """another variable is set"""
    names = [name for _, name, _ in m.declared("var")]
    for i in range(len(m.tokens)):
        if m.word(i) == "set":
            new = other(names, m.word(i + 1))
            if new:
                yield i, [(i + 1, i + 2, new)]


@kind("plus-for-minus")
def plus_for_minus(m):
    """`+` for `-`, or the other way round"""
    for i in range(len(m.tokens)):
        two_sided = m.kind(i - 1) in ("number", "unit", "name") or m.word(i - 1) in (")", "]")
        if m.word(i) in ("+", "-") and two_sided:
            yield i, [(i, i + 1, other("+-", m.word(i)))]


@kind("initial-out-of-range")
def initial_out_of_range(m):
    """a variable or parameter starts outside its range"""
    for word in ("var", "param"):
        for i, _, _ in m.declared(word):
            equals = next(j for j in range(i, len(m.tokens)) if m.word(j) == "=")
            end = equals + 2 + (m.kind(equals + 2) == "unit")
            if m.kind(equals + 1) == "number" and m.word(end) == "in":
                yield i, [(equals + 1, equals + 2, "9999")]


@kind("set-to-itself")
def set_to_itself(m):
    """a variable is set to what it is"""
    for i in range(len(m.tokens)):
        if m.word(i) == "set" and expression_end(m, i + 3) > i + 4:
            yield i, [(i + 3, expression_end(m, i + 3), m.word(i + 1))]


def swapped(m, one, two):
    return [(*one, m.source(*two)), (*two, m.source(*one))]
