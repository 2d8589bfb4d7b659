// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The vehicle's own rules of its missions, cycle by cycle: codes, waypoint lists, mission
// parameters, the surface dialogue, drifting, slots that are busy without a command.

#include "simulator/geography/ddmm.h"
#include "simulator/slocum/flight/geography.h"
#include "tests/unit/simulator/behaviour_bench.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace glider::simulator {
namespace {

using State = Behaviour::State;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Commands filledCommands() {
  Commands commands;
  commands.steer({}), commands.point({}), commands.pump(0);
  return commands;
}

struct WhenCase {
  double secs = 0, distance_m = 0, utc_stamp = -1, inflections = -1;
  Code15 code_15 = Code15::FarFromWaypoint;
  bool stops = false;
};

WhenCondition whenWith(int code, const WhenCase& c = {}) {
  static const MissionVariables kNone{{}};
  return {code,
          {.secs = {c.secs, kNone},
           .distance_m = {c.distance_m, kNone},
           .utc_stamp = c.utc_stamp,
           .inflections = c.inflections},
          c.code_15,
          c.stops};
}

TEST(VehicleRules, EachCodeLooksAtOneThing) {
  const Situation quiet{.time_s = 100, .waypoint_distance_m = 500, .silent_s = 0};
  Situation situation = quiet;
  Commands below = filledCommands();
  EXPECT_FALSE(whenWith(8).met(quiet, below));
  below.hit_waypoint = true;
  EXPECT_TRUE(whenWith(8).met(quiet, below));

  EXPECT_FALSE(whenWith(10, {.secs = 60}).met(quiet, filledCommands())) << "the pump is commanded";
  Commands no_pump = filledCommands();
  no_pump.pump_cc.reset();
  EXPECT_TRUE(whenWith(10, {.secs = 60}).met(quiet, no_pump));
  EXPECT_FALSE(whenWith(10, {.secs = 200}).met(quiet, no_pump)) << "not yet";

  EXPECT_FALSE(whenWith(11).met(quiet, filledCommands()));
  situation.science_wants_surface = true;
  EXPECT_TRUE(whenWith(11).met(situation, filledCommands()));

  EXPECT_FALSE(whenWith(14).met(quiet, filledCommands()));
  below.hovering = true;
  EXPECT_TRUE(whenWith(14).met(quiet, below));

  situation = quiet;
  situation.inflections = 3;
  EXPECT_FALSE(whenWith(16, {.inflections = 3}).met(situation, filledCommands()))
      << "more than, not as many as";
  EXPECT_TRUE(whenWith(16, {.inflections = 2}).met(situation, filledCommands()));
}

TEST(VehicleRules, Code15IsTheDistanceOrTheModeByRelease) {
  Situation s{.waypoint_distance_m = 500};
  EXPECT_TRUE(whenWith(15, {.distance_m = 499}).met(s, filledCommands()));
  EXPECT_FALSE(whenWith(15, {.distance_m = 500}).met(s, filledCommands()));
  const WhenCase starts{.secs = 4, .code_15 = Code15::MissionMode};
  const WhenCase stops{.secs = 4, .code_15 = Code15::MissionMode, .stops = true};
  s.mission_mode = 3;
  EXPECT_FALSE(whenWith(15, starts).met(s, filledCommands()));
  EXPECT_TRUE(whenWith(15, stops).met(s, filledCommands()))
      << "a stop_when waits for the bit to go";
  s.mission_mode = 6;
  EXPECT_TRUE(whenWith(15, starts).met(s, filledCommands()));
  EXPECT_FALSE(whenWith(15, stops).met(s, filledCommands()));
}

TEST(VehicleRules, LocalAxesArePerpendicularAndMagnetic) {
  // magnetic = true + variation: with 0.25 rad, magnetic north is true 0.25 rad to the west.
  const Geography geography({39.5, -73.25}, 0.25);
  const Planar north = geography.fromLocal(0, 2);
  EXPECT_NEAR(north.east, -2 * std::sin(0.25), 1e-12);
  EXPECT_NEAR(north.north, 2 * std::cos(0.25), 1e-12);
  const Planar east = geography.fromLocal(3, 0);
  EXPECT_NEAR(east.east, 3 * std::cos(0.25), 1e-12);
  EXPECT_NEAR(east.north, 3 * std::sin(0.25), 1e-12);
  const Planar back = geography.toLocal(geography.fromLocal(5, -7));
  EXPECT_NEAR(back.east, 5, 1e-12);
  EXPECT_NEAR(back.north, -7, 1e-12);
}

TEST(VehicleRules, Codes17And18AreTheDistanceToThePrimaryWaypoint) {
  Situation s{.waypoint_distance_m = 1, .primary_distance_m = 500};
  EXPECT_TRUE(whenWith(17, {.distance_m = 501}).met(s, filledCommands()));
  EXPECT_FALSE(whenWith(17, {.distance_m = 500}).met(s, filledCommands()));
  EXPECT_TRUE(whenWith(18, {.distance_m = 499}).met(s, filledCommands()));
  EXPECT_FALSE(whenWith(18, {.distance_m = 500}).met(s, filledCommands()));
  const Situation none{.waypoint_distance_m = 1};
  EXPECT_FALSE(whenWith(17, {.distance_m = 501}).met(none, filledCommands())) << "it is not known";
  EXPECT_FALSE(whenWith(18, {.distance_m = 0}).met(none, filledCommands()));
}

TEST(VehicleRules, AUtcTimeComesOnce) {
  // 2009-08-11 14:13:20 is 1.25e9 s since 1970.
  WhenCondition at = whenWith(13, {.utc_stamp = 908111414});
  Situation s{.time_s = 0, .utc_s = 1.25e9};
  EXPECT_FALSE(at.met(s, filledCommands()));
  s.time_s = 40, s.utc_s += 40;
  EXPECT_TRUE(at.met(s, filledCommands())) << "14:14:00";
  at.noteStart(40);
  s.time_s = 44, s.utc_s += 4;
  EXPECT_FALSE(at.met(s, filledCommands()));
  EXPECT_FALSE(whenWith(13, {.utc_stamp = 908111413}).met(s, filledCommands()))
      << "past when the mission began";
  EXPECT_FALSE(whenWith(13, {.utc_stamp = 908321413}).met(s, filledCommands())) << "32 August";
  EXPECT_FALSE(whenWith(13).met(s, filledCommands()));
}

TEST(VehicleRules, ABArgOfAMillionIsAMissionParameterReadWhenItIsUsed) {
  BehaviourBench heading(
      "behavior: set_heading\n b_arg: use_heading(bool) 1\n b_arg: heading_value(X) 1000009\n");
  heading.run({});
  EXPECT_EQ(heading.commands.heading->value_rad, 0) << "never set";
  heading.variables->set("u_mission_param_j", 1.25);
  heading.run({});
  EXPECT_EQ(heading.commands.heading->value_rad, 1.25);
  BehaviourBench last(
      "behavior: set_heading\n b_arg: use_heading(bool) 1\n b_arg: heading_value(X) 1000025\n");
  last.variables->set("u_mission_param_z", 0.5);
  last.run({});
  EXPECT_EQ(last.commands.heading->value_rad, 0.5);
  BehaviourBench set(
      "sensor: u_mission_param_a(X) 2\nbehavior: set_heading\n"
      " b_arg: use_heading(bool) 1\n b_arg: heading_value(X) 1000000\n");
  set.run({});
  EXPECT_EQ(set.commands.heading->value_rad, 2) << "by the mission file";
}

const Geography& geography() {
  static const Geography kGeography({39.5, -73.25}, 0.25);
  return kGeography;
}

const std::string kList =
    "behavior: goto_list\n b_arg: start_when(enum) 0\n b_arg: num_waypoints(nodim) 3\n"
    " b_arg: list_when_wpt_dist(m) 100\n";

std::string listOf(const std::string& more) {
  std::string text = kList + more;
  for (int i = 0; i < 3; ++i) {
    const std::string n = std::to_string(i);
    text += " b_arg: wpt_units_" + n + "(enum) 2\n b_arg: wpt_x_" + n + "(X) -73" + n +
            "0\n b_arg: wpt_y_" + n + "(X) 3930\n";
  }
  return text;
}

/// The longitude's tens of minutes of each waypoint steered to, when each is reached in one cycle;
/// "-" for cycles without a command.
std::string visited(BehaviourBench& list, int cycles, double at_longitude_ddmm = -7300) {
  std::string out;
  for (int i = 0; i < cycles; ++i) {
    list.run({.time_s = 4.0 * i,
              .latitude_ddmm = 3930,
              .longitude_ddmm = at_longitude_ddmm,
              .waypoint_distance_m = i % 2 == 1 ? 50.0 : 5000.0,
              .geography = &geography()});
    if (i % 2 == 0) {
      const auto& heading = list.commands.heading;
      out += heading ? std::to_string(static_cast<int>(-heading->longitude_ddmm - 7300) / 10) : "-";
    }
  }
  return out;
}

TEST(VehicleRules, AListIsFollowedAsOftenAsItsLegsSay) {
  BehaviourBench forever(listOf(" b_arg: initial_wpt(enum) 0\n"));
  EXPECT_EQ(visited(forever, 14), "0120120");
  BehaviourBench once(listOf(" b_arg: initial_wpt(enum) 1\n b_arg: num_legs_to_run(nodim) -2\n"));
  EXPECT_EQ(visited(once, 10), "12---");
  EXPECT_EQ(once.state(), State::Complete);
  BehaviourBench two(listOf(" b_arg: initial_wpt(enum) 2\n b_arg: num_legs_to_run(nodim) 2\n"));
  EXPECT_EQ(visited(two, 10), "20---");
}

TEST(VehicleRules, AListBeginsWhereInitialWptSays) {
  BehaviourBench nearest(listOf(" b_arg: initial_wpt(enum) -2\n"));
  EXPECT_EQ(visited(nearest, 2, -7318), "2");
  BehaviourBench middle(listOf(" b_arg: initial_wpt(enum) -2\n"));
  EXPECT_EQ(visited(middle, 2, -7311), "1");
  // One after the last that was reached: the first at the beginning, the third in its second run.
  BehaviourBench after(
      listOf(" b_arg: initial_wpt(enum) -1\n b_arg: num_legs_to_run(nodim) 2\n"
             " b_arg: end_action(enum) 2\n"));
  EXPECT_EQ(visited(after, 8), "0120");
}

TEST(VehicleRules, ReachingAWaypointIsSeenAboveInTheSameCycle) {
  BehaviourBench list(listOf(" b_arg: initial_wpt(enum) 0\n"));
  Situation s{.waypoint_distance_m = 50, .geography = &geography()};
  list.run(s);
  EXPECT_FALSE(list.commands.hit_waypoint) << "the distance is that of an earlier waypoint";
  list.run(s);
  EXPECT_TRUE(list.commands.hit_waypoint);
  s.waypoint_distance_m = 100;
  list.run(s);
  list.run(s);
  EXPECT_FALSE(list.commands.hit_waypoint) << "not nearer than list_when_wpt_dist";
}

TEST(VehicleRules, WaypointsHaveThreeUnits) {
  const auto north = geography().position(WaypointUnits::LocalMetres, 0, 1000);
  // y is magnetic north, which lies where the compass reads 0: 0.25 rad west of true north here.
  EXPECT_NEAR(fromDdmm(north.latitude_ddmm) - 39.5, 1000 * std::cos(0.25) / 111030, 2e-5);
  EXPECT_LT(fromDdmm(north.longitude_ddmm), -73.25 - 0.002);
  const auto start = geography().position(WaypointUnits::LocalMetres, 0, 0);
  EXPECT_NEAR(fromDdmm(start.latitude_ddmm), 39.5, 1e-9);
  // UTM zone 18 north, from the published series (Snyder 1987): 39.5 N 73.25 W.
  const auto utm = geography().position(WaypointUnits::Utm, 650478, 4373792);
  EXPECT_NEAR(fromDdmm(utm.latitude_ddmm), 39.5, 2e-3);
  EXPECT_NEAR(fromDdmm(utm.longitude_ddmm), -73.25, 2e-3);
  const auto plain = geography().position(WaypointUnits::LatLon, -7315, 3930);
  EXPECT_EQ(plain.latitude_ddmm, 3930);
  EXPECT_EQ(plain.longitude_ddmm, -7315);
}

std::string surfaceWith(int end_action) {
  return "behavior: surface\n b_arg: start_when(enum) 0\n b_arg: gps_wait_time(s) 100\n"
         " b_arg: keystroke_wait_time(s) 60\n b_arg: end_wpt_dist(m) 300\n"
         " b_arg: end_action(enum) " +
         std::to_string(end_action) + "\n";
}

/// The time at the surface after which a surfacing with this end action lets others fly, s; the
/// vehicle has a fix after 20 s and drifts away from its waypoint at 1 m/s.
double dialogue(BehaviourBench& surface, double from_s = 0) {
  for (double t = 0; t < 2000; t += 4) {
    surface.run({.time_s = from_s + t,
                 .depth_m = 0,
                 .waypoint_distance_m = t,
                 .at_surface = true,
                 .gps_fix = t >= 20});
    if (surface.state() != State::Active) {
      return t;
    }
  }
  return -1;
}

TEST(VehicleRules, TheSurfaceDialogueEndsAsEndActionSays) {
  struct Row {
    int action;
    double first_s, second_s;
    bool ends;
  };
  for (const Row& row : {Row{0, 20, -1, true}, Row{1, 80, 80, false}, Row{2, 20, 20, false},
                         Row{3, 304, 304, false}, Row{4, 80, 20, false}, Row{5, 80, -1, true}}) {
    BehaviourBench surface(surfaceWith(row.action));
    EXPECT_EQ(dialogue(surface), row.first_s) << row.action;
    EXPECT_EQ(surface.behaviour->endsMission(), row.ends) << row.action;
    EXPECT_EQ(surface.state(), row.ends ? State::Complete : State::Waiting) << row.action;
    if (!row.ends) {
      EXPECT_EQ(dialogue(surface, 5000), row.second_s) << row.action;
    }
  }
}

TEST(VehicleRules, NopCommandsKeepSlotsBusyAndMoveNothing) {
  BehaviourBench nop(
      "behavior: nop_cmds\n b_arg: nop_pitch(bool) 1\n b_arg: nop_heading(bool) 1\n"
      " b_arg: nop_bpump(bool) 1\n b_arg: secs_to_run(s) 40\n");
  nop.run({.time_s = 0});
  EXPECT_EQ(nop.commands.idleAbort(), Abort::None);
  EXPECT_EQ(nop.commands.pitch->mode, PitchCommand::Mode::Ignore);
  EXPECT_EQ(nop.commands.heading->mode, HeadingCommand::Mode::Ignore);
  EXPECT_TRUE(std::isnan(*nop.commands.pump_cc));
  nop.run({.time_s = 4}, filledCommands());
  EXPECT_EQ(*nop.commands.pump_cc, 0) << "what is commanded below stays";
  nop.run({.time_s = 40});
  EXPECT_EQ(nop.commands.idleAbort(), Abort::StackIdle);
  BehaviourBench pitch("behavior: nop_cmds\n b_arg: nop_pitch(bool) 1\n");
  pitch.run({.time_s = 1e6});
  EXPECT_EQ(pitch.commands.idleAbort(), Abort::HeadingIdle)
      << "only the slots that are set, for ever";
}

TEST(VehicleRules, DiveToAndClimbToAreOneLegEach) {
  BehaviourBench dive(
      "behavior: dive_to\n b_arg: target_depth(m) 20\n b_arg: bpump_value(X) -150\n"
      " b_arg: pitch_value(X) -0.4\n");
  dive.run({.depth_m = 5, .depth_rate_mps = 0.2, .altitude_m = kNaN});
  EXPECT_EQ(*dive.commands.pump_cc, -150);
  EXPECT_EQ(dive.commands.pitch->value, -0.4);
  dive.run({.time_s = 60, .depth_m = 20, .depth_rate_mps = 0.2, .altitude_m = kNaN});
  EXPECT_FALSE(dive.commands.pump_cc);
  EXPECT_EQ(dive.state(), State::Complete);
  BehaviourBench climb(
      "behavior: climb_to\n b_arg: target_depth(m) 4\n b_arg: end_action(enum) 2\n");
  climb.run({.depth_m = 25, .depth_rate_mps = -0.2, .altitude_m = kNaN});
  EXPECT_EQ(*climb.commands.pump_cc, 260);
  climb.run({.depth_m = 4, .depth_rate_mps = -0.2, .altitude_m = kNaN});
  EXPECT_EQ(climb.state(), State::Waiting);
}

TEST(VehicleRules, ADiveToByItselfHasDefaultsOfItsOwn) {
  BehaviourBench dive("behavior: dive_to\n");
  dive.run({.depth_m = 5, .depth_rate_mps = 0.2, .altitude_m = 2});
  EXPECT_EQ(dive.state(), State::Active) << "no target altitude";
  EXPECT_EQ(dive.commands.pitch->mode, PitchCommand::Mode::BatteryPosition);
  EXPECT_EQ(dive.commands.pitch->value, 0);
  EXPECT_FALSE(dive.commands.altimeter);
  dive.run({.time_s = 60, .depth_m = 10, .depth_rate_mps = 0.2, .altitude_m = kNaN});
  EXPECT_EQ(dive.state(), State::Complete) << "10 m";
  BehaviourBench clipped("sensor: f_max_working_depth(m) 7\nbehavior: dive_to\n");
  clipped.run({.depth_m = 6.9, .depth_rate_mps = 0.2, .altitude_m = kNaN});
  EXPECT_EQ(clipped.state(), State::Active);
  clipped.run({.time_s = 4, .depth_m = 7, .depth_rate_mps = 0.2, .altitude_m = kNaN});
  EXPECT_EQ(clipped.state(), State::Complete);
}

TEST(VehicleRules, AStopWhenItIsCompleteIsNoStopOfItsOwn) {
  EXPECT_TRUE(whenWith(0).met({}, filledCommands()));
  EXPECT_FALSE(whenWith(0, {.stops = true}).met({}, filledCommands()));
}

TEST(VehicleRules, AUtcTimeMayComeAgain) {
  WhenCondition again = whenWith(13, {.secs = 600, .utc_stamp = 908111414});
  Situation s{.time_s = 40, .utc_s = 1.25e9 + 40};
  EXPECT_TRUE(again.met(s, filledCommands()));
  again.noteStart(40);
  s.time_s = 639, s.utc_s = 1.25e9 + 639;
  EXPECT_FALSE(again.met(s, filledCommands()));
  s.time_s = 640, s.utc_s = 1.25e9 + 640;
  EXPECT_TRUE(again.met(s, filledCommands()));
  WhenCondition late = whenWith(13, {.secs = -1, .utc_stamp = 908110000});
  EXPECT_TRUE(late.met(s, filledCommands())) << "at any time after it";
  late.noteStart(640);
  EXPECT_FALSE(late.met(s, filledCommands())) << "once";
}

TEST(VehicleRules, AutoballastIsTheWholePump) {
  BehaviourBench dive("behavior: dive_to\n b_arg: use_bpump(enum) 0\n b_arg: bpump_value(X) 150\n");
  dive.run({.depth_m = 5, .depth_rate_mps = 0.2, .altitude_m = kNaN});
  EXPECT_EQ(*dive.commands.pump_cc, -1000) << "bpump_value is the stroke of a yo, without a sign";
}

TEST(VehicleRules, DriftAtDepthStaysAboveTheBottom) {
  BehaviourBench drift(
      "behavior: drift_at_depth\n b_arg: target_depth(m) 50\n b_arg: target_altitude(m) 20\n"
      " b_arg: target_deadband(m) 2\n b_arg: stop_when_hover_for(s) -1\n");
  drift.run({.time_s = 0, .depth_m = 5, .depth_rate_mps = 0.2, .altitude_m = kNaN});
  EXPECT_EQ(*drift.commands.pump_cc, -260);
  EXPECT_TRUE(drift.commands.altimeter);
  drift.run({.time_s = 60, .depth_m = 20, .depth_rate_mps = 0.2, .altitude_m = 30});
  EXPECT_FALSE(drift.commands.hovering) << "30 m is 20 m above the bottom";
  drift.run({.time_s = 100, .depth_m = 28, .depth_rate_mps = 0.2, .altitude_m = kNaN});
  EXPECT_TRUE(drift.commands.hovering);
  drift.run({.time_s = 1e6, .depth_m = 28, .depth_rate_mps = 0, .altitude_m = kNaN});
  EXPECT_EQ(drift.state(), State::Active) << "-1: without an end";
}

TEST(VehicleRules, DriftAtDepthHoversWithSmallSteps) {
  BehaviourBench drift(
      "behavior: drift_at_depth\n b_arg: target_depth(m) 50\n b_arg: target_altitude(m) -1\n"
      " b_arg: target_deadband(m) 2\n b_arg: stop_when_hover_for(s) 400\n"
      " b_arg: bpump_delta_value(cc) 10\n b_arg: bpump_delay(s) 20\n");
  drift.run({.time_s = 0, .depth_m = 5, .depth_rate_mps = 0.2});
  EXPECT_EQ(*drift.commands.pump_cc, -260) << "dives to it";
  EXPECT_FALSE(drift.commands.hovering);
  drift.run({.time_s = 100, .depth_m = 48, .depth_rate_mps = 0.2});
  EXPECT_TRUE(drift.commands.hovering);
  EXPECT_EQ(*drift.commands.pump_cc, 0);
  drift.run({.time_s = 119, .depth_m = 49, .depth_rate_mps = 0.1});
  EXPECT_EQ(*drift.commands.pump_cc, 0) << "bpump_delay";
  drift.run({.time_s = 120, .depth_m = 49, .depth_rate_mps = 0.1});
  EXPECT_EQ(*drift.commands.pump_cc, 10) << "against sinking";
  drift.run({.time_s = 140, .depth_m = 52.5, .depth_rate_mps = -0.1});
  EXPECT_EQ(*drift.commands.pump_cc, 0) << "it rises: less";
  drift.run({.time_s = 160, .depth_m = 52.5, .depth_rate_mps = 0});
  EXPECT_EQ(*drift.commands.pump_cc, 10) << "too deep";
  drift.run({.time_s = 180, .depth_m = 50, .depth_rate_mps = 0});
  EXPECT_EQ(*drift.commands.pump_cc, 10) << "at its depth";
  drift.run({.time_s = 500, .depth_m = 50, .depth_rate_mps = 0});
  EXPECT_EQ(drift.state(), State::Complete) << "400 s of hovering";
  EXPECT_FALSE(drift.commands.pump_cc);
}

}  // namespace
}  // namespace glider::simulator
