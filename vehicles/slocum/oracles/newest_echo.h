// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/oracles/judge_limits.h"
#include "vehicles/slocum/oracles/names.h"

#include <limits>

namespace glider::slocum::oracles {

/// How long ago the altimeter last received an echo.
class NewestEcho {
 public:
  /// Takes in one cycle.
  void cycle(const CycleView& view) {
    now_s_ = view.time_s;
    const bool is_echo =
        view.array.fresh(Sensor::m_altitude) && view.array.get(Sensor::m_altitude) >= 0;  // not NaN
    echo_s_ = is_echo ? view.time_s : echo_s_;
    touched_ = touched_ || (view.clearance_m < limits::kTouchM && view.true_depth_m > kUnderM);
  }
  /// s; infinite before the first.
  [[nodiscard]] double age() const { return now_s_ - echo_s_; }
  /// The same; infinite also once the vehicle has touched the bottom, which hookbeh then knows
  /// without an echo.
  [[nodiscard]] double ageOfWhatHookbehKnows() const {
    return touched_ ? std::numeric_limits<double>::infinity() : age();
  }

 private:
  static constexpr double kUnderM = 1;  // at the surface clearance is that of the shore

  double now_s_ = 0;
  double echo_s_ = -std::numeric_limits<double>::infinity();
  bool touched_ = false;
};

}  // namespace glider::slocum::oracles
