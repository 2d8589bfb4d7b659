#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""No log of a real glider breaks a row of the environment model, and all rows but one are in the logs.

  tests/world_logs/real_logs_test.py GLIDERCC
"""

import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
LOGS = ROOT.parent / "shared" / "data" / "dbd"
NO_LOG = {"start_depth_m"}  # no log is of a vehicle with hookbeh
SKIPPED = 77


def main(glidercc):
    if not LOGS.exists():
        print(f"{pathlib.Path(__file__).name}:1: Skipped\nthe logs of real gliders are not here: {LOGS}\n")
        return SKIPPED
    run = subprocess.run([ROOT / "scripts" / "world_against_logs", "--glidercc", glidercc, LOGS],
                         capture_output=True, text=True, check=False)
    print(run.stdout + run.stderr)
    lacking = set(re.findall(r"^(\w+) .*not in these logs: ", run.stdout, re.MULTILINE))
    if lacking != NO_LOG:
        print(f"not in the logs: {sorted(lacking)}; expected {sorted(NO_LOG)}")
    return 0 if run.returncode == 0 and lacking == NO_LOG else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
