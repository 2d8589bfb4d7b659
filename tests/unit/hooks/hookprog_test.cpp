// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookprog/hookprog.h"

#include "tests/unit/hooks/line_ends.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

namespace glider::hooks {
namespace {

using Type = MessageType;
using Kind = HookprogEvent::Kind;

/// A hookprog whose flight controller, instruments and SBC are the test.
class HookprogTest : public testing::Test {
 protected:
  HookprogTest() : hookprog_(HookprogOptions{true}) {}

  void run(double seconds = 1) {
    now_ += seconds;
    const ScienceSensors own{this, [](void* self, uint16_t id, bool* fresh) {
                               auto& values = static_cast<HookprogTest*>(self)->science_;
                               const auto found = values.find(id);
                               *fresh = found != values.end();
                               const double value = *fresh ? found->second : 0;
                               values.erase(id);
                               return value;
                             }};
    hookprog_.run(now_, own, sbc_line_.left(), flight_line_.left());
  }

  /// The flight controller reports `values`, then time and cycle.
  void cycle(std::vector<SensorUpdate> values = {}) {
    ++cycle_;
    values.push_back({GLIDER_M_PRESENT_SECS_INTO_MISSION, 4.0 * cycle_});
    values.push_back({GLIDER_M_CYCLE_NUMBER, cycle_});
    ASSERT_TRUE(flight_.send(values.data(), static_cast<uint32_t>(values.size())));
    SensorUpdate unused[1];
    flight_.poll(flight_line_.right(), unused, 0);
    run();
  }

  std::vector<SensorUpdate> atFlight() {
    std::vector<SensorUpdate> all(64);
    all.resize(flight_.poll(flight_line_.right(), all.data(), 64));
    return all;
  }

  std::vector<Frame> atSbc() { return framesAt(sbc_line_.right()); }

  template <typename Message>
  void say(const Message& message) {
    putMessage(sbc_line_.right(), message, ++said_);
  }

  void hello(uint32_t link = 7) {
    Hello hello;
    hello.dictionary = dictionaryHash();
    hello.link = link;
    hello.mission_name[0] = 'm';
    say(hello);
    say(subscription());
    say(answered());
    run();
  }

  static Subscribe subscription() {
    return {3, {{GLIDER_M_DEPTH}, {GLIDER_SCI_WATER_TEMP}, {GLIDER_M_PITCH}}};
  }

  /// The newest Tick, which must be there.
  TickReadings tick(const Subscribe& subscribed, TickHead* head = nullptr) {
    const auto frames = atSbc();
    TickHead unused;
    TickReadings readings;
    EXPECT_EQ(frames.size(), 1U);
    EXPECT_TRUE(decode(frames.at(0), head == nullptr ? unused : *head));
    EXPECT_TRUE(decode(frames.at(0), subscribed, readings));
    tick_sequence_ = frames.at(0).sequence;
    return readings;
  }

  /// The SBC answers the newest Tick that tick() has seen.
  void answerTick() {
    say(Done{tick_sequence_, 0, {now_, 0, 0, 1}});
    run();
  }

  static Done answered(uint32_t session = 0, double time = 1) {
    return {1, session, {time, 2, 1, 1}};
  }

  void write(const std::vector<SensorValue>& values) {
    Frame frame;
    encodeEmptyList(Type::Write, frame);
    for (const auto& value : values) {
      ASSERT_TRUE(appendValue(frame, value));
    }
    frame.sequence = ++said_;
    put(sbc_line_.right(), frame);
  }

  std::vector<Kind> events() {
    std::vector<Kind> kinds;
    for (auto event = hookprog_.nextEvent(); event.kind != Kind::None;
         event = hookprog_.nextEvent()) {
      kinds.push_back(event.kind);
      last_event_ = event;
    }
    return kinds;
  }

