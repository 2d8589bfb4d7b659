// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The pass `legTimes`: waypoints that their state has no time to reach from the nearest other
// waypoint. In: the end bound and the fixed positions that are commanded. Out: lines of the report.
// A hint: a waypoint may be meant as a direction, and the vehicle may come from elsewhere or be
// carried by a current.

#include "ir/prove/context/commands.h"
#include "ir/prove/context/duration_text.h"
#include "ir/prove/geometry/nearest.h"
#include "ir/prove/passes.h"
#include "support/units/position_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace glider::ir::prove {
namespace {

/// The one place that a state steers to, if it is fixed.
std::optional<Position> waypointOf(const Mission& m, const State& state) {
  std::optional<Position> found;
  for (const Statement* command : commandsOf(m, state)) {
    if (isVertical(command->command)) {
      continue;
    }
    const auto place = fixedTarget(m, *command);
    if (!place || (found && *found != *place)) {
      return std::nullopt;
    }
    found = place;
  }
  return found;
}

/// The mission time, s, before which the condition is not true, according to the clock alone.
// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
double earliest(const Mission& m, ExprId id) {
  const Expr& e = m[id];
  if (e.op == Op::And) {
    return std::max(earliest(m, e.operands[0]), earliest(m, e.operands[1]));
  }
  if (e.op == Op::Or) {
    return std::min(earliest(m, e.operands[0]), earliest(m, e.operands[1]));
  }
  const bool later = (e.op == Op::GreaterEqual || e.op == Op::Greater) &&
                     m[e.operands[0]].op == Op::MissionTime && m[e.operands[1]].op == Op::Constant;
  return later ? m[e.operands[1]].number : 0;
}

/// For each state: the mission time, s, before which nothing enters it.
std::vector<double> entriesOf(const Mission& m) {
  std::vector<double> entered(m.states.size(), kLongestMission);
  entered.front() = 0;
  const auto look = [&](const std::vector<Case>& cases) {
    for (const Case& c : cases) {
      if (c.target.valid()) {
        double& time = entered[c.target.index];
        time = std::min(time, earliest(m, c.guard));
      }
    }
  };
  look(m.always);
  for (const State& each : m.states) {
    look(each.cases);
  }
  return entered;
}

/// Every fixed place that the mission steers to.
std::vector<Position> waypointsOf(const Mission& m) {
  std::vector<Position> found;
  const auto add = [&](const std::vector<const Statement*>& commands) {
    for (const Statement* command : commands) {
      if (const auto place = fixedTarget(m, *command)) {
        found.push_back(*place);
      }
      const std::vector<Position> path = pathTargets(m, *command);
      found.insert(found.end(), path.begin(), path.end());
    }
  };
  add(commandsOfAlways(m));
  for (const State& state : m.states) {
    add(commandsOf(m, state));
  }
  return found;
}

/// Reports a state that is current for at most `stay` seconds.
void tellIfTooFar(Proof& proof, const State& state, double nearest, double stay) {
  const double way = proof.proof_context.platform.world.through_water_m_s * stay;
  if (way <= 0 || way >= nearest) {
    return;
  }
  proof.findings.lines.push_back(
      {state.range,
       fmt::format("`{}` cannot reach its waypoint in time: the nearest other one is {} away, "
                   "and in {} the vehicle covers at most {} without a current",
                   state.name, support::lengthText(nearest), durationOf(stay),
                   support::lengthText(way))});
}

}  // namespace

/// A waypoint may be one to steer to for a while and never reach, so these are not errors. The
/// vehicle's position when control is given is not known, so only ways from another waypoint are
/// checked.
void passes::legTimes(Proof& proof) {
  const Mission& m = proof.proof_context.mission;
  if (!proof.options.report || !proof.ending.boundWithoutPowerCuts().by) {
    return;
  }
  const PlaceIndex waypoints(waypointsOf(m));
  const std::vector<double> entered = entriesOf(m);
  for (size_t i = 0; i < m.states.size(); ++i) {
    const auto place = waypointOf(m, m.states[i]);
    const double nearest =
        place ? waypoints.nearestOther(*place) : std::numeric_limits<double>::infinity();
    if (std::isfinite(nearest)) {
      tellIfTooFar(proof, m.states[i], nearest,
                   proof.ending.boundWithoutPowerCuts().left_by[i] - entered[i]);
    }
  }
}

}  // namespace glider::ir::prove
