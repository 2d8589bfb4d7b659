// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/refused_commands.h"

#include "hooks/hookbeh/args.h"
#include "ir/prove/abstract/held_ranges.h"
#include "ir/prove/context/commands.h"
#include "slocum/mission_files/load.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <numbers>
#include <utility>

namespace glider::analysis {
namespace {

using Commands = std::vector<const ir::Statement*>;

constexpr double kEndless = std::numeric_limits<double>::infinity();
/// A greater bound means that the number has no range.
constexpr double kNoBound = 1e300;

std::string degrees(double angle) {
  return fmt::format("{:.3g} deg", angle * 180 / std::numbers::pi);
}

/// What the commands of a state may contain.
struct Extremes {
  double steepest = 0;
  double shallowest = kEndless;
  double deepest = 0;
};

Extremes extremesOf(const Commands& commands, const std::vector<ir::Interval>& held) {
  Extremes all;
  for (const ir::Statement* command : commands) {
    const bool sloped =
        command->command == ir::Command::Descend || command->command == ir::Command::Ascend;
    if (!sloped && command->command != ir::Command::Hover) {
      continue;
    }
    const ir::Interval& depth = held[command->values.at(0).index];
    if (!depth.empty && depth.highest < kNoBound) {
      all.deepest = std::max(all.deepest, depth.highest);
    }
    const ir::Interval pitch =
        sloped ? held[command->values.at(1).index] : ir::Interval{0, 0, true};
    if (!pitch.empty && pitch.highest - pitch.lowest < kNoBound) {
      all.steepest = std::max({all.steepest, pitch.highest, -pitch.lowest});
      all.shallowest = std::min(all.shallowest, std::max({pitch.lowest, -pitch.highest, 0.0}));
    }
  }
  return all;
}

void addRefused(const std::string& who, const Extremes& of, const CommandLimits& limits,
                std::vector<std::string>& lines) {
  const auto add = [&](const std::string& what, const std::string& limit) {
    lines.push_back(
        fmt::format("{} may command {}: hookbeh refuses {} ({})", who, what, limit, limits.source));
  };
  if (of.steepest > limits.steepest_pitch_rad) {
    add("a pitch of " + degrees(of.steepest), "more than " + degrees(limits.steepest_pitch_rad));
  }
  if (of.shallowest < limits.shallowest_pitch_rad) {
    add("a pitch of " + degrees(of.shallowest),
        "less than " + degrees(limits.shallowest_pitch_rad));
  }
  if (limits.greatest_depth_m && of.deepest > *limits.greatest_depth_m) {
    add(fmt::format("a depth of {:.4g} m", of.deepest),
        fmt::format("more than {:.4g} m", *limits.greatest_depth_m));
  }
}

}  // namespace

CommandLimits usualLimits() {
  const hooks::HookbehArgs args;
  return {args.steepest_pitch_rad, args.shallowest_pitch_rad, std::nullopt,
          fmt::format("assuming max_pitch {:.4g} and min_pitch {:.4g}; see --skeleton",
                      args.steepest_pitch_rad, args.shallowest_pitch_rad)};
}

support::Result<CommandLimits> limitsOf(const std::string& path) {
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  const auto mission = slocum::loadMission(path, sources, diagnostics, [](auto&&...) {});
  if (!mission) {
    return std::unexpected(mission.error());
  }
  const auto hookbeh =
      std::ranges::find(mission->behaviours, "hookbeh", &slocum::BehaviourBlock::name);
  if (hookbeh == mission->behaviours.end()) {
    return support::fail(support::DiagnosticId::skeletonErrors, path,
                         "it has no behavior `hookbeh`");
  }
  const double steepest = hookbeh->value("max_pitch");
  const double shallowest = hookbeh->value("min_pitch");
  const double deepest = hookbeh->value("max_depth");
  return CommandLimits{
      steepest, shallowest, deepest,
      fmt::format("max_pitch {:.4g}, min_pitch {:.4g} and max_depth {:.4g} in {}", steepest,
                  shallowest, deepest, std::filesystem::path(path).filename().string())};
}

std::vector<std::string> refusedLines(const ir::Mission& mission, const CommandLimits& limits) {
  const std::vector<ir::Interval> held = ir::prove::heldIntervals(mission);
  std::vector<std::string> lines;
  addRefused("`always`", extremesOf(ir::prove::commandsOfAlways(mission), held), limits, lines);
  for (const ir::State& state : mission.states) {
    addRefused("`" + state.name + "`", extremesOf(ir::prove::commandsOf(mission, state), held),
               limits, lines);
  }
  return lines;
}

}  // namespace glider::analysis
