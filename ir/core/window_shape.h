// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <cstdint>

namespace glider::ir {

/// How a window stores its readings: eval and codegen must agree on this.
struct WindowShape {
  TemporalKind kind = TemporalKind::Mean;
  bool stretch = false;
  double length = 0;  ///< s, or the SI unit of what it is stretched along
  double bin = 0;     ///< width of a bin, same unit
  uint32_t bins = 0;  ///< the number of slots for the bins of a window
};

/// Of a window that is not over a leg. A window over a time has a bin for each flight cycle (4 s),
/// at most 256. A window over a stretch has 32 bins in its length, and reaches that far to both
/// sides.
WindowShape windowShape(const Temporal& window);

}  // namespace glider::ir
