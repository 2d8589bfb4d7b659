// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Notes that say what to change where a requirement is not proved. In: the diagnostic that is being
// reported, and the mission or the counterexample; out: notes on that diagnostic. A note about an
// `exit` is added only if the end bound of the mission, with that case moved to the top, is proved;
// so following it helps. Used by `requirements` (GL3111) and violation_report.cpp (GL3110).

#include "ir/prove/requirements/advice.h"

#include "ir/core/ops.h"
#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/abstract/state_depths.h"
#include "ir/prove/abstract/surfacing.h"
#include "ir/prove/context/duration_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace glider::ir::prove {
namespace {

/// More notes would not be read.
constexpr size_t kMostLateExits = 3;

/// A case of `always` or, if it is valid, of a state.
struct LateExit {
  StateId state;
  size_t number = 0;
};

const std::vector<Case>& listOf(const Mission& m, StateId state) {
  return state.valid() ? m[state].cases : m.always;
}

/// It fires from some mission time on, unless a case before it fires.
bool isTimedExit(const Mission& m, const Case& c) {
  const Expr& e = m[c.guard];
  const bool later = e.op == Op::GreaterEqual || e.op == Op::Greater;
  return c.transition == Transition::Exit && later && m[e.operands[0]].op == Op::MissionTime;
}

/// Those that are not the first of their list.
std::vector<LateExit> lateExits(const Mission& m) {
  std::vector<LateExit> found;
  const auto look = [&](StateId state) {
    const std::vector<Case>& cases = listOf(m, state);
    for (size_t i = 1; i < cases.size(); ++i) {
      if (isTimedExit(m, cases[i])) {
        found.push_back({state, i});
      }
    }
  };
  look({});
  for (uint32_t i = 0; i < m.states.size(); ++i) {
    look({i});
  }
  return found;
}

/// Whether the mission ends in time if each of these cases comes first.
bool endsWith(const std::vector<LateExit>& first, double seconds,
              const ProofContext& proof_context) {
  Mission changed = proof_context.mission;
  for (const LateExit& place : first) {
    std::vector<Case>& cases =
        place.state.valid() ? changed.states[place.state.index].cases : changed.always;
    const auto at = cases.begin() + static_cast<std::ptrdiff_t>(place.number);
    std::rotate(cases.begin(), at, at + 1);
  }
  ProofContext context(changed, proof_context.platform);
  context.tick_gap_s = proof_context.tick_gap_s;
  const EndBound end = boundOf(context, kLongestMission, Goal::Exit);
  return end.by && std::ranges::max(end.left_by) <= seconds;
}

}  // namespace

void noteLateExits(support::DiagnosticBuilder& warning, double seconds,
                   const ProofContext& proof_context) {
  std::vector<LateExit> late = lateExits(proof_context.mission);
  if (late.empty() || !endsWith(late, seconds, proof_context)) {
    return;
  }
  for (size_t i = late.size(); i-- > 0 && late.size() > 1;) {
    std::vector<LateExit> fewer = late;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    if (endsWith(fewer, seconds, proof_context)) {
      late = std::move(fewer);
    }
  }
  for (size_t i = 0; i < std::min(late.size(), kMostLateExits); ++i) {
    const Case& c = listOf(proof_context.mission, late[i].state)[late[i].number];
    warning.note(proof_context.mission[c.guard].range,
                 "this `exit` is not tried while a case above it fires; move it to the top");
  }
}

void noteShortSurfacings(support::DiagnosticBuilder& error, const Counterexample& run,
                         const ProofContext& proof_context) {
  const Mission& m = proof_context.mission;
  const platforms::EnvironmentModel& world = proof_context.platform.world;
  const std::vector<double> climbs = climbTimes(proof_context);
  const std::vector<double> depths = deepestByState(proof_context);
  std::vector<bool> noted(m.states.size(), false);
  const auto left = [&](StateId state, double stay, double depth) {
    const double climb = climbs[state.index];
    if (noted[state.index] || !std::isfinite(climb) || stay >= climb ||
        !(depth > world.surface_depth_m)) {
      return;
    }
    noted[state.index] = true;
    const double reading = world.surface_depth_m - world.depth_error_m;
    const std::string sensor = proof_context.depth && reading > 0
                                   ? fmt::format(", or leave it only when `{} < {:.3g} m`",
                                                 m[*proof_context.depth].name, reading)
                                   : "";
    error.note(m[state].range,
               fmt::format("`{}` is left after {}, but the climb from {:.4g} m may take {}: stay "
                           "that long{}",
                           m[state].name, durationOf(stay), depths[state.index], durationOf(climb),
                           sensor));
  };
  double since = 0;
  for (size_t i = 1; i < run.ticks.size(); ++i) {
    const ConcreteTick& before = run.ticks[i - 1];
    const ConcreteTick& now = run.ticks[i];
    if (now.state != before.state) {
      left(before.state, now.mission_time - since, now.depth);
      since = now.mission_time;
    }
  }
}

}  // namespace glider::ir::prove
