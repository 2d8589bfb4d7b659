# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""Missions that have very many of one construct of the language each. Deterministic: no seed."""

import math

PROFILE = "  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)\n"
SENSORS = "  sensors       missiontime, statetime, depth, temp, altitude, lat, lon\n"
GOLDEN = 137.50776405  # degrees: points that this turns by from one to the next spread evenly


def state(name, *cases, route="", body=""):
    """A state with these cases."""
    return (f"state {name}\nbegin\n{route and f'  flightroute   {route}' + chr(10)}{PROFILE}{SENSORS}{body}  events\n"
            + "".join(f"    case {c}\n" for c in cases) + "end\n")


def mission(*parts):
    return "mission shape\n" + "".join(parts)


def ring(n, route=lambda i: "", body=lambda i: "", cases=lambda i: ()):
    """States that follow each other, 10 s each, until 50 h have passed."""
    return "".join(state(f"s{i}", "missiontime >= 50 h exit", *cases(i), f"statetime >= 10 s goto s{(i + 1) % n}",
                         route=route(i), body=body(i)) for i in range(n))


def one(*cases, **more):
    """A single state with these cases."""
    return state("s0", "missiontime >= 50 h exit", *cases, **more)


def over_the_sea(i, n):
    """The i-th of n positions, spread evenly over the oceans' latitudes."""
    latitude = math.degrees(math.asin(1.7 * (i + 0.5) / n - 0.85))
    longitude = (i * GOLDEN) % 360 - 180
    return f"{abs(latitude):.4f} {'N' if latitude >= 0 else 'S'} {abs(longitude):.4f} {'E' if longitude >= 0 else 'W'}"


def on_the_shelf(i, n):
    """The i-th of n positions, spread evenly over a disc of 50 km."""
    radius, angle = 0.45 * math.sqrt((i + 0.5) / n), math.radians(i * GOLDEN)
    return f"{39 + radius * math.sin(angle):.6f} N {73 + radius * math.cos(angle):.6f} W"


def round_an_area(n, step=1):
    """n corners of a star-shaped area about 39 N 73 W; `step`: every so many."""
    corners = []
    for i in range(0, n, step):
        angle, radius = 2 * math.pi * i / n, 0.5 if i % 2 else 0.45
        corners.append(f"{39 + radius * math.sin(angle):.6f} N {73 + radius * math.cos(angle):.6f} W")
    return ", ".join(corners)


def states(n):
    """states"""
    return mission(ring(n))


def waypoints_over_the_sea(n):
    """states with a waypoint each, over all oceans"""
    return mission(ring(n, route=lambda i: f"nav({over_the_sea(i, n)})"))


def waypoints_on_the_shelf(n):
    """states with a waypoint each, within 50 km"""
    return mission(ring(n, route=lambda i: f"nav({on_the_shelf(i, n)})"))


def waypoints_in_three_places(n):
    """states with one of three waypoints each"""
    return mission(ring(n, route=lambda i: f"nav({over_the_sea(i % 3, 3)})"))


def positions_of_a_path(n):
    """positions of a path"""
    track = ", ".join(on_the_shelf(i, n) for i in range(n))
    return mission(f"const track : path = [{track}]\n", one(route="along(track, 100 m)"))


def corners_required(n):
    """corners of an area that is required"""
    return mission(f"require always inside({round_an_area(n)})\n", one(route="nav(39 N, 73 W)"))


def areas_required(n):
    """areas that are required"""
    return mission(f"require always inside({round_an_area(6)})\n" * n, one(route="nav(39 N, 73 W)"))


def corners_of_a_guard(n):
    """corners of an area in a guard"""
    return mission(one(f"inside({round_an_area(n)}) goto s1"), state("s1", "missiontime >= 50 h exit"))


def cases(n):
    """cases of a state"""
    return mission("var n : number = 0 in 0 .. 10\n",
                   one(*(f"temp > {i % 40} degC && depth > {i / 100} m do set n = {i % 11} end stay" for i in range(n))))


