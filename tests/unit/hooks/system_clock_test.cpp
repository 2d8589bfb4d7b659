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

TEST(SystemClock, KeepsStepWithTheKernelsClock) {
  for (const bool old : {false, true}) {
    SystemClock clock;
    timespec begin{}, end{};
    ASSERT_EQ(__real_clock_gettime(CLOCK_MONOTONIC, &begin), 0);
    old_kernel = old;
    const double first = clock.now();
    ::usleep(250000);
    const double passed = clock.now() - first;
    old_kernel = false;
    ASSERT_EQ(__real_clock_gettime(CLOCK_MONOTONIC, &end), 0);
    const double true_seconds = static_cast<double>(end.tv_sec - begin.tv_sec) +
                                static_cast<double>(end.tv_nsec - begin.tv_nsec) / 1e9;
    EXPECT_GT(passed, 0.2);
    EXPECT_LT(passed, true_seconds + 0.02) << "a kernel tick is 0.01 s";
  }
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
