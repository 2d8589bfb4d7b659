// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// missions/detector: a scientist's own C++ code, built for every board and flown.

#include "tests/flights/flight.h"
#include "tests/support/user_code.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glider::tests {
namespace {

TEST(Detector, FindsTheBloomOnEveryBoardAlike) {
  const TemporaryFolder folder;
  const std::string mission = project("missions/detector/bloom_detector.mission");
  const auto source =
      folder.write("bloom_detector.cpp", slurp(project("missions/detector/bloom_detector.cpp")));
  const auto flyOn = [&](const std::string& board) {
    const std::string object = compileFor(board, mission, source, board + ".o");
    return fly(mission + " --scenario bloom --link " + object +
               (board == "host" ? "" : " --board " + board));
  };
  const Flight here = flyOn("host");
  ASSERT_EQ(here.outcome.status, 0) << here.outcome.err;
  // Patches of 250 m and 350 m radius, 600 m and 1.5 km east of the start.
  bool near = false, far = false;
  for (const Event& event : here.transitions()) {
    if (event.what.find("transect → sample") != std::string::npos) {
      const double east = here.valueAt("true_x", event.time_s);
      near = near || std::fabs(east - 600) < 300;
      far = far || std::fabs(east - 1500) < 400;
      EXPECT_TRUE(std::fabs(east - 600) < 300 || std::fabs(east - 1500) < 400) << east;
    }
  }
  EXPECT_TRUE(near && far) << here.outcome.out;
  for (const char* board : {"ts7800", "ts5500"}) {
    const Flight there = flyOn(board);
    EXPECT_EQ(there.outcome.status, 0) << there.outcome.err;
    EXPECT_TRUE(there.csv == here.csv) << board << " flies another way";
  }
}

}  // namespace
}  // namespace glider::tests
