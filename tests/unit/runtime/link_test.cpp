// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/core/control.h"
#include "runtime/library/library.h"
#include "tests/unit/runtime/bench_mission.h"
#include "tests/unit/runtime/log_csv.h"
#include "tests/unit/runtime/vehicle_bench.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace glider::runtime::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Kind = hooks::SeatEvent::Kind;

/// Two states: a yo until `turn` s, then one with other depths until `end` s, then exit.
class LinkTest : public ::testing::Test {
 protected:
  LinkTest() {
    mission_.sensors = {depthSensor(), temperatureSensor()};
    mission_.states = {benchState("first", &to_second_, 1, log_, 1),
                       benchState("second", &leave_, 1, log_, 1)};
    mission_.guards = [this](const GliderContext& c) {
      const double limit = c.state == 0 ? turn : end;
      return c.mission_time >= limit ? 0U : GLIDER_NO_CASE;
    };
    mission_.fly = [this](GliderContext& c, uint32_t phase) {
      gliderProfileYo(&c, &c.memory[c.state], phase, 5, c.state == 0 ? first_bottom : 15, .454,
                      .454);
      gliderRouteNoheading(&c, &c.memory[2], phase);
    };
    mission_.finish(1);
  }

  void boot(VehicleBench& vehicle) {
    runtime_memory_.assign(gliderRuntimeSize() / sizeof(double) + 1, 0.0);
    const GliderRuntimeOptions options{
        {this, &LinkTest::writeLog, nullptr, nullptr}, nullptr, {}, 0};
    runtime_ = gliderRuntimeInit(runtime_memory_.data(), mission_.memory.data(), &mission_.mission,
                                 &options);
    ASSERT_NE(runtime_, nullptr);
    vehicle.sbc = [this, &vehicle] { poll(vehicle); };
  }

  void poll(VehicleBench& vehicle) {
    const GliderByteStream stream = vehicle.sbcEnd();
    const GliderClock clock{&sbc_time_, [](void* t) { return *static_cast<double*>(t); }};
    sbc_time_ = vehicle.now();
    for (int i = 0; i < 100; ++i) {
      status_ = gliderRuntimePoll(runtime_, &stream, &clock);
      finished_ = finished_ || status_ == kGliderRuntimeFinished;
      if (status_ == kGliderRuntimeIdle || status_ == kGliderRuntimeLinkClosed) {
        return;
      }
    }
    FAIL() << "the runtime never comes to rest";
  }

  static int32_t writeLog(void* self, const uint8_t* bytes, uint32_t count) {
    static_cast<LinkTest*>(self)->log_text_.append(reinterpret_cast<const char*>(bytes), count);
    return static_cast<int32_t>(count);
  }

  /// The log so far, as `glidercc log --csv` shows it.
  [[nodiscard]] std::string logCsv() const { return csvOf(log_text_); }

  double turn = 100;
  double end = 200;
  double first_bottom = 12;
  GliderCaseInfo to_second_{kGliderGoto, 1};
  GliderCaseInfo leave_{kGliderExit, 0};
  GliderLogInfo log_[1] = {{"depth", 8, kGliderSensor, 0}};
  BenchMission mission_;
  std::vector<double> runtime_memory_;
  GliderRuntime* runtime_ = nullptr;
  GliderRuntimeStatus status_ = kGliderRuntimeIdle;
  bool finished_ = false;
  double sbc_time_ = 0;
  std::string log_text_;
};

