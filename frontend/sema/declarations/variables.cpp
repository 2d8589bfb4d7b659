// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/declarations/variables.h"

#include "frontend/sema/arrays/declared_array.h"
#include "frontend/sema/declarations/declared_value.h"
#include "frontend/sema/expressions/evaluate.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "ir/core/mission_writer.h"
#include "support/check.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::frontend {

namespace {

/// False, and reported, if there is no such type.
bool typed(Named& named, const ast::TypeName& name, Scope& scope) {
  const auto type = scope.declaredType(name, describe(named.kind));
  named.type = type.value_or(named.type);
  return type.has_value();
}

ir::VariableId push(ir::Variable variable, Scope& scope) {
  variable.name = scope.freshName(std::move(variable.name));
  return ir::MissionWriter(scope.mission).add(std::move(variable));
}

/// An IR variable like `model`, or two if it is a position: `longitude_start` belongs to the
/// second.
Element makeOne(const Named& named, ir::Variable model, ir::ExprId longitude_start, Scope& scope) {
  model.type = named.type.type;
  model.range = named.name->where;
  ir::Variable second = model;
  if (named.type.position) {
    second.name += ".longitude";
    second.type = longitude();
    second.initial = longitude_start;
    model.name += ".latitude";
  }
  Element made;
  made.variable = push(std::move(model), scope);
  if (named.type.position) {
    made.longitude = push(std::move(second), scope);
  }
  return made;
}

void make(Named& named, ir::Variable model, ir::ExprId longitude_start, Scope& scope) {
  const Element made = makeOne(named, std::move(model), longitude_start, scope);
  named.variable = made.variable;
  named.longitude = made.longitude;
  named.reached = true;
}

/// The first node of an expression that is one of `ops`.
const ir::Expr* firstOf(const ir::Mission& mission, ir::ExprId id,
                        std::initializer_list<ir::Op> ops) {
  const ir::Expr& expr = mission[id];
  if (std::ranges::find(ops, expr.op) != ops.end()) {
    return &expr;
  }
  for (const ir::ExprId operand : expr.operands) {
    const ir::Expr* found = operand.valid() ? firstOf(mission, operand, ops) : nullptr;
    if (found != nullptr) {
      return found;
    }
  }
  return nullptr;
}

/// False, and reported, if an expression depends on more than constants and parameters.
bool knownAtStart(ir::ExprId id, Scope& scope) {
  using enum ir::Op;
  const ir::Expr* found =
      firstOf(scope.mission, id, {Sensor, Age, MissionTime, StateTime, ResumeTime, Call});
  if (found != nullptr) {
    scope.report(support::diagnostics::notAtStart, found->range, scope.text(found->range));
  }
  return found == nullptr;
}

/// False, and reported, if a variable's initial value watches something over time, as an argument
/// may: it has no past when the variable starts.
bool knownOnEntry(ir::ExprId id, Scope& scope) {
  const ir::Expr* found = firstOf(scope.mission, id, {ir::Op::Temporal});
  if (found != nullptr) {
    scope.refuseOverTime(found->range, scope.text(found->range));
  }
  return found == nullptr;
}

ir::ExprId constantExpr(double value, const ir::Type& type, const support::SourceRange& range,
                        Scope& scope) {
  ir::MissionWriter write(scope.mission, range);
  return type == boolean() ? write.truth(value != 0) : write.number(value, type);
}

/// The number of its elements; 0 for what is not an array. Empty, and reported, if it is wrong.
std::optional<size_t> sizeOf(const std::optional<ast::Expr>& size, Named& named, Scope& scope) {
  named.array = size.has_value();
  return size ? arraySize(*size, scope) : std::optional(size_t{0});
}

/// The names in the IR of `named` and of its elements: "temps[3]".
std::string nameOf(std::string name, bool array, size_t i) {
  return array ? fmt::format("{}[{}]", name, i) : std::move(name);
}

/// Keeps the variable that was made for `named`, or for its next element.
void keep(const Element& made, Named& named) {
  if (named.array) {
    named.elements.push_back(made);
  } else {
    named.variable = made.variable;
    named.longitude = made.longitude;
  }
  named.reached = true;
}

/// The initial value `expr` of the variable `node`, or of one of its elements. Empty, and reported,
/// if something is wrong.
std::optional<Value> startOf(const ast::Expr& expr, const ast::Var& node, const Bounds& bounds,
                             DeclaredValue& lowering, Scope& scope) {
  if (isUnknown(expr, scope)) {
    return lowering.unknown(bounds, expr.where);
  }
  const auto start = lowering.start(expr);
  const bool mission = scope.context.at_start;
  if (!start || (mission && !knownAtStart(start->id, scope)) || !knownOnEntry(start->id, scope)) {
    return std::nullopt;
  }
  const auto known = evaluate(scope.mission, start->id);
  return known && node.range && !lowering.inside(*known, bounds, expr, *node.range) ? std::nullopt
                                                                                    : start;
}

/// Lowers into `named`; false, and reported, if something is wrong.
bool lowerVar(const ast::Var& node, const VariableOwner& owner, Named& named, Scope& scope) {
  const auto size = sizeOf(node.size, named, scope);
  if (!typed(named, node.type, scope) || !size) {
    return false;
  }
  DeclaredValue lowering(node.name, named.type, scope);
  const auto bounds = lowering.bounds(node.range);
  const auto starts = startsOf(node.name, *size, node.value, scope);
  if (!bounds || !starts) {
    return false;
  }
  named.starts_constant = true;
  for (size_t i = 0; i < starts->size(); ++i) {
    const auto start = startOf(*(*starts)[i], node, *bounds, lowering, scope);
    if (!start) {
      return false;
    }
    named.starts_constant &= evaluate(scope.mission, start->id).has_value();
    named.scale = lowering.scale();
    ir::Variable model;
    model.name = nameOf(owner.prefix + node.name.text, named.array, i);
    model.kind = owner.kind;
    model.owner = owner.state;
    model.initial = start->id;
    model.lowest = bounds->lowest;
    model.highest = bounds->highest;
    keep(makeOne(named, std::move(model), start->longitude, scope), named);
  }
  return true;
}

bool lowerParam(const ast::Param& node, Named& named, Scope& scope) {
  const auto size = sizeOf(node.size, named, scope);
  if (!typed(named, node.type, scope) || !size) {
    return false;
  }
  DeclaredValue lowering(node.name, named.type, scope);
  const auto bounds = lowering.bounds(node.range);
  const auto starts = startsOf(node.name, *size, node.value, scope);
  if (!bounds || !starts) {
    return false;
  }
  for (size_t i = 0; i < starts->size(); ++i) {
    const ast::Expr& expr = *(*starts)[i];
    const auto start = lowering.constant(expr, "the value of a parameter");
    if (!start || (node.range && !lowering.inside(start->first, *bounds, expr, *node.range))) {
      return false;
    }
    named.scale = lowering.scale();
    ir::Variable model;
    model.name = nameOf(node.name.text, named.array, i);
    model.kind = ir::VariableKind::Parameter;
    model.unit = named.scale.unit;
    model.initial = constantExpr(start->first, named.type.type, expr.where, scope);
    model.lowest = bounds->lowest;
    model.highest = bounds->highest;
    const ir::ExprId second = named.type.position
                                  ? constantExpr(start->second, longitude(), expr.where, scope)
                                  : ir::ExprId();
    keep(makeOne(named, std::move(model), second, scope), named);
  }
  return true;
}

/// Its declaration was lowered, or refused: then it has no elements, not even those before the
/// error.
void settle(Named& named) {
  named.reached = true;
  if (!named.valid) {
    named.elements.clear();
  }
}

/// The entry of `name` if this declaration has made it.
Named* entryOf(const ast::Name& name, Names& names) {
  const auto found = names.find(name.text);
  return found != names.end() && found->second.name == &name ? &found->second : nullptr;
}

}  // namespace

