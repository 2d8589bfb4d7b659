#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""scripts/world_against_logs on made-up logs: each row on one that keeps it and on one that breaks it, and what it says to wrong use."""

import importlib.machinery
import importlib.util
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SCRIPT = ROOT / "scripts" / "world_against_logs"
sys.dont_write_bytecode = True
sys.path[:0] = [str(pathlib.Path(__file__).resolve().parent), str(ROOT / "scripts")]

from flight import PLATFORM, START, Flight  # noqa: E402


def load():
    loader = importlib.machinery.SourceFileLoader("world_against_logs", str(SCRIPT))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("world_against_logs", loader))
    loader.exec_module(module)
    return module


WORLD = load()
from world_parts import logs as log_files  # noqa: E402
from world_parts import place_rows, rows, sensor_rows  # noqa: E402


def log_of(text, every_cycle=True):
    return log_files.Log("made_up", text, every_cycle)


def lines_of(*flights):
    found = WORLD.row_lines([log_of(flight.csv()) for flight in flights], PLATFORM)
    return {line.row: line for line in found}


def broken(*flights):
    return {row for row, line in lines_of(*flights).items() if line.verdict == rows.BROKEN}


# What breaks each row, and it alone: just beyond the platform's number.
BREAKS = {
    "greatest_depth_m": {"bottom_m": 61},
    "steepest_pitch_rad": {"pitch_rad": 0.79},
    "shallowest_pitch_rad": {"pitch_rad": 0.18},
    "vertical_rate_m_s": {"sinks_mps": 0.42},
    "inflection_overshoot_m": {"beyond_m": 5.6, "turns_s": 60},
    "drift_m_s": {"water_mps": 0.51},
    "pump_cc": {"pump_cc": 234},
    "fin_rad": {"fin_rad": 0.46},
    "cycle_s": {"cycle_s": 3.9},
    "start_depth_m": {"control_m": 3.1},
    "surface_depth_m": {"floats_m": 2.1, "control_m": 0},
    "slowest_climb_m_s": {"climbs_mps": 0.045},
    "turn_s": {"turns_s": 131},
    "depth_error_m": {"error_m": -0.6},
    "tick_gap_s": {"gap_s": 15.9},
    "through_water_m_s": {"speed_mps": 0.62},
    "steering_error_m": {"off_m": 600},
    "surface_drift_m_s": {"drifts_mps": 0.82},
    "line_lag_s": {"lag_s": 8.1},
}


class Rows(unittest.TestCase):
    def test_a_flight_within_the_model_breaks_nothing_and_each_row_is_measured(self):
        for row, line in lines_of(Flight()).items():
            with self.subTest(row):
                self.assertEqual(line.verdict, rows.HOLDS)

    def test_each_row_can_break(self):
        self.assertEqual(set(BREAKS), {key for _, key in rows.ROWS})
        for row, change in BREAKS.items():
            with self.subTest(row):
                self.assertEqual(broken(Flight(**change)), {row})

    def test_the_worst_of_all_logs_counts(self):
        self.assertEqual(broken(Flight(), Flight(water_mps=0.6), Flight()), {"drift_m_s"})

    def test_what_the_logs_lack_is_said(self):
        lines = lines_of(Flight(without=("m_ballast_pumped", "sci_water_pressure")))
        self.assertEqual(lines["pump_cc"].verdict, "not in these logs: m_ballast_pumped")
        self.assertEqual(lines["depth_error_m"].verdict, "not in these logs: m_depth and sci_water_pressure")
        self.assertIsNone(lines["greatest_depth_m"].seen)


