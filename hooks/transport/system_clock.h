// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/transport/clock.h"

#include <stdint.h>

namespace glider::hooks {

/// The time since its construction, from CLOCK_MONOTONIC, or from times(2) on kernels that lack it
/// (Linux 2.4).
class SystemClock {
 public:
  SystemClock();
  SystemClock(const SystemClock&) = delete;
  SystemClock& operator=(const SystemClock&) = delete;
  /// Seconds, never going back.
  double now();
  /// Points into this object.
  [[nodiscard]] GliderClock clock();

 private:
  /// Adds up the kernel's ticks, whose counter wraps on 32-bit boards.
  double byTicks();

  bool monotonic_ = false;
  double start_s_ = 0;
  double newest_s_ = 0;
  uint32_t last_ticks_ = 0;
  double ticks_ = 0;
  double ticks_a_second_ = 100;
};

}  // namespace glider::hooks
