// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/flight/behaviours/arguments.h"

#include <utility>

namespace glider::simulator {

/// Steers to a waypoint in longitude (wpt_x) and latitude (wpt_y), ddmm.mmmm.
class GotoWpt final : public Behaviour {
 public:
  explicit GotoWpt(const slocum::BehaviourBlock& block)
      : Behaviour(block.name),
        start_(startCondition(block)),
        stop_(stopCondition(block)),
        resumes_(block.value("end_action") == 2),
        command_{HeadingCommand::Mode::Waypoint, 0, block.value("wpt_y"), block.value("wpt_x")} {}

 protected:
  [[nodiscard]] bool starts(const Situation& s, const Commands& below) const override {
    return start_.met(s, below);
  }
  void begin(const Situation& s) override { start_.noteStart(s.time_s), fresh_ = true; }
  Outcome fly(const Situation& s, Commands& commands) override {
    // The distance known in the first cycle is still that of the previous waypoint.
    if (!std::exchange(fresh_, false) && stop_.met(s, commands)) {
      return Outcome::Done;
    }
    commands.steer(command_);
    return Outcome::Continue;
  }
  [[nodiscard]] bool resumes() const override { return resumes_; }
  void ended(const Situation& s) override { start_.noteEnd(s.time_s); }

 private:
  When start_, stop_;
  bool resumes_;
  bool fresh_ = true;
  HeadingCommand command_;
};

}  // namespace glider::simulator
