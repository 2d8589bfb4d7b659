// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "platforms/load/platform.h"

#include <cstdint>
#include <string>

namespace glider::ir::prove {

/// Who decides what a number or a reading is. An assumption states what the sea and the vehicle do;
/// what the mission itself decides is for requirements.
enum class Decider : uint8_t {
  Nobody,     ///< a constant
  Sea,        ///< the sea, or the vehicle's state: temperature, altitude, battery
  Counted,    ///< the mission, by how long it lasts: clocks
  Commanded,  ///< the mission, by its commands: depth, pitch, position, motors
  Launched,   ///< the pilot at the launch: a parameter
};

/// docs/verification.md has the table.
Decider deciderOf(const Mission& mission, const platforms::Platform& platform, const Expr& expr);
Decider deciderOf(const platforms::PlatformSensor& sensor);

/// Whether an assumption may only narrow the range of what this one decides within limits.
constexpr bool isDecided(Decider decider) {
  return decider >= Decider::Counted;
}

}  // namespace glider::ir::prove
