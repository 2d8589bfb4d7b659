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


HOOKBEH = "hooks/hookbeh/hookbeh.cpp"
GUARD = "hooks/hookbeh/guard.cpp"
PILOT = "hooks/hookbeh/pilot.cpp"
BOUNDS = "hooks/hookbeh/bounds.cpp"
VALUES = "hooks/protocol/values.cpp"
WATCHES = "hooks/hookprog/watches.cpp"

PLANTED = [
    Planted("HB-1", "ready before start_secs", HOOKBEH, "inputs.time_s >= args_.start_secs", "true"),
    Planted("HB-2", "no commands while the guard climbs", HOOKBEH, "outputs.commanding = true;", "outputs.commanding = !guarding_;"),
    Planted("HB-2", "no commands while it holds", HOOKBEH, "outputs.doing = vertical.doing;",
            "outputs.doing = vertical.doing; outputs.commanding = vertical.doing[2] != 'l';"),
    Planted("HB-2", "no pump while hovering", HOOKBEH, "outputs.pump_cc = vertical.pump_cc;",
            "outputs.pump_cc = vertical.pitch_rad == 0 ? __builtin_nan(\"\") : vertical.pump_cc;"),
    Planted("HB-3", "the check is ignored", HOOKBEH, "inputs.check == checkValue(*instruction)", "true"),
    Planted("HB-3", "an earlier instruction counts", HOOKBEH, "!isNewerSequence(sequence, settled_sequence_)", "false"),
    Planted("HB-4", "what lies in the array at the start is followed", HOOKBEH, "!settled_known_", "!(settled_known_ = true)"),
    Planted("HB-5", "an instruction is not answered", HOOKBEH, "outputs.answered_sequence = answered_sequence_;",
            "outputs.answered_sequence = state_ == HookState::Active && answered_sequence_ % 4 == 0 ? 1 : answered_sequence_;"),
    Planted("HB-5", "every steer is refused as too deep", HOOKBEH, "settled_answer_ = answer_ = decide(instruction);",
            "settled_answer_ = answer_ = state_ == HookState::Active && instruction.control == HookControl::Steer "
            "? HookAnswer::TooDeep : decide(instruction);"),
    Planted("HB-5", "a refused steer is followed", HOOKBEH,
            "if (instruction.control == HookControl::GiveBack) {\n    return giveBack();\n  }",
            "if (instruction.control == HookControl::GiveBack) { return giveBack(); } pilot_.follow(instruction);"),
    Planted("HB-6", "depths beyond max_depth are accepted", BOUNDS, "depth <= asFloat32(args.greatest_depth_m)", "true"),
    Planted("HB-6", "pitches beyond max_pitch are accepted", BOUNDS, "pitch <= asFloat32(args.steepest_pitch_rad)", "true"),
    Planted("HB-7", "no guard against depth", GUARD, "!(depth_m_ <= args.greatest_depth_m)", "false"),
    Planted("HB-7", "no guard against the bottom", GUARD, "!clearOfBottom(args, depth_m_, 0)", "false"),
    Planted("HB-8", "silence is ignored", HOOKBEH, "!(silence_s_ < args_.silence_secs)", "false"),
    Planted("HB-8", "commands go on in silence", HOOKBEH, "outputs.state = state_;",
            "if (state_ == HookState::Silent) { command(now, outputs); } outputs.state = state_;"),
    Planted("HB-15", "garbled instructions are waited for without an end", HOOKBEH, "!(garbled_s_ < args_.silence_secs)", "false"),
    Planted("HB-16", "a mission that stands still keeps the heart beating", WATCHES, "!(mission_time_s > latest_s_)", "false"),
    Planted("HB-9", "a lost session may take control again", HOOKBEH, "!isNewerSession(instruction.session, lost_session_)", "false"),
    Planted("HB-10", "ready again after GiveBack", HOOKBEH, "state_ = HookState::Complete;", "state_ = HookState::Ready;"),
    Planted("HB-11", "any session steers", HOOKBEH, "instruction.session != session_", "false"),
    Planted("HB-12", "an unknown depth counts as known", GUARD, "depth_known_ = isFinite(now.depth_m);", "depth_known_ = true;"),
    Planted("HB-13", "numbers do not count round", VALUES, "(ahead != 0 && ahead <= UINT16_MAX / 2)", "sequence > other"),
    Planted("HB-14", "the guard lets go after any climb", GUARD, "tripped_depth_m_ - depth_m_ >= (share > kRetryM ? share : kRetryM)", "true"),
    Planted("HB-14", "the guard lets go at the surface only", GUARD, "(mayGoOn(args, in_force) || hasClimbedFar())", "depth_m_ < 0.3"),
    Planted("HB-17", "a dive is held however deep", PILOT, "now.depth_m > in_force_.depth_m + kHoldReachM", "false"),
    Planted("HB-18", "no way back after the guard", HOOKBEH, "pilot_.goBack(now, args_);", ";"),
    Planted("HB-19", "no floating at the surface", PILOT, "in_force_.depth_m < kSurfaceM", "false"),
]

# What a campaign cannot see, with the reason.
UNSEEN = {}
