// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/lower_behaviour.h"

#include "frontend/sema/lower_case.h"
#include "frontend/sema/lower_statement.h"
#include "frontend/sema/variables.h"
#include "support/check.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::frontend {

using support::DiagnosticId;

namespace {

const std::vector<ast::Case>& casesOf(const ast::Behaviour& behaviour) {
  static const std::vector<ast::Case> none;
  for (const ast::Member& member : behaviour.members) {
    if (const auto* events = std::get_if<ast::EventsMember>(&member.node)) {
      return events->cases;
    }
  }
  return none;
}

const ast::Block* entryOf(const ast::Behaviour& behaviour) {
  for (const ast::Member& member : behaviour.members) {
    if (const auto* entry = std::get_if<ast::EntryMember>(&member.node)) {
      return &entry->block;
    }
  }
  return nullptr;
}

bool saysDone(const ast::Behaviour& behaviour) {
  return std::ranges::any_of(casesOf(behaviour), [](const ast::Case& node) {
    return node.transition == ast::Transition::Done;
  });
}

}  // namespace

ir::VariableKind BehaviourLowering::variableKind() const {
  return declaration_.kind == ir::BehaviourKind::Profile ? ir::VariableKind::Profile
                                                         : ir::VariableKind::Route;
}

Context BehaviourLowering::context(ir::StateId state) {
  Context result;
  result.names = &names_;
  result.isolated = true;
  result.behaviour = declaration_.name->text;
  result.state = state;
  return result;
}

void BehaviourLowering::check() {
  const size_t before = scope_.diagnostics().errorCount();
  {
    const Scope::Scratch scratch(scope_);
    const Scope::Within within(scope_, context({}));
    checkMembers();
    enterParameters();
    enterVariables();
    ir::Activity unused;
    body(unused, {}, "");
  }
  const bool good = scope_.diagnostics().errorCount() == before;
  if (good) {
    warnOfUnused(names_, scope_);
  }
  declaration_.usable = declaration_.usable && good && declaration_.signature.valid;
}

void BehaviourLowering::checkMembers() {
  for (const ast::Member& member : declaration_.body->members) {
    const bool foreign = std::holds_alternative<ast::RouteMember>(member.node) ||
                         std::holds_alternative<ast::ProfileMember>(member.node) ||
                         std::holds_alternative<ast::SensorsMember>(member.node);
    if (foreign) {
      scope_.report(DiagnosticId::stateMemberInBehaviour, member.keyword,
                    scope_.text(member.keyword));
    } else if (!std::holds_alternative<ast::Var>(member.node)) {
      checkOnce(member);
    }
  }
}

void BehaviourLowering::checkOnce(const ast::Member& member) {
  const auto [place, fresh] = seen_.emplace(member.node.index(), &member);
  if (!fresh) {
    scope_
        .report(DiagnosticId::memberTwice, member.keyword, "`" + declaration_.name->text + "`",
                scope_.text(member.keyword))
        .note(place->second->keyword, "the first is here");
  }
}

/// As plain values of their types.
void BehaviourLowering::enterParameters() {
  for (const Signature::Formal& formal : declaration_.signature.formals) {
    if (Named* named = enterName(*formal.name, NamedKind::BehaviourParameter, names_, scope_)) {
      named->type = formal.type;
      makeParameter(*named, variableKind(), {}, formal.name->text, scope_);
    }
  }
}

void BehaviourLowering::giveArguments(const std::vector<Snippet>& arguments) {
  size_t next = 0;
  for (const Signature::Formal& formal : declaration_.signature.formals) {
    Named& named = names_[formal.name->text];
    named.name = formal.name;
    named.kind = NamedKind::BehaviourParameter;
    named.type = formal.type;
    named.reached = true;
    const size_t slots = formal.type.position ? 2 : 1;
    CHECK(next + slots <= arguments.size(), "a behaviour is used with too few arguments");
    named.arguments.assign(arguments.begin() + static_cast<std::ptrdiff_t>(next),
                           arguments.begin() + static_cast<std::ptrdiff_t>(next + slots));
    next += slots;
  }
}

void BehaviourLowering::enterVariables() {
  for (const ast::Member& member : declaration_.body->members) {
    if (const auto* variable = std::get_if<ast::Var>(&member.node)) {
      enterName(variable->name, NamedKind::BehaviourVariable, names_, scope_);
    }
  }
}

void BehaviourLowering::use(ir::Activity& activity, const std::vector<Snippet>& arguments,
                            ir::StateId state, const std::string& state_name) {
  Context inside = context(state);
  inside.use = activity.range;
  const Scope::Within within(scope_, inside);
  giveArguments(arguments);
  enterVariables();
  const bool profile = declaration_.kind == ir::BehaviourKind::Profile;
  body(activity, state, fmt::format("{}.{}.", state_name, profile ? "profile" : "route"));
}

void BehaviourLowering::body(ir::Activity& activity, ir::StateId state, const std::string& prefix) {
  const VariableOwner owner{variableKind(), state, prefix};
  for (const ast::Member& member : declaration_.body->members) {
    if (const auto* variable = std::get_if<ast::Var>(&member.node)) {
      lowerVariable(*variable, owner, names_, scope_);
    }
  }
  if (saysDone(*declaration_.body)) {
    activity.done = makeDone(owner, declaration_.name->where, scope_);
  }
  scope_.context.list =
      declaration_.kind == ir::BehaviourKind::Profile ? ir::ListKind::Profile : ir::ListKind::Route;
  if (const ast::Block* entry = entryOf(*declaration_.body)) {
    activity.entry = StatementLowering(scope_).lower(entry->statements);
  }
  activity.cases = CaseLowering(scope_).lower(casesOf(*declaration_.body), [](const auto&) {});
}

}  // namespace glider::frontend
