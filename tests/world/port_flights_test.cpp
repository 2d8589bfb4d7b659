// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Missions on a vehicle without the hooks: its own layered control flies the mission file that was
// written with the program, and nothing on it watches the SBC.

#include "flights/in_process_sbc.h"
#include "ir/prove/falsification/rng.h"
#include "simulator/simulator.h"
#include "tests/slocum.h"
#include "tests/world/environment_check.h"
#include "tests/world/fleet.h"
#include "tests/world/port_flight.h"
#include "vehicles/slocum/rules/port/port_file.h"
#include "vehicles/slocum/rules/port/port_whole.h"
#include "vehicles/slocum/rules/port_commands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace glider::tests {
namespace {

constexpr double kSurfaceAfter = 3600;  // s

/// The port of a flight for a release.
slocum::PortChoice choiceFor(slocum::Release release) {
  return {.release = release, .greatest_depth_m = 60, .surface_after_s = kSurfaceAfter};
}

/// An abort turns the vehicle round within this much below the depth at which it comes, m: abend
/// looks every 15 s, and the vehicle overshoots.
constexpr double kBelowAbort = 12;

/// Looks at the true depth: never too deep, and not under water for longer than the bound after
/// the SBC's death. The check of campaigns (vehicles/slocum/oracles/port_judge.h) does much the
/// same, and is not used here on purpose: it is part of what is tested. Its bounds are read from
/// the mission file by the rules of `check`, those here come from the plan; and it counts from the
/// last surfacing, which hides how long the timer took after the SBC's death.
class PortWatch final : public simulator::FlightObserver {
 public:
  PortWatch(double deepest_m, double killed_s, double bound_s)
      : deepest_m_(deepest_m), killed_s_(killed_s), bound_s_(bound_s) {}

  void said(std::span<const uint8_t>, double) override { ++answers_; }
  bool cycle(const simulator::CycleView& view) override {
    dived_ = dived_ || view.true_depth_m > 3;
    most_m_ = std::max(most_m_, view.true_depth_m);
    up_s_ = view.true_depth_m < 1 ? view.time_s : up_s_;
    if (view.time_s > killed_s_) {
      longest_s_ = std::max(longest_s_, view.time_s - std::max(up_s_, killed_s_));
    }
    return true;
  }
  [[nodiscard]] bool dived() const { return dived_; }
  [[nodiscard]] bool tooDeep() const { return most_m_ > deepest_m_; }
  [[nodiscard]] double deepest() const { return most_m_; }
  [[nodiscard]] bool late() const { return longest_s_ > bound_s_; }
  [[nodiscard]] double longest() const { return longest_s_; }
  [[nodiscard]] int answers() const { return answers_; }

