// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/slocum/flight/behaviours/started.h"

namespace glider::simulator {

/// Keeps the vehicle at the surface until it has a fix, or until wait_time is over; then it is
/// complete.
class PrepareToDive final : public StartedBehaviour {
 public:
  explicit PrepareToDive(const BehaviourSource& source);
  [[nodiscard]] bool atWork() const override { return state() == State::Active; }

 protected:
  void begin(const Situation& situation) override;
  Outcome fly(const Situation& situation, Commands& commands) override;

 private:
  Argument wait_s_;
  PitchSource pitch_;  ///< this and the pump as a behaviour surface without b_args
  Argument pump_cc_;
  double begun_s_ = 0;
};

}  // namespace glider::simulator
