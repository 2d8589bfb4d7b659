// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/imc/codec.h"
#include "hooks/imc/packet.h"

#include <cstdint>
#include <optional>
#include <string>

namespace glider::simulator::lauv {

/// How the vehicle's plan ended.
enum class PlanEnd : uint8_t { Completed, Stopped, TimedOut, Aborted };

/// The part of the vehicle's software that flies plans for a back seat: starts and ends the one in
/// which it follows References, with their time-out, as hooks/imc/README.md describes it.
class PlanServer {
 public:
  using Reference = hooks::imc::Reference;

  /// Takes a packet that is addressed to the vehicle.
  void take(const hooks::imc::Packet& packet, double now_s);
  /// Ends the plan if its References have stopped.
  void look(double now_s);
  /// The operator ends it.
  void stop() { end(PlanEnd::Stopped); }

  [[nodiscard]] bool executes() const { return plan_.has_value(); }
  /// The newest Reference of the plan; null before the first.
  [[nodiscard]] const Reference* reference() const {
    return plan_ && plan_->reference ? &*plan_->reference : nullptr;
  }
  /// How the plan ended since the last call, if it did.
  std::optional<PlanEnd> takeEnd();

  /// What it says of itself. `state`: of the manoeuvre (FollowState).
  [[nodiscard]] hooks::imc::PlanControlState controlState() const;
  [[nodiscard]] hooks::imc::FollowRefState followState(uint8_t state) const;
  /// The answer to a request, or to an end, since the last call. It points into this.
  std::optional<hooks::imc::PlanControl> takeAnswer();
  /// FollowRefState says once that the References have stopped.
  bool takeTimeout();

 private:
  struct Plan {
    std::string id, maneuver;
    hooks::imc::FollowReference follow;
    std::optional<Reference> reference;
    double heard_s = 0;
    uint16_t request = 0;
  };
  void obey(const hooks::imc::PlanControl& request, double now_s);
  void start(const hooks::imc::PlanControl& request, double now_s);
  void follow(const hooks::imc::Packet& packet, const Reference& reference, double now_s);
  void answer(uint8_t type, uint8_t op, uint16_t request, const char* info);
  void end(PlanEnd how);

  std::optional<Plan> plan_;
  std::string last_id_;
  bool last_failed_ = true;
  std::optional<PlanEnd> ended_;
  std::optional<hooks::imc::PlanControl> answer_;
  bool timed_out_ = false;
};

}  // namespace glider::simulator::lauv
