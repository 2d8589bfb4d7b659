# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""The rows about how the vehicle moves up and down, its pump, its commands and its cycle.

Depths are those of the flight controller (`depth_motion`), unless a method says otherwise.
"""

import bisect
import statistics

from world_parts.logs import between, depth_motion, without_false
from world_parts.rows import LEAST, MOST, row

DIVE, SURFACE = 1, 0  # values of cc_final_depth_state_mode; 2 is climb
SERVO = 3  # value of cc_final_pitch_mode: a pitch in rad
HOOK_ACTIVE = 3  # value of x_hook_state
METRES_PER_BAR = 1e5 / (1025 * 9.80665)  # in sea water
OWN_SILENCE = 16  # s without a frame; then the mission ticks by the SBC's own clock (runtime/core/mission_clock.h)
SETTLED = 30  # s after a command; until then the vehicle turns, and its glide is not steady
LONGEST_OFFSET = 6.0  # s between the flight controller's depth and the science computer's, either way
OVERRUN = 2.0  # s longer than usual: the cycle has overrun
LONGEST_CYCLE = 30.0  # s; a longer one is a gap in the log
SCIENCE_GAP = 6  # s; over a longer one the CTD's depth is not known


def commands(log):
    """(mode, begin, end) of each commanded vertical mode, in order; the last ends with the log."""
    series = log.series("cc_final_depth_state_mode")
    starts = [(t, mode) for i, (t, mode) in enumerate(series) if i == 0 or series[i - 1][1] != mode]
    ends = [t for t, _ in starts[1:]] + [t for t, _ in series[-1:]]
    return [(mode, begin, end) for (begin, mode), end in zip(starts, ends)]


def steady(log, times):
    """Those of the times that are in a steady glide: SETTLED seconds or more after a command to dive or climb."""
    begins = [begin + SETTLED for mode, begin, _ in commands(log) if mode != SURFACE]
    ends = [end for mode, _, end in commands(log) if mode != SURFACE]
    found = []
    for time in times:
        i = bisect.bisect_right(begins, time) - 1
        if i >= 0 and time <= ends[i]:
            found.append(time)
    return found


def climbs(log):
    """(begin, end) from each command that ends a dive to the next command to dive, or to the end of the log."""
    found, dived = [], False
    for mode, begin, end in commands(log):
        if mode == DIVE:
            dived = True
        elif dived and found and found[-1][1] == begin:
            found[-1] = (found[-1][0], end)  # on to the surface: the same climb
        elif dived:
            found.append((begin, end))
    return found


@row("envelope", "greatest_depth_m", MOST, "m_depth of a vehicle with m_ballast_pumped")
def greatest_depth(log, platform):
    """A limit for commands. Compared with the greatest m_depth of vehicles with this pump (m_ballast_pumped); others may go deeper."""
    if log.series("m_ballast_pumped"):
        yield from ((value, time) for time, value in depth_motion(log))


def servo_pitches(log):
    return ((abs(pitch), t) for t, pitch, mode in log.together("cc_final_pitch_value", "cc_final_pitch_mode") if mode == SERVO)


@row("envelope", "steepest_pitch_rad", MOST, "cc_final_pitch_value in mode 3")
def steepest_pitch(log, platform):
    """A limit for commands. Compared with the pitches that real missions command in rad (cc_final_pitch_mode 3)."""
    yield from servo_pitches(log)


@row("envelope", "shallowest_pitch_rad", LEAST, "cc_final_pitch_value in mode 3")
def shallowest_pitch(log, platform):
    """A limit for commands. Compared with the pitches that real missions command in rad (cc_final_pitch_mode 3)."""
    yield from servo_pitches(log)


def speeds(series, shortest):
    """(mean speed, begin) from each reading to the first one at least `shortest` seconds later."""
    times = [t for t, _ in series]
    for i, (begin, depth) in enumerate(series):
        j = bisect.bisect_left(times, begin + shortest)
        if j < len(series):
            yield abs(series[j][1] - depth) / (times[j] - begin), begin


@row("envelope", "vertical_rate_m_s", MOST, "m_depth or sci_water_pressure")
def vertical_rate(log, platform):
    """The mean vertical speed between two readings at least cycle_s apart, at the surface and below it, waves included: by
    m_depth, and by the CTD's pressure, which does not share the flight sensor's faults. Readings of m_depth from cycles that
    overran are left out, as they were taken seconds later than recorded; so are single readings of either sensor that are 1 m or
    more above both neighbours or below both."""
    cycle = platform["envelope"]["cycle_s"]
    yield from speeds(depth_motion(log), cycle)
    yield from speeds(without_false([(t, bar * METRES_PER_BAR) for t, bar in log.series("sci_water_pressure")]), cycle)


@row("envelope", "inflection_overshoot_m", MOST, "cc_final_depth_state_mode, m_depth")
def inflection_overshoot(log, platform):
    """How far the vehicle goes below the depth at which the command changes from dive to climb (cc_final_depth_state_mode),
    until it dives again. The vehicle's yo changes its command at the target depth or altitude, so this is also how far it
    goes past a target. How far it rises past the upper target does not count: no proof assumes anything about that."""
    depth = depth_motion(log)
    for begin, end in climbs(log):
        climb = between(depth, begin, end)
        if climb:
            yield max((d - climb[0][1], t) for t, d in climb)


# drift_m_s is in place_rows.


@row("envelope", "pump_cc", MOST, "m_ballast_pumped")
def pump(log, platform):
    """The farthest position of the buoyancy pump on either side (m_ballast_pumped). Vehicles with an oil pump
    (m_de_oil_vol) are other vehicles."""
    yield from ((abs(value), time) for time, value in log.series("m_ballast_pumped"))


@row("envelope", "fin_rad", MOST, "m_fin")
def fin(log, platform):
    """The farthest position of the fin on either side (m_fin)."""
    yield from ((abs(value), time) for time, value in log.series("m_fin"))


@row("envelope", "cycle_s", LEAST, "every cycle")
def cycle(log, platform):
    """The usual length of a control cycle: the median time between the records of flight files with every cycle. The bounds on the
    serial lines and on the storage card assume that cycles are not shorter. Longer ones are in the row tick_gap_s."""
    if log.every_cycle and log.cycle():
        yield log.cycle(), log.flight_times[0]


def dives(log, platform):
    return any(depth > platform["world"]["surface_depth_m"] for _, depth in log.series("m_depth"))


@row("world", "start_depth_m", MOST, "x_hook_state: no vehicle with hookbeh")
def start_depth(log, platform):
    """m_depth in the cycle in which hookbeh gets control (x_hook_state becomes 3)."""
    states = log.series("x_hook_state")
    for (_, before), (time, after) in zip(states, states[1:]):
        if before != HOOK_ACTIVE == after and log.newest("m_depth", time):
            yield log.value("m_depth", time), time


@row("world", "surface_depth_m", MOST, "m_gps_lat while the surface is commanded")
def surface_depth(log, platform):
    """A definition: a vehicle at this depth or above counts as at the surface. Compared with m_depth of a vehicle that certainly
    is, because it gets a GPS fix while the surface is commanded (cc_final_depth_state_mode 0)."""
    yield from ((depth, t) for t, _, mode, depth in log.together("m_gps_lat", "cc_final_depth_state_mode", "m_depth")
                if mode == SURFACE)


@row("world", "slowest_climb_m_s", LEAST, "cc_final_depth_state_mode, m_depth")
def slowest_climb(log, platform):
    """The mean speed of a climb from turn_s after the command until each later reading at least tick_gap_s after that, as long as
    the vehicle has not reached surface_depth_m and has no other command."""
    world, depth = platform["world"], depth_motion(log)
    for begin, end in climbs(log):
        climb = between(depth, begin + world["turn_s"], end)
        for time, reached in climb:
            if reached <= world["surface_depth_m"]:
                break
            if time - climb[0][0] >= world["tick_gap_s"]:
                yield (climb[0][1] - reached) / (time - climb[0][0]), time


@row("world", "turn_s", MOST, "cc_final_depth_state_mode, m_depth")
def turn(log, platform):
    """The time from a command to climb that ends a dive until the vehicle is deepest: from then on it climbs."""
    depth = depth_motion(log)
    for begin, end in climbs(log):
        climb = between(depth, begin, end)
        if climb:
            deepest = max(climb, key=lambda reading: reading[1])
            yield deepest[0] - begin, begin


def ctd_depth(ctd, times, time):
    """The CTD's depth at a time between two of its readings; None in a gap."""
    i = bisect.bisect_right(times, time)
    if not 0 < i < len(times) or times[i] - times[i - 1] > SCIENCE_GAP:
        return None
    (begin, a), (end, b) = ctd[i - 1], ctd[i]
    return a + (b - a) * (time - begin) / (end - begin)


