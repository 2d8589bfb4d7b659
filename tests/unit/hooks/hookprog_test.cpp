// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/slocum.h"
#include "tests/unit/hooks/hookprog_bench.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glider::hooks {
namespace {

using Type = MessageType;
using Kind = SeatEvent::Kind;

class HookprogTest : public HookprogBench {};

TEST_F(HookprogTest, BeaconsOnceAFlightCycleUntilThereIsALink) {
  run();
  EXPECT_TRUE(atSbc().empty()) << "no flight controller, no beacon";
  for (int i = 0; i < 3; ++i) {
    cycle({{GLIDER_X_HOOK_STATE, 2}});
    run();
    const auto frames = atSbc();
    ASSERT_EQ(typesOf(frames), (std::vector{Type::Beacon}));
    Beacon beacon;
    ASSERT_TRUE(decode(frames[0], beacon));
    EXPECT_EQ(beacon.features, (Features{kAllFeatures, kFeatureVirtualTime}));
    EXPECT_EQ(beacon.dictionary, gliderDictionary.hash);
    EXPECT_EQ(beacon.hook_state, HookState::Ready);
  }
}

TEST_F(HookprogTest, HelloIsWelcomedAndReported) {
  cycle();
  atSbc();
  hello();
  const auto frames = atSbc();
  ASSERT_EQ(typesOf(frames), (std::vector{Type::Welcome}));
  Welcome welcome;
  ASSERT_TRUE(decode(frames[0], welcome));
  EXPECT_EQ(welcome.link, 7U);
  EXPECT_EQ(events(), (std::vector{Kind::SbcHello}));
  EXPECT_STREQ(last_event_.text, "m");
  EXPECT_TRUE(hookprog_.sbc().known);
}

TEST_F(HookprogTest, AnotherDictionaryOrVersionIsRefusedAndReportedOnce) {
  Hello hello;
  hello.dictionary = gliderDictionary.hash + 1;
  hello.link = 7;
  say(hello);
  run();
  say(hello);
  run();
  EXPECT_TRUE(atSbc().empty());
  EXPECT_EQ(events(), (std::vector{Kind::SbcRefused}));
  EXPECT_EQ(last_event_.b, gliderDictionary.hash + 1);
  hello.version = 9;
  say(hello);
  run();
  EXPECT_EQ(events(), (std::vector{Kind::SbcRefused}));
  EXPECT_EQ(last_event_.a, 9U);
  EXPECT_EQ(last_event_.b, 0U) << "of another version no dictionary is read";
  hello.version = 5;
  hello.dictionary = gliderDictionary.hash;
  say(hello);
  run();
  EXPECT_TRUE(atSbc().empty()) << "the check value of version 5 is another";
  EXPECT_EQ(events(), (std::vector{Kind::SbcRefused}));
  EXPECT_EQ(last_event_.a, 5U);
}

TEST_F(HookprogTest, AnSbcThatLacksAFeatureIsRefusedForEachOnce) {
  constexpr uint16_t kOfLaterVersions = 1U << 9;
  Hello hello;
  hello.dictionary = gliderDictionary.hash;
  hello.link = 7;
  hello.features = {.offers = kOfLaterVersions, .needs = 0};
  for (int i = 0; i < 2; ++i) {
    say(hello);
    run();
    EXPECT_TRUE(atSbc().empty());
  }
  EXPECT_EQ(events(), (std::vector{Kind::SbcRefused}));
  EXPECT_EQ(last_event_.c, kFeatureVirtualTime) << "the vehicle needs it";
  hello.features = {.offers = kAllFeatures, .needs = kOfLaterVersions};
  say(hello);
  run();
  EXPECT_EQ(events(), (std::vector{Kind::SbcRefused}));
  EXPECT_EQ(last_event_.c, kOfLaterVersions) << "the SBC needs it";
  hello.features = {.offers = kAllFeatures | kOfLaterVersions, .needs = kFeatureVirtualTime};
  say(hello);
  run();
  EXPECT_EQ(typesOf(atSbc()), (std::vector{Type::Welcome})) << "what it offers beyond is unused";
}

TEST_F(HookprogTest, AMissionThatNeedsAFixedFinAndActuatorsIsWelcome) {
  Hello hello;
  hello.dictionary = gliderDictionary.hash;
  hello.link = 7;
  hello.features = {.offers = kAllFeatures, .needs = kFeatureFixedFin | kFeatureActuators};
  say(hello);
  run();
  EXPECT_EQ(typesOf(atSbc()), (std::vector{Type::Welcome}));
}

TEST_F(HookprogTest, TheSamplingOfAnotherProgramEndsWithTheNextInstruction) {
  cycle({{GLIDER_X_HOOK_STATE, 2}});
  hello();
  write({{GLIDER_SCI_HOOK_SESSION, 7},
         {GLIDER_SCI_HOOK_SEQUENCE, 1},
         {GLIDER_SCI_HOOK_SAMPLING, 33}});
  say(answered());
  cycle({{GLIDER_X_HOOK_STATE, 2}});
  EXPECT_EQ(newestAtFlight(GLIDER_SCI_HOOK_SAMPLING), 33);
  write({{GLIDER_SCI_HOOK_SESSION, 8}, {GLIDER_SCI_HOOK_SEQUENCE, 2}});
  say(answered());
  cycle({{GLIDER_X_HOOK_STATE, 2}});
  EXPECT_EQ(newestAtFlight(GLIDER_SCI_HOOK_SAMPLING), 0);
}

TEST_F(HookprogTest, NothingGoesToFlightWithoutAHookbeh) {
  cycle({{GLIDER_M_DEPTH, 1}});
  hello();
  write({{GLIDER_SCI_HOOK_SESSION, 7}, {GLIDER_SCI_HOOK_SEQUENCE, 1}});
  say(answered());
  for (int i = 0; i < 10; ++i) {
    cycle({{GLIDER_X_HOOK_STATE, 0}});
  }
  EXPECT_TRUE(atFlight().empty());
}

class HookprogMissionsTest : public HookprogBench {
 protected:
  void fly(std::vector<SensorUpdate> report) {
    cycle(std::move(report));
    atSbc();
    atFlight();
    write({{GLIDER_SCI_HOOK_SESSION, 4}, {GLIDER_SCI_HOOK_SEQUENCE, 10}});
    say(answered(4, cycles_flown_++));
    run();
  }

