// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/hookbeh.h"

#include "hooks/hookbeh/bounds.h"
#include "hooks/protocol/messages.h"
#include "hooks/protocol/numbers.h"

namespace glider::hooks {
namespace {

/// 10 m of water are 1 bar: the vehicle's own conversion.
constexpr double kMetresPerBar = 10.0;
/// cc; commands to the pump that differ by less are the same.
constexpr double kPumpErrorCc = 30;

}  // namespace

Hookbeh::Hookbeh(const HookbehArgs& args, const Hull& hull)
    : hull_(hull), args_(within(args, hull)), guard_(hull) {}

HookbehOutputs Hookbeh::cycle(const HookbehInputs& inputs) {
  Surroundings now{inputs.depth_m,       inputs.depth_rate_mps,
                   inputs.altitude_m,    inputs.ctd_bar * kMetresPerBar,
                   inputs.latitude_ddmm, inputs.longitude_ddmm};
  if (!settled_known_) {
    guard_.ignore(inputs.altitude_m);  // what an earlier mission left there
  }
  clock_.advance(inputs.time_s, inputs.wall_time_s, inputs.cycle_number);
  const uint8_t masked = maskedIn(inputs);
  if ((masked & kMaskedPump) != 0) {
    last_.pump_cc = __builtin_nan("");
  }
  const bool drives = isFinite(last_.pump_cc) && !guarding_;
  const Way way = drives ? pilot_.way(guard_.depth()) : Way::None;
  guard_.observe(args_, now, clock_.step(), last_, way);
  now.depth_m = guard_.depth();
  // One false reading must not make it ready before its time.
  const bool time_is_sure = clock_.follows() || !(args_.start_secs > 0);
  if (state_ == HookState::Waiting && time_is_sure && inputs.time_s >= args_.start_secs) {
    state_ = HookState::Ready;
  }
  watchHeartbeat(inputs.heartbeat);
  readInstruction(inputs);

  HookbehOutputs outputs;
  last_ = {0, __builtin_nan("")};
  if (state_ == HookState::Active) {
    command(now, (masked & (kMaskedPitch | kMaskedPump)) != 0, outputs);
  }
  outputs.state = state_;
  outputs.answered_sequence = answered_sequence_;
  outputs.answer = answer_;
  outputs.session = session_;
  outputs.masked = outputs.commanding ? masked : 0;
  return outputs;
}

void Hookbeh::watchHeartbeat(double heartbeat) {
  uint32_t beat = 0;
  const bool there = isWhole(heartbeat, 0, kMostSession, &beat);
  // While an SBC is in control only a newer heartbeat counts: a repeated earlier one must not keep
  // a dead session alive. Otherwise any heartbeat is the one to count from, whichever number
  // hookprog began with.
  if (there && (state_ != HookState::Active || isNewerSession(beat, heartbeat_))) {
    heartbeat_ = beat;
    silence_s_ = 0;
  } else {
    silence_s_ += clock_.step();
  }
  if (!(silence_s_ < args_.silence_secs)) {
    loseSession();
  }
}

void Hookbeh::loseSession() {
  if (state_ == HookState::Active) {
    state_ = HookState::Silent;
    lost_session_ = session_;
    session_ = 0;
  }
}

void Hookbeh::readInstruction(const HookbehInputs& inputs) {
  uint32_t whole = 0;
  const bool there = isWhole(inputs.sequence, 1, UINT16_MAX, &whole);
  const auto sequence = static_cast<uint16_t>(whole);
  if (!settled_known_) {
    // What an earlier mission left in the sensor array was never meant for this one. Its number is
    // reported, so that the SBC does not happen to begin with it.
    settled_known_ = true;
    settled_sequence_ = sequence;
    answered_sequence_ = sequence;
    return;
  }
  if (!there || sequence == settled_sequence_) {
    garbled_s_ = 0;
    if (there) {
      answered_sequence_ = sequence;
      answer_ = settled_answer_;
    }
    return;
  }
  answered_sequence_ = sequence;
  if (!isNewerSequence(sequence, settled_sequence_)) {
    answer_ = HookAnswer::OldSequence;  // it was sent before the one that was decided on last
    garbled_s_ += garbled_s_ > 0 ? clock_.step() : 0;
    return;
  }
  Instruction instruction;
  if (!instructionOf(inputs, &instruction)) {
    answer_ = HookAnswer::BadCheck;  // not settled: the missing part may still come
    garbled_s_ += clock_.step();
    if (!(garbled_s_ < args_.silence_secs)) {
      loseSession();  // the SBC is alive, but its instructions do not arrive intact
    }
    return;
  }
  garbled_s_ = 0;
  settled_sequence_ = sequence;
  settled_answer_ = answer_ = decide(instruction);
}

HookAnswer Hookbeh::decide(const Instruction& instruction) {
  if (instruction.control != HookControl::Take && instruction.control != HookControl::Steer &&
      instruction.control != HookControl::Release) {
    return HookAnswer::BadCommand;
  }
  if (state_ == HookState::Waiting || state_ == HookState::Complete) {
    return HookAnswer::NotReady;
  }
  if (state_ != HookState::Active && instruction.control == HookControl::Take) {
    return take(instruction);
  }
  if (instruction.session != session_) {  // session 0 means no session: not an instruction
    return HookAnswer::WrongSession;
  }
  if (instruction.control == HookControl::Release) {
    return release();
  }
  // A Take of the session in control means that the SBC has not seen the answer to it: treat it as
  // a Steer.
  const HookAnswer answer = checkBounds(instruction, args_);
  if (answer == HookAnswer::Accepted) {
    pilot_.follow(instruction);
  }
  return answer;
}

HookAnswer Hookbeh::take(const Instruction& instruction) {
  if (!isNewerSession(instruction.session, lost_session_)) {
    return HookAnswer::WrongSession;
  }
  const HookAnswer answer = checkBounds(instruction, args_);
  if (answer == HookAnswer::Accepted) {
    state_ = HookState::Active;
    session_ = instruction.session;
    silence_s_ = 0;
    guard_.reset();
    pilot_.begin(instruction);
  }
  return answer;
}

HookAnswer Hookbeh::release() {
  state_ = HookState::Complete;
  session_ = 0;
  return HookAnswer::Accepted;
}

/// What behaviours above hookbeh replaced in the previous cycle. While they control the pump, the
/// vehicle's motion is not the result of hookbeh's commands.
uint8_t Hookbeh::maskedIn(const HookbehInputs& inputs) const {
  if (!isFinite(last_.pump_cc)) {
    return 0;  // it commanded nothing
  }
  const double off_cc = inputs.commanded_pump_cc - last_.pump_cc;
  const bool elsewhere = off_cc > kPumpErrorCc || off_cc < -kPumpErrorCc;
  return inputs.masked | (elsewhere ? kMaskedPump : 0);
}

/// `masked`: pitch or pump were not its own in the previous cycle. Then the times for which it
/// flies a command do not advance, and afterwards it goes back to a depth that it had reached.
VerticalCommand Hookbeh::vertical(const Surroundings& now, HookGuard guard, bool masked) {
  const bool shows = guard_.mustShowDepth(args_, pilot_.inForce());
  const bool climbs = guard != HookGuard::None || shows;
  if ((guarding_ || masked_) && !climbs && !masked) {
    pilot_.goBack(now, args_, checked_);
  }
  checked_ = shows;
  guarding_ = climbs;
  masked_ = masked;
  const VerticalCommand wanted = pilot_.vertical(now, masked ? 0 : clock_.step(), args_);
  return !climbs ? wanted
                 : climbNow(guard != HookGuard::None ? climbFor(guard) : Doing::CheckDepth, args_,
                            hull_);
}

void Hookbeh::command(const Surroundings& now, bool masked, HookbehOutputs& outputs) {
  outputs.guard = guard_.mustClimb(args_, pilot_.inForce());
  const VerticalCommand vertical = this->vertical(now, outputs.guard, masked);
  const LateralCommand lateral = pilot_.lateral(now);
  outputs.commanding = true;
  outputs.altimeter = !(args_.least_altitude_m < 0);
  outputs.heading_mode = lateral.mode;
  outputs.heading_rad = lateral.heading_rad;
  outputs.latitude_ddmm = lateral.latitude_ddmm;
  outputs.longitude_ddmm = lateral.longitude_ddmm;
  outputs.fin_rad = lateral.fin_rad;
  const bool servo = vertical.pitch_mode == PitchMode::Servo;
  outputs.pitch_mode = vertical.pitch_mode;
  outputs.pitch_rad = servo ? vertical.pitch_rad : 0;
  outputs.battery_in = vertical.battery_in;
  outputs.pump_cc = vertical.pump_cc;
  outputs.doing = vertical.doing;
  last_ = vertical;
}

}  // namespace glider::hooks
