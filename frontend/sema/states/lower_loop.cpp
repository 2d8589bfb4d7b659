// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// `for i in 0 .. 7 do … end`: the body is lowered once for each pass, in which the index is a
// constant. So nothing after the frontend knows loops, and each of them ends.

#include "frontend/sema/arrays/constant_number.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "frontend/sema/states/lower_statement.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

#include <cmath>

namespace glider::frontend {

namespace {

/// The most operations that an outermost loop may become: expressions, statements and passes.
constexpr size_t kMostOperations = 20'000;

size_t operationsOf(const Scope& scope) {
  return scope.mission.exprs.size() + scope.loops.statements;
}

}  // namespace

/// The value of an end of the range of a loop; empty, and reported, if it is not a constant whole
/// number.
std::optional<double> StatementLowering::bound(const ast::Expr& expr) {
  constexpr double kGreatest = 1e15;  // up to there every whole number is a double
  const auto known = constantNumber(expr, "the range of a loop", scope_);
  if (!known) {
    return std::nullopt;
  }
  if (!(std::fabs(*known) <= kGreatest && *known == std::floor(*known))) {
    scope_.report(support::diagnostics::loopRange, expr.where,
                  std::isnan(*known) ? "unknown" : fmt::format("{:.10g}", *known));
    return std::nullopt;
  }
  return known;
}

void StatementLowering::visit(const ast::For& node, const ast::Statement& statement,
                              ir::Block& block) {
  const auto first = bound(node.first);
  const auto last = bound(node.last);
  if (scope_.refuseName(node.index, "the index of a loop") || scope_.refuseSecond(node.index) ||
      !first || !last) {
    return;
  }
  const support::SourceRange range{statement.where.file, node.first.where.begin,
                                   node.last.where.end};
  const bool outermost = scope_.context.pass == nullptr;
  if (outermost) {
    scope_.loops.begin = operationsOf(scope_);
    if (*first > *last) {
      scope_.report(support::diagnostics::loopEmpty, range, *first, *last);
    }
  }
  passes(node, *first, *last, block);
  if (outermost && scope_.loops.too_large) {
    scope_.report(support::diagnostics::loopTooLong, range, *scope_.loops.too_large,
                  kMostOperations);
    scope_.loops.too_large.reset();
  }
}

/// If the loop becomes too large, estimates its size from the passes so far.
void StatementLowering::passes(const ast::For& node, double first, double last, ir::Block& block) {
  LoopPass pass;
  pass.index.name = &node.index;
  pass.index.type = plainNumber();
  pass.index.worked_out = true;
  pass.index.valid = true;
  pass.outer = scope_.context.pass;
  const size_t errors = scope_.diagnostics().errorCount();
  const size_t start = operationsOf(scope_);
  for (double number = first; number <= last; ++number) {
    pass.index.number = number;
    pass.again = !scope_.loops.seen.insert(&node).second;
    Context context = scope_.context;
    context.pass = &pass;
    const Scope::Within within(scope_, context);
    const size_t before = operationsOf(scope_);
    ++scope_.loops.statements;
    lowerInto(block, node.body);
    std::optional<double>& too_large = scope_.loops.too_large;
    if (too_large || operationsOf(scope_) - scope_.loops.begin > kMostOperations) {
      const double here = too_large.value_or(static_cast<double>(operationsOf(scope_) - before));
      const double made = static_cast<double>(before - start) + here;
      too_large = made / (number - first + 1) * (last - first + 1);
      return;
    }
    if (scope_.diagnostics().errorCount() > errors) {
      return;  // the other passes would have the same errors
    }
  }
}

}  // namespace glider::frontend
