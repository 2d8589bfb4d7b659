// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/lauv/plan_server.h"

#include "hooks/imc/values.h"

#include <limits>
#include <utility>

namespace glider::simulator::lauv {
namespace {

using namespace hooks::imc;

std::string stringOf(const Text& text) {
  return {text.bytes, text.size};
}

Text textIn(const std::string& text) {
  return {text.data(), static_cast<uint16_t>(text.size())};
}

}  // namespace

void PlanServer::take(const Packet& packet, double now_s) {
  PlanControl request;
  hooks::imc::Reference reference;
  if (packet.id == PlanControl::kId && decode(packet, request)) {
    obey(request, now_s);
  } else if (packet.id == hooks::imc::Reference::kId && decode(packet, reference)) {
    follow(packet, reference, now_s);
  } else if (packet.id == Abort::kId && plan_) {
    end(PlanEnd::Aborted);
  }
}

void PlanServer::obey(const PlanControl& request, double now_s) {
  if (request.type != PlanControlType::Request) {
    return;
  }
  if (request.op == PlanOperation::Start) {
    start(request, now_s);
  } else if (request.op == PlanOperation::Stop) {
    const bool runs = plan_.has_value();
    if (runs) {
      end(PlanEnd::Stopped);
    }
    answer(runs ? PlanControlType::Success : PlanControlType::Failure, request.op,
           request.request_id, runs ? "OK" : "no plan is running, request ignored");
  }
}

/// A start ends the plan that flies, also if it cannot be started itself.
void PlanServer::start(const PlanControl& request, double now_s) {
  if (plan_) {
    end(PlanEnd::Stopped);
  }
  const PlanSpecification& spec = request.arg.value;
  if (!request.arg.present || !spec.maneuvers.present || !spec.maneuvers.value.data.present) {
    answer(PlanControlType::Failure, request.op, request.request_id, "undefined plan");
    return;
  }
  plan_ = Plan{.id = stringOf(request.plan_id),
               .maneuver = stringOf(spec.maneuvers.value.maneuver_id),
               .follow = spec.maneuvers.value.data.value,
               .reference = {},
               .heard_s = now_s,
               .request = request.request_id};
  timed_out_ = false;
  answer(PlanControlType::Success, request.op, request.request_id, "plan loaded");
}

/// Of the system that the plan names, or of any. Without a place it is ignored; without a speed or
/// a depth those of before, or the surface, count.
void PlanServer::follow(const Packet& packet, const hooks::imc::Reference& reference,
                        double now_s) {
  if (!plan_ || (plan_->follow.control_src != kAllSystems &&
                 plan_->follow.control_src != packet.header.source)) {
    return;
  }
  plan_->heard_s = now_s;
  if ((reference.flags & ReferenceFlag::Done) != 0) {
    end(PlanEnd::Completed);
    return;
  }
  if ((reference.flags & ReferenceFlag::Location) == 0) {
    return;
  }
  hooks::imc::Reference taken = reference;
  if ((reference.flags & ReferenceFlag::Z) == 0 || !reference.z.present) {
    taken.z = {true, {.value = 0, .z_units = ZUnits::Depth}};
  }
  if (((reference.flags & ReferenceFlag::Speed) == 0 || !reference.speed.present) &&
      plan_->reference) {
    taken.speed = plan_->reference->speed;
  }
  plan_->reference = taken;
}

void PlanServer::look(double now_s) {
  if (plan_ && plan_->follow.timeout > 0 && now_s - plan_->heard_s > plan_->follow.timeout) {
    end(PlanEnd::TimedOut);
  }
}

void PlanServer::end(PlanEnd how) {
  const uint16_t request = plan_->request;
  last_id_ = plan_->id;
  last_failed_ = how != PlanEnd::Completed;
  timed_out_ = how == PlanEnd::TimedOut;
  plan_.reset();
  ended_ = how;
  if (how == PlanEnd::TimedOut) {
    answer(PlanControlType::Failure, PlanOperation::Start, request, "reference source timed out");
  } else if (how == PlanEnd::Completed) {
    answer(PlanControlType::Success, PlanOperation::Start, request, "plan completed");
  }
}

void PlanServer::answer(uint8_t type, uint8_t op, uint16_t request, const char* info) {
  PlanControl said;
  said.type = type;
  said.op = op;
  said.request_id = request;
  said.info = textOf(info);
  answer_ = said;
}

std::optional<PlanEnd> PlanServer::takeEnd() {
  return std::exchange(ended_, std::nullopt);
}

std::optional<PlanControl> PlanServer::takeAnswer() {
  return std::exchange(answer_, std::nullopt);
}

bool PlanServer::takeTimeout() {
  return std::exchange(timed_out_, false);
}

PlanControlState PlanServer::controlState() const {
  PlanControlState said;
  said.state = plan_ ? PlanState::Executing : PlanState::Ready;
  said.plan_id = textIn(plan_ ? plan_->id : last_id_);
  said.plan_eta = -1;
  said.plan_progress = -1;
  if (plan_) {
    said.man_id = textIn(plan_->maneuver);
  }
  said.man_type = plan_ ? FollowReference::kId : std::numeric_limits<uint16_t>::max();
  said.last_outcome = last_failed_ ? PlanOutcome::Failure : PlanOutcome::Success;
  return said;
}

FollowRefState PlanServer::followState(uint8_t state) const {
  FollowRefState said;
  said.control_src = plan_ ? plan_->follow.control_src : kAllSystems;
  said.control_ent = plan_ ? plan_->follow.control_ent : kAnyEntity;
  said.state = state;
  if (const auto* now = reference()) {
    said.reference = {true, *now};
  }
  return said;
}

}  // namespace glider::simulator::lauv
