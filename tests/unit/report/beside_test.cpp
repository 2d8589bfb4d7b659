// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/beside.h"

#include "support/diagnostics/diagnostic.h"
#include "tests/unit/report/small_trace.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glider::report {
namespace {

support::Trace logOf(std::initializer_list<std::vector<double>> rows) {
  auto trace = smallTrace({{"time", "s"}, {"m_depth", "m"}, {"dr_x", "m"}, {"dr_y", "m"}}, rows);
  trace.log.emplace().vehicle = "comet";
  return trace;
}

support::Trace flightOf(std::initializer_list<std::vector<double>> rows) {
  return smallTrace({{"time", "s"}, {"m_depth", "m"}, {"true_x", "m"}, {"true_y", "m"}}, rows);
}

TEST(Beside, BothFlightsLeaveTheSurfaceAtTheSameTime) {
  auto log = logOf(
      {{0, 0, 50, 60}, {100, 0, 50, 60}, {104, 4, 50, 60}, {108, 6, 51, 60}, {112, 8, 52, 60}});
  const auto flight = flightOf({{0, 0, 0, 0}, {10, 4, 5, 6}, {16, 10, 8, 9}});
  const auto shift = shiftBeside(log, flight, "f.csv");
  ASSERT_TRUE(shift);
  EXPECT_EQ(*shift, 94);
  addBeside(log, flight, *shift, "f.csv");
  EXPECT_EQ(log.log->beside, "f.csv");
  const int depth = log.column("sim_depth"), x = log.column("sim_x"), y = log.column("sim_y");
  ASSERT_EQ(log.rowCount(), 5U);
  EXPECT_TRUE(std::isnan(log.at(0, depth))) << "before the simulated flight";
  EXPECT_DOUBLE_EQ(log.at(1, depth), 2.4);
  EXPECT_DOUBLE_EQ(log.at(2, depth), 4);
  EXPECT_DOUBLE_EQ(log.at(3, depth), 8);
  EXPECT_TRUE(std::isnan(log.at(4, depth))) << "after it";
  EXPECT_DOUBLE_EQ(log.at(2, x), 50) << "the tracks meet where the dives begin";
  EXPECT_DOUBLE_EQ(log.at(2, y), 60);
  EXPECT_DOUBLE_EQ(log.at(3, x), 52);
  EXPECT_EQ(log.at(4, 1), 8) << "the log is as it was";
}

TEST(Beside, ALogWithoutPositionsHasNoSimulatedTrack) {
  auto log = smallTrace({{"time", "s"}, {"m_depth", "m"}}, {{0, 0}, {4, 5}, {8, 9}});
  log.log.emplace();
  const auto flight = flightOf({{0, 0, 0, 0}, {4, 4, 5, 6}, {8, 10, 8, 9}});
  addBeside(log, flight, 0, "f.csv");
  EXPECT_EQ(log.at(1, log.column("sim_depth")), 4);
  EXPECT_TRUE(std::isnan(log.at(1, log.column("sim_x"))));
}

TEST(Beside, AFlightThatNeverDivesCannotBeAligned) {
  const auto dives = flightOf({{0, 0, 0, 0}, {4, 9, 0, 0}});
  const auto floats = flightOf({{0, 0, 0, 0}, {4, 1, 0, 0}});
  for (const auto& [log, flight, who] :
       {std::tuple{dives, floats, "simulated flight"}, std::tuple{floats, dives, "vehicle"}}) {
    const auto shift = shiftBeside(log, flight, "f.csv");
    ASSERT_FALSE(shift);
    EXPECT_EQ(support::code(shift.error().id), "GL9367");
    EXPECT_NE(shift.error().message.find(who), std::string::npos) << shift.error().message;
  }
}

}  // namespace
}  // namespace glider::report
