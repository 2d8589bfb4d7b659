// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/lower_expr.h"
#include "frontend/sema/names/functions.h"
#include "frontend/sema/names/wished.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

namespace glider::frontend {

bool isPosition(const ast::Expr& expr, Scope& scope) {
  if (std::holds_alternative<ast::Position>(expr.node)) {
    return true;
  }
  if (const auto* index = std::get_if<ast::Index>(&expr.node)) {
    const auto array = findArray(index->list.text, scope);
    return !array || array->type.position;
  }
  if (const auto* call = std::get_if<ast::Invocation>(&expr.node)) {
    return isPlaceFunction(call->function.text) && !scope.declares(call->function.text, expr.where);
  }
  const auto* use = std::get_if<ast::NameUse>(&expr.node);
  if (use == nullptr) {
    return false;
  }
  if (use->name == "here" && meansValue(use->name, expr.where, scope)) {
    return true;
  }
  if (const Named* named = scope.findNamed(use->name)) {
    return named->type.position;
  }
  const Constant* constant = scope.findConstant(use->name);
  return constant != nullptr && constant->position;
}

ExprLowering::Result ExprLowering::visit(const ast::NameUse& node, const ast::Expr& expr,
                                         std::optional<ir::Type>) {
  if (Named* named = scope_.findNamed(node.name)) {
    if (named->type.path) {
      named->read = true;
      refusePath(expr);
      return std::nullopt;
    }
    if (const auto array = findArray(node.name, scope_)) {
      refuseArray(*array, expr.where);
      return std::nullopt;
    }
    return variable(*named, expr.where);
  }
  if (const Constant* found = scope_.findConstant(node.name)) {
    if (!found->worked_out) {
      scope_.report(support::diagnostics::usedBeforeDefined, expr.where, node.name)
          .note(found->name->where, "it is defined here");
      return std::nullopt;
    }
    if (!found->path.empty()) {
      refusePath(expr);
      return std::nullopt;
    }
    if (const auto array = findArray(node.name, scope_)) {
      refuseArray(*array, expr.where);
      return std::nullopt;
    }
    return constant(*found, expr.where);
  }
  if (const auto which = findClock(node.name)) {
    return clock(*which, expr.where);
  }
  if (const platforms::PlatformSensor* found = scope_.findSensor(node.name)) {
    return sensor(*found, node.name, expr.where);
  }
  if (scope_.refused_names.contains(node.name)) {
    return std::nullopt;  // its declaration was refused
  }
  if (meansValue(node.name, expr.where, scope_)) {
    return meantValue(node.name, expr.where);
  }
  if (node.name == "profiledone" || node.name == "routedone") {
    return finished(node, expr.where);
  }
  return unknown(node, expr.where);
}

bool ExprLowering::readable(Named& named, const support::SourceRange& range) {
  named.read = true;
  if (!named.valid) {
    return false;
  }
  if (!scope_.context.constant.empty()) {
    scope_
        .report(support::diagnostics::notConstant, range, named.name->text, scope_.context.constant)
        .note(named.name->where, fmt::format("it is {}", describe(named.kind)));
    return false;
  }
  if (scope_.context.at_start && named.kind != NamedKind::Parameter) {
    scope_.report(support::diagnostics::notAtStart, range, named.name->text)
        .note(named.name->where, fmt::format("it is {}", describe(named.kind)));
    return false;
  }
  if (!named.reached) {
    scope_.report(support::diagnostics::usedBeforeDefined, range, named.name->text)
        .note(named.name->where, "it is defined here");
    return false;
  }
  return true;
}

ExprLowering::Result ExprLowering::variable(Named& named, const support::SourceRange& range) {
  if (!readable(named, range)) {
    return std::nullopt;
  }
  if (!named.arguments.empty()) {
    Value value{paste(named.arguments.front(), scope_.mission), named.type.type, {}};
    if (named.type.position) {
      value.longitude = paste(named.arguments.back(), scope_.mission);
    }
    return value;
  }
  ir::MissionWriter write(scope_.mission, range);
  Value value{write.read(named.variable), named.type.type, {}, named.scale};
  if (named.type.position) {
    value.longitude = write.read(named.longitude);
  }
  return value;
}

ExprLowering::Result ExprLowering::sensor(const platforms::PlatformSensor& sensor,
                                          const std::string& written,
                                          const support::SourceRange& range) {
  const ir::SensorId id = scope_.subscribe(sensor, written);
  reads_.push_back({&sensor, written, range});
  Value value = valueOf(ir::MissionWriter(scope_.mission, range).read(id));
  if (value.type == plainNumber()) {
    value.scale = {sensor.unit, false};
  }
  return value;
}

ExprLowering::Result ExprLowering::clock(Clock clock, const support::SourceRange& range) {
  constexpr ir::Op kOps[] = {ir::Op::MissionTime, ir::Op::StateTime, ir::Op::ResumeTime};
  return emit(kOps[static_cast<size_t>(clock)], quantity(support::dimension::time), range, {});
}

ExprLowering::Result ExprLowering::constant(const Constant& constant,
                                            const support::SourceRange& range) {
  if (!constant.valid) {
    return std::nullopt;
  }
  if (constant.type.kind == ir::TypeKind::Bool) {
    return emit(constant.number != 0 ? ir::Op::True : ir::Op::False, boolean(), range, {});
  }
  Value value = emitNumber(constant.number, constant.type, range);
  value.scale = constant.scale;
  if (constant.position) {
    value.longitude = emitNumber(constant.second, longitude(), range).id;
  }
  return value;
}

ExprLowering::Result ExprLowering::finished(const ast::NameUse& node,
                                            const support::SourceRange& range) {
  const ir::State* state = scope_.context.activities;
  if (state == nullptr) {
    scope_.report(support::diagnostics::doneOutsideState, range, node.name);
    return std::nullopt;
  }
  const bool profile = node.name == "profiledone";
  const ir::Activity& activity = profile ? state->profile : state->route;
  if (!activity.behaviour.valid()) {
    return std::nullopt;  // it was refused, or there is none, which has been reported
  }
  if (!activity.done.valid()) {
    scope_
        .report(support::diagnostics::neverDone, range, node.name,
                profile ? "flightprofile" : "flightroute", scope_.mission[activity.behaviour].name)
        .note(activity.range, "it is used here");
    return emit(ir::Op::False, boolean(), range, {});
  }
  return valueOf(ir::MissionWriter(scope_.mission, range).read(activity.done));
}

ExprLowering::Result ExprLowering::unknown(const ast::NameUse& node,
                                           const support::SourceRange& range) {
  if (scope_.refuseUnseen(node.name, range) || scope_.refuseVehicle(node.name, range)) {
    return std::nullopt;
  }
  const auto function = scope_.functions.find(node.name);
  const Suggestion hint =
      legOf({node, range})
          ? Suggestion{"it is the length of a window: `highest(temp, last leg)`", ""}
      : function != scope_.functions.end()
          ? Suggestion{"it is a function: write `" + function->second.signature.text + "`", ""}
      : isFunctionName(node.name) ? Suggestion{"it is a function: give it arguments", ""}
      : scope_.states.contains(node.name)
          ? Suggestion{"`" + node.name +
                           "` is a state, which no condition reads: a case names it "
                           "after `goto` or `call`, a requirement alone or with `||`, `&&` and "
                           "`!`, as in `then " +
                           node.name + "`, `visit " + node.name + "` or `in " + node.name + ": …`",
                       ""}
      : scope_.places.contains(node.name)
          ? Suggestion{"`" + node.name +
                           "` is a place, which only the patterns of requirements name: write its "
                           "condition, `" +
                           scope_.text(scope_.places.at(node.name)->condition.where) + "`",
                       ""}
      : scope_.behaviours.contains(node.name)
          ? Suggestion{"`" + node.name + "` controls how the vehicle flies; it has no value", ""}
          : scope_.suggestName(node.name);
  scope_.reportUnknown(support::diagnostics::unknownName, range, hint, node.name);
  if (hint.fix.empty() && insteadOf(node.name, scope_.platform())) {
    scope_.refused_names.insert(node.name);  // its other uses are meant in the same way
  }
  return std::nullopt;
}

}  // namespace glider::frontend
