// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/core/after_tick.h"
#include "runtime/core/persistence.h"
#include "runtime/core/wait_times.h"

namespace glider::runtime::extctl {

/// Reports in the log that the vehicle is brought to the surface before the mission may begin, and
/// how long that has lasted.
class ComingUp {
 public:
  /// `for_s`: s; NaN: it is not. It outlives this.
  explicit ComingUp(const double* for_s) : for_s_(for_s) {}

  [[nodiscard]] AfterTick afterTick() { return {report, this}; }

 private:
  static void report(void* self, Persistence& persistence) {
    auto& coming = *static_cast<ComingUp*>(self);
    if (coming.times_.isDue(*coming.for_s_)) {
      persistence.bringsUp(*coming.for_s_);
    }
  }

  const double* for_s_;
  WaitTimes times_;
};

}  // namespace glider::runtime::extctl