  void flyWithHookbeh() {
    fly({{GLIDER_X_HOOK_STATE, 3},
         {GLIDER_X_HOOK_SESSION, 4},
         {GLIDER_X_HOOK_SEQUENCE, 9},
         {GLIDER_X_HOOK_ANSWER, 1}});
  }
  void flyWithout() { fly({{GLIDER_M_DEPTH, 1}}); }

  TickHead told() {
    cycle({{GLIDER_M_DEPTH, 1}});
    TickHead head;
    EXPECT_TRUE(decode(atSbc().at(0), head));
    return head;
  }

  double cycles_flown_ = 1;
};

TEST_F(HookprogMissionsTest, AMissionWithoutAHookbehIsFoundOutAfterSixCycles) {
  cycle({{GLIDER_X_HOOK_STATE, 3}});
  hello();
  for (int i = 0; i < 3; ++i) {
    flyWithHookbeh();
    EXPECT_EQ(atFlight().size(), 3U);
  }
  for (int i = 0; i < 5; ++i) {
    flyWithout();
    EXPECT_EQ(atFlight().size(), 3U) << i << ": its reports may have been lost";
  }
  for (int i = 0; i < 20; ++i) {
    flyWithout();
    EXPECT_TRUE(atFlight().empty()) << i;
  }
  const TickHead head = told();
  EXPECT_EQ(head.hook_state, HookState::Absent);
  EXPECT_EQ(head.session, 0U);
  EXPECT_EQ(head.answered_sequence, 0);
  EXPECT_EQ(head.answer, HookAnswer::None);
  flyWithHookbeh();
  EXPECT_EQ(atFlight().size(), 3U) << "it is there again";
}

TEST_F(HookprogMissionsTest, WhenMissionTimeTurnsBackTwoCyclesWithoutAHookbehAreEnough) {
  cycle({{GLIDER_X_HOOK_STATE, 3}});
  hello();
  for (int i = 0; i < 10; ++i) {
    flyWithHookbeh();
  }
  cycle_ = 0;
  flyWithout();
  EXPECT_EQ(atFlight().size(), 3U) << "one report may have been lost";
  for (int i = 0; i < 20; ++i) {
    flyWithout();
    EXPECT_TRUE(atFlight().empty()) << i;
  }
}

TEST_F(HookprogMissionsTest, OneFalseReadingOfTheTimeIsNotAnotherMission) {
  cycle({{GLIDER_X_HOOK_STATE, 3}});
  hello();
  for (int i = 0; i < 10; ++i) {
    flyWithHookbeh();
  }
  line_.fromFlight({{GLIDER_M_PRESENT_SECS_INTO_MISSION, 3},
                    {GLIDER_M_CYCLE_NUMBER, static_cast<double>(++cycle_)}});
  run();
  run();
  for (int i = 0; i < 4; ++i) {
    flyWithout();
    EXPECT_EQ(atFlight().size(), 3U) << "reports may be lost for six cycles, as ever: " << i;
  }
}

TEST_F(HookprogMissionsTest, AMissionWithAHookbehAfterAnotherIsServedFromItsStart) {
  cycle({{GLIDER_X_HOOK_STATE, 3}});
  hello();
  flyWithHookbeh();
  for (int i = 0; i < 10; ++i) {
    cycle_ = 0;
    flyWithHookbeh();
    EXPECT_EQ(atFlight().size(), 3U);
  }
}

TEST_F(HookprogMissionsTest, ReportsOfHookbehMayBeLostInBursts) {
  cycle({{GLIDER_X_HOOK_STATE, 3}});
  hello();
  for (int i = 0; i < 60; ++i) {
    i % 6 == 0 ? flyWithHookbeh() : flyWithout();
    EXPECT_EQ(atFlight().size(), 3U) << i;
  }
}

TEST_F(HookprogMissionsTest, ASilentFlightControllerForgetsNothing) {
  cycle({{GLIDER_X_HOOK_STATE, 3}});
  hello();
  flyWithHookbeh();
  run(100);
  EXPECT_EQ(told().hook_state, HookState::Active);
}

TEST_F(HookprogTest, EachWordOfAnInstructionIsWrittenIntoItsSensor) {
  hello();
  cycle({{GLIDER_X_HOOK_STATE, 2}});
  atFlight();
  write({{GLIDER_SCI_HOOK_SEQUENCE, 3}, {GLIDER_SCI_HOOK_SESSION, 7}, {GLIDER_SCI_HOOK_DEPTH, 20}});
  run();
  const auto got = atFlight();
  ASSERT_EQ(got.size(), 3U);
  EXPECT_EQ(got[0].id, GLIDER_SCI_HOOK_SEQUENCE);
  EXPECT_EQ(got[0].value, 3);
  EXPECT_EQ(got[1].id, GLIDER_SCI_HOOK_SESSION);
  EXPECT_EQ(got[1].value, 7);
  EXPECT_EQ(got[2].id, GLIDER_SCI_HOOK_DEPTH);
  EXPECT_EQ(got[2].value, 20);
}

TEST_F(HookprogTest, TheSbcMayWriteTheHooksSensorsOnly) {
  hello();
  cycle({{GLIDER_X_HOOK_STATE, 3}});
  atFlight();
  events();
  for (const uint16_t id :
       {GLIDER_C_PITCH, GLIDER_SCI_HOOK_HEARTBEAT, GLIDER_X_HOOK_STATE, GLIDER_SCI_WATER_TEMP}) {
    write({{GLIDER_SCI_HOOK_DEPTH, 20}, {id, 1}});
    run();
    EXPECT_EQ(events(), (std::vector{Kind::RefusedWrite}));
    EXPECT_EQ(last_event_.a, id);
    EXPECT_TRUE(atFlight().empty()) << "nothing of that frame";
  }
}

TEST_F(HookprogTest, OnlyASessionThatWentOnIsTheNewest) {
  cycle({{GLIDER_X_HOOK_STATE, 3}});
  hello();
  const auto newest = [&](uint32_t link) {
    atSbc();
    hello(link);
    Welcome welcome;
    EXPECT_TRUE(decode(atSbc().at(0), welcome));
    return welcome.newest_session;
  };
  write({{GLIDER_SCI_HOOK_SESSION, 4}, {GLIDER_SCI_HOOK_SEQUENCE, 3}});
  run();
  EXPECT_EQ(newest(8), 4U);
  write({{GLIDER_SCI_HOOK_SESSION, 9000}, {GLIDER_C_PITCH, 1}});
  run();
  EXPECT_EQ(newest(9), 4U) << "that frame was refused";
}

TEST_F(HookprogTest, AnInstructionThatComesAgainIsReportedOnceAndHookbehAnswersIt) {
  cycle({{GLIDER_X_HOOK_STATE, 3}, {GLIDER_X_HOOK_SEQUENCE, 9}, {GLIDER_X_HOOK_ANSWER, 1}});
  hello();
  atSbc();
  atFlight();
  events();
  write({{GLIDER_SCI_HOOK_SESSION, 4}, {GLIDER_SCI_HOOK_SEQUENCE, 3}});
  for (int i = 0; i < 6; ++i) {
    cycle({{GLIDER_X_HOOK_STATE, 3}, {GLIDER_X_HOOK_SEQUENCE, 3}, {GLIDER_X_HOOK_ANSWER, 9}});
    say(answered());
    run();
  }
  EXPECT_EQ(events(), (std::vector{Kind::OldInstruction}));
  EXPECT_EQ(last_event_.a, 3U);
  TickHead head;
  ASSERT_TRUE(decode(atSbc().at(0), head));
  EXPECT_EQ(head.answered_sequence, 3);
  EXPECT_EQ(head.answer, HookAnswer::OldSequence);
}

TEST_F(HookprogTest, AnEarlierSessionThatComesAgainIsNotTheNewest) {
  cycle({{GLIDER_X_HOOK_STATE, 3}});
  hello();
  write({{GLIDER_SCI_HOOK_SESSION, 4}, {GLIDER_SCI_HOOK_SEQUENCE, 3}});
  write({{GLIDER_SCI_HOOK_SESSION, 5}, {GLIDER_SCI_HOOK_SEQUENCE, 4}});
  write({{GLIDER_SCI_HOOK_SESSION, 4}, {GLIDER_SCI_HOOK_SEQUENCE, 3}});
  run();
  atSbc();
  hello(8);
  Welcome welcome;
  ASSERT_TRUE(decode(atSbc().at(0), welcome));
  EXPECT_EQ(welcome.newest_session, 5U);
}

TEST_F(HookprogTest, AnInstructionThatComesAgainDoesNotHideOneWithoutAnswer) {
  cycle({{GLIDER_X_HOOK_STATE, 3}, {GLIDER_X_HOOK_SEQUENCE, 6}});
  hello();
  events();
  for (int i = 0; i < 26; ++i) {
    write({{GLIDER_SCI_HOOK_SESSION, 4}, {GLIDER_SCI_HOOK_SEQUENCE, 7}});
    write({{GLIDER_SCI_HOOK_SESSION, 4}, {GLIDER_SCI_HOOK_SEQUENCE, 6}});
    run();
  }
  EXPECT_EQ(events(), (std::vector{Kind::SbcUnanswered}));
  EXPECT_EQ(last_event_.a, 7U);
}

TEST_F(HookprogTest, AFrameWithAnEarlierMissionTimeIsIgnored) {
  cycle({{GLIDER_X_HOOK_STATE, 3}, {GLIDER_X_HOOK_SESSION, 4}});
  hello();
  say(answered(4, 100));
  run();
  events();
  atFlight();
  TransitionNotice notice;
  notice.mission_time_s = 96;
  MissionNote note;
  note.mission_time_s = 96;
  say(notice);
  say(note);
  say(answered(0, 96));  // as it was before control was taken
  run();
  EXPECT_EQ(events(), (std::vector{Kind::StaleFrame}));
  EXPECT_EQ(last_event_.a, 3U);
  EXPECT_EQ(hookprog_.sbc().mission_time_s, 100);
  EXPECT_TRUE(atFlight().empty()) << "no heartbeat";
  for (int i = 0; i < 16; ++i) {
    say(answered(4, 96));
    cycle({{GLIDER_X_HOOK_STATE, 3}});
  }
  const auto told = events();
  EXPECT_EQ(std::ranges::count(told, Kind::SbcLost), 1) << "who is dead does not answer";
}

TEST_F(HookprogTest, EachAnswerOfTheSessionInControlIsAHeartbeat) {
  cycle({{GLIDER_X_HOOK_STATE, 3}, {GLIDER_X_HOOK_SESSION, 4}});
  hello();
  atFlight();
  double before = std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 3; ++i) {
    say(answered(4, 2 + i));
    run();
    const auto got = atFlight();
    ASSERT_EQ(got.size(), 1U);
    EXPECT_EQ(got[0].id, GLIDER_SCI_HOOK_HEARTBEAT);
    EXPECT_NE(got[0].value, before);
    before = got[0].value;
  }
  hello(8);
  say(answered(5));  // a program that was started again and has not taken control
  run();
  EXPECT_TRUE(atFlight().empty());
  cycle({{GLIDER_X_HOOK_STATE, 4}, {GLIDER_X_HOOK_SESSION, 0}});
  say(answered(5));
  run();
  EXPECT_EQ(atFlight().size(), 1U) << "no SBC is in control: any answer shows that one lives";
}

