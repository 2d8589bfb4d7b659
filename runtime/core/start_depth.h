// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/client/client.h"
#include "runtime/abi/runtime.h"

#include <stdint.h>

/// A mission begins only after its program has seen the vehicle near the surface in the present
/// mission of the vehicle. So a program that starts while the vehicle is under water, without a
/// checkpoint to continue from, waits until the vehicle's own layers have brought it up.
namespace glider::runtime {

class StartDepth {
 public:
  explicit StartDepth(const GliderMission& mission) : mission_(mission) {}

  /// True if the program must subscribe to the depth for this, in addition to the mission's
  /// sensors.
  [[nodiscard]] bool needsDepth() const;
  /// Takes in a tick before the mission has begun. True if it may begin.
  bool look(const hooks::VehicleTick& tick);
  /// True once, at the first tick that shows the vehicle too deep: it waits.
  bool takeWaiting();
  /// The depth in the newest tick that reported one, m.
  [[nodiscard]] double depth() const { return depth_; }

 private:
  [[nodiscard]] bool isNearSurface(const hooks::VehicleTick& tick);

  const GliderMission& mission_;
  double vehicle_time_ = 0;  ///< of the newest tick, s
  double depth_ = 0;
  bool seen_ = false;  ///< near the surface, in the vehicle's present mission
  bool too_deep_ = false;
  bool told_ = false;
};

}  // namespace glider::runtime
