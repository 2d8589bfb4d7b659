// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Missions of the kinds that every operator has (tests of the vehicle's aborts, checks at the dock,
// holding a place, yos with several reasons to surface, deep and shallow ones): each flies as its
// file says, to its end.

#include "tests/unit/simulator/flights.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace glider::simulator {
namespace {

/// The water of a flight.
struct Water {
  double depth_m = 60;
  double east_mps = 0;
  double duration_s = 7200;
};

class StockFlight {
 public:
  explicit StockFlight(const std::string& mission, const Water& water = {}) {
    SimulationSetup setup = setupWith(mission);
    setup.scenario.ocean.bottom.depth_m = water.depth_m;
    setup.scenario.ocean.current.east = setup.scenario.ocean.bottom_current.east = water.east_mps;
    setup.scenario.ocean.wave.amplitude_m = 0;
    // A pump of 100 m at 1000 m would pull the voltage below what abend allows.
    setup.scenario.vehicle.battery.power.resistance_ohm = 0;
    setup.duration_s = water.duration_s;
    trace = fly(std::move(setup));
  }

  [[nodiscard]] double column(size_t row, const char* name) const {
    return trace.at(row, trace.column(name));
  }
  [[nodiscard]] double deepest() const {
    double most = 0;
    for (size_t row = 0; row < trace.rowCount(); ++row) {
      most = std::max(most, column(row, "true_depth"));
    }
    return most;
  }
  [[nodiscard]] double lastDepth() const { return column(trace.rowCount() - 1, "true_depth"); }
  [[nodiscard]] double end() const { return trace.at(trace.rowCount() - 1, 0); }
  [[nodiscard]] int count(support::EventId id) const {
    return static_cast<int>(std::ranges::count(trace.events, id, &support::TraceEvent::id));
  }
  [[nodiscard]] bool has(support::EventId id) const { return count(id) > 0; }
  /// When the first such event was; NaN: never.
  [[nodiscard]] double when(support::EventId id) const {
    const support::TraceEvent* event = findEvent(trace, id);
    return event == nullptr ? NAN : event->time_s;
  }
  /// How often events contain `what`.
  [[nodiscard]] int count(const std::string& what) const {
    return static_cast<int>(std::ranges::count_if(trace.events, [&](const auto& event) {
      return textOf(event).find(what) != std::string::npos;
    }));
  }
  [[nodiscard]] bool has(const std::string& what) const { return count(what) > 0; }
  /// When the first event that contains `what` was; NaN: never.
  [[nodiscard]] double when(const std::string& what) const {
    const support::TraceEvent* event = findEvent(trace, what);
    return event == nullptr ? NAN : event->time_s;
  }
  /// The starts of a behaviour at a place of the mission, by the code that began them.
  [[nodiscard]] int starts(const std::string& label, int code) const {
    return static_cast<int>(std::ranges::count_if(trace.events, [&](const auto& event) {
      return event.id == support::EventId::BehaviourStarts &&
             std::get<std::string>(event.values[0]) == label &&
             event.why.starts_with(fmt::format("start_when {}: ", code));
    }));
  }
  [[nodiscard]] std::string events() const { return eventText(trace); }

