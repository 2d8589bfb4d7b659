# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""What the vectors ask: instructions, messages, and sessions of hookprog with an SBC, second by second.

What hookprog must do is written by hand from hooks/protocol/README.md (the rules M, R, T) and hooks/hookprog/README.md.
"""

import math
import pathlib
import re

import wire

NAN, INFINITY = math.nan, math.inf
PROTOCOL = pathlib.Path(__file__).parents[2] / "hooks" / "protocol"

# (name, bytes, of the science computer): a vehicle whose sensors are in another order than the roles, some without a role.
SENSORS = [
    ("sci_hook_sequence", 4, True), ("m_lat", 8, False), ("m_depth", 4, False), ("x_hook_state", 1, False),
    ("m_present_secs_into_mission", 4, False), ("sci_echo", 1, True), ("m_cycle_number", 4, False), ("sci_hook_session", 4, True),
    ("sci_hook_control", 1, True), ("sci_hook_vertical", 1, True), ("sci_hook_depth", 4, True), ("sci_hook_pitch", 4, True),
    ("sci_hook_lateral", 1, True), ("sci_hook_heading", 4, True), ("sci_hook_lat", 8, True), ("sci_hook_lon", 8, True),
    ("sci_hook_check", 8, True), ("sci_hook_heartbeat", 4, True), ("x_hook_sequence", 4, False), ("x_hook_answer", 1, False),
    ("x_hook_session", 4, False), ("m_present_time", 8, False), ("sci_water_temp", 4, True), ("m_device", 1, False),
    ("sci_hook_sampling", 8, True), ("x_hook_nap_secs", 4, False)]
NUMBER = {name: number for number, (name, _, _) in enumerate(SENSORS)}
WIDTH = {name: width for name, width, _ in SENSORS}
HASH = 0x5EA1CE5


def roles():
    """The vehicle's name of each role's sensor, in the order of the roles."""
    return re.findall(r"^ROLE\(\w+, (\w+),", (PROTOCOL / "roles.def").read_text(encoding="utf-8"), re.M)


def instruction(*words, sampling=0):
    names = ("session", "sequence", "control", "vertical", "lateral", *wire.REALS)
    return dict(zip(names, words, strict=True), sampling=sampling)


INSTRUCTIONS = [
    instruction(7, 258, 1, 1, 2, 20.1, -0.454, 1.3, 3910.5, -7349.8058),  # the example of the protocol's page
    instruction(1, 1, 3, 0, 0, 0, 0, 0, 0, 0),
    instruction(16777215, 65535, 2, 5, 3, -233, 0.6, -0.45, 0, 0),
    instruction(9, 40, 2, 2, 1, 0.0004, 0.000004, 0.000006, 1e-6, -4e-6),
    instruction(9, 41, 2, 2, 1, 0.0005, -0.000005, 6.283185307179586, 8959.99999, -17959.99999),
    instruction(9, 42, 2, 1, 1, 5000, 40, -40, 30000, -30000),
    instruction(9, 43, 2, 1, 2, NAN, -INFINITY, INFINITY, NAN, NAN),
    instruction(9, 44, 2, 4, 1, 0, 0, 1, 0, 0, sampling=1 | 6 << 5 | 2 << 10),  # off, every 4 s, as often as it can
    instruction(9, 45, 2, 4, 1, 0, 0, 1, 0, 0, sampling=(1 << 30) - 1),
]

MESSAGES = {
    "Beacon": [(6, 7, 7, 0x12345678, 2), (6, 0, 0, 0, 0), (6, 0xFFFF, 0x8001, 0xFFFFFFFF, 5)],
    "Welcome": [(1, 7, 6), (0, 16777215, 0), (0, 0, 16777215)],
    "Hello": [(6, 7, 0, 0x12345678, 7, "survey"), (6, 0, 1, 0, 16777215, ""), (6, 1, 2, 3, 4, "n" * 47)],
    "Transition": [(500.0, 1, 0, 1, 1, 0), (-0.25, 0, 0xFFFFFFFF, 0xFFFFFFFF, 0xFFFFFFFF, 1), (1e9, 3, 2, 0, 7, 1)],
    "Done": [(3, 7, 500.0, 1, 1, 1), (255, 16777215, 0.0, 0xFFFFFFFF, 255, 2), (0, 0, 1234.5678, 0, 0, 0)],
    "Note": [(500.0, 0, "met it at 12 "), (0.0, 1, ""), (86400.5, 0, "t" * 60)],
}

# Payloads that no sender writes, for each message that the vehicle reads.
REFUSED = [(kind, payload) for kind, good in (
    ("Hello", wire.PAYLOADS["Hello"](6, 7, 0, HASH, 7, "survey")), ("Transition", wire.PAYLOADS["Transition"](5.0, 0, 0, 1, 0, 1)),
    ("Done", wire.PAYLOADS["Done"](1, 2, 3.0, 4, 5, 1)), ("Note", wire.PAYLOADS["Note"](5.0, 0, "text")),
    ("Subscribe", wire.subscribe([(2, 1, 0.5)])), ("Write", wire.write([(10, 4, 20)]))
) for payload in (b"", good[:-1], good + b"\0")] + [
    ("Hello", wire.PAYLOADS["Hello"](6, 7, 0, HASH, 0, "no link")), ("Hello", wire.PAYLOADS["Hello"](6, 7, 0, HASH, 7, "")[:-1] + b"\x30" + b"n" * 48),
    ("Transition", wire.PAYLOADS["Transition"](5.0, 0, 0, 1, 0, 2)), ("Transition", wire.PAYLOADS["Transition"](NAN, 0, 0, 1, 0, 1)),
    ("Transition", wire.PAYLOADS["Transition"](INFINITY, 0, 0, 1, 0, 1)), ("Done", wire.PAYLOADS["Done"](1, 2, 3.0, 4, 5, 3)),
    ("Done", wire.PAYLOADS["Done"](1, 2, NAN, 4, 5, 1)), ("Note", wire.PAYLOADS["Note"](5.0, 2, "kind")),
    ("Note", wire.PAYLOADS["Note"](-INFINITY, 0, "time")), ("Note", wire.PAYLOADS["Note"](5.0, 0, "")[:-1] + b"\x3d" + b"n" * 61),
    ("Subscribe", wire.subscribe([(len(SENSORS), 1, 0)])), ("Subscribe", wire.subscribe([(2, 0, 0)])),
    ("Subscribe", wire.subscribe([(2, 1, -0.5)])), ("Subscribe", wire.subscribe([(2, 1, NAN)])), ("Subscribe", wire.subscribe([(2, 1, INFINITY)])),
    ("Subscribe", wire.subscribe([(2, 1, 0)] * 65)), ("Write", wire.write([(len(SENSORS), 4, 20)])), ("Write", wire.write([(8, 1, 2)] * 84)),
    ("Nap", b""), ("Nap", wire.nap(0, 1, [])[:-1]), ("Nap", wire.nap(0, 1, []) + b"\0"), ("Nap", wire.nap(0, 0, [])),
    ("Nap", wire.nap(0, 1, [(2, 0, 5.0)])[:-1]), ("Nap", wire.nap(0, 1, [(2, 0, NAN)])), ("Nap", wire.nap(0, 1, [(2, 1, NAN)])),
    ("Nap", wire.nap(0, 1, [(2, 4, 5.0)])), ("Nap", wire.nap(0, 1, [(1, 0, 5.0)])), ("Nap", wire.nap(0, 1, [(len(SENSORS), 2, 0.0)])),
    ("Nap", wire.nap(0, 1, [(2, 0, 5.0)] * 33)),
    ("Write", bytes((84,)) + wire.write([(8, 1, 2)] * 83)[1:]),  # one less than it says, in the most bytes
]


class Event:
    """What hookprog reports."""

    def __init__(self, kind, time, *numbers, text=""):
        self.kind, self.time, self.text = kind, time, text
        self.numbers = (numbers + (0,) * 5)[:5]


class Step:
    """A second of the science computer: what comes, and what hookprog must make of it."""

    def __init__(self, time):
        self.time, self.updates, self.sets, self.received, self.sent, self.events = time, [], [], b"", b"", []


class Session:
    """The seconds of a hookprog from its start. Both ends number their frames."""

    def __init__(self, start, virtual_time=False):
        self.steps, self.now, self.virtual = [], start - 1, virtual_time
        self.out, self.said = start % 16777215 % 256, 0
        self.heart = start % 16777215
        self.odd = 0
        self.kept = []
        self.report = {"virtual": virtual_time, "kept": False, "link": 0, "time": 0, "cycle": 0, "state": 0, "answer": 0, "answered": 0, "session": 0,
                       "clock": 0}
        self.subscription = b"\0"

    def second(self):
        """The next second, in which nothing happens."""
        self.now += 1
        self.steps.append(Step(self.now))
        return self

    def flight(self, **values):
        """The flight controller's values come over the vehicle's own line."""
        self.steps[-1].updates += list(values.items())
        return self

    def cycle(self, time, number, **values):
        """A flight cycle comes, and is complete a second later."""
        self.second().flight(m_present_secs_into_mission=time, m_cycle_number=number, **values).second()
        self.report.update(time=time, cycle=number)
        for name, key in (("x_hook_state", "state"), ("x_hook_session", "session")):
            self.report[key] = int(values.get(name, self.report[key]))
        if "x_hook_answer" in values and "x_hook_sequence" in values:
            self.report.update(answer=int(values["x_hook_answer"]), answered=int(values["x_hook_sequence"]))
        self.report["clock"] = int(values.get("m_present_time", self.report["clock"]))
        return self

    def sbc(self, kind, payload):
        """The SBC sends a frame."""
        self.said = (self.said + 1) % 256
        self.steps[-1].received += wire.frame(wire.TYPES[kind], self.said, payload)
        return self

    def done(self, *fields):
        return self.sbc("Done", wire.PAYLOADS["Done"](*fields))

    def noise(self, received):
        self.steps[-1].received += received
        return self

    def sends(self, kind, payload):
        """hookprog sends a frame in this second."""
        self.out = (self.out + 1) % 256
        self.steps[-1].sent += wire.frame(wire.TYPES[kind], self.out, payload)
        return self

    def beacon(self):
        offers = 30 | self.virtual
        return self.sends("Beacon", wire.PAYLOADS["Beacon"](6, offers, int(self.virtual), HASH, self.report["state"]))

    def tick(self, *reports):
        return self.sends("Tick", wire.tick(self.report, self.subscription, reports))

    def keeps(self, *reports):
        """hookprog numbers the Tick of this cycle, keeps it, and beats in the place of the SBC."""
        self.out = (self.out + 1) % 256
        self.kept.append((self.out, dict(self.report), reports))
        self.heart += 1 if (self.heart + 1) % 2 == self.odd else 2
        return self.sets(("sci_hook_heartbeat", -self.heart))

    def sends_kept(self):
        """hookprog sends all that it has kept; returns their numbers."""
        numbers = [number for number, _, _ in self.kept]
        for number, report, reports in self.kept:
            payload = wire.tick(dict(report, kept=number != numbers[-1]), self.subscription, reports)
            self.steps[-1].sent += wire.frame(wire.TYPES["Tick"], number, payload)
        self.kept = []
        return numbers

    def sets(self, *pairs):
        """hookprog sets these sensors of the science computer, in this order."""
        self.steps[-1].sets += pairs
        return self

    def beats(self):
        self.heart += 1
        return self.sets(("sci_hook_heartbeat", self.heart))

    def event(self, kind, *numbers, time=None, text=""):
        if kind == "SbcNap":  # the numbers of its heartbeats: odd in the first, then even, and so on
            self.odd = 1 - self.odd
        self.steps[-1].events.append(Event(kind, self.report["time"] if time is None else time, *numbers, text=text))
        return self

    def link(self, number, name, features=7, newest=0):
        """The SBC opens a link, which is welcomed."""
        self.sbc("Hello", wire.PAYLOADS["Hello"](6, features, 0, HASH, number, name)).event("SbcHello", number, text=name)
        self.report["link"] = number
        self.subscription = b"\0"
        return self.sends("Welcome", wire.PAYLOADS["Welcome"](int(self.virtual), number, newest))

    def subscribe(self, *wanted):
        self.subscription = wire.subscribe([(NUMBER[name], every, band) for name, every, band in wanted])
        return self.sbc("Subscribe", self.subscription)


def words_of(given):
    """The sensors of an instruction, in the order in which the SBC's client writes them; of a mission that does not sample."""
    carried = wire.in_steps(given)
    return [("sci_hook_session", given["session"]), ("sci_hook_control", given["control"]), ("sci_hook_vertical", given["vertical"]),
            ("sci_hook_depth", wire.as_float32(carried["depth"])), ("sci_hook_pitch", wire.as_float32(carried["pitch"])),
            ("sci_hook_lateral", given["lateral"]), ("sci_hook_heading", wire.as_float32(carried["heading"])),
            ("sci_hook_lat", carried["latitude"]), ("sci_hook_lon", carried["longitude"]), ("sci_hook_check", wire.check_value(given)),
            ("sci_hook_sequence", given["sequence"])]


