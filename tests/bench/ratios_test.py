#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""scripts/bench on tables of ratios: what counts as worse, what does not, and what it says to wrong use."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
BENCH = ROOT / "scripts" / "bench"
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "bench"))
import ratios  # noqa: E402


def row(bench, case, ratio, better="lower"):
    return ratios.Row(bench, case, ratio, better, "5", "none", "abc")


TABLE = [row("frontend", "10000 states", 2.0), row("link", "share of values", 0.8, "higher"), row("sim", "figure2", 30)]


class Bench(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.table = self.folder / "table.csv"
        ratios.write(self.table, TABLE, ["a head"])

    def run_bench(self, *words, **options):
        done = subprocess.run([BENCH, "--table", self.table, *words], capture_output=True, text=True, check=False, **options)
        return done.returncode, done.stdout, done.stderr

    def compare(self, measured, *words):
        given = self.folder / "measured.csv"
        ratios.write(given, measured, ())
        return self.run_bench("--compare", "--from", given, *words)

    def scaled(self, *factors):
        return [row(r.bench, r.case, r.ratio * f, r.better) for r, f in zip(TABLE, factors)]

    def test_the_same_is_fine(self):
        status, out, _ = self.compare(TABLE)
        self.assertEqual(status, 0)
        self.assertNotIn("worse", out)
        self.assertIn("10000 states", out)

    def test_noise_of_a_twentieth_is_fine(self):
        self.assertEqual(self.compare(self.scaled(1.05, 0.95, 1.05))[0], 0)
        self.assertEqual(self.compare(self.scaled(1.19, 0.85, 0.9))[0], 0)

    def test_a_fifth_worse_is_named(self):
        status, out, _ = self.compare(self.scaled(1.2, 1, 1))
        self.assertEqual(status, 1)
        self.assertIn("worse: frontend: 10000 states: 2.4, was 2 at abc (lower is better): 20 % worse", out)
        self.assertEqual(out.count("worse:"), 1)

    def test_what_is_better_higher_is_worse_when_it_falls(self):
        status, out, _ = self.compare(self.scaled(1, 0.8, 1))
        self.assertEqual(status, 1)
        self.assertIn("worse: link: share of values: 0.64, was 0.8", out)

    def test_what_gets_better_is_fine(self):
        self.assertEqual(self.compare(self.scaled(0.3, 1.2, 0.5))[0], 0)

    def test_a_case_that_is_gone_is_named(self):
        gone = [row("frontend", "9000 states", 1), *TABLE[1:]]
        status, out, _ = self.compare(gone)
        self.assertEqual(status, 1)
        self.assertIn("worse: frontend: 10000 states: in the table (2), but no longer measured", out)

    def test_benches_that_did_not_run_are_left_out(self):
        self.assertEqual(self.compare(TABLE[:1])[0], 0)
        self.assertEqual(self.compare(self.scaled(9, 1, 1), "link")[0], 0, "only link is asked about")

    def test_update_keeps_the_others_rows(self):
        given = self.folder / "measured.csv"
        ratios.write(given, [row("sim", "figure2", 60)], ())
        self.assertEqual(self.run_bench("--update", "--from", given)[0], 0)
        now = {r.key: r.ratio for r in ratios.read(self.table)}
        self.assertEqual(now, {("frontend", "10000 states"): 2, ("link", "share of values"): 0.8, ("sim", "figure2"): 60})

    def test_wrong_use_and_missing_files(self):
        for words, expected in (
                (["nonsense"], "no bench `nonsense`"), (["--frob"], "unrecognized"), (["--runs", "0"], "--runs"), (["--from", "/none.csv"], "none.csv")):
            status, _, err = self.run_bench(*words)
            self.assertEqual(status, 2, words)
            self.assertIn(expected, err)
        self.table.write_text("frontend,case,-1,lower,1,none,x\n")
        status, _, err = self.compare(TABLE)
        self.assertEqual(status, 2)
        self.assertIn("table.csv:1", err)

    def test_without_a_peer_it_says_which(self):
        if not (ROOT / "build/bin/glidercc").exists():
            self.skipTest("no build in build/")
        bare = self.folder / "bin"
        bare.mkdir()
        for tool in ("python3", "env", "git"):
            (bare / tool).symlink_to(f"/usr/bin/{tool}")
        status, _, err = self.run_bench("frontend", env={**os.environ, "PATH": str(bare)})
        self.assertEqual(status, 2)
        self.assertIn("bench/frontend needs `gcc`", err)
        self.assertIn("hint: apt-get install gcc", err)

    def test_the_committed_table_is_right_and_every_bench_hands_its_ratios_on(self):
        committed = ratios.read(ROOT / "bench" / "ratios.csv")
        benches = {path.name for path in (ROOT / "bench").iterdir() if path.is_file() and os.access(path, os.X_OK)}
        self.assertEqual({r.bench for r in committed}, benches)
        for bench in benches:
            self.assertIn("note(\"" + bench + "\", ", (ROOT / "bench" / bench).read_text())
        self.assertEqual(len({r.key for r in committed}), len(committed))
        self.assertTrue(all(r.commit and r.runs and r.seed for r in committed))

    def test_help(self):
        status, out, _ = self.run_bench("--help")
        self.assertEqual(status, 0)
        self.assertIn("--compare", out)


if __name__ == "__main__":
    unittest.main()
