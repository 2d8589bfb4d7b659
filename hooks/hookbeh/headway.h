// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

namespace glider::hooks {

/// Which way a sub-behaviour drives the vehicle.
enum class Way : uint8_t { None, Down, Up };

/// Checks whether the vehicle moves in the direction in which it is driven.
class Headway {
 public:
  /// Takes in one cycle in which it was driven `way`.
  void observe(Way way, double depth_m, double step_s);
  /// A cycle in which the depth was not known, and hookbeh climbed.
  void interrupt() { driven_s_ = still_s_ = 0; }
  [[nodiscard]] Way way() const { return way_; }
  /// Since it was driven this way and last gained a metre, s.
  [[nodiscard]] double idleFor() const { return idle_s_; }
  /// A dive has stopped, as on the bottom: the pump has had the time to act, and for a while the
  /// depth has not changed.
  [[nodiscard]] bool standsInDive() const;
  /// The depth at which it stands, m; NaN if it does not.
  [[nodiscard]] double standsAt() const;
  /// A dive that gains no depth has stopped: it has been driven down for a minute without a break,
  /// or has gained nothing for three.
  [[nodiscard]] bool mayHaveStopped() const;

 private:
  Way way_ = Way::None;
  double last_m_ = __builtin_nan("");
  double best_m_ = __builtin_nan("");
  double idle_s_ = 0;
  double driven_s_ = 0;                 ///< this way
  double still_m_ = __builtin_nan("");  ///< the depth has been near this one, and for how long
  double still_s_ = 0;
};

}  // namespace glider::hooks
