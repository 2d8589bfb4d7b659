// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/flight/behaviour.h"

namespace glider::simulator {

/// Brings the vehicle to the surface, waits there for a fix and for an operator (there is none),
/// then ends, resumes or quits the mission.
class Surface final : public Behaviour {
 public:
  explicit Surface(const slocum::BehaviourBlock& block);
  [[nodiscard]] bool atWork() const override { return state() == State::Active; }
  [[nodiscard]] bool endsMission() const override {
    return state() == State::Complete && end_action_ == 0;
  }

 protected:
  [[nodiscard]] bool starts(const Situation& s, const Commands& below) const override {
    return start_.met(s, below);
  }
  void begin(const Situation& situation) override;
  Outcome fly(const Situation& situation, Commands& commands) override;
  [[nodiscard]] bool resumes() const override { return end_action_ != 0; }
  void ended(const Situation& situation) override { start_.noteEnd(situation.time_s); }

 private:
  When start_;
  int end_action_;
  PitchCommand pitch_;
  double pump_cc_, gps_wait_s_, keystroke_wait_s_;
  double surfaced_s_ = 0, fixed_s_ = 0;  ///< NaN: not yet
};

}  // namespace glider::simulator
