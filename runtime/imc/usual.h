// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::runtime::imc {

/// Without a Reference for so long the vehicle stops its propeller and floats up: the only bound on
/// what it does when the SBC fails, s of its clock. References leave once a second, and an SBC that
/// pauses for its card or its network takes some seconds.
inline constexpr double kTimeoutSecs = 15;

/// The radius of the circle at a waypoint, m.
inline constexpr double kLoiterMetres = 10;

}  // namespace glider::runtime::imc
