// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/eval/tick_result.h"
#include "ir/prove/falsification/depth_limits.h"
#include "ir/prove/falsification/rng.h"
#include "platforms/load/platform.h"

#include <vector>

namespace glider::ir::prove {

/// How a RandomVehicle uses what the rules allow.
enum class Manner : uint8_t {
  Any,
  Late,  ///< it sinks as fast as it may, and climbs as late and as slowly
  Shy,   ///< it comes no nearer to the surface than commanded, and to the surface as late as it may
};

/// A vehicle that does anything that the rules V1 to V7 of docs/verification.md allow, in numbers
/// (DepthLimits).
class RandomVehicle {
 public:
  /// Both outlive this.
  RandomVehicle(const platforms::Platform& platform, Rng& dice, Manner manner = Manner::Any);

  /// True depth, m, and a reading that the sensor may report for it.
  [[nodiscard]] double depth() const { return limits_.depth(); }
  double reading();
  /// Follows the commands of a tick at mission time `now`, s.
  void obey(const std::vector<Action>& actions, double now);
  /// Sinks or climbs from one mission time to another.
  void move(double from, double to);

 private:
  [[nodiscard]] bool isAsLateAsItMay() const;
  [[nodiscard]] double highestAim() const;

  const platforms::Platform& platform_;
  Rng& dice_;
  Manner manner_;
  DepthLimits limits_;
  double speed_ = 0;       ///< the share of its possible speed that it moves at
  bool sinks_on_ = false;  ///< although it is commanded to climb, until it rises
  bool rose_ = false;      ///< since it was
  double speed_until_ = 0;
};

}  // namespace glider::ir::prove
