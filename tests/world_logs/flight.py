# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""A made-up flight as `glidercc log --csv` writes it: to a depth and back, within the environment model unless told otherwise."""

import dataclasses
import math

PLATFORM = {
    "envelope": {"greatest_depth_m": 60.0, "steepest_pitch_rad": 0.7854, "shallowest_pitch_rad": 0.19, "vertical_rate_m_s": 0.4,
                 "inflection_overshoot_m": 5.0, "drift_m_s": 0.5, "pump_cc": 233.0, "fin_rad": 0.45, "cycle_s": 4.0},
    "world": {"start_depth_m": 3.0, "surface_depth_m": 2.0, "slowest_climb_m_s": 0.05, "turn_s": 120.0, "depth_error_m": 0.5,
              "tick_gap_s": 20.0, "through_water_m_s": 0.6, "steering_error_m": 200.0, "surface_drift_m_s": 0.8,
              "line_lag_s": 8.0},
    "sensor": [{"name": "m_depth", "unit": "m", "stale_after_s": 20.0, "noise": 0.1, "lowest": 0.0, "highest": 1200.0}],
}
START = 1.5e9  # UTC, s
METRES_PER_BAR = 9.948
METRES_PER_MINUTE = 1853.2  # of latitude


@dataclasses.dataclass
class Flight:
    """What the vehicle does; each field can be changed to break a row."""
    bottom_m: float = 40
    sinks_mps: float = 0.2
    climbs_mps: float = 0.15
    beyond_m: float = 1.5
    turns_s: float = 12
    floats_m: float = 0.2
    pitch_rad: float = 0.45
    cycle_s: float = 4.5
    water_mps: float = 0.3
    pump_cc: float = 231
    fin_rad: float = 0.44
    control_m: float = 0
    error_m: float = 0         # of one reading of m_depth under water
    late_s: float = 0          # one cycle takes so much longer, and reads its depth at the end of it
    gap_s: float = 0           # one cycle takes so much longer, at the surface
    speed_mps: float = 0.3
    off_m: float = 0           # from the line to the waypoint
    drifts_mps: float = 0.5
    lag_s: float = 4.2         # of the line between the computers
    floats_s: float = 300      # after the climb
    without: tuple = ()        # names of sensors

    def csv(self):
        """The log as text."""
        rows = list(self.flight_rows())
        times = [time for time, _ in rows]
        names = sorted({name for _, row in rows for name in row} | {"sci_water_pressure"})
        science = [(t, {"sci_water_pressure": self.depth(t) / METRES_PER_BAR}) for t in range(0, int(times[-1]))]
        lines = [f"time_s,computer,{','.join(names)}"]
        for time, computer, row in sorted([(t, "flight", r) for t, r in rows] + [(t, "science", r) for t, r in science],
                                          key=lambda line: line[:2]):
            kept = {name: value for name, value in row.items() if name not in self.without}
            lines.append(f"{START + time},{computer}," + ",".join(f"{kept[n]:.9g}" if n in kept else "" for n in names))
        return "\n".join(lines) + "\n"

    def phases(self):
        """Moments, s: the commands to dive and to climb, the deepest moment, and when it floats."""
        dive = 100
        climb = dive + (self.bottom_m - self.floats_m) / self.sinks_mps
        deepest = climb + self.turns_s
        floats = deepest + (self.bottom_m + self.beyond_m - self.floats_m) / self.climbs_mps
        return dive, climb, deepest, floats

    def depth(self, time):
        dive, climb, deepest, floats = self.phases()
        low = self.bottom_m + self.beyond_m
        if time <= dive or time >= floats:
            return self.floats_m
        if time <= climb:
            return self.floats_m + self.sinks_mps * (time - dive)
        if time <= deepest:
            return self.bottom_m + self.beyond_m * (time - climb) / self.turns_s
        return low - self.climbs_mps * (time - deepest)

    def flight_rows(self):
        dive, climb, _, floats = self.phases()
        time, number = 0.0, 0
        middle = int((dive + climb) / 2 / self.cycle_s)
        while time < floats + self.floats_s:
            length = self.cycle_s + self.late_s * (number == middle) + self.gap_s * (number == 3)
            depth = self.depth(time + length - self.cycle_s if number == middle else time)
            yield time, self.row(time, depth + self.error_m * (number == middle))
            time, number = time + length, number + 1

    def row(self, time, depth):
        dive, climb, _, floats = self.phases()
        mode = 0 if time < dive else 1 if time < climb else 2 if time < floats - 20 else 0
        row = {"m_depth": depth, "cc_final_depth_state_mode": mode, "m_ballast_pumped": -self.pump_cc if mode == 1 else self.pump_cc, "m_fin": -self.fin_rad,
               "cc_final_pitch_mode": 3, "cc_final_pitch_value": -self.pitch_rad if mode == 1 else self.pitch_rad,
               "m_speed": self.speed_mps if mode else 0, "m_science_clothesline_lag": self.lag_s, "x_hook_state": 3 if time >= dive and self.depth(time) >= self.control_m
               or time > climb else 2}
        if time < dive or time > floats:
            row["m_gps_lat"] = 5400 + self.drifts_mps * time / METRES_PER_MINUTE
            row["m_gps_lon"] = 700
        if time < 3:
            row |= {"c_wpt_x_lmc": 0, "c_wpt_y_lmc": 10000, "m_water_vx": self.water_mps, "m_water_vy": 0}
        if dive < time < floats:
            along = (time - dive) / (floats - dive)
            row |= {"cc_final_heading_mode": 0, "m_y_lmc": self.speed_mps * (time - dive),
                    "m_x_lmc": self.water_mps * (time - dive) + self.off_m * math.sin(math.pi * along)}
        return row


def log_text(**series):
    """A log of the flight controller and, for sensors named sci_..., of the science computer: of each sensor, [(s, value)]."""
    names = sorted(series)
    lines = [(time, "science" if name.startswith("sci_") else "flight", {name: value})
             for name in names for time, value in series[name]]
    merged = {}
    for time, computer, values in lines:
        merged.setdefault((time, computer), {}).update(values)
    rows = [f"{START + time},{computer}," + ",".join(str(values.get(name, "")) for name in names)
            for (time, computer), values in sorted(merged.items())]
    return "\n".join([f"time_s,computer,{','.join(names)}", *rows]) + "\n"
