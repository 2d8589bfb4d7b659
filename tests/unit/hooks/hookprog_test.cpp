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
    putMessage(sbc_line_.right(), message);
  }

  void hello(uint32_t link = 7) {
    Hello hello;
    hello.dictionary = dictionaryHash();
    hello.link = link;
    hello.mission_name[0] = 'm';
    say(hello);
    Subscribe subscribe{3, {GLIDER_M_DEPTH, GLIDER_SCI_WATER_TEMP, GLIDER_M_PITCH}};
    say(subscribe);
    say(answered());
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
  auto frames = atSbc();
  ASSERT_EQ(typesOf(frames), (std::vector{Type::Tick}));
  TickHead head;
  SensorList readings;
  ASSERT_TRUE(decode(frames[0], head, readings));
  EXPECT_EQ(head.vehicle_time_s, 4);
  EXPECT_EQ(head.cycle, 1U);
  EXPECT_EQ(head.hook_state, HookState::Active);
  EXPECT_EQ(head.answer, HookAnswer::Accepted);
  EXPECT_EQ(head.answered_sequence, 9);
  EXPECT_EQ(head.session, 4U);
  ASSERT_EQ(readings.count, 2U);
  EXPECT_EQ(readings.values[0].value, 12.5);
  EXPECT_EQ(readings.values[1].value, 17.5);
  cycle();
  ASSERT_TRUE(decode(atSbc().at(0), head, readings));
  EXPECT_EQ(readings.count, 0U) << "nothing was reported anew";
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

TEST_F(HookprogTest, ManyReadingsGoInParts) {
  Hello hello;
  hello.dictionary = dictionaryHash();
  hello.link = 7;
  say(hello);
  Subscribe subscribe;
  std::vector<SensorUpdate> values;
  for (uint16_t i = 0; i < kMostSubscriptions; ++i) {
    subscribe.ids[subscribe.count++] = GLIDER_M_LAT;
  }
  say(subscribe);
  run();
  atSbc();
  cycle({{GLIDER_M_LAT, 3910}});
  const auto frames = atSbc();
  ASSERT_EQ(frames.size(), 3U);
  uint32_t total = 0;
  for (size_t i = 0; i < 3; ++i) {
    TickHead head;
    SensorList readings;
    ASSERT_TRUE(decode(frames[i], head, readings));
    EXPECT_EQ(head.more, i < 2);
    EXPECT_EQ(head.continues, i > 0);
    EXPECT_EQ(expectsAnswer(frames[i]), i == 2);
    total += readings.count;
  }
  EXPECT_EQ(total, kMostSubscriptions);
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
    say(answered(4));
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
