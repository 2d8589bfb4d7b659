# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""When a mutant misbehaves in flight: rules fixed before the checks that are to catch it.

Each compares the figures of its flight with those of the good mission's in the same world, and says in words what is
wrong, or nothing.
"""

GREATEST_DEPTH_M = 200  # of platforms/slocum.toml
OVERSHOOT_M = 5  # of platforms/slocum.toml


def no_control(good, bad):
    """the SBC never takes control"""
    return "never in control" if bad.control_s is None else None


def never_exits(good, bad):
    """the good mission exits, the mutant does not"""
    if good.exit_s is not None and bad.exit_s is None:
        return f"no exit; the good mission's is at {good.exit_s:.0f} s"
    return None


def ends_late(good, bad):
    """exits after half as much time again as the good mission takes, and 10 min more"""
    if good.exit_s is None or bad.exit_s is None:
        return None
    if bad.exit_s - bad.control_s > 1.5 * (good.exit_s - good.control_s) + 600:
        return f"exits at {bad.exit_s:.0f} s, the good mission at {good.exit_s:.0f} s"
    return None


def ends_at_once(good, bad):
    """exits within a minute, where the good mission flies for 10 min or more"""
    if bad.exit_s is not None and bad.exit_s - bad.control_s <= 60 and good.last_s - good.control_s >= 600:
        return f"exits after {bad.exit_s - bad.control_s:.0f} s in control"
    return None


def too_deep(good, bad):
    """deeper than the vehicle may, or than the good mission's deepest command and the inflection overshoot"""
    limit = min(GREATEST_DEPTH_M, max(good.deepest_command_m + OVERSHOOT_M, good.deepest_m + 1))
    if bad.deepest_m > limit:
        return f"{bad.deepest_m:.1f} m deep; more than {limit:.1f} m"
    return None


def aborts(good, bad):
    """the vehicle aborts"""
    return bad.aborted if good.aborted is None else None


def refused(good, bad):
    """the vehicle refuses an instruction"""
    return bad.refused if good.refused is None else None


def guarded(good, bad):
    """hookbeh's own guard has to climb, because of the depth or the bottom"""
    return bad.guarded if good.guarded is None else None


def no_command(good, bad):
    """a cycle in control without a command up, down or level"""
    if good.idle_s is None and bad.idle_s is not None:
        return f"nothing is commanded at {bad.idle_s:.0f} s"
    return None


def never_surfaces(good, bad):
    """the good mission comes up to the surface, the mutant flies as long and does not"""
    if good.surfaced and not bad.surfaced and bad.last_s >= good.last_s:
        return "never at the surface"
    return None


def bounces(good, bad):
    """20 transitions or more within 5 min, and more than twice as many as the good mission's"""
    if bad.most_transitions >= 20 and bad.most_transitions > 2 * good.most_transitions:
        return f"{bad.most_transitions} transitions within 5 min"
    return None


def astray(good, bad):
    """further from the start than twice as far as the good mission, and 500 m more"""
    if bad.farthest_m > 2 * good.farthest_m + 500:
        return f"{bad.farthest_m:.0f} m from the start; the good mission {good.farthest_m:.0f} m"
    return None


RULES = (no_control, aborts, refused, no_command, too_deep, guarded, never_exits, ends_at_once, ends_late, never_surfaces,
         bounces, astray)


def misbehaves(good, bad):
    """What the first rule that is broken says: (rule, words); None if none is, or nothing can be compared because not even
    the good mission was ever in control."""
    if good.control_s is None:
        return None
    for rule in RULES if bad.control_s is not None else (no_control,):
        words = rule(good, bad)
        if words:
            return rule.__name__.replace("_", "-"), words
    return None
