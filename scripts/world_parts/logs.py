# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""The logs of gliders: found, decoded by glidercc, and read as one series of (UTC s, value) per sensor."""

import bisect
import csv
import io
import math
import pathlib
import statistics
import subprocess

FLIGHT_KINDS = ("dbd", "dcd", "mbd", "mcd", "sbd", "scd")
SCIENCE_KINDS = ("ebd", "ecd", "nbd", "ncd", "tbd", "tcd")
# Files with a record for every cycle; the others hold a selection for transmission, with seconds or minutes left out.
EVERY_CYCLE = ("dbd", "dcd")
LATE = 1.5  # usual cycles
FALSE_BY = 1.0  # m; a vehicle that turns at full speed between two cycles stays within this


class LogError(Exception):
    """A log that cannot be read; the text says why."""


class Log:
    """One segment of a flight: each sensor's updates as its own computer recorded them."""

    def __init__(self, name, text, every_cycle):
        self.name = name
        self.every_cycle = every_cycle
        self.flight_times = []
        self._series = {}
        self._times = {}
        rows = csv.reader(io.StringIO(text))
        names = next(rows, [])
        if names[:2] != ["time_s", "computer"]:
            raise LogError(f"{name}: not the CSV of data files as `glidercc log --csv` writes it")
        for row in rows:
            self._add(names, row)

    def _add(self, names, row):
        time, computer = float(row[0]), row[1]
        if computer == "flight":
            self.flight_times.append(time)
        for name, text in zip(names[2:], row[2:]):
            if text and computer == ("science" if name.startswith("sci_") else "flight"):
                value = float(text)
                if math.isfinite(value):
                    self._series.setdefault(name, []).append((time, value))

    def series(self, name):
        """The updates of a sensor in order of time; [] if it has none."""
        return self._series.get(name, [])

    def newest(self, name, time):
        """The newest update (time, value) at or before `time`; None if there is none."""
        series = self.series(name)
        if name not in self._times:
            self._times[name] = [t for t, _ in series]
        count = bisect.bisect_right(self._times[name], time)
        return series[count - 1] if count else None

    def value(self, name, time):
        """The newest value at `time`; None if there is none."""
        update = self.newest(name, time)
        return update and update[1]

    def together(self, *names):
        """(time, value, value, ...) of the records that update all these sensors."""
        others = [dict(self.series(name)) for name in names[1:]]
        for time, value in self.series(names[0]):
            if all(time in other for other in others):
                yield time, value, *(other[time] for other in others)

    def cycle(self):
        """The usual length of a control cycle, s; None if there are not two."""
        gaps = [b - a for a, b in zip(self.flight_times, self.flight_times[1:])]
        return statistics.median(gaps) if gaps else None


def settled(series):
    """A series in which each value is the median of itself and its neighbours: single values that stand out disappear."""
    values = [value for _, value in series]
    middle = [sorted(values[i - 1:i + 2])[1] for i in range(1, len(values) - 1)]
    return list(zip([time for time, _ in series], values[:1] + middle + values[-1:])) if len(values) > 1 else series


def without_false(depths):
    """Depths without single readings that are FALSE_BY or more above both neighbours, or below both."""
    beyond = {k for k in range(1, len(depths) - 1)
              for a, x, b in [[depth for _, depth in depths[k - 1:k + 2]]]
              if x - max(a, b) >= FALSE_BY or min(a, b) - x >= FALSE_BY}
    return [reading for k, reading in enumerate(depths) if k not in beyond]


def depth_motion(log):
    """The readings of m_depth that show how the vehicle moved.

    A cycle that takes half as long again as usual reads its sensors seconds after its time of record, so its reading is left
    out, as are single false ones.
    """
    usual, ends = log.cycle(), dict(zip(log.flight_times, log.flight_times[1:]))
    late = {time for time, end in ends.items() if log.every_cycle and end - time > LATE * usual}
    return without_false([(time, depth) for time, depth in log.series("m_depth") if time not in late])


def between(series, begin, end):
    return [(time, value) for time, value in series if begin <= time <= end]


def files_of(paths):
    """All data files below these files and folders, without the compressed copy of one that is also there plain."""
    found = set()
    for path in map(pathlib.Path, paths):
        inside = path.rglob("*") if path.is_dir() else [path]
        found |= {file for file in inside if file.suffix[1:].lower() in FLIGHT_KINDS + SCIENCE_KINDS}
    plain = {file: file.with_suffix(file.suffix.replace("cd", "bd")) for file in found}
    return sorted(file for file in found if plain[file] == file or plain[file] not in found)


def segments(files):
    """Lists of files that record the same segment in the same detail: flight's and science's."""
    groups = {}
    for file in files:
        kind = file.suffix[1:].lower()
        kinds = FLIGHT_KINDS if kind in FLIGHT_KINDS else SCIENCE_KINDS
        groups.setdefault((file.with_suffix(""), kinds.index(kind) // 2), []).append(file)
    return [groups[key] for key in sorted(groups)]


def run(glidercc, *words):
    """The output of `glidercc log`, also of a damaged file as far as it can be read."""
    try:
        done = subprocess.run([glidercc, "log", *words], capture_output=True, text=True, check=False)
    except OSError as error:
        raise LogError(f"{glidercc}: {error.strerror}; build it, or name it with --glidercc") from error
    if done.returncode > 1:
        raise LogError(f"{words[-1]}: {done.stderr.strip()}")
    return done.stdout


def decode(glidercc, files, sensors):
    """The log in these files of one segment; of the sensors, those that they have."""
    there = {line.split()[0] for line in run(glidercc, *files).splitlines() if line.startswith("  ")}
    wanted = ",".join(sorted(sensors & there))
    text = run(glidercc, "--csv", "-", "--sensors", wanted, *files) if wanted else "time_s,computer\n"
    every_cycle = any(file.suffix[1:].lower() in EVERY_CYCLE for file in files)
    return Log(f"{files[0].stem}.{'+'.join(file.suffix[1:] for file in files)}", text, every_cycle)