  MemoryLine sbc_line_;
  MemoryLine flight_line_;
  Clothesline flight_;
  Hookprog hookprog_;
  std::map<uint16_t, double> science_;
  double now_ = 0;
  double cycle_ = 0;
  uint8_t said_ = 0;
  uint8_t tick_sequence_ = 0;
  HookprogEvent last_event_;
};

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
    EXPECT_TRUE(beacon.virtual_time);
    EXPECT_EQ(beacon.dictionary, dictionaryHash());
    EXPECT_EQ(beacon.hook_state, HookState::Ready);
  }
}

TEST_F(HookprogTest, HelloIsWelcomedAndTold) {
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

TEST_F(HookprogTest, AnotherDictionaryOrVersionIsRefusedAndToldOnce) {
  Hello hello;
  hello.dictionary = dictionaryHash() + 1;
  hello.link = 7;
  say(hello);
  run();
  say(hello);
  run();
  EXPECT_TRUE(atSbc().empty());
  EXPECT_EQ(events(), (std::vector{Kind::SbcRefused}));
  EXPECT_EQ(last_event_.b, dictionaryHash() + 1);
  hello.version = 9;
  say(hello);
  run();
  EXPECT_EQ(events(), (std::vector{Kind::SbcRefused}));
  EXPECT_EQ(last_event_.a, 9U);
}

TEST_F(HookprogTest, ATickHasTheSubscribedSensorsThatAreFresh) {
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
  EXPECT_EQ(readings.told[0], Told::Value);
  EXPECT_EQ(readings.values[0], 12.5);
  EXPECT_EQ(readings.told[1], Told::Value);
  EXPECT_EQ(readings.values[1], 17.5);
  EXPECT_EQ(readings.told[2], Told::Nothing) << "never reported";
  cycle();
  readings = tick(subscription());
  EXPECT_EQ(readings.told[0], Told::Nothing) << "nothing was reported anew";
  EXPECT_EQ(readings.told[1], Told::Nothing);
}

TEST_F(HookprogTest, OneTickACycleHoweverOftenItRuns) {
  hello();
  atSbc();
  cycle();
  run();
  run();
  EXPECT_EQ(atSbc().size(), 1U);
}

TEST_F(HookprogTest, ATickNeedsTimeAndCycleAnew) {
  hello();
  atSbc();
  const SensorUpdate only_cycle[] = {{GLIDER_M_CYCLE_NUMBER, 5}};
  flight_.send(only_cycle, 1);
  atFlight();
  run();
  EXPECT_TRUE(atSbc().empty()) << "the frame with the time was lost";
}

TEST_F(HookprogTest, OnlyWhatTheSbcDoesNotHoldIsSentOnceItHasAnswered) {
  hello();
  atSbc();
  cycle({{GLIDER_M_DEPTH, 12.5}, {GLIDER_M_PITCH, 0.1}});
  EXPECT_EQ(tick(subscription()).told[0], Told::Value);
  answerTick();
  cycle({{GLIDER_M_DEPTH, 12.5}, {GLIDER_M_PITCH, 0.2}});
  const TickReadings readings = tick(subscription());
  EXPECT_EQ(readings.told[0], Told::Unchanged);
  EXPECT_EQ(readings.told[2], Told::Value);
  EXPECT_EQ(readings.values[2], static_cast<double>(0.2F));
}

TEST_F(HookprogTest, AValueWhoseTickWasNotAnsweredIsSentAgain) {
  hello();
  atSbc();
  cycle({{GLIDER_M_DEPTH, 12.5}});
  tick(subscription());
  answerTick();
  cycle({{GLIDER_M_DEPTH, 14}});
  EXPECT_EQ(tick(subscription()).told[0], Told::Value);
  cycle({{GLIDER_M_DEPTH, 12.5}});  // as before the lost one: the SBC may have heard that
  EXPECT_EQ(tick(subscription()).told[0], Told::Value);
  cycle({{GLIDER_M_DEPTH, 12.5}});
  EXPECT_EQ(tick(subscription()).told[0], Told::Value);
  answerTick();
  cycle({{GLIDER_M_DEPTH, 12.5}});
  EXPECT_EQ(tick(subscription()).told[0], Told::Unchanged);
}

TEST_F(HookprogTest, ALateAnswerConfirmsWhatItsTickSaidUnlessAnotherValueWentSince) {
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
  EXPECT_EQ(readings.told[0], Told::Unchanged);
  EXPECT_EQ(readings.told[2], Told::Value) << "the SBC may hold 0.2";
}

TEST_F(HookprogTest, AnAnswerToWhatIsNoTickConfirmsNothing) {
  hello();
  atSbc();
  cycle({{GLIDER_M_DEPTH, 12.5}});
  tick(subscription());
  ++tick_sequence_;
  answerTick();
  cycle({{GLIDER_M_DEPTH, 12.5}});
  EXPECT_EQ(tick(subscription()).told[0], Told::Value);
}

TEST_F(HookprogTest, ANewSubscriptionOrLinkStartsWithNothingHeld) {
  hello();
  atSbc();
  for (int i = 0; i < 2; ++i) {
    cycle({{GLIDER_M_DEPTH, 12.5}});
    EXPECT_EQ(tick(subscription()).told[0], Told::Value);
    say(subscription());
    answerTick();
    cycle({{GLIDER_M_DEPTH, 12.5}});
    EXPECT_EQ(tick(subscription()).told[0], Told::Value)
        << "the answer came after the subscription";
    answerTick();
    cycle({{GLIDER_M_DEPTH, 12.5}});
    EXPECT_EQ(tick(subscription()).told[0], Told::Unchanged);
    hello(8);
    atSbc();
  }
}

TEST_F(HookprogTest, EachValueIsSentAnewAfterSixteenTicks) {
  hello();
  atSbc();
  int last = 0;
  for (int i = 0; i < 100; ++i) {
    cycle({{GLIDER_M_DEPTH, 12.5}});
    if (tick(subscription()).told[0] == Told::Value) {
      EXPECT_EQ(i - last, i == 0 ? 0 : 16);
      last = i;
    }
    answerTick();
  }
  EXPECT_GT(last, 80);
}

TEST_F(HookprogTest, ADeadBandHoldsSmallChangesBackButNotTheirSum) {
  hello();
  const Subscribe wanted{2, {{GLIDER_M_DEPTH, 1, 0.5F}, {GLIDER_M_PITCH, 1, 0.5F}}};
  say(wanted);
  run();
  atSbc();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  struct Row {
    double depth;
    Told told;
  };
  for (const Row& row :
       {Row{10, Told::Value}, Row{10.25, Told::Unchanged}, Row{9.5, Told::Unchanged},
        Row{10.5, Told::Unchanged}, Row{10.75, Told::Value}, Row{10.25, Told::Unchanged},
        Row{nan, Told::Value}, Row{nan, Told::Unchanged}, Row{10.75, Told::Value}}) {
    cycle({{GLIDER_M_DEPTH, row.depth}});
    EXPECT_EQ(tick(wanted).told[0], row.told) << row.depth;
    answerTick();
  }
}

TEST_F(HookprogTest, WithoutADeadBandEveryBitIsAChange) {
  hello();
  atSbc();
  for (const double depth : {0.0, -0.0, 1e-40, 0.0}) {
    cycle({{GLIDER_M_DEPTH, depth}});
    EXPECT_EQ(tick(subscription()).told[0], Told::Value) << depth;
    answerTick();
  }
}

TEST_F(HookprogTest, ARateIsKeptButALostTickIsMadeUpForAtOnce) {
  hello();
  const Subscribe wanted{1, {{GLIDER_M_DEPTH, 3, 0}}};
  say(wanted);
  run();
  atSbc();
  double depth = 0;
  const auto told = [&](bool answer) {
    cycle({{GLIDER_M_DEPTH, ++depth}});
    const Told one = tick(wanted).told[0];
    if (answer) {
      answerTick();
    }
    return one;
  };
  for (int i = 0; i < 9; ++i) {
    EXPECT_EQ(told(true), i % 3 == 0 ? Told::Value : Told::Nothing) << i;
  }
  EXPECT_EQ(told(false), Told::Value);
  EXPECT_EQ(told(true), Told::Value) << "the one before was not answered";
  EXPECT_EQ(told(true), Told::Nothing);
}

TEST_F(HookprogTest, SixtyFourReadingsGoInOneFrame) {
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
  for (const Told told : readings.told) {
    EXPECT_EQ(told, Told::Value);
  }
}

TEST_F(HookprogTest, NothingGoesToFlightWithoutAHookbeh) {
  cycle({{GLIDER_M_DEPTH, 1}});
  hello();
  write({{GLIDER_SCI_HOOK_SESSION, 7}, {GLIDER_SCI_HOOK_SEQUENCE, 1}});
  say(answered());
  for (int i = 0; i < 10; ++i) {
    cycle({{GLIDER_X_HOOK_STATE, 0}});
  }
  uint8_t byte = 0;
  const GliderByteStream flight = flight_line_.right();
  EXPECT_EQ(flight.read(flight.self, &byte, 1), 0) << "not one byte";
}

TEST_F(HookprogTest, WritesGoOnWithTheSequenceLast) {
  hello();
  cycle({{GLIDER_X_HOOK_STATE, 2}});
  atFlight();
  write({{GLIDER_SCI_HOOK_SEQUENCE, 3}, {GLIDER_SCI_HOOK_SESSION, 7}, {GLIDER_SCI_HOOK_DEPTH, 20}});
  run();
  const auto got = atFlight();
  ASSERT_EQ(got.size(), 3U);
  EXPECT_EQ(got[0].id, GLIDER_SCI_HOOK_SESSION);
  EXPECT_EQ(got[1].id, GLIDER_SCI_HOOK_DEPTH);
  EXPECT_EQ(got[2].id, GLIDER_SCI_HOOK_SEQUENCE);
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
  say(answered(5));  // a program that was started again and has not taken control
  run();
  EXPECT_TRUE(atFlight().empty());
  cycle({{GLIDER_X_HOOK_STATE, 4}, {GLIDER_X_HOOK_SESSION, 0}});
  say(answered(5));
  run();
  EXPECT_EQ(atFlight().size(), 1U) << "nobody is in control: any answer shows that an SBC lives";
}

TEST_F(HookprogTest, AnswersWithoutProgressAreNoHeartbeatAndAreToldOnce) {
  cycle({{GLIDER_X_HOOK_STATE, 3}, {GLIDER_X_HOOK_SESSION, 4}});
  hello();
  say(answered(4, 100));
  run();
  EXPECT_EQ(atFlight().size(), 1U);
  events();
  for (int i = 0; i < 40; ++i) {
    say(answered(4, 100));
    cycle();
    EXPECT_TRUE(atFlight().empty()) << i;
  }
  EXPECT_EQ(events(), (std::vector{Kind::SbcStuck}));
  EXPECT_EQ(last_event_.a, 4U);
  say(answered(4, 104));
  run();
  EXPECT_EQ(atFlight().size(), 1U) << "it flies again";
}

TEST_F(HookprogTest, AnotherLinkIsNoProgressAnotherSessionIs) {
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
  say(answered(5, 4));
  run();
  EXPECT_EQ(atFlight().size(), 1U);
}

TEST_F(HookprogTest, AnInstructionThatHookbehDoesNotAnswerIsToldOnce) {
  cycle({{GLIDER_X_HOOK_STATE, 3}, {GLIDER_X_HOOK_SEQUENCE, 6}});
  hello();
  events();
  for (int i = 0; i < 30; ++i) {
    write({{GLIDER_SCI_HOOK_SESSION, 4}, {GLIDER_SCI_HOOK_SEQUENCE, i < 15 ? 7.0 : 8.0}});
    say(answered());
    cycle();
    EXPECT_EQ(events().size(), i == 12 ? 1U : 0U) << i;
  }
  EXPECT_EQ(last_event_.kind, Kind::SbcUnanswered);
  EXPECT_EQ(last_event_.a, 7U);
  cycle({{GLIDER_X_HOOK_SEQUENCE, 8}});
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
  done.status.phase = 2;
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

TEST_F(HookprogTest, AClosedLineIsALostSbcToldOnce) {
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

TEST_F(HookprogTest, NotesAreToldAndLeaveRoomForOtherEvents) {
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
