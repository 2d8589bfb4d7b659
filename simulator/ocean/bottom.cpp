// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/ocean/bottom.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glider::simulator {

constexpr double kBottomTurn = 2 * std::numbers::pi;

double Bottom::depth(double x, double y) const {
  const BottomSettings& s = settings_;
  double depth = s.depth_m;
  if (s.wave_height_m != 0) {
    depth -= s.wave_height_m * std::sin(kBottomTurn * std::hypot(x, y) / s.wave_length_m);
  }
  if (s.slope != 0) {
    depth += s.slope * (x * std::sin(s.slope_bearing_rad) + y * std::cos(s.slope_bearing_rad));
  }
  for (const Seamount& mount : s.seamounts) {
    const double r = std::hypot(x - mount.x, y - mount.y) / mount.radius_m;
    depth -= mount.height_m * std::exp(-r * r);
  }
  return std::max(depth, 0.0);
}

}  // namespace glider::simulator
