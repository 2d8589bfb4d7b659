// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::simulator::remus100 {

/// Without goals for so long the simulated vehicle ends the override, s. Nothing public says that a
/// real one does, or when: whoever operates it must set it so and try it.
inline constexpr double kTimeoutSecs = 30;

}  // namespace glider::simulator::remus100
