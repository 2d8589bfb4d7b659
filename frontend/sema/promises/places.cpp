// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/promises/places.h"

#include "frontend/sema/expressions/lower_expr.h"
#include "frontend/spelling.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

namespace glider::frontend {

namespace {

/// True, and reported, if `name` is not the name of anything: a state is meant.
bool refuseUnknown(const std::string& name, const support::SourceRange& range, Scope& scope) {
  if (scope.findNamed(name) != nullptr || scope.findConstant(name) != nullptr ||
      scope.findSensor(name) != nullptr || scope.refused_names.contains(name) ||
      !scope.takenBy(name).empty() || meansValue(name, range, scope)) {
    return false;
  }
  std::vector<std::string_view> names;
  for (const auto& [known, number] : scope.states) {
    names.push_back(known);
  }
  for (const auto& [known, node] : scope.places) {
    names.push_back(known);
  }
  std::string all = scope.listedStates();
  for (const auto& [known, node] : scope.places) {
    all += fmt::format("{}{}", &known == &scope.places.begin()->first ? "; places: " : ", ", known);
  }
  scope.reportUnknown(support::diagnostics::unknownState, range, didYouMean(name, names, all),
                      name);
  return true;
}

/// The condition of a place; empty, and reported, if it is none.
std::optional<ir::ExprId> placeCondition(const ast::Expr& expr, Scope& scope) {
  const size_t uses = scope.mission.uses.size();
  const auto lowered = ExprLowering(scope).lowerCondition(expr);
  if (lowered && scope.mission.uses.size() > uses) {
    const ir::FunctionUse& use = scope.mission.uses[uses];
    scope.report(support::diagnostics::requirementCalls, use.range,
                 scope.mission.functions[use.function.index].name);
    return std::nullopt;
  }
  return lowered;
}

/// The operands of `||`, `&&` and `!`; empty for anything else.
std::vector<const ast::Expr*> partsOf(const ast::Expr& expr) {
  if (const auto* unary = std::get_if<ast::Unary>(&expr.node)) {
    return unary->op == ast::UnaryOp::Not ? std::vector<const ast::Expr*>{&*unary->operand}
                                          : std::vector<const ast::Expr*>();
  }
  const auto* binary = std::get_if<ast::Binary>(&expr.node);
  if (binary == nullptr || (binary->op != ast::BinaryOp::And && binary->op != ast::BinaryOp::Or)) {
    return {};
  }
  return {&*binary->left, &*binary->right};
}

ir::Op opOf(const ast::Expr& expr) {
  const auto* binary = std::get_if<ast::Binary>(&expr.node);
  return binary == nullptr                  ? ir::Op::Not
         : binary->op == ast::BinaryOp::And ? ir::Op::And
                                            : ir::Op::Or;
}

/// Whether a state or a `place` is among what `||`, `&&` and `!` combine.
// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
bool namesPlace(const ast::Expr& expr, const Scope& scope) {
  if (const auto* use = std::get_if<ast::NameUse>(&expr.node)) {
    return scope.states.contains(use->name) || scope.places.contains(use->name);
  }
  const auto parts = partsOf(expr);
  return std::ranges::any_of(parts,
                             [&](const ast::Expr* part) { return namesPlace(*part, scope); });
}

}  // namespace

bool combinesPlaces(const ast::Expr& expr, const Scope& scope) {
  return !partsOf(expr).empty() && namesPlace(expr, scope);
}

void declarePlaces(const ast::File& file, Scope& scope) {
  for (const ast::Item& item : file.items) {
    const auto* node = std::get_if<ast::PlaceDeclaration>(&item);
    if (node == nullptr || scope.refuseName(node->name, "a place") ||
        scope.refuseSecond(node->name)) {
      continue;
    }
    const auto [first, entered] = scope.places.emplace(node->name.text, node);
    const auto state = scope.states.find(node->name.text);
    const ast::Name* other = !entered ? &first->second->name
                             : state != scope.states.end()
                                 ? &scope.state_declarations[state->second.index].node->name
                                 : nullptr;
    if (other != nullptr) {
      scope.report(support::diagnostics::duplicateName, node->name.where, node->name.text)
          .note(other->where, "the first is here");
    }
  }
}

namespace {

/// Places name each other at most so deep: one that names itself is refused there.
constexpr size_t kDeepest = 4;

/// Within `deep` declarations of places.
// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
std::optional<PromisedPlace> placeWithin(const ast::Expr& expr, Scope& scope, size_t deep) {
  PromisedPlace place;
  place.words = fmt::format("`{}`", scope.text(expr.where));
  if (const auto* use = std::get_if<ast::NameUse>(&expr.node)) {
    if (const auto state = scope.states.find(use->name); state != scope.states.end()) {
      place.state = state->second;
      return place;
    }
    const auto named = scope.places.find(use->name);
    if (named != scope.places.end() && deep < kDeepest) {
      scope.used_places.insert(named->second);
      auto meant = placeWithin(named->second->condition, scope, deep + 1);
      if (meant) {
        meant->words = place.words;
      }
      return meant;
    }
    if (named == scope.places.end() && refuseUnknown(use->name, expr.where, scope)) {
      return std::nullopt;
    }
  }
  if (combinesPlaces(expr, scope)) {
    place.op = opOf(expr);
    for (const ast::Expr* part : partsOf(expr)) {
      auto lowered = placeWithin(*part, scope, deep);
      if (!lowered) {
        return std::nullopt;
      }
      place.parts.push_back(*std::move(lowered));
    }
    return place;
  }
  const auto lowered = placeCondition(expr, scope);
  if (!lowered) {
    return std::nullopt;
  }
  place.condition = *lowered;
  return place;
}

}  // namespace

std::optional<PromisedPlace> lowerPlace(const ast::Expr& expr, Scope& scope) {
  return placeWithin(expr, scope, 0);
}

void checkUnusedPlaces(Scope& scope) {
  if (scope.used_places.size() == scope.places.size()) {
    return;  // a trial copies the mission
  }
  const Scope::Trial trial(scope);
  for (const auto& [name, node] : scope.places) {
    if (!scope.used_places.contains(node)) {
      (void)lowerPlace(node->condition, scope);
    }
  }
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
ir::ExprId Sight::now(const PromisedPlace& place, ir::ObservationKind kind) {
  if (place.state.valid()) {
    return monitor_.observed(kind, place.state);
  }
  if (place.parts.empty()) {
    return place.condition;
  }
  std::vector<ir::ExprId> parts;
  for (const PromisedPlace& part : place.parts) {
    parts.push_back(now(part, ir::ObservationKind::Inside));
  }
  return monitor_.operation(place.op, parts);
}

ir::ExprId Sight::begins(const PromisedPlace& place) {
  if (place.state.valid()) {
    return visited(place);
  }
  const ir::VariableId before = monitor_.flag("before");
  const ir::ExprId is = monitor_.isTrue(holds(place));
  monitor_.atEnd([this_monitor = &monitor_, before, is] { this_monitor->set(before, is); });
  return monitor_.both(is, monitor_.negation(monitor_.read(before)));
}

}  // namespace glider::frontend
