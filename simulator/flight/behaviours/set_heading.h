// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/flight/behaviours/arguments.h"

namespace glider::simulator {

/// Holds a heading (use_heading 1) or the fin (4).
class SetHeading final : public Behaviour {
 public:
  explicit SetHeading(const slocum::BehaviourBlock& block)
      : Behaviour(block.name),
        start_(startCondition(block)),
        stop_(stopCondition(block)),
        resumes_(block.value("end_action") == 2),
        command_{block.value("use_heading") == 4 ? HeadingCommand::Mode::Fin
                                                 : HeadingCommand::Mode::Heading,
                 block.value("heading_value"), 0, 0} {}

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
    commands.steer(command_);
    return Outcome::Continue;
  }
  [[nodiscard]] bool resumes() const override { return resumes_; }
  void ended(const Situation& s) override { start_.noteEnd(s.time_s); }

 private:
  When start_, stop_;
  bool resumes_;
  HeadingCommand command_;
};

}  // namespace glider::simulator
