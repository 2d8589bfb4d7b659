// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/lower_state.h"
#include "frontend/spelling.h"

#include <fmt/format.h>

namespace glider::frontend {

using support::DiagnosticId;

namespace {

std::string_view word(ir::BehaviourKind kind) {
  return kind == ir::BehaviourKind::Profile ? "flightprofile" : "flightroute";
}

std::string countOf(size_t n) {
  return n == 0 ? "no arguments" : n == 1 ? "1 argument" : fmt::format("{} arguments", n);
}

}  // namespace

ir::Activity StateLowering::activity(const ast::Use& use, ir::BehaviourKind kind) {
  ir::Activity result;
  result.range = use.where;
  const auto found = scope_.behaviours.find(use.name.text);
  if (found == scope_.behaviours.end()) {
    std::vector<std::string_view> names;
    for (const auto& [name, declaration] : scope_.behaviours) {
      if (declaration.kind == kind) {
        names.push_back(name);
      }
    }
    std::string all;
    for (std::string_view name : names) {
      all += (all.empty() ? "there are: " : ", ") + std::string(name);
    }
    scope_.report(DiagnosticId::unknownProfileOrRoute, use.name.where, word(kind), use.name.text,
                  didYouMean(use.name.text, names, all));
    return result;
  }
  BehaviourDeclaration& declaration = found->second;
  if (declaration.kind != kind) {
    scope_.report(DiagnosticId::wrongBehaviour, use.name.where, use.name.text,
                  word(declaration.kind), word(kind));
    return result;
  }
  if (!declaration.usable) {
    return result;
  }
  result.behaviour = scope_.use(declaration);
  result.arguments = arguments(use, declaration);
  return result;
}

bool StateLowering::isPosition(const ast::Expr& expr) const {
  if (std::holds_alternative<ast::Position>(expr.node)) {
    return true;
  }
  const auto* use = std::get_if<ast::NameUse>(&expr.node);
  const auto found = use == nullptr ? scope_.constants.end() : scope_.constants.find(use->name);
  return found != scope_.constants.end() && found->second.position;
}

std::vector<ir::ExprId> StateLowering::arguments(const ast::Use& use,
                                                 const BehaviourDeclaration& declaration) {
  const auto& parameters = declaration.parameters;
  // A position fills a latitude and the longitude after it.
  size_t filled = 0;
  for (const ast::Argument& argument : use.arguments) {
    const bool pair =
        filled + 1 < parameters.size() && parameters[filled].type.kind == ir::TypeKind::Latitude &&
        parameters[filled + 1].type.kind == ir::TypeKind::Longitude && isPosition(*argument.value);
    filled += pair ? 2U : 1U;
  }
  if (wrongCount(use, declaration, filled)) {
    return {};
  }
  std::vector<ir::ExprId> result;
  for (const ast::Argument& argument : use.arguments) {
    if (argument.of) {
      scope_.notYet(argument.of->where, "a stretch with `of`");
      continue;
    }
    ExprLowering lowering(scope_);
    const ir::Parameter& parameter = parameters[std::min(result.size(), parameters.size() - 1)];
    if (parameter.type.kind == ir::TypeKind::Latitude && isPosition(*argument.value)) {
      const auto value = lowering.lower(*argument.value, std::nullopt);
      result.push_back(value ? value->id : ir::ExprId());
      result.push_back(value ? value->longitude : ir::ExprId());
    } else {
      const std::string what = fmt::format("`{}` of `{}`", parameter.name, use.name.text);
      result.push_back(
          lowering.lowerAs(*argument.value, parameter.type, what).value_or(ir::ExprId()));
    }
  }
  return result;
}

bool StateLowering::wrongCount(const ast::Use& use, const BehaviourDeclaration& declaration,
                               size_t filled) {
  const size_t wanted = declaration.parameters.size();
  if (filled == wanted) {
    return false;
  }
  const std::string takes = countOf(wanted);
  for (const ast::Argument& argument : use.arguments) {
    const auto* difference = std::get_if<ast::Binary>(&argument.value->node);
    const bool minus = difference != nullptr && difference->op == ast::BinaryOp::Subtract;
    if (minus && filled + 1 == wanted) {
      scope_
          .report(DiagnosticId::missingCommaBeforeMinus, argument.value->where, use.name.text,
                  takes, scope_.text(argument.value->where), scope_.text(difference->left->where),
                  scope_.text(difference->right->where))
          .fix(difference->op_where, ", -")
          .note(declaration.name->where, "declared as `" + declaration.signature + "`");
      return true;
    }
  }
  scope_
      .report(DiagnosticId::wrongArgumentCount, use.where, use.name.text, takes,
              use.arguments.empty() ? "none" : countOf(filled),
              "write `" + declaration.signature + "`")
      .note(declaration.name->where, "declared here");
  return true;
}

}  // namespace glider::frontend
