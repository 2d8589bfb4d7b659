// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/flight/behaviours/depth_leg.h"

namespace glider::simulator {

/// Dives and climbs in turn.
class Yo final : public Behaviour {
 public:
  explicit Yo(const BehaviourSource& source);
  [[nodiscard]] bool flies() const override { return true; }
  void tell(double time_s, Journal& journal) override;

 protected:
  [[nodiscard]] bool starts(const Situation& s, const Commands& below) const override {
    return start_.met(s, below);
  }
  void begin(const Situation& situation) override;
  Outcome fly(const Situation& situation, Commands& commands) override;
  [[nodiscard]] bool resumes() const override { return end_action_ == 2; }
  void ended(const Situation& situation) override { start_.noteEnd(situation.time_s); }

 private:
  When start_, stop_;
  DepthLeg dive_, climb_;
  bool starts_diving_;
  Argument half_cycles_to_do_;
  int end_action_;
  DepthLeg* leg_ = nullptr;
  int half_cycles_ = 0;
  std::vector<std::pair<std::string, std::string>> news_;
};

}  // namespace glider::simulator