  support::Trace trace;
};

std::string behaviour(const std::string& name, const std::string& arguments = "") {
  std::string text = "behavior: " + name + "\n";
  for (size_t at = 0; at < arguments.size();) {
    const size_t comma = std::min(arguments.find(", ", at), arguments.size());
    const std::string one = arguments.substr(at, comma - at);
    const size_t blank = one.find(' ');
    text += "    b_arg: " + one.substr(0, blank) + "(X) " + one.substr(blank + 1) + "\n";
    at = comma + 2;
  }
  return text;
}

const std::string kPrepare = behaviour("prepare_to_dive", "start_when 0, wait_time 60");
const std::string kSensors = behaviour("sensors_in");
const std::string kNopHeading = behaviour("nop_cmds", "nop_heading 1");
const std::string kFin = behaviour("set_heading", "use_heading 4, heading_value 0");
const std::string kNorth = behaviour("set_heading", "use_heading 1, heading_value 0");
/// A dive to wherever the vehicle may work.
const std::string kWorks25 = "sensor: f_max_working_depth(m) 25\n";
const std::string kSinks = behaviour("dive_to", "target_depth 10000");

std::string limits(const std::string& changed) {
  std::string all = "overdepth -1, undervolts -1, samedepth_for -1, ";
  all += changed;
  return behaviour("abend", all);
}

TEST(StockMissions, StatusAtTheDockEndsAtTheSurface) {
  const StockFlight f(
      behaviour("abend", "overdepth 10, overtime 360") +
      behaviour("surface", "start_when 0, end_action 0, report_all 1, gps_wait_time 180") +
      behaviour("sample", "state_to_sample 15, intersample_time 0") + kSensors +
      behaviour("nop_cmds", "nop_pitch 1, nop_bpump 1, nop_heading 1, nop_threng 1"));
  EXPECT_TRUE(f.has(EventId::MissionEndsNormally)) << f.events();
  EXPECT_LT(f.end(), 200);
  EXPECT_LT(f.deepest(), 1);
}

TEST(StockMissions, OvertimeAborts) {
  const StockFlight f(kWorks25 + limits("overtime 180") + kSinks + kPrepare + kSensors +
                      kNopHeading);
  EXPECT_NEAR(f.when("MS_ABORT_OVERTIME"), 184, 4) << f.events();
  EXPECT_GT(f.deepest(), 2);
  EXPECT_LT(f.lastDepth(), 1) << "and comes up";
}

TEST(StockMissions, OverdepthAborts) {
  const StockFlight shallow(kWorks25 +
                            behaviour("abend", "overdepth 2, overtime 600, undervolts -1") +
                            kSinks + kPrepare + kSensors + kNopHeading);
  EXPECT_TRUE(shallow.has("MS_ABORT_OVERDEPTH")) << shallow.events();
  EXPECT_LT(shallow.deepest(), 10);
  EXPECT_LT(shallow.lastDepth(), 1);
}

TEST(StockMissions, OverdepthIsClippedToTheWorkingDepth) {
  const StockFlight f(kWorks25 + behaviour("abend", "overdepth 1000, overtime 3000") +
                      behaviour("surface", "start_when 2, end_action 0") + kNorth +
                      behaviour("yo", "d_target_depth 24.9, c_target_depth 3") + kSensors);
  EXPECT_TRUE(f.has("MS_ABORT_OVERDEPTH")) << "it overshoots 25 m: " << f.events();
  EXPECT_LT(f.deepest(), 30);
}

TEST(StockMissions, LowBatteryAborts) {
  const StockFlight f(kWorks25 + limits("overtime 600") + kSinks + kSensors + kNopHeading);
  const StockFlight low(kWorks25 + behaviour("abend", "overtime 600, undervolts 30") + kSinks +
                        kSensors + kNopHeading);
  EXPECT_FALSE(f.has("MS_ABORT_UNDERVOLTS"));
  EXPECT_TRUE(low.has("MS_ABORT_UNDERVOLTS")) << low.events();
  EXPECT_LT(low.lastDepth(), 1);
}

TEST(StockMissions, AConstantDepthAborts) {
  const StockFlight f(behaviour("abend", "overtime 900, undervolts -1, samedepth_for 30") +
                          behaviour("dive_to", "target_depth 10000, stop_when_hover_for -1") +
                          kPrepare + kSensors + kNopHeading,
                      {.depth_m = 20});
  EXPECT_TRUE(f.has("MS_ABORT_SAMEDEPTH")) << "on the bottom: " << f.events();
  EXPECT_LT(f.lastDepth(), 1);
}

TEST(StockMissions, AnIdlePitchAborts) {
  const StockFlight f(behaviour("abend", "overdepth 10, overtime 360") +
                      behaviour("dive_to", "start_when 4, target_depth 2, target_altitude -1") +
                      kPrepare + kSensors + kNopHeading);
  EXPECT_TRUE(f.has("MS_ABORT_PITCH_IS_IDLE")) << f.events();
  EXPECT_LT(f.lastDepth(), 1);
}

TEST(StockMissions, WithoutContactTheWatchdogAborts) {
  const StockFlight f(kWorks25 + limits("overtime 900, no_cop_tickle_for 180") +
                      behaviour("dive_to",
                                "target_depth 10000, stop_when_hover_for -1, "
                                "stop_when_stalled_for -1") +
                      kPrepare + kSensors + kNopHeading);
  const double at = f.when("MS_ABORT_NO_TICKLE");
  EXPECT_GT(at, 180) << f.events();
  EXPECT_LT(at, 260) << "180 s after the last fix";
  EXPECT_LT(f.lastDepth(), 1);
}

TEST(StockMissions, OutOfBandAborts) {
  const StockFlight f(kWorks25 + limits("overtime 600") +
                      behaviour("oob_abort", "start_when 6, when_secs 120") + kSinks +
                      behaviour("prepare_to_dive", "start_when 0, wait_time 0") + kSensors +
                      behaviour("nop_cmds", "nop_pitch 1, nop_bpump 1, nop_heading 1"));
  EXPECT_NEAR(f.when("out of band"), 120, 4) << f.events();
  EXPECT_LT(f.lastDepth(), 1);
}

TEST(StockMissions, AMissionEnderEndsTheMission) {
  const StockFlight f(behaviour("mission_ender", "start_when 2") + kNorth +
                      behaviour("yo", "num_half_cycles_to_do 2, d_target_depth 8, end_action 0") +
                      kSensors);
  EXPECT_TRUE(f.has(EventId::MissionEndsNormally)) << f.events();
  EXPECT_FALSE(f.has(EventId::Aborts));
}

TEST(StockMissions, ATestDiveInAPondIsOneYo) {
  const StockFlight f(
      "sensor: u_use_current_correction(nodim) 0\n" +
          behaviour("abend", "overdepth -1, overtime 1200, samedepth_for 1000") +
          behaviour("surface", "start_when 1, end_action 0, gps_wait_time 300") + kFin +
          behaviour(
              "yo",
              "start_when 4, num_half_cycles_to_do 2, d_target_depth 3, d_target_altitude -1, "
              "d_use_pitch 1, d_pitch_value 0.1, d_max_thermal_charge_time 30, "
              "d_stop_when_stalled_for 600, c_target_depth 1.5, c_target_altitude -1, "
              "c_use_pitch 1, c_pitch_value -0.1, c_stop_when_stalled_for 600, end_action 0") +
          behaviour("sample", "state_to_sample 5, intersample_time 4") +
          behaviour("prepare_to_dive", "start_when 0, wait_time 300, max_thermal_charge_time 10") +
          behaviour("sensors_in", "c_att_time 0, c_pressure_time 0, c_alt_time 0"),
      {.depth_m = 20});
  EXPECT_EQ(f.count(EventId::LegOver), 2) << f.events();
  EXPECT_TRUE(f.has(EventId::MissionEndsNormally)) << f.events();
  EXPECT_GT(f.deepest(), 2.5);
  EXPECT_LT(f.deepest(), 9);
}

TEST(StockMissions, HoldingAPlaceDriftsAwayAndFliesBack) {
  const std::string hold =
      behaviour("abend", "overtime 9000") +
      behaviour("surface", "start_when 8, end_action 3, gps_wait_time 600, end_wpt_dist 100") +
      behaviour("surface", "start_when 12, when_secs 2700, end_action 1") +
      behaviour("goto_wpt",
                "start_when 1, stop_when 7, when_wpt_dist 25, wpt_units 0, wpt_x 0, wpt_y 0, "
                "end_action 2") +
      behaviour("yo",
                "start_when 4, d_target_depth 20, d_target_altitude 3, d_bpump_value -1000, "
                "d_pitch_value -0.43, c_target_depth 3, c_bpump_value 1000, "
                "c_pitch_value 0.43, end_action 2") +
      behaviour("prepare_to_dive", "start_when 0, wait_time 720") + kSensors;
  const StockFlight f(hold, {.east_mps = 0.1, .duration_s = 8000});
  EXPECT_GE(f.starts("surface_2", 8), 2) << "at the start, and when it is back: " << f.events();
  EXPECT_GT(f.deepest(), 15) << "it dives to come back";
  double farthest = 0;
  for (size_t row = 0; row < f.trace.rowCount(); ++row) {
    farthest = std::max(farthest, f.column(row, "true_x"));
  }
  EXPECT_GT(farthest, 100);
  EXPECT_LT(farthest, 400);
  EXPECT_FALSE(f.has(EventId::Aborts)) << f.events();
}

/// The surfaces of the usual long mission, in its order: no contact, heading idle, pitch idle, a
/// waypoint, science, every three hours.
std::string surfaces(const std::string& pump = "") {
  const std::string common = "gps_wait_time 300, keystroke_wait_time 300, when_wpt_dist 10, " +
                             pump + "c_use_pitch 3, c_pitch_value 0.4538";
  return behaviour("surface", "start_when 12, when_secs 1200, end_action 1, " + common) +
         behaviour("surface", "start_when 3, end_action 0, " + common) +
         behaviour("surface", "start_when 2, end_action 1, " + common) +
         behaviour("surface", "start_when 8, end_action 1, " + common) +
         behaviour("surface", "start_when 11, end_action 1, " + common) +
         behaviour("surface", "start_when 9, when_secs 10800, end_action 1, " + common);
}

std::string list(const std::string& more) {
  return behaviour("goto_list",
                   "start_when 0, list_stop_when 7, num_waypoints 2, wpt_x_0 0, "
                   "wpt_y_0 5000, wpt_x_1 0, wpt_y_1 -5000, " +
                       more);
}

TEST(StockMissions, TheUsualMissionSurfacesWithoutContactEveryTwentyMinutes) {
  const StockFlight f(behaviour("abend", "overtime -1, no_cop_tickle_for 48600") + surfaces() +
                          list("num_legs_to_run -1, initial_wpt 0") +
                          behaviour("yo",
                                    "start_when 2, num_half_cycles_to_do -1, "
                                    "d_target_depth 12, d_target_altitude 3, c_target_depth 3, "
                                    "end_action 2") +
                          behaviour("sample", "sensor_type 0, state_to_sample 7") +
                          behaviour("prepare_to_dive", "start_when 0, wait_time 720") + kSensors,
                      {.duration_s = 9000});
  EXPECT_FALSE(f.has(EventId::Aborts)) << f.events();
  // Each time after 20 min of yos: the climb, the fix, and 300 s for the operator, who is not
  // there.
  EXPECT_GE(f.starts("surface_2", 12), 4) << f.events();
  EXPECT_LE(f.starts("surface_2", 12), 6) << f.events();
  EXPECT_NEAR(f.when("surface_2 started"), 1204, 4);
  EXPECT_EQ(f.starts("surface_4", 2), 0) << "the yo has no end";
}

TEST(StockMissions, AutoballastDivesAndClimbsWithTheWholePump) {
  const StockFlight f(
      behaviour("abend", "overtime -1") + surfaces("c_use_bpump 0, ") +
          list("num_legs_to_run -1, initial_wpt 0") +
          behaviour("yo",
                    "start_when 2, num_half_cycles_to_do 6, d_target_depth 8, d_target_altitude 5, "
                    "d_use_bpump 0, d_bpump_value 360, d_pitch_value -0.37, "
                    "d_stop_when_hover_for 600, d_stop_when_stalled_for 660, d_speed_min 0.06, "
                    "c_target_depth 3.5, c_use_bpump 0, c_pitch_value 0.37, "
                    "c_stop_when_hover_for 600, c_stop_when_stalled_for 660, c_speed_min -0.06, "
                    "end_action 2") +
          behaviour("prepare_to_dive", "start_when 0, wait_time 720") + kSensors,
      {.duration_s = 4000});
  EXPECT_FALSE(f.has(EventId::Aborts)) << f.events();
  EXPECT_GE(f.count(" over, half cycle 6"), 1) << f.events();
  EXPECT_GE(f.starts("surface_4", 2), 1) << "after six half cycles: " << f.events();
  EXPECT_GT(f.deepest(), 8);
}

TEST(StockMissions, RecoverySurfacesAfterFourHalfCycles) {
  const StockFlight f(
      behaviour("abend", "overtime 60000, samedepth_for 2200, stalled_for -1, invalid_gps -1") +
          behaviour("surface", "start_when 8, end_action 1") +
          behaviour("surface", "start_when 12, when_secs 7200, end_action 1") +
          behaviour("surface", "start_when 2, end_action 1") +
          list("num_legs_to_run -1, initial_wpt -1") +
          behaviour("yo",
                    "start_when 2, num_half_cycles_to_do 4, d_target_depth 90, "
                    "d_target_altitude 20, d_stop_when_hover_for 600, "
                    "d_stop_when_stalled_for 800, c_target_depth 3, "
                    "c_stop_when_hover_for 600, c_stop_when_stalled_for 800, end_action 2") +
          behaviour("prepare_to_dive", "start_when 0, wait_time 300") + kSensors,
      {.depth_m = 80, .duration_s = 6000});
  EXPECT_FALSE(f.has(EventId::Aborts)) << f.events();
  EXPECT_GE(f.starts("surface_4", 2), 1) << f.events();
  EXPECT_LT(f.deepest(), 70) << "20 m above the bottom, and what it overshoots";
  EXPECT_GT(f.deepest(), 55);
}

TEST(StockMissions, WithoutContactAMissionEnds) {
  const StockFlight f(behaviour("abend", "overtime 3600") +
                      behaviour("surface", "start_when 12, when_secs 1200, end_action 0") +
                      behaviour("surface", "start_when 2, end_action 0") + kFin +
                      behaviour("yo",
                                "start_when 2, num_half_cycles_to_do -1, d_target_depth 40, "
                                "d_target_altitude 10, d_use_pitch 1, d_pitch_value 1, "
                                "c_target_depth 3, c_use_pitch 1, c_pitch_value -1, "
                                "end_action 2") +
                      behaviour("prepare_to_dive", "start_when 0, wait_time 120") + kSensors);
  EXPECT_NEAR(f.when("surface_2 started"), 1204, 4) << f.events();
  EXPECT_TRUE(f.has(EventId::MissionEndsNormally)) << f.events();
  EXPECT_LT(f.end(), 1900);
}

TEST(StockMissions, ACompassIsCalibratedInCirclesBothWays) {
  const StockFlight f(
      behaviour("abend", "stalled_for -1, overtime 4200") +
      behaviour("surface", "start_when 1, end_action 1") +
      behaviour("surface", "start_when 12, end_action 1, when_secs 1800") +
      behaviour("surface", "start_when 11, end_action 0") +
      behaviour("surface", "start_when 6, end_action 0, when_secs 3600") +
      behaviour("set_heading",
                "use_heading 4, heading_value -100, start_when 6, stop_when 6, "
                "when_secs 300, end_action 2") +
      behaviour("set_heading", "use_heading 4, heading_value 100, start_when 0, stop_when 5") +
      behaviour("compass_cal", "start_when 0, when_secs 0, num_samples 300") +
      behaviour("yo",
                "start_when 4, d_target_depth 30, d_target_altitude 3, "
                "d_bpump_value -1000, d_use_pitch 1, d_pitch_value 3, c_target_depth 5, "
                "c_bpump_value 1000, c_use_pitch 1, c_pitch_value -3, end_action 2") +
      behaviour("prepare_to_dive", "start_when 0, wait_time 720") + kSensors);
  EXPECT_FALSE(f.has(EventId::Aborts)) << f.events();
  EXPECT_TRUE(f.has(EventId::MissionEndsNormally)) << f.events();
  EXPECT_GT(f.end(), 3600);
  EXPECT_GT(f.deepest(), 25);
  EXPECT_GE(f.starts("set_heading_6", 6), 3) << "every other 300 s: " << f.events();
}

TEST(StockMissions, AVehicleThatMustNotDiveStaysUp) {
  const StockFlight f(
      behaviour("abend",
                "overdepth 1000, overtime 10800, samedepth_for -1, stalled_for -1, "
                "undervolts 6, remaining_charge_min -1") +
          behaviour("surface", "start_when 9, when_secs 1200, end_action 1") +
          behaviour("surface", "start_when 6, when_secs 10000, end_action 0") +
          behaviour("yo",
                    "start_when 4, num_half_cycles_to_do 2, d_target_depth 50, "
                    "d_target_altitude -1, d_bpump_value 1000, d_use_pitch 1, "
                    "d_pitch_value 2, d_stop_when_hover_for -1, d_stop_when_stalled_for -1, "
                    "c_target_depth 1.5, c_bpump_value 1000, c_use_pitch 1, c_pitch_value 2, "
                    "c_stop_when_hover_for -1, c_stop_when_stalled_for -1, end_action 0") +
          behaviour("prepare_to_dive", "start_when 0, wait_time 300") +
          behaviour("sensors_in", "c_att_time 0") +
          behaviour("nop_cmds", "nop_heading 1, nop_air_pump 1"),
      {.duration_s = 11000});
  EXPECT_FALSE(f.has(EventId::Aborts)) << f.events();
  EXPECT_TRUE(f.has(EventId::MissionEndsNormally)) << f.events();
  EXPECT_LT(f.deepest(), 1);
  EXPECT_GE(f.starts("surface_2", 9), 7);
}

TEST(StockMissions, AYoWhoseTargetsContradictEndsByATimeLimit) {
  const StockFlight f("sensor: f_max_working_depth(m) 30\n" +
                      behaviour("abend", "overdepth 1000, overtime 900, samedepth_for 120") +
                      behaviour("surface",
                                "start_when 6, end_action 1, gps_wait_time 30, "
                                "keystroke_wait_time 30, when_secs 600") +
                      kNorth +
                      behaviour("yo",
                                "start_when 2, d_target_depth 2, d_target_altitude -1, "
                                "c_target_depth 10, c_target_altitude -1") +
                      behaviour("prepare_to_dive", "start_when 0, wait_time 5") + kSensors);
  EXPECT_TRUE(f.has("MS_ABORT_OVERTIME") || f.has("MS_ABORT_SAMEDEPTH")) << f.events();
  EXPECT_LE(f.end(), 1100);
  EXPECT_LT(f.lastDepth(), 1);
}

TEST(StockMissions, DriftsAtADepthAndAboveTheBottom) {
  const auto drift = [](double water_m, const std::string& target) {
    return StockFlight(
        behaviour("abend", "samedepth_for 10800") +
            behaviour("surface", "start_when 9, when_secs 4000, end_action 0") + kNorth +
            behaviour("drift_at_depth", "start_when 2, end_action 2, stop_when_hover_for -1, " +
                                            target +
                                            "target_deadband 3, bpump_delta_value 10, "
                                            "bpump_delay 30, use_pitch 3, use_thruster 0, "
                                            "thruster_value 0, battpos_db 0.2") +
            behaviour("prepare_to_dive", "start_when 0, wait_time 720") + kSensors,
        {.depth_m = water_m, .duration_s = 6000});
  };
  const StockFlight at_depth = drift(60, "target_depth 30, target_altitude -1, ");
  EXPECT_TRUE(at_depth.has(EventId::MissionEndsNormally)) << at_depth.events();
  EXPECT_NEAR(valueAt(at_depth.trace, "true_depth", 3500), 30, 8) << at_depth.events();
  const StockFlight above_bottom = drift(50, "target_depth 100, target_altitude 20, ");
  EXPECT_NEAR(valueAt(above_bottom.trace, "true_depth", 3500), 30, 8) << above_bottom.events();
  EXPECT_LT(above_bottom.deepest(), 45) << "never near the bottom";
}

TEST(StockMissions, AThousandMetreYoComesUp) {
  const StockFlight f(behaviour("abend", "overdepth 1020") +
                          behaviour("surface", "start_when 9, when_secs 14000, end_action 0") +
                          kNorth +
                          behaviour("yo",
                                    "start_when 2, d_target_depth 995, d_target_altitude -1, "
                                    "c_target_depth 15") +
                          kSensors,
                      {.depth_m = 3000, .duration_s = 24000});
  EXPECT_FALSE(f.has(EventId::Aborts)) << f.events();
  EXPECT_TRUE(f.has("climb_to over, half cycle 2")) << f.events();
  EXPECT_TRUE(f.has(EventId::MissionEndsNormally)) << f.events();
  EXPECT_GT(f.deepest(), 990);
  EXPECT_LT(f.deepest(), 1020);
}

TEST(StockMissions, DeepYosSurfaceAfterANumberOfThem) {
  const StockFlight f(behaviour("abend", "overdepth 350") +
                          behaviour("surface", "start_when 2, end_action 0") + kNorth +
                          behaviour("yo",
                                    "start_when 2, num_half_cycles_to_do 6, "
                                    "d_target_depth 300, d_target_altitude 20, "
                                    "c_target_depth 20, end_action 0") +
                          kSensors,
                      {.depth_m = 1000, .duration_s = 24000});
  EXPECT_EQ(f.count(EventId::LegOver), 6) << f.events();
  EXPECT_TRUE(f.has(EventId::MissionEndsNormally)) << f.events();
  EXPECT_FALSE(f.has(EventId::Aborts));
}

TEST(StockMissions, InflectionsOfASegmentAreAReasonToSurface) {
  const StockFlight f(
      behaviour("abend", "overdepth 100") +
      behaviour("surface", "start_when 16, when_num_inflections 3, end_action 0") + kNorth +
      behaviour("yo", "start_when 2, d_target_depth 20, c_target_depth 5") + kSensors);
  EXPECT_EQ(f.starts("surface_2", 16), 1) << f.events();
  EXPECT_GE(f.count(EventId::LegOver), 4) << f.events();
  EXPECT_LE(f.count(EventId::LegOver), 5) << f.events();
  EXPECT_TRUE(f.has(EventId::MissionEndsNormally));
}

// The clock of the simulated vehicle begins at 14:13:20 UTC on 11 August 2009.
TEST(StockMissions, ATimeOfDayIsAReasonToSurface) {
  const auto at = [](const std::string& how) {
    return StockFlight(behaviour("abend", "overdepth 100") +
                           behaviour("surface",
                                     "start_when 13, end_action 1, "
                                     "keystroke_wait_time 30, " +
                                         how) +
                           kNorth +
                           behaviour("yo", "start_when 2, d_target_depth 20, c_target_depth 5") +
                           kSensors,
                       {.duration_s = 5000});
  };
  const StockFlight once = at("when_utc_timestamp 908111430, when_secs 0");
  EXPECT_EQ(once.starts("surface_2", 13), 1) << once.events();
  EXPECT_NEAR(once.when("surface_2 started"), 1000, 4);
  const StockFlight again = at("when_utc_timestamp 908111430, when_secs 1200");
  EXPECT_EQ(again.starts("surface_2", 13), 4) << "1000, 2200, 3400, 4600 s: " << again.events();
  const StockFlight late = at("when_utc_timestamp 908111400, when_secs -1");
  EXPECT_EQ(late.starts("surface_2", 13), 1) << "at any time after it: " << late.events();
  const StockFlight never = at("when_utc_timestamp 908111400, when_secs 0");
  EXPECT_EQ(never.starts("surface_2", 13), 0) << "the time is past: " << never.events();
}

TEST(StockMissions, AListOfWaypointsIsFlownOnceAndTheMissionEnds) {
  const StockFlight f(
      behaviour("abend", "overdepth 100") + behaviour("surface", "start_when 3, end_action 0") +
          behaviour("goto_list",
                    "start_when 0, list_stop_when 7, list_when_wpt_dist 60, "
                    "num_legs_to_run -2, initial_wpt 0, num_waypoints 2, "
                    "wpt_x_0 300, wpt_y_0 0, wpt_x_1 600, wpt_y_1 300") +
          behaviour("yo", "start_when 2, d_target_depth 20, c_target_depth 3") + kSensors,
      {.duration_s = 9000});
  EXPECT_TRUE(f.has("waypoint 0 reached")) << f.events();
  EXPECT_TRUE(f.has("waypoint 1 reached")) << f.events();
  EXPECT_TRUE(f.has(EventId::MissionEndsNormally)) << f.events();
  EXPECT_EQ(f.starts("surface_2", 3), 1);
}

TEST(StockMissions, AListThatWaitsForAnOperatorStaysAtItsLastWaypoint) {
  const StockFlight f(behaviour("abend", "overdepth 100") +
                          behaviour("surface", "start_when 9, when_secs 5000, end_action 0") +
                          behaviour("goto_list",
                                    "start_when 0, list_stop_when 7, list_when_wpt_dist 60, "
                                    "num_legs_to_run -2, initial_wpt 0, num_waypoints 1, "
                                    "wpt_x_0 300, wpt_y_0 0, end_action 6") +
                          behaviour("yo", "start_when 2, d_target_depth 20, c_target_depth 3") +
                          kSensors,
                      {.duration_s = 9000});
  EXPECT_EQ(f.count("waypoint 0 reached"), 1) << f.events();
  EXPECT_FALSE(f.has(EventId::Aborts)) << f.events();
  EXPECT_TRUE(f.has(EventId::MissionEndsNormally)) << f.events();
}

TEST(StockMissions, MayBeginWithAClimb) {
  const auto first = [](int start_diving) {
    const StockFlight f(behaviour("surface", "start_when 2, end_action 0") + kNorth +
                        behaviour("yo", fmt::format("start_when 2, start_diving {}, "
                                                    "num_half_cycles_to_do 2, d_target_depth 10, "
                                                    "end_action 0",
                                                    start_diving)) +
                        kSensors);
    return std::string(f.when("climb_to over, half cycle 1") >= 0 ? "climb" : "dive");
  };
  EXPECT_EQ(first(0), "climb");
  EXPECT_EQ(first(1), "dive");
  EXPECT_EQ(first(2), "dive") << "there is nothing to continue yet";
}

// What counts for start_when 12 is contact, not the surface.
TEST(StockMissions, AVehicleThatIsUpButDoesNotCallHasNoContact) {
  const StockFlight f(behaviour("abend", "overtime 5000") +
                          behaviour("surface", "start_when 12, when_secs 1200, end_action 0") +
                          kNorth +
                          behaviour("yo",
                                    "start_when 2, d_target_depth 15, c_target_depth 0.1, "
                                    "c_stop_when_hover_for 60, c_stop_when_stalled_for 90, "
                                    "d_use_pitch 1, d_pitch_value 1.0, c_use_pitch 1, "
                                    "c_pitch_value -1.0, end_action 2") +
                          kSensors,
                      {.depth_m = 150, .duration_s = 6000});
  EXPECT_NEAR(f.when("surface_2 started"), 1204, 4) << f.events();
  EXPECT_TRUE(f.has(EventId::MissionEndsNormally)) << f.events();
  const StockFlight resumed(
      behaviour("abend", "overtime 5000") +
          behaviour("surface",
                    "start_when 12, when_secs 1200, end_action 1, "
                    "keystroke_wait_time 60") +
          kNorth + behaviour("yo", "start_when 2, d_target_depth 30, c_target_depth 3") + kSensors,
      {.depth_m = 150, .duration_s = 4500});
  EXPECT_EQ(resumed.starts("surface_2", 12), 3)
      << "each 1200 s after the last contact: " << resumed.events();
}

}  // namespace
}  // namespace glider::simulator
