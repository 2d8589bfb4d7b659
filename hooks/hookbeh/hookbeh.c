// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/hookbeh.h"

#include "hooks/hookbeh/bounds.h"
#include "hooks/protocol/c_library.h"
#include "hooks/protocol/numbers.h"

/// 10 m of water are 1 bar: the vehicle's own conversion.
static const double kMetresPerBar = 10.0;
/// cc; commands to the pump that differ by less are the same.
static const double kPumpErrorCc = 30;

static void commandNothing(Hookbeh* hookbeh) {
  hookServoCommand(0, hookUnknown(), kHookDoingNothing, &hookbeh->last);
}

void hookbehInit(Hookbeh* hookbeh, const HookbehArgs* args, const HookHull* hull) {
  memset(hookbeh, 0, sizeof *hookbeh);
  hookbeh->hull = *hull;
  hookbehWithin(args, hull, &hookbeh->args);
  hookbeh->state = kHookStateWaiting;
  hookbehGuardInit(&hookbeh->guard, hull);
  hookPilotInit(&hookbeh->pilot);
  hookCycleClockInit(&hookbeh->clock);
  commandNothing(hookbeh);
}

void hookbehNoInputs(HookbehInputs* inputs) {
  memset(inputs, 0, sizeof *inputs);
  inputs->wall_time_s = inputs->cycle_number = inputs->ctd_bar = hookUnknown();
  inputs->commanded_pump_cc = hookUnknown();
}

/// What behaviours above hookbeh replaced in the previous cycle. While they control the pump, the
/// vehicle's motion is not the result of hookbeh's commands.
static uint8_t maskedIn(const Hookbeh* hookbeh, const HookbehInputs* inputs) {
  if (!hookIsFinite(hookbeh->last.pump_cc)) {
    return 0;  // it commanded nothing
  }
  const double off_cc = inputs->commanded_pump_cc - hookbeh->last.pump_cc;
  const bool elsewhere = off_cc > kPumpErrorCc || off_cc < -kPumpErrorCc;
  return (uint8_t)(inputs->masked | (elsewhere ? kHookMaskedPump : 0));
}

static void loseSession(Hookbeh* hookbeh) {
  if (hookbeh->state == kHookStateActive) {
    hookbeh->state = kHookStateSilent;
    hookbeh->lost_session = hookbeh->session;
    hookbeh->session = 0;
  }
}

static void watchHeartbeat(Hookbeh* hookbeh, double heartbeat) {
  uint32_t beat = 0;
  const bool there = hookIsWhole(hookMagnitude(heartbeat), 0, kHookMostSession, &beat);
  // While an SBC is in control only a newer heartbeat counts: a repeated earlier one must not keep
  // a dead session alive. Otherwise any heartbeat is the one to count from, whichever number
  // hookprog began with.
  const bool newer =
      there && (hookbeh->state != kHookStateActive || hookIsNewerSession(beat, hookbeh->heartbeat));
  // Of a sleeping SBC, hookprog knows only that it has ordered a nap: that counts for so long.
  const bool own = newer && heartbeat >= 0;
  const uint8_t kind = own ? 0 : (uint8_t)(1 + beat % 2);
  // Another nap: the SBC's own heartbeat in between is lost, but came after the one before this.
  const bool missed = newer && kind != 0 && hookbeh->beat_kind != 0 && kind != hookbeh->beat_kind;
  hookbeh->beat_kind = newer ? kind : hookbeh->beat_kind;
  hookbeh->heartbeat = newer ? beat : hookbeh->heartbeat;
  hookbeh->nap_s = missed ? hookbeh->silence_s : hookbeh->nap_s;
  hookbeh->nap_s = own ? 0 : hookbeh->nap_s + hookbeh->clock.step_s;
  if (own || (newer && hookbeh->nap_s < hookbeh->args.nap_secs)) {
    hookbeh->silence_s = 0;
  } else {
    hookbeh->silence_s += hookbeh->clock.step_s;
  }
  if (!(hookbeh->silence_s < hookbeh->args.silence_secs)) {
    loseSession(hookbeh);
  }
}

