// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "platforms/load/platform.h"
#include "support/source_range.h"

namespace glider::frontend {

/// What the line `pack` says, and what `energyused` needs.
struct Energy {
  bool good = false;  ///< false: the line was refused, which has been reported
  ir::Pack pack;
  support::SourceRange reserve;  ///< of its share; not valid if it has none
  /// The charge when it was first known in the mission; invalid: the mission does not ask for
  /// `energyused`, or the vehicle does not count its charge.
  ir::VariableId start;
};

/// The vehicle's sensor of the charge used since the batteries were new; null if there is none.
inline const platforms::PlatformSensor* findCharge(const platforms::Platform& platform) {
  const platforms::PlatformSensor* found = platform.find("charge");
  return found != nullptr && found->dimension == support::dimension::charge ? found : nullptr;
}

}  // namespace glider::frontend
