// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <cstdint>

namespace glider::ir {

/// How a window keeps its readings: what eval and codegen must agree on.
struct WindowShape {
  TemporalKind kind = TemporalKind::Mean;
  bool stretch = false;
  double length = 0;  ///< s, or the SI unit of what it is stretched along
  double bin = 0;     ///< width of a bin, same unit
  uint32_t bins = 0;  ///< how many slots hold the bins of a window
};

/// A bin a flight cycle (4 s) over a time, at most 256; 32 bins to the length of a stretch, which
/// reaches that far to both sides.
WindowShape windowShape(const Temporal& window);

}  // namespace glider::ir
