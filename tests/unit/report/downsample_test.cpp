// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/downsample.h"

#include "report/figures.h"
#include "tests/report/sample_trace.h"
#include "tests/unit/report/small_trace.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace glider::report {
namespace {

TEST(Downsample, AShortTraceComesBackUnchanged) {
  const support::Trace trace = sampleTrace();
  const support::Trace thin = downsampled(trace, trace.rowCount());
  EXPECT_EQ(support::traceToCsv(thin), support::traceToCsv(trace));
}

TEST(Downsample, ALongTraceKeepsEndsExtremesAndEveryChangeOfState) {
  const support::Trace trace = longTrace(40'000);
  const support::Trace thin = downsampled(trace, 9000);
  EXPECT_LT(thin.rowCount(), 10'000U);
  const FlightFigures before = flightFigures(trace);
  const FlightFigures after = flightFigures(thin);
  EXPECT_DOUBLE_EQ(after.duration_s, before.duration_s);
  EXPECT_DOUBLE_EQ(after.deepest_m, before.deepest_m);
  EXPECT_DOUBLE_EQ(after.shallowest_m, before.shallowest_m);
  EXPECT_EQ(after.yos, before.yos);
  ASSERT_EQ(after.states.size(), before.states.size());
  for (size_t i = 0; i < before.states.size(); ++i) {
    EXPECT_EQ(after.states[i].stretches, before.states[i].stretches);
    EXPECT_NEAR(after.states[i].time_s, before.states[i].time_s, 1e-6);
  }
}

TEST(Downsample, NeedsNoDepthColumn) {
  auto trace = smallTrace({{"time", "s"}}, {{0}, {1}, {2}, {3}, {4}, {5}, {6}, {7}});
  const support::Trace thin = downsampled(trace, 3);
  EXPECT_EQ(thin.rows, (std::vector<double>{0, 7}));
}

TEST(Downsample, CopesWithDepthsThatAreAllUnknown) {
  auto trace =
      smallTrace({{"time", "s"}, {"m_depth", "m"}}, {{0, kUnknown}, {1, kUnknown}, {2, kUnknown}});
  EXPECT_EQ(downsampled(trace, 1).rowCount(), 2U);
}

TEST(Downsample, OfALogKeepsGapsFixesAndCurrents) {
  support::Trace trace;
  trace.columns = {
      {"time", "s"}, {"m_depth", "m"}, {"gps_x", "m"}, {"current_x", "m/s"}, {"dr_leg", ""}};
  for (int i = 0; i < 1000; ++i) {
    const double gap = i == 500 ? kUnknown : 10, fix = i == 301 ? 7 : kUnknown;
    trace.rows.insert(trace.rows.end(),
                      {4.0 * i, gap, fix, i < 703 ? 0.1 : 0.2, i < 853 ? 0.0 : 1.0});
  }
  const support::Trace thin = downsampled(trace, 30);
  EXPECT_LT(thin.rowCount(), 60U);
  std::vector<double> times;
  for (size_t row = 0; row < thin.rowCount(); ++row) {
    times.push_back(thin.at(row, 0) / 4);
  }
  for (const double kept : {499, 500, 501, 301, 702, 703, 852, 853}) {
    EXPECT_NE(std::ranges::find(times, kept), times.end()) << kept;
  }
}

}  // namespace
}  // namespace glider::report
