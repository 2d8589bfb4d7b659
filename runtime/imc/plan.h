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
  void noteReference(const hooks::imc::Reference& reference, double now_s);
  /// Nothing shows that the vehicle reads what we send: it has not answered the request to start
  /// for so long, or does not report our References back, or has timed out although they were sent.
  [[nodiscard]] bool isInDoubt(double now_s) const;
  /// The connection is closed because of that doubt: the next doubt takes twice as long.
  void noteRenewal();
  /// The connection has ended, for any reason. What the vehicle flies is not known until it reports
  /// it on the next one: nothing is started or stopped before. What was sent is not waited for.
  void noteEndOfConnection();
  /// The vehicle has reported on this connection what it flies, and not too long ago.
  [[nodiscard]] bool isKnown() const {
    const double age_s = now_s_ - reported_s_;
    return age_s < kStaleSecs && age_s > -kSetBackSecs;
  }
  /// The vehicle executes our plan.
  [[nodiscard]] bool runs() const { return ours_runs_; }
  /// That the vehicle has refused, or has reported as a failure.
  enum class Failure : uint8_t { None, Start, End, Flight };
  /// What has failed since the last call. A refused end of a plan that is over does not count.
  Failure takeFailure();
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
  /// If nothing that was sent was answered for so long, it is in doubt whether the vehicle receives
  /// it, s. Twice as long after each new connection that did not help, up to kMostDoubtSecs.
  static constexpr double kDoubtSecs = 5;
  static constexpr double kMostDoubtSecs = 60;
  /// What the vehicle has reported says nothing when so long has passed, s: on a line without
  /// connections nothing else shows that it was silent. As long as TcpLine waits for a byte.
  static constexpr double kStaleSecs = 10;

 private:
  enum class State : uint8_t { Away, Ready, Following, Lost, Taken };
  /// A Reference that was sent, and when.
  struct Sent {
    double at_s = __builtin_nan("");
    double latitude = 0, longitude = 0, speed = 0;
    float depth = 0;
  };
  static constexpr uint32_t kRemembered = 8;
  /// A time that is so much older than the one before means that the clock was set back, s.
  static constexpr double kSetBackSecs = 60;
  void takeTime(double time_s);
  void takeReply(uint16_t to, const hooks::imc::PlanControl& said);
  void takeEcho(const hooks::imc::Reference& said);
  void forgetSent();
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
  bool ran_ = false;     ///< the vehicle has executed it since the newest request to start
  bool failed_ = false;  ///< the vehicle reports it of the newest request, failed_operation_
  uint8_t failed_operation_ = 0;
  uint16_t request_ = 0;
  double now_s_ = __builtin_nan("");  ///< of the newest packet; NaN before the first
  double reported_s_ =
      __builtin_nan("");  ///< when it has reported on this connection what it executes
  double asked_s_ = -kStartSecs;
  double unreplied_s_ = __builtin_nan("");  ///< when it was asked for a start without a reply since
  bool deaf_ = false;                       ///< it has timed out although References were sent
  double doubt_s_ = kDoubtSecs;
  Sent sent_[kRemembered];                   ///< the newest References, in a ring
  uint32_t newest_ = 0;                      ///< of sent_
  double unanswered_s_ = __builtin_nan("");  ///< when the oldest Reference was sent that none of
                                             ///< those reported back is or follows; NaN: none
};

}  // namespace glider::runtime::imc
