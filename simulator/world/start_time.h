// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::simulator {

/// The clocks of all simulated vehicles when a flight begins, s since 1970: in 2009. Those of a
/// fleet take turns by it. Nothing may depend on the wall clock of the machine.
inline constexpr double kStartUtc_s = 1.25e9;

}  // namespace glider::simulator
