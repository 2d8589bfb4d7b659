// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/flight/behaviours/started.h"

namespace glider::simulator {

/// Holds a heading (use_heading 1) or the fin (4).
class SetHeading final : public StartedBehaviour {
 public:
  explicit SetHeading(const BehaviourSource& source)
      : StartedBehaviour(source),
        stop_(source.stopCondition()),
        mode_(source.code("use_heading") == 4 ? HeadingCommand::Mode::Fin
                                              : HeadingCommand::Mode::Heading),
        value_(source.argument("heading_value")) {}

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
  When stop_;
  HeadingCommand::Mode mode_;
  Argument value_;
};

}  // namespace glider::simulator
