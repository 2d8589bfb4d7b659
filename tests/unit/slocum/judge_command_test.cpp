// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/unit/slocum/judged.h"
#include "vehicles/slocum/oracles/command_judge.h"

namespace glider::slocum::oracles {
namespace {

using hooks::Doing;
using hooks::HookGuard;

// What CommandJudge must detect in the climbs of hookbeh's guards and after them, and what it must
// not.

class JudgedCommand : public testing::Test {
 protected:
  JudgedCommand() : array_(shippedSetup("default").platform) {
    setup_.promise = promiseOf(FaultKind::Power);
    setup_.args.greatest_depth_m = 60;
    setup_.args.least_altitude_m = 5;
    setup_.pump_cc = 233;
    out_.commanding = true;
  }
  void command(double pitch_rad, double pump_cc, Doing doing, HookGuard guard = HookGuard::None) {
    out_.pitch_rad = pitch_rad;
    out_.pump_cc = pump_cc;
    out_.doing = doing;
    out_.guard = guard;
  }
  void climbByGuard() { command(0.4538, 233, Doing::NearBottom, HookGuard::NearBottom); }
  std::string cycle(double depth, bool echo) {
    now_ += kCycle;
    array_.beginCycle();
    array_.set(GLIDER_M_DEPTH, depth);
    if (echo) {
      array_.set(GLIDER_M_ALTITUDE, kBottom - depth);
    }
    array_.set(GLIDER_X_HOOK_GUARD, static_cast<double>(out_.guard));
    CycleView view{now_, hooks::HookState::Active, depth, false, false, array_, now_};
    view.clearance_m = kBottom - depth;
    view.hookbeh = &out_;
    view.masked = masked_;
    return judge_.cycle(view);
  }
  /// The first violation of a vehicle that climbs by a guard from `from` to `to`; an
  /// echo comes while it is deeper than `echo_below`.
  std::string climb(double from, double to, double echo_below) {
    std::string wrong;
    for (double depth = from; depth > to && wrong.empty(); depth -= 0.8) {
      wrong = cycle(depth, depth > echo_below);
    }
    return wrong;
  }
  void obey(hooks::HookVertical vertical, double depth, double pitch) {
    hooks::Instruction instruction;
    instruction.control = hooks::HookControl::Take;
    instruction.vertical = vertical;
    instruction.depth_m = depth;
    instruction.pitch_rad = pitch;
    judge_.answered(instruction, hooks::HookAnswer::Accepted);
  }

