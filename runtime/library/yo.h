// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/behaviour.h"

/// The decision that every profile made of dives and climbs shares.
namespace glider::runtime {

enum class Direction : uint32_t { None, Down, Up };

struct YoRange {
  double top = 0;     ///< m
  double bottom = 0;  ///< m
  double dive = 0;    ///< rad, magnitude
  double climb = 0;   ///< rad, magnitude
};

/// Down or up from `direction`, at `depth` (m, NaN: unknown). On enter and resume it is chosen
/// again: down unless the bottom is reached. An unknown depth means up, at once: only that is safe.
Direction turn(Direction direction, uint32_t phase, double depth, const YoRange& range);

/// Commands the leg in `direction`.
void flyLeg(GliderContext* context, Direction direction, const YoRange& range);

}  // namespace glider::runtime
