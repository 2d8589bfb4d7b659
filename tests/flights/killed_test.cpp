// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The SBC dies in flight: the layered control brings the glider up.

#include "tests/flights/flight.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace glider::tests {
namespace {

class Killed : public testing::TestWithParam<const char*> {};

TEST_P(Killed, UnderTheSkeletonTheGliderClimbsWithinTheStatedSeconds) {
  const Flight flight = fly(project("missions/figure2.mission") + " --scenario " +
                            project("scenarios/default.toml") + " --kill-sbc-at 800" + GetParam());
  const auto time = flight.column("time");
  const auto depth = flight.column("true_depth");
  const auto killed = std::ranges::find_if(
      flight.events, [](const Event& e) { return e.kind == "link" && e.time_s >= 800; });
  ASSERT_NE(killed, flight.events.end());
  EXPECT_NE(killed->what.find("SBC"), std::string::npos) << killed->what;
  // silence_secs of skeleton.mi is 24; a cycle to notice, a cycle for the surface behaviour, 20 s
  // for pump and pitch.
  const double deadline = 800 + 24 + 8 + 20;
  for (size_t i = 1; i < time.size(); ++i) {
    if (time[i] > deadline && depth[i] > 0.5) {
      EXPECT_LT(depth[i], depth[i - 1]) << "sinking at " << time[i] << " s";
    }
  }
  EXPECT_LT(*std::ranges::min_element(depth.end() - 20, depth.end()), 1.0);
  const auto transitions = flight.transitions();
  ASSERT_EQ(transitions.size(), 1U);
  EXPECT_EQ(transitions[0].what, "s1 → s2 (call)");
}

INSTANTIATE_TEST_SUITE_P(, Killed, testing::Values("", " --board host", " --board ts7800"));

}  // namespace
}  // namespace glider::tests