def words_of_sampling(given):
    """The same of a mission that samples."""
    return words_of(given) + [("sci_hook_sampling", given["sampling"])]


def written(words):
    return wire.write([(NUMBER[name], WIDTH[name], value) for name, value in words])


def flown():
    """A link, an instruction and its answer, events, refusals, and an SBC that falls silent."""
    take = words_of(INSTRUCTIONS[0])
    s = Session(1000)
    s.cycle(4.0, 1, x_hook_state=2, x_hook_session=0, x_hook_sequence=0, x_hook_answer=0, m_depth=0.5, m_present_time=1.7e9).beacon()
    s.second().link(7, "survey").subscribe(("m_depth", 1, 0), ("sci_water_temp", 1, 0), ("m_lat", 2, 0), ("m_device", 1, 1)).done(233, 0, 0, 0, 0, 0).beats()
    s.second().flight(sci_water_temp=12.25)
    s.cycle(8.0, 2, x_hook_state=2, m_depth=1.5, m_lat=3910.5, m_device=5).tick((4, 1.5), (4, 12.25), (8, 3910.5), (1, 5))
    s.second().done(s.out, 0, 0, 0, 0, 0).beats()
    # Only what the SBC does not hold, and m_lat not before the second Tick from there.
    s.cycle(12.0, 3, x_hook_state=2, m_depth=1.5, m_lat=3910.5, m_device=6).tick("same", None, None, "same")
    s.second().sbc("Write", written(take)).done(s.out, 7, 4, 1, 1, 1).sets(*take).beats()
    s.cycle(16.0, 4, x_hook_state=3, x_hook_session=7, x_hook_sequence=258, x_hook_answer=1, m_depth=2.5, m_lat=3910.6, m_device=7)
    s.tick((4, 2.5), None, (8, 3910.6), (1, 7))
    s.second().done(s.out, 7, 8, 1, 1, 1).beats()
    # The same mission time does not count as a heartbeat, nor does the Done of another session.
    s.second().done(s.out, 7, 8, 1, 1, 1).done(s.out, 6, 9, 1, 1, 1)
    s.second().sbc("Transition", wire.PAYLOADS["Transition"](9.5, 0, 1, 2, 3, 1)).event("SbcTransition", 0, 1, 2, 3, 1, time=9.5)
    s.sbc("Note", wire.PAYLOADS["Note"](9.5, 0, "deep")).event("SbcNote", 0, time=9.5, text="deep")
    s.sbc("Transition", wire.PAYLOADS["Transition"](7.5, 0, 1, 2, 3, 1)).event("StaleFrame", 1)
    s.second().sbc("Write", written([("sci_hook_depth", 20), ("sci_water_temp", 3)])).event("RefusedWrite", NUMBER["sci_water_temp"])
    s.second().noise(b"\x05\x01\x02\x03\x04\0\x03\x15\0").sbc("Done", b"short").event("BadFrame", 3)
    # The vehicle repeats a cycle, then goes on; an old instruction is refused.
    s.second().flight(m_present_secs_into_mission=16.0, m_cycle_number=3, x_hook_state=3).second()
    s.report.update(cycle=3)
    s.event("StaleFrame", 1)
    s.cycle(24.0, 6, x_hook_state=3, x_hook_session=7, x_hook_sequence=250, x_hook_answer=9, m_depth=3).event("OldInstruction", 250, time=24.0)
    s.tick((4, 3), None, None, None)
    # That Tick has no answer: 12 s later the SBC is lost.
    for _ in range(11):
        s.second()
    s.second().event("SbcLost", 7)
    s.cycle(28.0, 7, x_hook_state=3, x_hook_session=7).beacon()
    # Another mission of the vehicle has no hookbeh: after two cycles it is forgotten, and nothing more is set.
    s.cycle(4.0, 1, m_depth=0).event("StaleFrame", 1)
    s.cycle(8.0, 2, m_depth=0)
    s.report.update(state=0, session=0, answer=0, answered=0)
    s.beacon()
    s.second().link(8, "next", newest=7).sbc("Write", written(take)).done(1, 0, 0, 0, 0, 0)
    return s.steps


