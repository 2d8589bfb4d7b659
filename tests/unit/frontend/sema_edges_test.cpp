// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Where the analysis draws a line: the last that is allowed, and the first that is not.

#include "support/diagnostics/ids/meaning.h"
#include "tests/unit/frontend/compile.h"

namespace glider::frontend {
namespace {

using testing_support::FrontendRun;

std::string missionWith(const std::string& head, const std::string& guard,
                        const std::string& transition) {
  return "mission t\n" + head +
         "state s\nbegin\n  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)\n"
         "  sensors depth, temp, missiontime\n  events\n    case missiontime > 2 h exit\n    "
         "case " +
         guard + " " + transition + "\nend\n";
}

TEST(StackDepth, AMillionIsTheLargest) {
  const auto compiled = [](const std::string& depth) {
    FrontendRun run(missionWith("require stack <= " + depth + "\n", "depth > 7 m", "exit"));
    (void)run.compile();
    return run.says(support::diagnostics::stackNotWhole);
  };
  EXPECT_FALSE(compiled("1000000"));
  EXPECT_TRUE(compiled("1000001"));
}

/// Two longitudes side by side are not a position, though each looks like half of one.
TEST(SideBySide, WhatCanBeNoPositionIsADifference) {
  FrontendRun position(missionWith("", "temp > 3910.5 -7349.9", "exit"));
  (void)position.compile();
  EXPECT_TRUE(position.says(support::diagnostics::barePosition)) << position.said();
  FrontendRun difference(missionWith("", "temp > 12210.5 -12310.5", "exit"));
  (void)difference.compile();
  EXPECT_FALSE(difference.says(support::diagnostics::barePosition)) << difference.said();
}

TEST(Earth, EndsAt180DegreesInBothDirections) {
  const auto refused = [](const std::string& position) {
    std::string mission = missionWith("", "depth > 7 m", "exit");
    mission.insert(mission.find("  flightprofile"), "  flightroute nav" + position + "\n");
    FrontendRun run(mission);
    (void)run.compile();
    return run.says(support::diagnostics::notOnEarth);
  };
  EXPECT_FALSE(refused("(3900.0, 17900.0)"));
  EXPECT_TRUE(refused("(3900.0, 18100.0)"));
  EXPECT_FALSE(refused("(3900.0, -17900.0)"));
  EXPECT_TRUE(refused("(3900.0, -18100.0)"));
}

/// Only what comes after an argument can be its other half.
TEST(Arguments, TheLastIsNotTakenForHalfAPosition) {
  const std::string target =
      "state there(limit: time, to: position)\nbegin\n"
      "  flightprofile surfaced\n  sensors missiontime\n  events\n"
      "    case missiontime > limit exit\nend\n";
  FrontendRun run(missionWith("", "depth > 7 m", "goto there(5 min, 7 m)") + target);
  (void)run.compile();
  EXPECT_TRUE(run.says(support::diagnostics::wrongType)) << run.said();
  EXPECT_FALSE(run.says(support::diagnostics::wrongArgumentCount)) << run.said();
}

}  // namespace
}  // namespace glider::frontend
