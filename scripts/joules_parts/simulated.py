# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""A logged segment flown in the simulator: the same dives, depths, speeds and times at the surface."""

import csv
import dataclasses
import json
import math
import os
import pathlib
import subprocess

from joules_parts import segment as segments
from joules_parts import vehicle

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PUMP_cc = 233.0
JOULES_PER_WATTHOUR = 3600
TRIES = 3  # flights until the speeds are those of the log

# For the bound: the same dives commanded by an SBC, which adds no power here.
MISSION = """mission as_logged
platform {platform}
pack 400 Ah at 14.4 V
state wait
begin
  flightroute   noheading
  flightprofile surfaced
  sensors       missiontime, depth
  events
    case missiontime >= {dives:.0f} s goto fly
end
state fly
begin
  flightroute   heading(270 deg)
  flightprofile yo({top:.1f} m, {bottom:.1f} m, {dive:.1f} deg, {climb:.1f} deg)
  sensors       missiontime, depth
  events
    case missiontime >= {surfaces:.0f} s goto float
end
state float
begin
  flightroute   noheading
  flightprofile surfaced
  sensors       missiontime, depth
  events
    case missiontime >= {end:.0f} s exit
end
"""

# For the estimate: the vehicle's own mission, as it was flown, with the battery still. The time at the surface before the first dive
# comes at the end.
OWN_MISSION = """behavior: surface
    b_arg: start_when(enum)         9
    b_arg: when_secs(s)         {flies:.0f}
    b_arg: end_action(enum)         1
    b_arg: gps_wait_time(s)     86400
    b_arg: keystroke_wait_time(s) 86400
    b_arg: c_use_pitch(enum)        3
    b_arg: c_pitch_value(X)         0.4363
behavior: set_heading
    b_arg: use_heading(bool)        1
    b_arg: heading_value(X)         4.7
    b_arg: start_when(enum)         0
    b_arg: stop_when(enum)          5
behavior: yo
    b_arg: start_when(enum)         2
    b_arg: num_half_cycles_to_do(nodim) -1
    b_arg: d_target_depth(m)        {bottom:.2f}
    b_arg: d_target_altitude(m)     -1
    b_arg: d_use_pitch(enum)        1
    b_arg: d_pitch_value(X)         {battery:.3f}
    b_arg: d_bpump_value(X)         -1000
    b_arg: c_target_depth(m)        {top:.2f}
    b_arg: c_target_altitude(m)     -1
    b_arg: c_use_pitch(enum)        1
    b_arg: c_pitch_value(X)         {battery:.3f}
    b_arg: c_bpump_value(X)         1000
"""

SCENARIO = """name = "as_logged"
skeleton = "{skeleton}"
duration_s = {seconds:.0f}
seed = 1
[start]
latitude_deg = 54.5
longitude_deg = 7.0
[ocean]
surface_temp_degC = 18
bottom_temp_degC = 16
thermocline_depth_m = 17
thermocline_thickness_m = 3
density_kgm3 = 1025
water_depth_m = {water:.0f}
[vehicle]
mass_kg = 65
hull_volume_m3 = {volume:.9f}
drag = {drag:.5f}
[vehicle.battery]
sbc_W = 0
"""


class FlightError(Exception):
    """The simulator refused the flight; the text says why."""


@dataclasses.dataclass(frozen=True)
class Estimate:
    joules: float
    bound_joules: float
    dives: int
    devices: dict  # joules by device


@dataclasses.dataclass
class Hull:
    """What the speeds of the log are fitted with."""
    drag: float = 0.15
    light_cc: float = 0.0


def share_folder(folder, share, text):
    """A data folder of glidercc that also has this vehicle."""
    made = folder / "share"
    (made / "platforms").mkdir(parents=True)
    for part in share.iterdir():
        if part.name != "platforms":
            (made / part.name).symlink_to(part)
    for file in (share / "platforms").iterdir():
        (made / "platforms" / file.name).symlink_to(file)
    (made / "platforms" / f"{vehicle.NAME}.toml").write_text(text, encoding="utf-8")
    return made


class Simulator:
    def __init__(self, glidercc, folder, slocum, segment):
        self.segment, self.glidercc, self.folder = segment, pathlib.Path(glidercc).resolve(), folder
        share = self.glidercc.parent.parent / "share" / "glidercc"
        self.share = share_folder(folder, share, vehicle.platform_text(slocum, segment))
        self.write("m.mission", MISSION.format(
            platform=vehicle.NAME, dives=segment.dives_s, top=segment.top_m, bottom=segment.bottom_m, end=segment.seconds,
            dive=math.degrees(segment.dive_rad), climb=math.degrees(segment.climb_rad), surfaces=segment.surfaces_s))
        self.write("own.mi", OWN_MISSION.format(flies=segment.surfaces_s - segment.dives_s, top=segment.top_m,
                                                bottom=segment.bottom_m, battery=segment.battery_in))

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")

    def fly(self, *mission, hull, skeleton):
        """The figures of one flight."""
        self.write("w.toml", SCENARIO.format(skeleton=skeleton, seconds=self.segment.seconds, water=self.segment.bottom_m + 40,
                                             volume=65 / 1025 + hull.light_cc / 1e6, drag=hull.drag))
        done = subprocess.run([self.glidercc, "sim", *mission, "--scenario", "w.toml", "-o", "f", "-q"], cwd=self.folder,
                              env={**os.environ, "GLIDERCC_SHARE": str(self.share)}, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise FlightError(done.stderr or done.stdout)
        return json.loads((self.folder / "f" / "flight.json").read_text(encoding="utf-8"))["figures"]

    def fly_own(self, hull):
        return self.fly("--no-sbc", "--platform", vehicle.NAME, hull=hull, skeleton="own.mi")

    def legs(self):
        """The dives and climbs of the last flight, as `segments.glides` has those of a log."""
        found = []
        with open(self.folder / "f" / "trace.csv", encoding="utf-8", newline="") as file:
            for row in csv.DictReader(file):
                if row["c_ballast_pumped (cc)"]:
                    down = float(row["c_ballast_pumped (cc)"]) < 0
                    if not found or found[-1][0] != down:
                        found.append((down, []))
                    found[-1][1].append((float(row["time (s)"]), float(row["true_depth (m)"])))
        return found

    def fit(self):
        """The hull whose dives and climbs are as fast as those of the log."""
        hull, one = Hull(), self.segment
        for _ in range(TRIES):
            self.fly_own(hull)
            dive, climb = segments.rates(self.legs(), one.top_m, one.bottom_m)
            down = (PUMP_cc - hull.light_cc) * (one.dive_m_s / dive) ** 2
            up = (PUMP_cc + hull.light_cc) * (one.climb_m_s / climb) ** 2
            scale = 2 * PUMP_cc / (down + up)
            hull = Hull(hull.drag * scale, (up - down) * scale / 2)
        return hull

    def estimate(self):
        hull = self.fit()
        bound = self.fly("m.mission", hull=hull, skeleton=ROOT / "scenarios" / "skeleton.mi")["energy"].get("atMost", math.nan)
        figures = self.fly_own(hull)
        dives = sum(not down and max(depth for _, depth in leg) > segments.SHALLOWEST_DIVE_m for down, leg in self.legs())
        return Estimate(figures["energy"]["used"] * JOULES_PER_WATTHOUR, bound * JOULES_PER_WATTHOUR, dives,
                        {one["device"]: one["used"] * JOULES_PER_WATTHOUR for one in figures["energy"]["consumers"]})
