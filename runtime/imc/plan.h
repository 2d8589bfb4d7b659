// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/imc/codec.h"
#include "hooks/imc/packet.h"
#include "runtime/abi/imc_mission.h"

#include <stdint.h>

namespace glider::runtime::imc {

/// The address of the SBC on the vehicle's network: that of a console.
inline constexpr uint16_t kOwnAddress = 0x4001;

/// The plan in which the vehicle follows our References, and when it is started (README.md, rules
/// M1 to M5). Times are by the vehicle's clock, s.
class Plan {
 public:
  explicit Plan(const GliderImcMission& mission) : mission_(mission) {}

  /// Takes a packet of the vehicle.
  void take(const hooks::imc::Packet& packet);
  /// The vehicle follows our References, and nothing says otherwise.
  [[nodiscard]] bool follows() const { return state_ == State::Following; }
  /// It is in somebody else's hands: another plan flies, or ours was ended by somebody.
  [[nodiscard]] bool isTaken() const { return state_ == State::Taken; }
  /// Our plan ended because it did not receive our References: it may be started again, at any
  /// depth.
  [[nodiscard]] bool wasLost() const { return state_ == State::Lost; }
  /// Whether to ask for the start now; notes that it is.
  bool asksForStart(double now_s, double depth_m);
  /// A Reference leaves at `now_s`.
  void noteReference(double now_s) { sent_s_ = now_s; }
  /// No answer to our References for so long that the vehicle may not read what we send.
  [[nodiscard]] bool isInDoubt(double now_s) const;
  /// The vehicle executes our plan.
  [[nodiscard]] bool runs() const { return ours_runs_; }
  /// An operator has ended everything: nothing is started again.
  void takeAway();
  /// The plan is to end: nothing of it is started again.
  void end() { over_ = true; }
  [[nodiscard]] bool isOver() const { return over_ && state_ != State::Following; }

  /// The request that starts it, and the one that ends it.
  [[nodiscard]] hooks::imc::PlanControl start();
  [[nodiscard]] hooks::imc::PlanControl stop();

  /// The vehicle may need so long for a start, s: it is asked for again after that.
  static constexpr double kStartSecs = 6;
  /// Without a FollowRefState for so long it is in doubt whether the vehicle receives ours, s.
  static constexpr double kDoubtSecs = 5;

 private:
  enum class State : uint8_t { Away, Ready, Following, Lost, Taken };
  void takeState(const hooks::imc::PlanControlState& said);
  void takeFollowing(const hooks::imc::FollowRefState& said);
  void endOfPlan();
  [[nodiscard]] hooks::imc::PlanControl request(uint8_t operation);

  GliderImcMission mission_;
  State state_ = State::Away;
  bool ours_runs_ = false;  ///< the vehicle says that it executes our plan
  bool timed_out_ = false;  ///< it has said so of our References
  bool flew_ = false;       ///< this program has steered: what somebody ends stays ended
  bool over_ = false;
  uint16_t request_ = 0;
  double now_s_ = __builtin_nan("");  ///< of the newest packet; NaN before the first
  double asked_s_ = -kStartSecs;
  double sent_s_ = __builtin_nan("");   ///< the newest Reference
  double heard_s_ = __builtin_nan("");  ///< the newest FollowRefState
};

}  // namespace glider::runtime::imc
