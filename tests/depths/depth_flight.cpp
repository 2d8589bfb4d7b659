// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/depths/depth_flight.h"

#include "hooks/hookbeh/hookbeh.h"
#include "platforms/load/load_platform.h"
#include "simulator/campaign/kinds_of_faults.h"
#include "simulator/simulator.h"
#include "simulator/slocum/flight/skeleton.h"
#include "simulator/slocum/own_mission.h"
#include "support/check.h"
#include "tests/slocum.h"
#include "vehicles/slocum/mission_files/read.h"
#include "vehicles/slocum/oracles/bottom_judge.h"
#include "vehicles/slocum/oracles/judge_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <deque>
#include <ranges>
#include <utility>

namespace glider::tests {
namespace {

const std::filesystem::path kSource = GLIDER_SOURCE_DIR;

/// Sees how the vehicle itself fares.
class DepthOnlooker final : public simulator::FlightObserver {
 public:
  explicit DepthOnlooker(const slocum::oracles::JudgeSetup& judged) : judge_(judged) {}
  void said(std::span<const uint8_t> /*bytes*/, double /*now_s*/) override {}
  bool cycle(const simulator::CycleView& view) override {
    const double depth = view.true_depth_m;
    seen.deepest_m = std::max(seen.deepest_m, depth);
    seen.last_m = depth;
    noteTurn(depth);
    noteBottom(view);
    noteHeld(view);
    for (const double what : {depth, view.east_m, view.north_m, view.pumped_cc}) {
      constexpr uint64_t kPrime = 0x100000001b3U;  // FNV-1a, a word at a time
      seen.fingerprint = (seen.fingerprint ^ std::bit_cast<uint64_t>(what)) * kPrime;
    }
    if (view.hook == hooks::HookState::Complete && seen.given_back_s < 0) {
      seen.given_back_s = view.time_s;
    }
    const double guard = view.array.get(GLIDER_X_HOOK_GUARD);
    if (guard > 0) {
      seen.water_held_it = seen.guards.empty() ? held_ : seen.water_held_it;
      seen.guards.insert(static_cast<int>(guard));
      seen.guarded_s = seen.guarded_s < 0 ? view.time_s : seen.guarded_s;
    }
    return true;
  }
  Dived seen;

 private:
  void noteTurn(double depth) {
    constexpr double kTurned = 2;
    extreme_ = sinking_ ? std::max(extreme_, depth) : std::min(extreme_, depth);
    const double back = sinking_ ? extreme_ - depth : depth - extreme_;
    if (back > kTurned) {
      seen.dives += sinking_;
      sinking_ = !sinking_;
      extreme_ = depth;
    }
  }

  void noteHeld(const simulator::CycleView& view) {
    constexpr double kHeavyCc = -60, kActsSecs = 30, kStillSecs = 24, kStillM = 0.7;
    const bool heavy = view.pumped_cc <= kHeavyCc && view.clearance_m > 5;
    heavy_from_s_ = heavy ? std::min(heavy_from_s_, view.time_s) : 1e18;
    recent_.emplace_back(view.time_s, view.true_depth_m);
    while (view.time_s - recent_.front().first > kStillSecs) {
      recent_.pop_front();
    }
    const auto [least, most] = std::ranges::minmax(recent_ | std::views::values);
    held_ = held_ || (view.time_s - heavy_from_s_ >= kActsSecs + kStillSecs &&
                      view.true_depth_m > 2 && most - least < kStillM);
  }

  void noteBottom(const simulator::CycleView& view) {
    const bool touches =
        view.clearance_m < slocum::oracles::limits::kTouchM && view.true_depth_m > 1;
    touched_s_ = !touches ? -1 : touched_s_ < 0 ? view.time_s : touched_s_;
    seen.contacts += touches && touched_s_ == view.time_s;
    seen.on_bottom_s = std::max(seen.on_bottom_s, touches ? view.time_s - touched_s_ : 0);
    seen.clearance_m =
        view.true_depth_m > 1 ? std::min(seen.clearance_m, view.clearance_m) : seen.clearance_m;
    std::string wrong = judge_.cycle(view);
    seen.bottom_violation = seen.bottom_violation.empty() ? wrong : seen.bottom_violation;
  }

