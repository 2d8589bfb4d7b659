// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// When the plan of a back seat is started, and when it is left alone: runtime/imc/README.md.

#include "tests/unit/runtime/imc_packets.h"

#include <cmath>
#include <string>

namespace glider::runtime::imc {
namespace {

using namespace hooks::imc;
using testing::followState;
using testing::give;
using testing::kImcLimits;
using testing::planState;

/// A plan and what the vehicle says.
struct PlanBench {
  Plan plan{kImcLimits};
  double now_s = 1.7e9;

  void says(uint8_t state, const char* of = "glidercc") { give(planState(state, of), now_s, plan); }
  void follows(uint8_t state = FollowState::Goto, uint16_t of = kOwnAddress) {
    give(followState(state, of), now_s, plan);
  }
  [[nodiscard]] bool asks(double depth_m = 0.5) { return plan.asksForStart(now_s, depth_m); }
  /// From READY to References that are followed.
  void fly() {
    says(PlanState::Ready);
    ASSERT_TRUE(asks());
    now_s += 1;
    says(PlanState::Executing);
    follows(FollowState::Wait);
    ASSERT_TRUE(plan.follows());
  }
  /// Whether it asks within a minute in which the vehicle says READY once a second.
  [[nodiscard]] bool asksWithinAMinute(double depth_m) {
    bool asked = false;
    for (int second = 0; second < 60; ++second, now_s += 1) {
      says(PlanState::Ready);
      asked = asks(depth_m) || asked;
    }
    return asked;
  }
};

TEST(ImcPlan, StartsOnlyWhenTheVehicleIsReadyAndShallow) {
  PlanBench bench;
  EXPECT_FALSE(bench.asks()) << "nothing is known of the vehicle";
  bench.says(PlanState::Blocked);
  EXPECT_FALSE(bench.asks());
  bench.says(PlanState::Ready);
  EXPECT_FALSE(bench.asks(2.01));
  EXPECT_FALSE(bench.asks(std::nan(""))) << "nothing is known of its depth";
  bench.says(PlanState::Blocked);
  EXPECT_FALSE(bench.asks()) << "no longer ready";
  bench.says(PlanState::Ready);
  EXPECT_TRUE(bench.asks(2));
  EXPECT_FALSE(bench.plan.follows()) << "it was only asked";
}

TEST(ImcPlan, StartsAtMostOnceInSixSeconds) {
  PlanBench bench;
  bench.says(PlanState::Ready);
  int asked = 0;
  for (int tenths = 0; tenths < 600; ++tenths, bench.now_s += 0.1) {
    bench.says(PlanState::Ready);
    const bool asks = bench.asks();
    asked += asks ? 1 : 0;
    EXPECT_TRUE(!asks || tenths % 60 < 2 || tenths % 60 > 58 || asked > 1) << tenths;
  }
  EXPECT_GE(asked, 9);
  EXPECT_LE(asked, 10);
}

/// The parts of a vehicle give their packets times of their own, and some give none.
TEST(ImcPlan, APacketWithAnEarlierTimeDoesNotShortenTheSixSeconds) {
  for (const double time_s : {1.7e9 - 0.002, 1.7e9 - 59, 0.0, -1.0}) {
    PlanBench bench;
    bench.says(PlanState::Ready);
    ASSERT_TRUE(bench.asks());
    give(planState(PlanState::Ready), time_s, bench.plan);
    bench.now_s += 5.9;
    bench.says(PlanState::Ready);
    EXPECT_FALSE(bench.asks()) << time_s;
    bench.now_s += 0.2;
    EXPECT_TRUE(bench.asks()) << time_s;
  }
}

TEST(ImcPlan, StartsAfterTheClockWasSetBack) {
  PlanBench bench;
  bench.says(PlanState::Ready);
  ASSERT_TRUE(bench.asks());
  bench.now_s -= 3600;
  bench.says(PlanState::Ready);
  EXPECT_TRUE(bench.asks());
}

/// Between two packets with a time it is not a silence in which the plan could have timed out.
TEST(ImcPlan, APacketWithoutATimeIsNoTimeOut) {
  for (const double time_s : {0.0, -1.0}) {
    PlanBench bench;
    bench.fly();
    give(planState(PlanState::Executing), time_s, bench.plan);
    bench.now_s += 1;
    bench.says(PlanState::Ready);
    EXPECT_FALSE(bench.plan.wasLost()) << time_s;
  }
}

TEST(ImcPlan, NeverStartsWhileAnotherPlanFlies) {
  for (const uint8_t runs : {PlanState::Executing, PlanState::Initializing}) {
    for (const char* other : {"survey", "glidercc2", "glider", ""}) {
      PlanBench bench;
      bench.says(PlanState::Ready);
      bench.says(runs, other);
      EXPECT_TRUE(bench.plan.isTaken()) << other;
      EXPECT_FALSE(bench.asks()) << other;
      bench.now_s += 60;
      bench.says(runs, other);
      EXPECT_FALSE(bench.asks()) << other;
      bench.says(PlanState::Ready, other);
      EXPECT_TRUE(bench.asks()) << "it has ended, and we have not flown: " << other;
    }
  }
}

TEST(ImcPlan, FollowsOnlyWhenTheVehicleSaysSo) {
  PlanBench bench;
  bench.says(PlanState::Ready);
  ASSERT_TRUE(bench.asks());
  bench.follows();
  EXPECT_FALSE(bench.plan.follows()) << "of a plan that does not run";
  bench.says(PlanState::Initializing);
  EXPECT_FALSE(bench.plan.follows());
  bench.says(PlanState::Executing);
  bench.follows(FollowState::Goto, 0x4002);
  EXPECT_FALSE(bench.plan.follows()) << "the References of another";
  bench.follows();
  EXPECT_TRUE(bench.plan.follows());
}

TEST(ImcPlan, ReadyBetweenTheRequestAndItsExecutionIsNoEnd) {
  PlanBench bench;
  bench.says(PlanState::Ready);
  ASSERT_TRUE(bench.asks());
  for (int i = 0; i < 3; ++i) {
    bench.now_s += 0.3;
    bench.says(PlanState::Ready);
  }
  EXPECT_FALSE(bench.plan.isTaken());
  EXPECT_FALSE(bench.plan.wasLost());
  bench.says(PlanState::Executing);
  bench.follows();
  EXPECT_TRUE(bench.plan.follows());
}

TEST(ImcPlan, IsStartedAgainAtAnyDepthAfterATimeOut) {
  for (const double depth_m : {0.0, 2.5, 30.0, 50.0, std::nan("")}) {
    PlanBench bench;
    bench.fly();
    bench.now_s += 6;
    bench.follows(FollowState::Timeout);
    bench.says(PlanState::Ready);
    EXPECT_FALSE(bench.plan.follows());
    EXPECT_TRUE(bench.plan.wasLost());
    EXPECT_TRUE(bench.asks(depth_m)) << depth_m;
    EXPECT_FALSE(bench.asks(depth_m)) << "once";
  }
}

TEST(ImcPlan, ATimeOutThatWasNotHeardIsOneToo) {
  PlanBench bench;
  bench.fly();
  bench.now_s += 16;
  bench.says(PlanState::Ready);
  EXPECT_TRUE(bench.plan.wasLost());
  EXPECT_TRUE(bench.asks(30));
}

TEST(ImcPlan, IsNotStartedAgainAfterSomebodyHasStoppedIt) {
  PlanBench bench;
  bench.fly();
  for (int second = 0; second < 20; ++second) {
    bench.now_s += 1;
    bench.says(PlanState::Executing);
    bench.follows();
  }
  bench.now_s += 1;
  bench.says(PlanState::Ready);
  EXPECT_TRUE(bench.plan.isTaken());
  EXPECT_FALSE(bench.plan.wasLost());
  EXPECT_FALSE(bench.asksWithinAMinute(0.2));
}

TEST(ImcPlan, IsNotStartedAgainAfterAnotherPlanHasReplacedIt) {
  PlanBench bench;
  bench.fly();
  bench.now_s += 1;
  bench.says(PlanState::Executing, "survey");
  EXPECT_FALSE(bench.plan.follows());
  EXPECT_TRUE(bench.plan.isTaken());
  bench.now_s += 100;
  bench.says(PlanState::Executing, "survey");
  EXPECT_FALSE(bench.asksWithinAMinute(0.2));
}

TEST(ImcPlan, StoppedBeforeItsFirstStateIsNotLost) {
  PlanBench bench;
  bench.says(PlanState::Ready);
  ASSERT_TRUE(bench.asks());
  bench.now_s += 1;
  bench.says(PlanState::Executing);
  bench.now_s += 0.3;
  bench.says(PlanState::Ready);
  EXPECT_FALSE(bench.plan.wasLost()) << "no time-out can have been so early";
  bench.now_s += 10;
  EXPECT_FALSE(bench.asks(30));
}

TEST(ImcPlan, AnEndThatWeAskedForIsTheLast) {
  PlanBench bench;
  bench.fly();
  bench.plan.end();
  EXPECT_FALSE(bench.plan.isOver()) << "the vehicle still follows";
  bench.says(PlanState::Executing);
  bench.follows();
  EXPECT_FALSE(bench.plan.isOver());
  bench.says(PlanState::Ready);
  EXPECT_TRUE(bench.plan.isOver());
  EXPECT_FALSE(bench.plan.wasLost());
  EXPECT_FALSE(bench.asksWithinAMinute(0.2));
}

/// A Reference to a depth.
Reference referenceTo(double depth_m) {
  Reference reference;
  reference.speed = {.present = true, .value = {.value = 1.2}};
  reference.z = {.present = true, .value = {.value = static_cast<float>(depth_m)}};
  reference.lat = 0.72;
  reference.lon = -0.15;
  return reference;
}
/// The vehicle follows that Reference.
void echo(PlanBench& bench, double depth_m, uint16_t of = kOwnAddress) {
  FollowRefState said = followState(FollowState::Goto, of);
  said.reference = {.present = true, .value = referenceTo(depth_m)};
  give(said, bench.now_s, bench.plan);
}

TEST(ImcPlan, IsInDoubtAfterFiveSecondsWithoutAnAnswer) {
  PlanBench bench;
  EXPECT_FALSE(bench.plan.isInDoubt(bench.now_s));
  bench.fly();
  const double sent_s = bench.now_s;
  EXPECT_FALSE(bench.plan.isInDoubt(sent_s + 60)) << "nothing was sent that could be answered";
  bench.plan.noteReference(referenceTo(20), sent_s);
  EXPECT_FALSE(bench.plan.isInDoubt(sent_s + 5));
  EXPECT_TRUE(bench.plan.isInDoubt(sent_s + 5.1));
  bench.follows();
  EXPECT_TRUE(bench.plan.isInDoubt(sent_s + 5.1)) << "it follows none";
  echo(bench, 20, 0x4002);
  EXPECT_TRUE(bench.plan.isInDoubt(sent_s + 5.1)) << "what it says to another is ignored";
  echo(bench, 21);
  EXPECT_TRUE(bench.plan.isInDoubt(sent_s + 5.1)) << "another Reference";
  echo(bench, 20);
  EXPECT_FALSE(bench.plan.isInDoubt(sent_s + 600));
}

TEST(ImcPlan, AReferenceOfLongAgoIsNoAnswer) {
  PlanBench bench;
  bench.fly();
  bench.plan.noteReference(referenceTo(20), bench.now_s);
  echo(bench, 20);
  const double sent_s = bench.now_s;
  for (int second = 1; second <= 5; ++second) {
    bench.plan.noteReference(referenceTo(second < 5 ? 40 : 41), sent_s + second);
    echo(bench, 20);
  }
  EXPECT_FALSE(bench.plan.isInDoubt(sent_s + 6)) << "of the first that it does not follow";
  EXPECT_TRUE(bench.plan.isInDoubt(sent_s + 6.1));
  echo(bench, 40);
  EXPECT_FALSE(bench.plan.isInDoubt(sent_s + 10)) << "only the newest is not answered";
  EXPECT_TRUE(bench.plan.isInDoubt(sent_s + 10.1));
  for (int second = 6; second < 60; ++second) {
    bench.plan.noteReference(referenceTo(41), sent_s + second);
  }
  echo(bench, 20);
  EXPECT_TRUE(bench.plan.isInDoubt(sent_s + 60));
  echo(bench, 41);
  EXPECT_FALSE(bench.plan.isInDoubt(sent_s + 600));
}

TEST(ImcPlan, IsInDoubtWhenAStartIsNotAnswered) {
  const auto reply = [](PlanBench& bench, uint8_t type, uint16_t request) {
    PlanControl said;
    said.type = type;
    said.request_id = request;
    said.info = textOf("OK");
    give(said, bench.now_s, bench.plan);
  };
  for (const uint8_t type : {PlanControlType::Success, PlanControlType::Failure}) {
    PlanBench bench;
    bench.says(PlanState::Ready);
    ASSERT_TRUE(bench.asks());
    const uint16_t request = bench.plan.start().request_id;
    const double asked_s = bench.now_s;
    bench.now_s += 4;
    EXPECT_FALSE(bench.plan.isInDoubt(asked_s + 5));
    reply(bench, type, static_cast<uint16_t>(request + 1));
    reply(bench, PlanControlType::Request, request);
    EXPECT_TRUE(bench.plan.isInDoubt(asked_s + 5.1));
    reply(bench, type, request);
    EXPECT_FALSE(bench.plan.isInDoubt(asked_s + 600)) << int{type};
  }
}

TEST(ImcPlan, IsInDoubtWhenTheVehicleTimesOutAlthoughReferencesLeave) {
  for (const double since_s : {1.0, 16.0}) {
    PlanBench bench;
    bench.fly();
    bench.plan.noteReference(referenceTo(20), bench.now_s);
    echo(bench, 20);
    bench.now_s += since_s;
    bench.follows(FollowState::Timeout);
    EXPECT_EQ(bench.plan.isInDoubt(bench.now_s), since_s < 5);
    bench.plan.noteRenewal();
    EXPECT_FALSE(bench.plan.isInDoubt(bench.now_s));
  }
}

TEST(ImcPlan, WaitsTwiceAsLongAfterEachConnectionThatDidNotHelp) {
  PlanBench bench;
  bench.fly();
  double sent_s = bench.now_s;
  for (const double patience_s : {5.0, 10.0, 20.0, 40.0, 60.0, 60.0}) {
    bench.plan.noteReference(referenceTo(20), sent_s);
    EXPECT_FALSE(bench.plan.isInDoubt(sent_s + patience_s));
    EXPECT_TRUE(bench.plan.isInDoubt(sent_s + patience_s + 0.1));
    bench.plan.noteRenewal();
    EXPECT_FALSE(bench.plan.isInDoubt(sent_s + 600)) << "nothing was sent on the new one";
    sent_s += 100;
  }
  bench.plan.noteReference(referenceTo(20), sent_s);
  echo(bench, 20);
  bench.plan.noteReference(referenceTo(20), sent_s);
  EXPECT_TRUE(bench.plan.isInDoubt(sent_s + 5.1)) << "it has answered";
}

TEST(ImcPlan, WaitsNoLongerAfterAConnectionThatEndedByItself) {
  PlanBench bench;
  bench.fly();
  for (int times = 0; times < 3; ++times, bench.now_s += 100) {
    bench.plan.noteReference(referenceTo(20), bench.now_s);
    EXPECT_TRUE(bench.plan.isInDoubt(bench.now_s + 5.1)) << times;
    bench.plan.noteEndOfConnection();
    EXPECT_FALSE(bench.plan.isInDoubt(bench.now_s + 5.1)) << times;
  }
}

TEST(ImcPlan, TheRequestsSayWhatTheVehicleNeeds) {
  PlanBench bench;
  const PlanControl start = bench.plan.start();
  EXPECT_EQ(start.type, PlanControlType::Request);
  EXPECT_EQ(start.op, PlanOperation::Start);
  EXPECT_EQ(start.flags, 0);
  ASSERT_TRUE(start.arg.present);
  const PlanSpecification& plan = start.arg.value;
  EXPECT_TRUE(plan.plan_id == start.plan_id);
  ASSERT_TRUE(plan.maneuvers.present);
  EXPECT_TRUE(plan.start_man_id == plan.maneuvers.value.maneuver_id);
  ASSERT_TRUE(plan.maneuvers.value.data.present);
  const FollowReference& follow = plan.maneuvers.value.data.value;
  EXPECT_EQ(follow.control_src, kOwnAddress);
  EXPECT_EQ(follow.timeout, 15);
  EXPECT_EQ(follow.loiter_radius, 10);
  const PlanControl stop = bench.plan.stop();
  EXPECT_EQ(stop.type, PlanControlType::Request);
  EXPECT_EQ(stop.op, PlanOperation::Stop);
  EXPECT_TRUE(stop.plan_id == start.plan_id);
  EXPECT_NE(stop.request_id, start.request_id);
}

}  // namespace
}  // namespace glider::runtime::imc
