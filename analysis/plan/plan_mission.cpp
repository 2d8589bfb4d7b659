// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/plan/plan_mission.h"

#include "analysis/plan/front.h"
#include "analysis/plan/grid.h"
#include "analysis/plan/refusals.h"
#include "analysis/plan/scores.h"
#include "support/counted.h"
#include "support/diagnostics/ids/command.h"
#include "support/grouped.h"
#include "support/one_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <variant>

namespace glider::analysis {
namespace {

using support::Result;

/// More of the front is not checked.
constexpr size_t kMostOfFront = 40;

/// Receives nothing of thousands of checks.
class Silent final : public CheckObserver {};

class Planner {
 public:
  /// `compiled`: with no value written in any line `choose`.
  Planner(const std::string& name, compiler::Compilation compiled, const CheckOptions& options,
          CheckObserver& observer)
      : compiled_(std::move(compiled)),
        options_(options),
        observer_(observer),
        open_(compiled_.open),
        grid_(open_.choices),
        refused_(*compiled_.sources) {
    found_.plan.path = name;
  }

  Result<PlannedMission> run() {
    if (auto possible = countWays(); !possible) {
      return std::unexpected(possible.error());
    }
    auto scored = scoreAll();
    if (!scored) {
      return std::unexpected(scored.error());
    }
    const auto chosen = findBest();
    if (!chosen) {
      return std::unexpected(chosen.error());
    }
    if (*chosen) {
      found_.plan.chosen = optionOf(**chosen);
      refused_.takeLast(false);
      found_.plan.warnings = proved_.at((*chosen)->number);
      write(grid_.at((*chosen)->number));
      if (auto drawn = findFront(); !drawn) {
        return std::unexpected(drawn.error());
      }
    }
    found_.plan.refused = refused_.sorted();
    return std::move(found_);
  }

 private:
  Result<void> countWays() {
    if (open_.choices.empty()) {
      return support::fail(support::diagnostics::nothingToPlan, found_.plan.path);
    }
    for (size_t i = 0; i < open_.choices.size(); ++i) {
      const PlanGrid::Row& row = grid_.rows()[i];
      const auto text = [&](double value) { return compiler::textOf({row.name, value, row.unit}); };
      const bool written = open_.choices[i].written.begin != open_.choices[i].written.end;
      found_.plan.choices.push_back(
          {row.name, row.values.size(), text(row.values.front()), text(row.values.back()),
           written ? support::onOneLine(compiled_.sources->text(open_.choices[i].written)) : ""});
    }
    if (grid_.count() > static_cast<double>(kMostPlans)) {
      return support::fail(support::diagnostics::tooManyPlans, support::atMost(grid_.count()),
                           support::grouped(kMostPlans));
    }
    found_.plan.ways = static_cast<size_t>(grid_.count());
    return {};
  }

  /// The mission with what way `number` chooses.
  [[nodiscard]] compiler::Compilation with(size_t number) const {
    return compiler::withChosen(compiled_, grid_.at(number));
  }

  Result<void> scoreAll() {
    for (size_t i = 0; i < found_.plan.ways; ++i) {
      observer_.at(fmt::format("trying {} of {}", i + 1,
                               support::counted(found_.plan.ways, "way") + " to choose"));
      const compiler::Compilation one = with(i);
      if (!one.checked) {
        refused_.add(i, inWords(i), one.diagnostics.sorted());
        continue;
      }
      if (auto noted = noteCommon(one); !noted) {
        return noted;
      }
      scores_->add(i, one);
      ++found_.plan.possible;
    }
    refused_.takeLast(true);
    if (scores_) {
      plans_ = scores_->sorted();
      found_.plan.objectives = scores_->objectives();
    }
    return {};
  }

  /// Notes what the ways have in common, of the first one without errors.
  Result<void> noteCommon(const compiler::Compilation& good) {
    if (scores_) {
      return {};
    }
    found_.plan.mission = good.lowered->mission.name;
    found_.plan.promises = good.lowered->mission.requirements.size();
    auto scores = PlanScores::make(good, grid_);
    if (!scores) {
      return std::unexpected(scores.error());
    }
    scores_ = std::move(*scores);
    return {};
  }

  /// The best that is proved; empty: there is none.
  Result<std::optional<ScoredPlan>> findBest() {
    for (const ScoredPlan& plan : plans_) {
      const auto good = isProved(plan);
      if (!good) {
        return std::unexpected(good.error());
      }
      if (*good) {
        return plan;
      }
    }
    return std::nullopt;
  }

