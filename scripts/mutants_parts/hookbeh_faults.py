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


HOOKBEH = "hooks/hookbeh/hookbeh.cpp"
GUARD = "hooks/hookbeh/guard.cpp"
SUBS = "hooks/hookbeh/sub_behaviours.cpp"
PILOT = "hooks/hookbeh/pilot.cpp"
BOUNDS = "hooks/hookbeh/bounds.cpp"
VALUES = "hooks/protocol/values.c"
WATCHES = "hooks/seat/watches.c"
INSTRUCTION = "hooks/protocol/instruction.c"
DEPTH = "hooks/hookbeh/depth_source.cpp"
WATCH = "hooks/hookbeh/depth_watch.cpp"
UNSEEN_SINK = "hooks/hookbeh/unseen_sink.cpp"
CLOCK = "hooks/hookbeh/cycle_clock.cpp"
HULL = "hooks/hookbeh/hull.cpp"
BEHAVIOURS = "hooks/hookbeh/sub_behaviours.cpp"

# A surfacing above hookbeh masks it every few minutes.
MASKED = "scripts/soak/masked.mi"
# The CTD fails before the flight.
WITHOUT_CTD = "[sensors]\nctd_dropout = 1"
# The SBC is gone for good, and the line to the flight controller repeats what it carried before.
ECHOES = "[[faults.power]]\nfrom_s = 900\n[[faults.line]]\nline = \"to_flight\"\nfrom_s = 900\nreplayed = 0.5"

SENSORS = ("sensor frozen", "sensor stuck", "sensor missing", "sensor NaN", "sensor out of range", "sensor drifts", "sensor scaled",
           "sensor jumps", "several at once")

