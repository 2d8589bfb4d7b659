# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""Compares two flights of a mission: its transitions, where they happened, and the depths between them."""

import math

from dune_parts import imc

MOST_APART_M = 15  # what DUNE takes as arrived
MOST_DEPTH_M = 0.5
MOST_SECONDS, MOST_SHARE = 5, 0.03  # of the time of a transition
SETTLES_S = 90  # after a transition, until the depths count
TURN_M = 1  # the vehicle has turned when it has come back by so much


def metres(a, b):
    """Between two (latitude, longitude) in degrees, a few km apart at most."""
    lat = math.radians(a[0])
    across_m, along_m = imc.radii(lat)
    return math.hypot(math.radians(a[0] - b[0]) * along_m, math.radians(a[1] - b[1]) * across_m * math.cos(lat))


def place_at(flight, seconds):
    """The newest (latitude, longitude) then."""
    row = [row for row in flight.track if row[0] <= seconds][-1]
    return row[1:3]


def turns(depths):
    """The depths at which it turns, upper and lower; those of a level flight are none."""
    upper, lower, down, extreme = [], [], None, depths[0]
    for depth in depths:
        if down is None:
            down = depth > depths[0] if abs(depth - depths[0]) > TURN_M else None
        elif (depth - extreme) * (1 if down else -1) < -TURN_M:
            (lower if down else upper).append(extreme)
            down = not down
            extreme = depth
        extreme = depth if down is None else (max if down else min)(extreme, depth)
    return upper[1:], lower[1:]


def depths_of(flight, begin, end):
    """(upper, lower) mean turn between two mission times, or the mean depth twice of a level flight; None of a short one."""
    depths = [row[3] for row in flight.track if begin + SETTLES_S <= row[0] < end]
    if len(depths) < SETTLES_S:
        return None
    upper, lower = turns(depths)
    if not upper or not lower:
        upper = lower = depths
    return sum(upper) / len(upper), sum(lower) / len(lower)


def compare(here, there):
    """Rows of the table, each (what, here, there, apart, whether that is too much)."""
    names = lambda flight: [f"{origin} → {to}" for _, origin, to in flight.transitions]
    if names(here) != names(there):
        return [("transitions", ", ".join(names(here)), ", ".join(names(there)), "", True)]
    rows, begin_here, begin_there = [], 0, 0
    for (seconds, origin, to), (other, *_) in zip(here.transitions, there.transitions):
        for side, a, b in zip(("upper", "lower"), depths_of(here, begin_here, seconds) or (),
                              depths_of(there, begin_there, other) or ()):
            rows.append((f"{origin}: {side} depth, m", f"{a:.2f}", f"{b:.2f}", f"{b - a:+.2f}", abs(b - a) > MOST_DEPTH_M))
        late = other - seconds
        rows.append((f"{origin} → {to}: mission time, s", f"{seconds:.0f}", f"{other:.0f}", f"{late:+.0f}",
                     abs(late) > MOST_SECONDS + MOST_SHARE * seconds))
        apart = metres(place_at(here, seconds), place_at(there, other))
        rows.append((f"{origin} → {to}: place, m apart", "", "", f"{apart:.1f}", apart > MOST_APART_M))
        begin_here, begin_there = seconds, other
    return rows
