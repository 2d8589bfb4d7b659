// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Who decides on instructions where the vehicle has no hookbeh.

#include "runtime/extctl/stand_in.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glider::runtime::extctl {
namespace {

using hooks::HookAnswer;
using hooks::HookControl;
using hooks::HookState;
using hooks::HookVertical;
using hooks::Instruction;

constexpr GliderPortMission kPort{60, 0.7854, 0.19, 10, 4711, 0, 0, 0, 0};

Instruction dive(uint16_t sequence, uint32_t session = 5, HookControl control = HookControl::Take) {
  return {.session = session,
          .sequence = sequence,
          .control = control,
          .vertical = HookVertical::Descend,
          .depth_m = 40,
          .pitch_rad = -0.4};
}

VehicleMission flying(double time_s) {
  return {.time_s = time_s, .program = 4711, .in_glider_dos = 0};
}

/// Has seen the vehicle's mission from its beginning.
StandIn watching() {
  StandIn stand_in(kPort, nullptr);
  stand_in.observe(flying(4));
  return stand_in;
}

TEST(StandIn, IsReadyForItsOwnMissionFileOnly) {
  StandIn stand_in(kPort, nullptr);
  EXPECT_EQ(stand_in.state(), HookState::Absent);
  stand_in.observe({.time_s = 4, .program = 4711});
  EXPECT_EQ(stand_in.state(), HookState::Waiting) << "what an earlier mission was sent may arrive";
  stand_in.observe({.time_s = 24, .program = 4711});
  EXPECT_EQ(stand_in.state(), HookState::Ready);
  stand_in.observe({.time_s = 28, .program = 12});
  EXPECT_EQ(stand_in.state(), HookState::Absent);
  stand_in.observe({.time_s = 32, .program = 4711, .in_glider_dos = 1});
  EXPECT_EQ(stand_in.state(), HookState::Absent);
  stand_in.observe({.program = 4711});
  EXPECT_EQ(stand_in.state(), HookState::Absent) << "no mission time";
}

TEST(StandIn, AnUnknownMissionFileIsItsOwnOnlyIfBothClocksSaySo) {
  StandIn fresh(kPort, nullptr);
  fresh.observe({.time_s = 400, .clock_s = 9400});
  EXPECT_EQ(fresh.state(), HookState::Waiting);
  fresh.instruct(dive(1));
  EXPECT_EQ(fresh.answer(), HookAnswer::NotReady);
  const VehicleMission last{.time_s = 300, .clock_s = 9300};
  StandIn restarted(kPort, &last);
  restarted.observe({.time_s = 400, .clock_s = 9400});
  EXPECT_EQ(restarted.state(), HookState::Silent);
  restarted.instruct(dive(1));
  EXPECT_EQ(restarted.answer(), HookAnswer::Accepted);
  restarted.observe({.time_s = 404, .clock_s = 9404});
  EXPECT_EQ(restarted.state(), HookState::Active);
  const VehicleMission others[] = {{.time_s = 400, .clock_s = 9400 + 86400},  // the next day
                                   {.time_s = 4, .clock_s = 9400},            // the next mission
                                   {.time_s = 400}};
  for (const VehicleMission& now : others) {
    StandIn stand_in(kPort, &last);
    stand_in.observe(now);
    EXPECT_EQ(stand_in.state(), HookState::Waiting) << now.time_s << " " << now.clock_s;
  }
}

TEST(StandIn, ADamagedNumberDoesNotEndASession) {
  StandIn stand_in = watching();
  stand_in.observe(flying(100));
  stand_in.instruct(dive(1));
  stand_in.observe({.time_s = 104, .program = 17});
  EXPECT_EQ(stand_in.state(), HookState::Active);
  stand_in.observe({.time_s = 2, .program = 17});
  EXPECT_EQ(stand_in.state(), HookState::Absent) << "another mission of the vehicle";
}

TEST(StandIn, RefusesWhatIsOutOfBoundsAndKeepsWhatIsInForce) {
  StandIn stand_in = watching();
  stand_in.observe(flying(40));
  stand_in.instruct(dive(1));
  EXPECT_EQ(stand_in.answer(), HookAnswer::Accepted);
  Instruction deep = dive(2, 5, HookControl::Steer);
  deep.depth_m = 60.5;
  stand_in.instruct(deep);
  EXPECT_EQ(stand_in.answer(), HookAnswer::TooDeep);
  EXPECT_EQ(stand_in.inForce()->depth_m, 40);
  Instruction flat = dive(3, 5, HookControl::Steer);
  flat.pitch_rad = -0.1;
  stand_in.instruct(flat);
  EXPECT_EQ(stand_in.answer(), HookAnswer::BadPitch);
  Instruction hover = dive(4, 5, HookControl::Steer);
  hover.vertical = HookVertical::Hover;
  stand_in.instruct(hover);
  EXPECT_EQ(stand_in.answer(), HookAnswer::BadCommand);
  Instruction fin = dive(5, 5, HookControl::Steer);
  fin.lateral = hooks::HookLateral::Fin;
  stand_in.instruct(fin);
  EXPECT_EQ(stand_in.answer(), HookAnswer::BadCommand);
  Instruction pump = dive(7, 5, HookControl::Steer);
  pump.vertical = HookVertical::Actuators;
  stand_in.instruct(pump);
  EXPECT_EQ(stand_in.answer(), HookAnswer::BadCommand);
  stand_in.instruct(dive(8, 6, HookControl::Steer));
  EXPECT_EQ(stand_in.answer(), HookAnswer::WrongSession);
  stand_in.instruct(dive(4));
  EXPECT_EQ(stand_in.answer(), HookAnswer::OldSequence);
}

TEST(StandIn, ANewMissionOfTheVehicleEndsTheSession) {
  StandIn stand_in = watching();
  stand_in.observe(flying(400));
  stand_in.instruct(dive(1));
  stand_in.observe(flying(404));
  EXPECT_EQ(stand_in.state(), HookState::Active);
  EXPECT_TRUE(stand_in.takeRestart()) << "the first that it sees";
  EXPECT_FALSE(stand_in.takeRestart());
  stand_in.observe(flying(3));
  EXPECT_TRUE(stand_in.takeRestart());
  EXPECT_EQ(stand_in.state(), HookState::Waiting);
  EXPECT_EQ(stand_in.session(), 0U);
  stand_in.observe(flying(23));
  stand_in.instruct(dive(2, 5));
  EXPECT_EQ(stand_in.answer(), HookAnswer::WrongSession) << "a session that was lost";
  stand_in.instruct(dive(3, 6));
  EXPECT_EQ(stand_in.answer(), HookAnswer::Accepted);
}

TEST(StandIn, AReleaseIsAnsweredWhenItHasBeenToldOftenEnough) {
  StandIn stand_in = watching();
  stand_in.observe(flying(40));
  stand_in.instruct(dive(1));
  stand_in.observe(flying(44));
  const Instruction release{.session = 5, .sequence = 2, .control = HookControl::Release};
  uint32_t cycles = 0;
  for (double now = 48; stand_in.answered() != 2 && cycles < 100; now += 4, ++cycles) {
    stand_in.instruct(release);
    EXPECT_TRUE(stand_in.released());
    stand_in.observe(flying(now));
  }
  EXPECT_EQ(cycles, StandIn::kReleaseCycles);
  StandIn stuck = watching();
  stuck.observe(flying(40));
  stuck.instruct(dive(1));
  stuck.observe(flying(44));
  for (double now = 48; now < 400; now += 4) {
    stuck.instruct(release);
    stuck.observe(flying(now), false);
  }
  EXPECT_EQ(stuck.answered(), 1) << "nothing of it has left";
  EXPECT_EQ(stand_in.answer(), HookAnswer::Accepted);
  EXPECT_EQ(stand_in.state(), HookState::Complete);
  stand_in.observe(flying(400));
  EXPECT_EQ(stand_in.state(), HookState::Complete);
  stand_in.observe(flying(2));
  EXPECT_EQ(stand_in.state(), HookState::Waiting) << "the vehicle's next mission";
  stand_in.observe(flying(22));
  EXPECT_EQ(stand_in.state(), HookState::Ready);
}

VehicleMission at(double time_s, bool at_surface) {
  VehicleMission vehicle = flying(time_s);
  vehicle.at_surface = at_surface;
  return vehicle;
}

TEST(StandIn, AProgramThatBeginsInTheMidstBringsTheVehicleUpFirst) {
  StandIn late(kPort, nullptr);
  double now = 400;
  for (; now < 600; now += 4) {
    late.observe(at(now, false));
    ASSERT_EQ(late.state(), HookState::Waiting) << now;
    EXPECT_TRUE(late.makesSafe());
    late.toldToComeUp();
    late.instruct(dive(1));
    EXPECT_EQ(late.answer(), HookAnswer::NotReady);
  }
  late.observe(at(now, true));
  EXPECT_EQ(late.state(), HookState::Ready);
  EXPECT_FALSE(late.makesSafe());

  StandIn floats(kPort, nullptr);
  floats.observe(at(396, true));
  for (now = 400; now < 400 + StandIn::kSafeSecs; now += 4) {
    floats.toldToComeUp();
    floats.observe(at(now, true));
    EXPECT_EQ(floats.state(), HookState::Waiting) << "what it was sent may not have arrived";
  }
  floats.observe(at(now, true));
  EXPECT_EQ(floats.state(), HookState::Ready);
}

TEST(StandIn, ItsTimeCountsFromTheFirstAnswerThatHasLeft) {
  StandIn floats(kPort, nullptr);
  EXPECT_TRUE(std::isnan(*floats.comesUpFor()));
  double now = 400;
  for (; now < 400 + 3 * StandIn::kSafeSecs; now += 4) {
    floats.observe(at(now, true));
    EXPECT_EQ(floats.state(), HookState::Waiting) << now << ": nothing has been written";
    EXPECT_EQ(*floats.comesUpFor(), now - 400);
  }
  floats.toldToComeUp();
  const double heard_s = now + 100;  // the vehicle was silent meanwhile
  for (now = heard_s; now < heard_s + StandIn::kSafeSecs; now += 4) {
    floats.observe(at(now, true));
    EXPECT_EQ(floats.state(), HookState::Waiting) << now;
  }
  floats.observe(at(now, true));
  EXPECT_EQ(floats.state(), HookState::Ready);
  EXPECT_TRUE(std::isnan(*floats.comesUpFor()));
}

TEST(StandIn, APortThatRestartsMeanwhileBeginsThatAgain) {
  StandIn late(kPort, nullptr);
  for (double now = 400; now < 440; now += 4) {
    late.observe(at(now, true));
    late.toldToComeUp();
  }
  late.forget();
  late.observe(at(456, true));
  EXPECT_TRUE(late.makesSafe());
  late.toldToComeUp();
  late.observe(at(460, true));
  late.observe(at(460 + StandIn::kSafeSecs - 1, true));
  EXPECT_EQ(late.state(), HookState::Waiting);
  late.observe(at(460 + StandIn::kSafeSecs, true));
  EXPECT_EQ(late.state(), HookState::Ready);
}

TEST(StandIn, OneThatGoesOnFromItsCheckpointDoesNot) {
  const VehicleMission last{.time_s = 300, .clock_s = 9300};
  VehicleMission now = at(400, false);
  now.clock_s = 9400;
  StandIn restarted(kPort, &last);
  restarted.observe(now);
  EXPECT_EQ(restarted.state(), HookState::Ready);
  now.time_s += 13 * 3600;
  now.clock_s += 13 * 3600;
  StandIn old(kPort, &last);
  old.observe(now);
  EXPECT_TRUE(old.makesSafe()) << "an old checkpoint is of another flight";
  now.clock_s += 86400;
  StandIn other(kPort, &last);
  other.observe(now);
  EXPECT_TRUE(other.makesSafe());
}

TEST(StandIn, NorDoesAVehicleThatFliesAnotherMissionFile) {
  VehicleMission now = at(400, false);
  now.program = 12;
  StandIn other(kPort, nullptr);
  other.observe(now);
  EXPECT_FALSE(other.makesSafe());
  now.program = 4711;
  now.in_glider_dos = 1;
  other.observe(now);
  EXPECT_FALSE(other.makesSafe());
  EXPECT_EQ(other.state(), HookState::Absent);
}

/// A program that is started again too late has no control to release, and the vehicle still dives
/// to what an earlier one has written.
TEST(StandIn, AProgramThatIsOverWithoutControlBringsTheVehicleUp) {
  const VehicleMission last{.time_s = 300, .clock_s = 9300};
  VehicleMission now = flying(1000);
  now.clock_s = 10000;
  StandIn late(kPort, &last);
  late.observe(now);
  EXPECT_EQ(late.state(), HookState::Ready);
  EXPECT_FALSE(late.released());
  for (uint32_t cycle = 0; cycle < StandIn::kReleaseCycles; ++cycle) {
    EXPECT_FALSE(late.mayEnd()) << cycle;
    EXPECT_TRUE(late.released()) << cycle;
    now.time_s += 4;
    late.observe(now, false);
    EXPECT_FALSE(late.mayEnd()) << "what is stuck on the line does not count";
    now.time_s += 4;
    late.observe(now);
  }
  EXPECT_TRUE(late.mayEnd());
  EXPECT_EQ(late.state(), HookState::Complete);
  EXPECT_TRUE(late.released());
}

TEST(StandIn, AProgramThatIsOverEndsAtOnceWhereAnotherMissionFlies) {
  StandIn stand_in = watching();
  VehicleMission now = flying(40);
  now.program = 12;
  stand_in.observe(now);
  EXPECT_TRUE(stand_in.mayEnd());
  EXPECT_FALSE(stand_in.released());
  // The vehicle's mission ends while it is brought up.
  stand_in.observe(flying(44));
  EXPECT_FALSE(stand_in.mayEnd());
  now = flying(48);
  now.in_glider_dos = 1;
  stand_in.observe(now);
  EXPECT_TRUE(stand_in.mayEnd());
}

}  // namespace
}  // namespace glider::runtime::extctl
