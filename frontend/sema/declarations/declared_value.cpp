// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/declarations/declared_value.h"

#include "frontend/sema/expressions/evaluate.h"
#include "ir/eval/arithmetic.h"
#include "support/diagnostics/ids/meaning.h"
#include "support/units/units.h"

#include <fmt/format.h>

#include <cmath>

namespace glider::frontend {

namespace {

std::string withUnit(double value, const ir::Type& type) {
  if (type.kind != ir::TypeKind::Quantity) {
    return fmt::format("{:.10g} degrees", value);
  }
  const std::string unit = support::unitName(type.dimension);
  return fmt::format("{:.10g}{}{}", value, unit.empty() ? "" : " ", unit);
}

}  // namespace

support::SourceRange whole(const ast::Range& range) {
  return {range.lowest.where.file, range.lowest.where.begin, range.highest.where.end};
}

bool isUnknown(const ast::Expr& expr, Scope& scope) {
  const auto* use = std::get_if<ast::NameUse>(&expr.node);
  return use != nullptr && use->name == "unknown" && !scope.declares(use->name, expr.where);
}

Value DeclaredValue::unknown(const Bounds& bounds, const support::SourceRange& range) {
  ir::MissionWriter write(scope_.mission, range);
  const bool truth = type_.type == boolean();
  // Element 1 of a table that has only element 0.
  const auto missing = [&](const ir::Type& type) {
    const double some = std::isfinite(bounds.lowest)    ? bounds.lowest
                        : std::isfinite(bounds.highest) ? bounds.highest
                                                        : 0;
    return write.element(scope_.table({type, {some}}), write.number(1, plainNumber()));
  };
  Value value{missing(truth ? plainNumber() : type_.type), type_.type};
  if (truth) {
    const ir::ExprId zero = write.number(0, plainNumber());
    value.id = write.operation(ir::Op::Equal, boolean(), {value.id, zero});
  }
  if (type_.position) {
    value.longitude = missing(longitude());
  }
  scale_ = {};
  return value;
}

std::optional<Value> DeclaredValue::start(const ast::Expr& expr) {
  ExprLowering lowering(scope_);
  const auto value = lowering.lowerDeclared(expr, type_, "`" + name_.text + "`");
  if (!value || !value->scale.written) {
    return value;
  }
  if (scaled_ != nullptr &&
      lowering.scalesDiffer({{}, {}, {}, scale_}, scaled_->where, *value, expr.where, "in")) {
    return std::nullopt;
  }
  scale_ = value->scale;
  scaled_ = &expr;
  return value;
}

std::optional<std::pair<double, double>> DeclaredValue::constant(const ast::Expr& expr,
                                                                 std::string_view what) {
  Context context = scope_.context;
  context.constant = what;
  context.list.reset();
  const Scope::Within within(scope_, context);
  const size_t before = scope_.mission.exprs.size();
  const auto value = start(expr);
  const auto first = value ? evaluate(scope_.mission, value->id) : std::nullopt;
  const auto second = value && type_.position ? evaluate(scope_.mission, value->longitude) : first;
  scope_.mission.exprs.resize(before);
  if (!value) {
    return std::nullopt;
  }
  if (!first || !second) {
    scope_.report(support::diagnostics::notConstant, expr.where, scope_.text(expr.where), what);
    return std::nullopt;
  }
  if (!ir::isKnown(*first) || !ir::isKnown(*second)) {
    scope_.report(support::diagnostics::constantUnknown, expr.where, scope_.text(expr.where));
    return std::nullopt;
  }
  return std::pair(*first, *second);
}

std::optional<Bounds> DeclaredValue::bounds(const std::optional<ast::Range>& range) {
  if (!range) {
    return Bounds{};
  }
  const support::SourceRange where = whole(*range);
  if (type_.position || type_.type == boolean()) {
    scope_.report(support::diagnostics::rangeOfWhat, where, name_.text, describe(type_));
    return std::nullopt;
  }
  const auto lowest = constant(range->lowest, "a range");
  const auto highest = constant(range->highest, "a range");
  if (!lowest || !highest) {
    return std::nullopt;
  }
  if (lowest->first > highest->first) {
    scope_.report(support::diagnostics::emptyRange, where, scope_.text(where));
    return std::nullopt;
  }
  return Bounds{lowest->first, highest->first};
}

bool DeclaredValue::inside(double value, const Bounds& bounds, const ast::Expr& expr,
                           const ast::Range& range) {
  if (bounds.lowest <= value && value <= bounds.highest) {
    return true;
  }
  scope_
      .report(support::diagnostics::startOutsideRange, expr.where, name_.text,
              withUnit(value, type_.type), withUnit(bounds.lowest, type_.type),
              withUnit(bounds.highest, type_.type))
      .note(whole(range), "its range is here");
  return false;
}

}  // namespace glider::frontend
