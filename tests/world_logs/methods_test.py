#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""What each method of scripts/world_against_logs counts, and what it leaves out, on logs of a few readings."""

import pathlib
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.dont_write_bytecode = True
sys.path[:0] = [str(pathlib.Path(__file__).resolve().parent), str(ROOT / "scripts")]

from world_parts import logs as log_files  # noqa: E402
from world_parts import place_rows, rows, sensor_rows, vehicle_rows  # noqa: E402
from flight import PLATFORM, Flight, log_text  # noqa: E402


def small(**series):
    return log_files.Log("small", log_text(**series), every_cycle=True)


def every(seconds, values, begin=0.0):
    return [(begin + k * seconds, value) for k, value in enumerate(values)]


class MethodTest(unittest.TestCase):
    def measured(self, table, key, log):
        return [value for value, _ in rows.ROWS[table, key].measure(log, PLATFORM)]

    def of_flight(self, table, key, **change):
        return self.measured(table, key, log_files.Log("flight", Flight(**change).csv(), every_cycle=True))


class Vehicle(MethodTest):
    def test_a_battery_position_is_no_pitch(self):
        log = small(cc_final_pitch_value=every(4, [1.2, -0.4]), cc_final_pitch_mode=every(4, [1, 3]))
        self.assertEqual(self.measured("envelope", "steepest_pitch_rad", log), [0.4])
        self.assertEqual(self.measured("envelope", "shallowest_pitch_rad", log), [0.4])

    def test_the_vertical_rate_is_up_and_down_by_either_sensor(self):
        for sensor in ("m_depth", "sci_water_pressure"):
            for change in ({"sinks_mps": 0.42}, {"climbs_mps": 0.42}):
                speeds = self.of_flight("envelope", "vertical_rate_m_s", without=(sensor,), **change)
                self.assertAlmostEqual(max(speeds), 0.42, delta=0.005)

    def test_a_false_pressure_of_the_ctd_is_no_motion(self):
        log = small(sci_water_pressure=every(1, [1, 1, 1, 5, 1, 1, 1, 1, 1]))
        self.assertEqual(max(self.measured("envelope", "vertical_rate_m_s", log)), 0)

    def test_a_depth_that_stays_changed_is_motion(self):
        log = small(m_depth=every(4, [10, 10, 18, 18, 18, 18]))
        self.assertEqual(max(self.measured("envelope", "vertical_rate_m_s", log)), 2)

    def test_a_vehicle_that_floats_has_ended_its_climb(self):
        speeds = self.of_flight("world", "slowest_climb_m_s", floats_s=2000)
        self.assertAlmostEqual(min(speeds), 0.15, delta=0.01)

    def test_a_climb_at_the_surface_counts_while_it_is_commanded_only(self):
        log = small(m_gps_lat=every(4, [5400] * 3), m_depth=every(4, [0.2, 3.5, 0.3]), cc_final_depth_state_mode=every(4, [0, 1, 0]))
        self.assertEqual(self.measured("world", "surface_depth_m", log), [0.2, 0.3])

    def test_the_ctds_depth_in_a_gap_is_not_known(self):
        ctd = [(0, 1.0), (1, 2.0), (8, 9.0)]
        self.assertEqual(vehicle_rows.ctd_depth(ctd, [0, 1, 8], 0.5), 1.5)
        for time in (-1, 4, 9):
            self.assertIsNone(vehicle_rows.ctd_depth(ctd, [0, 1, 8], time))

    def test_a_vehicle_that_does_not_dive_has_no_ticks(self):
        log = small(m_depth=every(15, [0, 0.1, 0]))
        self.assertEqual(self.measured("world", "tick_gap_s", log), [])
        self.assertEqual(self.measured("envelope", "cycle_s", log), [15])


