// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/lower_expr.h"
#include "support/diagnostics/ids/meaning.h"
#include "support/units/units.h"

#include <charconv>
#include <chrono>
#include <cmath>
#include <limits>

// Times as they are written: `2026-11-25T12:00Z`, `3 h 30 min`.

namespace glider::frontend {
namespace {

/// The whole number in digits `from` to `from + count`.
unsigned digitsAt(std::string_view text, size_t from, size_t count) {
  unsigned value = 0;
  std::from_chars(text.data() + from, text.data() + from + count, value);
  return value;
}

/// Seconds since 1970 of `2026-11-25T12:00Z` or `2026-11-25T12:00:30Z`; empty if there is no such
/// time.
std::optional<double> secondsOf(std::string_view text) {
  constexpr size_t kWithoutSeconds = 17;
  constexpr unsigned kSixty = 60;
  const std::chrono::year_month_day date{std::chrono::year(static_cast<int>(digitsAt(text, 0, 4))),
                                         std::chrono::month(digitsAt(text, 5, 2)),
                                         std::chrono::day(digitsAt(text, 8, 2))};
  const unsigned hour = digitsAt(text, 11, 2);
  const unsigned minute = digitsAt(text, 14, 2);
  const unsigned second = text.size() > kWithoutSeconds ? digitsAt(text, 17, 2) : 0;
  if (!date.ok() || hour >= 24 || minute >= kSixty || second >= kSixty) {
    return std::nullopt;
  }
  const auto days = std::chrono::sys_days(date).time_since_epoch();
  return static_cast<double>(std::chrono::seconds(days).count()) + hour * 3600.0 + minute * 60.0 +
         second;
}

}  // namespace

ExprLowering::Result ExprLowering::visit(const ast::Instant& node, const ast::Expr& expr,
                                         std::optional<ir::Type>) {
  const std::optional<double> seconds = secondsOf(node.text);
  if (!seconds) {
    scope_.report(support::diagnostics::noSuchInstant, expr.where, node.text);
    return std::nullopt;
  }
  return emitNumber(*seconds, quantity(support::dimension::time), expr.where);
}

ExprLowering::Result ExprLowering::visit(const ast::Duration& node, const ast::Expr& expr,
                                         std::optional<ir::Type>) {
  double sum = 0;
  double last = std::numeric_limits<double>::infinity();
  for (const ast::Literal& part : node.parts) {
    const auto unit = support::parseUnit(part.unit);
    const auto number = this->number(part, expr.where);
    if (!number) {
      return std::nullopt;
    }
    const bool first = &part == &node.parts.front();
    const bool fits = unit && unit->dimension == support::dimension::time && unit->to_si < last &&
                      (first || *number * unit->to_si < last);
    if (!fits) {
      scope_.report(support::diagnostics::notADuration, expr.where, scope_.text(expr.where));
      return std::nullopt;
    }
    sum += *number * unit->to_si;
    last = unit->to_si;
  }
  if (!std::isfinite(sum)) {
    scope_.report(support::diagnostics::numberTooLarge, expr.where, scope_.text(expr.where));
    return std::nullopt;
  }
  return emitNumber(sum, quantity(support::dimension::time), expr.where);
}

}  // namespace glider::frontend