TEST_F(HookprogTest, AnswersWithoutProgressAreNotAHeartbeatAndAreReportedOnce) {
  cycle({{GLIDER_X_HOOK_STATE, 3}, {GLIDER_X_HOOK_SESSION, 4}});
  hello();
  say(answered(4, 100));
  run();
  EXPECT_EQ(atFlight().size(), 1U);
  events();
  for (int i = 0; i < 40; ++i) {
    say(answered(4, 100));
    cycle({{GLIDER_X_HOOK_STATE, 3}});
    EXPECT_TRUE(atFlight().empty()) << i;
  }
  EXPECT_EQ(events(), (std::vector{Kind::SbcStuck}));
  EXPECT_EQ(last_event_.a, 4U);
  say(answered(4, 104));
  run();
  EXPECT_EQ(atFlight().size(), 1U) << "it flies again";
}

TEST_F(HookprogTest, AnotherLinkIsNotProgressAnotherSessionIs) {
  cycle({{GLIDER_X_HOOK_STATE, 3}, {GLIDER_X_HOOK_SESSION, 4}});
  hello();
  say(answered(4, 5000));
  run();
  hello(8);
  atFlight();
  say(answered(4, 5000));
  run();
  EXPECT_TRUE(atFlight().empty()) << "the same stuck mission";
  cycle({{GLIDER_X_HOOK_SESSION, 5}});
  hello(9);
  atFlight();
  say(answered(5, 4));
  run();
  EXPECT_EQ(atFlight().size(), 1U);
}