static HookAnswer takeControl(Hookbeh* hookbeh, const HookInstruction* instruction) {
  if (!hookIsNewerSession(instruction->session, hookbeh->lost_session)) {
    return kHookAnswerWrongSession;
  }
  const HookAnswer answer = hookbehCheckBounds(instruction, &hookbeh->args);
  if (answer == kHookAnswerAccepted) {
    hookbeh->state = kHookStateActive;
    hookbeh->session = instruction->session;
    hookbeh->silence_s = 0;
    hookbeh->nap_s = 0;
    hookbehGuardReset(&hookbeh->guard);
    hookPilotBegin(&hookbeh->pilot, instruction);
  }
  return answer;
}

static HookAnswer releaseControl(Hookbeh* hookbeh) {
  hookbeh->state = kHookStateComplete;
  hookbeh->session = 0;
  return kHookAnswerAccepted;
}

static HookAnswer decideOn(Hookbeh* hookbeh, const HookInstruction* instruction) {
  if (instruction->control != kHookControlTake && instruction->control != kHookControlSteer &&
      instruction->control != kHookControlRelease) {
    return kHookAnswerBadCommand;
  }
  if (hookbeh->state == kHookStateWaiting || hookbeh->state == kHookStateComplete) {
    return kHookAnswerNotReady;
  }
  if (hookbeh->state != kHookStateActive && instruction->control == kHookControlTake) {
    return takeControl(hookbeh, instruction);
  }
  if (instruction->session != hookbeh->session) {  // session 0 means no session: not an instruction
    return kHookAnswerWrongSession;
  }
  if (instruction->control == kHookControlRelease) {
    return releaseControl(hookbeh);
  }
  // A Take of the session in control means that the SBC has not seen the answer to it: treat it as
  // a Steer.
  const HookAnswer answer = hookbehCheckBounds(instruction, &hookbeh->args);
  if (answer == kHookAnswerAccepted) {
    hookPilotFollow(&hookbeh->pilot, instruction);
  }
  return answer;
}

static void readInstruction(Hookbeh* hookbeh, const HookbehInputs* inputs) {
  uint32_t whole = 0;
  const bool there = hookIsWhole(inputs->words.sequence, 1, UINT16_MAX, &whole);
  const uint16_t sequence = (uint16_t)whole;
  if (!hookbeh->settled_known) {
    // What an earlier mission left in the sensor array was never meant for this one. Its number is
    // reported, so that the SBC does not happen to begin with it.
    hookbeh->settled_known = true;
    hookbeh->settled_sequence = sequence;
    hookbeh->answered_sequence = sequence;
    return;
  }
  if (!there || sequence == hookbeh->settled_sequence) {
    hookbeh->garbled_s = 0;
    if (there) {
      hookbeh->answered_sequence = sequence;
      hookbeh->answer = hookbeh->settled_answer;
    }
    return;
  }
  hookbeh->answered_sequence = sequence;
  if (!hookIsNewerSequence(sequence, hookbeh->settled_sequence)) {
    // It was sent before the one that was decided on last.
    hookbeh->answer = kHookAnswerOldSequence;
    hookbeh->garbled_s += hookbeh->garbled_s > 0 ? hookbeh->clock.step_s : 0;
    return;
  }
  HookInstruction instruction;
  if (!hookInstructionOf(&inputs->words, &instruction)) {
    hookbeh->answer = kHookAnswerBadCheck;  // not settled: the missing part may still come
    hookbeh->garbled_s += hookbeh->clock.step_s;
    if (!(hookbeh->garbled_s < hookbeh->args.silence_secs)) {
      loseSession(hookbeh);  // the SBC is alive, but its instructions do not arrive intact
    }
    return;
  }
  hookbeh->garbled_s = 0;
  hookbeh->settled_sequence = sequence;
  hookbeh->settled_answer = hookbeh->answer = decideOn(hookbeh, &instruction);
}

/// `masked`: pitch or pump were not its own in the previous cycle. Then the times for which it
/// flies a command do not advance, and afterwards it goes back to a depth that it had reached.
static void commandVertical(Hookbeh* hookbeh, const HookSurroundings* now, HookGuard guard,
                            bool masked, HookVerticalCommand* command) {
  const bool shows =
      hookbehGuardMustShowDepth(&hookbeh->guard, &hookbeh->args, &hookbeh->pilot.in_force);
  const bool climbs = guard != kHookGuardNone || shows;
  if ((hookbeh->guarding || hookbeh->masked) && !climbs && !masked) {
    hookPilotGoBack(&hookbeh->pilot, now, &hookbeh->args, hookbeh->checked);
  }
  // A climb that began for a guard does more than to check the depth.
  hookbeh->checked = shows && guard == kHookGuardNone && (hookbeh->checked || !hookbeh->guarding);
  hookbeh->guarding = climbs;
  hookbeh->masked = masked;
  hookPilotVertical(&hookbeh->pilot, now, masked ? 0 : hookbeh->clock.step_s, &hookbeh->args,
                    command);
  if (climbs) {
    hookClimbNow(guard != kHookGuardNone ? hookClimbFor(guard) : kHookDoingCheckDepth,
                 &hookbeh->args, &hookbeh->hull, command);
  }
}

