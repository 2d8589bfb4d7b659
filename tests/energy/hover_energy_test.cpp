// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What holding a depth takes in a swell, against which the pump works: the worst seas that a bound
// is for, and a vehicle that takes the most that its power table allows.

#include "ir/prove/energy/energy_bound.h"
#include "platforms/load/power.h"
#include "tests/energy/watched_energy.h"
#include "tests/slocum.h"
#include "tests/world/fleet.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace glider::tests {
namespace {

/// Holds the depth for an hour by `command`.
std::string holding(const std::string& command) {
  return fmt::format(
      "mission held\nflightprofile held()\nbegin\n  entry do {} end\nend\nstate one\nbegin\n"
      "  flightroute heading(90 deg)\n  flightprofile held()\n  sensors missiontime, depth\n"
      "  events\n    case missiontime > 1 h exit\nend\n",
      command);
}

/// The greatest share of its bound that a flight takes in a swell of 3 m, over all that a vehicle
/// may follow of it.
double nearest(const std::string& command, double period_s) {
  const auto mission = loadMission("held", holding(command));
  EXPECT_TRUE(mission) << command;
  const auto bound = boundOfEnergy(*mission, slocum(), usualBoardPower());
  EXPECT_TRUE(bound) << command;
  simulator::Scenario sea = deepSea();
  sea.ocean.bottom.depth_m = bound->deepest_m + platforms::kBelowDives_m;
  setHunger(sea.vehicle, usualBoardPower(), [] { return 1.0; });
  double most = 0;
  for (const double followed : {0.0, 1.0}) {
    sea.ocean.swell = {.amplitude_m = platforms::kSwell_m,
                       .period_s = period_s,
                       .bearing_rad = 0,
                       .followed_share = followed};
    most = std::max(most, flyForEnergy(*mission, *bound, sea, 1).nearest);
  }
  return most;
}

TEST(HoverEnergy, NoSwellTakesMore) {
  for (const char* command : {"hover(12 m)", "hover(80 m)", "hover(150 m)",
                              "descend(100 m, 26 deg)", "ascend(10 m, 26 deg)"}) {
    for (const double period_s : {12.0, platforms::kSwell_s}) {
      const double share = nearest(command, period_s);
      EXPECT_LE(share, 1) << command << " in a swell of " << period_s << " s";
      EXPECT_GT(share, 0.2) << command << " in a swell of " << period_s << " s";
    }
  }
}

TEST(HoverEnergy, ASwellFadesWithTheDepthAsItsPressure) {
  platforms::EnergyModel model;
  model.hover_pump_cc_s = 2.5;
  model.hover_swell_cc_s = 10;
  EXPECT_DOUBLE_EQ(platforms::hoverPump(model, 0), 12.5);
  EXPECT_DOUBLE_EQ(platforms::hoverPump(model, -3), 12.5) << "above the surface";
  // From w^2 = g k tanh(k h), solved apart from this: 0.012454 rad/m over 90 m, 0.010067 over 400
  // m.
  EXPECT_NEAR(platforms::hoverPump(model, 80), 2.5 + 10 * 0.593955, 1e-4);
  EXPECT_NEAR(platforms::hoverPump(model, 390), 2.5 + 10 * 0.035830, 1e-4);
}

}  // namespace
}  // namespace glider::tests
