// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/transport/system_clock.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <cstdint>
#include <ctime>
#include <sys/times.h>
#include <unistd.h>

/// True while the test plays a kernel without clock_gettime, such as Linux 2.4.
static bool old_kernel = false;
/// What its count of ticks says; negative: the kernel's own.
static int64_t ticks = -1;

extern "C" {
int __real_clock_gettime(clockid_t clock, timespec* now);
int __wrap_clock_gettime(clockid_t clock, timespec* now) {
  if (old_kernel) {
    errno = ENOSYS;
    return -1;
  }
  return __real_clock_gettime(clock, now);
}

clock_t __real_times(tms* used);
clock_t __wrap_times(tms* used);
clock_t __wrap_times(tms* used) {
  return ticks >= 0 ? static_cast<clock_t>(ticks) : __real_times(used);
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

/// A clock of kernel ticks, 100 in a second, from a moment that the test chooses.
class TickClock : public testing::Test {
 protected:
  ~TickClock() override {
    ticks = -1;
    old_kernel = false;
  }
  static SystemClock from(uint32_t begin) {
    old_kernel = true;
    ticks = begin;
    return SystemClock();
  }
  static double at(SystemClock& clock, uint32_t now) {
    ticks = now;
    return clock.now();
  }
};

TEST_F(TickClock, CountsRound) {
  SystemClock clock = from(0xFFFFFFF0);
  EXPECT_DOUBLE_EQ(at(clock, 0xFFFFFFFA), 0.1);
  EXPECT_DOUBLE_EQ(at(clock, 4), 0.2);
  EXPECT_DOUBLE_EQ(at(clock, 0x70000004), 0.2 + 0x70000000 / 100.0);
}

TEST_F(TickClock, WhatGoesBackDoesNotAdvanceUntilItIsThereAgain) {
  SystemClock clock = from(1000);
  EXPECT_DOUBLE_EQ(at(clock, 1100), 1);
  for (const uint32_t back : {1099U, 1090U, 5U, 1100U}) {
    EXPECT_DOUBLE_EQ(at(clock, back), 1) << back;
  }
  EXPECT_DOUBLE_EQ(at(clock, 1200), 2);
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
