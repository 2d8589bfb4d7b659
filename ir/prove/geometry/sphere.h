// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <numbers>

namespace glider::ir::prove {

/// The Earth's mean radius, m, rounded down from the 6371008.8 m that missions use
/// (runtime/numbers/earth.cpp): a proof that an edge is far enough away must not overestimate the
/// distance to it.
inline constexpr double kEarthRadius = 6371000;

/// Metres in a degree of a great circle.
inline constexpr double kMetresPerDegree = kEarthRadius * std::numbers::pi / 180;

}  // namespace glider::ir::prove
