// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::platforms {

/// The longest `line_lag_s` and cycle, together, of a vehicle whose commands cross a line, s: so
/// long the SBC's program leaves an instruction alone (runtime/core/control.h).
inline constexpr double kLongestCrossingS = 12;

}  // namespace glider::platforms
