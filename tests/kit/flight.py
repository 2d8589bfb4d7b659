# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""A flight of hookbeh as the vectors have it: in each cycle what is in the sensor array, and what must be commanded and reported."""

import math
import re

import sessions

NAN = math.nan
# States and answers, as the READMEs of hookbeh and of the protocol number them.
WAITING, READY, ACTIVE, SILENT, COMPLETE = range(1, 6)
ACCEPTED, BAD_CHECK, TOO_DEEP, BAD_PITCH, BAD_COMMAND, NOT_ON_EARTH, WRONG_SESSION, NOT_READY, OLD_SEQUENCE, BAD_FIN, BAD_PUMP, BAD_BATTERY = \
    range(1, 13)
TAKE, STEER, RELEASE = range(1, 4)
NONE, DESCEND, ASCEND, HOVER, SURFACE, ACTUATORS = range(6)
DRIFT, HEADING, WAYPOINT, FIN = range(4)
GUARDS = ("", "TooDeep", "NearBottom", "DepthUnknown", "DepthJumps", "DepthFrozen", "DepthsDisagree", "NoDepthGained", "NoHeightGained")
MASKED_HEADING, MASKED_PITCH, MASKED_PUMP = 1, 2, 4

USUAL_PITCH = math.radians(26)
HULL = {"greatest_depth_m": 200, "steepest_pitch_rad": 0.7854, "shallowest_pitch_rad": 0.19, "vertical_rate_m_s": 0.4, "pump_cc": 233,
        "fin_rad": 0.45, "battery_in": 0.6}
# What advances in each cycle, and by how much.
CLOCKS = {"time_s": 4, "wall_time_s": 4, "cycle_number": 1, "heartbeat": 1}
NUMBERS = ("heading_rad", "latitude_ddmm", "longitude_ddmm", "fin_rad", "pitch_rad", "battery_in", "pump_cc")
NOTHING = dict(dict.fromkeys(NUMBERS, 0), commanding=False, altimeter=False, heading_mode="CentreFin", pitch_mode="Servo", doing="Nothing",
               guard=0, masked=0, sampling=0)


# The field of each sensor of an instruction.
WORDS = {sensor: f"words.{word}" for sensor, word in re.findall(
    r"^(?:REAL_|CHECK_|LATER_)?WORD\(\w+, (\w+), (\w+),", (sessions.PROTOCOL / "instruction.def").read_text(encoding="utf-8"), re.M)}


def same(one, other):
    return one == other or (math.isnan(one) and math.isnan(other))


class Flight:
    """The cycles of a mission from its beginning: `args` are the b_args that differ from the defaults.

    `want` is what hookbeh must answer in the cycles that follow.
    """

    def __init__(self, name, whole_stroke=False, **args):
        self.name, self.args, self.whole_stroke, self.cycles = f"hookbeh: {name}", args, whole_stroke, []
        self.clocks = {"time_s": 0, "wall_time_s": 1.7e9, "cycle_number": 0, "heartbeat": 100}
        self.array = dict.fromkeys(CLOCKS, NAN)  # what it holds, as the reader of the vectors advances it
        self.want = dict(NOTHING, state=READY, answer=0, sequence=0, session=0)
        self.sequence, self.session = 0, 7
        self.beats = True  # the SBC's heart
        self.uses_altimeter = args.get("least_altitude_m", 5) >= 0

    def cycle(self, masked=0, **readings):
        """A cycle in which these readings are in the sensor array; the others stay, and the clocks advance."""
        for name, step in CLOCKS.items():
            self.clocks[name] += step if name != "heartbeat" or self.beats else 0
            self.array[name] += step
        readings = dict(self.clocks, **readings)
        changed = {name: value for name, value in readings.items() if not same(value, self.array.get(name, NAN))}
        self.array.update(changed)
        self.cycles.append((changed, masked, dict(self.want)))
        return self

    def through(self, start, stop, by, **readings):
        """Cycles in which the depth goes from `start` to `stop`, by so many metres in each."""
        for number in range(round((stop - start) / by) + 1):
            self.cycle(depth_m=start + by * number, **readings)
        return self

    def around(self, depth, cycles, **readings):
        """Cycles in which the vehicle stays at a depth: what a sensor gives differs a little from one to the next."""
        for number in range(cycles):
            self.cycle(depth_m=depth - (number + 1) % 2 / 8, **readings)
        return self

    def wants(self, **fields):
        self.want.update(fields)
        return self

    def flies(self, doing, pitch, pump):
        return self.wants(commanding=True, altimeter=self.uses_altimeter, doing=doing, pitch_mode="Servo", pitch_rad=pitch, battery_in=0,
                          pump_cc=pump, guard=0)

    def dives(self, pitch=-USUAL_PITCH):
        return self.flies("DiveTo", pitch, -230)

    def surfaces(self):
        return self.flies("Surface", USUAL_PITCH, 230)

    def guards(self, number):
        """It climbs for a guard: at 26 degrees, with the hull's whole stroke."""
        return self.flies(GUARDS[number], USUAL_PITCH, HULL["pump_cc"]).wants(guard=number)

    def rests(self, state):
        """It commands nothing."""
        return self.wants(**NOTHING).wants(state=state)

    def loses(self):
        """The SBC is lost."""
        return self.rests(SILENT).wants(session=0)

    def says(self, vertical=NONE, depth=0, pitch=0, lateral=HEADING, heading=1, latitude=0, longitude=0, *, control=STEER, answer=ACCEPTED,
             session=None, sequence=None, check=0, sampling=None):
        """The words of the SBC's next instruction, and the answer to it; `check`: by how much the check value is wrong; `sampling`: of a
        mission that samples."""
        self.sequence = (self.sequence % 65535 + 1) if sequence is None else sequence
        session = self.session if session is None else session
        given = sessions.instruction(session, self.sequence, control, vertical, lateral, depth, pitch, heading, latitude, longitude, sampling=sampling or 0)
        self.wants(answer=answer, sequence=self.sequence)
        if answer == ACCEPTED:
            self.steers(lateral, heading, latitude, longitude).wants(sampling=sampling or 0)
        words = sessions.words_of(given) if sampling is None else sessions.words_of_sampling(given)
        found = {WORDS[sensor]: value for sensor, value in words}
        return dict(found, **{"words.check": found["words.check"] + check})

    def takes(self, *command, **fields):
        """The handshake with the first instruction of a session, in the first cycle or a later one."""
        readings = self.says(*command, control=TAKE, **fields)
        self.wants(state=ACTIVE, session=self.session)
        return readings

    def steers(self, lateral, heading=0, latitude=0, longitude=0):
        self.wants(heading_mode=("CentreFin", "Heading", "Waypoint", "Fin")[lateral],
                   heading_rad=heading % math.tau if lateral == HEADING else 0, fin_rad=heading if lateral == FIN else 0,
                   latitude_ddmm=latitude if lateral == WAYPOINT else 0, longitude_ddmm=longitude if lateral == WAYPOINT else 0)
        return self


def taken(name, *command, depth=0.5, **args):
    """A flight whose second cycle is the handshake with this instruction."""
    flight = Flight(name, **args)
    flight.cycle(depth_m=depth)
    return flight, flight.takes(*command)