TEST_F(LinkTest, WaitsForHookbehThenTakesFliesAndReleases) {
  VehicleBench vehicle({.start_secs = 60});
  boot(vehicle);
  vehicle.run(60);
  EXPECT_EQ(gliderRuntimeContext(runtime_), nullptr) << "hookbeh was not ready";
  EXPECT_EQ(vehicle.sbcView().phase, hooks::MissionPhase::Waiting);
  vehicle.run(90);
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Active);
  EXPECT_THAT(vehicle.doings, ElementsAre("dive_to"));
  EXPECT_EQ(vehicle.array(GLIDER_SCI_HOOK_DEPTH), 12);
  EXPECT_EQ(vehicle.array(GLIDER_SCI_HOOK_PITCH), static_cast<double>(-.454F));
  vehicle.run(200);
  EXPECT_EQ(vehicle.array(GLIDER_SCI_HOOK_DEPTH), 15) << "the second state's command";
  EXPECT_FALSE(finished_);
  vehicle.run(300);
  EXPECT_TRUE(finished_);
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Complete);
  EXPECT_THAT(vehicle.answers, ElementsAre(hooks::HookAnswer::Accepted, hooks::HookAnswer::Accepted,
                                           hooks::HookAnswer::Accepted))
      << "take, one steer, release";
}

TEST_F(LinkTest, MissionTimeCountsFromControlAndTransitionsAreReported) {
  VehicleBench vehicle({.start_secs = 60});
  boot(vehicle);
  vehicle.run(300);
  std::vector<hooks::SeatEvent> transitions;
  for (const auto& event : vehicle.events) {
    if (event.kind == Kind::SbcTransition) {
      transitions.push_back(event);
    }
  }
  ASSERT_EQ(transitions.size(), 2U);
  EXPECT_EQ(transitions[0].mission_time_s, 100);
  EXPECT_EQ(transitions[0].a, static_cast<uint32_t>(kGliderGoto));
  EXPECT_EQ(transitions[0].b, 0U);
  EXPECT_EQ(transitions[0].c, 1U);
  EXPECT_EQ(transitions[1].mission_time_s, 200);
  EXPECT_EQ(transitions[1].a, static_cast<uint32_t>(kGliderExit));
}

TEST_F(LinkTest, LogsTheFlight) {
  VehicleBench vehicle({.start_secs = 60});
  boot(vehicle);
  vehicle.run(300);
  EXPECT_THAT(logCsv(), ::testing::StartsWith("time_s,record,name,value,from,to\n"
                                              "0,start,bench,,,\n"
                                              "0,begin,,,,\n"
                                              "0,value,depth,10,,\n"));
  EXPECT_THAT(logCsv(), HasSubstr("\n8,value,depth,10,,\n"));
  EXPECT_THAT(logCsv(), ::testing::Not(HasSubstr("\n4,value,"))) << "every 8 s";
  EXPECT_THAT(logCsv(), HasSubstr(",event,control taken,1,,\n"));
  EXPECT_THAT(logCsv(), HasSubstr("\n100,transition,goto,1,first,second\n"
                                  "100,fired,statetime,100,,\n100,fired,resumetime,100,,\n"
                                  "100,fired,m_depth,10,,\n100,fired,sci_water_temp,20,,\n"
                                  "100,value,depth,10,,\n"));
  EXPECT_THAT(logCsv(), HasSubstr("\n200,transition,exit,1,second,\n"));
  EXPECT_THAT(logCsv(), HasSubstr(",event,control released,"));
}

TEST_F(LinkTest, ARefusedInstructionIsRecordedAndTheMissionContinues) {
  VehicleBench vehicle({.greatest_depth_m = 14});
  boot(vehicle);
  vehicle.run(160);
  EXPECT_THAT(vehicle.answers, ElementsAre(hooks::HookAnswer::Accepted, hooks::HookAnswer::TooDeep))
      << "refused once, not sent again";
  EXPECT_THAT(logCsv(), HasSubstr(",event,instruction refused,2,too deep,\n"));
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Active);
  vehicle.run(300);
  EXPECT_TRUE(finished_);
}

