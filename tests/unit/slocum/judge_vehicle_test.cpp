// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/hull.h"
#include "tests/unit/slocum/judged.h"

namespace glider::slocum::oracles {
namespace {

using hooks::HookState;
using Outcome = Verdict::Outcome;

// What FlightJudge must detect in the vehicle: each test plants one fault in a good flight's trace.

TEST_F(Judged, TrueDepthPastMaxDepthIsSeenForAnyReadingOfTheSensor) {
  take();
  reading_ = 20;
  out_.pitch_rad = 0.4;
  out_.pump_cc = 230;
  cycle(HookState::Active, 64.9);
  EXPECT_EQ(violation().find("deep under"), std::string::npos) << violation();
  cycle(HookState::Active, 65.1);
  EXPECT_EQ(violation(), "65.1 m deep under max_depth 60 m");
}

TEST_F(Judged, WithoutTheSbcTheDepthIsComparedWithOverdepth) {
  take();
  cycle(HookState::Silent, 10);
  cycle(HookState::Silent, 74);
  EXPECT_EQ(violation().find("deep under"), std::string::npos) << violation();
  cycle(HookState::Silent, 76);
  EXPECT_EQ(violation(), "76.0 m deep under overdepth 70 m");
}

TEST_F(Judged, ADepthFromBeforeTheLimitIsNotAViolationUntilItIsLeft) {
  cycle(HookState::Ready, 72);
  instruct(1, 1, hooks::HookControl::Take);
  arrive();
  obey(1);
  climb();
  cycle(HookState::Active, 73);
  EXPECT_EQ(violation().find("deep under"), std::string::npos) << violation();
  cycle(HookState::Active, 50);
  cycle(HookState::Active, 66);
  EXPECT_NE(violation().find("66.0 m deep under max_depth 60"), std::string::npos) << violation();
}

TEST_F(Judged, TheHullsLimitHoldsAlways) {
  cycle(HookState::Ready, 201);
  EXPECT_EQ(violation(), "201.0 m deep, and the hull is made for 200 m");
}

TEST_F(Judged, TooLittleClearanceIsSeen) {
  take();
  clearance_ = 1.1;
  climb();
  cycle(HookState::Active, 30);
  EXPECT_EQ(violation().find("over the bottom"), std::string::npos) << violation();
  clearance_ = 0.9;
  cycle(HookState::Active, 30);
  EXPECT_EQ(violation(), "0.9 m over the bottom under min_altitude 5 m");
}

TEST_F(Judged, TheBottomIsSeenAlsoWithoutTheSbc) {
  clearance_ = 0;
  cycle(HookState::Silent, 30);
  EXPECT_EQ(violation(), "the vehicle is on the bottom");
}

/// A dive goes on while the flight controller starts again.
TEST_F(Judged, TheBottomThatIsMetWithoutAFlightControllerIsNotAViolationUntilItIsLeft) {
  take();
  now_ += 170;
  clearance_ = 0;
  cycle(HookState::Ready, 65);
  cycle(HookState::Ready, 65);
  EXPECT_EQ(violation().find("bottom"), std::string::npos) << violation();
  clearance_ = 1;
  cycle(HookState::Ready, 64);
  clearance_ = 0;
  cycle(HookState::Ready, 65);
  EXPECT_EQ(violation(), "the vehicle is on the bottom");
}

TEST_F(Judged, TheBottomIsTouchedFromLessThanFiveCentimetresAndUnderWaterOnly) {
  clearance_ = 0.05;
  cycle(HookState::Ready, 30);
  clearance_ = 0;
  cycle(HookState::Ready, 1);
  EXPECT_EQ(violation().find("bottom"), std::string::npos) << violation();
  clearance_ = 0.049;
  cycle(HookState::Ready, 1.01);
  EXPECT_EQ(violation(), "the vehicle is on the bottom");
}

TEST_F(Judged, ThreeCyclesWithoutAFlightControllerAreNotDark) {
  cycle(HookState::Ready, 30);
  now_ += 2 * kCycle;
  clearance_ = 0;
  cycle(HookState::Ready, 30);
  EXPECT_EQ(violation(), "the vehicle is on the bottom");
}

TEST_F(Judged, WhatIsLongerThanThreeCyclesIsDark) {
  cycle(HookState::Ready, 30);
  now_ += 2 * kCycle + 0.1;
  clearance_ = 0;
  cycle(HookState::Ready, 30);
  EXPECT_EQ(violation().find("bottom"), std::string::npos) << violation();
}

/// Who came out of the dark in open water has a flight controller that minds the bottom.
TEST_F(Judged, AfterThePowerIsBackTheBottomIsSeenAgain) {
  cycle(HookState::Ready, 30);
  now_ += 40;
  cycle(HookState::Ready, 30);
  clearance_ = 0;
  cycle(HookState::Ready, 30);
  EXPECT_EQ(violation(), "the vehicle is on the bottom");
}

TEST_F(Judged, ACycleWithoutACommandIsSeen) {
  take();
  out_.commanding = false;
  now_ += kCycle;
  judge_.cycle({now_, HookState::Active, 10, false, false, array_, now_, 100, 0, 14, true, &out_});
  EXPECT_EQ(violation(), "heading, pitch and pump are not all commanded");
}

TEST_F(Judged, AnIdleStackIsSeen) {
  take();
  whole_ = false;
  cycle(HookState::Active, 10);
  EXPECT_EQ(violation(), "heading, pitch and pump are not all commanded");
}

TEST_F(Judged, ACommandThatIsNotANumberIsSeen) {
  take();
  out_.heading_rad = std::nan("");
  cycle(HookState::Active, 10);
  EXPECT_EQ(violation(), "heading, pitch and pump are not all commanded");
}

TEST_F(Judged, CommandsBeyondTheArgsAreSeen) {
  take();
  out_.pitch_rad = -0.7;
  cycle(HookState::Active, 10);
  EXPECT_EQ(violation(), "a pitch of -0.70 rad is commanded under max_pitch 0.61");
}

TEST_F(Judged, APumpBeyondTheArgsIsSeen) {
  take();
  out_.pump_cc = -240;
  cycle(HookState::Active, 10);
  EXPECT_EQ(violation(), "a pump of -240 cc is commanded");
}

TEST_F(Judged, CommandsWithoutControlAreSeen) {
  now_ += kCycle;
  judge_.cycle({now_, HookState::Silent, 10, false, false, array_, now_, 100, 0, 14, true, &out_});
  EXPECT_EQ(violation(), "hookbeh commands, and the SBC is not in control");
}

TEST_F(Judged, AGuardThatDoesNotClimbIsSeen) {
  take();
  reading_ = 61;
  out_.pitch_rad = 0;
  cycle(HookState::Active, 20);
  cycle(HookState::Active, 20);
  EXPECT_EQ(violation(), "m_depth says 61.0 m, and hookbeh does not climb");
}

TEST_F(Judged, AnUnknownDepthWithoutAClimbIsSeen) {
  take();
  for (int i = 0; i < 2; ++i) {
    now_ += kCycle;
    array_.set(GLIDER_M_DEPTH, std::nan(""));
    judge_.cycle(
        {now_, HookState::Active, 10, false, false, array_, now_, 100, 0, 14, true, &out_});
  }
  EXPECT_EQ(violation(), "the depth is unknown, and hookbeh does not climb");
}

TEST_F(Judged, AGuardThatDoesNotMindTheBottomIsSeen) {
  take();
  array_.set(GLIDER_M_ALTITUDE, 3.5);
  clearance_ = 3.5;
  for (int i = 0; i < 4; ++i) {
    cycle(HookState::Active, 10);
  }
  EXPECT_EQ(violation(), "3.5 m over the bottom, and hookbeh does not climb");
}

/// Nearer than 2 m to the bottom the altimeter receives nothing.
TEST_F(Judged, AGuardThatReceivesNoEchoNeedNotMindTheBottom) {
  take();
  clearance_ = 1.5;
  for (int i = 0; i < 6; ++i) {
    done(1);
    cycle(HookState::Active, 20);
  }
  EXPECT_EQ(violation().find("does not climb"), std::string::npos) << violation();
}

TEST_F(Judged, DivingByAFrozenDepthIsSeen) {
  take();
  while (now_ < 80) {
    done(1);
    cycle(HookState::Active, 10);
  }
  EXPECT_EQ(violation(), "dives for 28 s by a depth that is frozen");
}

TEST_F(Judged, DivingByAWrongDepthIsSeenWhereTheCtdWorks) {
  take();
  for (int i = 0; i < 18 && violation().find("by a depth of") == std::string::npos; ++i) {
    reading_ = 5 + 0.5 * i;
    done(1);
    cycle(HookState::Active, 15 + 0.5 * i);
  }
  EXPECT_EQ(violation(), "dives at 22.5 m by a depth of 12.5 m");
}

TEST_F(Judged, AGuardWithoutALimitIsSeen) {
  take();
  climb();
  out_.guard = hooks::HookGuard::TooDeep;
  out_.doing = hooks::Doing::TooDeep;
  cycle(HookState::Active, 10);
  EXPECT_EQ(violation(), "the guard intervenes (climb: too deep), but no limit is near");
}

TEST_F(Judged, AGuardThatIsNotReportedIsSeen) {
  take();
  climb();
  out_.doing = hooks::Doing::TooDeep;
  cycle(HookState::Active, 10);
  EXPECT_EQ(violation(), "x_hook_guard does not show `climb: too deep`");
}

TEST_F(Judged, AnInstructionThatIsNotCarriedOutIsSeen) {
  take();
  out_.pitch_rad = -0.4;
  cycle(HookState::Active, 10);
  EXPECT_EQ(violation(), "no dive to 20 m though it is in force");
}

/// hookbeh asks for the depth by a climb of its own, steeper or flatter than the one in force.
class JudgedClimb : public Judged {
 protected:
  explicit JudgedClimb(const JudgeSetup& judged = setup()) : Judged(judged) {}
  void ascend() {
    take();
    instruct(1, 2, hooks::HookControl::Take, 4, hooks::HookVertical::Ascend, 0.3);
    arrive();
    obey(2);
    climb();
  }
};

TEST_F(JudgedClimb, ADepthCheckOfHookbehCountsAsTheClimb) {
  ascend();
  out_.doing = hooks::Doing::CheckDepth;
  out_.pump_cc = 233;
  cycle(HookState::Active, 10);
  EXPECT_EQ(violation().find("no climb"), std::string::npos) << violation();
  out_.pump_cc = -230;
  cycle(HookState::Active, 10);
  EXPECT_EQ(violation(), "no climb to 4 m though it is in force");
}

TEST_F(JudgedClimb, AtAnotherPitchIsSeen) {
  ascend();
  out_.doing = hooks::Doing::ClimbTo;
  cycle(HookState::Active, 10);
  EXPECT_EQ(violation(), "no climb to 4 m though it is in force");
}

TEST_F(JudgedClimb, ADepthCheckOfHookbehCountsOnTheWayToAHover) {
  take();
  instruct(1, 2, hooks::HookControl::Take, 50, hooks::HookVertical::Hover, 0);
  arrive();
  obey(2);
  climb();
  out_.doing = hooks::Doing::CheckDepth;
  out_.pump_cc = 233;
  cycle(HookState::Active, 37);
  EXPECT_EQ(violation().find("no way"), std::string::npos) << violation();
  out_.doing = hooks::Doing::ClimbTo;
  out_.pump_cc = 230;
  cycle(HookState::Active, 36);
  EXPECT_EQ(violation(), "no way to 50 m though it is in force");
}

TEST_F(Judged, ATakeWithoutAWayUpOrDownEndsTheOneBefore) {
  take();
  instruct(1, 2, hooks::HookControl::Take, 0, hooks::HookVertical::None);
  arrive();
  obey(2);
  climb();
  cycle(HookState::Active, 10);
  EXPECT_EQ(violation().find("in force"), std::string::npos) << violation();
}

/// A mission file that gives the SBC less than all of the pump.
class JudgedPump : public JudgedClimb {
 protected:
  JudgedPump() : JudgedClimb(ofLessPump()) {}
  static JudgeSetup ofLessPump() {
    JudgeSetup judged = setup();
    judged.args.climb_pump_cc = 200;
    return judged;
  }
};

TEST_F(JudgedPump, HookbehsOwnClimbTakesAllOfIt) {
  ascend();
  out_.doing = hooks::Doing::CheckDepth;
  out_.pump_cc = 233;
  cycle(HookState::Active, 10);
  EXPECT_EQ(violation().find("a pump of"), std::string::npos) << violation();
  out_.pump_cc = 234;
  cycle(HookState::Active, 10);
  EXPECT_EQ(violation(), "a pump of 234 cc is commanded");
}

TEST_F(JudgedPump, AnotherClimbKeepsToItsArgument) {
  ascend();
  out_.doing = hooks::Doing::ClimbTo;
  cycle(HookState::Active, 10);
  EXPECT_EQ(violation(), "a pump of 230 cc is commanded");
}

TEST_F(Judged, ADiveThatGoesOnPastItsTargetIsSeen) {
  take();
  cycle(HookState::Active, 20.9);
  EXPECT_EQ(violation().find("diving"), std::string::npos) << violation();
  cycle(HookState::Active, 21.1);
  EXPECT_EQ(violation(), "still diving 1.1 m past 20 m");
}

TEST_F(Judged, HoveringFarFromItsDepthIsSeen) {
  take();
  cycle(HookState::Active, 20);
  out_.pitch_rad = 0;
  for (int i = 0; i < 16; ++i) {
    done(1);
    cycle(HookState::Active, 26.5);
  }
  EXPECT_EQ(violation(), "hovers 6.5 m from its depth");
}

TEST_F(Judged, AnInstructionOutsideTheArgsThatIsObeyedIsSeen) {
  take();
  instruct(1, 2, hooks::HookControl::Steer, 61);
  arrive();
  obey(2);
  cycle(HookState::Active);
  EXPECT_EQ(violation(), "instruction 2 is obeyed though it is outside the b_args");
}

TEST_F(Judged, ARefusalWithoutAReasonIsSeen) {
  take();
  instruct(1, 2, hooks::HookControl::Steer, 50);
  arrive();
  obey(2);
  array_.set(GLIDER_X_HOOK_ANSWER, static_cast<double>(hooks::HookAnswer::TooDeep));
  cycle(HookState::Active, 10);
  EXPECT_EQ(violation(), "instruction 2 is refused without a valid reason");
}

TEST_F(Judged, ALostSessionThatTakesControlAgainIsSeen) {
  take();
  cycle(HookState::Silent);
  instruct(1, 2, hooks::HookControl::Take);
  arrive();
  obey(2);
  cycle(HookState::Active, 10);
  EXPECT_EQ(violation(), "session 1 takes control though session 1 has lost it");
}

TEST_F(Judged, AfterARestartOfTheFlightControllerAnOldInstructionIsObeyedTwice) {
  take();
  restarted_s_ = now_;
  cycle(HookState::Active, 10);  // session 1 again, without a message of the SBC
  EXPECT_NE(violation(), "");
}

TEST_F(Judged, WhatGarbledInstructionsAnswerIsNotAnAnswer) {
  take();
  instruct(1, 2, hooks::HookControl::Steer, 5);
  array_.set(GLIDER_X_HOOK_SEQUENCE, 2);
  array_.set(GLIDER_X_HOOK_ANSWER, static_cast<double>(hooks::HookAnswer::BadCheck));
  fly(now_ + 36);
  EXPECT_EQ(violation().find("garbled"), std::string::npos) << violation();
  fly(now_ + 8);
  EXPECT_EQ(violation(), "the SBC is in control though its instruction is garbled for 36 s");
}

TEST_F(Judged, AVehicleThatDoesNotComeUpIsSeen) {
  take();
  while (now_ < 40 + 120 + 10 / 0.05) {
    cycle(HookState::Silent, 10);
  }
  EXPECT_EQ(violation().find("still"), std::string::npos) << violation();
  cycle(HookState::Silent, 10);
  cycle(HookState::Silent, 10);
  EXPECT_EQ(violation(), "still 10.0 m deep though nothing dives any more");
}

TEST_F(Judged, APumpThatDrainsTheBatteriesIsSeen) {
  take();
  used_J_ = 8000 + 3 * 3 * (now_ + kCycle) + 1;
  cycle(HookState::Silent);
  EXPECT_NE(violation().find("the batteries have given"), std::string::npos) << violation();
}

TEST(JudgeKept, ControlThatIsLostWithoutAReasonIsSeen) {
  JudgeSetup setup;
  setup.dictionary = slocumSensors();
  setup.promise = promiseOf(FaultKind::Clock);
  setup.hull_m = 200;
  setup.has_hookbeh = true;
  FlightJudge judge(setup);
  SensorArray array(shippedSetup("default").platform);
  array.set(GLIDER_X_HOOK_GUARD, 0);
  hooks::HookbehOutputs out;
  const auto cycle = [&](double now, HookState hook) {
    out.commanding = hook == HookState::Active;
    out.pitch_rad = 0.4;
    out.pump_cc = 200;
    judge.cycle({now, hook, 0.1, false, false, array, now, 100, 0, 14, true, &out});
  };
  cycle(4, HookState::Silent);
  EXPECT_EQ(judge.verdict().violation, "the mission does not release control");
  cycle(8, HookState::Active);
  cycle(12, HookState::Silent);
  EXPECT_NE(judge.verdict().violation, "");
}

TEST(JudgeForEver, LooksNoLongerThanSomethingCanCome) {
  JudgeSetup setup;
  setup.dictionary = slocumSensors();
  setup.faults.power = {{100, kForever}};
  setup.promise = promiseOf(FaultKind::Power);
  FlightJudge judge(setup);
  hooks::HookbehOutputs out;
  out.pitch_rad = 0.4;
  out.pump_cc = 200;
  SensorArray array(shippedSetup("default").platform);
  array.set(GLIDER_X_HOOK_GUARD, 0);
  double last = 0;
  for (double now = 0; now < 1000; now += kCycle) {
    const bool active = now < 132;
    out.commanding = active;
    if (!judge.cycle({now, active ? HookState::Active : HookState::Silent, now < 300 ? 10.0 : 0,
                      false, false, array, now, 100, 0, 14, true, &out})) {
      last = now;
      break;
    }
  }
  EXPECT_EQ(last, 300 + 60 + kCycle);
}

}  // namespace
}  // namespace glider::slocum::oracles