  /// Those that no other beats in all that is preferred, and that are proved: the chosen one is
  /// the first, since none that is left comes before it.
  Result<void> findFront() {
    std::vector<ScoredPlan> front;
    bool changed = true;
    while (changed) {
      changed = false;
      std::erase_if(plans_, [&](const ScoredPlan& one) { return refused_.contains(one.number); });
      front = frontOf(plans_);
      for (const ScoredPlan& one : front) {
        if (proved_.size() >= kMostOfFront && !proved_.contains(one.number)) {
          found_.plan.whole_front = false;
          continue;
        }
        const auto good = isProved(one);
        if (!good) {
          return std::unexpected(good.error());
        }
        changed = changed || !*good;
      }
    }
    for (const ScoredPlan& one : front) {
      if (proved_.contains(one.number)) {
        found_.plan.front.push_back(optionOf(one));
      }
    }
    return {};
  }

  void tellOf(size_t number) {
    const std::string done =
        found_.plan.chosen ? support::counted(proved_.size(), "way") + " proved"
                           : fmt::format("{} refused, {} left", support::grouped(refused_.count()),
                                         support::grouped(found_.plan.ways - refused_.count()));
    observer_.at(fmt::format("proving what is required, with {} ({})", inWords(number), done));
  }

  /// Whether a check of the mission with these values has no error, and proves all that is
  /// required.
  Result<bool> isProved(const ScoredPlan& plan) {
    if (proved_.contains(plan.number) || refused_.contains(plan.number)) {
      return proved_.contains(plan.number);
    }
    tellOf(plan.number);
    Silent silent;
    const CheckedFile file =
        checkCompilation(found_.plan.path, with(plan.number), options_, silent);
    if (file.found.failure) {
      return std::unexpected(*file.found.failure);
    }
    for (const report::JudgedRequirement& one : file.found.requirements) {
      if (one.verdict != "proved") {
        refused_.add(plan.number, inWords(plan.number),
                     fmt::format("`{}` {}", one.text,
                                 one.verdict == "refuted" ? "may be broken" : "stays undecided"),
                     one.reason);
        return false;
      }
    }
    if (!file.found.ok()) {
      refused_.add(plan.number, inWords(plan.number), file.found.diagnostics);
      return false;
    }
    proved_[plan.number] = static_cast<size_t>(std::ranges::count(
        file.found.diagnostics, support::Severity::Warning, &support::Diagnostic::severity));
    return true;
  }

  /// "bottom = 60 m, hours = 44 h"
  [[nodiscard]] std::string inWords(size_t number) const {
    std::vector<std::string> parts;
    for (const compiler::ChosenValue& one : grid_.at(number)) {
      parts.push_back(one.name + " = " + compiler::textOf(one));
    }
    return fmt::format("{}", fmt::join(parts, ", "));
  }

  [[nodiscard]] report::PlanOption optionOf(const ScoredPlan& plan) const {
    report::PlanOption option;
    for (const compiler::ChosenValue& one : grid_.at(plan.number)) {
      option.values.push_back(compiler::textOf(one));
    }
    option.scores = scores_->shown(plan);
    return option;
  }

  /// Puts `values` into the text of the mission.
  void write(const std::vector<compiler::ChosenValue>& values) {
    std::vector<std::pair<support::SourceRange, std::string>> places;
    for (size_t i = 0; i < values.size(); ++i) {
      const support::SourceRange& place = open_.choices[i].written;
      const std::string text = compiler::textOf(values[i]);
      places.emplace_back(place, place.begin == place.end ? " = " + text : text);
    }
    std::ranges::sort(places, std::ranges::greater(),
                      [](const auto& one) { return one.first.begin; });
    found_.text = compiled_.sources->text(places.front().first.file);
    for (const auto& [place, text] : places) {
      found_.text.replace(place.begin, place.end - place.begin, text);
    }
  }

  const compiler::Compilation compiled_;
  const CheckOptions& options_;
  CheckObserver& observer_;
  const frontend::LeftOpen& open_;
  const PlanGrid grid_;
  std::optional<PlanScores> scores_;
  std::vector<ScoredPlan> plans_;  ///< the best first
  PlanRefusals refused_;
  std::map<size_t, size_t> proved_;  ///< how many warnings each has
  PlannedMission found_;
};

}  // namespace

bool isPlannable(const compiler::Compilation& compiled) {
  if (!compiled.parsed || compiled.parsed->faulty) {
    return false;
  }
  const auto lines = std::ranges::count_if(compiled.parsed->mission.items, [](const auto& item) {
    return std::holds_alternative<ast::Choice>(item);
  });
  const compiler::Compilation open = compiler::withChosen(compiled, {});
  return static_cast<size_t>(lines) == open.open.choices.size() && (lines > 0 || open.checked);
}

Result<PlannedMission> planMission(const std::string& name, const compiler::Compilation& compiled,
                                   const CheckOptions& options, CheckObserver& observer) {
  return Planner(name, compiler::withChosen(compiled, {}), options, observer).run();
}

}  // namespace glider::analysis
