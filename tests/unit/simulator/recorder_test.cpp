// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/unit/simulator/flights.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

namespace glider::simulator {
namespace {

std::vector<std::string> namesOf(const support::Trace& trace) {
  std::vector<std::string> names;
  for (const support::TraceColumn& column : trace.columns) {
    names.push_back(column.name);
  }
  return names;
}

TEST(Recorder, SensorsThatAreListedFollowAllOtherColumns) {
  SimulationSetup setup = shippedSetup("layered");
  setup.duration_s = 400;
  SimulationSetup plain = shippedSetup("layered");
  plain.duration_s = 400;
  const std::vector<std::string> before = namesOf(fly(std::move(plain)));
  setup.record = {"m_speed", "m_depth", "m_gps_lat", "sci_water_cond", "no_such_sensor"};
  const support::Trace trace = fly(std::move(setup));
  std::vector<std::string> expected = before;
  expected.insert(expected.end(), {"m_speed", "m_gps_lat", "sci_water_cond"});
  EXPECT_EQ(namesOf(trace), expected) << "a column that there is already is not added";
  EXPECT_EQ(trace.columns[static_cast<size_t>(trace.column("m_speed"))].unit, "m/s");
  EXPECT_EQ(trace.columns[static_cast<size_t>(trace.column("m_gps_lat"))].unit, "deg");
  EXPECT_NEAR(valueAt(trace, "m_gps_lat", 300), 39.175, 0.01) << "degrees, not ddmm";
  // Between that of the water at the surface, 24 degC and 31.5, and at the bottom, 7 degC and 33.
  EXPECT_GT(valueAt(trace, "sci_water_cond", 300), 3.3);
  EXPECT_LT(valueAt(trace, "sci_water_cond", 300), 4.8);
}

TEST(Recorder, EnergyIsWhatThePackHasLost) {
  SimulationSetup setup = shippedSetup("layered");
  setup.duration_s = 1800;
  setup.scenario.vehicle.battery.start_V = 13;
  const platforms::Power pack = setup.scenario.vehicle.battery.power;
  const support::Trace trace = fly(std::move(setup));
  EXPECT_EQ(valueAt(trace, "energy", 0), 0);
  const double volts = pack.full_V - pack.empty_V;
  const double capacity_Wh = pack.capacity_kj / 3.6;
  ASSERT_TRUE(trace.battery);
  EXPECT_NEAR(trace.battery->used_Wh, (pack.full_V - 13) / volts * capacity_Wh, 1e-6);
  EXPECT_NEAR(trace.battery->capacity_Wh, capacity_Wh, 1e-6);
  const double energy = valueAt(trace, "energy", trace.at(trace.rowCount() - 1, 0));
  double sum = 0;
  for (const support::Consumer& one : trace.battery->consumers) {
    sum += one.used_Wh;
    EXPECT_NE(one.device, "SBC") << "none flies";
  }
  EXPECT_NEAR(sum, energy, 0.02) << "what the devices took";
  const double seen_Wh =
      (13 - valueAt(trace, "m_battery", 1100)) / volts * trace.battery->capacity_Wh;
  EXPECT_GT(seen_Wh, energy) << "the voltage sags under load";
}

TEST(Recorder, TheTrueCurrentIsTheScenarios) {
  SimulationSetup setup = shippedSetup("default");
  setup.duration_s = 60;
  const support::Trace trace = fly(std::move(setup));
  EXPECT_DOUBLE_EQ(valueAt(trace, "true_current_x", 40), 0.02);
  EXPECT_DOUBLE_EQ(valueAt(trace, "true_current_y", 40), -0.03);
  EXPECT_EQ(trace.start_utc_s, 1.25e9);
}

TEST(Recorder, TheBottomAroundTheTrackIsThatOfTheOcean) {
  SimulationSetup setup = shippedSetup("shelf_slope");
  setup.duration_s = 600;
  const Ocean ocean(setup.scenario.ocean);
  const support::Trace trace = fly(std::move(setup));
  const support::BottomGrid& grid = trace.bottom;
  ASSERT_EQ(grid.depths_m.size(), grid.x_m.size() * grid.y_m.size());
  ASSERT_GT(grid.x_m.size(), 10U);
  EXPECT_LT(grid.x_m.front(), valueAt(trace, "true_x", 0) - 90) << "half of 200 m around it";
  EXPECT_GT(grid.y_m.back(), valueAt(trace, "true_y", 600) + 90);
  for (const size_t i : {size_t{0}, size_t{7}, grid.x_m.size() - 1}) {
    for (const size_t j : {size_t{0}, size_t{5}, grid.y_m.size() - 1}) {
      EXPECT_DOUBLE_EQ(grid.depths_m[i * grid.y_m.size() + j],
                       ocean.waterDepth(grid.x_m[i], grid.y_m[j]));
    }
  }
  SimulationSetup flat = shippedSetup("figure5");
  flat.duration_s = 60;
  EXPECT_TRUE(fly(std::move(flat)).bottom.depths_m.empty());
}

}  // namespace
}  // namespace glider::simulator