class Place(MethodTest):
    def test_both_estimates_of_the_current_count(self):
        log = small(m_final_water_vx=[(0, 0.3)], m_final_water_vy=[(0, 0.4)], m_water_vx=[(4, 0.0)], m_water_vy=[(4, -0.1)])
        self.assertEqual(sorted(self.measured("envelope", "drift_m_s", log)), [0.1, 0.5])

    def test_the_speed_counts_in_a_steady_glide_only(self):
        seconds = range(0, 400, 4)
        log = small(m_depth=[(t, 10) for t in seconds],
                    cc_final_depth_state_mode=[(t, 0 if t < 100 else 1 if t < 300 else 2) for t in seconds],
                    m_speed=[(t, 0.9 if t < 130 or 300 <= t < 330 else 0.3) for t in seconds])
        speeds = self.measured("world", "through_water_m_s", log)
        self.assertAlmostEqual(max(speeds), 0.3, delta=0.05)
        self.assertGreater(len(speeds), 20)

    def steering(self, modes, fixes=()):
        log = small(m_x_lmc=every(4, [0, 0, 50, 50]), m_y_lmc=every(4, [0, 10, 20, 30]), cc_final_heading_mode=every(4, modes),
                    c_wpt_x_lmc=[(0, 0)], c_wpt_y_lmc=[(0, 1000)], m_water_vx=[(0, 0)], m_water_vy=[(0, 0)],
                    m_gps_lat=[(t, 5400) for t in fixes])
        return self.measured("world", "steering_error_m", log)

    def test_steering_counts_while_it_is_to_a_waypoint_from_the_newest_fix_on(self):
        self.assertEqual(max(self.steering([0, 0, 0, 0])), 50)
        self.assertEqual(self.steering([0, 0, 4, 4]), [0])
        self.assertLess(max(self.steering([0, 0, 0, 0], fixes=(4,))), 50.1)
        self.assertLess(max(self.steering([0, 0, 0, 0], fixes=(8,))), 1)

    def test_a_degree_of_longitude_is_shorter_in_the_north(self):
        self.assertAlmostEqual(place_rows.metres((0, 60, 0), (9, 60, 1)), 55597, delta=10)
        self.assertAlmostEqual(place_rows.metres((0, 0, 0), (9, 1, 0)), 111195, delta=10)

    def surface_drift(self, seconds, depths, metres):
        lat = [(t, 5400 + 0.01 * x / 18.532) for t, x in zip(seconds, metres)]
        return self.measured("world", "surface_drift_m_s", small(
            m_gps_lat=lat, m_gps_lon=[(t, 700) for t in seconds], m_depth=[*zip(seconds, depths), (9999, 20)]))

    def test_drift_is_over_a_minute_or_more_of_one_stay(self):
        self.assertAlmostEqual(max(self.surface_drift((0, 30, 60, 90), (0,) * 4, (0, 15, 30, 45))), 0.5, delta=0.01)
        self.assertEqual(self.surface_drift((0, 20, 40, 50), (0,) * 4, (0, 40, 80, 120)), [])
        self.assertEqual(self.surface_drift((0, 40, 50, 60, 100), (0, 0, 9, 0, 0), (0, 0, 0, 900, 900)), [])


class Sensors(unittest.TestCase):
    def test_noise_counts_in_a_steady_glide_only(self):
        depths = [10 + 5 * (k % 2) for k in range(30)]
        glide = {"m_depth": every(4, depths), "cc_final_depth_state_mode": every(4, [1] * 30)}
        found = list(sensor_rows.noises(small(**glide), "m_depth", False))
        self.assertEqual(len(found), 30 - 8 - 1)  # 30 s after the command, and the last has no neighbour
        glide["cc_final_depth_state_mode"] = every(4, [0] * 30)
        self.assertEqual(list(sensor_rows.noises(small(**glide), "m_depth", False)), [])

    def test_a_heading_through_north_is_no_noise(self):
        log = small(m_heading=every(4, [6.27, 0.01] * 15), cc_final_depth_state_mode=every(4, [1] * 30))
        self.assertEqual(list(sensor_rows.noises(log, "m_heading", True)), [])
        self.assertEqual(len(list(sensor_rows.noises(log, "m_heading", False))), 21)

    def test_ages_count_under_water_from_the_first_update_on(self):
        log = small(m_depth=every(4, [0, 5, 5, 5, 0]), m_battery=[(4, 12)])
        self.assertEqual([age for age, _ in sensor_rows.ages(log, PLATFORM, "m_battery")], [4, 8])


if __name__ == "__main__":
    unittest.main()
