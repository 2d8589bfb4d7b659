// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What hookprog takes for what, at the very edges.

#include "tests/slocum.h"
#include "tests/unit/hooks/hookprog_bench.h"

#include <limits>

namespace glider::hooks {
namespace {

using Type = MessageType;
using Kind = SeatEvent::Kind;

class HookprogEdgesTest : public HookprogBench {
 protected:
  static constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

  /// The flight controller reports this and no more.
  void report(const std::vector<SensorUpdate>& values) {
    line_.fromFlight(values);
    run(0);
    run();
  }
  /// What goes to the flight controller, the next run's included.
  std::vector<SensorUpdate> atFlightSoon() {
    run();
    return atFlight();
  }
  uint32_t newestSession() {
    atSbc();
    hello(++link_);
    Welcome welcome;
    EXPECT_TRUE(decode(atSbc().at(0), welcome));
    return welcome.newest_session;
  }
  uint32_t link_ = 7;
};

TEST_F(HookprogEdgesTest, ItsNumbersBeginAtTheTimeOfTheClock) {
  for (const auto& [now, first] : {std::pair{1.7e9, 1'700'000'001U},
                                   {0.0, 1U},
                                   {4294967294.0, 4294967295U},
                                   {4294967296.0, 4294967295U},
                                   {-7.0, 0U}}) {
    Hookprog fresh{gliderDictionary, SeatOptions{true}};
    hookprog_ = fresh;
    now_ = now + 1;
    atSbc();
    cycle();
    const auto frames = atSbc();
    ASSERT_EQ(frames.size(), 1U) << now;
    EXPECT_EQ(frames[0].sequence, static_cast<uint8_t>(first % kMostSession + 1)) << now;
  }
}

TEST_F(HookprogEdgesTest, ACycleIsATimeAndAnotherCycleNumber) {
  hello();
  cycle();
  atSbc();
  events();
  report({{GLIDER_M_PRESENT_SECS_INTO_MISSION, 8}, {GLIDER_M_DEPTH, 3}});
  EXPECT_TRUE(atSbc().empty()) << "no cycle number";
  report({{GLIDER_M_PRESENT_SECS_INTO_MISSION, 12}, {GLIDER_M_CYCLE_NUMBER, 1}});
  EXPECT_TRUE(atSbc().empty()) << "the same";
  report({{GLIDER_M_PRESENT_SECS_INTO_MISSION, 12}, {GLIDER_M_CYCLE_NUMBER, kNan}});
  EXPECT_TRUE(atSbc().empty()) << "none";
  EXPECT_TRUE(events().empty());
  report({{GLIDER_M_PRESENT_SECS_INTO_MISSION, kNan}, {GLIDER_M_CYCLE_NUMBER, 2}});
  EXPECT_TRUE(atSbc().empty()) << "no time";
  report({{GLIDER_M_PRESENT_SECS_INTO_MISSION, 16}, {GLIDER_M_CYCLE_NUMBER, 3}});
  EXPECT_EQ(atSbc().size(), 1U);
}

TEST_F(HookprogEdgesTest, AnotherVersionAloneIsRefusedAndEachIsReportedOnce) {
  Hello stranger;
  stranger.dictionary = gliderDictionary.hash;
  stranger.link = 7;
  stranger.version = kProtocolVersion + 1;
  for (const int told : {1, 0}) {
    say(stranger);
    run();
    EXPECT_EQ(events().size(), static_cast<size_t>(told));
  }
  stranger.version = kProtocolVersion + 2;
  say(stranger);
  run();
  EXPECT_EQ(events().size(), 1U) << "another version";
  stranger.version = kProtocolVersion;
  for (const uint32_t dictionary : {1U, 2U}) {
    stranger.dictionary = dictionary;
    for (const int told : {1, 0}) {
      say(stranger);
      run();
      EXPECT_EQ(events().size(), static_cast<size_t>(told)) << dictionary;
    }
    EXPECT_EQ(last_event_.a, kProtocolVersion);
    EXPECT_EQ(last_event_.b, dictionary);
  }
  cycle();
  EXPECT_EQ(typesOf(atSbc()), (std::vector{Type::Beacon})) << "no link";
}

TEST_F(HookprogEdgesTest, AStrangerIsReportedAgainAfterALink) {
  Hello other_version, other_dictionary;
  other_version.version = kProtocolVersion + 1;
  other_version.link = other_dictionary.link = 9;
  other_dictionary.dictionary = gliderDictionary.hash + 1;
  for (const Hello& stranger : {other_version, other_dictionary}) {
    for (int i = 0; i < 2; ++i) {
      events();
      say(stranger);
      run();
      EXPECT_EQ(events(), (std::vector{Kind::SbcRefused})) << i;
      hello();
    }
  }
}

TEST_F(HookprogEdgesTest, WhatNoSbcSendsIsBadAndEachIsReportedOnce) {
  hello();
  events();
  for (int i = 0; i < 2; ++i) {
    say(Beacon{});
    run();
    EXPECT_EQ(events(), (std::vector{Kind::BadFrame})) << "not from an SBC";
    EXPECT_EQ(last_event_.a, 1U);
  }
  Frame frame;
  encode(answered(), frame);
  ++frame.size;
  frame.sequence = ++said_;
  put(sbc_line_.right(), frame);
  run();
  EXPECT_EQ(events(), (std::vector{Kind::BadFrame})) << "too long by a byte";
  EXPECT_EQ(last_event_.a, 1U);
}

TEST_F(HookprogEdgesTest, TakesSixtyFourFramesInARunAndAllThatTheVehicleReports) {
  hello();
  atSbc();
  events();
  for (int i = 0; i < 65; ++i) {
    say(Beacon{});
  }
  run();
  EXPECT_EQ(events(), (std::vector{Kind::BadFrame}));
  EXPECT_EQ(last_event_.a, 64U);
  run();
  EXPECT_EQ(events(), (std::vector{Kind::BadFrame}));
  EXPECT_EQ(last_event_.a, 1U);
  cycle(std::vector<SensorUpdate>(40, {GLIDER_M_DEPTH, 12.5}));
  EXPECT_EQ(atSbc().size(), 1U) << "in the same cycle";
}

TEST_F(HookprogEdgesTest, ACycleIsCompleteWhenNothingOfItHasComeForASecond) {
  hello();
  atSbc();
  line_.fromFlight({{GLIDER_M_CYCLE_NUMBER, 1}, {GLIDER_M_PRESENT_SECS_INTO_MISSION, 4}});
  run(0.5);
  EXPECT_TRUE(atSbc().empty()) << "there may be more";
  line_.fromFlight({{GLIDER_M_DEPTH, 12.5}});
  run(0.75);
  run(0.5);
  EXPECT_TRUE(atSbc().empty());
  run(0.5);
  EXPECT_EQ(tick(subscription()).values[0], 12.5) << "in the tick of its own cycle";
}

TEST_F(HookprogEdgesTest, AFlightControllerThatNeverPausesHasItsCycleAfterThreeSeconds) {
  hello();
  atSbc();
  line_.fromFlight({{GLIDER_M_CYCLE_NUMBER, 1}, {GLIDER_M_PRESENT_SECS_INTO_MISSION, 4}});
  run(0.5);
  for (int i = 0; i < 5; ++i) {
    line_.fromFlight({{GLIDER_M_DEPTH, 1.0 * i}});
    EXPECT_TRUE(atSbc().empty()) << i;
    run(0.5);
  }
  EXPECT_TRUE(atSbc().empty());
  line_.fromFlight({{GLIDER_M_DEPTH, 9}});
  run(0.5);
  EXPECT_EQ(atSbc().size(), 1U);
}

TEST_F(HookprogEdgesTest, TheClockIsSentIfItIsValid) {
  hello();
  for (const auto& [clock, told] : {std::pair{0.5, 0U},
                                    {1.0, 1U},
                                    {1.7e9, 1'700'000'000U},
                                    {4294967294.0, 4294967294U},
                                    {4294967295.0, 0U},
                                    {4294967296.0, 0U},
                                    {-1.0, 0U},
                                    {kNan, 0U}}) {
    atSbc();
    cycle({{GLIDER_M_PRESENT_TIME, clock}});
    TickHead head;
    tick(subscription(), &head);
    EXPECT_EQ(head.clock_s, told) << clock;
    answerTick();
  }
}

TEST_F(HookprogEdgesTest, WhatHookbehReportsIsSentIfItIsValid) {
  hello();
  struct Row {
    double state, answer, session;
    HookState told_state;
    HookAnswer told_answer;
    uint32_t told_session;
  };
  const auto complete = static_cast<double>(HookState::Complete);
  for (const Row& row :
       {Row{complete, 1, 16777215, HookState::Complete, HookAnswer::Accepted, 16777215},
        Row{complete + 1, 257, 16777216, HookState::Absent, HookAnswer::None, 0},
        Row{1, 255, 0, HookState::Waiting, HookAnswer::None, 0}}) {
    atSbc();
    cycle({{GLIDER_X_HOOK_STATE, row.state},
           {GLIDER_X_HOOK_SEQUENCE, 5},
           {GLIDER_X_HOOK_ANSWER, row.answer},
           {GLIDER_X_HOOK_SESSION, row.session}});
    TickHead head;
    tick(subscription(), &head);
    EXPECT_EQ(head.hook_state, row.told_state);
    EXPECT_EQ(head.answer, row.told_answer);
    EXPECT_EQ(head.session, row.told_session);
    answerTick();
  }
}

TEST_F(HookprogEdgesTest, ASessionIsANumberOfASession) {
  cycle({{GLIDER_X_HOOK_STATE, 3}});
  hello();
  for (const auto& [session, newest] : {std::pair{1.0, 1U},
                                        {-1.0, 1U},
                                        {0.0, 1U},
                                        {kNan, 1U},
                                        {2.0, 2U},
                                        {8388608.0, 8388608U},
                                        {16777214.0, 16777214U},
                                        {0.0, 16777214U},
                                        {16777215.0, 16777215U},
                                        {16777216.0, 16777215U}}) {
    write({{GLIDER_SCI_HOOK_SESSION, session}, {GLIDER_SCI_HOOK_SEQUENCE, 3}});
    run();
    EXPECT_EQ(newestSession(), newest) << session;
  }
}

TEST_F(HookprogEdgesTest, TheTimeOfASessionGoesOnByLessThanASecondToo) {
  cycle({{GLIDER_X_HOOK_STATE, 3}, {GLIDER_X_HOOK_SESSION, 4}});
  hello();
  for (const double time : {100.0, 100.5}) {
    atFlight();
    say(answered(4, time));
    EXPECT_EQ(atFlightSoon().size(), 1U) << time;
  }
}

TEST_F(HookprogEdgesTest, WithoutAnSbcInControlNoneIsStuckAndOneWithoutASessionLives) {
  cycle({{GLIDER_X_HOOK_STATE, 3}, {GLIDER_X_HOOK_SESSION, 0}});
  hello();
  events();
  atFlight();
  for (int i = 0; i < 30; ++i) {
    say(answered(4, 100));
    run();
    EXPECT_TRUE(events().empty()) << i;
  }
  for (int i = 0; i < 3; ++i) {
    atFlight();
    say(answered(0, 100));
    EXPECT_EQ(atFlightSoon().size(), 1U) << i;
  }
}

TEST_F(HookprogEdgesTest, EachOldInstructionIsReportedOnce) {
  cycle({{GLIDER_X_HOOK_STATE, 3}, {GLIDER_X_HOOK_SEQUENCE, 3}, {GLIDER_X_HOOK_ANSWER, 9}});
  EXPECT_EQ(events(), (std::vector{Kind::OldInstruction}));
  EXPECT_EQ(last_event_.a, 3U);
  cycle({{GLIDER_X_HOOK_SEQUENCE, 4}});
  cycle({{GLIDER_X_HOOK_ANSWER, 1}});
  EXPECT_TRUE(events().empty()) << "of number and answer one was lost";
  cycle({{GLIDER_X_HOOK_SEQUENCE, 4}, {GLIDER_X_HOOK_ANSWER, 9}});
  EXPECT_EQ(events(), (std::vector{Kind::OldInstruction}));
  EXPECT_EQ(last_event_.a, 4U);
  cycle({{GLIDER_X_HOOK_SEQUENCE, 4}, {GLIDER_X_HOOK_ANSWER, 1}});
  EXPECT_TRUE(events().empty()) << "accepted";
  cycle({{GLIDER_X_HOOK_SEQUENCE, 4}, {GLIDER_X_HOOK_ANSWER, 9}});
  EXPECT_EQ(events(), (std::vector{Kind::OldInstruction})) << "and old again";
}

/// Of the cycles without a report of hookbeh after the one given, in how many it is still there.
class HookprogForgetsTest : public HookprogEdgesTest {
 protected:
  int rememberedAfter(double time, double cycle_number) {
    for (int i = 0; i < 10; ++i) {
      cycle({{GLIDER_X_HOOK_STATE, 3}});
    }
    report({{GLIDER_M_PRESENT_SECS_INTO_MISSION, time}, {GLIDER_M_CYCLE_NUMBER, cycle_number}});
    cycle_ = 20;
    int cycles = 0;
    for (; cycles < 20; ++cycles) {
      atSbc();
      cycle();
      Beacon beacon;
      EXPECT_TRUE(decode(atSbc().at(0), beacon));
      if (beacon.hook_state == HookState::Absent) {
        break;
      }
    }
    return cycles;
  }
};

TEST_F(HookprogForgetsTest, HookbehIsAbsentAfterSixCyclesWithoutAReport) {
  EXPECT_EQ(rememberedAfter(44, 11), 4);
}
TEST_F(HookprogForgetsTest, ALowerCycleNumberAloneDoesNotShortenThat) {
  EXPECT_EQ(rememberedAfter(44, 9), 4);
}
TEST_F(HookprogForgetsTest, ALowerCycleNumberAtTheSameTimeDoesNotShortenThat) {
  EXPECT_EQ(rememberedAfter(40, 9), 4);
}
TEST_F(HookprogForgetsTest, AnEarlierTimeAloneDoesNotShortenThat) {
  EXPECT_EQ(rememberedAfter(36, 11), 4);
}
TEST_F(HookprogForgetsTest, WithBothTurnedBackHookbehIsAbsentAfterTwoCycles) {
  EXPECT_EQ(rememberedAfter(36, 9), 0);
}

TEST_F(HookprogForgetsTest, ACycleNumberThatReturnsToItsValueDoesNotShortenThat) {
  for (int i = 0; i < 10; ++i) {
    cycle({{GLIDER_X_HOOK_STATE, 3}});
  }
  report({{GLIDER_M_CYCLE_NUMBER, 11},
          {GLIDER_M_PRESENT_SECS_INTO_MISSION, 3},
          {GLIDER_M_CYCLE_NUMBER, 10}});
  for (int i = 0; i < 4; ++i) {
    atSbc();
    cycle();
    Beacon beacon;
    ASSERT_TRUE(decode(atSbc().at(0), beacon));
    EXPECT_EQ(beacon.hook_state, HookState::Active) << i;
  }
}

TEST_F(HookprogEdgesTest, ALateAnswerLeavesLessOfARate) {
  hello();
  const Subscribe wanted{1, {{GLIDER_M_DEPTH, 5, 0}}};
  say(wanted);
  run();
  atSbc();
  double depth = 0;
  const auto told = [&] {
    cycle({{GLIDER_M_DEPTH, ++depth}});
    return tick(wanted).told[0];
  };
  EXPECT_EQ(told(), ReadingReport::Value);
  const uint8_t first = tick_sequence_;
  EXPECT_EQ(told(), ReadingReport::Value) << "not answered";
  tick_sequence_ = first;
  answerTick();
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(told(), ReadingReport::Nothing) << i;
  }
  EXPECT_EQ(told(), ReadingReport::Value) << "five after the first";
}

TEST_F(HookprogEdgesTest, AnAnswerCountsForTheEightNewestTicks) {
  for (const bool counts : {true, false}) {
    hello(++link_);
    atSbc();
    cycle({{GLIDER_M_DEPTH, 12.5}});
    EXPECT_EQ(tick(subscription()).told[0], ReadingReport::Value);
    const uint8_t first = tick_sequence_;
    for (int i = 0; i < (counts ? 7 : 8); ++i) {
      cycle();
      atSbc();
    }
    tick_sequence_ = first;
    answerTick();
    cycle({{GLIDER_M_DEPTH, 12.5}});
    EXPECT_EQ(tick(subscription()).told[0] == ReadingReport::Unchanged, counts);
    answerTick();
  }
}

TEST(Hookprog, AsksOnlyForSensorsOfTheVehicle) {
  std::vector<uint32_t> roles(gliderDictionary.roles, gliderDictionary.roles + kGliderRoleCount);
  roles[kGliderRoleWaterPressure] = GLIDER_NO_SENSOR;
  GliderDictionary without_ctd = gliderDictionary;
  without_ctd.roles = roles.data();
  Hookprog hookprog(without_ctd);
  MemoryLine sbc;
  uint16_t greatest = 0;
  const ScienceMemory memory{&greatest,
                             [](void* self, uint16_t id, bool* fresh) {
                               auto& most = *static_cast<uint16_t*>(self);
                               most = std::max(most, id);
                               *fresh = true;
                               return 1.0;
                             },
                             [](void*, uint16_t, double) {}};
  for (int i = 1; i < 9; ++i) {
    hookprog.run(i, memory, sbc.left());
  }
  EXPECT_LT(greatest, without_ctd.count);
}

TEST(HookprogWatches, CyclesWrapAroundAndTwoInSequenceBegin) {
  HookprogCycleWatch half;
  EXPECT_TRUE(hookprogCycleIsNext(&half, 1));
  EXPECT_TRUE(hookprogCycleIsNext(&half, 1 + 0x7FFFFF)) << "half of the round";
  HookprogCycleWatch more;
  EXPECT_TRUE(hookprogCycleIsNext(&more, 1));
  EXPECT_FALSE(hookprogCycleIsNext(&more, 1 + 0x800000));
  for (const uint32_t lost : {8U, 9U}) {
    HookprogCycleWatch watch;
    EXPECT_TRUE(hookprogCycleIsNext(&watch, 1000));
    EXPECT_FALSE(hookprogCycleIsNext(&watch, 500));
    EXPECT_EQ(hookprogCycleIsNext(&watch, 500 + lost), lost == 8) << lost;
  }
  HookprogCycleWatch again;
  EXPECT_TRUE(hookprogCycleIsNext(&again, 1000));
  EXPECT_FALSE(hookprogCycleIsNext(&again, 500));
  EXPECT_FALSE(hookprogCycleIsNext(&again, 500)) << "twice the same is not a sequence";
}

TEST(HookprogWatches, AnInstructionWaitsFromOneToTheLargestNumber) {
  for (const auto& [sequence, waits] :
       {std::pair{0.0, 0}, {1.0, 1}, {65535.0, 65535}, {65536.0, 0}}) {
    HookAnswerWatch watch;
    hookAnswerWatchWritten(&watch, sequence, 10);
    EXPECT_EQ(watch.instruction, waits);
    EXPECT_FALSE(hookAnswerWatchIsOverdue(&watch, 12, 21.75));
    EXPECT_EQ(hookAnswerWatchIsOverdue(&watch, 12, 22), waits != 0);
    EXPECT_FALSE(hookAnswerWatchIsOverdue(&watch, 12, 23)) << "told";
  }
}

TEST(HookprogWatches, AnInstructionWithoutANumberDoesNotEndTheWait) {
  HookAnswerWatch watch;
  hookAnswerWatchWritten(&watch, 7, 10);
  EXPECT_TRUE(hookAnswerWatchIsOverdue(&watch, 12, 30));
  hookAnswerWatchWritten(&watch, 8, 31);
  EXPECT_FALSE(hookAnswerWatchIsOverdue(&watch, 12, 50)) << "told, and still waiting since then";
  hookAnswerWatchAnswered(&watch, 7);
  EXPECT_EQ(watch.instruction, 8);
  hookAnswerWatchAnswered(&watch, 8);
  hookAnswerWatchWritten(&watch, 9, 60);
  EXPECT_FALSE(hookAnswerWatchIsOverdue(&watch, 12, 71));
  EXPECT_TRUE(hookAnswerWatchIsOverdue(&watch, 12, 72));
}

TEST(HookprogWatches, ProgressIsALaterTimeOfTheSessionInControl) {
  HookProgressWatch watch;
  hookProgressWatchInit(&watch);
  EXPECT_TRUE(hookProgressWatchHasGoneOn(&watch, 4, 0, 10));
  EXPECT_FALSE(hookProgressWatchHasGoneOn(&watch, 4, 0, 11));
  EXPECT_FALSE(hookProgressWatchIsStuck(&watch, 12, 21.75));
  EXPECT_TRUE(hookProgressWatchIsStuck(&watch, 12, 22));
  EXPECT_FALSE(hookProgressWatchIsStuck(&watch, 12, 30)) << "told";
  EXPECT_TRUE(hookProgressWatchHasGoneOn(&watch, 5, 0, 31));
  EXPECT_FALSE(hookProgressWatchIsStuck(&watch, 12, 42));
  EXPECT_TRUE(hookProgressWatchIsStuck(&watch, 12, 43));
}

}  // namespace
}  // namespace glider::hooks
