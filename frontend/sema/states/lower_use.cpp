// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/states/lower_use.h"

#include "frontend/sema/expressions/lower_arguments.h"
#include "frontend/sema/names/wished.h"
#include "frontend/sema/states/lower_behaviour.h"
#include "frontend/sema/states/lower_state.h"
#include "frontend/spelling.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::frontend {

std::string_view word(ir::BehaviourKind kind) {
  return kind == ir::BehaviourKind::Profile ? "flightprofile" : "flightroute";
}

BehaviourDeclaration* findBehaviour(const ast::Use& use, ir::BehaviourKind kind, Scope& scope) {
  BehaviourDeclaration* found = scope.findBehaviour(use.name);
  if (found == nullptr) {
    std::vector<std::string_view> names;
    for (const auto& [name, declaration] : scope.behaviours) {
      if (declaration.kind == kind) {
        names.push_back(name);
      }
    }
    std::string all;
    for (std::string_view name : names) {
      all += (all.empty() ? std::string(word(kind)) + "s: " : ", ") + std::string(name);
    }
    const std::string_view meant = behaviourInsteadOf(use.name.text, use.arguments.size());
    const auto isThere = [&](std::string_view name) {
      return std::ranges::find(names, name) != names.end();
    };
    const Suggestion suggestion =
        isThere(meant) ? Suggestion{fmt::format("did you mean `{}`?", meant), ""}
        : namesWaypointList(use.name.text) && isThere("along")
            ? Suggestion{"in a mission this is `along(track, capture)` for a path, or `nav(to)` "
                         "for a position",
                         ""}
            : didYouMean(use.name.text, names, all);
    scope.reportUnknown(support::diagnostics::unknownProfileOrRoute, use.name.where, suggestion,
                        word(kind), use.name.text);
    return nullptr;
  }
  BehaviourDeclaration& declaration = *found;
  if (declaration.kind != kind) {
    scope.report(support::diagnostics::wrongBehaviour, use.name.where, use.name.text,
                 word(declaration.kind), word(kind));
    return nullptr;
  }
  return declaration.usable ? &declaration : nullptr;
}

ir::Activity StateLowering::activity(const ast::Use& use, ir::BehaviourKind kind) {
  ir::Activity result;
  result.range = use.where;
  if (BehaviourDeclaration* declaration = findBehaviour(use, kind, scope_)) {
    result.behaviour = scope_.use(*declaration);
    lowerUse(use, *declaration, {id_, state_.name.text}, result, scope_);
  }
  return result;
}

void lowerUse(const ast::Use& use, BehaviourDeclaration& declaration, const User& user,
              ir::Activity& activity, Scope& scope) {
  const size_t before = scope.mission.exprs.size();
  const size_t watched = scope.mission.temporals.size();
  const Callee callee{use.name.text, declaration.signature, declaration.name};
  auto arguments = lowerArguments(use.arguments, callee, use.where, scope);
  if (!arguments) {
    activity.behaviour = {};  // what it does is not known, nor whether it is ever done
    return;
  }
  if (declaration.body == nullptr) {
    activity.arguments = std::move(arguments->values);
    return;
  }
  BehaviourArguments given{{}, std::move(arguments->paths)};
  for (const ir::ExprId argument : arguments->values) {
    given.values.push_back(copy(scope.mission, argument));
  }
  // What is watched over time stays in place; everything else is placed where the body reads it.
  if (scope.mission.temporals.size() == watched) {
    scope.mission.exprs.resize(before);
  }
  BehaviourLowering(declaration, scope).use(activity, given, user);
}

}  // namespace glider::frontend
