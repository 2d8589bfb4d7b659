// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/unit/slocum/judged.h"
#include "vehicles/slocum/oracles/guard_judge.h"

#include <optional>

namespace glider::slocum::oracles {
namespace {

using hooks::HookGuard;
using hooks::HookState;

// What FlightJudge must detect in hookbeh's guards where no limit of depth is broken yet.

class JudgedGuard : public testing::Test {
 protected:
  JudgedGuard() : array_(shippedSetup("default").platform) { out_.commanding = true; }
  static JudgeSetup setup() {
    JudgeSetup setup;
    setup.promise = promiseOf(FaultKind::SensorStuck);
    setup.args.silence_secs = 24;
    setup.pump_cc = 233;
    return setup;
  }
  /// What is violated in a cycle at `depth`, as m_depth says or `reading`.
  std::string cycle(double depth, double reading, HookState hook = HookState::Active) {
    now_ += kCycle;
    array_.set(GLIDER_M_DEPTH, reading);
    array_.set(GLIDER_SCI_HOOK_HEARTBEAT, beats_ ? ++heartbeat_ : heartbeat_);
    array_.set(GLIDER_C_BALLAST_PUMPED, overridden_ ? -out_.pump_cc : out_.pump_cc);
    array_.set(GLIDER_X_HOOK_MASKED, reported_ | was_overridden_);
    was_overridden_ = overridden_ ? hooks::kMaskedPump : uint8_t{0};
    return judge_->cycle({now_, hook, depth, false, false, array_, now_, 100, 0, 14, true, &out_,
                          static_cast<uint8_t>(masked_ | was_overridden_)});
  }
  std::string cycle(double depth) { return cycle(depth, depth); }
  /// The first violation in `seconds` at `depth`.
  std::string stay(double depth, double seconds) {
    std::string wrong;
    for (const double until_s = now_ + seconds; now_ < until_s;) {
      const std::string found = cycle(depth);
      wrong = wrong.empty() ? found : wrong;
    }
    return wrong;
  }
  void dive() {
    out_.guard = HookGuard::None;
    out_.doing = hooks::Doing::DiveTo;
    out_.pitch_rad = -0.4;
    out_.pump_cc = -230;
  }
  void climb() {
    out_.pitch_rad = 0.4538;
    out_.pump_cc = 230;
  }
  void guard(HookGuard guard) {
    climb();
    out_.guard = guard;
    out_.doing = hookClimbFor(guard);
    out_.pump_cc = 233;
  }

