// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Missions that gliders have flown, in the simulator, without an SBC.

#include "simulator/slocum/flight/skeleton.h"
#include "simulator/slocum/own_mission.h"
#include "support/diagnostics/render.h"
#include "tests/unit/simulator/flights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>

namespace glider::simulator {
namespace {

namespace fs = std::filesystem;

const fs::path kMissions = fs::path(GLIDER_SOURCE_DIR) / "../shared/data/missions";

class RealMissions : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(kMissions)) {
      GTEST_SKIP() << "the real mission files are not here: " << kMissions;
    }
  }

  /// A flight of `file` in the water of the default scenario, moved to where the mission was flown.
  static SimulationSetup setup(const std::string& file, double latitude_deg, double longitude_deg,
                               double hours) {
    SimulationSetup setup = shippedSetup("default");
    support::SourceManager sources;
    support::DiagnosticEngine diagnostics;
    auto mission = loadMissionFile(kMissions / file, sources, diagnostics);
    EXPECT_TRUE(mission) << support::render(diagnostics, sources, false);
    if (mission) {
      missionFileOf(setup.scenario) = std::move(*mission);
    }
    setup.scenario.latitude_deg = latitude_deg;
    setup.scenario.longitude_deg = longitude_deg;
    setup.duration_s = hours * 3600;
    return setup;
  }

  static size_t count(const support::Trace& trace, support::EventId id) {
    return static_cast<size_t>(std::ranges::count(trace.events, id, &support::TraceEvent::id));
  }
  static size_t starts(const support::Trace& trace, const std::string& name) {
    return static_cast<size_t>(std::ranges::count_if(trace.events, [&](const auto& event) {
      return event.id == support::EventId::BehaviourStarts &&
             std::get<std::string>(event.values[0]).starts_with(name + "_");
    }));
  }
  static double deepest(const support::Trace& trace) {
    double most = 0;
    for (size_t row = 0; row < trace.rowCount(); ++row) {
      most = std::max(most, trace.at(row, trace.column("true_depth")));
    }
    return most;
  }
};

TEST_F(RealMissions, HelgoDivesItsFourHalfCyclesAndComesUp) {
  const support::Trace trace = fly(setup("comet-and-helgoland/calibration/helgo.mi", 54.3, 6.7, 3));
  EXPECT_EQ(count(trace, EventId::AbortedAtSurface), 0U) << eventText(trace);
  EXPECT_EQ(count(trace, EventId::Aborts), 0U) << eventText(trace);
  EXPECT_GE(count(trace, EventId::LegOver), 4U) << eventText(trace);
  EXPECT_GE(starts(trace, "surface"), 1U);
  EXPECT_GT(deepest(trace), 25);
}

TEST_F(RealMissions, Nsb3SteersToItsWaypointsAndSurfacesEveryThreeHours) {
  const support::Trace trace = fly(setup("comet-and-helgoland/nsb3/nsb3.mi", 54.55, 7.2, 8));
  EXPECT_EQ(count(trace, EventId::Aborts), 0U) << eventText(trace);
  EXPECT_GE(starts(trace, "surface"), 2U) << eventText(trace);
  EXPECT_GE(count(trace, EventId::LegOver), 10U);
  const int bearing = trace.column("c_wpt_lat");
  EXPECT_NEAR(trace.at(trace.rowCount() / 2, bearing), 54.5, 0.3);
}

TEST_F(RealMissions, SpiralTurnsWithAFixedFin) {
  const support::Trace trace = fly(setup("comet-and-helgoland/spiral/spiral.mi", 54.3, 6.7, 4));
  EXPECT_EQ(count(trace, EventId::Aborts), 0U) << eventText(trace);
  EXPECT_GE(count(trace, EventId::LegOver), 4U) << eventText(trace);
}

TEST_F(RealMissions, Bsdsta01KeepsStillOnTheSurfaceUntilItsTimeIsOver) {
  const support::Trace trace = fly(setup("backseat/bsdsta01.mi", 39.2, -73.8, 1));
  // Nothing flies: it ends by overtime (360 s), at the surface.
  const auto* over = findEvent(trace, "MS_ABORT_OVERTIME");
  ASSERT_NE(over, nullptr) << eventText(trace);
  EXPECT_EQ(over->time_s, 364);
  EXPECT_LT(deepest(trace), 1);
}

TEST_F(RealMissions, Backse01DoesWhatTheBackseatSets) {
  SimulationSetup flight = setup("backseat/backse01.mi", 39.2, -73.8, 3);
  slocumMissionOf(flight.scenario).code_15 = Code15::MissionMode;
  // A dive to 20 m and back to 3 m at 26 degrees on heading 90 degrees; after an hour: come up.
  for (const auto& [sensor, value] : {std::pair("u_mission_param_c", 20.0),
                                      {"u_mission_param_d", 5},
                                      {"u_mission_param_e", 3},
                                      {"u_mission_param_f", -0.4538},
                                      {"u_mission_param_h", 0.4538},
                                      {"u_mission_param_j", 1.5708}}) {
    flight.scenario.puts.push_back({0, sensor, value});
  }
  flight.scenario.puts.push_back({3600, "u_mission_mode", 1});
  const support::Trace trace = fly(std::move(flight));
  EXPECT_EQ(count(trace, EventId::Aborts), 0U) << eventText(trace);
  EXPECT_GT(deepest(trace), 18);
  EXPECT_LT(deepest(trace), 28);
  const auto* up = findStart(trace, "surface");
  ASSERT_NE(up, nullptr) << eventText(trace);
  EXPECT_NEAR(up->time_s, 3600, 8);
  EXPECT_GT(valueAt(trace, "true_x", 3600), 300) << "magnetic east";
}

}  // namespace
}  // namespace glider::simulator
