// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/own_mission.h"
#include "tests/slocum.h"
#include "tests/unit/simulator/fake_sbc.h"
#include "tests/unit/simulator/flights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <regex>

namespace glider::simulator {
namespace {

SimulationSetup withSbc(const std::string& scenario, FakePilot::Plan plan,
                        double silent_from_s = 1e9) {
  SimulationSetup setup = shippedSetup(scenario);
  setup.sbc = std::make_unique<FakeSbc>(plan, silent_from_s);
  setup.mission_name = "fake";
  setup.state_names = {"down", "up"};
  setup.explain = [](uint32_t, uint32_t state, uint32_t) {
    return state == 0 ? GuardText{"depth >= 20 m", {3}}
                      : GuardText{"depth <= 5 m", {3, GLIDER_M_LAT}};
  };
  return setup;
}

TEST(SbcFlight, TakesControlSteersAndReleases) {
  const support::Trace trace = fly(withSbc("default", {.release_s = 900}));
  const std::string events = eventText(trace);
  const auto* takes = findEvent(trace, EventId::SbcTakesControl);
  ASSERT_NE(takes, nullptr) << events;
  EXPECT_LE(takes->time_s, 12);
  const auto* turn = findEvent(trace, "down → up (goto)");
  ASSERT_NE(turn, nullptr) << events;
  EXPECT_EQ(turn->id, EventId::Transition);
  EXPECT_NE(turn->why.find("depth >= 20 m (depth 20."), std::string::npos) << turn->why;
  EXPECT_NEAR(valueAt(trace, "m_depth", turn->time_s), 20.4, 0.5);
  const auto* rise = findEvent(trace, "up → down (goto)");
  ASSERT_NE(rise, nullptr) << events;
  EXPECT_TRUE(std::regex_search(rise->why, std::regex(R"( m, lat 39 10\.\d\d\d N\)$)")))
      << rise->why;
  EXPECT_NE(findEvent(trace, "down → end (exit)"), nullptr) << events;
  const auto* back = findEvent(trace, EventId::SbcReleasesControl);
  ASSERT_NE(back, nullptr) << events;
  EXPECT_NEAR(back->time_s, 906, 12);
  const double t = 600;
  EXPECT_EQ(valueAt(trace, "hook_active", t), 1);
  EXPECT_EQ(valueAt(trace, "commanded_top", t), 5);
  EXPECT_EQ(valueAt(trace, "commanded_bottom", t), 20);
  EXPECT_EQ(valueAt(trace, "layer", t), 3);
  EXPECT_NEAR(valueAt(trace, "missiontime", t), t - 4, 8);
  EXPECT_TRUE(std::isnan(valueAt(trace, "state", back->time_s + 8)));
  EXPECT_EQ(valueAt(trace, "hook_active", back->time_s + 8), 0);
  EXPECT_NE(findEvent(trace, EventId::NothingLeftToFly), nullptr) << events;
  EXPECT_EQ(trace.at(trace.rowCount() - 1, trace.column("true_depth")), 0);
}

TEST(SbcFlight, KeepsTheCommandedDepths) {
  const support::Trace trace =
      fly(withSbc("default", {.top_m = 8, .bottom_m = 18, .release_s = 1500}));
  double deepest = 0, shallowest = 100;
  for (size_t row = 0; row < trace.rowCount(); ++row) {
    const double time = trace.at(row, 0), depth = trace.at(row, trace.column("true_depth"));
    deepest = std::max(deepest, depth);
    if (time > 250 && time < 1400) {
      shallowest = std::min(shallowest, depth);
    }
  }
  EXPECT_GT(deepest, 18);
  EXPECT_LT(deepest, 21.5);
  EXPECT_LT(shallowest, 8);
  EXPECT_GT(shallowest, 4);
}

/// The time from which on the vehicle only climbs; the newest row that sank, plus a cycle.
double climbingFrom(const support::Trace& trace, double after_s) {
  double from = after_s;
  for (size_t row = 1; row < trace.rowCount(); ++row) {
    const double sunk =
        trace.at(row, trace.column("true_depth")) - trace.at(row - 1, trace.column("true_depth"));
    if (trace.at(row, 0) > after_s && sunk > 0) {
      from = trace.at(row, 0) + 4;
    }
  }
  return from;
}

TEST(SbcFlight, ClimbsSoonAfterTheSbcIsKilled) {
  SimulationSetup setup = withSbc("default", {.top_m = 5, .bottom_m = 50});
  setup.kill_sbc_at_s = 101;
  const support::Trace trace = fly(std::move(setup));
  const std::string events = eventText(trace);
  const auto* gone = findEvent(trace, EventId::SbcGone);
  ASSERT_NE(gone, nullptr) << events;
  EXPECT_EQ(gone->time_s, 101);
  EXPECT_EQ(gone->why, "killed");
  const auto* silent = findEvent(trace, EventId::SbcSilent);
  ASSERT_NE(silent, nullptr) << events;
  EXPECT_LE(silent->time_s, 101 + 24 + 8) << "silence_secs and two cycles";
  const double climbing = climbingFrom(trace, 101);
  std::printf("killed at 101 s, silent at %.0f s, climbing from %.0f s\n", silent->time_s,
              climbing);
  EXPECT_LE(climbing, 101 + 60);
  EXPECT_NE(findEvent(trace, EventId::NothingLeftToFly), nullptr) << events;
}

TEST(SbcFlight, ClimbsSoonAfterTheSbcFallsSilent) {
  SimulationSetup setup = withSbc("default", {.top_m = 5, .bottom_m = 50}, 101);
  setup.duration_s = 1000;
  const support::Trace trace = fly(std::move(setup));
  ASSERT_NE(findEvent(trace, EventId::SbcSilent), nullptr) << eventText(trace);
  EXPECT_LE(climbingFrom(trace, 101), 101 + 60);
  EXPECT_EQ(findEvent(trace, EventId::SbcGone), nullptr) << "it is still there, only mute";
}

TEST(SbcFlight, RefusedInstructionsAreReportedAndChangeNothing) {
  const support::Trace trace = fly([] {
    SimulationSetup setup = withSbc("default", {.top_m = 5, .bottom_m = 75});
    setup.duration_s = 200;
    return setup;
  }());
  const auto* refused = findEvent(trace, "refused: max_depth 60 m refuses a dive to 75 m");
  ASSERT_NE(refused, nullptr) << eventText(trace);
  EXPECT_EQ(findEvent(trace, EventId::SbcTakesControl), nullptr);
  EXPECT_EQ(trace.at(trace.rowCount() - 1, trace.column("true_depth")), 0);
}

TEST(SbcFlight, ARefusalNamesTheLimitInEffectWhereTheHullIsNarrower) {
  SimulationSetup setup = withSbc("default", {.top_m = 5, .bottom_m = 3000});
  setup.duration_s = 200;
  for (slocum::BehaviourBlock& block : missionFileOf(setup.scenario).behaviours) {
    for (slocum::Setting& argument : block.arguments) {
      argument.value = argument.name == "max_depth" ? 2000 : argument.value;
    }
  }
  const double hull = setup.platform.envelope.greatest_depth_m;
  const std::string text =
      "refused: max_depth " + std::to_string(std::lround(hull)) + " m refuses a dive to 3000 m";
  const support::Trace trace = fly(std::move(setup));
  EXPECT_NE(findEvent(trace, text), nullptr) << eventText(trace);
}

TEST(SbcFlight, Figure5IsLayeredBeforeAndAfter) {
  const support::Trace trace =
      fly(withSbc("figure5", {.top_m = 8, .bottom_m = 20, .release_s = 1200}));
  const std::string events = eventText(trace);
  const auto* takes = findEvent(trace, EventId::SbcTakesControl);
  ASSERT_NE(takes, nullptr) << events;
  EXPECT_GE(takes->time_s, 260);
  EXPECT_LE(takes->time_s, 280);
  const auto* back = findEvent(trace, EventId::SbcReleasesControl);
  ASSERT_NE(back, nullptr) << events;
  EXPECT_GE(back->time_s, 1460);
  EXPECT_LE(back->time_s, 1476);
  int half_cycles_meanwhile = 0;
  for (const auto& event : trace.events) {
    half_cycles_meanwhile += textOf(event).starts_with("yo_") && event.time_s > takes->time_s &&
                             event.time_s < back->time_s;
  }
  EXPECT_EQ(half_cycles_meanwhile, 0) << "an overridden yo counts nothing that it has not reached\n"
                                      << events;
  EXPECT_NE(findEvent(trace, "half cycle 6"), nullptr) << events;
  EXPECT_NE(findEvent(trace, EventId::MissionEndsNormally), nullptr) << events;
}

TEST(SbcFlight, ASurfacingForWantOfContactMasksHookbehAndThenItsMissionGoesOn) {
  SimulationSetup setup = withSbc("default", {.top_m = 8, .bottom_m = 30});
  setup.duration_s = 2400;
  for (slocum::BehaviourBlock& block : missionFileOf(setup.scenario).behaviours) {
    for (slocum::Setting& argument : block.arguments) {
      argument.value = argument.name == "when_secs" ? 900 : argument.value;
    }
  }
  const support::Trace trace = fly(std::move(setup));
  const std::string events = eventText(trace);
  const auto* up = findStart(trace, "surface");
  ASSERT_NE(up, nullptr) << events;
  const auto* masked = findEvent(trace, "another behaviour masks pitch and pump");
  ASSERT_NE(masked, nullptr) << events;
  EXPECT_EQ(masked->time_s, up->time_s + 4) << "it reports the previous cycle";
  const auto* free = findEvent(trace, EventId::CommandsFly);
  ASSERT_NE(free, nullptr) << events;
  bool floats = false, dives = false;
  for (size_t row = 0; row < trace.rowCount(); ++row) {
    const double time = trace.at(row, 0), depth = trace.at(row, trace.column("true_depth"));
    floats = floats || (time > masked->time_s && time < free->time_s && depth < 0.5);
    dives = dives || (time > free->time_s && depth > 25);
  }
  EXPECT_TRUE(floats && dives) << events;
  EXPECT_EQ(findEvent(trace, EventId::SbcSilent), nullptr) << events;
  EXPECT_EQ(findEvent(trace, EventId::Aborts), nullptr) << events;
}

TEST(SbcFlight, WithoutHookbehTheSbcChangesNotAByte) {
  const std::string alone = traceToCsv(fly(shippedSetup("layered")));
  EXPECT_EQ(alone, traceToCsv(fly(withSbc("layered", {}))));
}

TEST(SbcFlight, IsDeterministic) {
  const std::string first = traceToCsv(fly(withSbc("figure5", {.release_s = 600})));
  EXPECT_EQ(first, traceToCsv(fly(withSbc("figure5", {.release_s = 600}))));
}

}  // namespace
}  // namespace glider::simulator