def refused():
    """An SBC of another version, of another vehicle, and one that lacks what the vehicle needs."""
    s = Session(16777215 + 200, True)
    s.cycle(4.0, 1, x_hook_state=1).beacon()
    s.second().sbc("Hello", b"\5anything").event("SbcRefused", 5, 0, 0)
    s.second().sbc("Hello", b"\5anything")
    s.second().sbc("Hello", wire.PAYLOADS["Hello"](6, 7, 0, HASH + 1, 9, "other")).event("SbcRefused", 6, HASH + 1, 0)
    s.second().sbc("Hello", wire.PAYLOADS["Hello"](6, 6, 0, HASH, 9, "waits not")).event("SbcRefused", 6, HASH, 1)
    s.second().sbc("Hello", wire.PAYLOADS["Hello"](6, 7, 0x8000, HASH, 9, "needs more")).event("SbcRefused", 6, HASH, 0x8000)
    s.second().done(1, 0, 0, 0, 0, 0).link(10, "waits", 1)
    s.cycle(8.0, 2, x_hook_state=1).tick()
    return s.steps


def unanswered():
    """The vehicle does not answer an instruction; and the mission time does not advance."""
    take = words_of(INSTRUCTIONS[0])
    s = Session(50)
    s.cycle(4.0, 1, x_hook_state=3, x_hook_session=7).beacon()
    s.second().link(7, "").sbc("Write", written(take)).done(s.out, 7, 1, 1, 1, 1).sets(*take).beats()
    for second in range(1, 25):
        s.second().done(0, 7, 1, 1, 1, 1)
        if second == 12:
            s.event("SbcStuck", 7)
        if second == 24:
            s.event("SbcUnanswered", 258)
    s.second().done(0, 7, 2, 1, 1, 1).beats()
    return s.steps