TEST_F(LinkTest, AHandshakeOutOfBoundsIsTriedAgainOnlyWithAnotherCommand) {
  first_bottom = 14.5;
  VehicleBench vehicle({.greatest_depth_m = 14});
  vehicle.depth = [](double t) { return t < 60 ? 10.0 : 14.6; };
  boot(vehicle);
  vehicle.run(60);
  EXPECT_THAT(vehicle.answers, ElementsAre(hooks::HookAnswer::TooDeep));
  vehicle.run(90);
  EXPECT_THAT(vehicle.answers, ElementsAre(hooks::HookAnswer::TooDeep, hooks::HookAnswer::Accepted))
      << "the climb is within bounds";
}

/// A vehicle whose ticks the test makes by hand, for answers that come in an unlucky order.
class HandMadeTicks {
 public:
  hooks::VehicleTick tick;
  Control control;
  /// The instruction that goes with the answer to this tick, under the next number; true if one
  /// does.
  bool answer(double depth) {
    news = control.observe(tick);
    hooks::Instruction wanted;
    wanted.vertical = hooks::HookVertical::Descend;
    wanted.depth_m = depth;
    hooks::Instruction out;
    const bool sends = control.choose(wanted, false, out);
    if (sends) {
      control.sent(out, ++sequence);
      tick.instruction_sequence = sequence;
      sent = out;
    }
    return sends;
  }
  uint16_t sequence = 0;
  hooks::Instruction sent;
  ControlNews news;
};

TEST(Control, ARefusalThatOvertakesTheAnswerToTheHandshakeLeavesControlOurs) {
  HandMadeTicks vehicle;
  vehicle.tick.hook_state = hooks::HookState::Ready;
  ASSERT_TRUE(vehicle.answer(12));
  ASSERT_TRUE(vehicle.answer(5000)) << "another command before the first was answered";
  vehicle.tick.hook_state = hooks::HookState::Active;
  vehicle.tick.obeys_us = true;
  vehicle.tick.answered_sequence = 2;
  vehicle.tick.answer = hooks::HookAnswer::TooDeep;
  EXPECT_FALSE(vehicle.answer(5000));
  EXPECT_EQ(vehicle.news.kind, ControlNews::Kind::Taken);
  EXPECT_FALSE(vehicle.answer(5000));
  EXPECT_EQ(vehicle.news.kind, ControlNews::Kind::Refused);
  ASSERT_TRUE(vehicle.answer(15)) << "the next command";
  EXPECT_EQ(vehicle.sent.control, hooks::HookControl::Steer) << "of the same session";
}

TEST(Control, OneInstructionInARowIsReplacedBeforeItIsAnswered) {
  HandMadeTicks vehicle;
  vehicle.tick.hook_state = hooks::HookState::Ready;
  ASSERT_TRUE(vehicle.answer(12));
  EXPECT_TRUE(vehicle.answer(14));
  EXPECT_FALSE(vehicle.answer(16)) << "it would never be obeyed, nor would any other";
  EXPECT_FALSE(vehicle.answer(18));
  EXPECT_TRUE(vehicle.answer(20)) << "that which stood has had its time";
  EXPECT_EQ(vehicle.sent.depth_m, 20) << "the newest; the others were replaced here";
}

TEST(Control, WhatHasWaitedIsNotReplacedEither) {
  HandMadeTicks vehicle;
  vehicle.tick.hook_state = hooks::HookState::Ready;
  ASSERT_TRUE(vehicle.answer(12));
  ASSERT_TRUE(vehicle.answer(14));
  ASSERT_FALSE(vehicle.answer(16));
  vehicle.tick.answered_sequence = 2;
  vehicle.tick.answer = hooks::HookAnswer::Accepted;
  EXPECT_TRUE(vehicle.answer(16)) << "an answer ends the wait";
  EXPECT_FALSE(vehicle.answer(18)) << "or 16 m would be obeyed 28 s after it was commanded";
  EXPECT_FALSE(vehicle.answer(18));
  EXPECT_TRUE(vehicle.answer(18));
}

