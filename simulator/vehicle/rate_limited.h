// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cmath>

namespace glider::simulator {

/// A motor that moves at a constant rate between two stops; with a lag it slows down near its
/// target.
struct RateLimited {
  double position = 0;
  double target = 0;
  double rate = 1;  ///< per s
  double lowest = 0;
  double highest = 0;
  double lag_s = 0;

  /// Moves for `seconds`; returns how far.
  double step(double seconds) {
    const double wanted = std::clamp(target, lowest, highest);
    const double share = lag_s > 0 ? 1 - std::exp(-seconds / lag_s) : 1;
    const double moved = std::clamp((wanted - position) * share, -rate * seconds, rate * seconds);
    position += moved;
    return moved;
  }
};

}  // namespace glider::simulator
