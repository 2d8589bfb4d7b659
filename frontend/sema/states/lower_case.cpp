// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/states/lower_case.h"

#include "frontend/sema/declarations/only_item.h"
#include "frontend/sema/expressions/evaluate.h"
#include "frontend/sema/expressions/lower_arguments.h"
#include "frontend/sema/states/lower_statement.h"
#include "frontend/spelling.h"
#include "support/check.h"
#include "support/diagnostics/ids/meaning.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

namespace glider::frontend {

std::vector<ir::Case> CaseLowering::lower(const std::vector<ast::Case>& cases,
                                          const GuardReads& guard_reads) {
  std::vector<ir::Case> result;
  for (const ast::Case& node : cases) {
    ExprLowering lowering(scope_);
    const auto guard = lowering.lowerCondition(node.guard);
    guard_reads(lowering.reads());
    result.push_back(lowerCase(node, guard.value_or(ir::ExprId())));
  }
  return result;
}

ir::Case CaseLowering::lowerCase(const ast::Case& node, ir::ExprId guard) {
  ir::Case lowered;
  lowered.range = node.where;
  lowered.guard = guard;
  if (node.action) {
    lowered.action = StatementLowering(scope_).lower(node.action->statements);
  }
  if (!allowed(node)) {
    return lowered;
  }
  lowered.transition = static_cast<ir::Transition>(node.transition);
  if (node.target) {
    lowerTarget(*node.target, lowered);
  }
  return lowered;
}

bool CaseLowering::allowed(const ast::Case& node) {
  CHECK(scope_.context.list.has_value(), "a case outside every list");
  const bool done = node.transition == ast::Transition::Done;
  const bool stay = node.transition == ast::Transition::Stay;
  switch (*scope_.context.list) {
    case ir::ListKind::Always:
      if (node.transition == ast::Transition::Return) {
        scope_.report(support::diagnostics::returnInAlways, node.transition_where);
        return false;
      }
      [[fallthrough]];
    case ir::ListKind::State:
      if (done) {
        auto report =
            scope_.report(support::diagnostics::doneOutsideBehaviour, node.transition_where);
        if (scope_.context.list == ir::ListKind::Always) {
          report.hint("write `goto`, `call`, `exit` or `stay`");
        }
      }
      return !done;
    case ir::ListKind::Profile:
    case ir::ListKind::Route:
      break;
  }
  if (!done && !stay) {
    const bool profile = scope_.context.list == ir::ListKind::Profile;
    scope_.report(support::diagnostics::transitionInBehaviour, node.transition_where,
                  scope_.text(node.transition_where), profile ? "flightprofile" : "flightroute",
                  profile ? "profiledone" : "routedone");
  }
  return done || stay;
}

std::string CaseLowering::insteadOfState(const std::string& name) const {
  std::vector<std::string_view> profiles;
  for (const auto& [known, declaration] : scope_.behaviours) {
    if (declaration.kind == ir::BehaviourKind::Profile) {
      profiles.push_back(known);
    }
  }
  const std::string_view profile = closest(name, profiles);
  if (!profile.empty()) {
    return fmt::format("`{0}` is a profile: write a state with `flightprofile {0}`, and name that",
                       profile);
  }
  return scope_.listedStates();
}

void CaseLowering::lowerTarget(const ast::Use& target, ir::Case& lowered) {
  const auto found = scope_.states.find(target.name.text);
  if (found == scope_.states.end()) {
    std::vector<std::string_view> names;
    for (const auto& [name, id] : scope_.states) {
      names.push_back(name);
    }
    scope_.reportUnknown(support::diagnostics::unknownState, target.name.where,
                         didYouMean(target.name.text, names, insteadOfState(target.name.text)),
                         target.name.text);
    return;
  }
  lowered.target = found->second;
  const StateDeclaration& state = scope_.state_declarations[found->second.index];
  if (!state.signature.valid) {
    return;
  }
  const Callee callee{target.name.text, state.signature, &state.node->name};
  if (auto arguments = lowerArguments(target.arguments, callee, target.where, scope_)) {
    lowered.arguments = std::move(arguments->values);
  }
}

namespace {

/// Warns about a case of `always` that depends on no state or sensor, which is probably an error.
void warnOfConstant(const ast::Case& node, const ir::Case& lowered, Scope& scope) {
  const auto value = lowered.guard.valid() ? evaluate(scope.mission, lowered.guard) : std::nullopt;
  const bool always = value == 1.0;
  if (!value || (always && lowered.transition == ir::Transition::Stay)) {
    return;
  }
  scope.report(
      support::diagnostics::constantAlways, node.guard.where, scope.text(node.guard.where),
      always ? "always true" : "never true",
      always ? "it fires on every tick, and no case after it is tried" : "this case never fires");
}

}  // namespace

void lowerAlways(const ast::File& file, Scope& scope) {
  const auto* always = onlyItem<ast::Always>(file, [&](const auto& again, const auto& first) {
    scope.report(support::diagnostics::memberTwice, again.where, "a mission", "always")
        .note(first.where, "the first is here")
        .hint("merge their cases into one; they are tried in order");
  });
  if (always == nullptr) {
    return;
  }
  Context context;
  context.list = ir::ListKind::Always;
  const Scope::Within within(scope, context);
  scope.mission.always = CaseLowering(scope).lower(always->cases, [](const auto&) {});
  for (size_t i = 0; i < always->cases.size(); ++i) {
    warnOfConstant(always->cases[i], scope.mission.always[i], scope);
  }
}

}  // namespace glider::frontend
