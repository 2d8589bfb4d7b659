// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/structure.h"

#include "ir/core/truth.h"

#include <algorithm>
#include <deque>

namespace glider::ir {
namespace {

/// What is true or false whatever the sensors and clocks say; Unknown stands for everything else.
std::vector<Truth> constantTruths(const Mission& mission) {
  std::vector<Truth> truths(mission.exprs.size(), Truth::Unknown);
  for (size_t i = 0; i < truths.size(); ++i) {
    const Expr& e = mission.exprs[i];
    auto operand = [&](size_t k) { return truths[e.operands.at(k).index]; };
    switch (e.op) {
      case Op::True:
        truths[i] = Truth::True;
        break;
      case Op::False:
        truths[i] = Truth::False;
        break;
      case Op::Not:
        truths[i] = logicalNot(operand(0));
        break;
      case Op::And:
        truths[i] = logicalAnd(operand(0), operand(1));
        break;
      case Op::Or:
        truths[i] = logicalOr(operand(0), operand(1));
        break;
      default:
        break;
    }
  }
  return truths;
}

Moves movesOf(const Mission& mission, uint32_t state, const std::vector<Truth>& truths) {
  Moves moves;
  Dead from_here = Dead::No;
  const std::vector<Case>& cases = mission.states[state].cases;
  for (uint32_t i = 0; i < cases.size(); ++i) {
    const Case& c = cases[i];
    const Truth guard = truths[c.guard.index];
    const Dead dead = guard == Truth::False ? Dead::AlwaysFalse : from_here;
    moves.dead.push_back(dead);
    from_here = guard == Truth::True ? Dead::Hidden : from_here;
    if (dead != Dead::No) {
      continue;
    }
    if (c.target.valid()) {
      moves.edges.push_back({state, i, c.target.index, c.transition == Transition::Call});
    } else if (c.transition == Transition::Return && !moves.return_case) {
      moves.return_case = i;
    } else if (c.transition == Transition::Exit && !moves.exit_case) {
      moves.exit_case = i;
    }
  }
  return moves;
}

}  // namespace

Structure::Structure(const Mission& of) : mission(of) {
  const std::vector<Truth> truths = constantTruths(mission);
  for (uint32_t s = 0; s < mission.states.size(); ++s) {
    moves.push_back(movesOf(mission, s, truths));
  }
  arrivals_.resize(2 * moves.size());
  nearest_called_.resize(moves.size());
  explore();
}

/// Breadth first, so that the paths are shortest.
void Structure::explore() {
  std::deque<Place> pending = {Place{}};
  arrivals_[index({})].reached = true;
  order.push_back(0);
  while (!pending.empty()) {
    const Place place = pending.front();
    pending.pop_front();
    for (const Edge& edge : moves[place.state].edges) {
      const Place next{edge.to, edge.call};
      if (at(next)) {
        continue;
      }
      if (!reached(edge.to)) {
        order.push_back(edge.to);
        nearest_called_[edge.to] = edge.call;
      }
      arrivals_[index(next)] = {true, place, edge};
      pending.push_back(next);
    }
  }
}

std::vector<Edge> Structure::pathTo(Place place) const {
  std::vector<Edge> path;
  for (const Arrival* a = &arrivals_[index(place)]; a->edge; a = &arrivals_[index(a->before)]) {
    path.push_back(*a->edge);
  }
  std::ranges::reverse(path);
  return path;
}

}  // namespace glider::ir
