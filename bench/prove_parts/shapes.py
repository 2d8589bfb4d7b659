# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""Large missions for the prover, in the mission language, by what there is much of. Deterministic: no seed."""

PROFILE = "  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)\n"
SENSORS = "  sensors       missiontime, statetime, temp, depth, altitude\n"


def state(name, *cases):
    """A state with these cases."""
    return f"state {name}\nbegin\n{PROFILE}{SENSORS}  events\n" + "".join(f"    case {c}\n" for c in cases) + "end\n"


def mission(body, requirements=()):
    """A mission that promises these."""
    return "mission large\n" + "".join(f"require {r}\n" for r in requirements) + body


def usual(last, count):
    """That many requirements of a mission that ends after 50 h and counts in `n`; `last` is its last state."""
    some = ["always n <= 10", "always missiontime <= 60 h", "exit within 60 h", "surfaces every 60 h", "always depth <= 25 m",
            "always depth <= 25 m && n >= 0", f"reach {last}", "stack <= 0", f"always missiontime - statetime >= 0 s || n < 0",
            "always missiontime + 1 s > missiontime"]
    more = [f"always n <= 10 && missiontime <= {60 + k} h && depth < {26 + k} m" for k in range(count)]
    return (some + more)[:count]


def ring(n):
    """States that follow each other, 10 s each, until 50 h have passed."""
    return "".join(state(f"s{i}", "missiontime >= 50 h exit",
                         f"statetime >= 10 s do set n = clamp(n + 1, 0, 10) end goto s{(i + 1) % n}") for i in range(n))


def states(n):
    """states that follow each other; no requirement"""
    return mission("var n : number = 0 in 0 .. 10\n" + ring(n))


def states_20(n):
    """the same with 20 requirements"""
    return mission("var n : number = 0 in 0 .. 10\n" + ring(n), usual(f"s{n - 1}", 20))


def calls_4(n):
    """each state calls the next; 4 requirements"""
    last = state(f"s{n - 1}", "statetime >= 10 s return")
    first = state("s0", "missiontime >= 50 h exit", "temp > 20 degC call s1")
    middle = "".join(state(f"s{i}", "statetime >= 10 s return", f"temp > 20 degC call s{i + 1}") for i in range(1, n - 1))
    return mission("var n : number = 0 in 0 .. 10\n" + first + middle + last,
                   [f"stack <= {n}", "always depth <= 25 m", "always n <= 10", "never s0 after s1"])


def variables_4(n):
    """variables that a state each counts up; 4 requirements"""
    declared = "".join(f"var v{i} : number = 0 in 0 .. 10\n" for i in range(n))
    body = "".join(state(f"s{i}", "missiontime >= 50 h exit",
                         f"statetime >= 10 s do set v{i} = clamp(v{i} + 1, 0, 10) end goto s{(i + 1) % n}")
                   for i in range(n))
    return mission(declared + body, ["always v0 <= 10", f"always v{n - 1} + v0 <= 20", "exit within 60 h",
                                     "always depth <= 25 m"])


def always_2(n):
    """cases of `always` that each go to a state; 2 requirements"""
    cases = "always\n" + "".join(f"  case temp > {i / 100} degC && depth > {i / 10} m do log \"{i}\" end stay\n"
                                 for i in range(n - 1)) + "  case missiontime >= 50 h exit\n"
    return mission("var n : number = 0 in 0 .. 10\n" + cases + ring(2),
                   ["exit within 60 h", "always n <= 10"])


def always_calls_2(n):
    """cases of `always` that each call a state; 2 requirements"""
    cases = "always\n" + "".join(f"  case temp > {i / 100} degC call t{i}\n" for i in range(n))
    called = "".join(state(f"t{i}", "statetime >= 10 s return") for i in range(n))
    return mission(cases + state("s0", "missiontime >= 50 h exit") + called, ["exit within 1000 h", "always depth <= 25 m"])


def guards_1(n):
    """guards with arithmetic; 1 requirement"""
    cases = [f"temp * {1 + i / 1000} + depth * 1 degC/m / {2 + i} > {i} degC && altitude / {1 + i / 7} < temp * 2 m/degC + "
             f"depth do set n = clamp(n + 1, 0, 10) end stay" for i in range(n)]
    return mission("var n : number = 0 in 0 .. 10\n" + state("s0", "missiontime >= 50 h exit", *cases), ["always n <= 10"])


def requirements(n):
    """requirements alone"""
    return mission("var n : number = 0 in 0 .. 10\n" + ring(3),
                   [f"always n * n <= {90 + k} && temp * depth <= {k} degC*m" for k in range(n)])


SHAPES = ((states, (100, 1000, 10000)), (states_20, (100, 450, 1000)), (calls_4, (50, 500, 5000)),
          (variables_4, (20, 200)), (always_2, (40, 400)), (always_calls_2, (4, 40, 400)), (guards_1, (100, 1000)),
          (requirements, (10, 100)))
