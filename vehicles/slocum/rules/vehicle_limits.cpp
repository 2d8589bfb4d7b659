// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/rules/vehicle_limits.h"

#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/context/commands.h"
#include "ir/prove/context/duration_text.h"
#include "support/diagnostics/ids/verification.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <ranges>
#include <vector>

namespace glider::slocum::rules {
namespace {

/// Where a fault of the whole mission is reported.
support::SourceRange beginningOf(const ir::Mission& mission) {
  return mission.states.front().range;
}

/// A commanded pump or battery leads as deep as hookbeh lets it.
void checkActuators(const ir::Mission& mission, const VehicleFile& file,
                    support::DiagnosticEngine& diagnostics) {
  const double overdepth = *file.aborts.overdepth_m;
  for (const ir::State& state : mission.states) {
    const auto commands = ir::prove::commandsOf(mission, state);
    const bool moves = std::ranges::any_of(commands, [](const ir::Statement* command) {
      return ir::prove::movesActuators(command->command);
    });
    if (moves && file.guards.greatest_depth_m > overdepth) {
      diagnostics.report(
          support::diagnostics::vehicleAborts, state.range,
          fmt::format("`{}` commands the pump or the battery, hookbeh ends a descent "
                      "at {:.4g} m, and abend allows no more than {:.4g} m "
                      "(max_depth and overdepth in {})",
                      state.name, file.guards.greatest_depth_m, overdepth, file.name),
          "raise overdepth, or lower max_depth");
    }
  }
}

void checkDepth(const ir::Mission& mission, double overdepth, const std::string& name,
                support::DiagnosticEngine& diagnostics) {
  CommandLimits limits = usualLimits();
  limits.steepest_pitch_rad = 10;  // of anything but depths abend knows nothing
  limits.shallowest_pitch_rad = 0;
  limits.greatest_fin_rad = 10;
  limits.greatest_pump_cc = limits.greatest_battery_in = std::numeric_limits<double>::infinity();
  limits.greatest_depth_m = overdepth;
  for (const Refusal& one : refusalsOf(mission, limits)) {
    diagnostics.report(support::diagnostics::vehicleAborts,
                       one.range.valid() ? one.range : beginningOf(mission),
                       fmt::format("{} may command {}, and abend allows no more than {:.4g} m "
                                   "(overdepth in {})",
                                   one.who, one.command, overdepth, name),
                       "command a shallower depth, or raise overdepth");
  }
}

/// The latest end of the mission, if it has a proved one.
std::optional<double> latestEnd(const ir::WrittenWorld& world) {
  const ir::prove::ProofContext context(world);
  return ir::prove::boundOf(context.withoutPowerCuts(), ir::prove::kLongestMission,
                            ir::prove::Goal::Exit)
      .by;
}

/// `starts`: when hookbeh is ready, s of the vehicle's mission.
void checkTime(const ir::WrittenWorld& world, double overtime, double starts,
               const std::string& name, support::DiagnosticEngine& diagnostics) {
  if (starts > overtime) {
    diagnostics.report(
        support::diagnostics::controlPrevented, beginningOf(world.mission),
        fmt::format("hookbeh is ready {} after the vehicle's mission has begun, and abend aborts "
                    "after {} (start_secs and overtime in {})",
                    ir::prove::durationOf(starts), ir::prove::durationOf(overtime), name),
        "lower start_secs, or raise overtime");
    return;
  }
  const std::optional<double> end = latestEnd(world);
  if (end && starts + *end > overtime) {
    const std::string from =
        starts > 0 ? fmt::format(" from {} on (start_secs)", ir::prove::durationOf(starts)) : "";
    diagnostics.report(
        support::diagnostics::vehicleAborts, beginningOf(world.mission),
        fmt::format("the mission may last {}{}, and abend allows {} (overtime in {})",
                    ir::prove::durationOf(*end), from, ir::prove::durationOf(overtime), name),
        "end the mission earlier, or raise overtime");
  }
}

/// What to change for a command to be obeyed.
std::string whereLimitIs(const Refusal& refusal, const VehicleFile& file) {
  return file.limits_at.empty()
             ? fmt::format("`{}` of {} in {}", refusal.argument, file.refuser, file.name)
             : file.limits_at;
}

}  // namespace

void checkVehicleLimits(const ir::WrittenWorld& world, const VehicleFile& file,
                        support::DiagnosticEngine& diagnostics) {
  const ir::Mission& mission = world.mission;
  for (const Refusal& one : refusalsOf(mission, file.commands)) {
    diagnostics.report(support::diagnostics::vehicleRefuses,
                       one.range.valid() ? one.range : beginningOf(mission), one.who, one.command,
                       file.refuser, one.limit, whereLimitIs(one, file));
  }
  if (file.aborts.overdepth_m) {
    checkDepth(mission, *file.aborts.overdepth_m, file.name, diagnostics);
    checkActuators(mission, file, diagnostics);
  }
  if (file.aborts.overtime_s) {
    checkTime(world, *file.aborts.overtime_s, std::max(0.0, file.guards.start_secs), file.name,
              diagnostics);
  }
  const double full = world.platform.power.full_V;
  if (file.aborts.undervolts_V && full > 0 && *file.aborts.undervolts_V >= full) {
    diagnostics.report(support::diagnostics::vehicleAborts, beginningOf(mission),
                       fmt::format("its full batteries have {:.4g} V, and abend demands {:.4g} V "
                                   "(undervolts in {})",
                                   full, *file.aborts.undervolts_V, file.name),
                       "lower undervolts");
  }
}

std::optional<std::string> endlessLine(const ir::WrittenWorld& world, const VehicleFile& file) {
  if (!file.aborts.overtime_s || latestEnd(world)) {
    return std::nullopt;
  }
  return fmt::format(
      "the mission has no proved end: abend aborts it {} after the vehicle's mission has begun "
      "(overtime in {})",
      ir::prove::durationOf(*file.aborts.overtime_s), file.name);
}

}  // namespace glider::slocum::rules
