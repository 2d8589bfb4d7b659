// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/trace/trace.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace glider::support {

/// A vehicle at less than this depth, m, is at the surface.
inline constexpr double kSurfaceDepth = 2;

/// A stretch of rows in which the vehicle is under water.
struct Submersion {
  size_t begin = 0;           ///< the first row below kSurfaceDepth
  std::optional<size_t> end;  ///< the first row above it again; empty: the trace ends before
};

/// The submersions of `trace`, by its measured depth (its true depth if it has no other), in order.
/// What stays within 1 m of kSurfaceDepth is a wave, not a submersion. If the vehicle stays above
/// it for less than 2 min, it has only turned for the next dive, and the submersion continues.
std::vector<Submersion> submersions(const Trace& trace);

}  // namespace glider::support