TEST(Control, AfterAnAnswerTheNextIsSentAtOnce) {
  HandMadeTicks vehicle;
  vehicle.tick.hook_state = hooks::HookState::Ready;
  ASSERT_TRUE(vehicle.answer(12));
  ASSERT_TRUE(vehicle.answer(14));
  vehicle.tick.answered_sequence = 2;
  vehicle.tick.answer = hooks::HookAnswer::Accepted;
  EXPECT_FALSE(vehicle.answer(14));
  EXPECT_TRUE(vehicle.answer(16));
}

TEST(Control, AnotherRowBeginsWhenNothingWasSentForSoLong) {
  HandMadeTicks vehicle;
  vehicle.tick.hook_state = hooks::HookState::Ready;
  ASSERT_TRUE(vehicle.answer(12));
  ASSERT_TRUE(vehicle.answer(14));
  vehicle.tick.answered_sequence = 2;
  vehicle.tick.answer = hooks::HookAnswer::Accepted;
  for (int tick = 0; tick < 4; ++tick) {
    ASSERT_FALSE(vehicle.answer(14));
  }
  EXPECT_TRUE(vehicle.answer(16));
  EXPECT_TRUE(vehicle.answer(18)) << "one in a row";
  EXPECT_FALSE(vehicle.answer(20));
}

TEST(Control, TheFirstOfAProgramThatGoesOnStands) {
  HandMadeTicks vehicle;
  vehicle.control.resume();
  vehicle.tick.hook_state = hooks::HookState::Active;
  ASSERT_TRUE(vehicle.answer(12)) << "one of the program before may be on its way";
  EXPECT_FALSE(vehicle.answer(14));
  EXPECT_FALSE(vehicle.answer(14));
  EXPECT_TRUE(vehicle.answer(14));
}

TEST(Control, AReleaseDoesNotWait) {
  HandMadeTicks vehicle;
  vehicle.tick.hook_state = hooks::HookState::Ready;
  ASSERT_TRUE(vehicle.answer(12));
  ASSERT_TRUE(vehicle.answer(13));
  hooks::Instruction release;
  EXPECT_TRUE(vehicle.control.choose({}, true, release));
  EXPECT_EQ(release.control, hooks::HookControl::Release);
}

/// Answer and state may come in different frames: how many ticks the state may lag.
TEST(Control, AStateThatLagsBehindTheAnswerIsNotALoss) {
  HandMadeTicks vehicle;
  vehicle.tick.hook_state = hooks::HookState::Ready;
  ASSERT_TRUE(vehicle.answer(12));
  vehicle.tick.answered_sequence = 1;
  vehicle.tick.answer = hooks::HookAnswer::Accepted;
  EXPECT_FALSE(vehicle.answer(12));
  ASSERT_EQ(vehicle.news.kind, ControlNews::Kind::Taken);
  int ticks = 0;
  do {
    (void)vehicle.answer(12);
    ++ticks;
  } while (vehicle.news.kind != ControlNews::Kind::Lost && ticks < 10);
  EXPECT_EQ(ticks, 7) << "six may still say Ready, the seventh is a loss";
}

TEST(Control, OnceSeenActiveAnyOtherStateIsALossAtOnce) {
  HandMadeTicks vehicle;
  vehicle.tick.hook_state = hooks::HookState::Ready;
  ASSERT_TRUE(vehicle.answer(12));
  vehicle.tick.answered_sequence = 1;
  vehicle.tick.answer = hooks::HookAnswer::Accepted;
  vehicle.tick.hook_state = hooks::HookState::Active;
  (void)vehicle.answer(12);
  (void)vehicle.answer(12);
  EXPECT_EQ(vehicle.news.kind, ControlNews::Kind::None);
  vehicle.tick.hook_state = hooks::HookState::Silent;
  (void)vehicle.answer(12);
  EXPECT_EQ(vehicle.news.kind, ControlNews::Kind::Lost);
  (void)vehicle.answer(12);
  EXPECT_NE(vehicle.news.kind, ControlNews::Kind::Lost) << "reported once";
}

