// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/states/lower_state.h"

#include "frontend/sema/declarations/formal_ranges.h"
#include "frontend/sema/declarations/variables.h"
#include "frontend/sema/expressions/evaluate.h"
#include "frontend/sema/states/lower_case.h"
#include "frontend/sema/states/lower_sample.h"
#include "frontend/sema/states/lower_statement.h"
#include "frontend/sema/states/moving_place.h"
#include "support/check.h"
#include "support/diagnostics/ids/meaning.h"

#include <algorithm>
#include <utility>

namespace glider::frontend {

namespace {

/// The place of a kind of member in ast::Member.
template <typename T>
constexpr size_t indexOf() {
  using Node = decltype(ast::Member::node);
  return []<size_t... k>(std::index_sequence<k...>) {
    size_t found = 0;
    ((std::is_same_v<std::variant_alternative_t<k, Node>, T> ? found = k : found), ...);
    return found;
  }(std::make_index_sequence<std::variant_size_v<Node>>());
}

void enterVariables(StateDeclaration& state, Scope& scope) {
  for (const ast::Member& member : state.node->members) {
    if (const auto* variable = std::get_if<ast::Var>(&member.node)) {
      enterName(variable->name, NamedKind::StateVariable, state.names, scope);
    }
  }
}

/// Enters the names of a state's parameters, which the first state cannot have, and variables.
void declareNames(ir::StateId id, Scope& scope) {
  StateDeclaration& state = scope.state_declarations[id.index];
  const ast::Name& name = state.node->name;
  state.signature = scope.signatureOf(name, listOf(state.node->formals), "a parameter of a state");
  settleRanges(state.signature, scope);
  if (id.index == 0 && !state.signature.formals.empty()) {
    scope.report(support::diagnostics::firstStateParameters, name.where, name.text);
    state.signature.valid = false;
  }
  Context context;
  context.names = &state.names;
  const Scope::Within within(scope, context);
  for (const Signature::Formal& formal : state.signature.formals) {
    Named* named = enterName(*formal.name, NamedKind::StateParameter, state.names, scope);
    if (named == nullptr) {
      state.signature.valid = false;
      continue;
    }
    named->type = formal.type;
    named->valid = state.signature.valid;
    makeParameter(*named, ir::VariableKind::Argument, id, name.text + "." + formal.name->text,
                  scope, {formal.lowest, formal.highest});
    state.parameters.push_back(named->variable);
    if (formal.type.position) {
      state.parameters.push_back(named->longitude);
    }
  }
  enterVariables(state, scope);
}

}  // namespace

void declareStates(const ast::File& file, Scope& scope) {
  for (const ast::Item& item : file.items) {
    const auto* state = std::get_if<ast::State>(&item);
    if (state == nullptr) {
      continue;
    }
    const ir::StateId id{static_cast<uint32_t>(scope.state_declarations.size())};
    const auto [place, fresh] = scope.states.emplace(state->name.text, id);
    if (!fresh) {
      const StateDeclaration& other = scope.state_declarations[place->second.index];
      scope.report(support::diagnostics::duplicateName, state->name.where, state->name.text)
          .note(other.node->name.where, "the first is here");
      continue;
    }
    scope.state_declarations.emplace_back().node = state;
    declareNames(id, scope);
  }
}

namespace {

/// The range of the state before its events.
support::SourceRange headOf(const ast::State& state) {
  support::SourceRange head = state.where;
  for (const ast::Member& member : state.members) {
    if (std::holds_alternative<ast::EventsMember>(member.node)) {
      head.end = std::min(head.end, member.where.begin);
    }
  }
  return head;
}

/// The range of its parameters, without the parentheses; empty if it has none.
support::SourceRange formalsOf(const ast::State& state) {
  const std::span<const ast::Formal> formals = listOf(state.formals);
  if (formals.empty()) {
    return {};
  }
  support::SourceRange range = formals.front().name.where;
  range.end = formals.back().type.where.end;
  return range;
}

}  // namespace

ir::State StateLowering::run() {
  result_.name = state_.name.text;
  result_.range = state_.name.where;
  result_.head = headOf(state_);
  result_.formals = formalsOf(state_);
  result_.parameters = declaration_.parameters;
  Context context;
  context.names = &declaration_.names;
  context.state = id_;
  const Scope::Within within(scope_, context);
  // In a fixed order, not that of the text: names first, and what guards read is checked against
  // `sensors`.
  visitAll(indexOf<ast::Var>());
  scope_.context.list = ir::ListKind::State;
  visitAll(indexOf<ast::RouteMember>());
  visitAll(indexOf<ast::ProfileMember>());
  if (!seen_.contains(indexOf<ast::ProfileMember>())) {
    scope_.report(support::diagnostics::noFlightprofile, state_.name.where, state_.name.text);
  }
  if (!seen_.contains(indexOf<ast::RouteMember>())) {
    const ast::Use none{{"noheading", state_.name.where}, false, {}, state_.name.where};
    result_.route = activity(none, ir::BehaviourKind::Route);
  }
  scope_.context.activities = &result_;
  visitAll(indexOf<ast::SensorsMember>());
  visitAll(indexOf<ast::SampleMember>());
  visitAll(indexOf<ast::EntryMember>());
  visitAll(indexOf<ast::EventsMember>());
  return std::move(result_);
}

void StateLowering::visitAll(size_t kind) {
  for (const ast::Member& member : state_.members) {
    if (member.node.index() == kind) {
      std::visit([&](const auto& node) { visit(node, member); }, member.node);
    }
  }
}

bool StateLowering::first(const ast::Member& member) {
  const auto [place, fresh] = seen_.emplace(member.node.index(), &member);
  if (!fresh) {
    scope_
        .report(support::diagnostics::memberTwice, member.keyword,
                "state `" + state_.name.text + "`", scope_.text(member.keyword))
        .note(place->second->keyword, "the first is here");
  }
  return fresh;
}

void StateLowering::visit(const ast::RouteMember& node, const ast::Member& member) {
  if (first(member)) {
    result_.route = activity(node.use, ir::BehaviourKind::Route);
    warnOfMovingPlaces(node.use, scope_);
  }
}

void StateLowering::visit(const ast::ProfileMember& node, const ast::Member& member) {
  if (first(member)) {
    result_.profile = activity(node.use, ir::BehaviourKind::Profile);
  }
}

void StateLowering::visit(const ast::Var& node, const ast::Member&) {
  lowerVariable(node, {ir::VariableKind::State, id_, state_.name.text + "."}, declaration_.names,
                scope_);
}

void StateLowering::visit(const ast::EntryMember& node, const ast::Member& member) {
  if (first(member)) {
    result_.entry = StatementLowering(scope_).lower(node.block.statements);
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

void StateLowering::visit(const ast::SampleMember& node, const ast::Member& member) {
  if (first(member)) {
    result_.sampling = lowerSample(node, member.keyword, scope_);
  }
}

void StateLowering::lowerItem(const ast::SensorItem& item) {
  const platforms::PlatformSensor* sensor = scope_.findSensor(item.name.text);
  const bool clock = findClock(item.name.text).has_value();
  if (sensor == nullptr && !clock) {
    const Named* named = scope_.findNamed(item.name.text);
    if (named != nullptr || scope_.findConstant(item.name.text) != nullptr) {
      scope_.report(support::diagnostics::notLogged, item.name.where, item.name.text,
                    named != nullptr ? describe(named->kind) : "a constant");
    } else if (!scope_.refused_names.contains(item.name.text) &&
               !scope_.refuseVehicle(item.name.text, item.name.where)) {
      scope_.reportUnknown(support::diagnostics::unknownSensor, item.name.where,
                           scope_.suggestSensor(item.name.text), scope_.platform().name,
                           item.name.text);
    }
    return;
  }
  const auto [place, fresh] = listed_.emplace(clock ? item.name.text : sensor->name, &item.name);
  if (!fresh) {
    scope_.report(support::diagnostics::sensorTwice, item.name.where, item.name.text)
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
    scope_.report(support::diagnostics::notConstant, every.where, scope_.text(every.where),
                  "the time of `every`");
    return;
  }
  if (!(*period > 0)) {
    scope_.report(support::diagnostics::everyNotPositive, every.where, *period);
    return;
  }
  for (size_t i = from; i < result_.log.size(); ++i) {
    result_.log[i].period_s = *period;
  }
}

void StateLowering::visit(const ast::EventsMember& node, const ast::Member& member) {
  if (first(member)) {
    result_.cases = CaseLowering(scope_).lower(
        node.cases, [&](const std::vector<SensorRead>& reads) { warnOfUnlisted(reads, node); });
  }
}

/// Whether an error is in the list of sensors, or in the case that reads: it may be the reason why
/// a sensor is not found.
bool StateLowering::isDoubtful(const SensorRead& read, const ast::EventsMember& events) const {
  const auto list = seen_.find(indexOf<ast::SensorsMember>());
  const support::DiagnosticEngine& diagnostics = scope_.diagnostics();
  return (list != seen_.end() && diagnostics.hasErrorIn(list->second->where)) ||
         std::ranges::any_of(events.cases, [&](const ast::Case& one) {
           return one.where.begin <= read.range.begin && read.range.begin < one.where.end &&
                  diagnostics.hasErrorIn(one.where);
         });
}

void StateLowering::warnOfUnlisted(const std::vector<SensorRead>& reads,
                                   const ast::EventsMember& node) {
  const auto list = seen_.find(indexOf<ast::SensorsMember>());
  for (const SensorRead& read : reads) {
    if (read.implied || listed_.contains(read.sensor->name) ||
        !warned_.emplace(read.sensor->name, true).second || isDoubtful(read, node)) {
      continue;
    }
    auto warning = scope_.report(support::diagnostics::unlistedSensor, read.range, state_.name.text,
                                 read.written);
    if (list != seen_.end()) {
      const uint32_t end = list->second->where.end;
      warning.fix({read.range.file, end, end}, ", " + read.written);
    } else {
      const auto events = seen_.find(indexOf<ast::EventsMember>());
      CHECK(events != seen_.end(), "a guard outside events");
      const support::SourceRange& keyword = events->second->keyword;
      if (keyword.begin == keyword.end) {
        continue;  // the word is missing, and its own fix comes first
      }
      const uint32_t begin = keyword.begin;
      warning.fix({read.range.file, begin, begin}, "sensors " + read.written + "\n  ");
    }
  }
}

}  // namespace glider::frontend
