// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The estimate of a long campaign, and what its progress is in a file.

#include "driver/output/time_left.h"

#include "driver/terminal.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>

namespace glider::driver {
namespace {

using std::chrono::seconds;

TEST(TimeLeft, IsByHowFastItWent) {
  const TimeLeft::Clock::time_point begin;
  TimeLeft left;
  EXPECT_EQ(left.of(10, 110, begin), "") << "the first call";
  EXPECT_EQ(left.of(12, 110, begin + seconds(2)), "") << "too early";
  EXPECT_EQ(left.of(20, 110, begin + seconds(5)), "about 45 s left");
  EXPECT_EQ(left.of(20, 110, begin + seconds(60)), "about 9 min left");
  EXPECT_EQ(left.of(20, 110, begin + seconds(1000)), "about 2.5 h left");
  EXPECT_EQ(left.of(110, 110, begin + seconds(1000)), "") << "all is done";
  EXPECT_EQ(left.of(10, 110, begin + seconds(1000)), "") << "nothing is done";
}

TEST(TimeLeft, OfAFlightIsByItsSeconds) {
  const TimeLeft::Clock::time_point begin;
  TimeLeft left;
  EXPECT_EQ(left.of(0, 21600, begin), "");
  EXPECT_EQ(left.of(3600, 21600, begin + seconds(10)), "about 50 s left");
}

TEST(ProgressLine, IsALineFromTimeToTimeInAFile) {
  testing::internal::CaptureStderr();
  {
    ProgressLine line(std::chrono::milliseconds(200));
    line.show("at once");
    std::this_thread::sleep_for(std::chrono::milliseconds(250));
    line.show("1 of 3");
    line.show("2 of 3");
    std::this_thread::sleep_for(std::chrono::milliseconds(250));
    line.show("3 of 3");
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "glidercc: 1 of 3\nglidercc: 3 of 3\n");
}

}  // namespace
}  // namespace glider::driver
