# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""The sensors that missions name, read from platforms/slocum.toml."""

import collections
import pathlib
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
Sensor = collections.namedtuple("Sensor", "unit lowest highest")


def _read():
    rows = tomllib.loads((ROOT / "platforms" / "slocum.toml").read_text())["sensor"]
    return {row["alias"]: Sensor(row["unit"], row["lowest"], row["highest"]) for row in rows if "alias" in row}


SENSORS = _read()
# Beyond what any sensor of the unit reads, in the unit that missions write without one.
PLAUSIBLE = {sensor.unit: f"{10 * max(s.highest for s in SENSORS.values() if s.unit == sensor.unit):g}"
             for sensor in SENSORS.values()}


def _next(names, name):
    names = list(names)
    return names[(names.index(name) + 1) % len(names)]


def of_the_same_unit(name):
    """The sensor after it that has its unit; None if there is none."""
    found = _next([n for n, s in SENSORS.items() if s.unit == SENSORS[name].unit], name)
    return None if found == name else found


def of_another_unit(name):
    """The next sensor that has another unit."""
    found = _next(SENSORS, name)
    while SENSORS[found].unit == SENSORS[name].unit:
        found = _next(SENSORS, found)
    return found
