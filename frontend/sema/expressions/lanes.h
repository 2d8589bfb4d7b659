// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/sema/names/paths.h"

#include <cstddef>
#include <expected>

namespace glider::frontend {

constexpr size_t kMostLanes = 256;
/// Lanes are laid out to this distance from the middle of the corners, m.
constexpr double kFarthestCorner = 250e3;

/// Why lanes cannot be laid out.
struct LaneProblem {
  enum class Kind { Line, TooFar, TooMany } kind = Kind::Line;
  double metres =
      0;  ///< TooFar: from the middle; TooMany: a spacing that makes kMostLanes or fewer
};

/// A lawn-mower over the convex hull of `corners`: parallel lanes at most `spacing` (m) apart,
/// flown to and fro, such that every point of the hull lies within half of `spacing` of a lane.
///
/// The lanes run along the hull's longer way: across them it is as narrow as it can be, so there
/// are as few lanes, and turns, as there can be. They reach the hull's edge, and beyond it only
/// where a corner between two lanes would be missed. The path begins at that of its four possible
/// ends which is nearest to the first corner given. Any place on Earth will do, poles and date line
/// included.
std::expected<Path, LaneProblem> layLanes(const Path& corners, double spacing);

}  // namespace glider::frontend
