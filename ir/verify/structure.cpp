// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/structure.h"

#include "ir/core/ops.h"
#include "ir/core/truth.h"

#include <algorithm>
#include <deque>

namespace glider::ir {
namespace {

/// Whether nothing after `c` in its list can fire if its guard is always true. A case of `always`
/// with a target may sometimes not fire.
bool hidesLater(const Case& c, bool always) {
  return !always || !c.target.valid();
}

Moves movesOf(const std::vector<Case>& cases, uint32_t state, bool always,
              const std::vector<Truth>& truths, const std::set<CasePlace>& known_dead) {
  Moves moves;
  Dead from_here = Dead::No;
  for (uint32_t i = 0; i < cases.size(); ++i) {
    const Case& c = cases[i];
    const Truth guard = truths[c.guard.index];
    const bool proved = known_dead.contains({always ? StateId() : StateId{state}, i});
    const Dead dead = guard == Truth::False ? Dead::AlwaysFalse : proved ? Dead::Proved : from_here;
    moves.dead.push_back(dead);
    from_here = guard == Truth::True && hidesLater(c, always) ? Dead::Hidden : from_here;
    if (dead != Dead::No) {
      continue;
    }
    if (c.target.valid()) {
      moves.edges.push_back({state, i, c.target.index, c.transition == Transition::Call, always});
    } else if (c.transition == Transition::Return && !moves.return_case) {
      moves.return_case = i;
    } else if (c.transition == Transition::Exit && !moves.exit_case) {
      moves.exit_case = i;
    }
  }
  return moves;
}

}  // namespace

std::vector<Truth> constantTruths(const Mission& mission) {
  std::vector<Truth> truths(mission.exprs.size(), Truth::Unknown);
  for (size_t i = 0; i < truths.size(); ++i) {
    const Expr& e = mission.exprs[i];
    auto operand = [&](size_t k) { return truths[e.operands.at(k).index]; };
    if (groupOf(e.op) == OpGroup::Truth) {
      truths[i] = truth(e.op == Op::True);
    } else if (groupOf(e.op) == OpGroup::Logic) {
      truths[i] = logical(opIn<LogicOp>(e.op), operand);
    }
  }
  return truths;
}

Structure::Structure(const Mission& of, const std::set<CasePlace>& dead) : mission(of) {
  const std::vector<Truth> truths = constantTruths(mission);
  for (uint32_t s = 0; s < mission.states.size(); ++s) {
    moves.push_back(movesOf(mission.states[s].cases, s, false, truths, dead));
  }
  always = movesOf(mission.always, 0, true, truths, dead);
  arrivals_.resize(std::size(kArrivals) * moves.size());
  nearest_.resize(moves.size());
  explore();
  findRoots();
  findLimits();
}

bool Structure::reached(uint32_t state) const {
  return meetsEmptyStack(state) || at({state, Arrived::Called});
}

const Case& Structure::caseOf(const Edge& edge) const {
  return edge.always ? mission.always[edge.case_index]
                     : mission.states[edge.from].cases[edge.case_index];
}

/// Breadth first, so that the paths are shortest. The targets of the cases of `always` are reached
/// from the start, which every case may interrupt. The last case comes first, so that a state that
/// only these cases lead to is reached with the greatest limit.
void Structure::explore() {
  std::deque<Place> pending = {Place{}};
  arrivals_[index({})].reached = true;
  order.push_back(0);
  while (!pending.empty()) {
    const Place place = pending.front();
    pending.pop_front();
    for (const Edge& edge : moves[place.state].edges) {
      visit(edge, place, pending);
    }
    if (index(place) == index({})) {
      for (size_t i = always.edges.size(); i-- > 0;) {
        if (always.edges[i].to != 0) {
          visit(always.edges[i], place, pending);
        }
      }
    }
  }
}

void Structure::visit(const Edge& edge, Place before, std::deque<Place>& pending) {
  const Arrived by_goto = edge.always ? Arrived::Limited : Arrived::Free;
  const Place next{edge.to, edge.call ? Arrived::Called : by_goto};
  if (at(next)) {
    return;
  }
  if (!reached(edge.to)) {
    order.push_back(edge.to);
    nearest_[edge.to] = next.arrived;
  }
  const Arrival& from = arrivals_[index(before)];
  arrivals_[index(next)] = {true, before, edge, from.steps + 1,
                            from.steps < Path::kFirst ? next : from.early};
  pending.push_back(next);
}

std::optional<uint32_t> Structure::rootLimit(uint32_t state) const {
  if (at({state, Arrived::Free})) {
    return kEndlessLimit;
  }
  return at({state, Arrived::Limited}) ? std::optional(limits_[state]) : std::nullopt;
}

void Structure::findRoots() {
  limits_.resize(size());
  for (const Edge& edge : always.edges) {
    if (!edge.call) {
      limits_[edge.to] = edge.case_index;  // at the end the greatest
    }
  }
  for (uint32_t s : order) {
    if (meetsEmptyStack(s)) {
      highest_roots_.push_back(s);
    }
  }
  auto higher = [&](uint32_t a, uint32_t b) { return *rootLimit(a) > *rootLimit(b); };
  std::ranges::stable_sort(highest_roots_, higher);
  highest_roots_.resize(std::min<size_t>(highest_roots_.size(), 3));
}

std::optional<uint32_t> Structure::otherRoot(uint32_t limit, uint32_t not_this,
                                             uint32_t nor_this) const {
  for (uint32_t root : highest_roots_) {
    if (root != not_this && root != nor_this && *rootLimit(root) > limit) {
      return root;
    }
  }
  return std::nullopt;
}

bool Structure::highRoot(uint32_t state) const {
  return std::ranges::find(highest_roots_, state) != highest_roots_.end();
}

/// A call passes the limit on, so the smallest limit of a state is that of the first case of
/// `always` whose target leads to it by calls.
void Structure::findLimits() {
  lowest_limit_.assign(size(), kEndlessLimit);
  for (const Edge& start : always.edges) {
    if (lowest_limit_[start.to] != kEndlessLimit ||
        !otherRoot(start.case_index, start.to, start.to)) {
      continue;
    }
    std::vector<uint32_t> pending = {start.to};
    lowest_limit_[start.to] = start.case_index;
    while (!pending.empty()) {
      const uint32_t state = pending.back();
      pending.pop_back();
      for (const Edge& edge : moves[state].edges) {
        if (edge.call && lowest_limit_[edge.to] == kEndlessLimit) {
          lowest_limit_[edge.to] = start.case_index;
          pending.push_back(edge.to);
        }
      }
    }
  }
}

bool Structure::deadEnd(uint32_t state) const {
  if (moves[state].leaves()) {
    return false;
  }
  auto leads_away = [&](const Edge& edge) { return edge.to != state; };
  if (!always.exit_case && std::ranges::none_of(always.edges, leads_away)) {
    return true;
  }
  const bool before_all = always.edges.empty() || lowestLimit(state) <= always.edges[0].case_index;
  return before_all && lowestLimit(state) <= always.exit_case.value_or(kEndlessLimit) &&
         lowestLimit(state) != kEndlessLimit;
}

/// The transition that led to a place other than the start.
Edge Structure::edgeTo(Place place) const {
  Edge edge = *arrivals_[index(place)].edge;
  edge.from = arrivals_[index(place)].before.state;
  return edge;
}

Path Structure::pathTo(Place place) const {
  auto back = [&](Place from, size_t steps) {  // the last `steps` transitions that lead to `from`
    std::vector<Edge> edges;
    for (; edges.size() < steps; from = arrivals_[index(from)].before) {
      edges.push_back(edgeTo(from));
    }
    std::ranges::reverse(edges);
    return edges;
  };
  const size_t steps = arrivals_[index(place)].steps;
  const std::vector<Edge> first =
      back(arrivals_[index(place)].early, std::min(steps, Path::kFirst));
  const std::vector<Edge> last = back(place, std::min(steps, Path::kLast));
  Path path;
  path.append(steps, [&](size_t i) {
    return i < first.size() ? first[i] : last[last.size() - (steps - i)];
  });
  return path;
}

}  // namespace glider::ir
