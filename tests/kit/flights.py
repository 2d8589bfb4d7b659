# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""Flights of hookbeh, each for one of its rules, cycle by cycle.

What hookbeh must do is written by hand from hooks/hookbeh/README.md and hooks/protocol/README.md. A cycle takes 4 s, unless the
flight is about its length. Depths are multiples of an eighth of a metre, so that nothing depends on a last bit.
"""

import itertools
import math

from flight import (ACTUATORS, ASCEND, BAD_BATTERY, BAD_CHECK, BAD_COMMAND, BAD_FIN, BAD_PITCH, BAD_PUMP, COMPLETE, DESCEND, DRIFT, FIN,
                    HEADING, HOVER, MASKED_PITCH, MASKED_PUMP, NAN, NOT_ON_EARTH, NOT_READY, OLD_SEQUENCE, READY, RELEASE, SURFACE, TAKE,
                    TOO_DEEP, USUAL_PITCH, WAITING, WAYPOINT, WRONG_SESSION, Flight, taken)

# m/s; what hookbeh assumes of a dive at 26 degrees: 0.44 m/s at 45, in proportion.
SINKS_UNSEEN = 0.44 * 26 / 45


def line_end(depths, before_m, rate_mps):
    """Depth and rate at the end of the line through `depths`, one a cycle, and an endless line before them; each counts 0.6 times as
    much as the next one (6 s of smoothing: 6 / (6 + 4))."""
    points = [(4 * n, depth) for n, depth in enumerate(depths, 1)] + [(-4 * n, before_m - 4 * n * rate_mps) for n in range(100)]
    weights = [0.6 ** (len(depths) - time / 4) for time, _ in points]
    mean_t, mean_d = (sum(w * p[axis] for w, p in zip(weights, points, strict=True)) / sum(weights) for axis in (0, 1))
    slope = (sum(w * (t - mean_t) * (d - mean_d) for w, (t, d) in zip(weights, points, strict=True)) /
             sum(w * (t - mean_t) ** 2 for w, (t, _) in zip(weights, points, strict=True)))
    return mean_d + slope * (4 * len(depths) - mean_t), slope


def hover_volumes(target_m, before_m, rate_mps, depths):
    """Each of `depths`, one a cycle, and the pump in it, of a hover that began at `before_m`."""
    pump = 40 * (before_m - target_m) + 1000 * rate_mps
    for count, depth in enumerate(depths, 1):
        fresh = [one for one, _ in itertools.groupby([before_m, *depths[:count]])][1:]  # the array keeps a depth
        at, rate = line_end(fresh, before_m, rate_mps)
        volume = max(-230, min(230, 40 * (at - target_m) + 1000 * rate))
        assert abs(abs(volume - pump) - 25) > 0.1, f"cycle {count}: {volume} is too near to rest or move"
        pump = pump if abs(volume - pump) <= 25 else volume
        yield depth, pump


def a_session():
    """Waiting, Ready, Active, Complete. What is in the array at the start is not followed, nor what comes before its time."""
    f = Flight("a session", start_secs=20)
    old = f.says(DESCEND, 20, -USUAL_PITCH, control=TAKE, answer=0, sequence=40)
    f.rests(WAITING).cycle(depth_m=0.5, **old)
    f.cycle(**f.says(DESCEND, 20, -USUAL_PITCH, control=TAKE, answer=NOT_READY)).cycle().cycle()
    f.rests(READY).cycle()  # at 20 s
    take = f.takes(DESCEND, 20, -USUAL_PITCH)
    f.dives().cycle(**take).through(1, 3, 0.5)
    release = f.says(control=RELEASE)
    f.rests(COMPLETE).wants(session=0).cycle(**release)
    return f.cycle(**f.says(DESCEND, 20, -USUAL_PITCH, control=TAKE, session=8, answer=NOT_READY))


def refusals():
    """An instruction outside the b_args is refused with its reason, and the one in force stays. At a limit it is accepted."""
    f = Flight("refusals")
    f.sequence = 65520  # the numbers go on at 1 after 65535
    depth = itertools.count(1, 0.375)
    f.cycle(depth_m=0.5)
    take = f.takes(DESCEND, 30, -0.61)
    f.dives(-0.61).cycle(depth_m=0.75, **take)
    for answer, *command in (
            (TOO_DEEP, DESCEND, 30.001, -USUAL_PITCH), (TOO_DEEP, ASCEND, 30.001, USUAL_PITCH), (TOO_DEEP, HOVER, 31),
            (BAD_PITCH, DESCEND, 20, USUAL_PITCH), (BAD_PITCH, DESCEND, 20, -0.6101), (BAD_PITCH, ASCEND, 5, 0.1899),
            (BAD_COMMAND, HOVER, -0.001), (BAD_COMMAND, HOVER, NAN), (BAD_COMMAND, 6, 20, -USUAL_PITCH), (BAD_COMMAND, SURFACE, 0, 0, 4),
            (BAD_COMMAND, SURFACE, 0, 0, HEADING, math.tau + 0.0001), (BAD_FIN, SURFACE, 0, 0, FIN, 0.4501),
            (BAD_FIN, SURFACE, 0, 0, FIN, -0.4501), (BAD_PUMP, ACTUATORS, 233.001, 0), (BAD_PUMP, ACTUATORS, -234, 0),
            (BAD_BATTERY, ACTUATORS, 0, 0.6001), (BAD_BATTERY, ACTUATORS, 0, -0.7), (NOT_ON_EARTH, SURFACE, 0, 0, WAYPOINT, 0, 9001, 0),
            (NOT_ON_EARTH, SURFACE, 0, 0, WAYPOINT, 0, 4561, 0), (NOT_ON_EARTH, SURFACE, 0, 0, WAYPOINT, 0, 0, -18000.1)):
        f.cycle(depth_m=next(depth), **f.says(*command, answer=answer))
    f.cycle(depth_m=next(depth), **f.says(SURFACE, control=0, answer=BAD_COMMAND))
    f.cycle(depth_m=next(depth), **f.says(SURFACE, session=8, answer=WRONG_SESSION))
    newest = f.sequence
    f.cycle(depth_m=next(depth), **f.says(SURFACE, answer=OLD_SEQUENCE, sequence=newest - 1))
    f.cycle(depth_m=next(depth), **f.says(HOVER, 30, answer=BAD_CHECK, sequence=newest + 1, check=1))
    heals = f.says(HOVER, 30, sequence=newest + 1)
    f.dives().cycle(depth_m=next(depth), latitude_ddmm=0, longitude_ddmm=0, **heals)
    f.cycle(depth_m=next(depth), **f.says(lateral=WAYPOINT, latitude=-9000, longitude=17960))  # 60 minutes are a rounded 59.999
    full = f.says(ACTUATORS, 233, -0.6, FIN, 0.45)
    return f.flies("Actuators", 0, 233).wants(pitch_mode="Battery", battery_in=-0.6).cycle(depth_m=next(depth), **full)


def silence():
    """24 s without a newer heartbeat end control, and only a newer session takes it again. An old heartbeat is not one."""
    f, take = taken("silence", DESCEND, 20, -USUAL_PITCH)
    f.dives().cycle(**take)
    f.beats = False
    f.through(1, 3, 0.5).loses().cycle(depth_m=3.5)
    f.cycle(depth_m=3, **f.says(DESCEND, 20, -USUAL_PITCH, control=TAKE, answer=WRONG_SESSION))
    f.beats, f.session = True, 8
    take = f.takes(DESCEND, 20, -USUAL_PITCH)
    f.dives().cycle(depth_m=3.5, **take)
    newest = f.clocks["heartbeat"]
    for old in range(newest - 6, newest - 1):
        f.cycle(depth_m=4 + (newest - old) / 8, heartbeat=old)
    return f.loses().cycle(depth_m=4, heartbeat=newest - 1)


def garbled():
    """An instruction that is garbled for 24 s ends control, though the heart beats."""
    f, take = taken("a garbled line", DESCEND, 20, -USUAL_PITCH)
    f.dives().cycle(**take)
    wrong = f.says(SURFACE, answer=BAD_CHECK, check=1)
    return f.cycle(depth_m=1, **wrong).through(1.5, 3, 0.5).loses().cycle(depth_m=3.5)


def clocks():
    """How long a cycle is, as the time of silence shows: after how many cycles, of which length by either clock, the SBC is lost."""
    f = Flight("clocks")
    f.cycle(depth_m=0.5)
    for cycles, mission, wall, number in (
            (6, 0, NAN, 1),  # time that does not advance: 4 s
            (3, 8, NAN, 1), (6, 8.125, NAN, 1),  # by one clock alone: up to twice 4 s, else 4 s
            (2, 16, NAN, 2),  # for each cycle that the number counts
            (2, 12, 12, 1), (2, 24, 24, 1),  # by both: as they say, up to 20 s
            (6, -100, 4, 1), (6, 1000, 4, 1), (6, 4, 8, 1)):  # what the other or the number contradicts
        f.beats, f.session = True, f.session + 1
        take = f.takes(SURFACE)
        f.surfaces().cycle(depth_m=0.5, **take)
        f.beats = False
        for left in reversed(range(cycles)):
            for clock, step in (("time_s", mission), ("cycle_number", number)) + (() if math.isnan(wall) else (("wall_time_s", wall),)):
                f.clocks[clock] += step - (1 if clock == "cycle_number" else 4)
            if left == 0:
                f.loses()
            f.cycle(depth_m=left / 8, **({"wall_time_s": NAN} if math.isnan(wall) else {}))
    return f


def false_time():
    """One false reading of the time neither ends a hold early nor makes hookbeh ready."""
    f = Flight("a false time", start_secs=30)
    f.rests(WAITING).cycle(depth_m=0.5).cycle(time_s=1000)
    for _ in range(5):
        f.cycle()
    f.rests(READY).cycle()
    take = f.takes(DESCEND, 5, -USUAL_PITCH)
    f.dives().cycle(depth_m=1, **take).through(2, 4, 1)
    f.flies("Hold", -USUAL_PITCH, -230).cycle(depth_m=5).cycle(depth_m=5.25, time_s=2000).cycle(depth_m=5.375)
    return f.flies("Hover", 0, 10).cycle(depth_m=5.25)


def steering():
    """Heading, fin, waypoint and drift; towards a waypoint from an unknown position it goes straight on."""
    f, take = taken("steering", SURFACE, 0, 0, HEADING, -1)
    f.surfaces().cycle(**take)
    f.cycle(**f.says(lateral=FIN, heading=-0.45))
    waypoint = f.says(lateral=WAYPOINT, latitude=3860, longitude=-18000)
    f.steers(DRIFT).cycle(**waypoint)
    f.steers(WAYPOINT, 0, 3860, -18000).cycle(latitude_ddmm=3859.5, longitude_ddmm=-7200)
    return f.cycle(**f.says(lateral=DRIFT))


def actuators():
    """Pump and battery stay as commanded, until a guard makes the vehicle climb by the servo; then they are held again."""
    f, take = taken("pump and battery", ACTUATORS, -150, 0.3, greatest_depth_m=10)
    held = {"doing": "Actuators", "pitch_mode": "Battery", "battery_in": 0.3, "pump_cc": -150}
    f.flies("Actuators", 0, -150).wants(**held).cycle(**take).through(1, 10, 1)
    f.guards(1).through(10.5, 5.5, -0.5)  # a climb of 5 m, as half of the depth is no more
    return f.flies("Actuators", 0, -150).wants(**held).cycle(depth_m=5)


def too_deep():
    """Guard 1 ends after half of the depth, and the dive is tried again; with a command to climb it ends a metre above the limit."""
    f, take = taken("too deep", DESCEND, 30, -USUAL_PITCH)
    f.dives().cycle(**take).through(1, 29, 1)
    f.flies("Hold", -USUAL_PITCH, -230).cycle(depth_m=30)
    f.guards(1).cycle(depth_m=30.25).through(31, 16, -1).cycle(depth_m=15.25)
    f.dives().through(15, 29, 1).flies("Hold", -USUAL_PITCH, -230).cycle(depth_m=30)
    f.guards(1).cycle(depth_m=30.25)
    f.cycle(depth_m=30, **f.says(SURFACE)).cycle(depth_m=29.125)
    return f.surfaces().cycle(depth_m=29)


def no_limit():
    """A greatest depth that is not a number is a violated limit."""
    f, take = taken("no greatest depth", SURFACE, greatest_depth_m=NAN)
    return f.guards(1).cycle(**take).cycle(depth_m=0.25)


def near_the_bottom():
    """Guard 2 turns a dive 8 s of sinking before 5 m over the bottom, and for 40 s without an echo too."""
    f = Flight("near the bottom")
    f.cycle(depth_m=0.5, altitude_m=3)  # from before
    take = f.takes(DESCEND, 25, -USUAL_PITCH)
    f.dives().cycle(**take).through(1, 4, 1, depth_rate_mps=0.25)
    for depth in range(5, 14):
        f.cycle(depth_m=depth, altitude_m=20 - depth)
    f.guards(2).cycle(depth_m=14, altitude_m=6).cycle(depth_m=14.5, altitude_m=5.5, depth_rate_mps=-0.25)
    for depth in range(14, 8, -1):
        f.cycle(depth_m=depth, altitude_m=20 - depth)
    f.cycle(depth_m=8).dives().cycle(depth_m=7, depth_rate_mps=0.25).through(8, 13, 1)
    return f.guards(2).cycle(depth_m=13.125)


def touched(name, least_altitude_m, false_bottom_m):
    """A dive that stops for 24 s, and whose depth follows the climb, has touched the bottom: the next one turns 2 m and the least
    altitude above that, for any altimeter."""
    f, take = taken(name, DESCEND, 50, -USUAL_PITCH, depth=0, greatest_depth_m=60, least_altitude_m=least_altitude_m)
    turns_m = 24 - 2 - (least_altitude_m if least_altitude_m >= 0 else 3)

    def cycle(depth, **readings):
        f.cycle(depth_m=depth, altitude_m=false_bottom_m - depth, **readings)

    f.dives()
    cycle(0, **take)
    for depth in range(1, 17):
        cycle(1.5 * depth)
    for number in range(5):  # 24 s to the cycle in which it is commanded to climb
        cycle(24 - (number + 1) % 2 / 8)
    climb = f.says(SURFACE)
    f.surfaces()
    for depth in range(24, 9, -1):  # it is sure of the bottom after 2.5 m
        f.guards(2) if turns_m - 1 < depth <= 21 else f.surfaces()
        cycle(depth, **(climb if depth == 24 else {}))
    again = f.says(DESCEND, 50, -USUAL_PITCH)
    f.dives()
    for depth in range(11, turns_m + 1):
        cycle(depth, **(again if depth == 11 else {}))
    f.guards(2)
    cycle(turns_m + 0.125)
    return f


def unknown_depth():
    """Guard 3 lasts as long as there is no depth that a sensor gives; the heading stays."""
    f, take = taken("no depth", DESCEND, 20, -USUAL_PITCH)
    f.dives().cycle(**take).through(1, 4, 1)
    f.guards(3).cycle(depth_m=NAN).cycle(depth_m=-5.125).cycle(depth_m=300.125)
    return f.dives().cycle(depth_m=4.5)


def depth_jumps():
    """Guard 4: a reading that jumps reaches no target; a depth that jumps for 10 s is believed when the CTD has agreed for a minute."""
    f, take = taken("a depth that jumps", DESCEND, 24, -USUAL_PITCH)
    f.dives().cycle(**take).through(1, 16, 1).cycle(depth_m=20)  # 4 m in 4 s is not a jump
    f.guards(4).cycle(depth_m=24.25)
    f.dives().cycle(depth_m=21).cycle(depth_m=22)
    f.guards(4).cycle(depth_m=29).cycle(depth_m=29.5).cycle(depth_m=29.75).through(22, 20.5, -0.25)
    for number in range(1, 15):
        f.cycle(depth_m=20.5 - number / 4, ctd_bar=(20.5 - number / 4) / 10)
    return f.dives().cycle(depth_m=16.75, ctd_bar=1.675)


def depth_freezes():
    """Guard 5 begins after 16 s of one depth, and ends when it has changed for two minutes of climbing, up to 3 m."""
    f, take = taken("a frozen depth", DESCEND, 20, -USUAL_PITCH)
    f.dives().cycle(**take).through(1, 10, 1).cycle().cycle().cycle()
    f.guards(5).cycle().cycle().cycle().through(9.5, 2.5, -0.25)
    return f.dives().cycle(depth_m=2.25)


def depths_disagree():
    """Guard 6 begins when depth and CTD have differed by more than 5 m for 10 s, and ends after two minutes of climbing, at 3 m."""
    f, take = taken("depths that disagree", DESCEND, 28, -USUAL_PITCH)
    f.dives().cycle(**take)
    for number in range(1, 28):
        depth = number / 2
        f.cycle(depth_m=depth, ctd_bar=(depth + max(0, number - 20)) / 10)
    f.guards(6).cycle(depth_m=14, ctd_bar=2.2)
    for number in range(1, 32):
        depth = 14 - 0.375 * number
        if number == 31:
            f.dives()
        f.cycle(depth_m=depth, ctd_bar=max(22 - 1.5 * number, depth) / 10)
    return f


def stuck_ctd():
    """A CTD that gives one value while the depth changes by 3 m is not used: it ends no dive."""
    f, take = taken("a stuck CTD", DESCEND, 28, -USUAL_PITCH)
    f.dives().cycle(**take)
    for number in range(1, 40):
        f.cycle(depth_m=number / 2, ctd_bar=min(number / 2, 6) / 10)
    return f


def checks_depth():
    """A hover that may have sunk to the greatest depth climbs until its depth follows by 2.5 m, and returns by its pump."""
    f, take = taken("a hover that checks its depth", ASCEND, 20, USUAL_PITCH, depth=26.5, greatest_depth_m=29.875, hold_secs=0)
    f.flies("ClimbTo", USUAL_PITCH, 230).cycle(depth_m=26, **take).through(25, 21, -1)
    f.flies("Hover", 0, 0).cycle(depth_m=20)
    cycles = math.ceil((12 + (29.875 - 20) / 0.1) / 4)  # it sinks by 0.1 m/s at most, and not in the first 12 s after the climb
    rests = [20 - (number + 1) % 2 / 8 for number in range(cycles - 1)]
    climbs = [20 - number / 8 for number in range(20)]
    for number, (depth, volume) in enumerate(hover_volumes(20, 20, 0, rests + climbs + [17.5, 16.5]), 1):
        f.flies("Hover", 0, volume)
        if cycles <= number < cycles + len(climbs):
            f.flies("CheckDepth", USUAL_PITCH, 233)
        f.cycle(depth_m=depth)
    return f


def no_headway():
    """Guard 7 ends a dive that gains less than a metre in 180 s, though the CTD agrees."""
    f, take = taken("no depth gained", DESCEND, 100, -USUAL_PITCH, greatest_depth_m=200)
    f.dives().cycle(**take)
    for depth in range(1, 13):
        f.cycle(depth_m=depth, ctd_bar=depth / 10)
    for number in range(1, 46):
        depth = 12 - number % 2 / 8
        if number == 45:
            f.guards(7)
        f.cycle(depth_m=depth, ctd_bar=depth / 10)
    return f.through(11, 9, -1)


def unseen():
    """Guard 7 ends a dive to 10 m that may be 8 m past it, as fast as it may sink: a depth that flickers does not show it."""
    f, take = taken("a dive that is not seen", SURFACE)
    f.surfaces().cycle(**take).around(0.5, 10)
    dive = f.says(DESCEND, 10, -USUAL_PITCH)
    f.dives().cycle(depth_m=0.375, **dive)
    cycles = math.ceil((12 + 18 / SINKS_UNSEEN) / 4)  # of the first 12 s none count
    return f.around(0.5, cycles - 1).guards(7).cycle(depth_m=0.625)


def swell():
    """In swell of a metre the line through the newest readings shows a slow dive."""
    f, take = taken("swell", DESCEND, 28, -USUAL_PITCH, depth=1)
    f.dives().cycle(depth_m=1.25, **take)
    for number in range(2, 32):
        f.cycle(depth_m=1 + 0.75 * number + (1 if number % 2 else -1))
    return f


def no_height():
    """Guard 8 helps a climb that gains less than a metre in 240 s with the whole stroke, until it has climbed a metre."""
    f, take = taken("no height gained", ASCEND, 5, USUAL_PITCH, depth=23)
    f.flies("ClimbTo", USUAL_PITCH, 230).cycle(depth_m=22, **take).through(21, 20, -1).around(20, 59)
    f.guards(8).cycle(depth_m=20).cycle(depth_m=19.125)
    return f.flies("ClimbTo", USUAL_PITCH, 230).cycle(depth_m=19)


def hover():
    """A hover is level; its pump is 40 cc a metre and 1000 cc a metre a second, and rests until it differs by more than 25 cc."""
    f, take = taken("hover", HOVER, 10, depth=9)
    f.flies("Hover", 0, 40 * (9.25 - 10) + 1000 * 0.0625).cycle(depth_m=9.25, depth_rate_mps=0.0625, **take)
    for depth, volume in hover_volumes(10, 9.25, 0.0625, [9.5, 9.75, 10, 10.5, 10.25, 10.75, 10.5, 10.75, 10.125, 9.375] + 8 * [9.125]):
        f.flies("Hover", 0, volume).cycle(depth_m=depth)
    return f


def masked():
    """While pitch or pump are another behaviour's the time of a hold does not advance; a pump elsewhere shows it too."""
    f, take = taken("masked", DESCEND, 5, -USUAL_PITCH)
    f.dives().cycle(**take).through(1, 4, 1, commanded_pump_cc=-200)  # 30 cc off: not another's
    f.flies("Hold", -USUAL_PITCH, -230).cycle(depth_m=5)
    f.wants(masked=MASKED_PITCH).cycle(depth_m=5.125, masked=MASKED_PITCH)
    f.wants(masked=MASKED_PUMP).cycle(depth_m=5.25, commanded_pump_cc=-199)
    f.wants(masked=0).cycle(depth_m=5.375, commanded_pump_cc=-230).cycle(depth_m=5.5)
    return f.flies("Hover", 0, 10).cycle(depth_m=5.25)


