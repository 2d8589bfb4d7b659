// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/plan/plan.h"
#include "report/svg/text_lines.h"
#include "support/counted.h"
#include "support/grouped.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::report {
namespace {

/// More rows of a table are not read.
constexpr size_t kMostRows = 12;

/// Lines "label  text", each after the first of a label with its place left blank.
class Lines {
 public:
  void begin(std::string_view label) { label_ = label; }
  void add(const std::string& text) {
    text_ += fmt::format("{:<10}{}\n", label_, text);
    label_ = "";
  }
  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  std::string text_;
  std::string_view label_;
};

using Row = std::vector<std::string>;

/// Columns as wide as their longest cell.
std::vector<std::string> aligned(const std::vector<Row>& rows) {
  std::vector<size_t> widths(rows.front().size());
  for (const Row& row : rows) {
    for (size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], columnsOf(row[i]));
    }
  }
  std::vector<std::string> lines;
  for (const Row& row : rows) {
    std::string line;
    for (size_t i = 0; i < row.size(); ++i) {
      line += row[i] + std::string(widths[i] - columnsOf(row[i]) + 2, ' ');
    }
    lines.push_back(line.substr(0, line.find_last_not_of(' ') + 1));
  }
  return lines;
}

/// Whether an objective is a choice by its name, which has a column already.
bool isChoice(const Plan& plan, const PlanObjective& objective) {
  return std::ranges::find(plan.choices, objective.quantity, &PlanChoice::name) !=
         plan.choices.end();
}

std::vector<Row> frontRows(const Plan& plan) {
  std::vector<Row> rows(1);
  for (const PlanChoice& choice : plan.choices) {
    rows.front().push_back(choice.name);
  }
  for (const PlanObjective& objective : plan.objectives) {
    if (!isChoice(plan, objective)) {
      rows.front().push_back(objective.quantity);
    }
  }
  for (size_t i = 0; i < std::min(plan.front.size(), kMostRows); ++i) {
    Row row = plan.front[i].values;
    for (size_t k = 0; k < plan.objectives.size(); ++k) {
      if (!isChoice(plan, plan.objectives[k])) {
        row.push_back(scoreText(plan.objectives[k], plan.front[i].scores[k]));
      }
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

void tellChosen(const Plan& plan, Lines& lines) {
  lines.begin("chosen");
  for (size_t i = 0; i < plan.choices.size(); ++i) {
    const std::string& before = plan.choices[i].before;
    const std::string& now = plan.chosen->values[i];
    lines.add(fmt::format("{} = {}{}", plan.choices[i].name, now,
                          before.empty() || before == now ? "" : ", before " + before));
  }
  if (plan.promises > 0) {
    lines.begin("proved");
    lines.add(support::counted(plan.promises, "requirement"));
  }
  if (plan.warnings > 0) {
    lines.begin("warned");
    lines.add(support::counted(plan.warnings, "warning") + ": see `glidercc check`");
  }
  lines.begin("preferred");
  for (size_t k = 0; k < plan.objectives.size(); ++k) {
    const PlanObjective& objective = plan.objectives[k];
    const std::string score = scoreText(objective, plan.chosen->scores[k]);
    lines.add(objective.until.empty()
                  ? fmt::format("{}: {}", objective.text, score)
                  : fmt::format("{}: at most {} {}", objective.text, score, objective.until));
  }
}

void tellFront(const Plan& plan, Lines& lines) {
  if (plan.front.size() < 2) {
    return;
  }
  lines.begin("instead");
  const std::vector<std::string> rows = aligned(frontRows(plan));
  for (size_t i = 0; i < rows.size(); ++i) {
    lines.add(rows[i] + (i == 1 ? "  (chosen)" : ""));
  }
  if (plan.front.size() > kMostRows || !plan.whole_front) {
    lines.add(fmt::format(
        "and {}more", plan.whole_front ? fmt::format("{} ", plan.front.size() - kMostRows) : ""));
  }
}

void tellRefused(const Plan& plan, Lines& lines) {
  lines.begin("refused");
  for (const PlanRefusal& one : plan.refused) {
    lines.add(fmt::format("{}: {}", support::counted(one.ways, "way"), one.reason));
    lines.add("  such as " + one.example);
  }
}

}  // namespace

std::string scoreText(const PlanObjective& objective, double score) {
  constexpr double kGrouped = 1000;
  const std::string number =
      std::fabs(score) < kGrouped
          ? fmt::format("{:.4g}", score)
          : (score < 0 ? "-" : "") +
                support::grouped(static_cast<uint64_t>(std::llround(std::fabs(score))));
  return number + (objective.unit.empty() ? "" : " ") + objective.unit;
}

std::string planText(const Plan& plan) {
  Lines lines;
  lines.begin("open");
  for (const PlanChoice& choice : plan.choices) {
    lines.add(fmt::format("{}: {} from {} to {}", choice.name,
                          support::counted(choice.values, "value"), choice.lowest, choice.highest));
  }
  if (plan.chosen) {
    tellChosen(plan, lines);
    tellFront(plan, lines);
  }
  tellRefused(plan, lines);
  return lines.take();
}

}  // namespace glider::report
