// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/abi/behaviour.h"
#include "runtime/core/instruction.h"
#include "tests/unit/runtime/bench_mission.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

namespace glider::runtime::testing {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Three states whose cases the test lays out; `fire` is the case whose guard is true.
class StepTest : public ::testing::Test {
 protected:
  StepTest() {
    bench_.sensors = {depthSensor(), temperatureSensor()};
    bench_.states = {benchState("a", cases_, 6), benchState("b", cases_, 6),
                     benchState("c", cases_, 6)};
    bench_.guards = [this](const GliderContext& c) {
      seen_ = c.readings[0].value;
      return fire;
    };
    bench_.fly = [this](GliderContext& c, uint32_t phase) {
      phase_ = phase;
      flown_state_ = c.state;
      ++flown_;
    };
    bench_.finish(2);
  }
  enum : uint32_t { ToC, CallB, CallC, Back, Leave, Rest };
  GliderCaseInfo cases_[6] = {{kGliderGoto, 2},   {kGliderCall, 1}, {kGliderCall, 2},
                              {kGliderReturn, 0}, {kGliderExit, 0}, {kGliderStay, 0}};
  uint32_t fire = GLIDER_NO_CASE;
  double seen_ = 0;
  uint32_t phase_ = 99;
  uint32_t flown_state_ = 99;
  int flown_ = 0;
  BenchMission bench_;
};

TEST_F(StepTest, TheStartEntersTheFirstStateAndTriesNoGuard) {
  fire = ToC;
  const GliderContext* c = bench_.start({update(GLIDER_M_DEPTH, 3)});
  EXPECT_EQ(c->state, 0U);
  EXPECT_EQ(c->mission_time, 0);
  EXPECT_EQ(c->entered, 0);
  EXPECT_EQ(c->resumed, 0);
  EXPECT_EQ(c->fired_state, GLIDER_NO_CASE);
  EXPECT_EQ(phase_, static_cast<uint32_t>(kGliderEnter));
  EXPECT_EQ(c->readings[0].value, 3) << "its frame counts";
}

TEST_F(StepTest, GotoEmptiesTheStackAndEnters) {
  GliderContext* c = bench_.start();
  fire = CallB;
  step(c, 4);
  fire = ToC;
  step(c, 8);
  EXPECT_EQ(c->state, 2U);
  EXPECT_EQ(c->stack_depth, 0U);
  EXPECT_EQ(c->entered, 8);
  EXPECT_EQ(c->resumed, 8);
  EXPECT_EQ(phase_, static_cast<uint32_t>(kGliderEnter));
  EXPECT_EQ(flown_state_, 2U);
  EXPECT_EQ(c->fired_state, static_cast<uint32_t>(ToC));
}

TEST_F(StepTest, CallRemembersAndReturnResumes) {
  GliderContext* c = bench_.start();
  fire = GLIDER_NO_CASE;
  step(c, 4);
  EXPECT_EQ(phase_, static_cast<uint32_t>(kGliderTick));
  fire = CallB;
  step(c, 8);
  EXPECT_EQ(c->state, 1U);
  EXPECT_EQ(c->entered, 8);
  EXPECT_EQ(phase_, static_cast<uint32_t>(kGliderEnter));
  fire = CallC;
  step(c, 12);
  EXPECT_EQ(c->stack_depth, 2U);
  fire = Back;
  step(c, 16);
  EXPECT_EQ(c->state, 1U);
  EXPECT_EQ(c->entered, 8) << "statetime runs on through calls";
  EXPECT_EQ(c->resumed, 16);
  EXPECT_EQ(phase_, static_cast<uint32_t>(kGliderResume));
  step(c, 20);
  EXPECT_EQ(c->state, 0U);
  EXPECT_EQ(c->entered, 0);
  EXPECT_EQ(c->resumed, 20);
  EXPECT_EQ(c->stack_depth, 0U);
}

TEST_F(StepTest, StayFiresWithoutEffect) {
  GliderContext* c = bench_.start();
  fire = Rest;
  step(c, 4);
  EXPECT_EQ(c->fired_state, static_cast<uint32_t>(Rest));
  EXPECT_EQ(c->state, 0U);
  EXPECT_EQ(c->entered, 0);
  EXPECT_EQ(phase_, static_cast<uint32_t>(kGliderTick));
}

TEST_F(StepTest, ExitEndsTheMissionForGood) {
  GliderContext* c = bench_.start();
  fire = Leave;
  step(c, 4);
  EXPECT_EQ(c->finished, 1U);
  EXPECT_EQ(flown_, 1) << "nothing flies on the tick of the exit";
  fire = ToC;
  step(c, 8, {update(GLIDER_M_DEPTH, 7)});
  EXPECT_EQ(c->state, 0U);
  EXPECT_EQ(c->mission_time, 4);
  EXPECT_EQ(flown_, 1);
}

TEST_F(StepTest, WhatTheVerifierRulesOutChangesNothing) {
  GliderContext* c = bench_.start();
  fire = Back;
  step(c, 4);
  EXPECT_EQ(c->state, 0U) << "return on an empty stack";
  fire = CallB;
  step(c, 8);
  fire = CallC;
  step(c, 12);
  fire = CallB;
  step(c, 16);
  EXPECT_EQ(c->state, 2U) << "call on a full stack";
  EXPECT_EQ(c->stack_depth, 2U);
  fire = 6;
  step(c, 20);
  EXPECT_EQ(c->fired_state, GLIDER_NO_CASE) << "a case that is none";
}

TEST_F(StepTest, MissionTimeNeverGoesBack) {
  GliderContext* c = bench_.start();
  step(c, 8);
  step(c, 4);
  EXPECT_EQ(c->mission_time, 8);
  step(c, kNaN);
  EXPECT_EQ(c->mission_time, 8);
}

TEST_F(StepTest, GuardsSeeTheReadingsOfThisTick) {
  GliderContext* c = bench_.start({update(GLIDER_M_DEPTH, 3)});
  step(c, 4, {update(GLIDER_M_DEPTH, 4), update(GLIDER_M_PITCH, 1)});
  EXPECT_EQ(seen_, 4);
}

TEST_F(StepTest, AReadingIsUnknownWhenUnseenImplausibleOrStale) {
  GliderContext* c = bench_.start();
  EXPECT_TRUE(std::isnan(c->readings[0].value)) << "never seen";
  step(c, 4, {update(GLIDER_M_DEPTH, 5)});
  EXPECT_EQ(c->readings[0].value, 5);
  EXPECT_EQ(gliderAge(c, GLIDER_M_DEPTH), 0);
  step(c, 24);
  EXPECT_EQ(c->readings[0].value, 5) << "20 s old: not older than stale_after";
  EXPECT_EQ(gliderAge(c, GLIDER_M_DEPTH), 20);
  step(c, 24.5);
  EXPECT_TRUE(std::isnan(c->readings[0].value)) << "stale";
  for (const double bad : {kNaN, kInfinity, -kInfinity, -0.001, 1200.001}) {
    step(c, 28, {update(GLIDER_M_DEPTH, 5)});
    step(c, 28, {update(GLIDER_M_DEPTH, bad)});
    EXPECT_TRUE(std::isnan(c->readings[0].value)) << bad << " replaces the reading and is unknown";
  }
  step(c, 28, {update(GLIDER_M_DEPTH, 1200)});
  EXPECT_EQ(c->readings[0].value, 1200);
  EXPECT_TRUE(std::isnan(gliderRead(c, GLIDER_M_PITCH))) << "not subscribed";
  EXPECT_TRUE(std::isnan(gliderAge(c, GLIDER_M_PITCH)));
}

TEST(Readings, BecomeSiUnitsAndDegrees) {
  BenchMission bench;
  bench.sensors = {{"m_vacuum", nullptr, 0.5, -1e308, 1e308, 20, 1, kGliderLinear},
                   {"m_lat", nullptr, 1, -9000, 9000, 20, 2, kGliderDegreesMinutes}};
  bench.states = {benchState("a")};
  bench.finish(0);
  GliderContext* c = bench.start({update(1, 3), update(2, 3910.5)});
  EXPECT_EQ(c->readings[0].value, 1.5);
  EXPECT_EQ(c->readings[1].value, 39.175);
  struct {
    double raw, degrees;
  } const table[] = {{-7349.8058, -(73 + 49.8058 / 60)}, {0, 0}, {59.999, 59.999 / 60}, {100, 1}};
  for (const auto& row : table) {
    step(c, 4, {update(2, row.raw)});
    EXPECT_NEAR(c->readings[1].value, row.degrees, 1e-12);
  }
  for (const double raw : {60.0, 3960.0, -8999.0}) {
    step(c, 4, {update(2, raw)});
    EXPECT_TRUE(std::isnan(c->readings[1].value)) << raw << ": 60 minutes or more";
  }
}

TEST(Settle, DecidesOnTheBitPattern) {
  const double below = std::numeric_limits<double>::min();
  const double least = std::nextafter(below, 1);
  auto bits = [](double x) { return std::bit_cast<uint64_t>(x); };
  EXPECT_EQ(bits(gliderSettle(least)), bits(least));
  EXPECT_EQ(bits(gliderSettle(-least)), bits(-least));
  EXPECT_EQ(bits(gliderSettle(below)), 0U);
  EXPECT_EQ(bits(gliderSettle(-below)), 0U);
  EXPECT_EQ(bits(gliderSettle(-0.0)), 0U);
  EXPECT_EQ(bits(gliderSettle(1e308)), bits(1e308));
  for (const double unknown : {kInfinity, -kInfinity, kNaN, -kNaN}) {
    EXPECT_EQ(bits(gliderSettle(unknown)), 0x7FF8000000000000U);
  }
}

TEST_F(StepTest, CommandsSetWhatIsInForce) {
  GliderContext* c = bench_.start();
  gliderDescend(c, 20, .454);
  EXPECT_EQ(c->vertical, static_cast<uint32_t>(kGliderDescend));
  EXPECT_EQ(c->depth, 20);
  EXPECT_EQ(c->pitch, -.454);
  gliderAscend(c, 5, -.454);
  EXPECT_EQ(c->pitch, .454) << "the sign follows from the direction";
  gliderHover(c, 7);
  EXPECT_EQ(c->vertical, static_cast<uint32_t>(kGliderHover));
  EXPECT_EQ(c->pitch, 0);
  gliderSurface(c);
  EXPECT_EQ(c->vertical, static_cast<uint32_t>(kGliderSurface));
  EXPECT_EQ(c->depth, 0);
  gliderPump(c, -150e-6);
  EXPECT_EQ(c->vertical, static_cast<uint32_t>(kGliderActuators));
  EXPECT_NEAR(c->depth, -150, 1e-9);
  EXPECT_EQ(c->pitch, 0) << "the battery is in the middle";
  gliderBattery(c, 0.5 * 0.0254);
  EXPECT_NEAR(c->pitch, 0.5, 1e-12);
  EXPECT_NEAR(c->depth, -150, 1e-9) << "both are in force";
  gliderPump(c, 40e-6);
  EXPECT_NEAR(c->depth, 40, 1e-9);
  EXPECT_NEAR(c->pitch, 0.5, 1e-12);
  gliderHover(c, 7);
  gliderBattery(c, -0.25 * 0.0254);
  EXPECT_EQ(c->vertical, static_cast<uint32_t>(kGliderActuators));
  EXPECT_EQ(c->depth, 0) << "the pump is in the middle, not at 7";
  EXPECT_NEAR(c->pitch, -0.25, 1e-12);
  gliderSteer(c, -std::numbers::pi / 2);
  EXPECT_NEAR(c->heading, 1.5 * std::numbers::pi, 1e-15);
  gliderSteerTo(c, 39.175, -73.83);
  EXPECT_EQ(c->lateral, static_cast<uint32_t>(kGliderWaypoint));
  EXPECT_EQ(c->heading, 0);
  gliderFin(c, -0.25);
  EXPECT_EQ(c->lateral, static_cast<uint32_t>(kGliderFin));
  EXPECT_EQ(c->heading, -0.25) << "an angle, not wrapped";
  EXPECT_EQ(c->latitude, 0);
  gliderDriftFree(c);
  EXPECT_EQ(c->lateral, static_cast<uint32_t>(kGliderDrift));
  EXPECT_EQ(c->heading, 0);
  EXPECT_EQ(c->refused_commands, 0U);
}

TEST_F(StepTest, HeadingsAreWrappedIntoOneTurn) {
  GliderContext* c = bench_.start();
  constexpr double kTurn = 2 * std::numbers::pi;
  struct Row {
    double given, in_force;
  };
  for (const Row& row :
       {Row{0, 0}, Row{1, 1}, Row{kTurn, 0}, Row{-kTurn, 0}, Row{3 * kTurn, 0}, Row{kTurn + 1, 1},
        Row{-1, kTurn - 1}, Row{-kTurn - 1, kTurn - 1}, Row{-1e-300, 0}}) {
    gliderSteer(c, row.given);
    EXPECT_NEAR(c->heading, row.in_force, 1e-12) << row.given;
    EXPECT_GE(c->heading, 0) << row.given;
    EXPECT_LT(c->heading, kTurn) << row.given;
    EXPECT_FALSE(std::signbit(c->heading)) << row.given;
  }
  gliderSteer(c, std::nextafter(kTurn, 0));
  EXPECT_EQ(c->heading, std::nextafter(kTurn, 0));
  gliderSteer(c, -0.0);
  EXPECT_EQ(c->heading, 0);
}

TEST_F(StepTest, AnUnknownCommandChangesNothingAndIsCounted) {
  GliderContext* c = bench_.start();
  gliderDescend(c, 20, .454);
  gliderSteer(c, 1);
  gliderDescend(c, kNaN, .3);
  gliderAscend(c, 5, kNaN);
  gliderHover(c, kInfinity);
  gliderSteer(c, kNaN);
  gliderSteerTo(c, 39, kNaN);
  gliderFin(c, kNaN);
  gliderFin(c, -kInfinity);
  gliderPump(c, kNaN);
  gliderBattery(c, kNaN);
  gliderBattery(c, kInfinity);
  EXPECT_EQ(c->refused_commands, 10U);
  EXPECT_EQ(c->vertical, static_cast<uint32_t>(kGliderDescend));
  EXPECT_EQ(c->depth, 20);
  EXPECT_EQ(c->lateral, static_cast<uint32_t>(kGliderHeading));
  EXPECT_EQ(c->heading, 1);
}

TEST(Instruction, IsInTheArraysUnits) {
  GliderContext c{};
  gliderDescend(&c, 12.3, .454);
  gliderSteerTo(&c, 39.175, -73.83);
  const hooks::Instruction i = instructionFor(c);
  EXPECT_EQ(i.vertical, hooks::HookVertical::Descend);
  EXPECT_EQ(i.depth_m, 12.3);
  EXPECT_EQ(i.pitch_rad, -.454);
  EXPECT_NEAR(i.latitude_ddmm, 3910.5, 1e-9);
  EXPECT_NEAR(i.longitude_ddmm, -7349.8, 1e-9);
  EXPECT_EQ(degreesMinutesOf(std::nextafter(180.0, 0)), 18000) << "never 60 minutes";
  EXPECT_EQ(degreesMinutesOf(-0.5), -30);
  gliderSteer(&c, 0.5);
  EXPECT_EQ(instructionFor(c).heading_rad, 0.5) << "as it is, without a compass";
  gliderDriftFree(&c);
  EXPECT_EQ(instructionFor(c).heading_rad, 0);
  gliderSteer(&c, std::nextafter(2 * std::numbers::pi, 0));
  EXPECT_EQ(instructionFor(c).heading_rad, 0) << "the next whole step is past a full turn";
  for (const double angle : {-0.25, 0.25, 2 * std::numbers::pi}) {
    gliderFin(&c, angle);
    EXPECT_EQ(instructionFor(c).lateral, hooks::HookLateral::Fin);
    EXPECT_NEAR(instructionFor(c).heading_rad, angle, 0.000005)
        << "a fin that the vehicle must refuse is not 0";
  }
  gliderPump(&c, 233 * 1e-6);
  gliderBattery(&c, -0.6 * 0.0254);
  EXPECT_EQ(instructionFor(c).vertical, hooks::HookVertical::Actuators);
  EXPECT_EQ(instructionFor(c).depth_m, 233) << "not a bit more, which would be refused";
  EXPECT_DOUBLE_EQ(instructionFor(c).pitch_rad, -0.6);
}

}  // namespace
}  // namespace glider::runtime::testing
