// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/journal.h"

#include <fmt/format.h>

namespace glider::simulator {

/// Notes in the journal when the vehicle touches the bottom, once for each contact.
class BottomContact {
 public:
  void look(double now_s, double depth_m, double water_depth_m, Journal& journal) {
    const double clearance_m = water_depth_m - depth_m;
    if (!touches_ && clearance_m < kTouch && depth_m > kAground) {
      journal.add(now_s, EventId::TouchesBottom, {}, fmt::format("{:.1f} m deep", depth_m));
      touches_ = true;
    }
    touches_ = touches_ && clearance_m < kOff;
  }

 private:
  static constexpr double kTouch = 0.05;  // m
  // A vehicle that slides along the bottom has one contact.
  static constexpr double kOff = 1;  // m
  // In shallower water it has not been launched properly; it does not fly into the bottom.
  static constexpr double kAground = 1;  // m

  bool touches_ = false;
};

}  // namespace glider::simulator
