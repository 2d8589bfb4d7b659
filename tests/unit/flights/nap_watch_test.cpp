// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/nap_watch.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace glider::flights {
namespace {

/// An SBC that evaluates a tick of some mission time.
class NapWatched : public testing::Test {
 protected:
  NapWatched() {
    context_.depth = 50;
    context_.latitude = std::numeric_limits<double>::quiet_NaN();
  }
  void tick(double mission_time, double now_s) {
    context_.mission_time = mission_time;
    watch_.look(context_, now_s);
  }
  [[nodiscard]] double late() const { return watch_.latest() ? watch_.latest()->late_s : -1; }

  GliderContext context_{};
  NapWatch watch_;
};

TEST_F(NapWatched, ATickThatChangesNothingIsNeverLate) {
  tick(0, 8);
  tick(4, 12);
  tick(8, 250);
  EXPECT_FALSE(watch_.latest());
}

TEST_F(NapWatched, IsLateByWhatTheVehicleHasGoneOn) {
  tick(0, 8);
  context_.depth = 5;
  tick(4, 12);
  EXPECT_EQ(late(), 0);
  tick(100, 248);
  context_.depth = 50;
  tick(104, 248);
  EXPECT_EQ(late(), 136);
  EXPECT_EQ(watch_.latest()->vehicle_time, 248);
  context_.depth = 5;
  tick(240, 249);
  EXPECT_EQ(late(), 136) << "the latest counts";
}

TEST_F(NapWatched, AnyPartOfACommandAndTheStateCount) {
  tick(0, 0);
  double time = 0;
  const auto changes = [&](auto& part) {
    part += 1;
    time += 4;
    NapWatch before = watch_;
    tick(time, time + time);
    const bool found = late() == time;
    watch_ = before;
    part -= 1;
    return found;
  };
  EXPECT_TRUE(changes(context_.vertical));
  EXPECT_TRUE(changes(context_.lateral));
  EXPECT_TRUE(changes(context_.state));
  EXPECT_TRUE(changes(context_.stack_depth));
  EXPECT_TRUE(changes(context_.depth));
  EXPECT_TRUE(changes(context_.pitch));
  EXPECT_TRUE(changes(context_.magnetic));
  EXPECT_TRUE(changes(context_.longitude));
}

TEST_F(NapWatched, APollWithoutATickSaysNothing) {
  tick(0, 0);
  tick(4, 4);
  context_.depth = 5;
  tick(4, 200);
  EXPECT_FALSE(watch_.latest());
}

compiler::Optimised missionWith(const std::string& line) {
  const auto compilation = compiler::compileText("m.mission", "mission m\n" + line + R"(
state look
begin
  flightprofile yo(5 m, 50 m)
  sensors       missiontime, depth
  events
    case missiontime > 1 h exit
end
)");
  return compiler::optimise(compilation->checked);
}

/// 15 s to wake and to read, and a cycle.
TEST_F(NapWatched, MoreThanTheTimeToWakeIsTooLate) {
  using simulator::SensorFault;
  const compiler::Optimised sleeps = missionWith("nap at most 4 min");
  tick(0, 0);
  context_.depth = 5;
  tick(100, 119);
  EXPECT_FALSE(tooLate(watch_, sleeps, {}));
  context_.depth = 50;
  tick(200, 219.5);
  ASSERT_TRUE(tooLate(watch_, sleeps, {}));
  EXPECT_EQ(tooLate(watch_, sleeps, {})->late_s, 19.5);
  EXPECT_FALSE(tooLate(watch_, missionWith(""), {})) << "it never sleeps";
  const SensorFault depth{.name = "m_depth"}, cycles{.name = "m_cycle_number"};
  EXPECT_TRUE(tooLate(watch_, sleeps, std::vector{depth}));
  EXPECT_FALSE(tooLate(watch_, sleeps, std::vector{depth, cycles})) << "nothing is known";
}

}  // namespace
}  // namespace glider::flights