  static constexpr double kBottom = 40;
  JudgeSetup setup_;
  CommandJudge judge_{setup_};
  hooks::HookbehOutputs out_;
  SensorArray array_;
  double now_ = 0;
  uint8_t masked_ = 0;
};

TEST_F(JudgedCommand, AFinThatIsNotHeldAsCommandedIsSeen) {
  hooks::Instruction instruction;
  instruction.control = hooks::HookControl::Take;
  instruction.vertical = hooks::HookVertical::Descend;
  instruction.depth_m = 57;
  instruction.pitch_rad = -0.4538;
  instruction.lateral = hooks::HookLateral::Fin;
  instruction.heading_rad = -0.25;
  EXPECT_EQ(judge_.answered(instruction, hooks::HookAnswer::Accepted), "");
  command(-0.4538, -230, Doing::DiveTo);
  const auto held = [&](hooks::HeadingMode mode, double angle) {
    out_.heading_mode = mode;
    out_.fin_rad = angle;
    return cycle(10, false);
  };
  using Mode = hooks::HeadingMode;
  EXPECT_EQ(held(Mode::Fin, -0.25), "");
  EXPECT_EQ(held(Mode::Fin, 0.25), "the fin is held at 0.25 rad though -0.25 rad is commanded");
  EXPECT_EQ(held(Mode::CentreFin, 0), "the fin is not held though -0.25 rad is commanded");
  EXPECT_EQ(held(Mode::Heading, 0), "the fin is not held though -0.25 rad is commanded");
  EXPECT_EQ(held(Mode::Fin, 0.5), "a fin of 0.50 rad is commanded under max_fin 0.45");
  instruction.control = hooks::HookControl::Steer;
  instruction.lateral = hooks::HookLateral::Drift;
  EXPECT_EQ(judge_.answered(instruction, hooks::HookAnswer::Accepted), "");
  EXPECT_EQ(held(Mode::CentreFin, 0), "");
  EXPECT_EQ(held(Mode::Fin, -0.25), "the fin is held though no angle of it is commanded");
}

TEST_F(JudgedCommand, PumpAndBatteryThatAreNotWhereTheyAreCommandedAreSeen) {
  hooks::Instruction instruction;
  instruction.control = hooks::HookControl::Take;
  instruction.vertical = hooks::HookVertical::Actuators;
  instruction.depth_m = -50;
  instruction.pitch_rad = 0.25;
  EXPECT_EQ(judge_.answered(instruction, hooks::HookAnswer::Accepted), "");
  const auto moved = [&](hooks::PitchMode mode, double pump_cc, double battery_in) {
    command(0, pump_cc, Doing::Actuators);
    out_.pitch_mode = mode;
    out_.battery_in = battery_in;
    return cycle(10, false);
  };
  using Mode = hooks::PitchMode;
  const std::string elsewhere =
      "pump and battery are not at -50 cc and 0.25 in though this is in force";
  EXPECT_EQ(moved(Mode::Battery, -50, 0.25), "");
  EXPECT_EQ(moved(Mode::Battery, 50, 0.25), elsewhere);
  EXPECT_EQ(moved(Mode::Battery, -50, -0.25), elsewhere);
  EXPECT_EQ(moved(Mode::Servo, -50, 0), elsewhere);
  EXPECT_EQ(moved(Mode::Battery, -240, 0.25),
            "a pump of -240 cc and a battery of 0.25 in are commanded");
  EXPECT_EQ(moved(Mode::Battery, -50, 0.9),
            "a pump of -50 cc and a battery of 0.90 in are commanded");
  instruction.control = hooks::HookControl::Steer;
  instruction.vertical = hooks::HookVertical::Surface;
  EXPECT_EQ(judge_.answered(instruction, hooks::HookAnswer::Accepted), "");
  command(0.4538, 230, Doing::Surface);
  out_.pitch_mode = Mode::Battery;
  out_.battery_in = 0.25;
  EXPECT_EQ(cycle(10, false), "the pitch battery is held though no position of it is commanded");
}

TEST_F(JudgedCommand, APumpOrBatteryBeyondItsLimitMustBeRefused) {
  hooks::Instruction instruction;
  instruction.control = hooks::HookControl::Take;
  instruction.vertical = hooks::HookVertical::Actuators;
  using hooks::HookAnswer;
  for (const double side : {-1.0, 1.0}) {
    instruction.pitch_rad = 0;
    instruction.depth_m = side * 234;
    EXPECT_NE(judge_.answered(instruction, HookAnswer::Accepted), "") << side;
    EXPECT_NE(judge_.answered(instruction, HookAnswer::BadBattery), "") << side;
    EXPECT_EQ(judge_.answered(instruction, HookAnswer::BadPump), "") << side;
    instruction.depth_m = side * 232;
    EXPECT_NE(judge_.answered(instruction, HookAnswer::BadPump), "") << side;
    instruction.pitch_rad = side * 0.61;
    EXPECT_NE(judge_.answered(instruction, HookAnswer::Accepted), "") << side;
    EXPECT_EQ(judge_.answered(instruction, HookAnswer::BadBattery), "") << side;
  }
}

TEST_F(JudgedCommand, AFinBeyondItsLimitMustBeRefused) {
  hooks::Instruction instruction;
  instruction.control = hooks::HookControl::Take;
  instruction.vertical = hooks::HookVertical::Surface;
  instruction.lateral = hooks::HookLateral::Fin;
  for (const double side : {-1.0, 1.0}) {
    instruction.heading_rad = side * 0.46;
    EXPECT_NE(judge_.answered(instruction, hooks::HookAnswer::Accepted), "") << side;
    EXPECT_EQ(judge_.answered(instruction, hooks::HookAnswer::BadFin), "") << side;
    instruction.heading_rad = side * 0.44;
    EXPECT_NE(judge_.answered(instruction, hooks::HookAnswer::BadFin), "") << side;
  }
}

TEST_F(JudgedCommand, AGuardThatClimbsOnAndOnIsSeen) {
  obey(hooks::HookVertical::Descend, 57, -0.4538);
  command(-0.4538, -230, Doing::DiveTo);
  EXPECT_EQ(cycle(33, true), "");
  climbByGuard();
  EXPECT_EQ(climb(33, 15, 0), "") << "half the way";
  EXPECT_EQ(climb(15, 1, 0), "the guard does not release control");
}

/// Without an echo the bottom may have risen below the vehicle.
TEST_F(JudgedCommand, ItsClimbCountsFromWhereAnEchoShowsTheBottomAgain) {
  obey(hooks::HookVertical::Descend, 57, -0.4538);
  command(-0.4538, -230, Doing::DiveTo);
  EXPECT_EQ(cycle(33, true), "");
  climbByGuard();
  std::string wrong = climb(33, 15, 30);
  EXPECT_EQ(wrong, "");
  EXPECT_EQ(climb(15, 8, 0), "");
  EXPECT_EQ(climb(8, 0, 0), "the guard does not release control");
}

/// An altimeter that reports NaN in every cycle reports no echo.
TEST_F(JudgedCommand, AnAltitudeThatIsNotANumberIsNoEcho) {
  NewestEcho newest;
  for (const double altitude : {12.0, std::nan(""), -1.0}) {
    now_ += 60;
    array_.beginCycle();
    array_.set(GLIDER_M_ALTITUDE, altitude);
    newest.cycle({now_, hooks::HookState::Active, 10, false, false, array_, now_});
    EXPECT_EQ(newest.age(), now_ - 60);
  }
}

TEST_F(JudgedCommand, AfterAGuardItGoesBackToItsDepthUnlessAnotherBehaviourSteers) {
  for (const bool steered : {true, false}) {
    judge_.restart();
    obey(hooks::HookVertical::Hover, 30, 0);
    command(0, 0, Doing::Hover);
    EXPECT_EQ(cycle(30, true), "");
    command(0.4538, 233, Doing::TooDeep, HookGuard::TooDeep);
    EXPECT_EQ(cycle(59, true), "");
    command(0, 0, Doing::Hover);
    masked_ = steered ? hooks::kMaskedPump : uint8_t{0};
    EXPECT_EQ(cycle(20, true), steered ? "" : "no way back to 30 m");
    masked_ = 0;
    EXPECT_EQ(cycle(20, true), steered ? "" : "no way back to 30 m") << "it knows a cycle later";
  }
}

/// hookbeh counts the seconds in which the vehicle turns twice as ones of a dive.
TEST_F(JudgedCommand, ADiveIsLateAfterABriefClimbOfAGuardOnly) {
  for (const int cycles : {2, 6}) {
    judge_.restart();
    obey(hooks::HookVertical::Descend, 57, -0.4538);
    command(-0.4538, -230, Doing::DiveTo);
    EXPECT_EQ(cycle(20, true), "");
    command(0.4538, 233, Doing::NearBottom, HookGuard::NearBottom);
    now_ += 60;  // without an echo
    for (int i = 0; i < cycles; ++i) {
      EXPECT_EQ(cycle(20, false), "");
    }
    command(-0.4538, -230, Doing::DiveTo);
    for (int i = 0; i < 10; ++i) {
      EXPECT_EQ(cycle(20 + 0.2 * i, true), "");
    }
    command(0.4538, 233, Doing::NoDepthGained, HookGuard::NoDepthGained);
    EXPECT_EQ(
        cycle(22, true),
        cycles == 2 ? "" : "the guard intervenes (climb: no depth gained), but no limit is near");
    command(-0.4538, -230, Doing::DiveTo);
    cycle(22, true);
  }
}

}  // namespace
}  // namespace glider::slocum::oracles