 private:
  double deepest_m_, killed_s_, bound_s_;
  bool dived_ = false;
  int answers_ = 0;
  double most_m_ = 0, up_s_ = 0, longest_s_ = 0;
};

/// The time to come up that the page of the port states.
double boundOf(const slocum::PortPlan& plan) {
  return slocum::rules::portWhole(plan, slocum()).endings.front().seconds();
}

struct Drawn {
  double killed_s = simulator::kForever;
  simulator::Faults faults = {};
  uint64_t seed = 1;
};

PortWatch fly(const FlyingMission& mission, const PortFlight& flight, const Drawn& drawn,
              double duration_s) {
  // A damaged sentence in 256 passes its sum: then the vehicle's own abend is the bound.
  const bool damaged = !drawn.faults.lines.empty();
  const double deepest_m = damaged ? flight.plan.overdepth_m + kBelowAbort
                                   : flight.plan.choice.greatest_depth_m + flight.plan.overshoot_m;
  PortWatch watch(deepest_m, drawn.killed_s, boundOf(flight.plan));
  simulator::SimulationSetup setup = setupOf(mission, flight, drawn.seed);
  setup.scenario.faults = drawn.faults;
  setup.duration_s = duration_s;
  setup.observer = &watch;
  if (drawn.killed_s < duration_s) {
    setup.kill_sbc_at_s = drawn.killed_s;
  }
  EXPECT_TRUE(simulator::simulate(std::move(setup)).has_value());
  return watch;
}

/// The missions that the port can fly.
std::vector<FlyingMission> portMissions() {
  auto all = missions(6, 1);
  std::erase_if(all, [](const FlyingMission& mission) {
    support::DiagnosticEngine diagnostics;
    slocum::rules::checkPortCommands(mission.flown->mission, diagnostics);
    return diagnostics.errorCount() != 0;
  });
  return all;
}

TEST(PortFlights, AKilledSbcLeavesTheVehicleToItsOwnTimer) {
  constexpr uint64_t kFew = 40;
  const uint64_t count = wanted("GLIDER_PORT_FLIGHTS", kFew);
  const auto all = portMissions();
  const auto worlds = scenarios();
  ASSERT_GT(all.size(), 3U);
  uint64_t counted = 0;
  double longest = 0;
  for (uint64_t i = 0; i < count; ++i) {
    const FlyingMission& mission = all[i % all.size()];
    const auto release = i % 2 == 0 ? slocum::Release::Common : slocum::Release::MissionModes;
    const PortFlight flight = planned(mission, worlds[i % worlds.size()], choiceFor(release));
    ir::prove::Rng dice(i + 1);
    const PortWatch watch =
        fly(mission, flight, {.killed_s = dice.within(60, 5400), .faults = {}, .seed = i + 1},
            5400 + 3 * boundOf(flight.plan));
    counted += watch.dived() ? 1U : 0U;
    longest = std::max(longest, watch.longest());
    EXPECT_FALSE(watch.tooDeep()) << mission.name << " seed " << i + 1 << ": " << watch.deepest();
    EXPECT_FALSE(watch.late()) << mission.name << " seed " << i + 1 << ": " << watch.longest();
  }
  EXPECT_GT(counted, count / 2);
  EXPECT_GT(longest, kSurfaceAfter) << "the timer was what brought it up";
}

/// Line noise, cuts, power cuts of the SBC, restarts of the science computer.
simulator::Faults drawFaults(ir::prove::Rng& dice, double duration_s, bool noisy) {
  simulator::Faults faults;
  const auto span = [&](double longest_s) {
    const double from_s = dice.within(0, duration_s);
    return simulator::Span{from_s, from_s + dice.within(1, longest_s)};
  };
  for (const auto way : {simulator::LineWay::ToSbc, simulator::LineWay::FromSbc}) {
    if (!noisy) {
      break;
    }
    simulator::LineFault fault;
    faults.lines.push_back({.way = way,
                            .when = span(duration_s),
                            .loss = dice.within(0, 0.01),
                            .flips = dice.within(0, 0.01),
                            .doubled = dice.within(0, 0.05)});
  }
  faults.power.push_back(span(600));
  faults.science.push_back(span(120));
  return faults;
}

TEST(PortFlights, UnderFaultsOfTheLineItIsNeverTooDeep) {
  constexpr uint64_t kFew = 40;
  const uint64_t count = wanted("GLIDER_PORT_FLIGHTS", kFew);
  const auto all = portMissions();
  const auto worlds = scenarios();
  constexpr double kDuration = 2 * 3600;
  uint64_t dived = 0;
  for (uint64_t i = 0; i < count; ++i) {
    const FlyingMission& mission = all[i % all.size()];
    const auto release = i % 2 == 0 ? slocum::Release::Common : slocum::Release::MissionModes;
    const PortFlight flight = planned(mission, worlds[i % worlds.size()], choiceFor(release));
    ir::prove::Rng dice(1000 + i);
    const PortWatch watch =
        fly(mission, flight, {.faults = drawFaults(dice, kDuration, i % 4 < 2), .seed = i + 1},
            kDuration);
    dived += watch.dived() ? 1U : 0U;
    EXPECT_FALSE(watch.tooDeep()) << mission.name << " seed " << i + 1 << ": " << watch.deepest();
  }
  EXPECT_GT(dived, count / 2);
}

/// Compares a flight with the world in which proofs by the port hold.
class PortWorld final : public simulator::FlightObserver {
 public:
  explicit PortWorld(const platforms::Platform& platform) : world_(platform) {}

