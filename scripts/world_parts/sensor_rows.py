# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""The rows of [[sensor]]: age, noise and range of readings.

Proofs allow any reading to be unknown, so one that is too old or out of range breaks nothing: the lines say how often
a mission would get none.
"""

import bisect
import dataclasses
import math
import statistics

from world_parts.logs import LATE
from world_parts.place_rows import fix_delays
from world_parts.rows import HOLDS, LEAST, MOST, NOT_HERE, Line, Seen, worst
from world_parts.vehicle_rows import steady

USUAL = 0.95  # the share of readings whose noise the row covers: the others are waves, gradients and false readings
# x[k] minus the mean of its neighbours has 1.5 times the variance of one reading, the difference of two readings 2 times.
TO_DIFFERENCE = math.sqrt(2 / 1.5)


def ages(log, platform, name):
    """(age, UTC s) of the newest update in each cycle under water, just before the cycle, in files with every cycle.

    A sensor that has no update yet, or none in the file, yields nothing.
    """
    times = [t for t, _ in log.series(name)]
    for t, depth in log.series("m_depth") if times and log.every_cycle else ():
        count = bisect.bisect_left(times, t)
        if depth > platform["world"]["surface_depth_m"] and count:
            yield t - times[count - 1], t


def noises(log, name, turns):
    """(difference, UTC s): how much neighbouring readings in a steady glide differ beyond a steady change, as of two readings of the
    same water."""
    series = log.series(name)
    glide = set(steady(log, [t for t, _ in series]))
    gaps = [b[0] - a[0] for a, b in zip(series, series[1:])]
    longest = LATE * statistics.median(gaps) if gaps else 0
    for k in range(1, len(series) - 1):
        (_, a), (t, x), (_, b) = series[k - 1:k + 2]
        across = turns and max(abs(x - a), abs(b - x)) > math.pi  # through north
        if t in glide and gaps[k - 1] <= longest and gaps[k] <= longest and not across:
            yield TO_DIFFERENCE * abs(x - (a + b) / 2), t


def stale_line(logs, platform, sensor):
    """How old the newest reading is under water: a mission sees none that is older than stale_after_s."""
    name, limit = f"{sensor['name']}.stale_after_s", sensor["stale_after_s"]
    seen = worst(MOST, logs, lambda log: ages(log, platform, sensor["name"]))
    if seen is None:
        return Line(name, limit, None, None, NOT_HERE)
    all_ages = [age for log in logs for age, _ in ages(log, platform, sensor["name"])]
    unknown = sum(age > limit for age in all_ages) / len(all_ages)
    return Line(name, limit, seen, limit - seen.value, f"unknown in {unknown:.1%} of cycles under water" if unknown else HOLDS)


def noise_line(logs, sensor):
    """The noise that 95 % of the differences keep to, and where it is reached."""
    name, limit, turns = f"{sensor['name']}.noise", sensor["noise"], sensor["unit"] == "rad"
    found = sorted((d, log.name, t) for log in logs if log.every_cycle for d, t in noises(log, sensor["name"], turns))
    if not found:
        return Line(name, limit, None, None, NOT_HERE)
    value, log, time = found[math.ceil(USUAL * len(found)) - 1]
    verdict = HOLDS if value <= limit else "larger: a remark of check --report may be missing"
    return Line(name, limit, Seen(value, log, time), limit - value, verdict)


def range_line(logs, sensor):
    """The reading nearest to the end of the range or beyond it: a mission sees none that is outside."""
    name, low, high = f"{sensor['name']} range", sensor["lowest"], sensor["highest"]
    seen = worst(LEAST, logs, lambda log: ((min(v - low, high - v), t) for t, v in log.series(sensor["name"])))
    if seen is None:
        return Line(name, f"{low:.4g}..{high:.4g}", None, None, NOT_HERE)
    log = next(log for log in logs if log.name == seen.log)
    values = [v for each in logs for _, v in each.series(sensor["name"])]
    unknown = sum(not low <= v <= high for v in values)
    verdict = f"unknown in {unknown} of {len(values)} readings" if unknown else HOLDS
    at = dataclasses.replace(seen, value=log.value(sensor["name"], seen.time))
    return Line(name, f"{low:.4g}..{high:.4g}", at, seen.value, verdict)


def fix_line(logs, platform):
    seen = worst(MOST, logs, lambda log: fix_delays(log, platform))
    return Line("first GPS fix after surfacing, s", None, seen, None, NOT_HERE if seen is None else "no proof assumes a time")


def lines(logs, platform):
    """The lines of all sensors: age, noise if the sensor has that row, and range."""
    for sensor in platform["sensor"]:
        yield stale_line(logs, platform, sensor)
        if "noise" in sensor:
            yield noise_line(logs, sensor)
        yield range_line(logs, sensor)
    yield fix_line(logs, platform)
