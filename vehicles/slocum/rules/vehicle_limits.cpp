// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/rules/vehicle_limits.h"

#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/context/duration_text.h"
#include "support/diagnostics/ids/verification.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <ranges>
#include <vector>

namespace glider::slocum::rules {
namespace {

/// Where a fault of the whole mission is reported.
support::SourceRange beginningOf(const ir::Mission& mission) {
  return mission.states.front().range;
}

void checkDepth(const ir::Mission& mission, double overdepth, const std::string& name,
                support::DiagnosticEngine& diagnostics) {
  CommandLimits limits = usualLimits();
  limits.steepest_pitch_rad = 10;  // of pitches and fins abend knows nothing
  limits.shallowest_pitch_rad = 0;
  limits.greatest_fin_rad = 10;
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

}  // namespace

void checkVehicleLimits(const ir::WrittenWorld& world, const VehicleFile& file,
                        support::DiagnosticEngine& diagnostics) {
  const ir::Mission& mission = world.mission;
  for (const Refusal& one : refusalsOf(mission, file.commands)) {
    diagnostics.report(support::diagnostics::vehicleRefuses,
                       one.range.valid() ? one.range : beginningOf(mission), one.who, one.command,
                       file.refuser, one.limit, file.limits_at);
  }
  if (file.aborts.overdepth_m) {
    checkDepth(mission, *file.aborts.overdepth_m, file.name, diagnostics);
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
