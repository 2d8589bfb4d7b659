// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/skeleton.h"

#include "simulator/slocum/flight/argument_values.h"
#include "support/diagnostics/render.h"
#include "vehicles/slocum/mission_files/read.h"

#include <gtest/gtest.h>

#include <string>

namespace glider::simulator {
namespace {

/// The codes that checking `mission` gives.
std::string check(const std::string& mission) {
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  const uint32_t file = sources.add("test.mi", mission);
  const auto read = slocum::readMission(sources, file, diagnostics);
  if (read) {
    checkSkeleton(*read, {file, 0, 0}, diagnostics);
  }
  std::string out;
  for (const auto& diagnostic : diagnostics.sorted()) {
    out += (out.empty() ? "" : " ") + support::code(diagnostic.id);
  }
  return out;
}

TEST(Skeleton, RefusesWhatTheSimulatorCannotFly) {
  EXPECT_EQ(check("behavior: hookbe\n"), "GL5103") << "nearly hookbeh";
  EXPECT_EQ(check("behavior: yo\n b_arg: start_when(enum) 19\n"), "GL5107");
  EXPECT_EQ(check("behavior: sample\n b_arg: state_to_sample(enum) 16\n"), "GL5107");
  EXPECT_EQ(check("behavior: prepare_to_dive\n b_arg: start_when(enum) 6\n"), "GL5107");
  EXPECT_EQ(check("behavior: yo\n b_arg: d_pitch_value(X) -26\n"), "GL5107");
  EXPECT_EQ(check("behavior: hookbeh\n b_arg: silence_secs(s) 1\n"), "GL5107");
  EXPECT_EQ(check("behavior: hookbeh\nbehavior: hookbeh\n"), "GL5208");
  EXPECT_EQ(check(""), "GL5108");
  EXPECT_EQ(check("sensor: c_alt_time(sec) 4\n"), "GL5205") << "settings, for loadmission";
  EXPECT_EQ(check("name unit_999\n"), "GL5205");
  // accepts: GL5103 GL5107 GL5108 GL5205 GL5208
  EXPECT_EQ(check("behavior: yo\n b_arg: start_when(enum) 2\n b_arg: d_pitch_value(X) -0.4538\n"),
            "");
}

TEST(Skeleton, WarnsOfWhatHasNoEffect) {
  const std::string plain = "behavior: yo\nbehavior: sample\nbehavior: sensors_in\n";
  EXPECT_EQ(check("behavior: prepare_to_dive\n" + plain), "");
  EXPECT_EQ(check("sensor: u_alt_reduced_usage_mode(bool) 1\nbehavior: yo\n"), "GL5111");
  EXPECT_EQ(check("behavior: yo\nbehavior: pinger_on\n"), "GL5110");
  EXPECT_EQ(check("behavior: yo\nbehavior: pinger_on\nbehavior: pinger_on\n"), "GL5110") << "once";
  EXPECT_EQ(check("behavior: yo\n b_arg: wobble_amplitude(m) 3\n"), "GL5116");
  EXPECT_EQ(check("behavior: yo\n b_arg: d_use_thruster(enum) 4\n b_arg: c_use_thruster(enum) 4\n"),
            "GL5116")
      << "once";
  EXPECT_EQ(check("sensor: u_mission_param_a(X) 1\nbehavior: yo\n"), "") << "it is read";
  EXPECT_EQ(check("behavior: yo\n b_arg: d_use_thruster(enum) 0\n"),
            "");  // accepts: GL5110 GL5111 GL5116
}

TEST(Skeleton, APositionOfTheBatteryIsClippedAsByTheVehicle) {
  const std::string yo = "behavior: yo\n b_arg: d_use_pitch(enum) 1\n";
  EXPECT_EQ(check(yo + " b_arg: d_pitch_value(X) 3\n"), "GL5206") << "a warning";
  EXPECT_EQ(check(yo + " b_arg: d_pitch_value(X) -1.43\n"), "GL5206");
  EXPECT_EQ(check(yo + " b_arg: d_pitch_value(X) 1.4\n"), "");  // accepts: GL5206
  EXPECT_EQ(check("behavior: yo\n b_arg: d_pitch_value(X) 1.3\n"), "GL5107") << "an angle";
  EXPECT_EQ(check("behavior: dive_to\n b_arg: pitch_value(X) 2\n"), "GL5206")
      << "a battery position, by default";
  EXPECT_EQ(check("behavior: drift_at_depth\n b_arg: use_pitch(enum) 3\n"
                  " b_arg: pitch_value(X) 2\n"),
            "GL5107");
  EXPECT_EQ(check("behavior: surface\n b_arg: c_pitch_value(X) 26\n"), "GL5107") << "degrees";
  const auto platform =
      platforms::loadPlatform(fs::path(GLIDER_SOURCE_DIR) / "platforms/slocum.toml");
  ASSERT_TRUE(platform);
  EXPECT_EQ(kBatteryTravelIn, platform->motion->pitch_battery_limit_in);
}

TEST(Skeleton, FliesTheCodesThatTheVehicleHas) {
  const std::string heading = "behavior: set_heading\n b_arg: heading_value(X) 1\n";
  for (const int code : {1, 2, 5, 6, 7, 8, 15}) {
    EXPECT_EQ(check(heading + fmt::format(" b_arg: use_heading(bool) 1\n"
                                          " b_arg: stop_when(enum) {}\n",
                                          code)),
              "");
  }
  for (const int code : {2, 3, 5}) {
    EXPECT_EQ(check(heading + fmt::format(" b_arg: use_heading(bool) {}\n", code)), "GL5116")
        << "not simulated, and not refused";
  }
  EXPECT_EQ(check(heading), "GL5116") << "a bank, by default";
  EXPECT_EQ(check(heading + " b_arg: use_heading(bool) 6\n"), "GL5107");
  EXPECT_EQ(check("behavior: yo\n b_arg: start_diving(enum) 2\n"), "");
  EXPECT_EQ(check("behavior: yo\n b_arg: d_use_bpump(enum) 5\n"), "GL5116");
  EXPECT_EQ(check("behavior: compass_cal\nbehavior: yo\n"), "GL5110");
  EXPECT_EQ(check("behavior: compass_cal\n b_arg: num_sample(nodim) 3\nbehavior: yo\n"),
            "GL5110 GL5104");
}

TEST(Skeleton, WarnsOfInstrumentsThatItDoesNotHave) {
  const std::string sensors_in = "behavior: sensors_in\n";
  EXPECT_EQ(check(sensors_in + " b_arg: c_flntu_on(sec) 0\n"), "GL5116");
  EXPECT_EQ(check(sensors_in + " b_arg: c_oxy3_on(sec) 4\n"), "GL5116") << "nearly c_oxy4_on";
  EXPECT_EQ(check(sensors_in + " b_arg: c_flntu_on(sec) -1\n"), "") << "switches nothing on";
  EXPECT_EQ(check(sensors_in + " b_arg: c_profile_on(sec) 0\n b_arg: c_flbbcd_on(sec) 1\n"
                               " b_arg: c_oxy4_on(sec) 1\n b_arg: c_gps_on(bool) 1\n"
                               " b_arg: c_science_all_on(sec) 1\n"),
            "");
  EXPECT_EQ(check(sensors_in + " b_arg: c_alt_tim(sec) 0\n"), "GL5104");
  EXPECT_EQ(check("behavior: sample\n b_arg: sensor_type(enum) 39\n"), "GL5116");
  EXPECT_EQ(check("behavior: sample\n b_arg: sensor_type(enum) 39\n"
                  " b_arg: intersample_time(s) -1\n"),
            "");
  for (const int simulated : {0, 1, 48, 54}) {
    EXPECT_EQ(check(fmt::format("behavior: sample\n b_arg: sensor_type(enum) {}\n", simulated)),
              "");
  }
  EXPECT_EQ(check("sensor: c_science_all_on_enabled(bool) 0\nsensor: c_profile_on(sec) 1\n"
                  "sensor: c_alt_time(sec) 1\nbehavior: yo\n"),
            "");
  EXPECT_EQ(check("sensor: c_flntu_on(sec) 0\nbehavior: yo\n"), "GL5111");
}

TEST(Skeleton, ThePrimaryWaypointIsNotKnownUnlessItsDistanceIsSet) {
  for (const int code : {17, 18}) {
    const std::string yo = fmt::format("behavior: yo\n b_arg: start_when(enum) {}\n", code);
    EXPECT_EQ(check(yo), "GL5116");
    EXPECT_EQ(check("sensor: m_dist_to_primary_wpt(m) 800\n" + yo), "");
  }
  EXPECT_EQ(check("behavior: yo\n b_arg: start_when(enum) 16\n"), "");
}

TEST(Skeleton, WaypointsAreOnEarthAndAsManyAsStated) {
  const std::string to = "behavior: goto_wpt\n b_arg: wpt_units(enum) 2\n b_arg: wpt_y(lat) 3900\n";
  EXPECT_EQ(check(to + " b_arg: wpt_x(lon) -7300\n"), "");
  EXPECT_EQ(check(to + " b_arg: wpt_x(lon) 69696969\n"), "GL5107") << "never set";
  EXPECT_EQ(check(to + " b_arg: wpt_x(lon) -18001\n"), "GL5107");
  EXPECT_EQ(check(to + " b_arg: wpt_x(lon) 1000000\n"), "") << "a mission parameter";
  EXPECT_EQ(check("behavior: goto_wpt\n b_arg: wpt_x(X) 90000\n b_arg: wpt_y(X) 0\n"), "")
      << "metres";
  EXPECT_EQ(check("behavior: goto_list\n"), "GL5107") << "no waypoint";
  EXPECT_EQ(check("behavior: goto_list\n b_arg: num_waypoints(nodim) 9\n"), "GL5107");
  EXPECT_EQ(check("behavior: goto_list\n b_arg: num_waypoints(nodim) 8\n"), "");
  EXPECT_EQ(check("behavior: goto_list\n b_arg: num_waypoints(nodim) 1\n"
                  " b_arg: num_legs_to_run(nodim) 0\n"),
            "GL5107");
  EXPECT_EQ(check("behavior: goto_list\n b_arg: num_waypoints(nodim) 1\n"
                  " b_arg: wpt_units_0(enum) 2\n b_arg: wpt_y_0(X) 9100\n"),
            "GL5107");
}

}  // namespace
}  // namespace glider::simulator
