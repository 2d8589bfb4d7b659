// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/slocum/flight/behaviours/started.h"
#include "simulator/slocum/flight/geography.h"

#include <string>
#include <vector>

namespace glider::simulator {

/// Steers to the waypoints of a list in turn: those of its .ma file, in latitude and longitude, or
/// wpt_x_0, wpt_y_0 and on.
class GotoList final : public StartedBehaviour {
 public:
  explicit GotoList(const BehaviourSource& source);
  void tell(double time_s, Journal& journal) override;

 protected:
  void begin(const Situation& situation) override;
  Outcome fly(const Situation& situation, Commands& commands) override;

 private:
  struct Place {
    WaypointUnits units;
    Argument x, y;
  };
  [[nodiscard]] WaypointPosition at(const Situation& situation, size_t number) const;
  [[nodiscard]] size_t first(const Situation& situation) const;
  /// The number of waypoints to reach from `first`; negative: no end.
  [[nodiscard]] int legs(size_t first) const;

  WhenCondition stop_;
  std::vector<Place> places_;
  int initial_, legs_to_run_;
  bool stays_;  ///< at its last waypoint, until an operator gives it another list (end_action 6)
  size_t current_ = 0;
  int reached_ = 0, wanted_ = 0;
  int last_reached_ = -1;
  bool over_ = false;  ///< the last waypoint is reached, and it stays there
  bool fresh_ = true;  ///< the distance that is known is not yet that of this waypoint
  std::vector<News> news_;
};

}  // namespace glider::simulator
