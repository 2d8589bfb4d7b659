// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/core/start_depth.h"

namespace glider::runtime {
namespace {

/// A reading above this is not a depth (as for hookbeh), m.
constexpr double kHighest = -5;
constexpr double kCmPerM = 100;

}  // namespace

bool StartDepth::needsDepth() const {
  const uint32_t depth = mission_.dictionary->roles[kGliderRoleDepth];
  for (uint32_t i = 0; i < mission_.sensor_count; ++i) {
    if (mission_.sensors[i].id == depth && mission_.sensors[i].poll == nullptr) {
      return false;
    }
  }
  return mission_.start_depth_cm != 0;
}

bool StartDepth::isNearSurface(const hooks::VehicleTick& tick) {
  const uint32_t depth = mission_.dictionary->roles[kGliderRoleDepth];
  for (uint32_t i = 0; i < tick.reading_count; ++i) {
    if (tick.readings[i].id == depth && tick.readings[i].value == tick.readings[i].value) {
      depth_ = tick.readings[i].value;
      too_deep_ = mission_.start_depth_cm != 0 && depth_ * kCmPerM > mission_.start_depth_cm;
      return depth_ >= kHighest && !too_deep_;
    }
  }
  return false;
}

bool StartDepth::look(const hooks::VehicleTick& tick) {
  seen_ = seen_ && tick.vehicle_time_s >= vehicle_time_;  // else the vehicle has restarted
  vehicle_time_ = tick.vehicle_time_s;
  seen_ = isNearSurface(tick) || seen_;
  return seen_ || mission_.start_depth_cm == 0;
}

bool StartDepth::takeWaiting() {
  const bool now = too_deep_ && !seen_ && !told_;
  told_ = told_ || now;
  return now;
}

}  // namespace glider::runtime
