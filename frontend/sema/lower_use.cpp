// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/lower_arguments.h"
#include "frontend/sema/lower_behaviour.h"
#include "frontend/sema/lower_state.h"
#include "frontend/spelling.h"

namespace glider::frontend {

using support::DiagnosticId;

namespace {

std::string_view word(ir::BehaviourKind kind) {
  return kind == ir::BehaviourKind::Profile ? "flightprofile" : "flightroute";
}

}  // namespace

BehaviourDeclaration* StateLowering::find(const ast::Use& use, ir::BehaviourKind kind) {
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
    return nullptr;
  }
  BehaviourDeclaration& declaration = found->second;
  if (declaration.kind != kind) {
    scope_.report(DiagnosticId::wrongBehaviour, use.name.where, use.name.text,
                  word(declaration.kind), word(kind));
    return nullptr;
  }
  return declaration.usable ? &declaration : nullptr;
}

ir::Activity StateLowering::activity(const ast::Use& use, ir::BehaviourKind kind) {
  ir::Activity result;
  result.range = use.where;
  BehaviourDeclaration* declaration = find(use, kind);
  if (declaration == nullptr) {
    return result;
  }
  result.behaviour = scope_.use(*declaration);
  if (declaration->body != nullptr) {
    useBody(use, *declaration, result);
    return result;
  }
  const Callee callee{use.name.text, declaration->signature, declaration->name};
  result.arguments =
      lowerArguments(use.arguments, callee, use.where, scope_).value_or(result.arguments);
  return result;
}

void StateLowering::useBody(const ast::Use& use, BehaviourDeclaration& declaration,
                            ir::Activity& activity) {
  const size_t before = scope_.mission.exprs.size();
  const size_t watched = scope_.mission.temporals.size();
  const Callee callee{use.name.text, declaration.signature, declaration.name};
  const auto arguments = lowerArguments(use.arguments, callee, use.where, scope_);
  if (!arguments) {
    return;
  }
  std::vector<Snippet> snippets;
  for (const ir::ExprId argument : *arguments) {
    snippets.push_back(copy(scope_.mission, argument));
  }
  // What is watched over time stays where it is; all else stands where the body reads it.
  if (scope_.mission.temporals.size() == watched) {
    scope_.mission.exprs.resize(before);
  }
  BehaviourLowering(declaration, scope_).use(activity, snippets, id_, state_.name.text);
}

}  // namespace glider::frontend
