// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/falsification/depth_limits.h"

#include "ir/prove/context/vehicle_rules.h"
#include "support/check.h"

#include <algorithm>
#include <limits>

namespace glider::ir::prove {
namespace {

struct DoubleAlgebra {
  [[nodiscard]] static double number(double value) { return value; }
  [[nodiscard]] static bool truth(bool value) { return value; }
  [[nodiscard]] static double choose(bool truth, double a, double b) { return truth ? a : b; }
};

constexpr DoubleAlgebra kDoubles;
constexpr double kNoLimit = std::numeric_limits<double>::infinity();

}  // namespace

/// V2 as the least and the greatest depth.
struct DepthLimits::Limits {
  double lowest = -kNoLimit;
  double highest = kNoLimit;

  void atLeast(double limit) { lowest = std::max(lowest, limit); }
  void atMost(double limit) { highest = std::min(highest, limit); }
  void atMostIf(bool truth, double limit) { highest = truth ? std::min(highest, limit) : highest; }
};

DepthLimits::DepthLimits(const platforms::Platform& platform, double depth_m)
    : platform_(&platform),
      vehicle_{depth_m, VehicleRules(kDoubles, platform).deepestAtStart(depth_m), false, 0, 0} {}

DepthLimits::Limits DepthLimits::limits(double from, double to) const {
  Vehicle vehicle = vehicle_;
  if (anything_) {
    vehicle.deepest = kNoLimit;
    vehicle.climbing = false;
  }
  Limits limits;
  VehicleRules(kDoubles, *platform_).move(vehicle, from, to, limits);
  return limits;
}

double DepthLimits::lowest(double from, double to) const {
  return limits(from, to).lowest;
}

double DepthLimits::highest(double from, double to) const {
  return limits(from, to).highest;
}

void DepthLimits::obey(const CommandRun& command, double now) {
  CHECK(!command.refused, "a command with an unknown target, which the vehicle does not follow");
  const auto target = [&] { return command.arguments.at(0); };
  const auto after =
      VehicleRules(kDoubles, *platform_).obey(vehicle_, command.command, target, now);
  if (after) {
    vehicle_ = *after;
    anything_ = anything_ && after->climbing;  // as downTo
  }
}

void DepthLimits::downTo(double target) {
  vehicle_ = VehicleRules(kDoubles, *platform_).downTo(vehicle_, target);
  anything_ = false;
}

void DepthLimits::upTo(double target, double now) {
  vehicle_ = VehicleRules(kDoubles, *platform_).upTo(vehicle_, target, now);
}

}  // namespace glider::ir::prove