TEST_F(HookprogTest, AnInstructionThatHookbehDoesNotAnswerIsReportedOnce) {
  cycle({{GLIDER_X_HOOK_STATE, 3}, {GLIDER_X_HOOK_SEQUENCE, 6}});
  hello();
  events();
  for (int i = 0; i < 50; ++i) {
    write({{GLIDER_SCI_HOOK_SESSION, 4}, {GLIDER_SCI_HOOK_SEQUENCE, i < 30 ? 7.0 : 8.0}});
    say(answered());
    cycle({{GLIDER_X_HOOK_STATE, 3}});
    EXPECT_EQ(events().size(), i == 23 ? 1U : 0U) << i;
  }
  EXPECT_EQ(last_event_.kind, Kind::SbcUnanswered);
  EXPECT_EQ(last_event_.a, 7U);
  cycle({{GLIDER_X_HOOK_SEQUENCE, 8}, {GLIDER_X_HOOK_ANSWER, 1}});
  for (int i = 0; i < 20; ++i) {
    say(answered());
    cycle();
  }
  EXPECT_TRUE(events().empty()) << "answered";
}

TEST_F(HookprogTest, TheSbcIsLostAfterTwelveSecondsWithoutAnswer) {
  hello();
  events();
  for (int i = 0; i < 12; ++i) {
    cycle();
    EXPECT_TRUE(events().empty());
  }
  cycle();
  EXPECT_EQ(events(), (std::vector{Kind::SbcLost}));
  EXPECT_EQ(last_event_.a, 7U);
  EXPECT_FALSE(hookprog_.sbc().known);
  atSbc();
  cycle();
  EXPECT_EQ(typesOf(atSbc()), (std::vector{Type::Beacon}));
}

