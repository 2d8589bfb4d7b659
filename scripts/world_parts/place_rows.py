# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""The rows about where the vehicle goes: currents, speed through the water, straight legs, drift at the surface."""

import math
import statistics

from world_parts.logs import between, settled
from world_parts.rows import MOST, row
from world_parts.vehicle_rows import SETTLED, commands, dives

EARTH = 6371000.0  # m
TO_WAYPOINT = 0  # value of cc_final_heading_mode
GLIDE = 60  # s over which m_speed is averaged
SHORTEST_STAY, LONGEST_STAY = 60, 300  # s between two fixes at the surface


@row("envelope", "drift_m_s", MOST, "m_water_vx, m_water_vy")
def drift(log, platform):
    """The current that the vehicle finds when it surfaces: the difference between its first GPS fix and its dead-reckoned position,
    by the time under water (m_water_vx, m_water_vy; m_final_water_vx, m_final_water_vy). The error of the dead reckoning is in it,
    as in the row."""
    for x, y in (("m_water_vx", "m_water_vy"), ("m_final_water_vx", "m_final_water_vy")):
        yield from ((math.hypot(vx, vy), t) for t, vx, vy in log.together(x, y))


@row("world", "through_water_m_s", MOST, "cc_final_depth_state_mode, m_speed")
def through_water(log, platform):
    """m_speed, which the vehicle computes from depth rate and pitch, as the mean over 60 s of a steady glide: from 30 s after a
    command to dive or climb until the next command, below surface_depth_m. While the vehicle turns, m_speed is not its speed."""
    for mode, begin, end in commands(log):
        glide = [(t, v) for t, v in between(log.series("m_speed"), begin + SETTLED, end)
                 if (log.value("m_depth", t) or 0) > platform["world"]["surface_depth_m"]]
        for time, _ in glide if mode else ():
            part = [v for t, v in glide if time <= t < time + GLIDE]
            if glide[-1][0] - time >= GLIDE and part:
                yield abs(statistics.fmean(part)), time


def off_line(point, begin, end):
    """The distance of a point from the straight line between two others, m."""
    x, y = end[0] - begin[0], end[1] - begin[1]
    length = math.hypot(x, y)
    px, py = point[0] - begin[0], point[1] - begin[1]
    if length == 0:
        return math.hypot(px, py)
    along = min(max((px * x + py * y) / length**2, 0), 1)
    return math.hypot(px - along * x, py - along * y)


@row("world", "steering_error_m", MOST, "c_wpt_x_lmc, m_x_lmc, m_water_vx, cc_final_heading_mode 0")
def steering_error(log, platform):
    """How far the dead-reckoned position (m_x_lmc, m_y_lmc) gets from the straight line between the place where the waypoint was
    commanded (c_wpt_x_lmc) and the waypoint, beyond what the current in the dead reckoning (m_water_vx, m_water_vy) can have moved
    the vehicle since: proofs add the drift to this row. It counts while the vehicle steers to the waypoint
    (cc_final_heading_mode 0). A GPS fix moves the dead-reckoned position by the error of that current: it begins a new line."""
    fixes = {t for t, _ in log.series("m_gps_lat")}
    waypoint, begin = None, None
    for time, x, y, mode in log.together("m_x_lmc", "m_y_lmc", "cc_final_heading_mode"):
        known = [log.value(name, time) for name in ("c_wpt_x_lmc", "c_wpt_y_lmc", "m_water_vx", "m_water_vy")]
        if mode != TO_WAYPOINT or None in known or time in fixes:
            begin = None
        elif begin is None or known[:2] != waypoint:
            begin, waypoint = (time, x, y), known[:2]
        else:
            drifted = math.hypot(*known[2:]) * (time - begin[0])
            yield max(off_line((x, y), begin[1:], waypoint) - drifted, 0), time


def degrees(nmea):
    """Degrees of a latitude or longitude as the vehicle writes it, dddmm.mmmm."""
    whole = math.trunc(nmea / 100)
    return whole + (nmea - 100 * whole) / 60


def metres(a, b):
    """The distance of two fixes (s, latitude, longitude), as on a flat map."""
    north = math.radians(b[1] - a[1])
    east = math.radians(b[2] - a[2]) * math.cos(math.radians(a[1]))
    return EARTH * math.hypot(north, east)


def stays(log, surface_depth_m):
    """Lists of GPS fixes (s, latitude, longitude) of one stay at the surface each."""
    fixes = [fix for fix in log.together("m_gps_lat", "m_gps_lon") if abs(fix[1]) <= 9000 and abs(fix[2]) <= 18000]
    for north, east in [([(t, lat) for t, lat, _ in fixes], [(t, lon) for t, _, lon in fixes])]:
        fixes = [(t, degrees(lat), degrees(lon)) for (t, lat), (_, lon) in zip(settled(north), settled(east))]
    stay = []
    for fix in fixes:
        below = stay and any(d > surface_depth_m for _, d in between(log.series("m_depth"), stay[-1][0], fix[0]))
        if below or stay and fix[0] - stay[-1][0] > LONGEST_STAY:
            yield stay
            stay = []
        stay.append(fix)
    yield stay


@row("world", "surface_drift_m_s", MOST, "GPS fixes at least 60 s apart in one stay of a vehicle that dives")
def surface_drift(log, platform):
    """The speed between two GPS fixes 60 s to 300 s apart in one stay at the surface, of vehicles that dive (not of one on a ship or
    ashore): over a shorter time the error of the fixes counts for more than the drift. A single fix that stands out is replaced by
    the median of itself and its neighbours."""
    if not dives(log, platform) and not log.series("m_water_vx"):
        return
    for stay in stays(log, platform["world"]["surface_depth_m"]):
        for i, a in enumerate(stay):
            yield from ((metres(a, b) / (b[0] - a[0]), a[0]) for b in stay[i + 1:]
                        if SHORTEST_STAY <= b[0] - a[0] <= LONGEST_STAY)


def fix_delays(log, platform):
    """The time from the last reading below surface_depth_m to the first GPS fix after it, while the surface is commanded."""
    surface = platform["world"]["surface_depth_m"]
    fixes, found = [t for t, _ in log.series("m_gps_lat")], set()
    below = [t for t, depth in log.series("m_depth") if depth > surface]
    for time in fixes if log.every_cycle else ():
        last = max((t for t in below if t < time), default=None)
        if last is not None and last not in found and log.value("cc_final_depth_state_mode", time) == 0:
            found.add(last)
            yield time - last, time
