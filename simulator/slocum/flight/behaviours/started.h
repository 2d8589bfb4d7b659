// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/slocum/flight/behaviour.h"
#include "simulator/slocum/flight/behaviours/source.h"

namespace glider::simulator {

/// A behaviour that begins by its start_when, and after end_action 2 waits for the next start.
class StartedBehaviour : public Behaviour {
 protected:
  explicit StartedBehaviour(const BehaviourSource& source)
      : StartedBehaviour(source, source.code("end_action") == 2) {}
  /// For a behaviour without end_action.
  StartedBehaviour(const BehaviourSource& source, bool resumes)
      : Behaviour(source.block.name), start_(source.startCondition()), resumes_(resumes) {}

  [[nodiscard]] bool starts(const Situation& s, const Commands& below) const override {
    return start_.met(s, below);
  }
  [[nodiscard]] std::string whyStarts(const Commands& below) const override {
    return "start_when " + start_.text(below);
  }
  void begin(const Situation& s) override { start_.noteStart(s.time_s); }
  [[nodiscard]] bool resumes() const override { return resumes_; }
  void ended(const Situation& s) override { start_.noteEnd(s.time_s); }

 private:
  WhenCondition start_;
  bool resumes_;
};

}  // namespace glider::simulator
