# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""What a log says of one segment of a flight: the joules drawn, its times, dives and depths, and which devices were on."""

import bisect
import dataclasses
import statistics

# What is read of a log.
SENSORS = {"m_coulomb_amphr_total", "m_battery_inst", "m_depth", "m_pitch", "m_battpos", "c_ballast_pumped", "c_logger_on",
           "sci_dvl_ensemble_offset", "sci_flntu_chlor_units"}
UNDER_m = 2.0          # deeper is under water
SHALLOWEST_DIVE_m = 10.0
SETTLED_m = 6.0        # from both turns: the vehicle glides steadily
TOP_m = 3.0            # of the yos of both missions; their vehicle obeyed one to three cycles later
GAP_s = 20.0           # an instrument that is on has a reading as often


class Unusable(Exception):
    """A segment that cannot be checked; the text says why."""


@dataclasses.dataclass(frozen=True)
class Segment:
    """One segment as the log has it; times in seconds since its first record."""
    name: str
    joules: float
    count_joules: float      # that of one count of the coulomb counter
    seconds: float
    dives_s: float           # the first command to dive
    surfaces_s: float        # the last climb passes UNDER_m; no later than `seconds`
    dives: int               # strokes of the pump outwards, under water
    top_m: float             # where the turns were commanded; at the bottom on average
    bottom_m: float
    dive_m_s: float
    climb_m_s: float
    dive_rad: float
    climb_rad: float
    battery_in: float        # of the pitch battery in dives and climbs
    on: dict                 # instrument: the share of the time for which it is on


def joules(log):
    """The joules drawn, by the charge counted and the voltage at that time, and those of one count."""
    charge = log.series("m_coulomb_amphr_total")
    volts = log.series("m_battery_inst")
    if len(charge) < 100 or not volts:
        raise Unusable("no count of the charge with the voltage")
    times = [time for time, _ in volts]
    total, counts = 0.0, []
    for (_, before), (time, after) in zip(charge, charge[1:]):
        voltage = volts[max(0, bisect.bisect_right(times, time) - 1)][1]
        total += (after - before) * 3600 * voltage
        counts += [(after - before) * 3600 * voltage] if after > before else []
    return total, min(counts, default=0.0)


def turns(log):
    """(s, depth, down): where the pump was commanded to the other side."""
    commands = log.series("c_ballast_pumped")
    found, side = [], None
    for time, cc in commands:
        down = cc < 0
        if side is not None and down != side and cc != 0:
            found.append((time, log.value("m_depth", time) or 0.0, down))
        side = down if cc else side
    return found


def glides(log, found, end):
    """(down, [(s, depth)]) of each leg between two turns."""
    depths = log.series("m_depth")
    times = [time for time, _ in depths]
    for k, (time, _, down) in enumerate(found):
        until = found[k + 1][0] if k + 1 < len(found) else end
        yield down, depths[bisect.bisect_left(times, time):bisect.bisect_left(times, until)]


def rate(leg, top, bottom):
    """The vertical speed of the steady part of a leg, m/s; None if it is too short."""
    steady = [(time, depth) for time, depth in leg if top + SETTLED_m < depth < bottom - SETTLED_m]
    if len(steady) < 5:
        return None
    return abs(steady[-1][1] - steady[0][1]) / (steady[-1][0] - steady[0][0])


def rates(legs, top, bottom):
    """The vertical speeds of dives and climbs, m/s."""
    found = [(down, rate(leg, top, bottom)) for down, leg in legs]
    both = [[speed for down, speed in found if down == way and speed] for way in (True, False)]
    if not all(both):
        raise Unusable("no steady dives and climbs")
    return tuple(statistics.mean(speeds) for speeds in both)


def pitches(log, legs, top, bottom):
    """The mean pitches of steady dives and climbs, rad, both positive."""
    values = {True: [], False: []}
    for down, leg in legs:
        values[down] += [abs(log.value("m_pitch", time) or 0) for time, depth in leg
                         if top + SETTLED_m < depth < bottom - SETTLED_m]
    return tuple(statistics.mean(values[way]) for way in (True, False))


def share_on(log, name, seconds):
    """The share of the time for which an instrument had readings."""
    times = [time for time, _ in log.series(name)]
    return sum(b - a for a, b in zip(times, times[1:]) if b - a < GAP_s) / seconds


def share_set(log, name, end, seconds):
    """The share of the time for which a device was commanded to be on: 0 or more."""
    series = log.series(name)
    ends = [time for time, _ in series[1:]] + [end]
    return sum(until - time for (time, value), until in zip(series, ends) if value >= 0) / seconds


def segment_of(log):
    """The facts of a log; Unusable if it cannot be checked."""
    total, count = joules(log)
    start, end = log.flight_times[0], log.flight_times[-1]
    found = turns(log)
    ups = [depth for _, depth, down in found if not down and depth > SHALLOWEST_DIVE_m]
    if not ups:
        raise Unusable("no dive with a piston pump")
    first = next(k for k, turn in enumerate(found) if turn[2])
    top, bottom = TOP_m, statistics.mean(ups)
    legs = list(glides(log, found[first:], end))
    sinks, climbs = rates(legs, top, bottom)
    dive, climb = pitches(log, legs, top, bottom)
    under = [time for time, depth in log.series("m_depth") if depth > UNDER_m]
    seconds = end - start
    on = {"fluorometer": share_on(log, "sci_flntu_chlor_units", seconds),
          "dvl": share_on(log, "sci_dvl_ensemble_offset", seconds),
          "logger": share_set(log, "c_logger_on", end, seconds)}
    return Segment(log.name, total, count, seconds, found[first][0] - start, under[-1] - start, len(ups), top, bottom,
                   sinks, climbs, dive, climb, statistics.median(inches for _, inches in log.series("m_battpos")), on)
