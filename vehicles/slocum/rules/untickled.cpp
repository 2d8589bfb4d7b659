// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/rules/untickled.h"

#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/abstract/shallowest_command.h"
#include "ir/prove/abstract/surfacing.h"
#include "ir/prove/context/duration_text.h"
#include "support/diagnostics/ids/verification.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace glider::slocum::rules {
namespace {

using ir::prove::ProofContext;

/// How long the mission may stay under water, s; none: no bound is known.
std::optional<double> longestStay(const ProofContext& context) {
  const auto end = ir::prove::boundOf(context, ir::prove::kLongestMission, ir::prove::Goal::Exit);
  return ir::prove::longestSubmersion(context, end, ir::prove::kLongestMission);
}

bool commandsTheSurface(const ProofContext& context) {
  const ir::prove::ShallowestCommands commands(context);
  for (uint32_t i = 0; i < context.mission.states.size(); ++i) {
    const auto shallowest = commands.of(ir::StateId{i});
    if (!shallowest || shallowest->target_m <= context.platform.world.surface_depth_m) {
      return true;
    }
  }
  return false;
}

/// Whether a behaviour above hookbeh (any, if there is none) brings the vehicle up before `limit`
/// has passed.
bool comesUpByItself(std::span<const Layer> layers, double limit, double climb) {
  const auto hookbeh = std::ranges::find(layers, Role::Hookbeh, &Layer::role);
  return std::any_of(layers.begin(), hookbeh, [&](const Layer& layer) {
    return layer.role == Role::Surfaces && layer.start == Start::InTime &&
           layer.starts_within_s + climb <= limit;
  });
}

}  // namespace

void checkUntickled(const ir::WrittenWorld& world, const VehicleFile& file,
                    std::span<const Layer> layers, support::DiagnosticEngine& diagnostics) {
  const platforms::EnvironmentModel& sea = world.platform.world;
  const double climb = sea.turn_s + file.guards.greatest_depth_m / sea.slowest_climb_m_s;
  if (!file.aborts.untickled_s || comesUpByItself(layers, *file.aborts.untickled_s, climb)) {
    return;
  }
  const ProofContext context = ProofContext(world).withoutPowerCuts();
  const std::optional<double> stay = longestStay(context);
  const bool surfaces = commandsTheSurface(context);
  if (stay ? *stay <= *file.aborts.untickled_s : surfaces) {
    return;
  }
  const std::string limit =
      fmt::format("abend allows {} without a fix or contact (no_cop_tickle_for in {})",
                  ir::prove::durationOf(*file.aborts.untickled_s), file.name);
  const std::string how_long = stay ? "for " + ir::prove::durationOf(*stay) : "without a limit";
  diagnostics.report(
      stay && !surfaces ? support::diagnostics::vehicleAborts : support::diagnostics::mayNotFollow,
      world.mission.states.front().range,
      fmt::format("the mission may stay under water {}, and {}", how_long, limit),
      "come to the surface in time, or raise no_cop_tickle_for");
}

}  // namespace glider::slocum::rules
