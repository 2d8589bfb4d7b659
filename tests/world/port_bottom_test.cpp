// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Missions by the port over a bottom that is shallower than their dives: the vehicle's own
// d_target_altitude is all that keeps it off.

#include "simulator/simulator.h"
#include "tests/world/fleet.h"
#include "tests/world/port_flight.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>

namespace glider::tests {
namespace {

constexpr double kLeastAltitude = 5;  // m, d_target_altitude
/// The vehicle goes on until it has turned, and the altimeter is looked at in the next cycle, m.
constexpr double kTurns = 4.5;

/// How near the bottom a vehicle came, and how deep it dived.
class ClearanceWatch final : public simulator::FlightObserver {
 public:
  void said(std::span<const uint8_t>, double) override {}
  bool cycle(const simulator::CycleView& view) override {
    least_m_ = std::min(least_m_, view.clearance_m);
    deepest_m_ = std::max(deepest_m_, view.true_depth_m);
    if (view.time_s > settled_s) {
      shallowest_m_ = std::min(shallowest_m_, view.true_depth_m);
    }
    turned_ += dives_ && view.true_depth_m < turn_m_ - 3 ? 1 : 0;
    dives_ = dives_ ? !(view.true_depth_m < turn_m_ - 3) : view.true_depth_m > turn_m_ + 3;
    turn_m_ = dives_ ? std::max(turn_m_, view.true_depth_m) : std::min(turn_m_, view.true_depth_m);
    aborted_ = aborted_ || view.aborted;
    return true;
  }
  double settled_s = 3600;  ///< from then on shallowest() counts, s
  [[nodiscard]] double least() const { return least_m_; }
  [[nodiscard]] double deepest() const { return deepest_m_; }
  [[nodiscard]] double shallowest() const { return shallowest_m_; }
  [[nodiscard]] int turned() const { return turned_; }
  [[nodiscard]] bool aborted() const { return aborted_; }

 private:
  double least_m_ = 1e9, deepest_m_ = 0, shallowest_m_ = 1e9, turn_m_ = 0;
  int turned_ = 0;
  bool dives_ = false, aborted_ = false;
};

struct Bottom {
  double depth_m = 40;
  double rises = 0;  ///< m per m towards the east, where the missions go
};

/// Dives to `profile` for three hours, eastward.
FlyingMission mission(const std::string& profile) {
  return *loadMission("bottom", fmt::format("mission bottom\n\n"
                                            "flightprofile stays(bottom: length)\nbegin\n"
                                            "  entry do descend(bottom, 26 deg) end\n"
                                            "end\n\n"
                                            "flightprofile rises(top: length)\nbegin\n"
                                            "  entry do ascend(top, 26 deg) end\n"
                                            "end\n\n"
                                            "state fly\nbegin\n"
                                            "  flightroute heading(90 deg)\n"
                                            "  flightprofile {}\n"
                                            "  sensors missiontime, depth\n"
                                            "  events\n    case missiontime > 3 h exit\nend\n",
                                            profile));
}

ClearanceWatch fly(const std::string& profile, const Bottom& bottom, uint64_t seed = 1,
                   std::optional<double> killed_s = {},
                   slocum::Release release = slocum::Release::Common) {
  const FlyingMission flown = mission(profile);
  simulator::Scenario scenario;
  for (simulator::Scenario& one : scenarios()) {
    if (one.name == "default") {
      scenario = std::move(one);
    }
  }
  scenario.ocean.bottom = {
      .depth_m = bottom.depth_m, .slope = bottom.rises, .slope_bearing_rad = -1.5707963};
  const PortFlight flight = planned(flown, scenario,
                                    {.release = release,
                                     .greatest_depth_m = 100,
                                     .surface_after_s = killed_s ? 3600.0 : 4 * 3600.0});
  ClearanceWatch watch;
  simulator::SimulationSetup setup = setupOf(flown, flight, seed);
  setup.duration_s = 3 * 3600;
  setup.observer = &watch;
  setup.kill_sbc_at_s = killed_s;
  EXPECT_TRUE(simulator::simulate(std::move(setup)).has_value());
  EXPECT_FALSE(watch.aborted());
  return watch;
}

TEST(PortBottom, ADiveBeyondItTurnsAtItsAltitudeAgainAndAgain) {
  for (const auto release : {slocum::Release::Common, slocum::Release::MissionModes}) {
    const ClearanceWatch yo = fly("yo(4 m, 100 m, 26 deg, 26 deg)", {}, 1, {}, release);
    EXPECT_GT(yo.least(), kLeastAltitude - kTurns);
    EXPECT_GT(yo.deepest(), 34);
    EXPECT_GT(yo.turned(), 10) << "it goes on";
  }
}

TEST(PortBottom, SoDoesADiveThatIsToStayAtItsDepth) {
  const ClearanceWatch deep = fly("stays(100 m)", {});
  EXPECT_GT(deep.least(), kLeastAltitude - kTurns);
  EXPECT_GT(deep.turned(), 10);
}

TEST(PortBottom, NorDoesAnSbcThatIsDeadChangeThat) {
  for (const double killed_s : {120.0, 200.0, 400.0, 1500.0}) {
    const ClearanceWatch dead = fly("yo(4 m, 100 m, 26 deg, 26 deg)", {}, 1, killed_s);
    EXPECT_GT(dead.least(), kLeastAltitude - kTurns) << killed_s;
    EXPECT_GT(dead.turned(), 5) << killed_s;
  }
}

TEST(PortBottom, InDeepWaterADepthIsStillHeld) {
  const ClearanceWatch held = fly("stays(40 m)", {.depth_m = 80});
  EXPECT_GT(held.shallowest(), 40 - 10 - 5) << "by a yo of 10 m";
  EXPECT_LT(held.deepest(), 45);
  const ClearanceWatch from_above = fly("rises(40 m)", {.depth_m = 80});
  EXPECT_GT(from_above.shallowest(), 40 - 5);
  EXPECT_LT(from_above.deepest(), 50 + 5);
}

TEST(PortBottom, AHeldDepthIsLeftWhereTheBottomRises) {
  // The three hours end in water of about 30 m.
  for (uint64_t seed = 1; seed <= 3; ++seed) {
    const ClearanceWatch held = fly("stays(60 m)", {.depth_m = 100, .rises = 0.02}, seed);
    EXPECT_GT(held.least(), kLeastAltitude - kTurns) << seed;
    EXPECT_GT(held.deepest(), 60);
    const ClearanceWatch steep = fly("stays(60 m)", {.depth_m = 175, .rises = 0.045}, seed);
    EXPECT_GT(steep.least(), kLeastAltitude - kTurns) << seed;
  }
}

TEST(PortBottom, NeitherDoesADescentToTheDepthOfAClimbReachIt) {
  const ClearanceWatch climb = fly("rises(45 m)", {});
  EXPECT_GT(climb.least(), kLeastAltitude - kTurns) << "from the surface it is a dive";
}

}  // namespace
}  // namespace glider::tests
