// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/slocum/flight/behaviours/started.h"
#include "simulator/slocum/flight/geography.h"

namespace glider::simulator {

/// Steers to one waypoint: wpt_x and wpt_y in wpt_units.
class GotoWpt final : public StartedBehaviour {
 public:
  explicit GotoWpt(const BehaviourSource& source);

 protected:
  void begin(const Situation& situation) override;
  Outcome fly(const Situation& situation, Commands& commands) override;

 private:
  WhenCondition stop_;
  bool fresh_ = true;
  WaypointUnits units_;
  Argument x_, y_;
};

}  // namespace glider::simulator
