// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/headway.h"

namespace glider::hooks {

void Headway::observe(Way way, double depth_m, double step_s) {
  constexpr double kGainM = 1;
  const double gained = way == Way::Down ? depth_m - best_m_ : best_m_ - depth_m;
  if (way != way_ || gained >= kGainM) {
    best_m_ = depth_m;
    idle_s_ = 0;
  } else {
    idle_s_ += step_s;
  }
  way_ = way;
}

}  // namespace glider::hooks
