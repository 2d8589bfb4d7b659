// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What a campaign draws, promises and sees.

#include "hooks/protocol/messages.h"
#include "platforms/slocum_sensors.h"
#include "simulator/campaign/draw_faults.h"
#include "simulator/campaign/flight_judge.h"
#include "tests/unit/simulator/fake_sbc.h"
#include "tests/unit/simulator/flights.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glider::simulator {
namespace {

using hooks::HookState;
using Outcome = Verdict::Outcome;

constexpr double kSilence = 24, kCycle = 4;

TEST(DrawFaults, EveryKindDrawsSomethingWithinTheFlightAndTheSameForASeed) {
  for (uint32_t k = 1; k < kFaultKinds; ++k) {
    const auto kind = static_cast<FaultKind>(k);
    for (uint64_t seed = 0; seed < 50; ++seed) {
      const Faults faults = drawFaults(kind, seed, 1000);
      EXPECT_FALSE(faults.empty()) << nameOf(kind);
      EXPECT_LT(faults.first(), 1000) << nameOf(kind);
      EXPECT_EQ(faults.first(), drawFaults(kind, seed, 1000).first());
      EXPECT_NE(faults.first(), drawFaults(kind, seed + 1, 1000).first()) << nameOf(kind);
    }
  }
  EXPECT_TRUE(drawFaults(FaultKind::None, 1, 1000).empty());
}

TEST(StatedTimes, AreThoseOfTheWatchdogs) {
  Faults faults;
  faults.power = {{100, 200}};
  faults.lines = {{.when = {300, kForever}, .cut = true}, {.when = {0, 50}, .delay_s = 2}};
  faults.aborts = {500};
  const StatedTimes stated = statedTimes(faults, kSilence, kCycle);
  ASSERT_EQ(stated.hand_backs.size(), 3U);
  EXPECT_EQ(stated.hand_backs[0].when.from_s, 100 + 32 + 2);
  EXPECT_EQ(stated.hand_backs[0].when.to_s, 200);
  EXPECT_EQ(stated.hand_backs[1].when.from_s, 300 + 32 + 2);
  EXPECT_EQ(stated.hand_backs[2].when.from_s, 500);
  EXPECT_EQ(stated.most_standstill_s, 56 + 2);
}

/// A judge that is told a story: what the SBC says, what hookbeh does with it.
class Judged : public testing::Test {
 protected:
  Judged() : array_(shippedSetup("default").platform) {}

  void say(hooks::Frame& frame) {
    frame.sequence = ++frame_sequence_;
    std::array<uint8_t, hooks::kMostEncodedBytes> bytes;
    judge_.said({bytes.data(), hooks::encodeFrame(frame, bytes.data())}, now_);
  }
  void instruct(uint32_t session, uint16_t sequence, hooks::HookControl control,
                double depth = 20) {
    hooks::Frame frame;
    hooks::encodeEmptyList(hooks::MessageType::Write, frame);
    const std::pair<uint16_t, double> words[] = {
        {GLIDER_SCI_HOOK_SESSION, session},
        {GLIDER_SCI_HOOK_CONTROL, static_cast<double>(control)},
        {GLIDER_SCI_HOOK_VERTICAL, 1},
        {GLIDER_SCI_HOOK_DEPTH, depth},
        {GLIDER_SCI_HOOK_PITCH, -0.5},
        {GLIDER_SCI_HOOK_LATERAL, 0},
        {GLIDER_SCI_HOOK_HEADING, 0},
        {GLIDER_SCI_HOOK_LAT, 0},
        {GLIDER_SCI_HOOK_LON, 0},
        {GLIDER_SCI_HOOK_CHECK, 7},
        {GLIDER_SCI_HOOK_SEQUENCE, sequence}};
    for (const auto& [id, value] : words) {
      ASSERT_TRUE(hooks::appendValue(frame, {id, value}));
      arriving_.emplace_back(id, value);
    }
    say(frame);
  }
  /// What was instructed gets into the sensor array.
  void arrive() {
    for (const auto& [id, value] : arriving_) {
      array_.set(id, value);
    }
    arriving_.clear();
  }
  void done(uint32_t session) {
    hooks::Frame frame;
    hooks::Done done;
    done.session = session;
    done.status.mission_time_s = now_;
    hooks::encode(done, frame);
    say(frame);
  }
  void obey(uint16_t sequence, uint32_t session = 1) {
    array_.set(GLIDER_X_HOOK_SESSION, session);
    array_.set(GLIDER_X_HOOK_SEQUENCE, sequence);
    array_.set(GLIDER_X_HOOK_ANSWER, static_cast<double>(hooks::HookAnswer::Accepted));
  }
  bool cycle(HookState hook, double depth = 0.1, bool aborted = false) {
    now_ += kCycle;
    return judge_.cycle({now_, hook, depth, aborted, false, array_});
  }
  /// Up to `until_s` in control, the mission going on.
  void fly(double until_s) {
    while (now_ < until_s) {
      done(1);
      cycle(HookState::Active, 10);
    }
  }
  void take() {
    instruct(1, 1, hooks::HookControl::Take);
    arrive();
    obey(1);
    fly(40);
  }
  void giveBack() {
    instruct(1, 9, hooks::HookControl::GiveBack);
    arrive();
    obey(9);
    cycle(HookState::Complete);
  }
  [[nodiscard]] std::string violation() const { return judge_.verdict().violation; }

