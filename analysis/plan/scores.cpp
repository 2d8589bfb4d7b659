// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/plan/scores.h"

#include "compiler/boards.h"
#include "ir/prove/energy/energy_bound.h"
#include "platforms/load/power.h"
#include "support/check.h"
#include "support/diagnostics/ids/command.h"
#include "support/one_line.h"
#include "support/rounded.h"
#include "support/units/units.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace glider::analysis {
namespace {

using support::Result;

/// The unit of the choice that is preferred, or of one of the same dimension, so that it is shown
/// as it is written; else the usual one. A plain number has none, though a choice may be in
/// percent.
std::string unitFor(const std::string& text, const ir::Type& type, const PlanGrid& grid) {
  const auto named = std::ranges::find(grid.rows(), text, &PlanGrid::Row::name);
  if (named != grid.rows().end() || type.dimension.dimensionless()) {
    return named != grid.rows().end() ? named->unit : "";
  }
  for (const PlanGrid::Row& row : grid.rows()) {
    const auto unit = support::parseUnit(row.unit);
    if (unit && unit->dimension == type.dimension) {
      return row.unit;
    }
  }
  return support::unitName(type.dimension);
}

/// What differs by no more than rounding is equal.
double withoutRounding(double score) {
  constexpr int kDigits = 12;
  CHECK(std::isfinite(score), "a score that is not known");
  return support::rounded(score, kDigits);
}

std::optional<ir::prove::EnergyBound> boundOf(const compiler::Checked& checked,
                                              const std::optional<platforms::BoardPower>& board) {
  return ir::prove::energyBoundOf(checked.mission(), checked.worlds.widest.platform, board,
                                  ir::prove::Parameters::AsWritten);
}

}  // namespace

Result<PlanScores> PlanScores::make(const compiler::Compilation& good, const PlanGrid& grid) {
  const compiler::Checked& checked = *good.checked;
  const auto board = compiler::usualBoardPower(checked.worlds.widest.platform);
  if (!board) {
    return std::unexpected(board.error());
  }
  PlanScores made;
  made.board_ = *board;
  for (const frontend::OpenObjective& one : good.open.objectives) {
    const std::string text = support::onOneLine(checked.sources().text(one.range));
    Objective objective{one.aim, text, unitFor(text, one.type, grid), 1};
    const auto unit = support::parseUnit(objective.unit);
    objective.to_si = unit ? unit->to_si : 1;
    made.objectives_.push_back(std::move(objective));
  }
  const bool named = std::ranges::find(made.objectives_, ast::Aim::Endurance, &Objective::aim) !=
                     made.objectives_.end();
  const bool known = boundOf(checked, made.board_).has_value();
  if (named && !known) {
    return support::fail(support::diagnostics::enduranceUnknown, checked.mission().name,
                         checked.platform().name);
  }
  if (!named && known) {
    made.objectives_.push_back({});
  }
  return made;
}

void PlanScores::add(size_t number, const compiler::Compilation& with) {
  Entry entry{number, {}, std::nullopt, 0};
  for (const frontend::OpenObjective& one : with.open.objectives) {
    entry.values.push_back(one.value);
  }
  entry.values.resize(objectives_.size());
  if (const auto bound = boundOf(*with.checked, board_)) {
    entry.joules = bound->joules;
    entry.watts = bound->watts;
  }
  entries_.push_back(std::move(entry));
}

bool PlanScores::endsAlways() const {
  return std::ranges::all_of(entries_, [](const Entry& one) { return one.joules.has_value(); });
}

double PlanScores::scoreOf(const Entry& entry, size_t objective, bool ends) const {
  switch (objectives_[objective].aim) {
    case ast::Aim::Least:
      return entry.values[objective];
    case ast::Aim::Greatest:
      return -entry.values[objective];
    case ast::Aim::Endurance:
      break;
  }
  return ends ? *entry.joules : entry.watts;
}

std::vector<ScoredPlan> PlanScores::sorted() const {
  const bool ends = endsAlways();
  std::vector<ScoredPlan> plans;
  for (const Entry& entry : entries_) {
    ScoredPlan plan{entry.number, {}};
    for (size_t i = 0; i < objectives_.size(); ++i) {
      plan.scores.push_back(withoutRounding(scoreOf(entry, i, ends)));
    }
    plans.push_back(std::move(plan));
  }
  std::ranges::stable_sort(plans, {}, &ScoredPlan::scores);
  return plans;
}

std::vector<report::PlanObjective> PlanScores::objectives() const {
  std::vector<report::PlanObjective> all;
  for (const Objective& one : objectives_) {
    if (one.aim != ast::Aim::Endurance) {
      const char* word = one.aim == ast::Aim::Greatest ? "greatest " : "least ";
      all.push_back({word + one.text, one.text, one.unit, ""});
    } else if (endsAlways()) {
      all.push_back({"endurance", "energy at most", "Wh", "until the mission ends"});
    } else {
      all.push_back({"endurance", "power at most", "W", "on average in a long flight"});
    }
  }
  return all;
}

std::vector<double> PlanScores::shown(const ScoredPlan& plan) const {
  std::vector<double> shown;
  for (size_t i = 0; i < objectives_.size(); ++i) {
    const Objective& one = objectives_[i];
    switch (one.aim) {
      case ast::Aim::Least:
        shown.push_back(plan.scores[i] / one.to_si);
        break;
      case ast::Aim::Greatest:
        shown.push_back(-plan.scores[i] / one.to_si);
        break;
      case ast::Aim::Endurance:
        shown.push_back(endsAlways() ? plan.scores[i] / platforms::kJoulesPerWattHour
                                     : plan.scores[i]);
    }
  }
  return shown;
}

}  // namespace glider::analysis
