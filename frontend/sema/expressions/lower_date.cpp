// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/evaluate.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>

namespace glider::frontend {

namespace {

constexpr double kYear_s = 365.25 * 86400;

/// A whole number of at most four digits.
std::optional<int> wholeNumber(const ast::Expr& expr) {
  constexpr size_t kMostDigits = 4;
  const auto* literal = std::get_if<ast::Literal>(&expr.node);
  if (literal == nullptr || !literal->unit.empty() || literal->digits.size() > kMostDigits ||
      literal->digits.find_first_not_of("0123456789") != std::string::npos) {
    return std::nullopt;
  }
  int value = 0;
  std::from_chars(literal->digits.data(), literal->digits.data() + literal->digits.size(), value);
  return value;
}

/// "2026-11-25T00:00Z", in backquotes; empty: there is no such day.
std::string instantText(int year, int month, int day) {
  const std::chrono::year_month_day date{std::chrono::year(year),
                                         std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  if (!date.ok()) {
    return {};
  }
  return fmt::format("`{:04}-{:02}-{:02}T00:00Z`", year, month, day);
}

bool isYear(int number) {
  return number >= 1970 && number <= 2099;
}

/// The date that three numbers look like, as year, month and day; month and day may both be wrong
/// where either could be the month.
std::optional<std::array<int, 3>> dateOf(int a, int b, int c) {
  constexpr int kMonths = 12;
  constexpr int kDays = 31;
  const auto fits = [&](int month, int day) {
    return month >= 1 && month <= kMonths && day >= 1 && day <= kDays;
  };
  if (isYear(a) && fits(b, c)) {
    return std::array{a, b, c};
  }
  if (isYear(c) && fits(b, a)) {
    return std::array{c, b, a};
  }
  if (isYear(c) && fits(a, b)) {
    return std::array{c, a, b};
  }
  return std::nullopt;
}

}  // namespace

bool ExprLowering::isDate(const ast::Binary& node, const ast::Expr& expr) {
  const auto* inner = std::get_if<ast::Binary>(&node.left->node);
  const bool divides = node.op == ast::BinaryOp::Divide;
  if (inner == nullptr || inner->op != node.op ||
      !(divides || node.op == ast::BinaryOp::Subtract)) {
    return false;
  }
  const auto first = wholeNumber(*inner->left);
  const auto second = wholeNumber(*inner->right);
  const auto third = wholeNumber(*node.right);
  const std::string text = scope_.text(expr.where);
  // `(2026 - 11) - 25` certainly means a difference.
  if (!first || !second || !third || text.find_first_of("()") != std::string::npos) {
    return false;
  }
  const auto date = dateOf(*first, *second, *third);
  if (!date) {
    return false;
  }
  const std::string instant = instantText((*date)[0], (*date)[1], (*date)[2]);
  scope_.report(support::diagnostics::dateAsDifference, expr.where, text, *first, *second, *third,
                divides ? "divided by" : "minus",
                instant.empty() ? "there is no such day; a time is written `2026-11-25T12:00Z`"
                                : "write " + instant);
  return true;
}

bool ExprLowering::tooSoonAfter1970(const Value& clock, const ast::Expr& clock_expr,
                                    const Value& value, const ast::Expr& value_expr) {
  const ir::Expr& e = scope_.mission[clock.id];
  if (e.op != ir::Op::Sensor) {
    return false;
  }
  const std::string& name = scope_.mission[e.sensor].vehicle_name;
  const auto& sensors = scope_.platform().sensors;
  const auto found = std::ranges::find(sensors, name, &platforms::PlatformSensor::name);
  const std::optional<double> time = evaluate(scope_.mission, value.id);
  if (found == sensors.end() || found->unit != "timestamp" || !time || *time <= 0 ||
      *time >= kYear_s) {
    return false;
  }
  constexpr int kYearPlace = 10000;
  constexpr int kMonthPlace = 100;
  const int number = *time == std::floor(*time) ? static_cast<int>(*time) : 0;
  const int year = number / kYearPlace;
  const std::string instant =
      isYear(year) ? instantText(year, number / kMonthPlace % kMonthPlace, number % kMonthPlace)
                   : std::string();
  scope_.report(
      support::diagnostics::timeSince1970, value_expr.where, scope_.text(clock_expr.where),
      scope_.text(value_expr.where),
      instant.empty()
          ? "for the time since the mission began, write `missiontime`; a date is written "
            "`2026-11-25T12:00Z`"
          : "write " + instant);
  return true;
}

}  // namespace glider::frontend
