# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""Faults for scripts/mutants_campaign: for each requirement of hooks/hookbeh/README.md edits that break it.

`old` stands exactly once in `file`. What ends in `;` or `}` is a statement, everything else an expression.
"""

import dataclasses


@dataclasses.dataclass
class Planted:
    requirement: str
    what: str
    file: str
    old: str
    new: str
    faults: tuple = ()  # the campaign flies these kinds only; none: all
    scenario: str = ""  # lines that the campaign's scenario has beside those of scenarios/default.toml
    missions: tuple = ()  # the campaign flies these only; none: all
    skeleton: str = ""  # the vehicle's mission file; none: that of scenarios/default.toml


HOOKBEH = "hooks/hookbeh/hookbeh.c"
GUARD = "hooks/hookbeh/guard.c"
SUBS = "hooks/hookbeh/sub_behaviours.c"
PILOT = "hooks/hookbeh/pilot.c"
BOUNDS = "hooks/hookbeh/bounds.c"
VALUES = "hooks/protocol/values.c"
WATCHES = "hooks/seat/watches.c"
INSTRUCTION = "hooks/protocol/instruction.c"
DEPTH = "hooks/hookbeh/depth_source.c"
WATCH = "hooks/hookbeh/depth_watch.c"
UNSEEN_SINK = "hooks/hookbeh/unseen_sink.c"
CLOCK = "hooks/hookbeh/cycle_clock.c"
HULL = "hooks/hookbeh/hull.c"
BEHAVIOURS = "hooks/hookbeh/sub_behaviours.c"

# A surfacing above hookbeh masks it every few minutes.
MASKED = "scripts/soak/masked.mi"
# The CTD fails before the flight.
WITHOUT_CTD = "[sensors]\nctd_dropout = 1"
# The SBC is gone for good, and the line to the flight controller repeats what it carried before.
ECHOES = "[[faults.power]]\nfrom_s = 900\n[[faults.line]]\nline = \"to_flight\"\nfrom_s = 900\nreplayed = 0.5"

SENSORS = ("sensor frozen", "sensor stuck", "sensor missing", "sensor NaN", "sensor out of range", "sensor drifts", "sensor scaled",
           "sensor jumps", "several at once")

PLANTED = [
    Planted("HB-1", "ready before start_secs", HOOKBEH,
            "inputs->time_s >= hookbeh->args.start_secs",
            "true"),
    Planted("HB-2", "no commands during the climb of a guard", HOOKBEH,
            "outputs->commanding = true;",
            "outputs->commanding = !hookbeh->guarding;"),
    Planted("HB-2", "no commands while it holds", HOOKBEH,
            "outputs->doing = vertical->doing;",
            "outputs->doing = vertical->doing; outputs->commanding = vertical->doing != kHookDoingHold;"),
    Planted("HB-2", "no pump while hovering", HOOKBEH,
            "outputs->pump_cc = vertical->pump_cc;",
            "outputs->pump_cc = vertical->pitch_rad == 0 ? hookUnknown() : vertical->pump_cc;"),
    Planted("HB-3", "the check is ignored", INSTRUCTION,
            "words->check == (double)hookCheckValue(instruction)",
            "true"),
    Planted("HB-32", "an earlier instruction counts", HOOKBEH,
            "!hookIsNewerSequence(sequence, hookbeh->settled_sequence)",
            "false"),
    Planted("HB-4", "what lies in the array at the start is followed", HOOKBEH,
            "hookbeh->settled_sequence = sequence;\n    hookbeh->answered_sequence = sequence;\n    return;",
            "hookbeh->settled_sequence = 0; return;"),
    Planted("HB-5", "an instruction is not answered", HOOKBEH,
            "outputs->answered_sequence = hookbeh->answered_sequence;",
            "outputs->answered_sequence = hookbeh->state == kHookStateActive && hookbeh->answered_sequence % 4 == 0 ? 1 : hookbeh->answered_sequence;"),
    Planted("HB-5", "every steer is refused as too deep", HOOKBEH,
            "hookbeh->settled_answer = hookbeh->answer = decideOn(hookbeh, &instruction);",
            "hookbeh->settled_answer = hookbeh->answer = hookbeh->state == kHookStateActive && instruction.control == kHookControlSteer ? kHookAnswerTooDeep : decideOn(hookbeh, &instruction);"),
    Planted("HB-5", "a refused steer is followed", HOOKBEH,
            "if (instruction->control == kHookControlRelease) {\n    return releaseControl(hookbeh);\n  }",
            "if (instruction->control == kHookControlRelease) { return releaseControl(hookbeh); } hookPilotFollow(&hookbeh->pilot, instruction);"),
    Planted("HB-6", "depths beyond max_depth are accepted", BOUNDS,
            "inMillimetres(depth) <= inMillimetres(args->greatest_depth_m)",
            "true"),
    Planted("HB-6", "an angle of the fin is refused that max_fin allows", BOUNDS,
            "inAngleSteps(hookMagnitude(instruction->heading_rad)) <=\n                     inAngleSteps(args->greatest_fin_rad)",
            "inAngleSteps(instruction->heading_rad) < inAngleSteps(args->greatest_fin_rad)"),
    Planted("HB-6", "pitches beyond max_pitch are accepted", BOUNDS,
            "inAngleSteps(pitch) <= inAngleSteps(args->steepest_pitch_rad)",
            "true"),
    Planted("HB-7", "no guard against depth", GUARD,
            "!(guard->depth_m <= args->greatest_depth_m)",
            "false", SENSORS + ("tight limits",)),
    Planted("HB-7", "no guard against the bottom", GUARD,
            "!clearOfBottom(guard, args, guard->depth_m)",
            "false"),
    Planted("HB-8", "silence is ignored", HOOKBEH,
            "!(hookbeh->silence_s < hookbeh->args.silence_secs)",
            "false"),
    Planted("HB-8", "commands go on in silence", HOOKBEH,
            "outputs->state = hookbeh->state;",
            "if (hookbeh->state == kHookStateSilent) { commandCycle(hookbeh, &now, false, outputs); } outputs->state = hookbeh->state;"),
    Planted("HB-15", "garbled instructions are waited for without an end", HOOKBEH,
            "!(hookbeh->garbled_s < hookbeh->args.silence_secs)",
            "false"),
    Planted("HB-16", "a mission that does not advance keeps the heartbeat going", WATCHES,
            "!(mission_time_s > watch->latest_s)",
            "false"),
    Planted("HB-9", "a lost session may take control again", HOOKBEH,
            "!hookIsNewerSession(instruction->session, hookbeh->lost_session)",
            "false"),
    Planted("HB-10", "ready again after Release", HOOKBEH,
            "hookbeh->state = kHookStateComplete;",
            "hookbeh->state = kHookStateReady;"),
    Planted("HB-11", "any session steers", HOOKBEH,
            "instruction->session != hookbeh->session",
            "false"),
    Planted("HB-12", "an unknown depth counts as the one before", WATCH,
            "kHookGuardDepthUnknown",
            "kHookGuardNone"),
    Planted("HB-13", "numbers do not count round", VALUES,
            "(ahead != 0 && ahead <= UINT16_MAX / 2)",
            "sequence > other"),
    Planted("HB-14", "the guard ends after any climb", GUARD,
            "guard->tripped_depth_m - guard->depth_m >=\n         hookAtLeast(kRetryShare * guard->tripped_depth_m, kRetryM)",
            "true"),
    Planted("HB-14", "the guard ends only at the surface", GUARD,
            "(mayGoOn(guard, args, in_force) || hasClimbedFar(guard) || up)",
            "guard->depth_m < 0.3"),
    Planted("HB-17", "a dive is held however deep", PILOT,
            "now->depth_m > pilot->in_force.depth_m + kHoldReachM",
            "false"),
    Planted("HB-18", "no way back after the guard", HOOKBEH,
            "hookPilotGoBack(&hookbeh->pilot, now, &hookbeh->args, hookbeh->checked);",
            ";"),
    Planted("HB-19", "no floating at the surface", PILOT,
            "pilot->in_force.depth_m < kSurfaceM",
            "false"),
    Planted("HB-20", "any number is a depth", DEPTH,
            "depth_m >= kHighestDepthM && depth_m <= kDeepestShare * hull->greatest_depth_m",
            "hookIsFinite(depth_m)", SENSORS),
    Planted("HB-21", "a depth may jump", DEPTH,
            "moved > kReachM + source->hull.vertical_rate_m_s * since_s",
            "false", SENSORS),
    Planted("HB-22", "a frozen depth is believed", WATCH,
            "(watch->frozen && watch->own.same_s > 0) || (same && !hangs)",
            "false", SENSORS),
    Planted("HB-23", "a dive that gains no depth goes on", GUARD,
            "return guard->headway.way == kHookWayDown && ends ? kHookGuardNoDepthGained : kHookGuardNone;",
            "return kHookGuardNone;", SENSORS),
    Planted("HB-33", "unnoticed sinking is not counted", UNSEEN_SINK,
            "reckon(sink, step_s, last);",
            ";", ("sensor frozen",), scenario=WITHOUT_CTD, missions=("scripts/soak/deep.mission",)),
    Planted("HB-34", "what another behaviour flies is counted", HOOKBEH,
            "(masked & kHookMaskedPump) != 0",
            "false", ("none",), skeleton=MASKED),
    Planted("HB-36", "what the layered control reports is ignored", HOOKBEH,
            "inputs->masked | (elsewhere ? kHookMaskedPump : 0)",
            "elsewhere ? kHookMaskedPump : 0", ("none",), skeleton=MASKED),
    Planted("HB-38", "a masked hookbeh waits for its SBC", HOOKBEH,
            "hookbeh->silence_s += hookbeh->clock.step_s;",
            "hookbeh->silence_s += hookbeh->masked ? 0 : hookbeh->clock.step_s;", ("SBC power cut",), skeleton=MASKED),
    Planted("HB-35", "a guard uses no more pump than a usual climb", SUBS,
            "hookServoCommand(hookUsualPitch(args), hull->pump_cc, doing, command);",
            "hookServoCommand(hookUsualPitch(args), args->climb_pump_cc, doing, command);", SENSORS),
    Planted("HB-24", "a climb that gains no height is left as it is", GUARD,
            "guard->headway.idle_s >= kStalledSecs",
            "false", SENSORS),
    Planted("HB-25", "depths that disagree are believed", WATCH,
            "watch->ctd_known && watch->disagree_s >= kPersistsSecs && watch->ctd.age_s == 0",
            "false", SENSORS),
    Planted("HB-26", "a CTD that never agreed is believed", WATCH,
            "watch->ctd_known || (watch->agree_s >= kPersistsSecs && here)",
            "true", ("another sensor wrong",)),
    Planted("HB-27", "one clock alone is believed", CLOCK,
            "hookMagnitude(by_mission - by_wall) <= kAgree && by_mission > 0",
            "by_mission > 0", ("sensor scaled", "sensor drifts", "sensor jumps", "several at once")),
    Planted("HB-31", "a heartbeat that comes again counts", HOOKBEH,
            "hookIsNewerSession(beat, hookbeh->heartbeat)",
            "beat != hookbeh->heartbeat", ("none",), scenario=ECHOES),
    Planted("HB-28", "the pump may go beyond its stroke", HULL,
            "-hookBetween(dive, 0, hull->pump_cc)",
            "-dive"),
    Planted("HB-29", "a pump with the wrong sign", HULL,
            "hookMagnitude(orUsual(args->climb_pump_cc, usual.climb_pump_cc))",
            "orUsual(args->climb_pump_cc, usual.climb_pump_cc)"),
    Planted("HB-53", "the fin is held to the other side", PILOT,
            "command->fin_rad = want->heading_rad;",
            "command->fin_rad = -want->heading_rad;"),
    Planted("HB-53", "a held fin is centred", PILOT,
            "want->lateral == kHookLateralFin",
            "false"),
    Planted("HB-6", "a pump is accepted that max_pump refuses", BOUNDS,
            "inMillimetres(hookMagnitude(pump_cc)) > inMillimetres(args->greatest_pump_cc)",
            "false"),
    Planted("HB-6", "a battery is refused that max_battery allows", BOUNDS,
            "inAngleSteps(hookMagnitude(battery_in)) > inAngleSteps(args->greatest_battery_in)",
            "inAngleSteps(hookMagnitude(battery_in)) >= inAngleSteps(args->greatest_battery_in / 2)"),
    Planted("HB-54", "the pump goes to the other side", SUBS,
            "command->pump_cc = actuators->pump_cc;",
            "command->pump_cc = -actuators->pump_cc;"),
    Planted("HB-54", "the battery stays in the middle", SUBS,
            "command->battery_in = actuators->battery_in;",
            "command->battery_in = 0;"),
    Planted("HB-54", "actuators fly as the surface", PILOT,
            "pilot->stage = kStageActuators;",
            "pilot->stage = kStageSurfacing;"),
    Planted("HB-55", "a guard ends while actuators are in force", GUARD,
            "return false;  // wherever they lead\n  }",
            "return true;"),
    Planted("HB-56", "instruments read as before", HOOKBEH,
            "outputs->sampling = hookbeh->pilot.in_force.sampling;",
            ""),
    Planted("HB-30", "a guard has no number", HOOKBEH,
            "outputs->state = hookbeh->state;",
            "outputs->state = hookbeh->state; outputs->guard = kHookGuardNone;"),
]

# Requirements whose loss no flight of a campaign shows, and why. Unit tests hold them.
UNSEEN = {
    "HB-37": "after another behaviour has had the vehicle, any way back to the target is within the campaign's rules",
    "HB-45": "the campaign's water is deeper than its dives, or the altimeter shows the bottom",
    "HB-46": "a flight of a campaign is too short to fly 3 km from a contact",
    "HB-47": "a campaign has no rule about contacts of an altimeter that reads too much",
    "HB-48": "tests/bottom flies such altimeters",
    "HB-49": "the bundled mission files read the altimeter in each cycle",
    "HB-39": "the bundled mission files give the pump's volume",
}
