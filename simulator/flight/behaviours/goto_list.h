// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/flight/behaviour.h"
#include "simulator/flight/behaviours/source.h"
#include "simulator/flight/geography.h"

#include <string>
#include <vector>

namespace glider::simulator {

/// Steers to the waypoints of a list in turn: those of its .ma file, in latitude and longitude, or
/// wpt_x_0, wpt_y_0 and on.
class GotoList final : public Behaviour {
 public:
  explicit GotoList(const BehaviourSource& source);
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
  struct Place {
    WaypointUnits units;
    Argument x, y;
  };
  [[nodiscard]] WaypointPosition at(const Situation& situation, size_t number) const;
  [[nodiscard]] size_t first(const Situation& situation) const;
  /// The number of waypoints to reach from `first`; negative: no end.
  [[nodiscard]] int legs(size_t first) const;

  When start_, stop_;
  bool resumes_;
  std::vector<Place> places_;
  int initial_, legs_to_run_;
  size_t current_ = 0;
  int reached_ = 0, wanted_ = 0;
  int last_reached_ = -1;
  bool fresh_ = true;  ///< the distance that is known is not yet that of this waypoint
  std::vector<std::string> news_;
};

}  // namespace glider::simulator