def sampled():
    """A mission that samples, and another behind it that does not: the instruments get the word of none that is gone."""
    s = Session(70)
    s.cycle(4.0, 1, x_hook_state=3, x_hook_session=7).beacon()
    s.second().link(7, "samples", features=15)
    given = words_of_sampling(INSTRUCTIONS[-2])
    s.sbc("Write", written(given)).done(s.out, 7, 1, 1, 1, 1).sets(*given).beats()
    given = words_of_sampling(INSTRUCTIONS[3])  # with a 0
    s.second().sbc("Write", written(given)).done(0, 7, 2, 1, 1, 1).sets(*given).beats()
    s.second().link(8, "does not", newest=9)
    given = words_of(INSTRUCTIONS[0])
    s.sbc("Write", written(given)).done(s.out, 7, 3, 1, 1, 1).sets(*given, ("sci_hook_sampling", 0)).beats()
    s.second().sbc("Write", written(given)).done(0, 7, 4, 1, 1, 1).sets(*given, ("sci_hook_sampling", 0)).beats()
    return s.steps


def sampled_before():
    """The word of a mission that sampled before hookprog began."""
    s = Session(70)
    s.cycle(4.0, 1, x_hook_state=3, x_hook_session=7).flight(sci_hook_sampling=33).beacon()
    given = words_of(INSTRUCTIONS[0])
    s.second().link(8, "does not").sbc("Write", written(given)).done(s.out, 7, 3, 1, 1, 1)
    s.sets(*given, ("sci_hook_sampling", 0)).beats()
    return s.steps