Named* enterName(const ast::Name& name, NamedKind kind, Names& names, Scope& scope) {
  const std::string_view what = describe(kind);
  if (scope.refuseName(name, what) || scope.refuseSecond(name)) {
    return nullptr;
  }
  Named named;
  named.name = &name;
  named.kind = kind;
  return &names.insert_or_assign(name.text, std::move(named)).first->second;
}

void makeParameter(Named& named, ir::VariableKind kind, ir::StateId state, const std::string& name,
                   Scope& scope, const Bounds& bounds) {
  ir::Variable model;
  model.name = name;
  model.kind = kind;
  model.owner = state;
  model.lowest = bounds.lowest;
  model.highest = bounds.highest;
  make(named, std::move(model), {}, scope);
}

void lowerVariable(const ast::Var& node, const VariableOwner& owner, Names& names, Scope& scope) {
  if (Named* named = entryOf(node.name, names)) {
    named->valid = lowerVar(node, owner, *named, scope);
    settle(*named);
  }
}

ir::VariableId makeDone(const VariableOwner& owner, const support::SourceRange& range,
                        Scope& scope) {
  ir::Variable variable;
  variable.name = owner.prefix + "done";
  variable.type = boolean();
  variable.kind = owner.kind;
  variable.owner = owner.state;
  variable.initial = constantExpr(0, boolean(), range, scope);
  variable.range = range;
  return push(std::move(variable), scope);
}

void lowerMissionParameter(const ast::Param& node, Scope& scope) {
  if (Named* named = entryOf(node.name, scope.names)) {
    named->valid = lowerParam(node, *named, scope);
    settle(*named);
  }
}

void lowerMissionCondition(const ast::Param& node, Scope& scope) {
  if (!node.condition) {
    return;
  }
  std::vector<bool> read;
  for (const auto& [name, named] : scope.names) {
    read.push_back(named.read);
  }
  const auto condition = ExprLowering(scope).lowerCondition(*node.condition);
  size_t next = 0;
  for (auto& [name, named] : scope.names) {
    named.read = read[next++];  // a condition alone does not count as a use of a parameter
  }
  if (condition && knownAtStart(*condition, scope)) {
    scope.mission.conditions.push_back(*condition);
  }
}

void warnOfUnused(const Names& names, Scope& scope) {
  for (const auto& [name, named] : names) {
    if (!named.valid || !named.reached) {
      continue;
    }
    if (!named.read) {
      scope.report(support::diagnostics::neverRead, named.name->where, name, describe(named.kind));
    } else if (isVariable(named.kind) && !named.written && named.starts_constant) {
      auto warning = scope.report(support::diagnostics::neverSet, named.name->where, name);
      if (named.kind == NamedKind::BehaviourVariable) {
        warning.hint("replace it by its value");
      }
    }
  }
}

}  // namespace glider::frontend