class Motion(unittest.TestCase):
    """What is the vehicle's motion, and what is its sensors' doing."""

    def test_a_single_false_reading_is_no_motion(self):
        self.assertEqual(broken(Flight(error_m=-8)), {"depth_error_m"})

    def test_a_depth_read_late_in_a_long_cycle_is_no_motion(self):
        self.assertEqual(broken(Flight(late_s=9)), set())

    def test_a_wrong_depth_in_a_long_cycle_is_an_error(self):
        self.assertEqual(broken(Flight(late_s=9, error_m=-4)), {"depth_error_m"})

    def test_by_the_ctd_alone_a_fast_dive_is_seen(self):
        self.assertEqual(broken(Flight(sinks_mps=0.42, without=("m_depth",))), {"vertical_rate_m_s"})

    def test_a_constant_offset_between_the_computers_is_no_error(self):
        flight = Flight(sinks_mps=0.3, climbs_mps=0.3)
        lines = flight.csv().splitlines()
        shifted = [",".join([str(float(t) + 3), *rest]) if rest[0] == "science" else line
                   for line in lines[1:] for t, *rest in [line.split(",")]]
        log = log_of("\n".join([lines[0], *sorted(shifted)]))
        error = max(value for value, _ in rows.ROWS["world", "depth_error_m"].measure(log, PLATFORM))
        self.assertLess(error, 0.2)

    def test_a_long_gap_is_bridged_by_the_sbcs_own_clock(self):
        line = lines_of(Flight(gap_s=50))["tick_gap_s"]
        self.assertEqual((line.seen.value, line.verdict), (16, rows.HOLDS))

    def test_files_with_cycles_left_out_say_nothing_about_gaps(self):
        log = log_of(Flight(gap_s=15.9).csv(), every_cycle=False)
        found = {line.row: line for line in WORLD.row_lines([log], PLATFORM)}
        for row in ("tick_gap_s", "cycle_s", "depth_error_m"):
            self.assertIsNone(found[row].seen, row)


class Places(unittest.TestCase):
    def test_the_current_in_the_dead_reckoning_is_no_steering_error(self):
        line = lines_of(Flight(water_mps=0.45))["steering_error_m"]
        self.assertLess(line.seen.value, 1)

    def test_a_vehicle_that_never_dives_does_not_drift(self):
        line = lines_of(Flight(bottom_m=1, beyond_m=0.1, drifts_mps=12, without=("m_water_vx",)))["surface_drift_m_s"]
        self.assertIsNone(line.seen)

    def test_degrees_of_the_vehicles_positions(self):
        self.assertAlmostEqual(place_rows.degrees(5430.0), 54.5)
        self.assertAlmostEqual(place_rows.degrees(-12805.4), -128.09)

    def test_off_line_is_the_distance_to_the_leg_not_to_its_extension(self):
        self.assertAlmostEqual(place_rows.off_line((3, 4), (0, 0), (100, 0)), 4)
        self.assertAlmostEqual(place_rows.off_line((-3, 4), (0, 0), (100, 0)), 5)
        self.assertAlmostEqual(place_rows.off_line((103, 4), (0, 0), (100, 0)), 5)


