// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/flight/behaviour.h"
#include "simulator/flight/behaviours/source.h"

namespace glider::simulator {

/// Holds a heading (use_heading 1) or the fin (4).
class SetHeading final : public Behaviour {
 public:
  explicit SetHeading(const BehaviourSource& source)
      : Behaviour(source.block.name),
        start_(source.startCondition()),
        stop_(source.stopCondition()),
        resumes_(source.code("end_action") == 2),
        mode_(source.code("use_heading") == 4 ? HeadingCommand::Mode::Fin
                                              : HeadingCommand::Mode::Heading),
        value_(source.argument("heading_value")) {}

 protected:
  [[nodiscard]] bool starts(const Situation& s, const Commands& below) const override {
    return start_.met(s, below);
  }
  void begin(const Situation& s) override {
    start_.noteStart(s.time_s), stop_.noteEnd(s.time_s), stop_.noteStart(s.time_s);
  }
  Outcome fly(const Situation& s, Commands& commands) override {
    if (stop_.met(s, commands)) {
      return Outcome::Done;
    }
    commands.steer({mode_, value_(), 0, 0});
    return Outcome::Continue;
  }
  [[nodiscard]] bool resumes() const override { return resumes_; }
  void ended(const Situation& s) override { start_.noteEnd(s.time_s); }

 private:
  When start_, stop_;
  bool resumes_;
  HeadingCommand::Mode mode_;
  Argument value_;
};

}  // namespace glider::simulator
