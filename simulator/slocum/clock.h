// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::simulator {

/// The clocks of both computers of a simulated Slocum when a flight begins, s since 1970: in 2009.
/// Nothing may depend on the wall clock of the machine.
inline constexpr double kStartOfMission = 1.25e9;

}  // namespace glider::simulator
