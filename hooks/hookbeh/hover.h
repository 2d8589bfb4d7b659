// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/args.h"
#include "hooks/hookbeh/command.h"

namespace glider::hooks {

/// Keeps a depth at level pitch by the pump: proportional to the error of the depth, damped by its
/// rate, both smoothed. The pump rests while its volume would change little: a stroke costs what
/// the rest of the vehicle takes in three minutes, and neither noise nor swell moves the vehicle.
class Hover {
 public:
  Hover() = default;
  explicit Hover(double target_m) : target_m_(target_m) {}
  [[nodiscard]] double target() const { return target_m_; }
  /// The command in this cycle, `step_s` after the previous one; 0 while another behaviour has the
  /// motors. A depth that is unknown brings the pump out.
  VerticalCommand command(const Surroundings& now, double step_s, const HookbehArgs& args);

 private:
  void follow(const Surroundings& now, double step_s);

  double target_m_ = 0;
  double read_m_ = __builtin_nan("");  ///< the newest reading, and its age
  double age_s_ = 0;
  double depth_m_ = __builtin_nan("");  ///< smoothed, at the time of that reading
  double rate_mps_ = 0;                 ///< the same, positive when sinking
  double pump_cc_ = __builtin_nan("");  ///< commanded last
};

}  // namespace glider::hooks
