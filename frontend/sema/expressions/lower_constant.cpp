// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/evaluate.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "ir/core/ops.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::frontend {

using support::DiagnosticId;

namespace {

bool isConstant(const Snippet& snippet) {
  return std::ranges::none_of(snippet, [](const ir::Expr& expr) {
    using enum ir::Op;
    return expr.op == Call || (expr.op != Constant && expr.op != True && expr.op != False &&
                               ir::operandCount(expr) == 0);
  });
}

/// The names in an expression, in the order written.
void collectNames(const ast::Expr& expr, std::vector<std::string_view>& names) {
  if (const auto* use = std::get_if<ast::NameUse>(&expr.node)) {
    names.push_back(use->name);
  } else if (const auto* unary = std::get_if<ast::Unary>(&expr.node)) {
    collectNames(*unary->operand, names);
  } else if (const auto* binary = std::get_if<ast::Binary>(&expr.node)) {
    collectNames(*binary->left, names);
    collectNames(*binary->right, names);
  } else if (const auto* call = std::get_if<ast::Invocation>(&expr.node)) {
    for (const ast::Argument& argument : call->arguments) {
      collectNames(*argument.value, names);
    }
  }
}

/// In a behaviour that is lowered for a use, the parameter that determines `expr`: the first that
/// is not constant, otherwise the first; null if it names none.
const Named* blamed(const ast::Expr& expr, Scope& scope) {
  std::vector<std::string_view> names;
  collectNames(expr, names);
  const Named* first = nullptr;
  for (const std::string_view name : names) {
    const Named* named = scope.findNamed(name);
    if (named == nullptr || named->arguments.empty()) {
      continue;
    }
    if (!isConstant(named->arguments.front())) {
      return named;
    }
    first = first == nullptr ? named : first;
  }
  return first;
}

/// Reports `id` for `expr` and what it is, or for the argument of the parameter that causes it.
void refuse(DiagnosticId id, const ast::Expr& expr, const std::string& what, std::string_view role,
            Scope& scope) {
  const Named* named = blamed(expr, scope);
  if (named == nullptr) {
    scope.report(id, expr.where, scope.text(expr.where), what);
    return;
  }
  // Once, even if it has that role several times: the places and the words are the same.
  const support::SourceRange given = named->arguments.front().back().range;
  scope.diagnostics()
      .report(id, given, scope.text(given),
              fmt::format("`{}` of `{}`", named->name->text, scope.context.behaviour))
      .note(expr.where, std::string(role));
}

}  // namespace

void MissingUnit::explain(support::DiagnosticBuilder& report) const {
  if (constant != nullptr) {
    report.hint(fmt::format("write `const {}`", declaration))
        .note(constant->name->where, "it is defined here without a unit");
  }
}

MissingUnit ExprLowering::missingUnitOf(const ast::Expr& expr, const DeclaredType& want) {
  const auto* use = std::get_if<ast::NameUse>(&expr.node);
  const bool quantity = !want.position && !want.path && want.type.kind == ir::TypeKind::Quantity &&
                        !want.type.dimension.dimensionless();
  if (use == nullptr || !quantity || scope_.findNamed(use->name) != nullptr) {
    return {};
  }
  const Constant* constant = scope_.findConstant(use->name);
  const auto* literal = constant != nullptr && constant->untyped != nullptr
                            ? std::get_if<ast::Literal>(&constant->untyped->node)
                            : nullptr;
  if (literal == nullptr || !literal->unit.empty()) {
    return {};
  }
  const bool first =
      scope_.unitless.insert(fmt::format("{}: {}", use->name, describe(want))).second;
  return {.constant = constant,
          .declaration = fmt::format("{} = {} {}", use->name, literal->digits,
                                     pilotsUnit(want.type.dimension)),
          .reported = !first};
}

std::optional<double> ExprLowering::positiveConstant(const ast::Expr& expr, const ir::Type& type,
                                                     const ConstantRole& role) {
  const auto lowered = lowerAs(expr, type, role.what);
  if (!lowered) {
    return std::nullopt;
  }
  const auto known = evaluate(scope_.mission, *lowered);
  // A behaviour's parameters are known where it is used, not where it is checked on its own.
  if (!known && scope_.context.checkedAlone()) {
    return 1.0;
  }
  if (!known) {
    refuse(support::diagnostics::notConstant, expr, role.what, role.role, scope_);
    return std::nullopt;
  }
  if (!(*known > 0)) {
    refuse(role.not_positive, expr, role.what, role.role, scope_);
    return std::nullopt;
  }
  return known;
}

}  // namespace glider::frontend