PLANTED = [
    Planted("HB-1", "ready before start_secs", HOOKBEH, "inputs.time_s >= args_.start_secs", "true"),
    Planted("HB-2", "no commands during the climb of a guard", HOOKBEH, "outputs.commanding = true;", "outputs.commanding = !guarding_;"),
    Planted("HB-2", "no commands while it holds", HOOKBEH, "outputs.doing = vertical.doing;",
            "outputs.doing = vertical.doing; outputs.commanding = vertical.doing != Doing::Hold;"),
    Planted("HB-2", "no pump while hovering", HOOKBEH, "outputs.pump_cc = vertical.pump_cc;",
            "outputs.pump_cc = vertical.pitch_rad == 0 ? __builtin_nan(\"\") : vertical.pump_cc;"),
    Planted("HB-3", "the check is ignored", INSTRUCTION, "words->check == (double)hookCheckValue(instruction)", "true"),
    Planted("HB-32", "an earlier instruction counts", HOOKBEH, "!isNewerSequence(sequence, settled_sequence_)", "false"),
    Planted("HB-4", "what lies in the array at the start is followed", HOOKBEH, "!settled_known_", "!(settled_known_ = true)"),
    Planted("HB-5", "an instruction is not answered", HOOKBEH, "outputs.answered_sequence = answered_sequence_;",
            "outputs.answered_sequence = state_ == HookState::Active && answered_sequence_ % 4 == 0 ? 1 : answered_sequence_;"),
    Planted("HB-5", "every steer is refused as too deep", HOOKBEH, "settled_answer_ = answer_ = decide(instruction);",
            "settled_answer_ = answer_ = state_ == HookState::Active && instruction.control == HookControl::Steer "
            "? HookAnswer::TooDeep : decide(instruction);"),
    Planted("HB-5", "a refused steer is followed", HOOKBEH,
            "if (instruction.control == HookControl::Release) {\n    return release();\n  }",
            "if (instruction.control == HookControl::Release) { return release(); } pilot_.follow(instruction);"),
    Planted("HB-6", "depths beyond max_depth are accepted", BOUNDS, "depth <= asFloat32(args.greatest_depth_m)", "true"),
    Planted("HB-6", "an angle of the fin is refused that max_fin allows", BOUNDS, "magnitude(instruction.heading_rad) <= asFloat32(args.greatest_fin_rad)",
            "instruction.heading_rad < asFloat32(args.greatest_fin_rad)"),
    Planted("HB-6", "pitches beyond max_pitch are accepted", BOUNDS, "pitch <= asFloat32(args.steepest_pitch_rad)", "true"),
    Planted("HB-7", "no guard against depth", GUARD, "!(depth_m_ <= args.greatest_depth_m)", "false", SENSORS + ("tight limits",)),
    Planted("HB-7", "no guard against the bottom", GUARD, "!clearOfBottom(args, depth_m_)", "false"),
    Planted("HB-8", "silence is ignored", HOOKBEH, "!(silence_s_ < args_.silence_secs)", "false"),
    Planted("HB-8", "commands go on in silence", HOOKBEH, "outputs.state = state_;",
            "if (state_ == HookState::Silent) { command(now, outputs); } outputs.state = state_;"),
    Planted("HB-15", "garbled instructions are waited for without an end", HOOKBEH, "!(garbled_s_ < args_.silence_secs)", "false"),
    Planted("HB-16", "a mission that does not advance keeps the heartbeat going", WATCHES, "!(mission_time_s > watch->latest_s)", "false"),
    Planted("HB-9", "a lost session may take control again", HOOKBEH, "!isNewerSession(instruction.session, lost_session_)", "false"),
    Planted("HB-10", "ready again after Release", HOOKBEH, "state_ = HookState::Complete;", "state_ = HookState::Ready;"),
    Planted("HB-11", "any session steers", HOOKBEH, "instruction.session != session_", "false"),
    Planted("HB-12", "an unknown depth counts as the one before", WATCH, "HookGuard::DepthUnknown", "HookGuard::None"),
    Planted("HB-13", "numbers do not count round", VALUES, "(ahead != 0 && ahead <= UINT16_MAX / 2)", "sequence > other"),
    Planted("HB-14", "the guard ends after any climb", GUARD, "tripped_depth_m_ - depth_m_ >= atLeast(kRetryShare * tripped_depth_m_, kRetryM)", "true"),
    Planted("HB-14", "the guard ends only at the surface", GUARD, "(mayGoOn(args, in_force) || hasClimbedFar())", "depth_m_ < 0.3"),
    Planted("HB-17", "a dive is held however deep", PILOT, "now.depth_m > in_force_.depth_m + kHoldReachM", "false"),
    Planted("HB-18", "no way back after the guard", HOOKBEH, "pilot_.goBack(now, args_);", ";"),
    Planted("HB-19", "no floating at the surface", PILOT, "in_force_.depth_m < kSurfaceM", "false"),
    Planted("HB-20", "any number is a depth", DEPTH,
            "depth_m >= kHighestDepthM && depth_m <= kDeepestShare * hull.greatest_depth_m", "isFinite(depth_m)", SENSORS),
    Planted("HB-21", "a depth may jump", DEPTH, "moved > kReachM + hull_.vertical_rate_m_s * age_s_", "false", SENSORS),
    Planted("HB-22", "a frozen depth is believed", WATCH, "(frozen_ && own_.sameFor() > 0) || (same && !hangs)", "false", SENSORS),
    Planted("HB-23", "a dive that gains no depth goes on", GUARD, "return headway_.way() == Way::Down && ends ? HookGuard::NoDepthGained : HookGuard::None;",
            "return HookGuard::None;", SENSORS),
    Planted("HB-33", "unnoticed sinking is not counted", UNSEEN_SINK, "reckon(step_s, last);", ";", ("sensor frozen",), WITHOUT_CTD,
            ("scripts/soak/deep.mission",)),
    Planted("HB-34", "what another behaviour flies is counted", HOOKBEH,
            "(masked & kMaskedPump) != 0", "false", ("none",), skeleton=MASKED),
    Planted("HB-36", "what the layered control reports is ignored", HOOKBEH, "inputs.masked | (elsewhere ? kMaskedPump : 0)",
            "elsewhere ? kMaskedPump : 0", ("none",), skeleton=MASKED),
    Planted("HB-38", "a masked hookbeh waits for its SBC", HOOKBEH, "silence_s_ += clock_.step();",
            "silence_s_ += masked_ ? 0 : clock_.step();", ("SBC power cut",), skeleton=MASKED),
    Planted("HB-35", "a guard uses no more pump than a usual climb", BEHAVIOURS,
            "return {usualPitch(args), hull.pump_cc, doing};", "return {usualPitch(args), args.climb_pump_cc, doing};", SENSORS),
    Planted("HB-24", "a climb that gains no height is left as it is", GUARD, "headway_.idleFor() >= kStalledSecs", "false", SENSORS),
    Planted("HB-25", "depths that disagree are believed", WATCH, "ctd_known_ && disagree_s_ >= kPersistsSecs && ctd_.age() == 0", "false", SENSORS),
    Planted("HB-26", "a CTD that never agreed is believed", WATCH, "ctd_known_ || agree_s_ >= kPersistsSecs", "true", ("another sensor wrong",)),
    Planted("HB-27", "one clock alone is believed", CLOCK, "magnitude(by_mission - by_wall) <= kAgree && by_mission > 0", "by_mission > 0", ("sensor scaled", "sensor drifts", "sensor jumps", "several at once")),
    Planted("HB-31", "a heartbeat that comes again counts", HOOKBEH, "isNewerSession(beat, heartbeat_)", "beat != heartbeat_", ("none",), ECHOES),
    Planted("HB-28", "the pump may go beyond its stroke", HULL, "-between(dive, 0, hull.pump_cc)", "-dive"),
    Planted("HB-29", "a pump with the wrong sign", HULL, "magnitude(orUsual(args.climb_pump_cc, usual.climb_pump_cc))",
            "orUsual(args.climb_pump_cc, usual.climb_pump_cc)"),
    Planted("HB-53", "the fin is held to the other side", PILOT, "in_force_.heading_rad};", "-in_force_.heading_rad};"),
    Planted("HB-53", "a held fin is centred", PILOT, "in_force_.lateral == HookLateral::Fin", "false"),
    Planted("HB-6", "a pump is accepted that max_pump refuses", BOUNDS, "!(magnitude(pump_cc) <= asFloat32(args.greatest_pump_cc))", "false"),
    Planted("HB-6", "a battery is refused that max_battery allows", BOUNDS, "magnitude(battery_in) <= asFloat32(args.greatest_battery_in)",
            "magnitude(battery_in) < asFloat32(args.greatest_battery_in) / 2"),
    Planted("HB-54", "the pump goes to the other side", SUBS, "pump_cc, Doing::Actuators", "-pump_cc, Doing::Actuators"),
    Planted("HB-54", "the battery stays in the middle", SUBS, "PitchMode::Battery, battery_in}", "PitchMode::Battery, 0}"),
    Planted("HB-54", "actuators fly as the surface", PILOT, "actuators_ = {want.depth_m, want.pitch_rad};\n      stage_ = Stage::Actuators;",
            "stage_ = Stage::Surfacing;"),
    Planted("HB-55", "a guard ends while actuators are in force", GUARD, "return false;  // wherever they lead", "return true;"),
    Planted("HB-30", "a guard has no number", HOOKBEH, "outputs.state = state_;",
            "outputs.state = state_; outputs.guard = HookGuard::None;"),
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
