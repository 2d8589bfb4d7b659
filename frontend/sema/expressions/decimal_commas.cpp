// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/decimal_commas.h"

#include "frontend/spelling.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

namespace glider::frontend {
namespace {

bool isWhole(const ast::Literal& literal) {
  return literal.digits.find_first_not_of("0123456789") == std::string::npos;
}

/// The number that an argument is or ends with, perhaps behind a minus: `temp > 12`; null: none.
const ast::Literal* numberIn(const ast::Argument& argument) {
  const ast::Expr* expr = &*argument.value;
  while (const auto* binary = std::get_if<ast::Binary>(&expr->node)) {
    expr = &*binary->right;
  }
  if (const auto* unary = std::get_if<ast::Unary>(&expr->node);
      unary != nullptr && unary->op == ast::UnaryOp::Negate) {
    expr = &*unary->operand;
  }
  return std::get_if<ast::Literal>(&expr->node);
}

/// `39,175 N`: digits, a comma and digits without a space.
bool isDecimalComma(const ast::Argument& first, const ast::Argument& second, const Scope& scope) {
  const ast::Literal* whole = numberIn(first);
  const auto* rest = std::get_if<ast::Literal>(&second.value->node);
  return whole != nullptr && rest != nullptr && whole->unit.empty() && isWhole(*whole) &&
         isWhole(*rest) && !first.of && second.value->where.begin == first.value->where.end + 1 &&
         scope.fileText(first.value->where.file)[first.value->where.end] == ',';
}

}  // namespace

bool refuseDecimalCommas(const std::vector<ast::Argument>& arguments, Scope& scope,
                         const std::function<bool(const std::vector<ast::Argument>&)>& fit) {
  std::vector<ast::Argument> read;
  std::vector<support::SourceRange> commas;
  for (size_t i = 0; i < arguments.size(); ++i) {
    read.push_back(arguments[i]);
    if (i + 1 < arguments.size() && isDecimalComma(arguments[i], arguments[i + 1], scope)) {
      const support::SourceRange& whole = arguments[i].value->where;
      commas.push_back({whole.file, whole.end, whole.end + 1});
      ++i;
    }
  }
  if (commas.empty() || !fit(read)) {
    return false;
  }
  for (const support::SourceRange& comma : commas) {
    const std::string_view text = scope.fileText(comma.file);
    constexpr std::string_view kDigits = "0123456789";
    const size_t before = text.find_last_not_of(kDigits, comma.begin - 1) + 1;
    const size_t after = std::min(text.find_first_not_of(kDigits, comma.end), text.size());
    const auto part = [&](size_t begin, size_t end) { return text.substr(begin, end - begin); };
    const std::string_view whole = part(before, comma.begin);
    const std::string_view rest = part(comma.end, after);
    auto report =
        scope.report(support::diagnostics::decimalComma,
                     {comma.file, static_cast<uint32_t>(before), static_cast<uint32_t>(after)},
                     part(before, after), fmt::format("{}.{}", whole, rest));
    const size_t letter = std::min(text.find_first_not_of(' ', after), text.size());
    const bool position =
        std::string_view("NSEW").contains(text.substr(letter, 1)) && letter < text.size();
    if (!position && mayBeThousands(whole, rest)) {
      report.hint(fmt::format("write `{0}{1}` or `{0}.{1}`, whichever is meant", whole, rest));
    } else {
      report.fix(comma, ".");
    }
  }
  return true;
}

}  // namespace glider::frontend
