// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/bottom_contact.h"
#include "tests/unit/simulator/flights.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace glider::simulator {
namespace {

const std::string kLayeredYo =
    "behavior: yo\n b_arg: num_half_cycles_to_do(nodim) 4\n b_arg: end_action(enum) 0\n"
    " b_arg: d_target_depth(m) 20\n b_arg: c_target_depth(m) 3\n";
const std::string kHeading =
    "behavior: set_heading\n b_arg: use_heading(bool) 1\n b_arg: heading_value(rad) 1.0\n";
const std::string kLayeredSurface =
    "behavior: surface\n b_arg: start_when(enum) 1\n b_arg: end_action(enum) 0\n b_arg: "
    "gps_wait_time(s) 60\n";

TEST(Layered, FliesThreeYosAndSurfaces) {
  const support::Trace trace = fly(shippedSetup("layered"));
  const std::string events = eventText(trace);
  const auto* over = findEvent(trace, "climb_to over, half cycle 6");
  ASSERT_NE(over, nullptr) << events;
  EXPECT_EQ(findEvent(trace, "half cycle 7"), nullptr);
  const auto* surface = findStart(trace, "surface");
  ASSERT_NE(surface, nullptr) << events;
  EXPECT_EQ(surface->time_s, over->time_s) << "in the same cycle, or the stack would be idle";
  ASSERT_NE(findEvent(trace, EventId::MissionEndsNormally), nullptr) << events;
  for (const auto& event : trace.events) {
    EXPECT_NE(event.id, support::EventId::Aborts) << textOf(event);
  }
  double deepest = 0;
  for (size_t row = 0; row < trace.rowCount(); ++row) {
    deepest = std::max(deepest, trace.at(row, trace.column("true_depth")));
  }
  EXPECT_GT(deepest, 30);
  EXPECT_LT(deepest, 33.5) << "overshoot of an inflection";
}

TEST(Layered, YoHasTheSpeedsOfAGlider) {
  const support::Trace trace = fly(shippedSetup("layered"));
  double down = 0, up = 0, ahead = 0;
  int downs = 0, ups = 0;
  for (size_t row = 1; row + 1 < trace.rowCount(); ++row) {
    const double depth = trace.at(row, trace.column("true_depth"));
    const double rate = (depth - trace.at(row - 1, trace.column("true_depth"))) / 4;
    if (depth > 10 && depth < 25 && std::fabs(rate) > 0.05) {
      (rate > 0 ? down : up) += std::fabs(rate);
      ++(rate > 0 ? downs : ups);
      ahead +=
          std::hypot(
              trace.at(row, trace.column("true_x")) - trace.at(row - 1, trace.column("true_x")),
              trace.at(row, trace.column("true_y")) - trace.at(row - 1, trace.column("true_y"))) /
          4;
    }
  }
  EXPECT_GT(down / downs, 0.13);
  EXPECT_LT(down / downs, 0.21);
  EXPECT_GT(up / ups, 0.13);
  EXPECT_LT(up / ups, 0.21);
  EXPECT_GT(ahead / (downs + ups), 0.28);
  EXPECT_LT(ahead / (downs + ups), 0.42);
  const double first = findEvent(trace, "half cycle 2")->time_s,
               second = findEvent(trace, "half cycle 4")->time_s;
  EXPECT_GT(second - first, 250);
  EXPECT_LT(second - first, 480);
  // Dead reckoning counts on a steady flight; each turn is a little slower.
  const size_t last = trace.rowCount() - 20;
  const double run = trace.at(last, trace.column("true_x"));
  EXPECT_NEAR(trace.at(last, trace.column("m_x_lmc")), run, 0.08 * run);
  EXPECT_NEAR(trace.at(last, trace.column("m_heading")), 1.7863, 0.15);
}

TEST(Layered, IdleStackAborts) {
  const support::Trace nothing = fly(setupWith("behavior: abend\n"));
  ASSERT_NE(findEvent(nothing, "MS_ABORT_STACK_IS_IDLE"), nullptr) << eventText(nothing);
  EXPECT_EQ(findEvent(nothing, "MS_ABORT_STACK_IS_IDLE")->time_s, 0);
  const support::Trace no_heading = fly(setupWith(kLayeredYo));
  ASSERT_NE(findEvent(no_heading, "MS_ABORT_HEADING_IS_IDLE"), nullptr) << eventText(no_heading);
  const support::Trace no_pitch = fly(setupWith(kHeading));
  ASSERT_NE(findEvent(no_pitch, "MS_ABORT_PITCH_IS_IDLE"), nullptr) << eventText(no_pitch);
}

TEST(Layered, AnIdleStackSaysWhichCommandIsMissing) {
  const support::Trace no_heading = fly(setupWith(kLayeredYo));
  EXPECT_EQ(findEvent(no_heading, "MS_ABORT_HEADING")->why,
            "no behaviour gives a command for the heading");
  const support::Trace no_pitch = fly(setupWith(kHeading));
  EXPECT_EQ(findEvent(no_pitch, "MS_ABORT_PITCH")->why,
            "no behaviour gives a command for the pitch");
  const support::Trace no_pump =
      fly(setupWith("behavior: nop_cmds\n b_arg: nop_heading(bool) 1\n b_arg: nop_pitch(bool) 1\n"
                    " b_arg: nop_bpump(bool) 0\n"));
  ASSERT_NE(findEvent(no_pump, "MS_ABORT_BPUMP"), nullptr) << eventText(no_pump);
  EXPECT_EQ(findEvent(no_pump, "MS_ABORT_BPUMP")->why, "no behaviour gives a command for the pump");
  const support::Trace nothing = fly(setupWith("behavior: abend\n"));
  EXPECT_EQ(findEvent(nothing, "MS_ABORT_STACK")->why, "no behaviour gives a command");
}

/// As the vehicle does: by its name and its place in the mission, counted from 1.
TEST(Layered, EventsSayWhichBehaviourStartedAndWhy) {
  const std::string silent =
      "behavior: surface\n b_arg: start_when(enum) 12\n b_arg: when_secs(s) 150\n b_arg: "
      "end_action(enum) 1\n b_arg: keystroke_wait_time(s) 8\n";
  const support::Trace trace =
      fly(setupWith("behavior: abend\n" + silent + kLayeredSurface + kHeading + kLayeredYo));
  const auto* first = findStart(trace, "surface");
  ASSERT_NE(first, nullptr) << eventText(trace);
  EXPECT_EQ(textOf(*first), "surface_2 started");
  EXPECT_EQ(first->why, "start_when 12: no contact for 150 s");
  EXPECT_EQ(textOf(*findStart(trace, "yo")), "yo_5 started");
  EXPECT_EQ(findStart(trace, "yo")->why, "start_when 2: no behaviour below commands pitch");
  EXPECT_NE(findEvent(trace, "yo_5: dive_to over, half cycle 1"), nullptr);
  EXPECT_EQ(findEvent(trace, "surface_2 done, waits for its next start")->why, "");
  const auto* last = findEvent(trace, "surface_3 started");
  ASSERT_NE(last, nullptr) << eventText(trace);
  EXPECT_EQ(last->why, "start_when 1: no behaviour below commands pitch or pump");
  EXPECT_EQ(findEvent(trace, EventId::MissionEndsNormally)->why,
            "surface_3 has ended it; it started by start_when 1: no behaviour below commands "
            "pitch or pump");
}

/// With a surface for an idle stack, a mission that lacks a heading is over when it begins.
TEST(Layered, AMissionWithoutAHeadingSaysWhyItEnds) {
  const support::Trace trace = fly(setupWith(kLayeredSurface + kLayeredYo));
  const auto* end = findEvent(trace, EventId::MissionEndsNormally);
  ASSERT_NE(end, nullptr) << eventText(trace);
  EXPECT_EQ(end->time_s, 0);
  EXPECT_NE(findEvent(trace, "surface_1 started"), nullptr) << "though it ends in the same cycle";
  EXPECT_EQ(end->why,
            "surface_1 has ended it; it started by start_when 1: no behaviour below commands "
            "heading");
}

TEST(Layered, TheBottomIsAnEventOnceForEachContact) {
  const auto flown = [](double water_depth_m) {
    SimulationSetup setup =
        setupWith(kLayeredSurface + kHeading + kLayeredYo + " b_arg: d_target_altitude(m) -1\n");
    setup.scenario.ocean.bottom.depth_m = water_depth_m;
    setup.duration_s = 1500;
    return fly(std::move(setup));
  };
  const support::Trace trace = flown(14);
  const auto* touch = findEvent(trace, EventId::TouchesBottom);
  ASSERT_NE(touch, nullptr) << eventText(trace);
  EXPECT_EQ(touch->id, EventId::TouchesBottom);
  EXPECT_NEAR(valueAt(trace, "true_depth", touch->time_s), 14, 1.5);
  // Both dives are to 20 m, and hover on the bottom for 180 s.
  EXPECT_EQ(
      std::ranges::count(trace.events, support::EventId::TouchesBottom, &support::TraceEvent::id),
      2)
      << eventText(trace);
  EXPECT_EQ(findEvent(flown(60), EventId::TouchesBottom), nullptr);
}

TEST(BottomContact, BeginsAtTheBottomAndEndsAMetreAboveIt) {
  BottomContact contact;
  Journal journal;
  const auto after = [&](double depth_m) {
    contact.look(8, depth_m, 20, journal);
    return journal.events().size();
  };
  EXPECT_EQ(after(19.9), 0U);
  EXPECT_EQ(after(19.96), 1U);
  EXPECT_EQ(after(19.5), 1U);
  EXPECT_EQ(after(20), 1U) << "it slides";
  EXPECT_EQ(after(18.9), 1U);
  EXPECT_EQ(after(20), 2U);
  EXPECT_EQ(journal.events()[0].time_s, 8);
  BottomContact aground;
  Journal none;
  aground.look(0, 0.9, 0.9, none);
  EXPECT_TRUE(none.events().empty()) << "it has not dived";
}

TEST(Layered, AbortBringsTheVehicleUp) {
  const support::Trace trace = fly(setupWith(kHeading + kLayeredYo));
  const auto* abort = findEvent(trace, "MS_ABORT_PITCH_IS_IDLE");
  ASSERT_NE(abort, nullptr) << "when the yo is over nothing commands pitch" << eventText(trace);
  EXPECT_GT(abort->time_s, 300);
  EXPECT_NE(findEvent(trace, "aborted (MS_ABORT_PITCH_IS_IDLE) and at the surface"), nullptr)
      << eventText(trace);
  EXPECT_EQ(trace.at(trace.rowCount() - 1, trace.column("true_depth")), 0);
}

TEST(Layered, AbendWatchesDepthAndTime) {
  const std::string deep =
      "behavior: abend\n b_arg: overdepth(m) 12\n" + kLayeredSurface + kHeading + kLayeredYo;
  const support::Trace overdepth = fly(setupWith(deep));
  ASSERT_NE(findEvent(overdepth, "MS_ABORT_OVERDEPTH"), nullptr) << eventText(overdepth);
  EXPECT_NEAR(valueAt(overdepth, "m_depth", findEvent(overdepth, "MS_ABORT_OVERDEPTH")->time_s),
              12.4, 0.5);
  const support::Trace overtime = fly(setupWith("behavior: abend\n b_arg: overtime(s) 100\n" +
                                                kLayeredSurface + kHeading + kLayeredYo));
  ASSERT_NE(findEvent(overtime, "MS_ABORT_OVERTIME"), nullptr);
  EXPECT_EQ(findEvent(overtime, "MS_ABORT_OVERTIME")->time_s, 104);
}

TEST(Layered, HigherBehavioursWin) {
  const std::string east =
      "behavior: set_heading\n b_arg: use_heading(bool) 1\n b_arg: heading_value(rad) 1.5\n";
  const std::string south =
      "behavior: set_heading\n b_arg: use_heading(bool) 1\n b_arg: heading_value(rad) 3.1\n";
  const support::Trace trace = fly(setupWith(kLayeredSurface + east + south + kLayeredYo));
  EXPECT_NEAR(valueAt(trace, "c_heading", 200), 1.5, 1e-6);
  EXPECT_EQ(valueAt(trace, "layer", 200), 3) << "the yo commands the pitch";
  // A start condition sees only what is below: this heading has nothing below it that steers.
  const std::string idle =
      "behavior: set_heading\n b_arg: use_heading(bool) 1\n b_arg: heading_value(rad) 2.0\n b_arg: "
      "start_when(enum) 3\n";
  EXPECT_NEAR(
      valueAt(fly(setupWith(kLayeredSurface + south + idle + kLayeredYo)), "c_heading", 200), 3.1,
      1e-6);
  EXPECT_NEAR(
      valueAt(fly(setupWith(kLayeredSurface + idle + south + kLayeredYo)), "c_heading", 200), 3.1,
      1e-6);
}

/// Steering east to a waypoint in a current of 0.15 m/s to the south: with u_use_current_correction
/// the vehicle points into it after its first dive, and counts on it.
TEST(Layered, UsesTheCurrentThatItHasFound) {
  const std::string to_east =
      "behavior: goto_wpt\n b_arg: wpt_units(enum) 0\n b_arg: wpt_x(X) 20000\n b_arg: wpt_y(X) 0\n"
      " b_arg: stop_when(enum) 5\n";
  const std::string surfaces =
      "behavior: surface\n b_arg: start_when(enum) 9\n b_arg: when_secs(s) 3000\n"
      " b_arg: end_action(enum) 1\n b_arg: keystroke_wait_time(s) 120\n b_arg: gps_wait_time(s) "
      "120\n";
  const std::string yo =
      "behavior: yo\n b_arg: d_target_depth(m) 40\n b_arg: c_target_depth(m) 5\n";
  double astray[2] = {}, heading[2] = {};
  for (const bool uses : {false, true}) {
    SimulationSetup setup =
        setupWith(fmt::format("sensor: u_use_current_correction(nodim) {}\n", uses ? 1 : 0) +
                  surfaces + to_east + yo);
    setup.duration_s = 12000;
    setup.scenario.ocean.current = setup.scenario.ocean.bottom_current = {0, -0.15};
    const support::Trace trace = fly(std::move(setup));
    const double late = 11000;
    EXPECT_NEAR(valueAt(trace, "m_water_vy", late), -0.15, 0.03);
    EXPECT_NEAR(valueAt(trace, "m_water_vx", late), 0, 0.03);
    astray[uses] = std::fabs(valueAt(trace, "m_y_lmc", late) - valueAt(trace, "true_y", late));
    heading[uses] = valueAt(trace, "c_heading", late);
  }
  EXPECT_GT(astray[0], 150);
  EXPECT_LT(astray[1], 60);
  EXPECT_LT(heading[1], heading[0] - 0.3) << "it points to the north of its way";
}

/// Where the needle points 16.7 degrees east: the sensors are magnetic, the trace is true.
TEST(Layered, TheTraceShowsTheCurrentTowardsTrueEastAndNorth) {
  SimulationSetup setup = setupWith(
      "behavior: surface\n b_arg: start_when(enum) 1\n b_arg: end_action(enum) 1\n"
      " b_arg: keystroke_wait_time(s) 300\n" +
      kHeading + kLayeredYo);
  setup.scenario.latitude_deg = 51.65;
  setup.scenario.longitude_deg = -128.09;
  setup.scenario.sensors.gps.noise_m = 0;
  setup.scenario.ocean.current = setup.scenario.ocean.bottom_current = {0.3, 0};
  const support::Trace trace = fly(std::move(setup));
  const size_t last = trace.rowCount() - 1;
  EXPECT_NEAR(trace.at(last, trace.column("m_water_vx")), 0.3, 0.04);
  EXPECT_NEAR(trace.at(last, trace.column("m_water_vy")), 0, 0.04);
}

/// Of the way from the start, rad clockwise from true north, at 400 s.
double wayFrom(const support::Trace& trace, const char* x, const char* y) {
  return std::atan2(valueAt(trace, x, 400), valueAt(trace, y, 400));
}

TEST(Layered, HeadingsAreMagnetic) {
  // Off New Jersey, off British Columbia, where the needle points 16.7 degrees east, and there in
  // another year. The vehicle's tables are as good as a tenth of a degree.
  const struct {
    double latitude_deg, longitude_deg, year, declination_deg;
  } places[] = {{39.175, -73.835, 2025, -12.350},
                {51.65, -128.09, 2025, 16.693},
                {51.65, -128.09, 2027, 16.383}};
  const std::string north =
      "behavior: set_heading\n b_arg: use_heading(bool) 1\n b_arg: heading_value(rad) 1.0\n";
  for (const auto& place : places) {
    SCOPED_TRACE(place.declination_deg);
    SimulationSetup setup = setupWith(kLayeredSurface + north + kLayeredYo);
    setup.scenario.latitude_deg = place.latitude_deg;
    setup.scenario.longitude_deg = place.longitude_deg;
    setup.scenario.year = place.year;
    setup.scenario.vehicle.initial_heading_rad = 1 + place.declination_deg / 57.29578;
    setup.scenario.sensors.attitude.heading_rad = setup.scenario.sensors.gps.noise_m = 0;
    const support::Trace trace = fly(std::move(setup));
    EXPECT_NEAR(valueAt(trace, "c_heading", 200), 1, 1e-6);
    EXPECT_NEAR(valueAt(trace, "m_heading", 0), 1, 1e-4) << "by the compass";
    const double true_heading = 1 + place.declination_deg / 57.29578;
    EXPECT_NEAR(wayFrom(trace, "true_x", "true_y"), true_heading, 0.01);
    EXPECT_NEAR(wayFrom(trace, "m_x_lmc", "m_y_lmc"), true_heading, 0.01) << "dead-reckoned";
  }
}

TEST(Layered, SurfacesWithoutCommunication) {
  const std::string silent =
      "behavior: surface\n b_arg: start_when(enum) 12\n b_arg: when_secs(s) 150\n b_arg: "
      "end_action(enum) 0\n";
  const support::Trace trace = fly(setupWith(silent + kHeading + kLayeredYo));
  const auto* started = findStart(trace, "surface");
  ASSERT_NE(started, nullptr) << eventText(trace);
  EXPECT_NEAR(started->time_s, 160, 30);
  EXPECT_NE(findEvent(trace, EventId::MissionEndsNormally), nullptr);
}

TEST(Layered, SteersToAWaypoint) {
  const std::string there =
      "behavior: goto_wpt\n b_arg: wpt_units(enum) 2\n b_arg: wpt_x(lon) -7350.1\n b_arg: "
      "wpt_y(lat) 3911.0\n"
      " b_arg: stop_when(enum) 5\n";
  const support::Trace trace = fly(setupWith(kLayeredSurface + there + kLayeredYo));
  // True north, on a compass that reads 12.4 degrees more.
  EXPECT_GT(std::cos(valueAt(trace, "c_heading", 200) - 0.2164), 0.99);
  EXPECT_GT(valueAt(trace, "true_y", 500), 60);
}

TEST(Simulator, IsDeterministicForASeed) {
  const std::string first = traceToCsv(fly(shippedSetup("layered")));
  EXPECT_EQ(first, traceToCsv(fly(shippedSetup("layered"))));
  SimulationSetup other = shippedSetup("layered");
  other.seed = 99;
  EXPECT_NE(first, traceToCsv(fly(std::move(other))));
}

TEST(Simulator, EndsWithItsTimeAndReportsProgress) {
  SimulationSetup setup = shippedSetup("layered");
  setup.duration_s = 400;
  int calls = 0;
  setup.progress = [&](const Progress& progress) {
    EXPECT_EQ(progress.duration_s, 400);
    ++calls;
  };
  const support::Trace trace = fly(std::move(setup));
  EXPECT_EQ(trace.rowCount(), 101U);
  EXPECT_EQ(calls, 5);
  EXPECT_NE(findEvent(trace, "time of 400 s is over"), nullptr);
  EXPECT_EQ(trace.field.depths_m.size(), 80U);
  EXPECT_EQ(trace.field.times_s.size(), 101U);
  EXPECT_EQ(trace.field.values.size(), 101U * 80U);
}

TEST(Simulator, RefusesAPlatformWithoutItsSensors) {
  SimulationSetup setup = shippedSetup("layered");
  for (platforms::PlatformSensor& sensor : setup.platform.sensors) {
    sensor.name = sensor.name == "m_pitch" ? "m_tilt" : sensor.name;
  }
  const auto result = simulate(std::move(setup));
  ASSERT_FALSE(result);
  EXPECT_EQ(support::code(result.error().id), "GL5121");  // accepts: GL5121 — every other test here
}

}  // namespace
}  // namespace glider::simulator