def cases_of_always(n):
    """cases of always"""
    return mission("var n : number = 0 in 0 .. 10\nalways\n",
                   "".join(f"  case temp > {i % 40} degC && depth > {i / 100} m do set n = {i % 11} end stay\n"
                           for i in range(n)), one())


def gotos_of_a_state(n):
    """states to which one state may go"""
    return mission(one(*(f"depth > {5 + i / n} m && temp > {i % 30} degC goto t{i}" for i in range(n))),
                   *(state(f"t{i}", "missiontime >= 50 h exit") for i in range(n)))


def calls_of_a_state(n):
    """states that one state may call"""
    return mission(one(*(f"depth > {5 + i / n} m && temp > {i % 30} degC call t{i}" for i in range(n))),
                   *(state(f"t{i}", "statetime >= 10 s return") for i in range(n)))


def calls_in_a_row(n):
    """states that call each other in a row"""
    return mission(state("s0", "missiontime >= 50 h exit", "temp > 20 degC call s1"),
                   *(state(f"s{i}", "statetime >= 10 s return", f"temp > 20 degC call s{i + 1}") for i in range(1, n - 1)),
                   state(f"s{n - 1}", "statetime >= 10 s return"))


def windows(n):
    """windows over time, one in a state"""
    return mission(ring(n, cases=lambda i: (f"mean(temp, 60 s) > {i % 40} degC && depth > 4 m exit",)))


def windows_of_a_state(n):
    """windows of one state"""
    return mission("var n : number = 0 in 0 .. 10\n",
                   one(*(f"mean(temp, {60 + 4 * i} s) > {i % 40} degC do set n = {i % 11} end stay" for i in range(n))))


def held_of_a_state(n):
    """held conditions of one state"""
    return mission("var n : number = 0 in 0 .. 10\n",
                   one(*(f"held(temp > {i % 40} degC, {10 + i} s) do set n = {i % 11} end stay" for i in range(n))))


def became_of_a_state(n):
    """became conditions of one state"""
    return mission("var n : number = 0 in 0 .. 10\n",
                   one(*(f"became(depth > {1 + i / n * 18} m) do set n = {i % 11} end stay" for i in range(n))))


def variables(n):
    """variables, each set in a state"""
    return mission(*(f"var v{i} : number = 0 in 0 .. 10\n" for i in range(n)),
                   ring(n, cases=lambda i: (f"became(depth > 10 m) do set v{i} = clamp(v{i} + 1, 0, 10) end stay",)))


def parameters(n):
    """parameters, each a depth of a state"""
    return mission(*(f"param p{i} : length = 20 m in 10 m .. 30 m\n" for i in range(n)),
                   ring(n, cases=lambda i: (f"depth > p{i} && temp > 4 degC exit",)))


def conditions_of_parameters(n):
    """parameters with a condition on the one before"""
    return mission("param p0 : length = 20 m in 10 m .. 30 m\n",
                   *(f"param p{i} : length = 20 m in 10 m .. 30 m where p{i} >= p{i - 1}\n" for i in range(1, n)),
                   one(f"depth > p{n - 1} exit"))


def constants(n):
    """constants, each made of the one before"""
    return mission("const c0 = 1 m\n", *(f"const c{i} = c{i - 1} + 1 mm\n" for i in range(1, n)),
                   one(f"depth > c{n - 1} exit"))


def terms_of_a_sum(n):
    """terms of one sum"""
    return mission(one("depth > " + " + ".join(f"{1 + i % 7} mm" for i in range(n)) + " && temp > 4 degC exit",
                       "depth + " + " + ".join("depth * 0.001" for _ in range(n)) + " > 30 m exit"))


def terms_of_a_condition(n):
    """comparisons of one condition"""
    return mission(one(" || ".join(f"(depth > {i % 20} m && temp > {i % 31} degC)" for i in range(n)) + " exit"))


