// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/abi/order.h"
#include "tests/unit/runtime/bench_mission.h"

#include <gtest/gtest.h>

#include <limits>

namespace glider::runtime::testing {
namespace {

using Limits = std::numeric_limits<double>;

TEST(Order, IsThatOfTheNumbersWithUnknownAbove) {
  const double numbers[] = {-Limits::infinity(),
                            -Limits::max(),
                            -2.5,
                            -Limits::min(),
                            -0.0,
                            0.0,
                            Limits::min(),
                            1,
                            1.0000000000000002,
                            Limits::max(),
                            Limits::infinity(),
                            Limits::quiet_NaN()};
  for (size_t i = 1; i < std::size(numbers); ++i) {
    EXPECT_LT(gliderOrder(numbers[i - 1]), gliderOrder(numbers[i])) << i;
  }
  EXPECT_EQ(gliderOrder(-0.0), -1);
}

/// Depth cut at 5 m (from there) and 10 m (past it), mission time at 100 s. Row 0, case 0: below
/// 5 m. Row 1, case 1: past 10 m, if asked. Row 2, case 2: from 100 s on.
class GuardTableTest : public ::testing::Test {
 protected:
  GuardTableTest() {
    bench_.sensors = {depthSensor()};
    bench_.states = {benchState("a")};
    bench_.mission.interval_count = gliderGuardMemory(2, 1);
    bench_.finish(0);
    context_ = bench_.start();
  }
  uint32_t at(double time, double depth, uint32_t from = 0) {
    step(context_, time, {update(GLIDER_M_DEPTH, depth)});
    return gliderFirstTrue(context_, &table_, from);
  }

  BenchMission bench_;
  const int64_t depth_keys_[3] = {gliderOrder(5), gliderOrder(10) + 1,
                                  gliderOrder(Limits::infinity()) + 1};
  const uint32_t depth_rows_[2] = {0b101, 0b100};  // below 5 m; unknown
  const uint16_t depth_turns_[3] = {0, 1, 1};
  const uint16_t depth_first_[4] = {0, 1, 2, 3};
  const int64_t time_keys_[2] = {gliderOrder(100), gliderOrder(Limits::infinity()) + 1};
  const uint32_t time_rows_[2] = {0b011, 0b011};
  const uint16_t time_turns_[2] = {2, 2};
  const uint16_t time_first_[3] = {0, 1, 2};
  GliderGuardColumn columns_[2] = {
      {depth_keys_, depth_rows_, depth_turns_, depth_first_, 3, kGliderSensor, 0, 0},
      {time_keys_, time_rows_, time_turns_, time_first_, 2, kGliderMissionTime, 0, 0}};
  const uint16_t cases_[3] = {0, 1, 2};
  const uint32_t exact_[1] = {0b111};
  GliderGuardTable table_ = {columns_, cases_, exact_, nullptr, 2, 1, 0, 0};
  GliderContext* context_ = nullptr;
};

TEST_F(GuardTableTest, FindsTheFirstCaseThatIsTrue) {
  EXPECT_EQ(at(4, 4.9), 0u);
  EXPECT_EQ(at(8, 5), GLIDER_NO_CASE);
  EXPECT_EQ(at(12, 10), GLIDER_NO_CASE);
  EXPECT_EQ(at(16, 10.1), 1u);
  EXPECT_EQ(at(100, 7), 2u);
  EXPECT_EQ(at(104, 11), 1u);
}

TEST_F(GuardTableTest, UnknownIsAnIntervalOfItsOwn) {
  EXPECT_EQ(at(4, 1e9), GLIDER_NO_CASE);
  EXPECT_EQ(at(104, 1e9), 2u);
}

TEST_F(GuardTableTest, GoesOnFromACase) {
  EXPECT_EQ(at(104, 4, 0), 0u);
  EXPECT_EQ(at(108, 4, 1), 2u);
  EXPECT_EQ(at(112, 4, 0), 0u);
  EXPECT_EQ(at(116, 4, 3), GLIDER_NO_CASE);
}

TEST_F(GuardTableTest, LooksAtNoRowWhileNumbersStayInTheirIntervals) {
  EXPECT_EQ(at(4, 4), 0u);
  columns_[0].rows = time_rows_;  // other rows, which it must not see
  EXPECT_EQ(at(8, 3), 0u);
  EXPECT_EQ(context_->intervals[0], 3u) << "the answer is remembered";
}

TEST_F(GuardTableTest, AsksForWhatTheTableCannotSay) {
  const uint32_t some[1] = {0b101};
  table_.exact = some;
  table_.holds = [](const GliderContext* c, uint32_t number) -> uint32_t {
    return number == 1 && c->readings[0].value > 20 ? 1 : 0;
  };
  EXPECT_EQ(at(4, 15), GLIDER_NO_CASE);
  EXPECT_EQ(at(8, 21), 1u) << "within the same interval";
  EXPECT_EQ(at(12, 15), GLIDER_NO_CASE);
}

}  // namespace
}  // namespace glider::runtime::testing
