// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Missions that command something else on each tick: a vehicle that obeyed only what is left alone
// until all its words have crossed the line would go on with the dive that such commands end.

#include "tests/world/fleet.h"
#include "tests/world/watched_flight.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace glider::tests {
namespace {

/// Dives steeply and deep; from `turns_at` on it commands `one` and `other` in turn, which differ
/// in every word.
std::string restless(const std::string& one, const std::string& other) {
  const auto state = [](const std::string& name, const std::string& profile,
                        const std::string& heading, const std::string& next) {
    return fmt::format(
        "state {}\nbegin\n  flightprofile {}\n  flightroute heading({})\n"
        "  sensors missiontime, depth, statetime\n  events\n"
        "    case depth < 5 m goto diving\n    case statetime > 0 s goto {}\nend\n\n",
        name, profile, heading, next);
  };
  return "mission restless\n\n"
         "flightprofile up(top: length, climb: angle)\nbegin\n"
         "  entry do ascend(top, climb) end\nend\n\n"
         "flightprofile down(bottom: length, dive: angle)\nbegin\n"
         "  entry do descend(bottom, dive) end\nend\n\n"
         "always\n  case missiontime >= 80 min exit\n\n"
         "state diving\nbegin\n  flightprofile down(55 m, 33 deg)\n"
         "  sensors missiontime, depth, statetime\n  events\n"
         "    case depth > 15 m goto one\n    case statetime > 20 min goto one\nend\n\n" +
         state("one", one, "10 deg", "other") + state("other", other, "200 deg", "one");
}

/// In many waters and with many vehicles, over whole lines.
TEST(Restless, ADiveThatEverOtherClimbsEndEndsWithinTheTimeOfOne) {
  const auto mission = loadMission("restless", restless("up(4 m, 26 deg)", "up(3 m, 20 deg)"));
  ASSERT_TRUE(mission);
  // As if 12 s were all: what the vehicles use of the 24 s is a few metres.
  platforms::Platform strict = slocum();
  strict.world.line_lag_s = 2;
  const auto worlds = scenarios();
  int whole = 0;
  double most = 0;
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    const auto& scenario = worlds[seed % worlds.size()];
    const Conditions conditions = drawConditions(mission->flown->mission, scenario, seed);
    if (!conditions.whole) {
      continue;
    }
    const auto seen = flyWatched(*mission, conditions, strict);
    ASSERT_TRUE(seen);
    most = std::max(most, seen->uses.at(static_cast<size_t>(Rule::Deepest)).most);
    whole += seen->in_control_s > 0;
    EXPECT_FALSE(seen->broken) << scenario.name << ", seed " << seed << ": "
                               << nameOf(seen->broken->rule) << " at " << seen->broken->time_s
                               << " s: " << seen->broken->what;
  }
  EXPECT_GT(whole, 10);
  // Of the overshoot. Where each command replaces the one before at once it is 0.89.
  EXPECT_LT(most, 0.4);
}

}  // namespace
}  // namespace glider::tests