TEST(Control, FollowsANumberThatTheClientHadToReplace) {
  HandMadeTicks vehicle;
  vehicle.tick.hook_state = hooks::HookState::Ready;
  ASSERT_TRUE(vehicle.answer(12));
  vehicle.tick.instruction_sequence = 9;
  EXPECT_FALSE(vehicle.answer(12));
  vehicle.tick.answered_sequence = 9;
  vehicle.tick.answer = hooks::HookAnswer::Accepted;
  EXPECT_FALSE(vehicle.answer(12));
  EXPECT_EQ(vehicle.news.kind, ControlNews::Kind::Taken);
}

TEST_F(LinkTest, ARefusedLinkIsLoggedBelowTheHeaderWithItsReason) {
  constexpr uint16_t kOfLaterVersions = 1U << 9;
  const std::pair<hooks::Beacon, std::string> refused[] = {
      {{hooks::kProtocolVersion, {}, 0, hooks::HookState::Ready}, "0,another sensor dictionary"},
      {{9, {}, 0, hooks::HookState::Ready}, "9,another protocol version"},
      {{hooks::kProtocolVersion,
        {.offers = 0, .needs = kOfLaterVersions},
        gliderDictionary.hash,
        hooks::HookState::Ready},
       "9,a protocol feature that this version does not know is missing"},
  };
  hooks::MemoryLine line;
  const GliderRuntimeOptions options{{this, &LinkTest::writeLog, nullptr, nullptr}, nullptr, {}, 0};
  runtime_memory_.assign(gliderRuntimeSize() / sizeof(double) + 1, 0.0);
  runtime_ = gliderRuntimeInit(runtime_memory_.data(), mission_.memory.data(), &mission_.mission,
                               &options);
  std::string expected = "time_s,record,name,value,from,to\n0,start,bench,,,\n";
  for (const auto& [beacon, reason] : refused) {
    hooks::Frame frame;
    hooks::encode(beacon, frame);
    uint8_t bytes[hooks::kMostEncodedBytes];
    const uint32_t size = hooks::encodeFrame(frame, bytes);
    const GliderByteStream vehicle = line.left();
    vehicle.write(vehicle.self, bytes, size);
    const GliderByteStream stream = line.right();
    const GliderClock clock{&sbc_time_, [](void* t) { return *static_cast<double*>(t); }};
    (void)gliderRuntimePoll(runtime_, &stream, &clock);
    expected += "0,event,link refused," + reason + ",\n";
  }
  EXPECT_EQ(logCsv(), expected);
}

TEST_F(LinkTest, AfterSilenceControlIsTakenAgainAndTheMissionContinues) {
  VehicleBench vehicle({.silence_secs = 24});
  boot(vehicle);
  vehicle.run(60);
  const uint32_t before = vehicle.hookbeh().session;
  vehicle.line_is_cut = true;
  vehicle.run(100);
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Silent);
  EXPECT_FALSE(vehicle.hookbeh().commanding);
  vehicle.line_is_cut = false;
  vehicle.run(140);
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Active);
  EXPECT_GT(vehicle.hookbeh().session, before);
  EXPECT_THAT(logCsv(), HasSubstr(",event,control lost,"));
  EXPECT_EQ(gliderRuntimeContext(runtime_)->state, 1U) << "mission time ran on";
  EXPECT_EQ(vehicle.array(GLIDER_SCI_HOOK_DEPTH), 15) << "the commands in force, sent again";
  vehicle.run(300);
  EXPECT_TRUE(finished_);
}

