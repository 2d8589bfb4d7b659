// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What `check --skeleton` proves of the vehicle's mission file, in flight: the SBC's control ends
// at a random moment in each of the ways, and the vehicle is at the surface in the stated time.
// Twins of the files with a fault each, which are refused, stay under water.

#include "flights/in_process_sbc.h"
#include "ir/prove/falsification/rng.h"
#include "simulator/simulator.h"
#include "simulator/slocum/flight/skeleton.h"
#include "simulator/slocum/own_mission.h"
#include "tests/support/command.h"
#include "tests/world/fleet.h"
#include "vehicles/slocum/rules/whole.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

namespace glider::tests {
namespace {

using flights::InProcessSbc;

enum class Way : uint8_t { Exit, Killed, Cut, Device, Overdepth, Overtime, Masked };

struct WayRow {
  Way way;
  const char* after;  ///< how the ending begins in Whole
};
constexpr auto kWays = std::to_array<WayRow>({
    {Way::Exit, "`exit`"},
    {Way::Killed, "silence of the SBC"},
    {Way::Cut, "instructions that get no answer"},
    {Way::Device, "an abort (overtime"},  // any abort that is not of the depth
    {Way::Overdepth, "an abort (overdepth"},
    {Way::Overtime, "an abort (overtime"},
    {Way::Masked, "masking by behaviour 2"},
});

constexpr const char* kFiles[] = {"skeleton", "first_deployment", "figure5"};

std::string shipped(const std::string& name) {
  return slurp(fmt::format("{}/scenarios/{}.mi", GLIDER_SOURCE_DIR, name));
}

slocum::MissionFile vehicleOf(const std::string& text) {
  const TemporaryFolder folder;
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  auto mission = simulator::loadMissionFile(folder.write("a.mi", text), sources, diagnostics);
  EXPECT_TRUE(mission) << text;
  return mission ? *mission : slocum::MissionFile{};
}

/// `text` with a b_arg of its behaviour `number`, by place, set to `value`.
slocum::MissionFile with(slocum::MissionFile mission, size_t number, const std::string& argument,
                         double value) {
  for (slocum::Setting& setting : mission.behaviours.at(number - 1).arguments) {
    if (setting.name == argument) {
      setting.value = value;
      return mission;
    }
  }
  ADD_FAILURE() << argument;
  return mission;
}

FlyingMission yoUntil(double exit_s) {
  setenv("GLIDERCC_SHARE", GLIDER_BINARY_DIR "/share/glidercc", 1);
  return *loadMission(
      "yo.mission",
      fmt::format("mission yo\nstate only\nbegin\n  flightprofile yo(5 m, 25 m, 26 deg, 26 deg)\n"
                  "  sensors missiontime, depth\n  events\n    case missiontime >= {:.0f} s exit\n"
                  "end\n",
                  exit_s));
}

/// Sees when control is lost, and when the vehicle is at the surface after that.
class LossWatch final : public simulator::FlightObserver {
 public:
  LossWatch(Way way, double at_s, double stated_s) : way_(way), at_s_(at_s), stated_s_(stated_s) {}

  void said(std::span<const uint8_t>, double) override {}
  bool cycle(const simulator::CycleView& view) override {
    const bool active = view.hook == hooks::HookState::Active;
    if (lost_s_ < 0 && controlled_ && isLost(view)) {
      lost_s_ = way_ == Way::Killed || way_ == Way::Cut ? at_s_ : view.time_s;
    }
    controlled_ = controlled_ || active;
    if (lost_s_ < 0) {
      return true;
    }
    deepest_m_ = std::max(deepest_m_, view.true_depth_m);
    if (view.true_depth_m <= slocum().world.surface_depth_m) {
      surfaced_s_ = view.time_s;
      return false;
    }
    return view.time_s <= lost_s_ + stated_s_ + 300;
  }
  void finished() { finished_ = true; }

  [[nodiscard]] bool lost() const { return lost_s_ >= 0; }
  [[nodiscard]] bool surfaced() const { return surfaced_s_ >= 0; }
  /// From the loss to the surface.
  [[nodiscard]] double took() const { return surfaced_s_ - lost_s_; }
  [[nodiscard]] double deepest() const { return deepest_m_; }

