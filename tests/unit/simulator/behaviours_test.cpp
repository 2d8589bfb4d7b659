// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/behaviour.h"
#include "simulator/slocum/flight/layered_control.h"
#include "tests/unit/simulator/behaviour_bench.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

/// Each behaviour by itself, cycle by cycle: what it commands, when it begins and when it ends.
namespace glider::simulator {
namespace {

constexpr double kNotSet = std::numeric_limits<double>::quiet_NaN();
using State = Behaviour::State;

Commands filled() {
  Commands commands;
  commands.steer({});
  commands.point({});
  commands.pump(0);
  return commands;
}

/// A condition with plain numbers.
WhenCondition when(int code, double secs, double distance_m) {
  static const MissionVariables kNone{{}};
  return {
      code, {.secs = {secs, kNone}, .distance_m = {distance_m, kNone}}, Code15::FarFromWaypoint};
}

TEST(When, Codes) {
  const Situation at{.time_s = 100, .waypoint_distance_m = 10, .silent_s = 50};
  Commands no_heading = filled(), no_pitch = filled(), no_pump = filled();
  no_heading.heading.reset();
  no_pitch.pitch.reset();
  no_pump.pump_cc.reset();
  struct Row {
    int code;
    bool full, heading, pitch, pump;
  };
  for (const Row& row : {Row{0, true, true, true, true}, Row{1, false, true, true, true},
                         Row{2, false, false, true, false}, Row{3, false, true, false, false},
                         Row{4, false, false, false, true}, Row{5, false, false, false, false}}) {
    const WhenCondition condition = when(row.code, 1e9, 0);
    EXPECT_EQ(condition.met(at, filled()), row.full) << row.code;
    EXPECT_EQ(condition.met(at, no_heading), row.heading) << row.code;
    EXPECT_EQ(condition.met(at, no_pitch), row.pitch) << row.code;
    EXPECT_EQ(condition.met(at, no_pump), row.pump) << row.code;
  }
  EXPECT_FALSE(when(7, 0, 10).met(at, filled())) << "not nearer than 10 m";
  EXPECT_TRUE(when(7, 0, 10.1).met(at, filled()));
  EXPECT_FALSE(when(12, 50, 0).met(at, filled())) << "not longer than 50 s";
  EXPECT_TRUE(when(12, 49.9, 0).met(at, filled()));
  WhenCondition since_end = when(6, 40, 0), since_start = when(9, 40, 0);
  EXPECT_TRUE(since_end.met(at, filled())) << "100 s since the mission's start";
  EXPECT_TRUE(since_start.met(at, filled()));
  since_end.noteEnd(60);
  since_start.noteStart(60);
  EXPECT_TRUE(since_end.met(at, filled())) << "40 s to the second";
  EXPECT_TRUE(since_start.met(at, filled()));
  since_end.noteStart(99);
  since_start.noteEnd(99);
  EXPECT_TRUE(since_end.met(at, filled()));
  EXPECT_TRUE(since_start.met(at, filled()));
  since_end.noteEnd(60.1);
  since_start.noteStart(60.1);
  EXPECT_FALSE(since_end.met(at, filled()));
  EXPECT_FALSE(since_start.met(at, filled()));
}

TEST(Commands, IdleSlotsAndWhoFilledThem) {
  Commands commands;
  EXPECT_EQ(commands.idleAbort(), Abort::StackIdle);
  EXPECT_TRUE(commands.anyIdle());
  commands.layer = 4;
  commands.steer({});
  EXPECT_EQ(commands.idleAbort(), Abort::PitchIdle);
  commands.layer = 2;
  commands.point({});
  EXPECT_EQ(commands.idleAbort(), Abort::PumpIdle);
  EXPECT_TRUE(commands.anyIdle());
  commands.layer = 1;
  commands.pump(3);
  EXPECT_EQ(commands.idleAbort(), Abort::None);
  EXPECT_FALSE(commands.anyIdle());
  EXPECT_EQ(commands.heading_layer, 4);
  EXPECT_EQ(commands.pitch_layer, 2);
  EXPECT_EQ(commands.pump_layer, 1);
  commands.heading.reset();
  EXPECT_EQ(commands.idleAbort(), Abort::HeadingIdle);
}

const std::string kYoBehaviour =
    "behavior: yo\n b_arg: start_when(enum) 0\n b_arg: num_half_cycles_to_do(nodim) 3\n"
    " b_arg: end_action(enum) 0\n b_arg: d_target_depth(m) 20\n b_arg: d_target_altitude(m) 6\n"
    " b_arg: c_target_depth(m) 4\n b_arg: d_pitch_value(rad) -0.4\n b_arg: c_pitch_value(rad) 0.5\n"
    " b_arg: d_bpump_value(cc) -200\n b_arg: c_bpump_value(cc) 210\n"
    " b_arg: d_stop_when_hover_for(s) 40\n b_arg: d_stop_when_stalled_for(s) 60\n";

TEST(Yo, GoesDownAndUpBetweenItsDepths) {
  BehaviourBench yo(kYoBehaviour);
  yo.run({.time_s = 0, .depth_m = 0, .depth_rate_mps = 0.2, .altitude_m = kNotSet});
  EXPECT_EQ(yo.commands.pitch->value, -0.4);
  EXPECT_EQ(yo.commands.pitch->mode, PitchCommand::Mode::Servo);
  EXPECT_EQ(*yo.commands.pump_cc, -200);
  EXPECT_FALSE(yo.commands.heading) << "a yo does not steer";
  yo.run({.time_s = 4, .depth_m = 19.99, .depth_rate_mps = 0.2, .altitude_m = kNotSet});
  EXPECT_EQ(*yo.commands.pump_cc, -200);
  yo.run({.time_s = 8, .depth_m = 20, .depth_rate_mps = 0.2, .altitude_m = kNotSet});
  EXPECT_EQ(*yo.commands.pump_cc, 210);
  EXPECT_EQ(yo.commands.pitch->value, 0.5);
  yo.run({.time_s = 12, .depth_m = 4.01, .depth_rate_mps = -0.2, .altitude_m = kNotSet});
  EXPECT_EQ(*yo.commands.pump_cc, 210);
  yo.run({.time_s = 16, .depth_m = 4, .depth_rate_mps = -0.2, .altitude_m = kNotSet});
  EXPECT_EQ(*yo.commands.pump_cc, -200);
  EXPECT_EQ(yo.state(), State::Active);
  yo.run({.time_s = 20, .depth_m = 21, .depth_rate_mps = 0.2, .altitude_m = kNotSet});
  EXPECT_EQ(yo.state(), State::Complete) << "three half cycles";
  EXPECT_FALSE(yo.commands.pump_cc) << "in its last cycle it commands nothing";
}

TEST(Yo, TurnsAboveTheBottom) {
  BehaviourBench yo(kYoBehaviour);
  yo.run({.time_s = 0, .depth_m = 10, .depth_rate_mps = 0.2, .altitude_m = 6.01});
  EXPECT_EQ(*yo.commands.pump_cc, -200);
  yo.run({.time_s = 4, .depth_m = 10.5, .depth_rate_mps = 0.2, .altitude_m = kNotSet});
  EXPECT_EQ(*yo.commands.pump_cc, -200);
  yo.run({.time_s = 8, .depth_m = 11, .depth_rate_mps = 0.2, .altitude_m = 6});
  EXPECT_EQ(*yo.commands.pump_cc, 210);
  // By default a climb looks at no altitude, and without a target a dive neither.
  yo.run({.time_s = 12, .depth_m = 10, .depth_rate_mps = -0.2, .altitude_m = 60});
  EXPECT_EQ(*yo.commands.pump_cc, 210);
  BehaviourBench deep(kYoBehaviour + " b_arg: start_diving(bool) 1\n");
  BehaviourBench none(
      "behavior: yo\n b_arg: start_when(enum) 0\n b_arg: d_target_altitude(m) -1\n");
  none.run({.time_s = 0, .depth_m = 1, .depth_rate_mps = 0.2, .altitude_m = -2});
  EXPECT_EQ(*none.commands.pump_cc, -260);
}

TEST(Yo, AClimbMayEndAtAnAltitude) {
  BehaviourBench yo(
      "behavior: yo\n b_arg: start_when(enum) 0\n b_arg: start_diving(bool) 0\n"
      " b_arg: c_target_depth(m) 0\n b_arg: c_target_altitude(m) 30\n");
  yo.run({.time_s = 0, .depth_m = 15, .depth_rate_mps = -0.2, .altitude_m = 29.9});
  EXPECT_EQ(*yo.commands.pump_cc, 260);
  yo.run({.time_s = 4, .depth_m = 8, .depth_rate_mps = -0.2, .altitude_m = 30});
  EXPECT_EQ(*yo.commands.pump_cc, -260);
}

TEST(Yo, HoveringEndsALeg) {
  // A quarter of 0.19 m/s is the slowest that counts as moving.
  BehaviourBench yo(kYoBehaviour);
  yo.run({.time_s = 0, .depth_m = 5, .depth_rate_mps = 0.2, .altitude_m = kNotSet});
  double depth = 5;
  for (double t = 4; t < 40; t += 4) {
    yo.run(
        {.time_s = t, .depth_m = depth += 0.19, .depth_rate_mps = 0.0474, .altitude_m = kNotSet});
    ASSERT_EQ(*yo.commands.pump_cc, -200) << t;
  }
  yo.run({.time_s = 39.9, .depth_m = depth, .depth_rate_mps = -0.0476, .altitude_m = kNotSet});
  yo.run({.time_s = 79.8, .depth_m = depth + 2, .depth_rate_mps = 0.0474, .altitude_m = kNotSet});
  EXPECT_EQ(*yo.commands.pump_cc, -200);
  yo.run({.time_s = 79.9, .depth_m = depth + 2, .depth_rate_mps = -0.0474, .altitude_m = kNotSet});
  EXPECT_EQ(*yo.commands.pump_cc, 210);
}

TEST(Yo, NoWayMadeEndsALeg) {
  // The vehicle heaves, so it does not hover, but gains no metre.
  BehaviourBench yo(kYoBehaviour);
  yo.run({.time_s = 0, .depth_m = 5, .depth_rate_mps = 0.2, .altitude_m = kNotSet});
  yo.run({.time_s = 50, .depth_m = 6, .depth_rate_mps = 0.2, .altitude_m = kNotSet});
  yo.run({.time_s = 80, .depth_m = 5.2, .depth_rate_mps = -0.2, .altitude_m = kNotSet});
  yo.run({.time_s = 109.9, .depth_m = 6.99, .depth_rate_mps = 0.2, .altitude_m = kNotSet});
  EXPECT_EQ(*yo.commands.pump_cc, -200) << "60 s after the gain to 6 m are not over";
  yo.run({.time_s = 110, .depth_m = 6.99, .depth_rate_mps = 0.2, .altitude_m = kNotSet});
  EXPECT_EQ(*yo.commands.pump_cc, 210);
  // The climb of it, 240 s by default.
  yo.run({.time_s = 200, .depth_m = 5.99, .depth_rate_mps = -0.2, .altitude_m = kNotSet});
  yo.run({.time_s = 439, .depth_m = 5.5, .depth_rate_mps = -0.2, .altitude_m = kNotSet});
  EXPECT_EQ(*yo.commands.pump_cc, 210);
  yo.run({.time_s = 440, .depth_m = 5.5, .depth_rate_mps = -0.2, .altitude_m = kNotSet});
  EXPECT_EQ(*yo.commands.pump_cc, -200);
}

TEST(Yo, WhatAnotherFliesIsNotItsStall) {
  BehaviourBench yo(kYoBehaviour);
  yo.run({.time_s = 0, .depth_m = 5, .depth_rate_mps = 0, .altitude_m = kNotSet});
  yo.behaviour->noteMasked(hooks::kMaskedPump);
  yo.run({.time_s = 500, .depth_m = 5, .depth_rate_mps = 0, .altitude_m = kNotSet});
  EXPECT_EQ(*yo.commands.pump_cc, -200);
  yo.behaviour->noteMasked(0);
  yo.run({.time_s = 539, .depth_m = 5, .depth_rate_mps = 0, .altitude_m = kNotSet});
  EXPECT_EQ(*yo.commands.pump_cc, -200) << "its 40 s begin when it has the motors again";
  yo.run({.time_s = 540, .depth_m = 5, .depth_rate_mps = 0, .altitude_m = kNotSet});
  EXPECT_EQ(*yo.commands.pump_cc, 210);
  yo.behaviour->noteMasked(hooks::kMaskedPump);
  yo.run({.time_s = 544, .depth_m = 4, .depth_rate_mps = 0, .altitude_m = kNotSet});
  EXPECT_EQ(*yo.commands.pump_cc, -200) << "a target that is reached counts";
}

TEST(Yo, BeginsAgainFromItsFirstLeg) {
  BehaviourBench yo(
      "behavior: yo\n b_arg: start_when(enum) 2\n b_arg: num_half_cycles_to_do(nodim) 1\n"
      " b_arg: end_action(enum) 2\n b_arg: d_target_depth(m) 20\n");
  Commands busy;
  busy.point({});
  yo.run({.time_s = 0, .depth_m = 0, .altitude_m = kNotSet}, busy);
  EXPECT_EQ(yo.state(), State::Waiting);
  yo.run({.time_s = 4, .depth_m = 0, .altitude_m = kNotSet});
  EXPECT_EQ(yo.state(), State::Active);
  yo.run({.time_s = 8, .depth_m = 20, .altitude_m = kNotSet});
  EXPECT_EQ(yo.state(), State::Waiting);
  yo.run({.time_s = 12, .depth_m = 10, .altitude_m = kNotSet});
  EXPECT_EQ(*yo.commands.pump_cc, -260);
}

TEST(Yo, ContradictingTargetsContinue) {
  BehaviourBench yo(
      "behavior: yo\n b_arg: start_when(enum) 0\n b_arg: d_target_depth(m) 5\n"
      " b_arg: c_target_depth(m) 15\n");
  yo.run({.time_s = 0, .depth_m = 10, .altitude_m = kNotSet});
  EXPECT_EQ(*yo.commands.pump_cc, -260) << "two legs in one cycle, then it dives";
  Journal journal;
  yo.behaviour->tell(0, journal);
  ASSERT_EQ(journal.events().size(), 2U);
  EXPECT_EQ(textOf(journal.events()[0]), "yo: dive_to over, half cycle 1");
  EXPECT_EQ(journal.events()[0].why, "m_depth 10.0 m, target 5 m");
  EXPECT_EQ(textOf(journal.events()[1]), "yo: climb_to over, half cycle 2");
  yo.behaviour->tell(0, journal);
  EXPECT_EQ(journal.events().size(), 2U);
}

TEST(Surface, WaitsForAFixAndForKeys) {
  BehaviourBench surface(
      "behavior: surface\n b_arg: start_when(enum) 0\n b_arg: end_action(enum) 1\n"
      " b_arg: gps_wait_time(s) 60\n b_arg: keystroke_wait_time(s) 30\n"
      " b_arg: c_pitch_value(rad) 0.3\n b_arg: c_bpump_value(cc) 500\n");
  surface.run({.time_s = 0, .depth_m = 10});
  EXPECT_EQ(surface.commands.pitch->value, 0.3);
  EXPECT_EQ(*surface.commands.pump_cc, 500);
  EXPECT_EQ(surface.commands.heading->mode, HeadingCommand::Mode::Fin);
  EXPECT_EQ(surface.commands.heading->value_rad, 0);
  EXPECT_TRUE(surface.behaviour->atWork());
  surface.run({.time_s = 100, .at_surface = true});
  surface.run({.time_s = 120, .at_surface = true, .gps_fix = true});
  surface.run({.time_s = 149, .at_surface = true, .gps_fix = true});
  EXPECT_EQ(surface.state(), State::Active);
  surface.run({.time_s = 150, .at_surface = true, .gps_fix = true});
  EXPECT_EQ(surface.state(), State::Waiting) << "for its next start";
  EXPECT_FALSE(surface.behaviour->endsMission());
  EXPECT_FALSE(surface.behaviour->atWork());
  EXPECT_EQ(*surface.commands.pump_cc, 500) << "it commands in its last cycle too";
}

TEST(Surface, WithoutAFixItWaitsItsTime) {
  BehaviourBench surface(
      "behavior: surface\n b_arg: start_when(enum) 0\n b_arg: end_action(enum) 0\n"
      " b_arg: gps_wait_time(s) 60\n");
  surface.run({.time_s = 0, .depth_m = 3});
  surface.run({.time_s = 100, .at_surface = true});
  surface.run({.time_s = 159, .depth_m = 1});
  EXPECT_EQ(surface.state(), State::Active);
  EXPECT_FALSE(surface.behaviour->endsMission());
  surface.run({.time_s = 160, .at_surface = true});
  EXPECT_EQ(surface.state(), State::Complete) << "end_action 0 waits for no keys";
  EXPECT_TRUE(surface.behaviour->endsMission());
}

TEST(Surface, LeavesAHeadingThatIsThere) {
  BehaviourBench surface("behavior: surface\n b_arg: start_when(enum) 0\n");
  Commands below;
  below.steer({HeadingCommand::Mode::Heading, 1.5, 0, 0});
  surface.run({.time_s = 0, .depth_m = 3}, below);
  EXPECT_EQ(surface.commands.heading->mode, HeadingCommand::Mode::Heading);
}

TEST(Surface, ComesAgainAfterItsTime) {
  BehaviourBench surface(
      "behavior: surface\n b_arg: start_when(enum) 6\n b_arg: when_secs(s) 200\n"
      " b_arg: end_action(enum) 2\n");
  surface.run({.time_s = 199});
  EXPECT_EQ(surface.state(), State::Waiting);
  surface.run({.time_s = 200, .at_surface = true, .gps_fix = true});
  EXPECT_EQ(surface.state(), State::Waiting) << "begun and over in one cycle";
  EXPECT_TRUE(surface.commands.pump_cc);
  surface.run({.time_s = 399});
  EXPECT_FALSE(surface.commands.pump_cc);
  surface.run({.time_s = 400});
  EXPECT_EQ(surface.state(), State::Active);
}

TEST(SetHeading, HoldsAHeadingOrTheFin) {
  BehaviourBench heading(
      "behavior: set_heading\n b_arg: use_heading(bool) 1\n b_arg: heading_value(rad) 1.25\n");
  heading.run({.time_s = 0});
  EXPECT_EQ(heading.commands.heading->mode, HeadingCommand::Mode::Heading);
  EXPECT_EQ(heading.commands.heading->value_rad, 1.25);
  EXPECT_FALSE(heading.commands.pitch);
  BehaviourBench fin(
      "behavior: set_heading\n b_arg: use_heading(enum) 4\n b_arg: heading_value(rad) 0.1\n"
      " b_arg: stop_when(enum) 9\n b_arg: when_secs(s) 50\n");
  fin.run({.time_s = 10});
  EXPECT_EQ(fin.commands.heading->mode, HeadingCommand::Mode::Fin);
  EXPECT_EQ(fin.commands.heading->value_rad, 0.1);
  fin.run({.time_s = 59});
  EXPECT_EQ(fin.state(), State::Active);
  fin.run({.time_s = 60});
  EXPECT_EQ(fin.state(), State::Complete) << "50 s after its own start";
  EXPECT_FALSE(fin.commands.heading);
}

TEST(GotoWpt, SteersThereUntilItIsNear) {
  BehaviourBench there(
      "behavior: goto_wpt\n b_arg: wpt_units(enum) 2\n b_arg: wpt_x(lon) -7350.1\n"
      " b_arg: wpt_y(lat) 3911.0\n b_arg: stop_when(enum) 7\n b_arg: when_wpt_dist(m) 25\n");
  there.run({.time_s = 0, .waypoint_distance_m = 3});
  EXPECT_EQ(there.commands.heading->mode, HeadingCommand::Mode::Waypoint)
      << "the distance is still that of the waypoint before";
  EXPECT_EQ(there.commands.heading->latitude_ddmm, 3911.0);
  EXPECT_EQ(there.commands.heading->longitude_ddmm, -7350.1);
  there.run({.time_s = 4, .waypoint_distance_m = 25});
  EXPECT_EQ(there.state(), State::Active);
  there.run({.time_s = 8, .waypoint_distance_m = 24.9});
  EXPECT_EQ(there.state(), State::Complete);
  EXPECT_FALSE(there.commands.heading);
}

Abort abortOf(const std::string& arguments, std::initializer_list<Situation> cycles) {
  BehaviourBench abend("behavior: abend\n" + arguments);
  std::string why;
  for (const Situation& s : cycles) {
    abend.run(s);
  }
  return abend.behaviour->abort(why);
}

TEST(Abend, WatchesEachLimitAtItsEdge) {
  const std::string off = " b_arg: undervolts(volts) -1\n b_arg: samedepth_for(s) -1\n";
  const auto overdepth = " b_arg: overdepth(m) 50\n" + off;
  EXPECT_EQ(abortOf(overdepth, {{.depth_m = 50}}), Abort::None);
  EXPECT_EQ(abortOf(overdepth, {{.depth_m = 50.1}}), Abort::Overdepth);
  EXPECT_EQ(abortOf(overdepth, {{.depth_m = kNotSet}}), Abort::None);
  EXPECT_EQ(abortOf(" b_arg: overdepth(m) -1\n" + off, {{.depth_m = 50}}), Abort::None);
  const auto overtime = " b_arg: overtime(s) 100\n" + off;
  EXPECT_EQ(abortOf(overtime, {{.time_s = 100}}), Abort::None);
  EXPECT_EQ(abortOf(overtime, {{.time_s = 100.1}}), Abort::Overtime);
  EXPECT_EQ(abortOf(off, {{.time_s = 1e9}}), Abort::None);
  const std::string undervolts = " b_arg: undervolts(volts) 11\n b_arg: samedepth_for(s) -1\n";
  EXPECT_EQ(abortOf(undervolts, {{.voltage = 11}}), Abort::None);
  EXPECT_EQ(abortOf(undervolts, {{.voltage = 10.9}}), Abort::Undervolts);
  const auto far = " b_arg: max_wpt_distance(m) 1000\n" + off;
  EXPECT_EQ(abortOf(far, {{.waypoint_distance_m = 1000}}), Abort::None);
  EXPECT_EQ(abortOf(far, {{.waypoint_distance_m = 1001}}), Abort::WaypointTooFar);
  EXPECT_EQ(abortOf(off, {{.waypoint_distance_m = 1001}}), Abort::None);
}

TEST(Abend, TheFirstReasonStands) {
  EXPECT_EQ(abortOf(" b_arg: overdepth(m) 50\n b_arg: overtime(s) 100\n",
                    {{.time_s = 200, .depth_m = 60, .voltage = 14}}),
            Abort::Overdepth);
  EXPECT_EQ(abortOf(" b_arg: overdepth(m) 50\n b_arg: overtime(s) 100\n",
                    {{.time_s = 101, .depth_m = 5, .voltage = 14},
                     {.time_s = 200, .depth_m = 60, .voltage = 14}}),
            Abort::Overtime);
}

TEST(Abend, NoticesADepthThatDoesNotChange) {
  const std::string same = " b_arg: samedepth_for(s) 300\n";
  EXPECT_EQ(abortOf(same, {{.time_s = 0, .depth_m = 20, .voltage = 14},
                           {.time_s = 300, .depth_m = 20.9, .voltage = 14}}),
            Abort::None);
  EXPECT_EQ(abortOf(same, {{.time_s = 0, .depth_m = 20, .voltage = 14},
                           {.time_s = 301, .depth_m = 19.1, .voltage = 14}}),
            Abort::SameDepth);
  EXPECT_EQ(abortOf(same, {{.time_s = 0, .depth_m = 20, .voltage = 14},
                           {.time_s = 200, .depth_m = 21, .voltage = 14},
                           {.time_s = 301, .depth_m = 20.5, .voltage = 14}}),
            Abort::None)
      << "a metre is a change";
  EXPECT_EQ(abortOf(same, {{.time_s = 0, .depth_m = 0, .voltage = 14, .at_surface = true},
                           {.time_s = 900, .depth_m = 0, .voltage = 14, .at_surface = true}}),
            Abort::None)
      << "at the surface it may stay";
}

TEST(StartWhen, EachCodeIsSaidInWords) {
  const std::string numbers =
      " b_arg: when_secs(s) 90\n b_arg: when_wpt_dist(m) 15\n"
      " b_arg: when_utc_timestamp(X) 0902030405\n b_arg: when_num_inflections(X) 3\n";
  const std::pair<int, const char*> kTexts[] = {
      {0, "0: at once"},
      {1, "1: no behaviour below commands heading or pump"},
      {2, "2: no behaviour below commands pitch"},
      {3, "3: no behaviour below commands heading"},
      {4, "4: no behaviour below commands pump"},
      {6, "6: 90 s after it ended"},
      {7, "7: the waypoint is nearer than 15 m"},
      {8, "8: a waypoint is reached"},
      {9, "9: every 90 s"},
      {10, "10: every 90 s, when no behaviour below commands the pump"},
      {11, "11: the science computer asks for it"},
      {12, "12: no contact for 90 s"},
      {13, "13: at 0902030405 UTC (yymmddhhmm) and every 90 s after it"},
      {14, "14: the vehicle hovers"},
      {15, "15: the waypoint is further away than 15 m"},
      {16, "16: more than 3 inflections"},
      {17, "17: the primary waypoint is nearer than 15 m"},
      {18, "18: the primary waypoint is further away than 15 m"}};
  for (const auto& [code, text] : kTexts) {
    BehaviourBench bench("behavior: surface\n b_arg: start_when(enum) " + std::to_string(code) +
                         "\n" + numbers);
    Commands below;
    below.hit_waypoint = below.hovering = true;
    if (code != 2) {
      below.point({});
    }
    const bool near = code == 7 || code == 17;
    bench.run({.time_s = 100,
               .waypoint_distance_m = near ? 10.0 : 20.0,
               .primary_distance_m = near ? 10.0 : 20.0,
               .silent_s = 91,
               .utc_s = 1233633850 + 100,
               .inflections = 4,
               .science_wants_surface = true},
              below);
    EXPECT_EQ(bench.state(), State::Active) << code;
    EXPECT_EQ(bench.behaviour->whyStarted(), std::string("start_when ") + text);
    EXPECT_EQ(bench.behaviour->label(), "surface") << "it has no place";
  }
}

}  // namespace
}  // namespace glider::simulator
