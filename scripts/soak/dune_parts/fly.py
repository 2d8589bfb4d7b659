# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""Flies a mission on DUNE's vehicle and on the simulator's: both give a Flight."""

import csv
import dataclasses
import subprocess
import time

from dune_parts import imc, vehicle

EXIT = 3  # hooks/protocol/notices.def
CALM = """name = "calm"
description = "no current, one temperature, deep water"
skeleton = "calm.mi"
duration_s = 7200
[start]
latitude_deg = {}
longitude_deg = {}
heading_rad = 0.0
[ocean]
surface_temp_degC = 14.0
bottom_temp_degC = 14.0
water_depth_m = 200.0
"""


@dataclasses.dataclass
class Flight:
    """What a flight has shown, by mission time in s."""
    track: list  # (time, latitude, longitude in degrees, depth in m), once a second
    transitions: list  # (time, from, to); states by number, and `to` of the end is 0


def fly_here(glidercc, skeleton, mission, folder):
    """In the simulator."""
    folder.mkdir()
    (folder / "calm.toml").write_text(CALM.format(*vehicle.START), encoding="utf-8")
    (folder / "calm.mi").write_text(skeleton.read_text(encoding="utf-8"), encoding="utf-8")
    subprocess.run([glidercc, "sim", mission, "--scenario", folder / "calm.toml", "-q", "-o", folder / "flight"], check=True)
    with open(folder / "flight" / "trace.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    track = [(float(row["missiontime (s)"]), float(row["m_lat (deg)"]), float(row["m_lon (deg)"]),
              float(row["m_depth (m)"])) for row in rows if row["missiontime (s)"]]
    with open(folder / "flight" / "events.csv", encoding="utf-8") as file:
        events = [row for row in csv.DictReader(file) if row["kind"] == "transition"]
    return Flight(track, [(float(event["missiontime (s)"]), *event["what"].split(" (")[0].split(" → ")) for event in events])


def program_of(glidercc, mission, board, folder, port=vehicle.PORT):
    """Compiles the mission for the SBC; returns the command that flies it at that port."""
    program = folder / "program"
    subprocess.run([glidercc, "build", mission, "--target", board, "-o", program], check=True, stdout=subprocess.DEVNULL)
    emulator = {"ts7800": ["qemu-arm"], "ts5500": ["qemu-i386", "-cpu", "486"]}.get(board, [])
    return [*emulator, str(program), "--tcp", f"127.0.0.1:{port}", "--log", str(folder / "flight.log")]


def wait_until(holds, seconds, what):
    """Waits so many s of real time at most."""
    end = time.monotonic() + seconds
    while not holds():
        if time.monotonic() > end:
            raise RuntimeError(f"{what}: not within {seconds:.0f} s")
        time.sleep(0.05)


def flight_of(recorder, names):
    """By mission time, which the SBC writes with each transition into the vehicle's log."""
    said = [(when, fields["text"].split(",")) for when, fields in recorder.of(imc.LOG_BOOK_ENTRY)
            if fields["context"] == "glidercc" and fields["text"].startswith("transition,")]
    said = list({tuple(words): (when, words) for when, words in reversed(said)}.values())[::-1]
    if not said:
        raise RuntimeError("the vehicle's log has no transition")
    began = said[0][0] - float(said[0][1][1])
    transitions = [(float(words[1]), names[int(words[3])], "end" if int(words[2]) == EXIT else names[int(words[4])])
                   for _, words in said]
    track, newest = [], -1
    for when, state in recorder.of(imc.ESTIMATED_STATE):
        mission_s = when - began
        if mission_s >= 0 and int(mission_s) != newest:
            newest = int(mission_s)
            track.append((mission_s, state["lat"], state["lon"], state["depth"]))
    return Flight(track, transitions)
