// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What FlightJudge detects where a dive gains no depth by the readings.

#include "tests/unit/slocum/judged.h"

namespace glider::slocum::oracles {
namespace {

using hooks::HookState;

/// Nothing is wrong but what is planted.
class JudgedForLong : public Judged {
 protected:
  explicit JudgedForLong(JudgeSetup judged = withoutFaults()) : Judged(std::move(judged)) {}
  static JudgeSetup withoutFaults() {
    JudgeSetup judged = setup();
    judged.faults = {};
    return judged;
  }
  /// How long a depth may be frozen at 11 m after a reading of `from_m`, s.
  double frozenAfter(double from_m) {
    take();
    reading_ = from_m;
    cycle(HookState::Active, 11);
    reading_ = 11;
    double seconds = 0;
    for (; seconds < 100 && violation().find("frozen") == std::string::npos; seconds += kCycle) {
      done(1);
      cycle(HookState::Active, 11);
    }
    return seconds;
  }
};

TEST_F(JudgedForLong, ADiveThatGainsNoDepthIsSeen) {
  take();
  for (int i = 0; i < 60 && violation().find("gained") == std::string::npos; ++i) {
    reading_ = 11 + 0.01 * (i % 7);
    done(1);
    cycle(HookState::Active, 11);
  }
  EXPECT_NE(violation().find("without a metre gained"), std::string::npos) << violation();
}

/// hookbeh believes a reading that has jumped a cycle later.
TEST_F(JudgedForLong, ADepthThatFreezesAtAJumpHasACycleMore) {
  EXPECT_EQ(frozenAfter(6), 32 + kCycle) << violation();
}

TEST_F(JudgedForLong, ADepthThatFreezesWithoutAJumpHasTheUsualTime) {
  EXPECT_EQ(frozenAfter(10), 32) << violation();
}

/// A pressure that is read every 16 s may come twice.
class JudgedRarePressure : public JudgedForLong {
 protected:
  JudgedRarePressure() : JudgedForLong(rarely()) {}
  static JudgeSetup rarely() {
    JudgeSetup judged = withoutFaults();
    judged.late_m = 4;
    return judged;
  }
};

TEST_F(JudgedRarePressure, HasAsLongAsHookbehWaitsForOne) {
  EXPECT_EQ(frozenAfter(10), 52) << violation();
}

/// On a sloping bottom it slides on, and hookbeh counts the metres from another place.
TEST_F(JudgedForLong, ADiveThatCreepsHasTwiceTheTime) {
  take();
  const double begun_s = now_;
  for (int i = 0; i < 150 && violation().find("gained") == std::string::npos; ++i) {
    reading_ = 11 + std::min(0.014 * i, 0.85) + 0.01 * (i % 7);
    done(1);
    cycle(HookState::Active, 11);
  }
  EXPECT_NE(violation().find("without a metre gained"), std::string::npos) << violation();
  EXPECT_GT(now_ - begun_s, 380);
  EXPECT_LT(now_ - begun_s, 480);
}

/// A depth that flickers by up to 0.8 m: hookbeh may take the farthest for a metre gained.
TEST_F(JudgedForLong, ADiveThatCreepsWithAFlickerHasTwiceTheTime) {
  take();
  const double begun_s = now_;
  for (int i = 0; i < 150 && violation().find("gained") == std::string::npos; ++i) {
    reading_ = i % 2 == 0 ? 11.01 : 11.7 + 0.001 * i;
    done(1);
    cycle(HookState::Active, 11);
  }
  EXPECT_NE(violation().find("without a metre gained"), std::string::npos) << violation();
  EXPECT_GT(now_ - begun_s, 380);
}

TEST_F(JudgedForLong, ANewDiveAfterSilenceBeginsAgain) {
  take();
  fly(200);
  cycle(HookState::Silent, 15);
  instruct(2, 2, hooks::HookControl::Take);
  arrive();
  obey(2, 2);
  while (now_ < 420) {
    done(2);
    cycle(HookState::Active, 5 + 0.01 * (now_ - 204));
  }
  EXPECT_EQ(violation(), "the flight does not end in time");
}

}  // namespace
}  // namespace glider::slocum::oracles