 private:
  [[nodiscard]] bool isLost(const simulator::CycleView& view) const {
    switch (way_) {
      case Way::Exit:
        return finished_;
      case Way::Killed:
      case Way::Cut:
        return view.time_s >= at_s_;
      case Way::Device:
      case Way::Overdepth:
      case Way::Overtime:
        return view.aborted;
      case Way::Masked:
        return view.hook == hooks::HookState::Active && view.overridden();
    }
    return false;
  }

  Way way_;
  double at_s_, stated_s_;
  bool controlled_ = false, finished_ = false;
  double lost_s_ = -1, surfaced_s_ = -1, deepest_m_ = 0;
};

struct Flight {
  const FlyingMission& mission;
  const slocum::MissionFile& vehicle;
  Way way;
  double at_s, stated_s;
  uint64_t seed;
};

LossWatch fly(const Flight& flight) {
  static const std::vector<simulator::Scenario> kWorlds = scenarios();
  const auto world = std::ranges::find(kWorlds, "default", &simulator::Scenario::name);
  LossWatch watch(flight.way, flight.at_s, flight.stated_s);
  simulator::SimulationSetup setup;
  setup.platform = slocum();
  setup.scenario = *world;
  simulator::missionFileOf(setup.scenario) = flight.vehicle;
  setup.seed = flight.seed;
  setup.duration_s = 4000 + flight.stated_s;
  if (flight.way == Way::Killed) {
    setup.kill_sbc_at_s = flight.at_s;
  } else if (flight.way == Way::Cut) {
    simulator::LineFault cut;
    cut.way = simulator::LineWay::FromSbc;
    cut.when.from_s = flight.at_s;
    cut.cut = true;
    setup.scenario.faults.lines.push_back(cut);
  } else if (flight.way == Way::Device) {
    setup.scenario.faults.aborts.push_back(flight.at_s);
  }
  setup.observer = &watch;
  auto sbc =
      std::make_unique<InProcessSbc>(flight.mission.loaded, std::vector<double>{},
                                     std::make_shared<flights::Card>(), flight.way == Way::Cut);
  sbc->watch([&](const GliderContext& context, double) {
    if (context.finished != 0) {
      watch.finished();
    }
  });
  setup.sbc = std::move(sbc);
  EXPECT_TRUE(simulator::simulate(std::move(setup)).has_value());
  return watch;
}

double stated(const slocum::rules::Whole& whole, const std::string& after) {
  const auto found = std::ranges::find_if(whole.endings, [&](const slocum::rules::Ending& ending) {
    return ending.after.starts_with(after);
  });
  EXPECT_NE(found, whole.endings.end()) << after;
  EXPECT_TRUE(found->proved()) << found->why_not;
  return found->seconds();
}

slocum::MissionFile prepared(const std::string& file, Way way, double at_s) {
  slocum::MissionFile vehicle = vehicleOf(shipped(file));
  return way == Way::Overdepth  ? with(vehicle, 1, "overdepth", 18)
         : way == Way::Overtime ? with(vehicle, 1, "overtime", at_s)
         : way == Way::Masked   ? with(vehicle, 2, "when_secs", at_s)
                                : vehicle;
}

TEST(Whole, AfterEachLossOfControlTheVehicleIsAtTheSurfaceInTheStatedTime) {
  const uint64_t seeds = wanted("GLIDER_WHOLE_FLIGHTS", 3);
  ir::prove::Rng dice(20261123);
  uint64_t counted = 0, flown = 0;
  double longest = 0;
  for (uint64_t seed = 1; seed <= seeds; ++seed) {
    const double exit_s = dice.within(600, 1500);
    const FlyingMission until_exit = yoUntil(exit_s), for_long = yoUntil(20000);
    for (const char* file : kFiles) {
      for (const WayRow& row : kWays) {
        const double at_s = dice.within(400, 1500);
        const FlyingMission& mission = row.way == Way::Exit ? until_exit : for_long;
        const slocum::MissionFile vehicle = prepared(file, row.way, at_s);
        // An early abort by overtime is what is flown, not what is proved about the layers.
        const auto whole =
            slocum::rules::wholeOf({mission.flown->mission, slocum()},
                                   row.way == Way::Overtime ? vehicleOf(shipped(file)) : vehicle);
        const double within_s = stated(whole, row.after);
        const LossWatch watch = fly({mission, vehicle, row.way, at_s, within_s, seed});
        ++flown;
        const std::string told = fmt::format("{}, {}, seed {}", file, row.after, seed);
        if (watch.lost()) {
          ++counted;
          EXPECT_TRUE(watch.surfaced()) << told;
          EXPECT_LE(watch.took(), within_s) << told;
          EXPECT_LE(watch.deepest(), whole.deepest_m) << told;
          longest = std::max(longest, watch.took() / within_s);
        }
      }
    }
  }
  EXPECT_GT(counted, flown * 2 / 3);
  EXPECT_GT(longest, 0.1) << "none was under water";
  fmt::print("{} of {} flights lost control; the longest took {:.2f} of what is stated\n", counted,
             flown, longest);
}

constexpr const char* kEndlessYo =
    "behavior: yo\n    b_arg: start_when(enum) 0\n    b_arg: d_target_depth(m) 30\n"
    "    b_arg: c_target_depth(m) 12\n";
constexpr const char* kHeading =
    "behavior: set_heading\n    b_arg: use_heading(bool) 1\n    b_arg: heading_value(X) 1\n";

/// The skeleton with a fault.
struct Twin {
  const char* fault;
  std::string text;
  bool stays = true;  ///< under water, for longer than the skeleton's time
};

std::vector<Twin> twins() {
  const std::string whole = shipped("skeleton");
  const auto inserted = [&](const std::string& before, const std::string& text) {
    std::string twin = whole;
    return twin.insert(twin.rfind(before), text);
  };
  return {
      {"an endless yo below", whole + kHeading + kEndlessYo},
      {"a yo that starts again below",
       whole + kHeading + kEndlessYo +
           "    b_arg: num_half_cycles_to_do(nodim) 3\n    b_arg: end_action(enum) 2\n",
       false},  // here the stack is idle for a cycle: nothing promises that
      {"a drift below", whole + kHeading +
                            "behavior: drift_at_depth\n    b_arg: target_depth(m) 20\n"
                            "    b_arg: target_deadband(m) 3\n    b_arg: "
                            "stop_when_hover_for(s) 36000\n"},
      {"a yo above hookbeh", inserted("behavior: hookbeh", kEndlessYo) + kHeading},
      {"a yo above the surface behaviour", inserted("behavior: surface", kEndlessYo)},
      {"a surface behaviour that dives",
       inserted("behavior: hookbeh", "    b_arg: c_bpump_value(X) -1000\n"),
       false},  // it sinks to 70 m, where the vehicle aborts
  };
}

TEST(Whole, TwinsWithAFaultAreRefusedAndStayUnderWater) {
  const FlyingMission mission = yoUntil(20000);
  const double within_s = stated(
      slocum::rules::wholeOf({mission.flown->mission, slocum()}, vehicleOf(shipped("skeleton"))),
      "silence");
  constexpr double kInADive_s = 700;  // near its top the vehicle comes up by itself
  for (const auto& [fault, text, stays] : twins()) {
    slocum::MissionFile vehicle = vehicleOf(text);
    // Without the surfacing after 8 hours, which does bring a yo below it up.
    vehicle = with(vehicle, 2, "start_when", 5);
    EXPECT_FALSE(slocum::rules::wholeOf({mission.flown->mission, slocum()}, vehicle).proved())
        << fault;
    const LossWatch watch = fly({mission, vehicle, Way::Killed, kInADive_s, within_s, 1});
    EXPECT_TRUE(watch.lost()) << fault;
    EXPECT_TRUE(!stays || !watch.surfaced()) << fault;
  }
}

}  // namespace
}  // namespace glider::tests
