// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/transport/system_clock.h"

#include <sys/auxv.h>
#include <sys/times.h>
#include <time.h>

namespace glider::hooks {
namespace {

bool monotonicSeconds(double* seconds) {
  timespec now{};
  if (clock_gettime(CLOCK_MONOTONIC, &now) != 0) {
    return false;
  }
  *seconds = static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
  return true;
}

/// Kernel ticks since some moment of the past, modulo 2^32. Near the wrap the C library may take
/// the number for an error and return -1: one tick off.
uint32_t kernelTicks() {
  tms unused{};
  return static_cast<uint32_t>(times(&unused));
}

double now(void* self) {
  return static_cast<SystemClock*>(self)->now();
}

}  // namespace

SystemClock::SystemClock() : last_ticks_(kernelTicks()) {
  monotonic_ = monotonicSeconds(&start_s_);
  // The value of sysconf(_SC_CLK_TCK), without linking the rest of sysconf.
  const unsigned long rate = getauxval(AT_CLKTCK);
  if (rate > 0) {
    ticks_a_second_ = static_cast<double>(rate);
  }
}

double SystemClock::now() {
  double seconds = 0;
  const bool fine = monotonic_ && monotonicSeconds(&seconds);
  const double passed = fine ? seconds - start_s_ : byTicks();
  newest_s_ = passed > newest_s_ ? passed : newest_s_;
  return newest_s_;
}

double SystemClock::byTicks() {
  const uint32_t ticks = kernelTicks();
  const uint32_t passed = ticks - last_ticks_;
  if (passed < UINT32_MAX / 2) {
    ticks_ += passed;
    last_ticks_ = ticks;
  }
  return ticks_ / ticks_a_second_;
}

GliderClock SystemClock::clock() {
  return {this, &glider::hooks::now};
}

}  // namespace glider::hooks