  static Faults faults() {
    Faults faults;
    faults.power = {{200, 400}};
    return faults;
  }
  FlightJudge judge_{faults(), kSilence, kCycle};
  SensorArray array_;
  double now_ = 0;
  uint8_t frame_sequence_ = 0;
  std::vector<std::pair<uint16_t, double>> arriving_;
};

TEST_F(Judged, AGoodFlightExits) {
  take();
  instruct(1, 2, hooks::HookControl::Steer, 5);
  cycle(HookState::Active);
  arrive();
  obey(2);
  fly(80);
  giveBack();
  EXPECT_EQ(judge_.verdict().outcome, Outcome::Exited) << violation();
  EXPECT_EQ(judge_.verdict().instructions, 3U);
  EXPECT_EQ(judge_.verdict().hand_backs, 0U);
}

TEST_F(Judged, AFlightWithoutTheSbcAtTheEndIsHandedBack) {
  take();
  cycle(HookState::Silent);
  EXPECT_EQ(judge_.verdict().outcome, Outcome::HandedBack) << violation();
  EXPECT_EQ(judge_.verdict().hand_backs, 1U);
}

TEST_F(Judged, WhatWasNotSaidSoIsSeen) {
  take();
  instruct(1, 2, hooks::HookControl::Steer, 5);
  arrive();
  array_.set(GLIDER_SCI_HOOK_DEPTH, 6);
  obey(2);
  cycle(HookState::Active);
  EXPECT_EQ(violation(), "instruction 2 of session 1 is obeyed, but was not said so");
}

TEST_F(Judged, AnInstructionObeyedTwiceIsSeen) {
  take();
  instruct(1, 2, hooks::HookControl::Steer, 5);
  arrive();
  obey(2);
  cycle(HookState::Active);
  instruct(1, 1, hooks::HookControl::Take);
  arrive();
  obey(1);
  cycle(HookState::Active);
  EXPECT_EQ(violation(), "instruction 1 of session 1 is obeyed twice");
}

TEST_F(Judged, ANumberThatIsUsedForOtherWordsIsSeen) {
  take();
  instruct(1, 1, hooks::HookControl::Take, 12);
  EXPECT_EQ(violation(), "instruction 1 of session 1 is said anew with other words");
}

TEST_F(Judged, ALostInstructionIsSeen) {
  take();
  instruct(1, 2, hooks::HookControl::Steer, 5);
  fly(now_ + 56);
  cycle(HookState::Silent);
  EXPECT_EQ(violation(), "") << "let go in time";
  fly(now_ + 64);
  EXPECT_EQ(violation(), "instruction 2 of session 1 is lost: no answer for 60 s");
}

TEST_F(Judged, AMissionThatStandsStillInControlIsSeen) {
  take();
  for (int i = 0; i < 13; ++i) {
    cycle(HookState::Active);
  }
  EXPECT_EQ(violation().find("stood still"), std::string::npos);
  cycle(HookState::Active);
  EXPECT_NE(violation().find("stood still for 60 s"), std::string::npos) << violation();
}

TEST_F(Judged, ControlBeyondTheStatedTimeIsSeen) {
  take();
  fly(232);
  EXPECT_EQ(violation().find("no power"), std::string::npos);
  fly(236);
  EXPECT_EQ(violation(), "the SBC is in control though the SBC has no power");
  EXPECT_EQ(judge_.verdict().violation_s, 236);
}

TEST_F(Judged, ControlWithoutAHandshakeIsSeen) {
  instruct(1, 1, hooks::HookControl::Steer);
  arrive();
  obey(1);
  cycle(HookState::Active);
  EXPECT_EQ(violation(), "control is taken without a handshake");
}

TEST_F(Judged, AnotherSessionWithoutAHandshakeIsSeen) {
  take();
  instruct(2, 2, hooks::HookControl::Steer);
  arrive();
  obey(2, 2);
  cycle(HookState::Active);
  EXPECT_EQ(violation(), "control is taken without a handshake");
}

TEST_F(Judged, AnInstructionAfterControlWasGivenBackIsSeen) {
  take();
  giveBack();
  instruct(2, 10, hooks::HookControl::Take);
  arrive();
  obey(10, 2);
  cycle(HookState::Active);
  EXPECT_EQ(violation(), "instruction 10 of session 2 is obeyed after control was given back");
}

TEST_F(Judged, WhatArrivesWhenHookbehDoesNotListenIsNotObeyed) {
  take();
  instruct(2, 2, hooks::HookControl::Take);
  arrive();  // x_hook_sequence stays at 1, accepted
  cycle(HookState::Silent);
  cycle(HookState::Complete, 0.1, true);
  EXPECT_EQ(violation(), "");
  EXPECT_EQ(judge_.verdict().instructions, 1U);
}

TEST_F(Judged, AFlightThatDoesNotEndIsSeen) {
  take();
  EXPECT_EQ(violation(), "the flight does not end in time");
  cycle(HookState::Silent, 10);
  EXPECT_EQ(violation(), "not at the surface in time");
}

TEST(JudgeForEver, LooksNoLongerThanSomethingCanCome) {
  Faults faults;
  faults.power = {{100, kForever}};
  FlightJudge judge(faults, kSilence, kCycle);
  const SensorArray array(shippedSetup("default").platform);
  double last = 0;
  for (double now = 0; now < 1000; now += kCycle) {
    const bool active = now < 132;
    if (!judge.cycle({now, active ? HookState::Active : HookState::Silent, now < 300 ? 10.0 : 0,
                      false, false, array})) {
      last = now;
      break;
    }
  }
  EXPECT_EQ(last, 300 + 60 + kCycle);
}

TEST(JudgedFlight, OfTheFakePilotIsGood) {
  for (uint32_t k = 0; k < kFaultKinds; ++k) {
    const FakePilot::Plan plan{.give_back_s = 1200, .takes_again = true};
    SimulationSetup setup = shippedSetup("default");
    setup.scenario.faults = drawFaults(static_cast<FaultKind>(k), 5, 1200);
    setup.restart_sbc = [plan] {
      return support::Result<std::unique_ptr<SbcPort>>(std::make_unique<FakeSbc>(plan, 1e9, true));
    };
    setup.sbc = std::move(*setup.restart_sbc());
    FlightJudge judge(setup.scenario.faults, kSilence, kCycle);
    setup.onlooker = &judge;
    const support::Trace trace = fly(std::move(setup));
    EXPECT_NE(judge.verdict().outcome, Outcome::Violation)
        << nameOf(static_cast<FaultKind>(k)) << ": " << judge.verdict().violation << "\n"
        << eventText(trace);
  }
}

}  // namespace
}  // namespace glider::simulator
