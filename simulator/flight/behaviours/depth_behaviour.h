// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/flight/behaviours/depth_leg.h"

#include <optional>
#include <string>

namespace glider::simulator {

/// dive_to or climb_to by itself: one leg to a depth or an altitude.
class DepthBehaviour final : public Behaviour {
 public:
  explicit DepthBehaviour(const BehaviourSource& source);
  [[nodiscard]] bool flies() const override { return true; }
  void tell(double time_s, Journal& journal) override;

 protected:
  [[nodiscard]] bool starts(const Situation& s, const Commands& below) const override {
    return start_.met(s, below);
  }
  void begin(const Situation& situation) override;
  Outcome fly(const Situation& situation, Commands& commands) override;
  [[nodiscard]] bool resumes() const override { return resumes_; }
  void ended(const Situation& s) override { start_.noteEnd(s.time_s); }

 private:
  When start_;
  bool resumes_;
  DepthLeg leg_;
  std::optional<std::string> why_over_;
};

}  // namespace glider::simulator
