# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""Checks and flies missions with glidercc, and takes from a flight the figures that the rules compare."""

import csv
import dataclasses
import hashlib
import math
import pathlib
import re
import subprocess
import tempfile

# Where each mission is flown: scenario and seed.
WORLDS = (("default", 1), ("shelf_slope", 2), ("front", 3), ("bloom", 4), ("low_battery", 5), ("default", 6))


class BrokenError(Exception):
    """glidercc itself failed: no mutant may bring that about."""


@dataclasses.dataclass
class Figures:
    """Of one flight. Times in seconds of the vehicle, depths in metres; None: did not happen."""
    control_s: float = None  # the SBC takes control
    exit_s: float = None  # the mission ends
    last_s: float = 0  # the last time at which the SBC was in control
    deepest_m: float = 0
    deepest_command_m: float = 0
    farthest_m: float = 0  # from the start
    idle_s: float = None  # the first cycle in control without a command up, down or level
    surfaced: bool = False  # came up to 1.5 m from below 4 m, in control
    aborted: str = None
    refused: str = None
    guarded: str = None  # hookbeh's own guard had to climb
    most_transitions: int = 0  # within 300 s


def world_options(world):
    return ["--scenario", world[0], "--seed", str(world[1])]


def check(glidercc, text, *options):
    """("error" or "warning" or "", ids of the diagnostics)."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "mutant.mission")
        path.write_text(text)
        done = subprocess.run([glidercc, "check", *options, str(path)], capture_output=True, text=True, timeout=60)
    if done.returncode not in (0, 1) or "internal error" in done.stderr:
        raise BrokenError(f"glidercc check ended with {done.returncode}: {done.stderr}")
    ids = sorted(set(re.findall(r"\[(GL\d{4}) ", done.stderr)))
    if done.returncode == 1:
        return "error", ids
    return ("warning" if ids else ""), ids


def fly(glidercc, text, world):
    """(digest of trace.csv, Figures)."""
    with tempfile.TemporaryDirectory() as folder:
        path, flight = pathlib.Path(folder, "mutant.mission"), pathlib.Path(folder, "flight")
        path.write_text(text)
        command = [glidercc, "sim", str(path), *world_options(world), "-o", str(flight)]
        done = subprocess.run(command, capture_output=True, text=True, timeout=600)
        if done.returncode not in (0, 1) or "internal error" in done.stderr:
            raise BrokenError(f"glidercc sim ended with {done.returncode}: {done.stderr}")
        trace = (flight / "trace.csv").read_bytes()
        events = list(csv.reader((flight / "events.csv").read_text().splitlines()))[1:]
    figures = Figures()
    _read_trace(figures, trace.decode())
    _read_events(figures, events)
    return hashlib.sha256(trace).hexdigest(), figures


def _read_trace(figures, text):
    lines = text.splitlines()
    names = [title.split(" ")[0] for title in next(csv.reader([lines[0]]))]
    time, depth, bottom, active, vertical, x, y = (
        names.index(n) for n in ("time", "true_depth", "commanded_bottom", "hook_active", "hook_vertical", "true_x", "true_y"))
    below = False
    for line in lines[1:]:
        row = line.split(",")
        figures.deepest_m = max(figures.deepest_m, float(row[depth]))
        if row[active] != "1":
            continue
        figures.last_s = float(row[time])
        if figures.control_s is None:
            figures.control_s = figures.last_s
        if row[bottom]:
            figures.deepest_command_m = max(figures.deepest_command_m, float(row[bottom]))
        if row[vertical] in ("", "0") and figures.idle_s is None:
            figures.idle_s = figures.last_s
        below = below or float(row[depth]) > 4
        figures.surfaced = figures.surfaced or (below and float(row[depth]) < 1.5)
        figures.farthest_m = max(figures.farthest_m, math.hypot(float(row[x]), float(row[y])))


def _read_events(figures, events):
    transitions = []
    for time, _, kind, what, _ in events:
        if kind == "transition":
            transitions.append(float(time))
            if what.endswith("(exit)"):
                figures.exit_s = float(time)
        elif kind == "abort" and figures.aborted is None:
            figures.aborted = f"{what} at {time} s"
        elif kind == "hook" and what.startswith("instruction ") and " refused: " in what and figures.refused is None:
            figures.refused = f"{what} at {time} s"
        elif kind == "hook" and "climb: " in what and figures.guarded is None:
            figures.guarded = f"{what} at {time} s"
    first = 0
    for i, at in enumerate(transitions):
        while transitions[first] < at - 300:
            first += 1
        figures.most_transitions = max(figures.most_transitions, i - first + 1)