class Sensors(unittest.TestCase):
    def lines(self, log, **sensor):
        platform = {**PLATFORM, "sensor": [{**PLATFORM["sensor"][0], **sensor}]}
        return {line.row: line for line in sensor_rows.lines([log], platform)}

    def test_a_sensor_that_is_always_there_holds(self):
        for row, line in self.lines(log_of(Flight().csv())).items():
            if row.startswith("m_depth"):
                self.assertEqual(line.verdict, rows.HOLDS, row)

    def test_an_old_reading_is_unknown_and_breaks_nothing(self):
        line = self.lines(log_of(Flight().csv()), name="m_gps_lat", stale_after_s=60, lowest=-9000, highest=9000)["m_gps_lat.stale_after_s"]
        self.assertRegex(line.verdict, r"^unknown in [89]\d\.\d% of cycles under water$")
        self.assertLess(line.margin, 0)

    def test_readings_out_of_range_are_counted(self):
        line = self.lines(log_of(Flight().csv()), highest=41)["m_depth range"]
        self.assertRegex(line.verdict, r"^unknown in \d readings? of \d+$|^unknown in \d of \d+ readings$")
        self.assertAlmostEqual(line.seen.value, 41.5, delta=0.7)

    def test_noise_is_measured_as_the_difference_of_two_readings(self):
        rows_of = Flight().csv().splitlines()
        column = rows_of[0].split(",").index("m_depth")
        sign, text = 1, [rows_of[0]]
        for line in rows_of[1:]:
            cells = line.split(",")
            if cells[column]:
                cells[column], sign = str(float(cells[column]) + 0.2 * sign), -sign
            text.append(",".join(cells))
        line = self.lines(log_of("\n".join(text)))["m_depth.noise"]
        self.assertAlmostEqual(line.seen.value, 0.4 * (2 / 1.5) ** 0.5, delta=0.02)
        self.assertTrue(line.verdict.startswith("larger"))

    def test_the_time_to_the_first_fix(self):
        line = self.lines(log_of(Flight().csv()))["first GPS fix after surfacing, s"]
        self.assertAlmostEqual(line.seen.value, 12 + 4.5, delta=4.6)


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_script(self, *words):
        done = subprocess.run([SCRIPT, *words], capture_output=True, text=True, check=False)
        return done.returncode, done.stdout, done.stderr

    def test_a_compressed_copy_is_not_read_twice_and_a_segment_is_one_log(self):
        for name in ("a.dbd", "a.dcd", "a.ebd", "b.dcd", "c.sbd", "c.tbd", "a.sbd", "notes.txt", "x.cac"):
            (self.folder / name).touch()
        found = log_files.segments(log_files.files_of([self.folder]))
        self.assertEqual(sorted(sorted(file.name for file in files) for files in found),
                         [["a.dbd", "a.ebd"], ["a.sbd"], ["b.dcd"], ["c.sbd", "c.tbd"]])

    def test_the_table_of_a_decoded_log_and_its_exit_status(self):
        for change, status in ({}, 0), ({"water_mps": 0.6}, 1):
            file = self.folder / "made_up.csv"
            file.write_text(Flight(**change).csv(), encoding="utf-8")
            got, out, err = self.run_script("--csv", file)
            self.assertEqual((got, err), (status, ""))
            self.assertIn("made_up", out)
        self.assertRegex(out, r"drift_m_s +0\.5 +0\.6 +made_up +2017-07-14 02:40:00 +-0\.1 +BROKEN")
        self.assertIn("1 log; broken: drift_m_s", out)

    def test_no_logs(self):
        self.assertEqual(self.run_script(self.folder / "nowhere")[0], 2)
        status, _, err = self.run_script(self.folder)
        self.assertEqual(status, 2)
        self.assertIn("no data files of gliders in", err)

    def test_a_row_without_a_method_is_an_error(self):
        platform = self.folder / "mine.toml"
        platform.write_text((ROOT / "platforms" / "slocum.toml").read_text(encoding="utf-8").replace("turn_s =", "wait_s =", 1),
                            encoding="utf-8")
        status, _, err = self.run_script("--platform", platform)
        self.assertEqual(status, 2)
        self.assertRegex(err, "`(turn_s|wait_s)` of \\[world\\] has no method")

    def test_what_is_no_log_is_an_error(self):
        (self.folder / "a.dbd").write_text("nothing", encoding="utf-8")
        self.assertEqual(self.run_script("--glidercc", self.folder / "none", self.folder)[0], 2)
        (self.folder / "a.csv").write_text("time,depth\n", encoding="utf-8")
        self.assertEqual(self.run_script("--csv", self.folder / "a.csv")[0], 2)

    def test_the_methods_are_explained(self):
        status, out, _ = self.run_script("--methods")
        self.assertEqual(status, 0)
        for _, key in rows.ROWS:
            self.assertIn(f"{key}: at ", out)


if __name__ == "__main__":
    unittest.main()
