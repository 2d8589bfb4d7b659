// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/imc/plan.h"

#include "hooks/imc/values.h"

namespace glider::runtime::imc {
namespace {

using namespace hooks::imc;

/// Of the plan and of its one manoeuvre.
const Text kPlan = textOf("glidercc");
const Text kManeuver = textOf("follow");

}  // namespace

void Plan::take(const Packet& packet) {
  // What it has reported of a time-out meanwhile was not received.
  constexpr double kSpread = 2;
  timed_out_ =
      timed_out_ || (now_s_ > 0 && packet.header.time_s - now_s_ >= mission_.timeout_s - kSpread);
  now_s_ = packet.header.time_s;
  asked_s_ = asked_s_ > now_s_ ? -kStartSecs : asked_s_;  // its clock was set back
  if (packet.id == PlanControlState::kId) {
    PlanControlState said;
    if (decode(packet, said)) {
      takeState(said);
    }
  } else if (packet.id == FollowRefState::kId) {
    FollowRefState said;
    if (decode(packet, said)) {
      takeFollowing(said);
    }
  }
}

/// READY is said three times a second also in the moment between a request and its execution, so
/// only the end of a plan that has run is one.
void Plan::takeState(const PlanControlState& said) {
  const bool runs = said.state == PlanState::Executing || said.state == PlanState::Initializing;
  if (runs && !(said.plan_id == kPlan)) {
    ours_runs_ = false;
    state_ = State::Taken;
    return;
  }
  if (runs) {
    ours_runs_ = true;
    return;
  }
  const bool blocked = said.state == PlanState::Blocked;
  const bool idle = state_ == State::Away || (state_ == State::Taken && !flew_);
  if (blocked && (ours_runs_ || state_ == State::Lost)) {
    takeAway();
  } else if (ours_runs_) {
    endOfPlan();
  } else if (idle && said.state == PlanState::Ready) {
    state_ = State::Ready;
  } else if (blocked && state_ == State::Ready) {
    state_ = State::Away;
  }
}

/// An operator has aborted what flies, or blocks what is to fly.
void Plan::takeAway() {
  ours_runs_ = false;
  timed_out_ = false;
  flew_ = true;
  state_ = State::Taken;
}

/// Ours has ended without our having asked for it: for want of References, or by somebody.
void Plan::endOfPlan() {
  ours_runs_ = false;
  state_ = over_ ? State::Away : timed_out_ ? State::Lost : State::Taken;
  timed_out_ = false;
}

void Plan::takeFollowing(const FollowRefState& said) {
  if (said.control_src != kOwnAddress && said.control_src != kAllSystems) {
    return;
  }
  heard_s_ = now_s_;
  if (said.state == FollowState::Timeout) {
    timed_out_ = true;
  } else if (ours_runs_) {
    state_ = State::Following;
    flew_ = true;
    timed_out_ = false;
  }
}

bool Plan::asksForStart(double now_s, double depth_m) {
  if (ours_runs_) {
    return false;  // it has begun, and the vehicle does not say yet that it follows
  }
  const bool begins = state_ == State::Ready && depth_m <= mission_.start_depth_m;
  const bool again = wasLost();
  if (over_ || !(begins || again) || now_s - asked_s_ < kStartSecs) {
    return false;
  }
  asked_s_ = now_s;
  heard_s_ = __builtin_nan("");
  sent_s_ = __builtin_nan("");
  return true;
}

bool Plan::isInDoubt(double now_s) const {
  return follows() && sent_s_ == sent_s_ && heard_s_ == heard_s_ && now_s - heard_s_ > kDoubtSecs;
}

PlanControl Plan::request(uint8_t operation) {
  PlanControl request;
  request.type = PlanControlType::Request;
  request.op = operation;
  request.request_id = ++request_;
  request.plan_id = kPlan;
  return request;
}

PlanControl Plan::start() {
  PlanControl request = this->request(PlanOperation::Start);
  request.arg.present = true;
  PlanSpecification& plan = request.arg.value;
  plan.plan_id = kPlan;
  plan.start_man_id = kManeuver;
  plan.maneuvers.present = true;
  PlanManeuver& maneuver = plan.maneuvers.value;
  maneuver.maneuver_id = kManeuver;
  maneuver.data.present = true;
  FollowReference& follow = maneuver.data.value;
  follow.control_src = kOwnAddress;
  follow.control_ent = kAnyEntity;
  follow.timeout = static_cast<float>(mission_.timeout_s);
  follow.loiter_radius = static_cast<float>(mission_.loiter_m);
  follow.altitude_interval = 0;
  return request;
}

PlanControl Plan::stop() {
  return request(PlanOperation::Stop);
}

}  // namespace glider::runtime::imc
