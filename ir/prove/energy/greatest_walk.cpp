// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/energy/greatest_walk.h"

#include <cmath>
#include <limits>
#include <utility>

namespace glider::ir::prove {
namespace {

constexpr size_t kNone = std::numeric_limits<size_t>::max();
constexpr double kUnreached = -std::numeric_limits<double>::infinity();
/// A difference of less is that of rounding: of the joules that are compared.
constexpr double kRounding = 1e-9;

}  // namespace

/// The greatest walk to each vertex, by Bellman and Ford.
struct EnergyGraph::Search {
  std::vector<double> best;  ///< energy less the price of the time, J
  std::vector<size_t> by;    ///< the last arc of that walk; none at the start
  std::vector<size_t> use;   ///< which of its uses
  size_t in_cycle = kNone;   ///< a vertex behind a cycle that never ends to raise it
};

EnergyGraph::EnergyGraph(size_t vertices, std::vector<EnergyArc> arcs, Joules joules)
    : vertices_(vertices), arcs_(std::move(arcs)), joules_(std::move(joules)) {
  for (const EnergyArc& arc : arcs_) {
    std::vector<double>& each = joules_of_.emplace_back();
    for (const EnergyUse& use : arc.uses) {
      each.push_back(joules_(use));
    }
  }
  // Newton's method: each cycle that is found takes more for its time than the one before.
  while (const auto above = cycleAbove(power_)) {
    const double power = joules_(above->use) / above->use.seconds;
    if (!(power > power_)) {
      break;
    }
    cycle_ = *above;
    power_ = power;
  }
}

size_t EnergyGraph::bestUse(const EnergyArc& arc, double power) const {
  const std::vector<double>& each = joules_of_[static_cast<size_t>(&arc - arcs_.data())];
  size_t best = 0;
  for (size_t i = 1; i < each.size(); ++i) {
    const auto worth = [&](size_t k) { return each[k] - power * arc.uses[k].seconds; };
    best = worth(i) > worth(best) ? i : best;
  }
  return best;
}

EnergyGraph::Search EnergyGraph::search(double power) const {
  Search found{std::vector<double>(vertices_, kUnreached), std::vector<size_t>(vertices_, kNone),
               std::vector<size_t>(vertices_, 0), kNone};
  std::vector<size_t> use;
  std::vector<double> worth;
  for (size_t i = 0; i < arcs_.size(); ++i) {
    use.push_back(bestUse(arcs_[i], power));
    worth.push_back(joules_of_[i][use.back()] - power * arcs_[i].uses[use.back()].seconds);
  }
  found.best[0] = 0;
  for (size_t round = 0; round <= vertices_; ++round) {
    found.in_cycle = kNone;
    for (size_t i = 0; i < arcs_.size(); ++i) {
      const double sum = found.best[arcs_[i].from] + worth[i];
      double& known = found.best[arcs_[i].to];
      const double raised =
          known == kUnreached ? known : known + kRounding * (1 + std::fabs(known));
      if (sum > raised) {
        known = sum;
        found.by[arcs_[i].to] = i;
        found.use[arcs_[i].to] = use[i];
        found.in_cycle = arcs_[i].to;
      }
    }
    if (found.in_cycle == kNone) {
      break;
    }
  }
  return found;
}

std::optional<EnergyGraph::Cycle> EnergyGraph::around(const Search& found) const {
  size_t at = found.in_cycle;
  for (size_t i = 0; i < vertices_ && at != kNone; ++i) {  // back into the cycle itself
    at = found.by[at] == kNone ? kNone : arcs_[found.by[at]].from;
  }
  if (at == kNone) {
    return std::nullopt;
  }
  const size_t first = at;
  Cycle cycle;
  do {
    cycle.use = cycle.use + arcs_[found.by[at]].uses[found.use[at]];
    at = arcs_[found.by[at]].from;
    cycle.vertices.push_back(at);
  } while (at != first);
  return cycle;
}

std::optional<EnergyGraph::Cycle> EnergyGraph::cycleAbove(double power) const {
  const Search found = search(power);
  return found.in_cycle == kNone ? std::nullopt : around(found);
}

EnergyUse EnergyGraph::greatestWalk(double power) const {
  const Search found = search(power);
  size_t end = 0;
  for (size_t i = 0; i < vertices_; ++i) {
    end = found.best[i] > found.best[end] ? i : end;
  }
  EnergyUse sum;
  for (size_t steps = 0; found.by[end] != kNone && steps <= vertices_; ++steps) {
    sum = sum + arcs_[found.by[end]].uses[found.use[end]];
    end = arcs_[found.by[end]].from;
  }
  return sum;
}

}  // namespace glider::ir::prove
