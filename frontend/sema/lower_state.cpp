// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/lower_state.h"

#include "frontend/sema/evaluate.h"
#include "frontend/spelling.h"
#include "support/check.h"

#include <cmath>

namespace glider::frontend {

using support::DiagnosticId;

ir::State StateLowering::run() {
  result_.name = state_.name.text;
  result_.range = state_.name.where;
  if (state_.formals) {
    scope_.notYet(state_.name.where, "a state with parameters");
  }
  // In one order, however they were written: names first, and what guards read is checked against
  // `sensors`.
  constexpr size_t kOrder[] = {3, 0, 1, 2, 4, 5};
  static_assert(
      std::is_same_v<std::variant_alternative_t<kOrder[0], decltype(ast::Member::node)>, ast::Var>);
  static_assert(std::size(kOrder) == std::variant_size_v<decltype(ast::Member::node)>);
  for (const size_t kind : kOrder) {
    for (const ast::Member& member : state_.members) {
      if (member.node.index() == kind) {
        std::visit([&](const auto& node) { visit(node, member); }, member.node);
      }
    }
  }
  defaults();
  return std::move(result_);
}

void StateLowering::defaults() {
  if (!seen_.contains(ast::Member{ast::ProfileMember{}, {}, {}}.node.index())) {
    scope_.report(DiagnosticId::noFlightprofile, state_.name.where, state_.name.text);
  }
  if (!seen_.contains(ast::Member{ast::RouteMember{}, {}, {}}.node.index())) {
    const ast::Use none{{"noheading", state_.name.where}, false, {}, state_.name.where};
    result_.route = activity(none, ir::BehaviourKind::Route);
  }
}

bool StateLowering::first(const ast::Member& member) {
  const auto [place, fresh] = seen_.emplace(member.node.index(), &member);
  if (!fresh) {
    scope_
        .report(DiagnosticId::memberTwice, member.keyword, "state `" + state_.name.text + "`",
                scope_.text(member.keyword))
        .note(place->second->keyword, "the first is here");
  }
  return fresh;
}

void StateLowering::visit(const ast::RouteMember& node, const ast::Member& member) {
  if (first(member)) {
    result_.route = activity(node.use, ir::BehaviourKind::Route);
  }
}

void StateLowering::visit(const ast::ProfileMember& node, const ast::Member& member) {
  if (first(member)) {
    result_.profile = activity(node.use, ir::BehaviourKind::Profile);
  }
}

void StateLowering::visit(const ast::Var& node, const ast::Member& member) {
  scope_.notYet(member.where, "`var`", "use `const` for now");
  scope_.later_values.emplace(node.name.text, &node.name);
}

void StateLowering::visit(const ast::EntryMember&, const ast::Member& member) {
  if (first(member)) {
    scope_.notYet(member.keyword, "`entry`");
  }
}

void StateLowering::visit(const ast::SensorsMember& node, const ast::Member& member) {
  if (!first(member)) {
    return;
  }
  size_t group = 0;
  for (const ast::SensorItem& item : node.items) {
    lowerItem(item);
    if (item.every) {
      setPeriod(*item.every, group);
      group = result_.log.size();
    }
  }
}

void StateLowering::lowerItem(const ast::SensorItem& item) {
  const platforms::PlatformSensor* sensor = scope_.platform().find(item.name.text);
  const bool clock = findClock(item.name.text).has_value();
  if (sensor == nullptr && !clock) {
    if (scope_.constants.contains(item.name.text)) {
      scope_.report(DiagnosticId::notLogged, item.name.where, item.name.text);
    } else if (!scope_.later_values.contains(item.name.text)) {
      scope_.report(DiagnosticId::unknownSensor, item.name.where, scope_.platform().name,
                    item.name.text, scope_.suggestSensor(item.name.text));
    }
    return;
  }
  const auto [place, fresh] = listed_.emplace(clock ? item.name.text : sensor->name, &item.name);
  if (!fresh) {
    scope_.report(DiagnosticId::sensorTwice, item.name.where, item.name.text)
        .note(place->second->where, "the first is here");
    return;
  }
  ExprLowering lowering(scope_);
  const auto value = lowering.lower({ast::NameUse{item.name.text}, item.name.where}, std::nullopt);
  if (value) {
    result_.log.push_back({item.name.text, value->id, 0});
  }
}

void StateLowering::setPeriod(const ast::Expr& every, size_t from) {
  ExprLowering lowering(scope_);
  const size_t before = scope_.mission.exprs.size();
  const auto value =
      lowering.lowerAs(every, quantity(support::dimension::time), "the time of `every`");
  const auto period = value ? evaluate(scope_.mission, *value) : std::optional(1.0);
  scope_.mission.exprs.resize(before);
  if (!period) {
    scope_.report(DiagnosticId::notConstant, every.where, scope_.text(every.where),
                  "the time of `every`");
    return;
  }
  if (!(*period > 0)) {
    scope_.report(DiagnosticId::everyNotPositive, every.where, *period);
    return;
  }
  for (size_t i = from; i < result_.log.size(); ++i) {
    result_.log[i].period_s = *period;
  }
}

void StateLowering::visit(const ast::EventsMember& node, const ast::Member& member) {
  if (first(member)) {
    for (const ast::Case& c : node.cases) {
      lowerCase(c);
    }
  }
}

void StateLowering::lowerCase(const ast::Case& node) {
  ExprLowering lowering(scope_);
  ir::Case lowered;
  lowered.range = node.where;
  if (const auto guard = lowering.lowerCondition(node.guard)) {
    lowered.guard = *guard;
  }
  warnOfUnlisted(lowering.reads());
  if (node.action) {
    scope_.notYet(node.action->where, "`do` in a case");
  }
  lowerTarget(node, lowered);
  result_.cases.push_back(lowered);
}

void StateLowering::lowerTarget(const ast::Case& node, ir::Case& lowered) {
  if (node.transition == ast::Transition::Done) {
    scope_.report(DiagnosticId::doneOutsideBehaviour, node.transition_where);
    return;
  }
  lowered.transition = static_cast<ir::Transition>(node.transition);
  if (!node.target) {
    return;
  }
  const ast::Use& target = *node.target;
  if (target.parenthesised) {
    scope_.notYet(target.where, "giving arguments to a state");
  }
  const auto found = scope_.states.find(target.name.text);
  if (found != scope_.states.end()) {
    lowered.target = found->second;
    return;
  }
  std::vector<std::string_view> names;
  for (const auto& [name, id] : scope_.states) {
    names.push_back(name);
  }
  scope_.report(DiagnosticId::unknownState, target.name.where, target.name.text,
                didYouMean(target.name.text, names, ""));
}

void StateLowering::warnOfUnlisted(const std::vector<SensorRead>& reads) {
  const auto list = seen_.find(ast::Member{ast::SensorsMember{}, {}, {}}.node.index());
  for (const SensorRead& read : reads) {
    if (listed_.contains(read.sensor->name) || !warned_.emplace(read.sensor->name, true).second) {
      continue;
    }
    auto warning =
        scope_.report(DiagnosticId::unlistedSensor, read.range, state_.name.text, read.written);
    if (list != seen_.end()) {
      const uint32_t end = list->second->where.end;
      warning.fix({read.range.file, end, end}, ", " + read.written);
    } else {
      const auto events = seen_.find(ast::Member{ast::EventsMember{}, {}, {}}.node.index());
      CHECK(events != seen_.end(), "a guard outside events");
      const uint32_t begin = events->second->keyword.begin;
      warning.fix({read.range.file, begin, begin}, "sensors " + read.written + "\n  ");
    }
  }
}

}  // namespace glider::frontend
