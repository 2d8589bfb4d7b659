// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/slocum/flight/behaviours/started.h"

namespace glider::simulator {

/// Holds a heading (use_heading 1) or the fin (4); for a bank (2, 3) the fin in the middle, because
/// the simulated vehicle does not roll. 5 is a heading relative to the current, which is not
/// simulated: checkValues warns, and the heading is steered as it is given.
class SetHeading final : public StartedBehaviour {
 public:
  explicit SetHeading(const BehaviourSource& source)
      : StartedBehaviour(source),
        stop_(source.stopCondition()),
        mode_(isHeading(source.code("use_heading")) ? HeadingCommand::Mode::Heading
                                                    : HeadingCommand::Mode::Fin),
        value_(isRoll(source.code("use_heading")) ? Argument(0, source.variables)
                                                  : source.argument("heading_value")) {}

 protected:
  void begin(const Situation& s) override {
    StartedBehaviour::begin(s);
    stop_.restart(s.time_s);
  }
  Outcome fly(const Situation& s, Commands& commands) override {
    if (stop_.met(s, commands)) {
      return Outcome::Done;
    }
    commands.steer({mode_, value_(), 0, 0});
    return Outcome::Continue;
  }

 private:
  static bool isHeading(int code) { return code == 1 || code == 5; }
  static bool isRoll(int code) { return code == 2 || code == 3; }

  WhenCondition stop_;
  HeadingCommand::Mode mode_;
  Argument value_;
};

}  // namespace glider::simulator
