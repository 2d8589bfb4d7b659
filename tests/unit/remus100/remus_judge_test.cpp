// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// How the check of a flight reads the SBC's lines; what it checks is in lauv_judge_test.cpp.

#include "vehicles/remus100/remus_judge.h"

#include "platforms/load/load_platform.h"
#include "simulator/seat/sensor_array.h"
#include "tests/unit/remus100/sbc_lines.h"

#include <gtest/gtest.h>

namespace glider::remus100 {
namespace {

using glider::testing::lineOf;
using simulator::JudgeId;
using simulator::Verdict;

const platforms::Platform& remus() {
  static const auto platform =
      platforms::loadPlatform(GLIDER_SOURCE_DIR "/platforms/remus100.toml");
  return *platform;
}

/// A flight that is looked at each second.
struct JudgedFlight {
  RemusJudge judge{
      {.greatest_depth_m = 100, .overshoot_m = 4, .lets_go_s = 33, .turn_s = 40, .rises_m_s = 0.1}};
  simulator::SensorArray array{remus()};
  double now_s = 0;
  bool goes_on = true;

  template <typename Message>
  void says(const Message& message) {
    const std::string line = lineOf(message);
    judge.said({reinterpret_cast<const uint8_t*>(line.data()), line.size()}, now_s);
  }
  void goals(double depth_m) {
    says(hooks::recon::HeadingGoal{90});
    says(hooks::recon::SpeedGoal{1.5, hooks::recon::SpeedUnit::MetresPerSecond});
    says(hooks::recon::DepthGoal{depth_m});
  }
  void letGo() {
    goals(0);
    says(hooks::recon::Override{false});
  }
  void second(double depth_m) {
    now_s += 1;
    goes_on = judge.cycle({.time_s = now_s, .true_depth_m = depth_m, .array = array});
  }
  void follow(double told_m, double depth_m, int seconds) {
    for (int i = 0; i < seconds; ++i) {
      goals(told_m);
      second(depth_m);
    }
  }
  [[nodiscard]] bool violates(JudgeId id) const {
    const Verdict verdict = judge.verdict();
    return verdict.violations.size() == 1 && verdict.violations.front().judge == id;
  }
};

TEST(RemusJudge, AFlightToItsEndIsFine) {
  JudgedFlight flight;
  flight.follow(20, 23.9, 100);
  flight.follow(0, 0.5, 10);
  EXPECT_TRUE(flight.goes_on);
  flight.says(hooks::recon::Override{false});
  int seconds = 0;
  for (; flight.goes_on && seconds < 1000; ++seconds) {
    flight.second(0.2);
  }
  EXPECT_LE(seconds, 61);
  EXPECT_EQ(flight.judge.verdict().outcome, Verdict::Outcome::Exited);
  EXPECT_EQ(flight.judge.verdict().instructions, 110U);
}

TEST(RemusJudge, SeesGoalsThatAreTooDeepOrNotWhole) {
  JudgedFlight deep;
  deep.goals(100.1);
  EXPECT_TRUE(deep.violates(JudgeId::Commands));
  JudgedFlight alone;
  alone.goals(20);
  EXPECT_TRUE(alone.judge.verdict().violations.empty());
  alone.says(hooks::recon::SpeedGoal{1.5, hooks::recon::SpeedUnit::MetresPerSecond});
  alone.says(hooks::recon::DepthGoal{20});
  EXPECT_TRUE(alone.violates(JudgeId::Commands)) << "without a heading";
  JudgedFlight slow;
  slow.goals(20);
  slow.says(hooks::recon::HeadingGoal{90});
  slow.says(hooks::recon::DepthGoal{20});
  EXPECT_TRUE(slow.violates(JudgeId::Commands)) << "without a speed";
}

/// Goals of the surface are in force until the vehicle has ended the override.
TEST(RemusJudge, SeesAGoalUnderWaterAfterTheEnd) {
  JudgedFlight flight;
  flight.goals(20);
  flight.letGo();
  flight.letGo();
  EXPECT_TRUE(flight.judge.verdict().violations.empty());
  flight.goals(20);
  EXPECT_TRUE(flight.violates(JudgeId::Commands));
  JudgedFlight again;
  again.letGo();
  again.says(hooks::recon::Override{true});
  again.goals(20);
  again.letGo();
  again.says(hooks::recon::TimeQuery());  // another program
  again.goals(20);
  EXPECT_TRUE(again.judge.verdict().violations.empty());
}

/// A request may be lost: then the goals are in force.
TEST(RemusJudge, SeesAnEndWithoutGoalsOfTheSurface) {
  JudgedFlight none;
  none.goals(20);
  none.says(hooks::recon::Override{false});
  EXPECT_TRUE(none.violates(JudgeId::Commands));
  JudgedFlight once;
  once.goals(0);
  once.says(hooks::recon::Override{false});
  EXPECT_TRUE(once.judge.verdict().violations.empty());
  once.says(hooks::recon::Override{false});
  EXPECT_TRUE(once.violates(JudgeId::Commands)) << "each time: the goals may be what is lost";
}

TEST(RemusJudge, SeesGoalsOfTheSurfaceThatAreNotObeyed) {
  JudgedFlight flight;
  flight.follow(20, 20, 100);
  flight.follow(0, 20, 110);
  EXPECT_TRUE(flight.judge.verdict().violations.empty()) << "by then it need not be higher";
  flight.follow(0, 20, 10);
  EXPECT_TRUE(flight.violates(JudgeId::Ascent));
  JudgedFlight after_the_end;
  after_the_end.follow(20, 20, 100);
  for (int second = 0; second < 120; ++second) {
    after_the_end.letGo();
    after_the_end.second(20);
  }
  EXPECT_TRUE(after_the_end.violates(JudgeId::Ascent));
}

TEST(RemusJudge, SeesAVehicleThatIsTooDeepOrDoesNotComeUp) {
  JudgedFlight deep;
  deep.follow(20, 24.1, 1);
  EXPECT_TRUE(deep.violates(JudgeId::Depth));
  JudgedFlight stays;
  stays.follow(20, 20, 10);
  for (int silent_s = 0; silent_s < 200; ++silent_s) {
    stays.second(20);
  }
  EXPECT_TRUE(stays.violates(JudgeId::Ascent));
  EXPECT_EQ(stays.judge.verdict().releases, 1U);
}

}  // namespace
}  // namespace glider::remus100