def long():
    """Values that are sent again, Ticks without an answer, a flight controller that never pauses, many notes, a hookbeh that is gone."""
    s = Session(300)
    s.cycle(4.0, 1, x_hook_state=2).beacon()
    s.second().link(3, "long").subscribe(("m_depth", 1, 0)).done(s.out, 0, 0, 0, 0, 0).beats()
    for number in range(2, 20):  # R4: the first Tick has the value, and that 16 Ticks later
        s.cycle(4.0 * number, number, x_hook_state=2, m_depth=5).tick((4, 5) if number in (2, 18) else "same")
        s.second().done(s.out, 0, 0, 0, 0, 0).beats()
    # R1: an answer to a Tick is none to the value that went since.
    s.cycle(80.0, 20, x_hook_state=2, m_depth=6).tick((4, 6))
    answered = s.out
    s.cycle(84.0, 21, x_hook_state=2, m_depth=7).tick((4, 7))
    s.second().done(answered, 0, 0, 0, 0, 0).beats()
    s.cycle(88.0, 22, x_hook_state=2, m_depth=7).tick((4, 7))
    s.second().done(s.out, 0, 0, 0, 0, 0).beats()
    s.second().flight(m_present_secs_into_mission=92.0, m_cycle_number=23, x_hook_state=2)
    for depth in (8, 8.5, 9):
        s.second().flight(m_depth=depth)
    s.report.update(time=92.0, cycle=23)
    s.tick((4, 9))
    s.second().done(s.out, 0, 0, 0, 0, 0).beats()
    s.second()
    for number in range(20):
        s.sbc("Note", wire.PAYLOADS["Note"](0.0, 0, f"note {number}"))
        if number < 16:
            s.event("SbcNote", 0, time=0.0, text=f"note {number}")
    s.sbc("Transition", wire.PAYLOADS["Transition"](0.0, 1, 2, 3, 4, 0)).event("SbcTransition", 1, 2, 3, 4, 0, time=0.0)
    for number in range(24, 30):
        s.report["state"] = 0 if number == 29 else 2
        s.cycle(4.0 * number, number).tick(None)
        s.second().done(s.out, 0, 0, 0, 0, 0)
        if number < 29:
            s.beats()
    return s.steps


