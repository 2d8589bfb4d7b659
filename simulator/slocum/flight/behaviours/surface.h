// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/slocum/flight/behaviours/started.h"

namespace glider::simulator {

/// Brings the vehicle to the surface, waits there for a fix and for an operator (there is none),
/// then ends, resumes or quits the mission.
class Surface final : public StartedBehaviour {
 public:
  explicit Surface(const BehaviourSource& source);
  [[nodiscard]] bool atWork() const override { return state() == State::Active; }
  [[nodiscard]] bool endsMission() const override { return state() == State::Complete; }
  [[nodiscard]] double lastContact() const override { return contact_s_; }

 protected:
  void begin(const Situation& situation) override;
  Outcome fly(const Situation& situation, Commands& commands) override;
  [[nodiscard]] bool resumes() const override {
    return end_action_ != EndAction::Quit && end_action_ != EndAction::WaitThenQuit;
  }

 private:
  /// end_action. The operator's keys are waited for, but none is pressed.
  enum class EndAction : uint8_t {
    Quit,
    WaitThenResume,
    Resume,
    DriftAway,  ///< until the waypoint is further away than end_wpt_dist
    WaitOnce,   ///< at the first surfacing only
    WaitThenQuit,
  };
  [[nodiscard]] bool waitsForKeys() const;
  [[nodiscard]] bool dialogueOver(const Situation& situation) const;

  EndAction end_action_;
  PitchSource pitch_;
  Argument pump_cc_, gps_wait_s_, keystroke_wait_s_, end_distance_m_;
  double surfaced_s_ = 0, fixed_s_ = 0;  ///< NaN: not yet
  double contact_s_ = 0;                 ///< when last
  bool has_waited_ = false;
};

}  // namespace glider::simulator
