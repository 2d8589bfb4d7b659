// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// When FlightJudge lets hookbeh report that the depths disagree.

#include "tests/unit/slocum/judged.h"

namespace glider::slocum::oracles {
namespace {

using hooks::HookState;

TEST_F(Judged, ACtdThatReadsTooDeepIsALimitThatIsNear) {
  take();
  climb();
  array_.set(GLIDER_SCI_WATER_PRESSURE, 5.9);
  out_.guard = hooks::HookGuard::TooDeep;
  out_.doing = hooks::Doing::TooDeep;
  cycle(HookState::Active, 10);
  EXPECT_EQ(violation().find("no limit is near"), std::string::npos) << violation();
}

/// Old frames come again to the flight computer, and with them old readings of the CTD.
class JudgedOldFrames : public Judged {
 protected:
  /// It is asked while the SBC has control.
  static constexpr const char* kNothingSoFar = "the flight does not end in time";
  explicit JudgedOldFrames(LineWay way = LineWay::ToFlight, double replayed = 0.4)
      : Judged(setup(way, replayed)) {}
  static JudgeSetup setup(LineWay way, double replayed) {
    JudgeSetup setup = Judged::setup();
    setup.faults = {};
    LineFault& line = setup.faults.lines.emplace_back();
    line.way = way;
    line.when = {20, 60};
    line.replayed = replayed;
    line.loss = 0.01;
    setup.promise = promiseOf(FaultKind::OldFrames);
    return setup;
  }
  std::string guardsAt(double time_s, hooks::HookGuard guard) {
    take();
    fly(time_s);
    climb();
    out_.pump_cc = hooks::kHull.pump_cc;
    out_.guard = guard;
    out_.doing = hookClimbFor(guard);
    for (double depth = 10; depth > 0; depth -= 0.4) {  // to the surface, against any instruction
      done(1);
      cycle(HookState::Active, depth);
    }
    return violation();
  }
};

TEST_F(JudgedOldFrames, MayMakeTheDepthsDisagree) {
  EXPECT_EQ(guardsAt(48, hooks::HookGuard::DepthsDisagree), kNothingSoFar);
}

TEST_F(JudgedOldFrames, ExcuseDepthsThatDisagreeShortlyAfterwards) {
  EXPECT_EQ(guardsAt(84, hooks::HookGuard::DepthsDisagree), kNothingSoFar);
}

TEST_F(JudgedOldFrames, DoNotExcuseDepthsThatDisagreeLongAfterwards) {
  EXPECT_EQ(guardsAt(96, hooks::HookGuard::DepthsDisagree),
            "the guard intervenes (climb: depths disagree), but no limit is near");
}

TEST_F(JudgedOldFrames, ExcuseNoOtherGuard) {
  EXPECT_EQ(guardsAt(48, hooks::HookGuard::DepthJumps),
            "the guard intervenes (climb: depth jumps), but no limit is near");
}

class JudgedOldFramesToScience : public JudgedOldFrames {
 protected:
  JudgedOldFramesToScience() : JudgedOldFrames(LineWay::FromFlight) {}
};

TEST_F(JudgedOldFramesToScience, ExcuseNothing) {
  EXPECT_EQ(guardsAt(48, hooks::HookGuard::DepthsDisagree),
            "the guard intervenes (climb: depths disagree), but no limit is near");
}

class JudgedLostBytes : public JudgedOldFrames {
 protected:
  JudgedLostBytes() : JudgedOldFrames(LineWay::ToFlight, 0) {}
};

TEST_F(JudgedLostBytes, ExcuseNothing) {
  EXPECT_EQ(guardsAt(48, hooks::HookGuard::DepthsDisagree),
            "the guard intervenes (climb: depths disagree), but no limit is near");
}

}  // namespace
}  // namespace glider::slocum::oracles
