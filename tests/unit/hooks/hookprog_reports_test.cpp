// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/unit/hooks/hookprog_bench.h"

#include <cmath>
#include <limits>

namespace glider::hooks {
namespace {

using Type = MessageType;
using Kind = SeatEvent::Kind;

class HookprogReportsTest : public HookprogBench {};

TEST_F(HookprogReportsTest, ATickHasTheSubscribedSensorsThatAreFresh) {
  hello();
  atSbc();
  science_[GLIDER_SCI_WATER_TEMP] = 17.5;
  cycle({{GLIDER_M_DEPTH, 12.5},
         {GLIDER_M_ROLL, 0.1},
         {GLIDER_X_HOOK_STATE, 3},
         {GLIDER_X_HOOK_SEQUENCE, 9},
         {GLIDER_X_HOOK_ANSWER, 1},
         {GLIDER_X_HOOK_SESSION, 4}});
  TickHead head;
  TickReadings readings = tick(subscription(), &head);
  EXPECT_EQ(head.vehicle_time_s, 4);
  EXPECT_EQ(head.cycle, 1U);
  EXPECT_EQ(head.hook_state, HookState::Active);
  EXPECT_EQ(head.answer, HookAnswer::Accepted);
  EXPECT_EQ(head.answered_sequence, 9);
  EXPECT_EQ(head.session, 4U);
  EXPECT_EQ(head.subscription, subscriptionCheck(subscription()));
  EXPECT_EQ(readings.told[0], ReadingReport::Value);
  EXPECT_EQ(readings.values[0], 12.5);
  EXPECT_EQ(readings.told[1], ReadingReport::Value);
  EXPECT_EQ(readings.values[1], 17.5);
  EXPECT_EQ(readings.told[2], ReadingReport::Nothing) << "never reported";
  cycle();
  readings = tick(subscription());
  EXPECT_EQ(readings.told[0], ReadingReport::Nothing) << "nothing was reported again";
  EXPECT_EQ(readings.told[1], ReadingReport::Nothing);
}

TEST_F(HookprogReportsTest, OneTickACycleHoweverOftenItRuns) {
  hello();
  atSbc();
  cycle();
  run();
  run();
  EXPECT_EQ(atSbc().size(), 1U);
}

TEST_F(HookprogReportsTest, ATickNeedsANewTimeAndCycle) {
  hello();
  atSbc();
  const std::vector<SensorUpdate> only_cycle = {{GLIDER_M_CYCLE_NUMBER, 5}};
  line_.fromFlight(only_cycle);
  run();
  run();
  EXPECT_TRUE(atSbc().empty()) << "the time was lost";
}

TEST_F(HookprogReportsTest, OnlyWhatTheSbcDoesNotHoldIsSentOnceItHasAnswered) {
  hello();
  atSbc();
  cycle({{GLIDER_M_DEPTH, 12.5}, {GLIDER_M_PITCH, 0.1}});
  EXPECT_EQ(tick(subscription()).told[0], ReadingReport::Value);
  answerTick();
  cycle({{GLIDER_M_DEPTH, 12.5}, {GLIDER_M_PITCH, 0.2}});
  const TickReadings readings = tick(subscription());
  EXPECT_EQ(readings.told[0], ReadingReport::Unchanged);
  EXPECT_EQ(readings.told[2], ReadingReport::Value);
  EXPECT_EQ(readings.values[2], static_cast<double>(0.2F));
}

TEST_F(HookprogReportsTest, AValueWhoseTickWasNotAnsweredIsSentAgain) {
  hello();
  atSbc();
  cycle({{GLIDER_M_DEPTH, 12.5}});
  tick(subscription());
  answerTick();
  cycle({{GLIDER_M_DEPTH, 14}});
  EXPECT_EQ(tick(subscription()).told[0], ReadingReport::Value);
  cycle({{GLIDER_M_DEPTH, 12.5}});  // as before the lost one: the SBC may have received that
  EXPECT_EQ(tick(subscription()).told[0], ReadingReport::Value);
  cycle({{GLIDER_M_DEPTH, 12.5}});
  EXPECT_EQ(tick(subscription()).told[0], ReadingReport::Value);
  answerTick();
  cycle({{GLIDER_M_DEPTH, 12.5}});
  EXPECT_EQ(tick(subscription()).told[0], ReadingReport::Unchanged);
}

TEST_F(HookprogReportsTest, ALateAnswerConfirmsWhatItsTickSaidUnlessAnotherValueWentSince) {
  hello();
  atSbc();
  cycle({{GLIDER_M_DEPTH, 12.5}, {GLIDER_M_PITCH, 0.1}});
  tick(subscription());
  const uint8_t first = tick_sequence_;
  cycle({{GLIDER_M_DEPTH, 12.5}, {GLIDER_M_PITCH, 0.2}});
  tick(subscription());
  cycle({{GLIDER_M_DEPTH, 12.5}, {GLIDER_M_PITCH, 0.1}});
  tick(subscription());
  tick_sequence_ = first;
  answerTick();
  cycle({{GLIDER_M_DEPTH, 12.5}, {GLIDER_M_PITCH, 0.1}});
  const TickReadings readings = tick(subscription());
  EXPECT_EQ(readings.told[0], ReadingReport::Unchanged);
  EXPECT_EQ(readings.told[2], ReadingReport::Value) << "the SBC may hold 0.2";
}

TEST_F(HookprogReportsTest, AnAnswerToWhatIsNotATickConfirmsNothing) {
  hello();
  atSbc();
  cycle({{GLIDER_M_DEPTH, 12.5}});
  tick(subscription());
  ++tick_sequence_;
  answerTick();
  cycle({{GLIDER_M_DEPTH, 12.5}});
  EXPECT_EQ(tick(subscription()).told[0], ReadingReport::Value);
}

TEST_F(HookprogReportsTest, AnAnswerThatComesAgainConfirmsNothing) {
  hello();
  atSbc();
  cycle({{GLIDER_M_PITCH, 0.1}});
  tick(subscription());
  answerTick();
  cycle({{GLIDER_M_DEPTH, 12.5}});
  tick(subscription());  // is lost
  // An answer of 256 frames ago has the same number.
  say(Done{tick_sequence_, 0, {now_ - 4, 0, 0, MissionPhase::Flying}});
  run();
  cycle({{GLIDER_M_DEPTH, 12.5}});
  EXPECT_EQ(tick(subscription()).told[0], ReadingReport::Value);
}

TEST_F(HookprogReportsTest, AReportThatComesAgainIsNotATick) {
  hello();
  atSbc();
  for (int i = 0; i < 10; ++i) {
    cycle({{GLIDER_M_DEPTH, 10.0 + i}});
  }
  atSbc();
  events();
  const double newest = cycle_;
  cycle_ = 4;
  cycle({{GLIDER_M_DEPTH, 14}});
  EXPECT_TRUE(atSbc().empty());
  EXPECT_EQ(events(), (std::vector{SeatEvent::Kind::StaleFrame}));
  cycle_ = newest;
  cycle({{GLIDER_M_PITCH, 0.1}});
  EXPECT_EQ(tick(subscription()).told[0], ReadingReport::Nothing)
      << "nor is its depth a later one's";
}

TEST_F(HookprogReportsTest, AVehicleThatCountsFromTheStartIsFollowedFromItsSecondReport) {
  hello();
  atSbc();
  cycle_ = 1000;
  cycle();
  atSbc();
  cycle_ = 0;
  cycle();
  EXPECT_TRUE(atSbc().empty());
  for (int i = 0; i < 3; ++i) {
    cycle();
    EXPECT_EQ(atSbc().size(), 1U) << i;
  }
}

TEST_F(HookprogReportsTest, ANewSubscriptionOrLinkStartsWithNothingHeld) {
  hello();
  atSbc();
  for (int i = 0; i < 2; ++i) {
    cycle({{GLIDER_M_DEPTH, 12.5}});
    EXPECT_EQ(tick(subscription()).told[0], ReadingReport::Value);
    say(subscription());
    answerTick();
    cycle({{GLIDER_M_DEPTH, 12.5}});
    EXPECT_EQ(tick(subscription()).told[0], ReadingReport::Value)
        << "the answer came after the subscription";
    answerTick();
    cycle({{GLIDER_M_DEPTH, 12.5}});
    EXPECT_EQ(tick(subscription()).told[0], ReadingReport::Unchanged);
    hello(8);
    atSbc();
  }
}

TEST_F(HookprogReportsTest, EachValueIsSentAgainAfterSixteenTicks) {
  hello();
  atSbc();
  int last = 0;
  for (int i = 0; i < 100; ++i) {
    cycle({{GLIDER_M_DEPTH, 12.5}});
    if (tick(subscription()).told[0] == ReadingReport::Value) {
      EXPECT_EQ(i - last, i == 0 ? 0 : 16);
      last = i;
    }
    answerTick();
  }
  EXPECT_GT(last, 80);
}

TEST_F(HookprogReportsTest, ADeadBandHoldsSmallChangesBackButNotTheirSum) {
  hello();
  const Subscribe wanted{2, {{GLIDER_M_DEPTH, 1, 0.5F}, {GLIDER_M_PITCH, 1, 0.5F}}};
  say(wanted);
  run();
  atSbc();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  struct Row {
    double depth;
    ReadingReport told;
  };
  for (const Row& row : {Row{10, ReadingReport::Value}, Row{10.25, ReadingReport::Unchanged},
                         Row{9.5, ReadingReport::Unchanged}, Row{10.5, ReadingReport::Unchanged},
                         Row{10.75, ReadingReport::Value}, Row{10.25, ReadingReport::Unchanged},
                         Row{nan, ReadingReport::Value}, Row{nan, ReadingReport::Unchanged},
                         Row{10.75, ReadingReport::Value}}) {
    cycle({{GLIDER_M_DEPTH, row.depth}});
    EXPECT_EQ(tick(wanted).told[0], row.told) << row.depth;
    answerTick();
  }
}

TEST_F(HookprogReportsTest, WithoutADeadBandEveryBitIsAChange) {
  hello();
  atSbc();
  for (const double depth : {0.0, -0.0, 1e-40, 0.0}) {
    cycle({{GLIDER_M_DEPTH, depth}});
    EXPECT_EQ(tick(subscription()).told[0], ReadingReport::Value) << depth;
    answerTick();
  }
}

TEST_F(HookprogReportsTest, ARateIsKeptButALostTickIsMadeUpForAtOnce) {
  hello();
  const Subscribe wanted{1, {{GLIDER_M_DEPTH, 3, 0}}};
  say(wanted);
  run();
  atSbc();
  double depth = 0;
  const auto told = [&](bool answer) {
    cycle({{GLIDER_M_DEPTH, ++depth}});
    const ReadingReport one = tick(wanted).told[0];
    if (answer) {
      answerTick();
    }
    return one;
  };
  for (int i = 0; i < 9; ++i) {
    EXPECT_EQ(told(true), i % 3 == 0 ? ReadingReport::Value : ReadingReport::Nothing) << i;
  }
  EXPECT_EQ(told(false), ReadingReport::Value);
  EXPECT_EQ(told(true), ReadingReport::Value) << "the one before was not answered";
  EXPECT_EQ(told(true), ReadingReport::Nothing);
}

TEST_F(HookprogReportsTest, SixtyFourReadingsGoInOneFrame) {
  hello();
  Subscribe wanted;
  for (uint16_t i = 0; i < kMostSubscriptions; ++i) {
    wanted.sensors[wanted.count++] = {GLIDER_M_LAT, 1, 0};
  }
  say(wanted);
  run();
  atSbc();
  cycle({{GLIDER_M_LAT, 3910}});
  const TickReadings readings = tick(wanted);
  for (const ReadingReport told : readings.told) {
    EXPECT_EQ(told, ReadingReport::Value);
  }
}

}  // namespace
}  // namespace glider::hooks