  slocum::oracles::BottomJudge judge_;
  double touched_s_ = -1;
  std::deque<std::pair<double, double>> recent_;  ///< times, s, and true depths, m
  double heavy_from_s_ = 1e18;
  bool held_ = false;
  bool sinking_ = true;
  double extreme_ = 0;
};

const platforms::Platform& platform() {
  static const auto kPlatform = platforms::loadPlatform(kSource / "platforms/slocum.toml");
  return *kPlatform;
}

}  // namespace

uint64_t wantedNumber(const char* name, uint64_t standard) {
  const char* text = std::getenv(name);
  return text == nullptr ? standard : std::stoull(text);
}

std::string hookbehSkeleton(double greatest_m) {
  return fmt::format(
      "behavior: abend\n b_arg: overdepth(m) {}\n b_arg: overtime(s) 43200\n"
      " b_arg: samedepth_for(s) 1800\n"
      "behavior: surface\n b_arg: start_when(enum) 1\n b_arg: end_action(enum) 2\n"
      " b_arg: gps_wait_time(s) 0\n b_arg: c_use_pitch(enum) 3\n b_arg: c_pitch_value(X) 0.4538\n"
      "behavior: hookbeh\n b_arg: max_depth(m) {}\n b_arg: min_altitude(m) 5\n"
      " b_arg: max_pitch(rad) 0.7854\n",
      greatest_m + 10, greatest_m);
}

std::string layeredSkeleton(double greatest_m, double bottom_m) {
  return fmt::format(
      "behavior: abend\n b_arg: overdepth(m) {}\n b_arg: overtime(s) 43200\n"
      " b_arg: samedepth_for(s) 1800\n"
      "behavior: surface\n b_arg: start_when(enum) 1\n b_arg: end_action(enum) 0\n"
      " b_arg: gps_wait_time(s) 120\n b_arg: c_use_pitch(enum) 3\n b_arg: c_pitch_value(X) 0.4538\n"
      "behavior: set_heading\n b_arg: use_heading(enum) 1\n b_arg: heading_value(X) 1.5708\n"
      "behavior: yo\n b_arg: start_when(enum) 2\n b_arg: num_half_cycles_to_do(nodim) 100\n"
      " b_arg: end_action(enum) 0\n b_arg: d_target_depth(m) {}\n b_arg: d_target_altitude(m) 5\n"
      " b_arg: d_use_pitch(enum) 3\n b_arg: d_pitch_value(X) -0.4538\n"
      " b_arg: d_bpump_value(X) -1000\n b_arg: c_target_depth(m) 4\n"
      " b_arg: c_target_altitude(m) -1\n b_arg: c_use_pitch(enum) 3\n"
      " b_arg: c_pitch_value(X) 0.4538\n b_arg: c_bpump_value(X) 1000\n",
      greatest_m + 10, bottom_m);
}

simulator::Scenario diveScenario(const std::string& skeleton, double water_m) {
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  auto scenario =
      simulator::loadScenario(kSource / "scenarios/default.toml", platform(), sources, diagnostics);
  CHECK(scenario.has_value(), "the default scenario is not right");
  const uint32_t file = sources.add("dive.mi", skeleton);
  auto mission = slocum::readMission(sources, file, diagnostics);
  CHECK(mission.has_value(), "the skeleton mission cannot be read");
  simulator::checkSkeleton(*mission, {file, 0, 0}, diagnostics);
  CHECK(diagnostics.errorCount() == 0, "the skeleton mission has errors");
  simulator::missionFileOf(*scenario) = std::move(*mission);
  scenario->ocean.bottom.depth_m = water_m;
  scenario->ocean.bottom.wave_height_m = 0;
  return std::move(*scenario);
}

Dived flyDive(const Plan* plan, simulator::Scenario scenario, uint64_t seed, bool comes_back) {
  const slocum::oracles::JudgeSetup judged =
      slocum::oracles::judgeSetup(platform(), scenario, simulator::kindsOf(scenario.faults));
  DepthOnlooker observer(judged);
  simulator::SimulationSetup setup;
  setup.platform = platform();
  setup.scenario = std::move(scenario);
  setup.seed = seed;
  setup.observer = &observer;
  if (plan != nullptr) {
    setup.sbc = std::make_unique<simulator::FakeSbc>(*plan);
  }
  if (comes_back) {
    setup.restart_sbc = [again = *plan](auto&&...) mutable {
      again.takes_again = true;
      return std::make_unique<simulator::FakeSbc>(again);
    };
  }
  const auto trace = simulator::simulate(std::move(setup));
  CHECK(trace.has_value(), "the flight could not be flown");
  return observer.seen;
}

}  // namespace glider::tests
