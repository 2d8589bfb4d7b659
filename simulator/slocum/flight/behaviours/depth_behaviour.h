// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/slocum/flight/behaviours/depth_leg.h"
#include "simulator/slocum/flight/behaviours/started.h"

#include <optional>
#include <string>

namespace glider::simulator {

/// dive_to or climb_to by itself: one leg to a depth or an altitude.
class DepthBehaviour final : public StartedBehaviour {
 public:
  explicit DepthBehaviour(const BehaviourSource& source);
  [[nodiscard]] bool flies() const override { return true; }
  void tell(double time_s, Journal& journal) override;

 protected:
  void begin(const Situation& situation) override;
  Outcome fly(const Situation& situation, Commands& commands) override;

 private:
  DepthLeg leg_;
  std::optional<std::string> why_over_;
};

}  // namespace glider::simulator
