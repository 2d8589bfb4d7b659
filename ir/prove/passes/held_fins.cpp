// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The pass `heldFins`: states that hold the fin hard over to one side for hours (GL3142). In: the
// interval of each angle, and the longest stay in the state by its clocks (stayOf). Certain: all
// commands about the heading that the state may give hold the fin there. A hint: readings may end
// the state sooner, and a command with an unknown argument changes nothing.

#include "ir/prove/abstract/bounds_by_state.h"
#include "ir/prove/abstract/leaving.h"
#include "ir/prove/context/commands.h"
#include "ir/prove/context/duration_text.h"
#include "ir/prove/passes.h"
#include "support/diagnostics/ids/verification.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

namespace glider::ir::prove {
namespace {

/// s; a spiral to 200 m and back takes less.
constexpr double kLong = 2 * 3600;
/// Of the fin's range; beyond it the fin is hard over.
constexpr double kHardOver = 0.9;

/// The fin's angle nearest to the middle that the state may command; none if it may command less
/// than hard over, either side, more than there is (GL3104), or anything else about the heading.
std::optional<double> heldAt(const ProofContext& context, const State& state) {
  const double hard_over = kHardOver * context.platform.envelope.fin_rad;
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (const Statement* command : commandsOf(context.mission, state)) {
    if (isVertical(command->command)) {
      continue;
    }
    if (command->command != Command::Fin) {
      return std::nullopt;
    }
    const Interval& angle = context.intervals[command->values.at(0).index];
    least = std::min(least, angle.empty ? HUGE_VAL : angle.lowest);
    most = std::max(most, angle.empty ? -HUGE_VAL : angle.highest);
  }
  const bool one_side = least <= most && (least >= hard_over || most <= -hard_over) &&
                        std::max(least, -most) <= context.platform.envelope.fin_rad;
  return one_side ? std::optional(least > 0 ? least : most) : std::nullopt;
}

/// Whether code in C may steer the state too.
bool steersInC(const Mission& m, const State& state) {
  return !m[state.profile.behaviour].symbol.empty() || !m[state.route.behaviour].symbol.empty();
}

}  // namespace

void passes::heldFins(Proof& proof) {
  const ProofContext& context = proof.proof_context;
  const Mission& m = context.mission;
  const Interruptions always{neverPrevented(m), false};
  for (const State& state : m.states) {
    const std::optional<double> angle = heldAt(context, state);
    if (!angle || steersInC(m, state)) {
      continue;
    }
    const double stay = stayOf(context, state, always, anyValues(m)).by;
    if (stay > kLong) {
      proof.diagnostics.report(support::diagnostics::finHardOver, state.route.range, state.name,
                               fmt::format("{:.4g} deg", *angle * 180 / std::numbers::pi),
                               std::isfinite(stay) && stay < kLongestMission
                                   ? "for up to " + durationOf(stay)
                                   : "with no bound by the clock");
    }
  }
}

}  // namespace glider::ir::prove