TEST_F(LinkTest, AfterSilenceACommandThatIsRefusedDoesNotKeepItFromTakingControl) {
  end = 5000;
  VehicleBench vehicle({.greatest_depth_m = 14, .silence_secs = 24}, false);
  boot(vehicle);
  vehicle.run(120);
  ASSERT_EQ(vehicle.hookbeh().answer, hooks::HookAnswer::TooDeep);
  vehicle.line_is_cut = true;
  vehicle.run(180);
  ASSERT_EQ(vehicle.hookbeh().state, hooks::HookState::Silent);
  vehicle.line_is_cut = false;
  const size_t before = vehicle.answers.size();
  vehicle.run(2000);
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Active);
  EXPECT_LE(vehicle.answers.size(), before + 3) << "the refused take, the take, the refused steer";
  EXPECT_TRUE(vehicle.hookbeh().commanding) << "as by the last that it had accepted";
}

/// Gone for so long, then the vehicle restarts its own mission.
class NewVehicleMission : public LinkTest, public ::testing::WithParamInterface<double> {};

TEST_P(NewVehicleMission, TheMissionGoesOnFromTheTimeThatItsOwnClockHadReached) {
  turn = end = 1e6;
  double offset = 0;
  {
    VehicleBench first({.silence_secs = 24}, false);
    boot(first);
    first.run(100);
    const GliderByteStream stream = first.sbcEnd();
    const GliderClock clock{&sbc_time_, [](void* t) { return *static_cast<double*>(t); }};
    for (; offset < GetParam(); ++offset) {
      sbc_time_ = 100 + offset;
      (void)gliderRuntimePoll(runtime_, &stream, &clock);
    }
  }
  const double reached = gliderRuntimeContext(runtime_)->mission_time;
  VehicleBench second({.silence_secs = 24}, false);
  int heard_at = -1;
  for (double t = 1; t < 1000; ++t) {
    // The second is received when its own time is already later than the first's last.
    second.line_is_cut = t < 150;
    second.sbc = [&] { poll(second); };
    second.run(t);
    if (heard_at < 0 && second.hookbeh().state == hooks::HookState::Active) {
      heard_at = static_cast<int>(t);
    }
    ASSERT_NE(second.hookbeh().state, hooks::HookState::Silent) << t;
  }
  EXPECT_GT(heard_at, 0);
  EXPECT_NEAR(gliderRuntimeContext(runtime_)->mission_time - reached, 1000 - 150, 20);
}

INSTANTIATE_TEST_SUITE_P(, NewVehicleMission, ::testing::Values(60, 120, 300, 3600));

TEST_F(LinkTest, ARestartedProgramTakesControlOfAVehicleThatStillObeysTheOldOne) {
  VehicleBench vehicle({.silence_secs = 24});
  boot(vehicle);
  vehicle.run(60);
  boot(vehicle);  // forgets everything, within the seconds of silence
  vehicle.run(200);
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Active);
  EXPECT_THAT(logCsv(), HasSubstr("control taken"));
  EXPECT_GE(gliderRuntimeContext(runtime_)->mission_time, 100);
  EXPECT_EQ(vehicle.array(GLIDER_SCI_HOOK_DEPTH), 15);
  vehicle.run(400);
  EXPECT_TRUE(finished_);
}

TEST_F(LinkTest, InRealTimeASilentLinkMakesTicksOfTheClockAlone) {
  VehicleBench vehicle({.silence_secs = 24}, false);
  boot(vehicle);
  vehicle.run(60);
  const double before = gliderRuntimeContext(runtime_)->mission_time;
  sbc_time_ = 60;
  const GliderByteStream stream = vehicle.sbcEnd();
  const GliderClock clock{&sbc_time_, [](void* t) { return *static_cast<double*>(t); }};
  for (; sbc_time_ < 130; sbc_time_ += 1) {
    (void)gliderRuntimePoll(runtime_, &stream, &clock);
  }
  EXPECT_NEAR(gliderRuntimeContext(runtime_)->mission_time, before + 60, 12.1);
  EXPECT_EQ(gliderRuntimeContext(runtime_)->state, 1U)
      << "its clock is enough for missiontime >= 100";
  EXPECT_THAT(logCsv(), HasSubstr(",event,silent link,"));
}

