// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/transport/system_clock.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <ctime>
#include <unistd.h>

/// True while the test plays a kernel without clock_gettime, such as Linux 2.4.
static bool old_kernel = false;

extern "C" {
int __real_clock_gettime(clockid_t clock, timespec* now);
int __wrap_clock_gettime(clockid_t clock, timespec* now) {
  if (old_kernel) {
    errno = ENOSYS;
    return -1;
  }
  return __real_clock_gettime(clock, now);
}
}

namespace glider::hooks {
namespace {

void expectItRuns() {
  SystemClock clock;
  const GliderClock plain = clock.clock();
  double last = plain.now(plain.self);
  EXPECT_GE(last, 0);
  EXPECT_LT(last, 1);
  for (int i = 0; i < 12; ++i) {
    ::usleep(10000);
    const double now = plain.now(plain.self);
    EXPECT_GE(now, last);
    last = now;
  }
  EXPECT_GE(last, 0.1);
  EXPECT_LT(last, 30) << "seconds, not ticks";
}

TEST(SystemClock, RunsOnThisKernel) {
  expectItRuns();
}

TEST(SystemClock, RunsOnAKernelWithoutAMonotonicClock) {
  old_kernel = true;
  expectItRuns();
  old_kernel = false;
}

TEST(SystemClock, GoesOnWhenTheClockFailsLater) {
  SystemClock clock;
  ::usleep(20000);
  const double before = clock.now();
  old_kernel = true;
  EXPECT_GE(clock.now(), before);
  old_kernel = false;
}

}  // namespace
}  // namespace glider::hooks
