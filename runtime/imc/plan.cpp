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

/// A packet may be a little older than the one before, or have no time.
void Plan::takeTime(double time_s) {
  if (time_s <= 0) {
    return;
  }
  // What it has reported of a time-out meanwhile was not received.
  constexpr double kSpread = 2;
  timed_out_ = timed_out_ || time_s - now_s_ >= mission_.timeout_s - kSpread;
  now_s_ = time_s;
  asked_s_ = asked_s_ - now_s_ > kSetBackSecs ? -kStartSecs : asked_s_;
}

void Plan::take(const Packet& packet) {
  takeTime(packet.header.time_s);
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
  } else if (packet.id == PlanControl::kId) {
    PlanControl said;
    if (decode(packet, said)) {
      takeReply(packet.header.destination, said);
    }
  }
}

/// Any reply shows that it has read our request. It also repeats the request itself, under our
/// address: that is not a reply. Others number their requests too.
void Plan::takeReply(uint16_t to, const PlanControl& said) {
  if (said.type == PlanControlType::Request || said.request_id != request_ ||
      (to != kOwnAddress && to != kAllSystems)) {
    return;
  }
  unreplied_s_ = __builtin_nan("");
  if (said.type == PlanControlType::Failure) {
    failed_ = true;
    failed_operation_ = said.op;
  }
}

Plan::Failure Plan::takeFailure() {
  if (!failed_) {
    return Failure::None;
  }
  failed_ = false;
  if (failed_operation_ == PlanOperation::Stop) {
    return ours_runs_ ? Failure::End : Failure::None;
  }
  return ran_ ? Failure::Flight : Failure::Start;
}

/// READY is said three times a second also in the moment between a request and its execution, so
/// only the end of a plan that has run is one.
void Plan::takeState(const PlanControlState& said) {
  reported_s_ = now_s_;
  const bool runs = said.state == PlanState::Executing || said.state == PlanState::Initializing;
  if (runs && !(said.plan_id == kPlan)) {
    ours_runs_ = false;
    state_ = State::Taken;
    return;
  }
  if (runs) {
    ours_runs_ = ran_ = true;
    unreplied_s_ = __builtin_nan("");
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
  if (said.state == FollowState::Timeout) {
    timed_out_ = true;
    deaf_ = deaf_ || now_s_ - sent_[newest_].at_s < kDoubtSecs;
  } else if (ours_runs_) {
    state_ = State::Following;
    flew_ = true;
    timed_out_ = false;
  }
  if (said.reference.present) {
    takeEcho(said.reference.value);
  }
}

/// The vehicle follows a Reference of ours: the next ones are waited for. One that was sent long
/// ago answers only itself.
void Plan::takeEcho(const Reference& said) {
  for (uint32_t back = 0; back < kRemembered; ++back) {
    const Sent& sent = sent_[(newest_ + kRemembered - back) % kRemembered];
    if (sent.at_s == sent.at_s && sent.latitude == said.lat && sent.longitude == said.lon &&
        sent.depth == said.z.value.value && sent.speed == said.speed.value.value) {
      const double next_s = back == 0
                                ? __builtin_nan("")
                                : sent_[(newest_ + 1 + kRemembered - back) % kRemembered].at_s;
      unanswered_s_ = unanswered_s_ > next_s ? unanswered_s_ : next_s;
      doubt_s_ = back == 0 ? kDoubtSecs : doubt_s_;
      return;
    }
  }
}

void Plan::noteReference(const Reference& reference, double now_s) {
  newest_ = (newest_ + 1) % kRemembered;
  sent_[newest_] = {.at_s = now_s,
                    .latitude = reference.lat,
                    .longitude = reference.lon,
                    .speed = reference.speed.value.value,
                    .depth = reference.z.value.value};
  unanswered_s_ = unanswered_s_ == unanswered_s_ ? unanswered_s_ : now_s;
}

void Plan::forgetSent() {
  for (Sent& sent : sent_) {
    sent = {};
  }
  unanswered_s_ = __builtin_nan("");
  deaf_ = false;
}

bool Plan::asksForStart(double now_s, double depth_m) {
  if (ours_runs_ || !isKnown()) {
    return false;  // it has begun, and the vehicle does not say yet that it follows; or another
                   // may have begun while nothing was received
  }
  const bool begins = state_ == State::Ready && depth_m <= mission_.start_depth_m;
  const bool again = wasLost();
  if (over_ || !(begins || again) || now_s - asked_s_ < kStartSecs) {
    return false;
  }
  asked_s_ = now_s;
  unreplied_s_ = unreplied_s_ == unreplied_s_ ? unreplied_s_ : now_s;
  forgetSent();
  return true;
}

bool Plan::isInDoubt(double now_s) const {
  return deaf_ || (ours_runs_ && now_s - unanswered_s_ > doubt_s_) ||
         now_s - unreplied_s_ > doubt_s_;
}

void Plan::noteEndOfConnection() {
  reported_s_ = __builtin_nan("");
  forgetSent();
  unreplied_s_ = __builtin_nan("");
}

void Plan::noteRenewal() {
  noteEndOfConnection();
  doubt_s_ = 2 * doubt_s_ < kMostDoubtSecs ? 2 * doubt_s_ : kMostDoubtSecs;
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
  ran_ = false;
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