TEST_F(HookprogTest, AnSbcWhoseMissionHasFinishedMayGoWithoutAnAlarm) {
  hello();
  Done done = answered();
  done.status.phase = MissionPhase::Finished;
  say(done);
  run();
  events();
  atSbc();
  for (int i = 0; i < 20; ++i) {
    cycle();
  }
  EXPECT_TRUE(events().empty());
  EXPECT_EQ(typesOf(atSbc()).back(), Type::Beacon) << "another one may come";
}

TEST_F(HookprogTest, AQuietFlightControllerIsNotTheSbcsFault) {
  hello();
  events();
  for (int i = 0; i < 100; ++i) {
    run();
  }
  EXPECT_TRUE(events().empty());
}

TEST_F(HookprogTest, AClockThatIsSetBackDoesNotHideALostSbc) {
  now_ = 10000;
  hello();
  cycle();
  events();
  now_ = 6400;
  for (int i = 0; i < 12; ++i) {
    run();
    EXPECT_TRUE(events().empty()) << i;
  }
  run();
  EXPECT_EQ(events(), (std::vector{Kind::SbcLost}));
}

TEST_F(HookprogTest, AClockThatIsSetBackDoesNotHideAStuckMission) {
  now_ = 10000;
  cycle({{GLIDER_X_HOOK_STATE, 3}, {GLIDER_X_HOOK_SESSION, 4}});
  hello();
  say(answered(4, 100));
  run();
  events();
  now_ = 6400;
  for (int i = 0; i < 20; ++i) {
    say(answered(4, 100));
    run();
    EXPECT_EQ(events().size(), i == 12 ? 1U : 0U) << i;
  }
  EXPECT_EQ(last_event_.kind, Kind::SbcStuck);
}

