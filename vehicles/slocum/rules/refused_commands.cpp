// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/rules/refused_commands.h"

#include "hooks/hookbeh/args.h"
#include "ir/core/ops.h"
#include "ir/prove/abstract/held_ranges.h"
#include "ir/prove/context/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

namespace glider::slocum::rules {
namespace {

using Commands = std::vector<const ir::Statement*>;

constexpr double kEndless = std::numeric_limits<double>::infinity();
/// A greater bound means that the number has no range.
constexpr double kNoBound = 1e300;

constexpr double kCcPerCubicMetre = 1e6;
constexpr double kMetresPerInch = 0.0254;

std::string degrees(double angle) {
  return fmt::format("{:.3g} deg", angle * 180 / std::numbers::pi);
}

/// What the commands of a state may contain.
struct Extremes {
  double steepest = 0;
  double shallowest = kEndless;
  double deepest = -kEndless;  ///< that: it commands no depth
  double farthest_fin = 0;
  double farthest_pump = 0, farthest_battery = 0;  ///< m3, m
};

/// Where a command moves a part to, for commands that do.
double* partOf(const ir::Statement& command, Extremes& all) {
  switch (command.command) {
    case ir::Command::Fin:
      return &all.farthest_fin;
    case ir::Command::Pump:
      return &all.farthest_pump;
    case ir::Command::Battery:
      return &all.farthest_battery;
    case ir::Command::Descend:
    case ir::Command::Ascend:
    case ir::Command::DescendAt:
    case ir::Command::AscendAt:
    case ir::Command::Hover:
    case ir::Command::Surface:
    case ir::Command::Steer:
    case ir::Command::SteerTo:
    case ir::Command::Drift:
      break;
  }
  return nullptr;
}

Extremes extremesOf(const Commands& commands, const std::vector<ir::Interval>& held) {
  Extremes all;
  for (const ir::Statement* command : commands) {
    if (double* farthest = partOf(*command, all)) {
      const ir::Interval& to = held[command->values.at(0).index];
      if (!to.empty && to.highest - to.lowest < kNoBound) {
        *farthest = std::max({*farthest, to.highest, -to.lowest});
      }
      continue;
    }
    const bool sloped = ir::isDescent(command->command) || ir::isAscent(command->command);
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

void addRefused(const Refusal& of, const Extremes& all, const CommandLimits& limits,
                std::vector<Refusal>& found) {
  const auto add = [&](std::string command, std::string limit, const char* argument) {
    found.push_back({of.range, of.who, std::move(command), std::move(limit), argument});
  };
  if (all.steepest > limits.steepest_pitch_rad) {
    add("a pitch of " + degrees(all.steepest), "more than " + degrees(limits.steepest_pitch_rad),
        "max_pitch");
  }
  if (all.shallowest < limits.shallowest_pitch_rad) {
    add("a pitch of " + degrees(all.shallowest),
        "less than " + degrees(limits.shallowest_pitch_rad), "min_pitch");
  }
  if (all.farthest_fin > limits.greatest_fin_rad) {
    add("a fin angle of " + degrees(all.farthest_fin),
        "more than " + degrees(limits.greatest_fin_rad), "max_fin");
  }
  // As commands and limits are rounded: 0.6 inch are not more than 0.6 in.
  constexpr double kRounded = 1 + 1e-9;
  const double pump_cc = all.farthest_pump * kCcPerCubicMetre;
  if (pump_cc > limits.greatest_pump_cc * kRounded) {
    add(fmt::format("a pump volume of {:.4g} cc", pump_cc),
        fmt::format("more than {:.4g} cc", limits.greatest_pump_cc), "max_pump");
  }
  const double battery_in = all.farthest_battery / kMetresPerInch;
  if (battery_in > limits.greatest_battery_in * kRounded) {
    add(fmt::format("a battery position of {:.4g} inch", battery_in),
        fmt::format("more than {:.4g} inch", limits.greatest_battery_in), "max_battery");
  }
  if (limits.greatest_depth_m && all.deepest > *limits.greatest_depth_m) {
    add(fmt::format("a depth of {:.4g} m", all.deepest),
        fmt::format("more than {:.4g} m", *limits.greatest_depth_m), "max_depth");
  }
}

}  // namespace

CommandLimits usualLimits() {
  const hooks::HookbehArgs args;
  return {
      args.steepest_pitch_rad,
      args.shallowest_pitch_rad,
      args.greatest_fin_rad,
      args.greatest_pump_cc,
      args.greatest_battery_in,
      std::nullopt,
      fmt::format("assuming max_pitch {:.4g}, min_pitch {:.4g}, max_fin {:.4g}, max_pump {:.4g} "
                  "and max_battery {:.4g}; see --mi",
                  args.steepest_pitch_rad, args.shallowest_pitch_rad, args.greatest_fin_rad,
                  args.greatest_pump_cc, args.greatest_battery_in)};
}

std::optional<std::string> deeperThanBundledLine(const ir::Mission& mission) {
  const std::vector<Dive> dives = divesOf(mission);
  const auto deepest = std::ranges::max_element(dives, {}, &Dive::depth_m);
  if (deepest == dives.end() || deepest->depth_m <= kBundledGreatestDepth_m) {
    return std::nullopt;
  }
  return fmt::format(
      "{} may command a depth of {:.4g} m: with the mission files that come with "
      "glidercc, hookbeh refuses more than {:.4g} m (max_depth in skeleton.mi); "
      "check with yours by --mi",
      deepest->who, deepest->depth_m, kBundledGreatestDepth_m);
}

std::vector<Refusal> refusalsOf(const ir::Mission& mission, const CommandLimits& limits) {
  const std::vector<ir::Interval> held = ir::prove::heldIntervals(mission);
  std::vector<Refusal> found;
  addRefused({{}, "`always`", "", ""}, extremesOf(ir::prove::commandsOfAlways(mission), held),
             limits, found);
  for (const ir::State& state : mission.states) {
    addRefused({state.range, "`" + state.name + "`", "", ""},
               extremesOf(ir::prove::commandsOf(mission, state), held), limits, found);
  }
  return found;
}

std::vector<Dive> divesOf(const ir::Mission& mission) {
  const std::vector<ir::Interval> held = ir::prove::heldIntervals(mission);
  std::vector<Dive> dives;
  const auto add = [&](const support::SourceRange& range, const std::string& who,
                       const Commands& commands) {
    const double deepest = extremesOf(commands, held).deepest;
    if (deepest > -kEndless) {
      dives.push_back({range, who, deepest});
    }
  };
  add({}, "`always`", ir::prove::commandsOfAlways(mission));
  for (const ir::State& state : mission.states) {
    add(state.range, "`" + state.name + "`", ir::prove::commandsOf(mission, state));
  }
  return dives;
}

std::vector<std::string> refusedLines(const ir::Mission& mission, const CommandLimits& limits) {
  std::vector<std::string> lines;
  for (const Refusal& one : refusalsOf(mission, limits)) {
    lines.push_back(fmt::format("{} may command {}: hookbeh refuses {} ({})", one.who, one.command,
                                one.limit, limits.source));
  }
  return lines;
}

}  // namespace glider::slocum::rules