TEST_F(LinkTest, AClockThatJumpsDoesNotCarryTheMissionAway) {
  end = 5000;
  VehicleBench vehicle({.silence_secs = 24}, false);
  boot(vehicle);
  vehicle.run(60);
  const double before = gliderRuntimeContext(runtime_)->mission_time;
  sbc_time_ += 3600;
  const GliderByteStream stream = vehicle.sbcEnd();
  const GliderClock clock{&sbc_time_, [](void* t) { return *static_cast<double*>(t); }};
  for (int i = 0; i < 3; ++i) {
    (void)gliderRuntimePoll(runtime_, &stream, &clock);
  }
  EXPECT_LE(gliderRuntimeContext(runtime_)->mission_time, before + 16);
  vehicle.run(100);
  EXPECT_NEAR(gliderRuntimeContext(runtime_)->mission_time, before + 40, 0.1);
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Active)
      << "its time stopped for 16 s at most";
}

TEST_F(LinkTest, AnInstructionWithoutAnswerIsLoggedOnce) {
  VehicleBench vehicle({.silence_secs = 24});
  boot(vehicle);
  vehicle.run(60);
  const double told = vehicle.array(GLIDER_X_HOOK_SEQUENCE);
  vehicle.forgets_sequence = true;
  vehicle.run(200);
  const std::string line = ",event,instruction unanswered,";
  const std::string log = logCsv();
  const size_t first = log.find(line);
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(log.substr(first + line.size(), 2), std::to_string(static_cast<int>(told) + 1) + ",");
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Silent);
}

TEST_F(LinkTest, AReleaseThatHasToWaitIsNotLoggedAsUnanswered) {
  end = 100;
  VehicleBench vehicle({.silence_secs = 24});
  boot(vehicle);
  vehicle.run(96);
  vehicle.forgets_sequence = true;
  vehicle.run(200);
  EXPECT_NE(gliderRuntimeContext(runtime_)->finished, 0U);
  EXPECT_THAT(logCsv(), Not(HasSubstr(",event,instruction unanswered,")));
}

TEST_F(LinkTest, SaysWhenTheLineIsClosed) {
  VehicleBench vehicle({});
  boot(vehicle);
  vehicle.run(20);
  vehicle.closeLine();
  poll(vehicle);
  EXPECT_EQ(status_, kGliderRuntimeLinkClosed);
}

TEST_F(LinkTest, ALogThatFailsNeverStopsTheMission) {
  VehicleBench vehicle({});
  boot(vehicle);
  const GliderRuntimeOptions full{
      {this, [](void*, const uint8_t*, uint32_t) { return -1; }, nullptr, nullptr}, nullptr, {}, 0};
  runtime_ =
      gliderRuntimeInit(runtime_memory_.data(), mission_.memory.data(), &mission_.mission, &full);
  vehicle.run(300);
  EXPECT_TRUE(finished_);
}

TEST_F(LinkTest, RefusesAMissionOfAnotherAbi) {
  runtime_memory_.assign(gliderRuntimeSize() / sizeof(double) + 1, 0.0);
  auto init = [&](const GliderMission& m) {
    return gliderRuntimeInit(runtime_memory_.data(), mission_.memory.data(), &m, nullptr);
  };
  GliderMission other = mission_.mission;
  EXPECT_NE(init(other), nullptr);
  other.abi_version = GLIDER_ABI_VERSION - 1;
  EXPECT_EQ(init(other), nullptr);
  other = mission_.mission;
  other.dictionary = nullptr;
  EXPECT_EQ(init(other), nullptr);
  other = mission_.mission;
  other.context_bytes -= 8;
  EXPECT_EQ(init(other), nullptr);
  other = mission_.mission;
  other.sensor_count = 65;
  EXPECT_EQ(init(other), nullptr);
  mission_.states[1].guards = nullptr;
  EXPECT_EQ(init(mission_.mission), nullptr) << "a state has cases and no guards";
}

}  // namespace
}  // namespace glider::runtime::testing
