// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/world/start_time.h"

namespace glider::simulator {

/// The clocks of both computers of a simulated Slocum when a flight begins, s since 1970.
inline constexpr double kStartOfMission = kStartUtc_s;

}  // namespace glider::simulator
