// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/eval/arithmetic.h"
#include "ir/prove/duration_text.h"
#include "ir/prove/orders.h"
#include "ir/prove/passes.h"

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
  for (const Statement* order : ordersOf(m, state.route)) {
    const auto place = fixedTarget(m, *order);
    if (!place || (found && *found != *place)) {
      return std::nullopt;
    }
    found = place;
  }
  return found;
}

/// Before this mission time, s, the condition is not true: what it says of the clock alone.
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

/// Of each state: before this mission time, s, nothing enters it.
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

/// m from a place to the nearest other one; infinite if there is none.
double nearestOther(const Position& place, const std::vector<std::optional<Position>>& places) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& other : places) {
    const bool another = other && *other != place;
    nearest = another ? std::min(nearest, onEarth(Op::Distance, place, *other)) : nearest;
  }
  return nearest;
}

/// Of a state that is current for `stay` seconds at most.
void tellIfTooFar(Proof& proof, const State& state, double nearest, double stay) {
  const double way = proof.ground.platform.world.through_water_m_s * stay;
  if (way <= 0 || way >= nearest) {
    return;
  }
  proof.findings.lines.push_back(
      {state.range,
       fmt::format("`{}` has no time for its waypoint: {:.0f} m from the nearest other one, and "
                   "in {} it gets on by {:.0f} m at most, without a current",
                   state.name, nearest, durationOf(stay), way)});
}

}  // namespace

/// A waypoint may be meant to be steered to for a while and never reached, so these are no
/// mistakes. Where the vehicle is when control is given is not known, so only ways from another
/// waypoint are looked at.
void passes::legTimes(Proof& proof) {
  const Mission& m = proof.ground.mission;
  std::vector<std::optional<Position>> places;
  for (const State& state : m.states) {
    places.push_back(waypointOf(m, state));
  }
  const bool some = std::ranges::count_if(places, [](const auto& p) { return p.has_value(); }) > 1;
  if (!proof.options.report || !some || !proof.ending.boundWithoutPowerCuts().by) {
    return;
  }
  const std::vector<double> entered = entriesOf(m);
  for (size_t i = 0; i < m.states.size(); ++i) {
    const double nearest =
        places[i] ? nearestOther(*places[i], places) : std::numeric_limits<double>::infinity();
    if (std::isfinite(nearest)) {
      tellIfTooFar(proof, m.states[i], nearest,
                   proof.ending.boundWithoutPowerCuts().left_by[i] - entered[i]);
    }
  }
}

}  // namespace glider::ir::prove
