// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/flight/behaviour.h"
#include "simulator/flight/behaviours/source.h"
#include "simulator/flight/geography.h"

namespace glider::simulator {

/// Steers to one waypoint: wpt_x and wpt_y in wpt_units.
class GotoWpt final : public Behaviour {
 public:
  explicit GotoWpt(const BehaviourSource& source);

 protected:
  [[nodiscard]] bool starts(const Situation& s, const Commands& below) const override {
    return start_.met(s, below);
  }
  void begin(const Situation& situation) override;
  Outcome fly(const Situation& situation, Commands& commands) override;
  [[nodiscard]] bool resumes() const override { return resumes_; }
  void ended(const Situation& s) override { start_.noteEnd(s.time_s); }

 private:
  When start_, stop_;
  bool resumes_;
  bool fresh_ = true;
  WaypointUnits units_;
  Argument x_, y_;
};

}  // namespace glider::simulator
