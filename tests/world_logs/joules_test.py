#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""What scripts/joules_against_logs reads from a log, on logs of a few readings, and the vehicle file that it writes."""

import dataclasses
import math
import pathlib
import sys
import tomllib
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.dont_write_bytecode = True
sys.path[:0] = [str(pathlib.Path(__file__).resolve().parent), str(ROOT / "scripts")]

from joules_parts import segment as segments  # noqa: E402
from joules_parts import vehicle  # noqa: E402
from world_parts import logs as log_files  # noqa: E402
from flight import log_text  # noqa: E402

SLOCUM = (ROOT / "platforms" / "slocum.toml").read_text(encoding="utf-8")
TOP, BOTTOM = 2.0, 42.0


def depth(time):
    """Two dives of 800 s, from 100 s on, at 0.1 m/s."""
    if not 100 <= time < 1700:
        return 0.0
    leg = (time - 100) % 800
    return TOP + 0.1 * (leg if leg < 400 else 800 - leg)


def sinks(time):
    return 100 <= time < 1700 and (time - 100) % 800 < 400


def flown(**without):
    """A log of those dives: 0.1 A at 14 V all the time, an instrument that is on for 400 s."""
    times = [4.0 * k for k in range(451)]
    series = {"m_depth": [(t, depth(t)) for t in times], "m_pitch": [(t, -0.4 if sinks(t) else 0.5) for t in times],
              "m_battpos": [(t, 0.4) for t in times], "m_battery_inst": [(0.0, 14.0)],
              "c_ballast_pumped": [(t, -233 if sinks(t) else 233) for t in times],
              "m_coulomb_amphr_total": [(t, 100 + 0.1 * t / 3600) for t in times],
              "c_logger_on": [(t, 0 if 100 <= t < 1000 else -1) for t in times],
              "sci_flntu_chlor_units": [(200.0 + k, 1.0) for k in range(401)]}
    return log_files.Log("made_up", log_text(**{name: s for name, s in series.items() if name not in without}), every_cycle=True)


class Segment(unittest.TestCase):
    def setUp(self):
        self.segment = segments.segment_of(flown())

    def test_joules_are_charge_times_voltage(self):
        self.assertAlmostEqual(self.segment.joules, 0.1 * 14 * 1800, delta=0.1)
        self.assertAlmostEqual(self.segment.count_joules, 0.1 * 14 * 4, delta=0.01)

    def test_dives_and_times(self):
        one = self.segment
        self.assertEqual((one.dives, one.seconds, one.dives_s), (2, 1800, 100))
        self.assertAlmostEqual(one.surfaces_s, 1696, delta=4)
        self.assertAlmostEqual(one.bottom_m, BOTTOM, delta=0.5)

    def test_speeds_and_pitches_are_of_steady_legs(self):
        one = self.segment
        for speed in (one.dive_m_s, one.climb_m_s):
            self.assertAlmostEqual(speed, 0.1, delta=1e-6)
        self.assertAlmostEqual(one.dive_rad, 0.4, delta=1e-6)
        self.assertAlmostEqual(one.climb_rad, 0.5, delta=1e-6)
        self.assertEqual(one.battery_in, 0.4)

    def test_an_instrument_is_on_while_it_reads_and_a_device_while_it_is_commanded(self):
        self.assertAlmostEqual(self.segment.on["fluorometer"], 400 / 1800, delta=1e-6)
        self.assertAlmostEqual(self.segment.on["logger"], 900 / 1800, delta=4 / 1800)
        self.assertEqual(self.segment.on["dvl"], 0)

    def test_what_cannot_be_checked_says_why(self):
        for name, why in (("m_coulomb_amphr_total", "no count of the charge"), ("m_battery_inst", "no count of the charge"),
                          ("c_ballast_pumped", "no dive with a piston pump")):
            with self.subTest(name), self.assertRaisesRegex(segments.Unusable, why):
                segments.segment_of(flown(**{name: None}))


class Vehicle(unittest.TestCase):
    def platform(self, **on):
        one = dataclasses.replace(segments.segment_of(flown()), on=on)
        return tomllib.loads(vehicle.platform_text(SLOCUM, one))

    def draws(self, device, **on):
        return [one["W"] for one in self.platform(**on)["power"]["draw"] if one["device"] == device and one["when"] == "always"]

    def test_a_device_is_counted_for_the_share_of_the_time_for_which_it_is_on(self):
        dvl = next(device for device in vehicle.DEVICES if device.name == "dvl")
        self.assertEqual(self.draws("dvl", dvl=0.5, logger=0.0), [round(dvl.watt * 0.5, 4)])
        self.assertEqual(self.draws("dvl", dvl=0.0, logger=0.0), [])

    def test_an_instrument_of_the_table_has_the_number_of_the_table(self):
        table = next(one["W"] for one in tomllib.loads(SLOCUM)["power"]["draw"] if one["device"] == "fluorometer")
        self.assertTrue(math.isclose(self.draws("fluorometer", fluorometer=0.25, dvl=0, logger=0)[0], table / 4, abs_tol=1e-4))

    def test_it_has_its_trim_and_no_sbc(self):
        platform = self.platform(dvl=0, logger=0)
        self.assertNotIn("board", platform["power"])
        self.assertEqual(platform["name"], vehicle.NAME)
        for key, value in vehicle.TRIM.items():
            self.assertEqual(platform["motion"][key], value)


if __name__ == "__main__":
    unittest.main()