def napped():
    """Z1 to Z8: a nap that a value ends, one that hookbeh does not allow, and one from which the SBC does not come back."""
    s = Session(500)
    s.cycle(4.0, 1, x_hook_state=3, x_hook_session=7, x_hook_nap_secs=43).beacon()
    s.second().link(4, "sleeps", features=31).subscribe(("m_depth", 1, 0.5), ("m_lat", 3, 0)).done(s.out, 7, 1, 1, 1, 1).beats()
    s.cycle(8.0, 2, x_hook_state=3, m_depth=5, m_lat=3910.5).tick((4, 5), (8, 3910.5))
    s.second().sbc("Nap", wire.nap(3, 41, [])).done(s.out, 7, 5, 1, 1, 1).beats()  # longer than it may be
    s.cycle(12.0, 3, x_hook_state=3, m_depth=5).tick("same", None)
    s.second().sbc("Nap", wire.nap(3, 40, [(NUMBER["m_depth"], 0, 20.5), (NUMBER["m_lat"], 1, 0.0)])).done(s.out, 7, 9, 1, 1, 1)
    s.beats().event("SbcNap", 40, 2)
    s.cycle(16.0, 4, x_hook_state=3, m_depth=6, m_lat=3910.6).keeps((4, 6), None)
    s.cycle(20.0, 5, x_hook_state=3, m_depth=6.25, m_lat=3910.6).keeps((4, 6), (8, 3910.6))  # within the dead band: the value from before once more
    s.cycle(24.0, 6, x_hook_state=3, m_depth=20.5, m_lat=3910.7).keeps((4, 20.5), None).event("SbcWoken", 1, 3)
    s.second().second().second()
    numbers = s.sends_kept()
    s.second()
    for time, number in enumerate(numbers, 13):
        s.done(number, 7, time, 1, 1, 1).beats()
    s.cycle(28.0, 7, x_hook_state=3, m_depth=20.25).tick("same", None)
    s.second().sbc("Nap", wire.nap(0, 8, [])).done(s.out, 7, 25, 1, 1, 1).beats().event("SbcNap", 8, 0)
    s.cycle(32.0, 8, x_hook_state=3, m_depth=3).keeps((4, 3), None)
    s.cycle(36.0, 9, x_hook_state=3, m_depth=3).keeps((4, 3), None).event("SbcWoken", 2, 2).sends_kept()
    for _ in range(11):
        s.second()
    s.second().event("SbcLost", 4)
    s.cycle(40.0, 10, x_hook_state=3).beacon()
    return s.steps


ALL_AT_ONCE = 2048
# (name, in virtual time, bytes that the line takes in a second, seconds)
SESSIONS = [("a flight", False, ALL_AT_ONCE, flown()), ("a slow line", False, 11, flown()), ("refusals", True, ALL_AT_ONCE, refused()),
            ("no answer", False, ALL_AT_ONCE, unanswered()), ("a long link", False, ALL_AT_ONCE, long()),
            ("instruments", False, ALL_AT_ONCE, sampled()), ("instruments of before", False, ALL_AT_ONCE, sampled_before()),
            ("naps", False, ALL_AT_ONCE, napped())]