@row("world", "depth_error_m", MOST, "m_depth and sci_water_pressure")
def depth_error(log, platform):
    """The difference between m_depth and the CTD's depth in sea water of 1025 kg/m3, in every cycle, at the surface and below.
    The two computers' clocks and the moments of reading differ by a constant of at most 6 s: the one with the smallest mean
    difference. A cycle that overruns is dated from its beginning and reads its depth at some time before its end: there, the smallest
    difference in the cycle counts. The mission gets the reading when the cycle is over, so it is not old then. Single readings count."""
    ctd = [(t, bar * METRES_PER_BAR) for t, bar in log.series("sci_water_pressure")]
    times = [t for t, _ in ctd]
    depths = log.series("m_depth")
    usual = log.cycle() or platform["envelope"]["cycle_s"]

    def moments(time, end):
        """When the depth of the cycle from `time` to `end` may have been read: every half second of one that overran."""
        over = min(end - time, LONGEST_CYCLE) if end - time > usual + OVERRUN else 0
        return [time + k / 2 for k in range(int(2 * over) + 1)]

    def errors(offset):
        for (t, depth), end in zip(depths, [t for t, _ in depths[1:] + depths[-1:]]):
            others = [ctd_depth(ctd, times, moment + offset) for moment in moments(t, end)]
            found = [abs(depth - other) for other in others if other is not None]
            if found:
                yield min(found), t

    offsets = [k / 4 for k in range(int(-4 * LONGEST_OFFSET), int(4 * LONGEST_OFFSET) + 1)]
    found = [(statistics.fmean(e for e, _ in all_errors), all_errors) for all_errors in map(list, map(errors, offsets)) if all_errors]
    if log.every_cycle and found:
        yield from min(found, key=lambda pair: pair[0])[1]


@row("world", "tick_gap_s", MOST, "every cycle of a vehicle under water")
def tick_gap(log, platform):
    """The time between two ticks if every cycle sends a frame and none is lost: the time between two records of flight files with
    every cycle, of vehicles that dive. After 16 s without a frame the mission ticks by the SBC's own clock, and a frame may arrive
    one cycle late: a gap longer than both together counts as 16 s."""
    if log.every_cycle and dives(log, platform):
        for begin, end in zip(log.flight_times, log.flight_times[1:]):
            gap = end - begin
            yield gap if gap <= OWN_SILENCE + log.cycle() else OWN_SILENCE, begin


@row("world", "line_lag_s", MOST, "m_science_clothesline_lag under water")
def line_lag(log, platform):
    """How late the science computer's values are on the flight controller: m_science_clothesline_lag, which compares the two clocks, in
    cycles deeper than surface_depth_m. At the surface, where the computers begin and a console may suspend the line, it can be longer."""
    for time, lag in log.series("m_science_clothesline_lag"):
        depth = log.value("m_depth", time)
        if depth is not None and depth > platform["world"]["surface_depth_m"]:
            yield lag, time