static void commandCycle(Hookbeh* hookbeh, const HookSurroundings* now, bool masked,
                         HookbehOutputs* outputs) {
  outputs->guard = hookbehGuardMustClimb(&hookbeh->guard, &hookbeh->args, &hookbeh->pilot.in_force);
  HookVerticalCommand* vertical = &hookbeh->last;
  commandVertical(hookbeh, now, outputs->guard, masked, vertical);
  HookLateralCommand lateral;
  hookPilotLateral(&hookbeh->pilot, now, &lateral);
  outputs->commanding = true;
  outputs->sampling = hookbeh->pilot.in_force.sampling;
  outputs->altimeter = !(hookbeh->args.least_altitude_m < 0);
  outputs->heading_mode = lateral.mode;
  outputs->heading_rad = lateral.heading_rad;
  outputs->latitude_ddmm = lateral.latitude_ddmm;
  outputs->longitude_ddmm = lateral.longitude_ddmm;
  outputs->fin_rad = lateral.fin_rad;
  const bool servo = vertical->pitch_mode == kHookPitchModeServo;
  outputs->pitch_mode = vertical->pitch_mode;
  outputs->pitch_rad = servo ? vertical->pitch_rad : 0;
  outputs->battery_in = vertical->battery_in;
  outputs->pump_cc = vertical->pump_cc;
  outputs->doing = vertical->doing;
}

void hookbehCycle(Hookbeh* hookbeh, const HookbehInputs* inputs, HookbehOutputs* outputs) {
  HookSurroundings now = {inputs->depth_m,       inputs->depth_rate_mps,
                          inputs->altitude_m,    inputs->ctd_bar * kMetresPerBar,
                          inputs->latitude_ddmm, inputs->longitude_ddmm};
  if (!hookbeh->settled_known) {
    // What an earlier mission left there.
    hookEchoFloorIgnore(&hookbeh->guard.bottom.echoes, inputs->altitude_m);
  }
  hookCycleClockAdvance(&hookbeh->clock, inputs->time_s, inputs->wall_time_s, inputs->cycle_number);
  const uint8_t masked = maskedIn(hookbeh, inputs);
  if ((masked & kHookMaskedPump) != 0) {
    hookbeh->last.pump_cc = hookUnknown();
  }
  const bool drives = hookIsFinite(hookbeh->last.pump_cc) && !hookbeh->guarding;
  const HookWay way =
      drives ? hookPilotWay(&hookbeh->pilot, hookDepthWatchDepth(&hookbeh->guard.watch))
             : kHookWayNone;
  hookbehGuardObserve(&hookbeh->guard, &hookbeh->args, &now, hookbeh->clock.step_s, &hookbeh->last,
                      way);
  now.depth_m = hookDepthWatchDepth(&hookbeh->guard.watch);
  // One false reading must not make it ready before its time.
  const bool time_is_sure = hookbeh->clock.follows || !(hookbeh->args.start_secs > 0);
  if (hookbeh->state == kHookStateWaiting && time_is_sure &&
      inputs->time_s >= hookbeh->args.start_secs) {
    hookbeh->state = kHookStateReady;
  }
  watchHeartbeat(hookbeh, inputs->heartbeat);
  readInstruction(hookbeh, inputs);

  memset(outputs, 0, sizeof *outputs);
  commandNothing(hookbeh);
  if (hookbeh->state == kHookStateActive) {
    commandCycle(hookbeh, &now, (masked & (kHookMaskedPitch | kHookMaskedPump)) != 0, outputs);
  }
  outputs->state = hookbeh->state;
  outputs->answered_sequence = hookbeh->answered_sequence;
  outputs->answer = hookbeh->answer;
  outputs->session = hookbeh->session;
  outputs->nap_secs = hookbeh->args.nap_secs;
  outputs->masked = outputs->commanding ? masked : 0;
}
