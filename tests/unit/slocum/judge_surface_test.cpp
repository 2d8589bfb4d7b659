// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The check of a vehicle that stays at the surface though a depth is commanded.

#include "tests/unit/slocum/good_flight.h"

namespace glider::slocum::oracles {
namespace {

/// A vehicle that stays at the surface under a commanded depth.
class JudgedAtSurface : public testing::Test {
 protected:
  std::string stay(double seconds, const std::function<void()>& each = [] {}) {
    hooks::Instruction in_force;
    in_force.vertical = hooks::HookVertical::Descend;
    in_force.depth_m = 40;
    std::string wrong;
    for (double passed = 0; passed < seconds && wrong.empty(); passed += kCycle) {
      now_ += kCycle;
      array_.beginCycle();
      depth_reading_m_ = 0.1 + 0.01 * (static_cast<int>(now_) % 3);
      ctd_bar_ = kNan;
      each();
      array_.set(GLIDER_M_DEPTH, depth_reading_m_);
      if (!std::isnan(ctd_bar_)) {
        array_.set(GLIDER_SCI_WATER_PRESSURE, ctd_bar_);
      }
      wrong = judge_.cycle({now_, hook_, 0.1, false, false, array_, now_, clearance_m_}, in_force);
    }
    return wrong;
  }
  static constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  JudgeSetup setup_ = GoodFlight::usual();
  SurfaceJudge judge_{setup_};
  SensorArray array_{shippedSetup("default").platform};
  HookState hook_ = HookState::Active;
  double now_ = 0, depth_reading_m_ = 0, ctd_bar_ = kNan, clearance_m_ = 100;
};

TEST_F(JudgedAtSurface, AStayWithoutAReasonIsSeen) {
  EXPECT_EQ(stay(4000), "at the surface for 1804 s though 40 m is commanded");
}

TEST_F(JudgedAtSurface, IsRightAfterAJumpOfTheDepthThatNoCtdRefutes) {
  EXPECT_EQ(stay(100), "");
  EXPECT_EQ(stay(12, [&] { depth_reading_m_ = 30; }), "");
  EXPECT_EQ(stay(9000), "");
  EXPECT_EQ(stay(100, [&] { ctd_bar_ = depth_reading_m_ / 10; }), "");
  EXPECT_NE(stay(4000), "") << "the CTD has agreed for a minute";
}

TEST_F(JudgedAtSurface, IsSeenAfterAJumpTooShortToCount) {
  EXPECT_EQ(stay(100), "");
  EXPECT_EQ(stay(8, [&] { depth_reading_m_ = 30; }), "");
  EXPECT_NE(stay(4000), "");
}

TEST_F(JudgedAtSurface, IsSeenAfterARestartOfHookbeh) {
  EXPECT_EQ(stay(12, [&] { depth_reading_m_ = 30; }), "");
  EXPECT_EQ(stay(100), "");
  judge_.restart();
  EXPECT_NE(stay(4000), "");
}

TEST_F(JudgedAtSurface, IsRightBetweenRareEchoesInTwentyEightMetres) {
  setup_.echo_every_s = 80;
  clearance_m_ = 28;
  EXPECT_EQ(stay(4000), "");
  clearance_m_ = 32;
  EXPECT_NE(stay(4000), "");
}

TEST_F(JudgedAtSurface, AStayWithAWrongDepthSensorIsNotAViolation) {
  setup_.faults.sensors.push_back({.name = "m_depth", .kind = SensorFault::Kind::Value});
  EXPECT_EQ(stay(4000, [&] { depth_reading_m_ = 0; }), "") << "it is right there by chance";
}

TEST_F(JudgedAtSurface, IsNotItsFaultUnderAnSbcThatLosesControlAgainAndAgain) {
  for (int i = 0; i < 300; ++i) {
    hook_ = HookState::Active;
    EXPECT_EQ(stay(28), "");
    hook_ = HookState::Silent;
    EXPECT_EQ(stay(4), "");
  }
}

}  // namespace
}  // namespace glider::slocum::oracles
