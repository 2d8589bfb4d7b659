// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/states/lower_behaviour.h"

#include "frontend/sema/declarations/variables.h"
#include "frontend/sema/expressions/lower_arguments.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "frontend/sema/states/lower_case.h"
#include "frontend/sema/states/lower_statement.h"
#include "support/check.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::frontend {

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

/// The use of a behaviour in a member of that kind; null for any other member.
const ast::Use* useIn(const ast::Member& member, ir::BehaviourKind kind) {
  const auto* route = std::get_if<ast::RouteMember>(&member.node);
  const auto* profile = std::get_if<ast::ProfileMember>(&member.node);
  if (kind == ir::BehaviourKind::Route) {
    return route != nullptr ? &route->use : nullptr;
  }
  return profile != nullptr ? &profile->use : nullptr;
}

/// The use of another behaviour that this one consists of; null if it has cases of its own.
const ast::Use* otherOf(const BehaviourDeclaration& declaration) {
  if (declaration.body == nullptr) {
    return nullptr;
  }
  for (const ast::Member& member : declaration.body->members) {
    if (const ast::Use* use = useIn(member, declaration.kind)) {
      return use;
    }
  }
  return nullptr;
}

/// A placeholder for any path.
PathArgument anyPath() {
  return {Path(3), {}};
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
    enterParameters();
    if (const ast::Use* other = otherOf(declaration_)) {
      checkNothingBeside(*other);
      checkOther(*other);
    } else {
      checkMembers();
      enterVariables();
      ir::Activity unused;
      body(unused, {}, "");
    }
  }
  const bool good = scope_.diagnostics().errorCount() == before;
  if (good && declaration_.usable) {
    warnOfUnused(names_, scope_);
  }
  declaration_.usable = declaration_.usable && good && declaration_.signature.valid;
}

void BehaviourLowering::checkMembers() {
  for (const ast::Member& member : declaration_.body->members) {
    const bool foreign = std::holds_alternative<ast::RouteMember>(member.node) ||
                         std::holds_alternative<ast::ProfileMember>(member.node) ||
                         std::holds_alternative<ast::SensorsMember>(member.node) ||
                         std::holds_alternative<ast::SampleMember>(member.node);
    if (foreign) {
      scope_.report(support::diagnostics::stateMemberInBehaviour, member.keyword,
                    scope_.text(member.keyword));
    } else if (!std::holds_alternative<ast::Var>(member.node)) {
      checkOnce(member);
    }
  }
}

/// For a behaviour that consists of another; such an error is reported once.
void BehaviourLowering::checkNothingBeside(const ast::Use& other) {
  for (const ast::Member& member : declaration_.body->members) {
    if (useIn(member, declaration_.kind) != &other) {
      scope_
          .report(support::diagnostics::besideBehaviour, member.keyword, declaration_.name->text,
                  word(declaration_.kind), scope_.text(member.keyword))
          .note(other.where, "the other is here");
      return;
    }
  }
}

void BehaviourLowering::checkOnce(const ast::Member& member) {
  const auto [place, fresh] = seen_.emplace(member.node.index(), &member);
  if (!fresh) {
    scope_
        .report(support::diagnostics::memberTwice, member.keyword,
                "`" + declaration_.name->text + "`", scope_.text(member.keyword))
        .note(place->second->keyword, "the first is here");
  }
}

void BehaviourLowering::checkOther(const ast::Use& other) {
  checkChain();
  const BehaviourDeclaration* declaration = findBehaviour(other, declaration_.kind, scope_);
  if (declaration == nullptr) {
    declaration_.usable = false;
    return;
  }
  const Callee callee{other.name.text, declaration->signature, declaration->name};
  (void)lowerArguments(other.arguments, callee, other.where, scope_);
}

/// Refuses a behaviour that consists of one that consists of … itself.
void BehaviourLowering::checkChain() {
  std::string by_way_of;
  const BehaviourDeclaration* next = &declaration_;
  for (size_t i = 0; i < scope_.behaviours.size(); ++i) {
    const ast::Use* other = otherOf(*next);
    const BehaviourDeclaration* found =
        other != nullptr ? scope_.findBehaviour(other->name) : nullptr;
    if (found == nullptr || !found->usable) {
      return;
    }
    next = found;
    if (next == &declaration_) {
      scope_.report(support::diagnostics::behaviourOfItself, declaration_.name->where,
                    declaration_.name->text, by_way_of);
      return;
    }
    by_way_of += fmt::format("{} `{}`", by_way_of.empty() ? " through" : ",", other->name.text);
  }
}

/// As plain values of their types.
void BehaviourLowering::enterParameters() {
  for (const Signature::Formal& formal : declaration_.signature.formals) {
    if (Named* named = enterName(*formal.name, NamedKind::BehaviourParameter, names_, scope_)) {
      named->type = formal.type;
      if (formal.type.path) {
        named->path = anyPath();
        named->reached = true;
        continue;
      }
      makeParameter(*named, variableKind(), {}, formal.name->text, scope_,
                    {formal.lowest, formal.highest});
      if (formal.usual != nullptr) {
        (void)lowerUsual(formal, "`" + formal.name->text + "`", formal.usual->where, scope_);
      }
    }
  }
}

void BehaviourLowering::giveArguments(const BehaviourArguments& given) {
  const std::vector<Snippet>& arguments = given.values;
  size_t next = 0;
  size_t next_path = 0;
  for (const Signature::Formal& formal : declaration_.signature.formals) {
    Named& named = names_[formal.name->text];
    named.name = formal.name;
    named.kind = NamedKind::BehaviourParameter;
    named.type = formal.type;
    named.reached = true;
    if (formal.type.path) {
      named.path = given.paths.at(next_path++);
      continue;
    }
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

void BehaviourLowering::use(ir::Activity& activity, const BehaviourArguments& arguments,
                            const User& user) {
  Context inside = context(user.state);
  inside.use = activity.range;
  const Scope::Within within(scope_, inside);
  giveArguments(arguments);
  if (const ast::Use* other = otherOf(declaration_)) {
    useOther(*other, activity, user);
    return;
  }
  enterVariables();
  const bool profile = declaration_.kind == ir::BehaviourKind::Profile;
  body(activity, user.state, fmt::format("{}.{}.", user.name, profile ? "profile" : "route"));
}

void BehaviourLowering::useOther(const ast::Use& other, ir::Activity& activity, const User& user) {
  BehaviourDeclaration* declaration = findBehaviour(other, declaration_.kind, scope_);
  if (declaration == nullptr) {
    return;  // refused, which has been reported
  }
  if (declaration->body == nullptr) {
    activity.behaviour = scope_.use(*declaration);
  }
  lowerUse(other, *declaration, user, activity, scope_);
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