TEST_F(HookprogTest, AClockThatIsSetBackDoesNotHideAnInstructionWithoutAnswer) {
  now_ = 10000;
  cycle({{GLIDER_X_HOOK_STATE, 3}, {GLIDER_X_HOOK_SEQUENCE, 6}});
  hello();
  write({{GLIDER_SCI_HOOK_SESSION, 4}, {GLIDER_SCI_HOOK_SEQUENCE, 7}});
  run();
  events();
  now_ = 6400;
  for (int i = 0; i < 40; ++i) {
    say(answered());
    run();
    EXPECT_EQ(events().size(), i == 24 ? 1U : 0U) << i;
  }
  EXPECT_EQ(last_event_.kind, Kind::SbcUnanswered);
}

TEST_F(HookprogTest, AClosedLineIsALostSbcReportedOnce) {
  hello();
  events();
  sbc_line_.close();
  run();
  run();
  cycle();
  EXPECT_EQ(events(), (std::vector{Kind::SbcLost}));
}

TEST_F(HookprogTest, TransitionsAreEvents) {
  hello();
  events();
  say(TransitionNotice{500, 1, 0, 1, 2, 0});
  say(answered(0, 500));
  run();
  EXPECT_EQ(events(), (std::vector{Kind::SbcTransition}));
  EXPECT_EQ(last_event_.mission_time_s, 500);
  EXPECT_EQ(last_event_.a, 1U);
  EXPECT_EQ(last_event_.c, 1U);
  EXPECT_EQ(last_event_.d, 2U);
  EXPECT_EQ(last_event_.e, 0U);
  EXPECT_EQ(hookprog_.sbc().mission_time_s, 500);
  EXPECT_EQ(hookprog_.sbc().state, 2U);
  EXPECT_EQ(hookprog_.sbc().stack_depth, 1);
}

TEST_F(HookprogTest, BadFramesAreCountedInOneEventARun) {
  const uint8_t noise[] = {1, 2, 3, 0, 4, 5, 0};
  const GliderByteStream sbc = sbc_line_.right();
  sbc.write(sbc.self, noise, sizeof noise);
  run();
  EXPECT_EQ(events(), (std::vector{Kind::BadFrame}));
  EXPECT_EQ(last_event_.a, 2U);
}

TEST_F(HookprogTest, EventsAreBounded) {
  hello();
  events();
  for (int i = 0; i < 40; ++i) {
    say(TransitionNotice{1.0 * i, 0, 0, 0, 0});
  }
  run();
  EXPECT_EQ(events().size(), 32U);
}

TEST_F(HookprogTest, NotesAreReportedAndLeaveRoomForOtherEvents) {
  hello();
  events();
  MissionNote note;
  note.mission_time_s = 500;
  note.text[0] = 'x';
  for (int i = 0; i < 40; ++i) {
    say(note);
  }
  say(TransitionNotice{504, 1, 0, 1, 2});
  run();
  const auto told = events();
  ASSERT_EQ(told.size(), 17U);
  EXPECT_EQ(told.front(), Kind::SbcNote);
  EXPECT_EQ(told.back(), Kind::SbcTransition);
}

}  // namespace
}  // namespace glider::hooks