def hull():
    """b_args beyond the hull count as the hull's limits; a pump of the wrong sign is turned round, a weak climb strengthened."""
    f, take = taken("the hull", DESCEND, 200, -0.7854, greatest_depth_m=500, steepest_pitch_rad=1.2, shallowest_pitch_rad=0.05,
                    greatest_fin_rad=1, greatest_pump_cc=500, greatest_battery_in=3, dive_pump_cc=300, climb_pump_cc=10, least_altitude_m=0.5)
    f.flies("DiveTo", -0.7854, -233).cycle(**take)
    for number, (answer, *command) in enumerate((
            (TOO_DEEP, DESCEND, 200.001, -USUAL_PITCH), (BAD_PITCH, DESCEND, 20, -0.7855), (BAD_PITCH, DESCEND, 20, -0.1899),
            (BAD_FIN, SURFACE, 0, 0, FIN, 0.4501), (BAD_PUMP, ACTUATORS, 233.001, 0), (BAD_BATTERY, ACTUATORS, 0, 0.6001))):
        f.cycle(depth_m=1 + number, **f.says(*command, answer=answer))
    f.cycle(depth_m=7, altitude_m=2.5).cycle(depth_m=7.5)  # 2 m over the bottom at least
    f.guards(2).cycle(depth_m=7.625).through(7, 3, -1)
    climb = f.says(ASCEND, 1, 0.19)
    return f.flies("ClimbTo", 0.19, 116.5).cycle(depth_m=2.5, **climb)


