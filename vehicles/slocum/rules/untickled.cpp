// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/rules/untickled.h"

#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/abstract/shallowest_command.h"
#include "ir/prove/abstract/state_depths.h"
#include "ir/prove/abstract/surfacing.h"
#include "ir/prove/context/duration_text.h"
#include "support/diagnostics/ids/verification.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace glider::slocum::rules {
namespace {

using ir::prove::ProofContext;

/// At the surface, until the GPS has a fix, s: the longest in the logs of real vehicles.
constexpr double kFix_s = 106;

/// How long the mission may stay under water, s; none: no bound is known.
std::optional<double> longestStay(const ProofContext& context) {
  const auto end = ir::prove::boundOf(context, ir::prove::kLongestMission, ir::prove::Goal::Exit);
  return ir::prove::longestSubmersion(context, end, ir::prove::kLongestMission);
}

/// Or a depth from which it may coast to the surface.
bool commandsTheSurface(const ProofContext& context) {
  constexpr double kCoasts_m = 1.5;
  const ir::prove::ShallowestCommands commands(context);
  for (uint32_t i = 0; i < context.mission.states.size(); ++i) {
    const auto shallowest = commands.of(ir::StateId{i});
    if (!shallowest || shallowest->target_m <= context.platform.world.surface_depth_m + kCoasts_m) {
      return true;
    }
  }
  return false;
}

/// The slowest climb from where the mission dives to, s.
double climbOf(const ProofContext& context) {
  const platforms::EnvironmentModel& sea = context.platform.world;
  const double deepest = std::min(std::ranges::max(ir::prove::deepestByState(context)),
                                  context.platform.envelope.greatest_depth_m);
  return sea.command_delay_s + sea.turn_s + deepest / sea.slowest_climb_m_s;
}

/// Whether one of the behaviours above hookbeh (any, if there is none) surfaces and `does`.
template <typename Does>
bool anyAbove(std::span<const Layer> layers, Does does) {
  const auto hookbeh = std::ranges::find(layers, Role::Hookbeh, &Layer::role);
  return std::any_of(layers.begin(), hookbeh, [&](const Layer& layer) {
    return layer.role == Role::Surfaces && does(layer);
  });
}

}  // namespace

void checkUntickled(const ir::WrittenWorld& world, const VehicleFile& file,
                    std::span<const Layer> layers, support::DiagnosticEngine& diagnostics) {
  if (!file.aborts.untickled_s) {
    return;
  }
  const double limit = *file.aborts.untickled_s;
  const ProofContext context = ProofContext(world).withoutPowerCuts();
  const double up = climbOf(context) + kFix_s;
  if (anyAbove(layers, [&](const Layer& layer) {
        return layer.start == Start::InTime && layer.starts_within_s + up <= limit;
      })) {
    return;
  }
  const std::optional<double> stay = longestStay(context);
  // It counts from the beginning of the vehicle's mission on, and still after an exit.
  const double before = std::max(0.0, file.guards.start_secs);
  if (stay && before + *stay + up <= limit) {
    return;
  }
  const bool surely =
      stay && *stay > limit && !commandsTheSurface(context) &&
      !anyAbove(layers, [](const Layer& layer) { return layer.start == Start::Uncertain; });
  const std::string how_long =
      !stay ? "nothing shows how long the mission stays under water"
            : fmt::format("the mission may stay under water for {}{}", ir::prove::durationOf(*stay),
                          *stay > limit ? "" : ", and then climb until it has a fix");
  diagnostics.report(
      surely ? support::diagnostics::vehicleAborts : support::diagnostics::mayNotFollow,
      world.mission.states.front().range,
      fmt::format("{}, and abend allows {} without a fix or contact (no_cop_tickle_for in {})",
                  how_long, ir::prove::durationOf(limit), file.name),
      "come to the surface in time, or raise no_cop_tickle_for");
}

}  // namespace glider::slocum::rules