def statements(n):
    """statements of a case"""
    return mission("var n : number = 0 in 0 .. 10\n",
                   one("became(depth > 10 m) do " + "\n".join(f"set n = clamp(n + {i % 3}, 0, 10)" for i in range(n))
                       + " end stay"))


def branches(n):
    """if statements of a case"""
    return mission("var n : number = 0 in 0 .. 10\n",
                   one("became(depth > 10 m) do " + "\n".join(f"if temp > {i % 40} degC then set n = {i % 11} end"
                                                              for i in range(n)) + " end stay"))


def logs(n):
    """log statements, one in a state"""
    return mission(ring(n, body=lambda i: f"  entry do log \"state {i}\", depth, temp end\n"))


def profiles(n):
    """profiles of the mission's own, one for each state"""
    own = "".join(f"flightprofile own{i}(bottom: length) begin flightprofile yo(3 m, bottom, 26 deg, 26 deg) end\n"
                  for i in range(n))
    return mission(own, ring(n).replace("yo(5 m, 20 m, 26 deg, 26 deg)", "own0(20 m)"))


def cases_of_a_profile(n):
    """cases of a profile"""
    own = ("flightprofile own(bottom: length)\nbegin\n  entry do surface() end\n  events\n"
           + "".join(f"    case depth <= {i / n} m do descend(bottom, 26 deg) end stay\n" for i in range(n))
           + "    case depth >= bottom do surface() end stay\nend\n")
    return mission(own, one().replace("yo(5 m, 20 m, 26 deg, 26 deg)", "own(20 m)"))


def functions_in_c(n):
    """functions in C, one in a guard each"""
    return mission(*(f"extern function f{i}(depth: length): number in 0 .. 10\n" for i in range(n)),
                   ring(n, cases=lambda i: (f"f{i}(depth) > 5 exit",)))


def requirements_at_a_moment(n):
    """requirements about a moment"""
    return mission(*(f"require always depth < {26 + i} m && missiontime <= {60 + i} h\n" for i in range(n)), ring(3))


def requirements_of_surfacing(n):
    """requirements of surfacing, all proved"""
    return mission(*(f"require surfaces every {51 * 60 + i} min\n" for i in range(n)), ring(3))


def promises(n):
    """promises about places"""
    return mission(*(f"require visit s1 at least once within {60 + i} h or exit\n" for i in range(n)), ring(3))


def assumptions(n):
    """assumptions, with one requirement"""
    return mission(*(f"assume depth < {1000 + i} m || temp > {i / n} degC\n" for i in range(n)),
                   "require always depth <= 25 m\n", ring(3))


def comments(n):
    """lines of comments"""
    return mission("# what the next state is for\n" * n, one())


def errors(n):
    """errors"""
    return mission(ring(n, cases=lambda i: (f"temperature{i} > 5 degC exit",)))


# A shape, and the smaller of its two sizes: the larger has four times as many.
SHAPES = ((states, 2500), (waypoints_over_the_sea, 2500), (waypoints_on_the_shelf, 2500), (waypoints_in_three_places, 2500),
          (positions_of_a_path, 1000), (corners_required, 250), (areas_required, 100), (corners_of_a_guard, 250),
          (cases, 500), (cases_of_always, 500), (gotos_of_a_state, 1000), (calls_of_a_state, 1000), (calls_in_a_row, 1250),
          (windows, 1000), (windows_of_a_state, 50), (held_of_a_state, 250), (became_of_a_state, 250), (variables, 1000),
          (parameters, 500), (conditions_of_parameters, 250), (constants, 2500), (terms_of_a_sum, 500),
          (terms_of_a_condition, 250), (statements, 500), (branches, 500), (logs, 2500), (profiles, 1000),
          (cases_of_a_profile, 250), (functions_in_c, 500), (requirements_at_a_moment, 50), (requirements_of_surfacing, 50),
          (promises, 10), (assumptions, 25), (comments, 10000), (errors, 1000))