  void said(std::span<const uint8_t>, double) override {}
  bool cycle(const simulator::CycleView& view) override {
    now_s_ = view.time_s;
    depth_m_ = view.true_depth_m;
    if (begun_ && !over_) {
      world_.moved(now_s_, depth_m_);
    }
    return !world_.broken() && !over_;
  }
  void polled(const GliderContext& context) {
    if (context.mission_time == mission_time_ || over_) {
      return;
    }
    if (!begun_) {
      begun_ = true;
      world_.begin(now_s_, depth_m_, true);
    }
    mission_time_ = context.mission_time;
    ++ticks_;
    command(static_cast<GliderVertical>(context.vertical), context.depth);
    over_ = context.finished != 0;
    look(context);
  }

  EnvironmentCheck& world() { return world_; }
  [[nodiscard]] uint64_t ticks() const { return ticks_; }

 private:
  void command(GliderVertical vertical, double target_m) {
    if (vertical == kGliderDescend || vertical == kGliderHover) {
      world_.commandDown(target_m, depth_m_);
    } else if (vertical == kGliderAscend || vertical == kGliderSurface) {
      world_.commandUp(vertical == kGliderSurface ? 0 : target_m, depth_m_, now_s_);
    }
  }
  /// The reading of a tick counts as that of its time.
  void look(const GliderContext& context) {
    for (uint32_t i = 0; i < context.mission->sensor_count; ++i) {
      const double reading = context.readings[i].value;
      if (context.mission->sensors[i].id == GLIDER_M_DEPTH && !std::isnan(reading)) {
        world_.sees(now_s_, reading, depth_m_);
      }
    }
  }

  EnvironmentCheck world_;
  double now_s_ = 0, depth_m_ = 0;
  double mission_time_ = -1;
  uint64_t ticks_ = 0;
  bool begun_ = false, over_ = false;
};

TEST(PortFlights, StayWithinTheWorldThatProofsByThePortAssume) {
  constexpr uint64_t kFew = 30;
  const uint64_t count = wanted("GLIDER_PORT_FLIGHTS", kFew);
  const auto all = portMissions();
  const auto worlds = scenarios();
  platforms::Platform platform = slocum();
  slocum::rules::widenForPort(platform, 0);
  uint64_t ticks = 0;
  std::array<Use, kRules> most;
  for (uint64_t i = 0; i < count; ++i) {
    const FlyingMission& mission = all[i % all.size()];
    const auto release = i % 2 == 0 ? slocum::Release::Common : slocum::Release::MissionModes;
    const PortFlight flight = planned(mission, worlds[i % worlds.size()], choiceFor(release));
    PortWorld watch(platform);
    simulator::SimulationSetup setup = setupOf(mission, flight, i + 1);
    setup.scenario.faults = {};
    setup.duration_s = 3 * 3600;
    setup.observer = &watch;
    auto sbc = std::make_unique<flights::InProcessSbc>(
        mission.loaded, *flights::chooseParameters(mission.flown->mission, {}),
        std::make_shared<flights::Card>(), false, portEnd(flight));
    sbc->watch([&watch](const GliderContext& context, double) { watch.polled(context); });
    setup.sbc = std::move(sbc);
    ASSERT_TRUE(simulator::simulate(std::move(setup)).has_value());
    const auto& broken = watch.world().broken();
    EXPECT_FALSE(broken) << mission.name << " seed " << i + 1 << " at " << broken->time_s << ": "
                         << nameOf(broken->rule) << ": " << broken->what;
    ticks += watch.ticks();
    for (const Rule rule : kAllRules) {
      Use& use = most.at(static_cast<size_t>(rule));
      use.most = std::max(use.most, watch.world().use(rule).most);
      use.looks += watch.world().use(rule).looks;
    }
  }
  EXPECT_GT(ticks, count * 100);
  for (const Rule rule : {Rule::Deepest, Rule::Climb, Rule::Reading, Rule::Rate}) {
    EXPECT_GT(most.at(static_cast<size_t>(rule)).looks, count) << nameOf(rule);
  }
}

}  // namespace
}  // namespace glider::tests