  JudgeSetup setup_ = setup();
  std::optional<GuardJudge> judge_{setup_};
  hooks::HookbehOutputs out_;
  SensorArray array_;
  double now_ = 0, heartbeat_ = 0;
  bool beats_ = true;           ///< a newer heartbeat comes in every cycle
  bool overridden_ = false;     ///< another behaviour has the pump
  uint8_t was_overridden_ = 0;  ///< the same, as x_hook_masked reports it a cycle later
  uint8_t masked_ = 0, reported_ = 0;
};

TEST_F(JudgedGuard, WhatMasksItIsReportedACycleLater) {
  out_.commanding = true;
  dive();
  EXPECT_EQ(cycle(10), "");
  masked_ = hooks::kMaskedPitch | hooks::kMaskedPump;
  EXPECT_EQ(cycle(10), "") << "it cannot know yet";
  EXPECT_EQ(cycle(10), "x_hook_masked is 0, but other behaviours replaced 6");
  reported_ = 6;
  EXPECT_EQ(cycle(10), "");
  masked_ = 0;
  EXPECT_EQ(cycle(10), "");
  EXPECT_EQ(cycle(10), "x_hook_masked is 6, but other behaviours replaced 0");
  reported_ = hooks::kMaskedPump;
  EXPECT_EQ(cycle(10), "") << "the commanded pump may be read wrongly";
  out_.commanding = false;
  EXPECT_EQ(cycle(10), "x_hook_masked is 4, but other behaviours replaced 0");
}

TEST_F(JudgedGuard, AGuardClimbsWithAllOfThePump) {
  guard(HookGuard::NoDepthGained);
  EXPECT_EQ(cycle(10), "");
  out_.pump_cc = 232;
  EXPECT_EQ(cycle(10), "climb: no depth gained with 232 cc, and the pump has 233");
  EXPECT_EQ(cycle(10, 10, HookState::Silent), "") << "it commands nothing";
}

TEST_F(JudgedGuard, AClimbThatChecksTheDepthIsWithAllOfThePumpToo) {
  climb();
  out_.doing = hooks::Doing::ClimbTo;
  EXPECT_EQ(cycle(10), "");
  out_.doing = hooks::Doing::CheckDepth;
  EXPECT_EQ(cycle(10), "check depth with 230 cc, and the pump has 233");
}

TEST_F(JudgedGuard, AJumpWithoutAClimbIsSeen) {
  dive();
  EXPECT_EQ(stay(12, 80), "");
  EXPECT_EQ(cycle(12, 24.1), "m_depth jumps by 12.1 m, and hookbeh does not climb");
}

TEST_F(JudgedGuard, AJumpUpwardsWithoutAClimbIsSeen) {
  dive();
  EXPECT_EQ(stay(30, 80), "");
  EXPECT_EQ(cycle(30, 17.9), "m_depth jumps by -12.1 m, and hookbeh does not climb");
}

TEST_F(JudgedGuard, ASmallerJumpOrOneWithoutTheSbcIsNotAViolation) {
  dive();
  stay(30, 80);
  EXPECT_EQ(cycle(30, 42), "");
  stay(30, 80);
  EXPECT_EQ(cycle(30, 50, HookState::Silent), "");
}

TEST_F(JudgedGuard, AJumpWithAClimbIsNotAViolation) {
  dive();
  stay(12, 80);
  guard(HookGuard::DepthJumps);
  EXPECT_EQ(cycle(12, 30), "");
}

TEST_F(JudgedGuard, OnlyADepthThatWasRightForAMinuteCanJump) {
  dive();
  cycle(12, 30);
  stay(12, 60);
  EXPECT_EQ(cycle(12, 25), "");
  stay(12, 64);
  EXPECT_NE(cycle(12, 25), "");
}

TEST_F(JudgedGuard, AfterAGapTheDepthMayBeAnother) {
  dive();
  stay(12, 80);
  now_ += 20;
  EXPECT_EQ(cycle(26), "");
}

TEST_F(JudgedGuard, AClimbWithoutProgressOrGuardIsSeen) {
  climb();
  EXPECT_EQ(stay(20, 504), "");
  EXPECT_EQ(cycle(20), "climbs for 508 s and gains no height, but no guard intervenes");
}

TEST_F(JudgedGuard, AClimbThatGainsHalfAMetreIsNotAViolation) {
  climb();
  for (const double depth : {20.0, 19.5, 19.0}) {
    EXPECT_EQ(stay(depth, 480), "");
  }
}

TEST_F(JudgedGuard, NoHeightIsToBeGainedAtTheSurfaceOrByAnother) {
  climb();
  EXPECT_EQ(stay(3, 1000), "");
  overridden_ = true;
  EXPECT_EQ(stay(20, 1000), "");
  overridden_ = false;
  EXPECT_EQ(stay(20, 200), "");
  guard(HookGuard::NoHeightGained);
  EXPECT_EQ(stay(20, 1000), "");
  dive();
  EXPECT_EQ(stay(20, 1000), "") << "another check reports that";
}

TEST_F(JudgedGuard, AGuardThatCountsWhatAnotherBehaviourFliesIsSeen) {
  dive();
  overridden_ = true;
  EXPECT_EQ(stay(20, 16), "");
  guard(HookGuard::NoDepthGained);
  EXPECT_EQ(cycle(20),
            "the guard intervenes (climb: no depth gained) while another behaviour has the pump");
  EXPECT_EQ(cycle(20), "") << "once";
}

TEST_F(JudgedGuard, AGuardThatLastsOverSessionsIsNoNewOne) {
  out_.commanding = true;
  guard(HookGuard::NoDepthGained);
  EXPECT_EQ(stay(20, 16), "");
  out_ = {};
  EXPECT_EQ(cycle(10, 10, HookState::Silent), "");
  out_.commanding = true;
  reported_ = hooks::kMaskedPump;
  overridden_ = true;
  guard(HookGuard::NoDepthGained);
  EXPECT_EQ(stay(10, 16), "");
}

TEST_F(JudgedGuard, AGuardMayComeInAsAnotherBehaviourTakesThePump) {
  dive();
  overridden_ = true;
  stay(20, 12);
  guard(HookGuard::NoHeightGained);
  EXPECT_EQ(cycle(20), "");
}

TEST_F(JudgedGuard, HeartbeatsThatComeAgainAreSilence) {
  EXPECT_EQ(stay(10, 40), "");
  beats_ = false;
  const double newest = heartbeat_;
  for (int i = 0; i < 8; ++i) {
    heartbeat_ = i % 2 == 0 ? newest - 1 : newest;
    EXPECT_EQ(cycle(10), "");
  }
  EXPECT_EQ(cycle(10), "the SBC is in control without a newer heartbeat for 36 s");
  EXPECT_EQ(cycle(10, 10, HookState::Silent), "");
}

TEST_F(JudgedGuard, ASessionThatBeginsAsTheLastIsLostHasASilenceOfItsOwn) {
  array_.set(GLIDER_X_HOOK_SESSION, 1);
  EXPECT_EQ(stay(10, 40), "");
  beats_ = false;
  EXPECT_EQ(stay(10, 24), "");
  array_.set(GLIDER_X_HOOK_SESSION, 2);
  EXPECT_EQ(stay(10, 36), "");
  EXPECT_EQ(cycle(10), "the SBC is in control without a newer heartbeat for 36 s");
}

TEST_F(JudgedGuard, AHeartbeatIsAWholeNumber) {
  stay(10, 40);
  beats_ = false;
  heartbeat_ += 0.5;
  for (int i = 0; i < 8; ++i, ++heartbeat_) {
    EXPECT_EQ(cycle(10), "");
  }
  EXPECT_NE(cycle(10), "");
}

TEST_F(JudgedGuard, SilenceIsAsLongAsAWrongClockSays) {
  for (const char* clock : {"m_present_time", "m_present_secs_into_mission", "m_cycle_number"}) {
    SensorFault fault;
    fault.name = clock;
    setup_.faults.sensors = {fault};
    judge_.emplace(setup_);
    stay(10, 40);
    beats_ = false;
    EXPECT_EQ(stay(10, 200), "") << clock;
    beats_ = true;
  }
}

TEST_F(JudgedGuard, OneWrongClockMayCountACycleTwiceAndNoMore) {
  SensorFault fault;
  fault.name = "m_present_time";
  setup_.faults.sensors = {fault, fault};
  judge_.emplace(setup_);
  for (const double seconds : {4.0, 8.0}) {
    for (const bool garbled : {false, true}) {
      stay(10, 40);
      array_.set(GLIDER_X_HOOK_ANSWER,
                 garbled ? static_cast<double>(hooks::HookAnswer::BadCheck) : 0);
      beats_ = false;
      stay(10, seconds);
      EXPECT_EQ(cycle(10, 10, HookState::Silent),
                seconds == 4 && !garbled ? "control ends after 8 s of silence" : "");
      beats_ = true;
    }
  }
}

TEST_F(JudgedGuard, OfTwoWrongClocksNothingIsPromised) {
  setup_.faults.sensors.resize(2);
  setup_.faults.sensors[0].name = "m_present_time";
  setup_.faults.sensors[1].name = "m_cycle_number";
  judge_.emplace(setup_);
  stay(10, 40);
  beats_ = false;
  EXPECT_EQ(cycle(10, 10, HookState::Silent), "");
}

TEST_F(JudgedGuard, AnotherMissionStartsFromTheBeginning) {
  dive();
  stay(12, 80);
  judge_->restart();
  heartbeat_ = 0;
  EXPECT_EQ(cycle(40), "");
}

/// The checks of the flight include those of the guards.
TEST_F(Judged, AGuardThatIsTooWeakIsSeen) {
  take();
  climb();
  out_.doing = hooks::Doing::CheckDepth;
  cycle(HookState::Active, 10);
  EXPECT_EQ(violation(), "check depth with 230 cc, and the pump has 233");
}

}  // namespace
}  // namespace glider::slocum::oracles
