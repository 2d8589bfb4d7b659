// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "analysis/plan/grid.h"
#include "compiler/compilation.h"
#include "platforms/load/board.h"
#include "report/plan/plan.h"
#include "support/result.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace glider::analysis {

/// A way to choose, and how good it is: of two, the one is better whose scores come first in
/// lexicographic order.
struct ScoredPlan {
  size_t number = 0;           ///< in the PlanGrid
  std::vector<double> scores;  ///< of the objectives; the lower, the better
};

/// Scores ways to choose by what the mission prefers, and last by its energy.
class PlanScores {
 public:
  /// `good`: the mission with any values, without errors. Fails if it prefers endurance and its
  /// vehicle's file says too little for it.
  static support::Result<PlanScores> make(const compiler::Compilation& good, const PlanGrid& grid);

  /// Scores the mission with what the way `number` chooses; it has no errors.
  void add(size_t number, const compiler::Compilation& with);
  /// All that were added, the best first; of equal ones, the one with the lowest number first.
  [[nodiscard]] std::vector<ScoredPlan> sorted() const;

  /// What the scores are of. Energy is the last one if the mission does not name it.
  [[nodiscard]] std::vector<report::PlanObjective> objectives() const;
  /// The scores of a plan in the units of `objectives`.
  [[nodiscard]] std::vector<double> shown(const ScoredPlan& plan) const;

 private:
  struct Objective {
    ast::Aim aim = ast::Aim::Endurance;
    std::string text;  ///< of its value
    std::string unit;
    double to_si = 1;
  };
  struct Entry {
    size_t number = 0;
    std::vector<double> values;    ///< of the objectives, SI units; of endurance 0
    std::optional<double> joules;  ///< at most, until it ends; empty: it may not end
    double watts = 0;              ///< at most, on average in a long flight
  };
  PlanScores() = default;

  /// Whether every way has a known end, so that all can be compared by the energy until then.
  [[nodiscard]] bool endsAlways() const;
  [[nodiscard]] double scoreOf(const Entry& entry, size_t objective, bool ends) const;

  std::vector<Objective> objectives_;
  std::optional<platforms::BoardPower> board_;
  std::vector<Entry> entries_;
};

}  // namespace glider::analysis
