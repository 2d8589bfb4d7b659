// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/sema/names/paths.h"

#include <cstddef>
#include <expected>

namespace glider::frontend {

constexpr size_t kMostLanes = 256;
/// The farthest corner from the middle of the corners for which lanes are laid out, m.
constexpr double kFarthestCorner = 250e3;

/// Why lanes cannot be laid out.
struct LaneProblem {
  enum class Kind { Line, TooFar, TooMany } kind = Kind::Line;
  double metres =
      0;  ///< TooFar: from the middle; TooMany: a spacing that makes kMostLanes or fewer
};

/// A lawn-mower path over the convex hull of `corners`: parallel lanes at most `spacing` (m) apart,
/// flown back and forth, so that every point of the hull is within half of `spacing` of a lane.
///
/// The lanes run along the hull's longer direction: across them it is as narrow as possible, so
/// there are as few lanes, and turns, as possible. They reach the hull's edge, and go beyond it
/// only where a corner between two lanes would be missed. The path begins at that one of its four
/// possible ends that is nearest to the first corner given. Works anywhere on Earth, including the
/// poles and the date line.
std::expected<Path, LaneProblem> layLanes(const Path& corners, double spacing);

}  // namespace glider::frontend
