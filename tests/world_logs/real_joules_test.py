#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""The charge that real gliders counted agrees with the power table, and no longer does once a row of the table is wrong.

  tests/world_logs/real_joules_test.py GLIDERCC
"""

import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
LOGS = ROOT.parent / "shared" / "data" / "dbd"
SLOCUM = ROOT / "platforms" / "slocum.toml"
SEGMENTS = 2
ONE = "comet-2019-222-02-154"  # has no device without a row in the table
SKIPPED = 77

# A wrong number: device, when it draws, its number, and the factor. What is too small to show is not here: the CTD and the surface are
# 3 to 7 % of the flights, fin and pitch battery less; and half of what the pump takes for each metre more still is within 10 %.
FAULTS = (
    ("hotel", "always", "W", 0.0),
    ("hotel", "always", "W", 1.5),
    ("pump", "pump_out", "J_per_cc_m", 1.5),
    ("fluorometer", "read", "W", 0.0),
)


def compared(glidercc, platform, logs):
    return subprocess.run([ROOT / "scripts" / "joules_against_logs", "--glidercc", glidercc, "--platform", platform, *logs],
                          capture_output=True, text=True, check=False)


def with_fault(text, device, when, key, factor):
    """The platform with one number of its power table multiplied."""
    row = re.compile(rf'(device = "{device}"\nwhen = "{when}"\n(?:.*\n)*?{key} = )([0-9.]+)')
    changed, count = row.subn(lambda match: f"{match[1]}{float(match[2]) * factor:.6f}", text, count=1)
    assert count == 1, f"no `{key}` of {device}"
    return changed


def halved_pump(text):
    """All that the pump takes, halved."""
    for when, key in (("pump_out", "J_per_cc"), ("pump_out", "J_per_cc_m"), ("pump_in", "J_per_cc")):
        text = with_fault(text, "pump", when, key, 0.5)
    return text


def unseen(glidercc, folder):
    """The planted faults that go unseen."""
    text = SLOCUM.read_text(encoding="utf-8")
    planted = {f"{device}, {key} times {factor}": with_fault(text, device, when, key, factor)
               for device, when, key, factor in FAULTS}
    planted["half of the pump"] = halved_pump(text)
    for name, changed in planted.items():
        file = pathlib.Path(folder) / "slocum.toml"
        file.write_text(changed, encoding="utf-8")
        run = compared(glidercc, file, [LOGS / f"{ONE}.dbd", LOGS / f"{ONE}.ebd"])
        seen = run.returncode == 1 and "FAILS: the estimate is off by" in run.stdout
        print(f"planted: {name}: {'seen' if seen else run.stdout + run.stderr}")
        if not seen:
            yield name


def main(glidercc):
    if not LOGS.exists():
        print(f"{pathlib.Path(__file__).name}:1: Skipped\nthe logs of real gliders are not here: {LOGS}\n")
        return SKIPPED
    run = compared(glidercc, SLOCUM, [LOGS])
    print(run.stdout + run.stderr)
    if run.returncode != 0 or f"\n{SEGMENTS} segments, 0 of them fail" not in run.stdout:
        return 1
    with tempfile.TemporaryDirectory() as folder:
        return 1 if list(unseen(glidercc, folder)) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
