// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::platforms {

/// The longest `line_lag_s` of a vehicle whose commands cross a line, in control cycles: so long,
/// and one more, the SBC's program leaves an instruction alone (runtime/core/control.h).
inline constexpr double kLongestLagCycles = 2;

}  // namespace glider::platforms