def whole_stroke():
    """With pump mode 0 the pump makes the hull's whole stroke; what is usually 26 degrees is within the b_args."""
    f = Flight("the whole stroke", whole_stroke=True, steepest_pitch_rad=0.3)
    f.cycle(depth_m=0.5)
    take = f.takes(DESCEND, 20, -0.3)
    f.flies("DiveTo", -0.3, -233).cycle(**take).through(1, 3, 1)
    climb = f.says(SURFACE)
    f.flies("Surface", 0.3, 233).cycle(depth_m=3.5, **climb)
    return f.guards(3).wants(pitch_rad=0.3).cycle(depth_m=NAN)


def instruments():
    """They read as the instruction in force says, also while a guard makes the vehicle climb, and as the vehicle's mission says without one."""
    f = Flight("instruments")
    f.cycle(depth_m=0.5)
    often, seldom = 1 | 6 << 5, (1 << 30) - 1
    take = f.takes(DESCEND, 28, -USUAL_PITCH, sampling=often)
    f.dives().cycle(depth_m=0.75, **take).through(1, 2, 0.5)
    f.cycle(depth_m=2.5, **f.says(DESCEND, 31, -USUAL_PITCH, answer=TOO_DEEP, sampling=seldom))
    number = f.sequence + 1
    for depth, wrong in ((3, 0.5), (3.5, 2.0**30), (4, -1)):
        f.cycle(depth_m=depth, **dict(f.says(DESCEND, 20, -USUAL_PITCH, answer=BAD_CHECK, sequence=number, sampling=often), **{"words.sampling": wrong}))
    f.cycle(depth_m=4.5, **f.says(DESCEND, 20, -USUAL_PITCH, sequence=number, sampling=seldom))
    left = f.says(DESCEND, 20, -USUAL_PITCH, answer=BAD_CHECK)  # of another mission: the word is left over
    f.cycle(depth_m=5, **left)
    f.cycle(depth_m=5.5, **f.says(DESCEND, 20, -USUAL_PITCH, sequence=f.sequence, sampling=0))
    f.cycle(depth_m=6, **f.says(DESCEND, 20, -USUAL_PITCH, sampling=often))
    f.guards(3).cycle(depth_m=NAN)
    f.dives().cycle(depth_m=6.5)
    f.beats = False
    return f.through(7, 9, 0.5).loses().cycle(depth_m=9.5)


def all_flights():
    return [a_session(), refusals(), silence(), garbled(), clocks(), false_time(), steering(), actuators(), too_deep(), no_limit(),
            near_the_bottom(), touched("a bottom that the altimeter does not show", 5, 40), touched("a bottom without an altimeter", -1, 12),
            unknown_depth(), depth_jumps(), depth_freezes(), depths_disagree(), stuck_ctd(), checks_depth(), no_headway(), unseen(),
            swell(), no_height(), hover(), masked(), hull(), whole_stroke(), instruments()]
