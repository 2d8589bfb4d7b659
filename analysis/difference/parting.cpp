// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/difference/parting.h"

#include "analysis/difference/random_readings.h"
#include "analysis/difference/tick_text.h"
#include "analysis/heard_flight.h"
#include "flights/flight_setup.h"
#include "flights/launch_choice.h"
#include "ir/prove/context/commands.h"
#include "simulator/simulator.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <variant>

namespace glider::analysis {
namespace {

using support::Result;

constexpr uint64_t kRandomFlights = 60;
constexpr size_t kRandomTicks = 1500;

bool isSame(const std::optional<ir::CommandRun>& a, const std::optional<ir::CommandRun>& b) {
  return a.has_value() == b.has_value() &&
         (!a || (a->command == b->command && a->arguments == b->arguments));
}

/// One version in flight, on the interpreter.
class VersionRun {
 public:
  VersionRun(const compiler::Checked& checked, const std::vector<std::string>& names)
      : m_(checked.mission()), names_(names), interpreter_(m_, checked.facts.stack_depth) {}

  void tick(double mission_time, std::span<const ir::SensorUpdate> frame) {
    before_ = result_.state;
    const bool first = !std::exchange(started_, true);
    result_ = first ? interpreter_.start(frame) : interpreter_.tick(mission_time, frame);
    before_ = first ? ir::StateId{0} : before_;
    for (const ir::Action& action : result_.actions) {
      const auto* run = std::get_if<ir::CommandRun>(&action);
      if (run != nullptr && !run->refused) {
        (ir::prove::isVertical(run->command) ? depth_ : heading_) = *run;
      }
    }
  }

  /// Whether both are in the same state, under the same commands.
  [[nodiscard]] bool doesAs(const VersionRun& other) const {
    return result_.finished == other.result_.finished && state() == other.state() &&
           isSame(depth_, other.depth_) && isSame(heading_, other.heading_);
  }

  [[nodiscard]] bool finished() const { return result_.finished; }
  [[nodiscard]] const std::string& state() const { return names_[result_.state.index]; }
  [[nodiscard]] const std::string& stateBefore() const { return names_[before_.index]; }
  [[nodiscard]] std::string does() const { return tickText(m_, result_, before_, names_); }
  [[nodiscard]] std::vector<std::string> readings() const { return readingsText(m_, interpreter_); }

 private:
  const ir::Mission& m_;
  const std::vector<std::string>& names_;
  ir::Interpreter interpreter_;
  ir::TickResult result_;
  ir::StateId before_{0};
  bool started_ = false;
  std::optional<ir::CommandRun> depth_, heading_;  ///< in force
};

/// Flies both versions in the simulator, for likely flights, and follows on the interpreter what
/// each has received; then both on the interpreter with random readings, for rare ones. That
/// nothing is found proves nothing.
class SearchForParting {
 public:
  SearchForParting(const compiler::Optimised& before, const compiler::Optimised& after,
                   const MissionDifference& difference)
      : old_(before), new_(after), difference_(difference) {}

  Result<PartingSearch> run() {
    if (auto simulated = simulate(); !simulated) {
      return std::unexpected(simulated.error());
    }
    for (uint64_t seed = 1; seed <= kRandomFlights && !found_.found; ++seed) {
      ++found_.random;
      flyRandom(seed);
    }
    return std::move(found_);
  }

 private:
  Result<void> simulate() {
    if (!simulator::checkPlatform(old_.platform())) {
      return {};
    }
    auto was = flights::loadHere(old_, {});
    auto is = was ? flights::loadHere(new_, {}) : std::unexpected(was.error());
    if (!is) {
      return std::unexpected(is.error());
    }
    const auto old_loaded = std::make_shared<const codegen::LoadedMission>(std::move(*was));
    const auto new_loaded = std::make_shared<const codegen::LoadedMission>(std::move(*is));
    for (const std::string& scenario : scenariosInOrder()) {
      constexpr uint64_t kSeed = 1;
      const auto one = flyHeard(old_, old_loaded, ir::defaultParameters(old_.checked->mission()),
                                scenario, kSeed);
      const auto other =
          one ? flyHeard(new_, new_loaded, ir::defaultParameters(new_.checked->mission()), scenario,
                         kSeed)
              : std::unexpected(one.error());
      if (!other) {
        return std::unexpected(other.error());
      }
      ++found_.flights;
      follow(one->ticks, other->ticks, fmt::format("scenario {}, --seed {}", scenario, kSeed));
      if (found_.found) {
        return {};
      }
    }
    return {};
  }

  /// Both flights are the same until they part, and so are their ticks.
  void follow(const std::vector<flights::HeardTick>& one,
              const std::vector<flights::HeardTick>& other, const std::string& flight) {
    VersionRun was(*old_.checked, difference_.old_names);
    VersionRun is(*new_.checked, difference_.new_names);
    for (size_t i = 0; i < std::min(one.size(), other.size()); ++i) {
      if (one[i].mission_time != other[i].mission_time) {
        return;
      }
      was.tick(one[i].mission_time, one[i].frame);
      is.tick(other[i].mission_time, other[i].frame);
      if (tellIfParted(was, is, one[i].mission_time, flight)) {
        return;
      }
    }
  }

  void flyRandom(uint64_t seed) {
    const ir::Mission& old_mission = old_.checked->mission();
    const ir::Mission& new_mission = new_.checked->mission();
    RandomReadings readings(old_mission, new_mission, seed);
    VersionRun was(*old_.checked, difference_.old_names);
    VersionRun is(*new_.checked, difference_.new_names);
    for (size_t i = 0; i < kRandomTicks && !was.finished(); ++i) {
      readings.next();
      was.tick(readings.missionTime(), readings.frame(old_mission));
      is.tick(readings.missionTime(), readings.frame(new_mission));
      if (tellIfParted(was, is, readings.missionTime(), "random readings")) {
        return;
      }
    }
  }

  bool tellIfParted(const VersionRun& was, const VersionRun& is, double mission_time,
                    const std::string& flight) {
    if (was.doesAs(is)) {
      return false;
    }
    found_.found = true;
    std::vector<std::string> readings = was.readings();
    for (std::string& one : is.readings()) {
      if (std::ranges::find(readings, one) == readings.end()) {
        readings.push_back(std::move(one));
      }
    }
    found_.parting = {flight, mission_time, was.stateBefore(), was.does(), is.does(), readings};
    return true;
  }

  const compiler::Optimised& old_;
  const compiler::Optimised& new_;
  const MissionDifference& difference_;
  PartingSearch found_;
};

}  // namespace

Result<PartingSearch> searchParting(const compiler::Optimised& before,
                                    const compiler::Optimised& after,
                                    const MissionDifference& difference) {
  const bool flies = before.platform().name == after.platform().name &&
                     !flights::needsCodeInC(before.checked->mission()) &&
                     !flights::needsCodeInC(after.checked->mission());
  return flies ? SearchForParting(before, after, difference).run() : PartingSearch{};
}

}  // namespace glider::analysis
