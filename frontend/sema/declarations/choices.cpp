// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/declarations/choices.h"

#include "frontend/sema/declarations/declared_value.h"
#include "frontend/sema/declarations/only_item.h"
#include "frontend/sema/expressions/evaluate.h"
#include "frontend/spelling.h"
#include "ir/eval/arithmetic.h"
#include "support/diagnostics/ids/meaning.h"
#include "support/diagnostics/ids/syntax.h"
#include "support/units/units.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace glider::frontend {
namespace {

/// The constant of a choice; null: it was refused.
const Constant* constantOf(const ast::Choice& node, Scope& scope) {
  const auto found = scope.constants.find(node.constant.name.text);
  const bool good = found != scope.constants.end() && found->second.name == &node.constant.name &&
                    found->second.valid;
  return good ? &found->second : nullptr;
}

/// The distance between the values that are tried; 0: the line names none; empty, and reported, if
/// it is not one.
std::optional<double> stepOf(const ast::Choice& node, const Bounds& bounds, DeclaredValue& lowering,
                             Scope& scope) {
  if (!node.step) {
    return 0;
  }
  const auto step = lowering.constant(*node.step, "the distance of what can be chosen");
  const double span = bounds.highest - bounds.lowest;
  if (step && !(step->first > 0 && (step->first <= span || span == 0))) {
    scope
        .report(support::diagnostics::choiceStep, node.step->where, node.constant.name.text,
                scope.text(node.step->where),
                step->first > 0 ? "write at most what the range spans" : "write a distance above 0")
        .note(whole(node.range), "its range is here");
    return std::nullopt;
  }
  return step ? std::optional(step->first) : std::nullopt;
}

/// The unit of a number, also with a sign, or of the first in a sum or product.
std::string unitOf(const ast::Expr& expr) {
  const ast::Expr* at = &expr;
  while (std::get_if<ast::Literal>(&at->node) == nullptr) {
    if (const auto* unary = std::get_if<ast::Unary>(&at->node)) {
      at = &*unary->operand;
    } else if (const auto* binary = std::get_if<ast::Binary>(&at->node)) {
      at = &*binary->left;
    } else {
      return "";
    }
  }
  return std::get<ast::Literal>(at->node).unit;
}

/// The unit in which the range is written, if that is of its type; empty: none is.
std::string unitOf(const ast::Choice& node, const ir::Type& type) {
  for (const ast::Expr* expr : {&node.range.lowest, &node.range.highest}) {
    const std::string unit = unitOf(*expr);
    const auto known = support::parseUnit(unit);
    if (known && known->dimension == type.dimension) {
      return unit;
    }
  }
  return "";
}

/// A written value may differ from an end of the range by rounding.
constexpr double kRounding = 1e-9;

/// False, and reported, if the written value is out of bounds.
bool isInside(const ast::Choice& node, double value, const Bounds& bounds,
              DeclaredValue& lowering) {
  const double nearest = std::clamp(value, bounds.lowest, bounds.highest);
  const bool rounded =
      std::fabs(nearest - value) <= kRounding * std::max(std::fabs(nearest), std::fabs(value));
  return lowering.inside(rounded ? nearest : value, bounds, node.constant.value, node.range);
}

std::optional<OpenChoice> readChoice(const ast::Choice& node, const Constant& constant,
                                     Scope& scope) {
  const DeclaredType type{constant.type, constant.position};
  if (type.type.kind != ir::TypeKind::Quantity) {
    scope.report(support::diagnostics::rangeOfWhat, whole(node.range), node.constant.name.text,
                 describe(type));
    return std::nullopt;
  }
  DeclaredValue lowering(node.constant.name, type, scope);
  const size_t open = scope.open_reads;
  const auto bounds = lowering.bounds(node.range);
  const auto step = bounds ? stepOf(node, *bounds, lowering, scope) : std::nullopt;
  if (scope.open_reads != open) {
    scope.report(support::diagnostics::openRange, whole(node.range), node.constant.name.text);
    return std::nullopt;
  }
  if (!step || !isInside(node, constant.number, *bounds, lowering)) {
    return std::nullopt;
  }
  return OpenChoice{node.constant.name.text,
                    constant.type,
                    unitOf(node, constant.type),
                    bounds->lowest,
                    bounds->highest,
                    *step,
                    node.written};
}

/// What `where` demands may name any choice, and so comes after all of them.
void checkCondition(const ast::Choice& node, Scope& scope) {
  if (!node.condition) {
    return;
  }
  const DeclaredType truth{boolean()};
  const auto kept = DeclaredValue(node.constant.name, truth, scope)
                        .constant(*node.condition, "a condition of what is chosen");
  if (kept && kept->first == 0 && node.chosen) {
    scope.report(support::diagnostics::choiceOutside, node.constant.value.where,
                 scope.text(node.condition->where));
  }
}

/// What its line lacks is more than a value if an error is in it.
void warnOfOpen(const ast::Choice& node, Scope& scope) {
  if (scope.diagnostics().hasErrorIn(node.where)) {
    return;
  }
  const std::string lowest = scope.text(node.range.lowest.where);
  scope.report(support::diagnostics::notChosen, node.constant.name.where, node.constant.name.text,
               lowest,
               fmt::format("choose {} : {} = {} in …", node.constant.name.text,
                           node.constant.type->text, lowest));
}

/// "`bottom` or `hours`": what can be preferred.
std::string choicesOf(const Scope& scope) {
  constexpr size_t kMost = 3;
  std::vector<std::string> names;
  for (const auto& [name, constant] : scope.constants) {
    if (constant.choice && names.size() < kMost) {
      names.push_back(fmt::format("`{}`", name));
    }
  }
  return fmt::format("{}", fmt::join(names, " or "));
}

/// `least energyused`, `greatest endurance`, `greatest depth`: names of what only the flight will
/// tell. True if that was reported.
bool refuseUnchosen(const ast::Objective& node, Scope& scope) {
  constexpr std::array<std::string_view, 9> kEnergy = {"endurance", "energyused",  "energyleft",
                                                       "energy",    "power",       "battery",
                                                       "charge",    "consumption", "batteries"};
  const auto* use = std::get_if<ast::NameUse>(&node.value->node);
  if (use == nullptr || scope.findConstant(use->name) != nullptr ||
      scope.refused_names.contains(use->name)) {
    return false;
  }
  const support::SourceRange& where = node.value->where;
  if (std::ranges::find(kEnergy, use->name) != kEnergy.end()) {
    const bool used = use->name != "endurance" && use->name != "energyleft";
    auto report = scope.report(support::diagnostics::unexpectedToken, node.where, "`endurance`",
                               fmt::format("`{}`", scope.text(node.where)));
    report.hint("write `endurance`: it prefers the least energy");
    if (used == (node.aim == ast::Aim::Least)) {
      report.fix(node.where, "endurance");
    }
    return true;
  }
  std::vector<std::string_view> names;
  for (const auto& [name, constant] : scope.constants) {
    names.push_back(name);
  }
  const Named* named = scope.findNamed(use->name);
  if (named == nullptr && !didYouMean(use->name, names, "").hint.empty()) {
    return false;  // a name that is spelled wrong
  }
  auto report =
      scope.report(support::diagnostics::notConstant, where, use->name, "what is preferred");
  report.hint(fmt::format("only what is chosen can be preferred: {}", choicesOf(scope)));
  if (named != nullptr) {
    report.note(named->name->where, fmt::format("it is {}", describe(named->kind)));
  }
  return true;
}

/// Evaluates what is preferred; empty, and reported, if it must wait for the flight.
std::optional<OpenObjective> readObjective(const ast::Objective& node, Scope& scope) {
  OpenObjective made{node.aim, 0, plainNumber(), node.where};
  if (!node.value) {
    return made;
  }
  if (refuseUnchosen(node, scope)) {
    return std::nullopt;
  }
  Context context;
  context.constant = "what is preferred";
  const Scope::Within within(scope, context);
  const size_t before = scope.mission.exprs.size();
  const auto value = ExprLowering(scope).lower(*node.value, std::nullopt);
  const auto number = value ? evaluate(scope.mission, value->id) : std::nullopt;
  scope.mission.exprs.resize(before);
  if (!value) {
    return std::nullopt;
  }
  if (!number || value->longitude.valid() || value->type == boolean()) {
    scope.report(support::diagnostics::notConstant, node.value->where,
                 scope.text(node.value->where), "what is preferred");
    return std::nullopt;
  }
  const double score = number.value_or(ir::kUnknown);
  if (!ir::isKnown(score)) {
    scope.report(support::diagnostics::constantUnknown, node.value->where,
                 scope.text(node.value->where));
    return std::nullopt;
  }
  made.value = score;
  made.type = value->type;
  made.range = node.value->where;
  return made;
}

std::vector<OpenObjective> readPreference(const ast::File& mission, bool open, Scope& scope) {
  const auto* line = onlyItem<ast::Preference>(mission, [&](const auto& again, const auto& first) {
    scope.report(support::diagnostics::preferTwice, again.where)
        .note(first.where, "the first is here");
  });
  std::vector<OpenObjective> objectives;
  if (line == nullptr) {
    return objectives;
  }
  if (!open) {
    scope.report(support::diagnostics::nothingToPrefer, line->where);
    return objectives;
  }
  for (const ast::Objective& one : line->objectives) {
    if (auto made = readObjective(one, scope)) {
      objectives.push_back(*made);
    }
  }
  return objectives;
}

}  // namespace

LeftOpen checkChoices(const ast::File& mission, Scope& scope) {
  LeftOpen open;
  std::vector<const ast::Choice*> nodes;
  for (const ast::Item& item : mission.items) {
    if (const auto* node = std::get_if<ast::Choice>(&item)) {
      nodes.push_back(node);
    }
  }
  for (const ast::Choice* node : nodes) {
    const Constant* constant = constantOf(*node, scope);
    auto choice = constant != nullptr ? readChoice(*node, *constant, scope) : std::nullopt;
    if (choice) {
      open.choices.push_back(std::move(*choice));
    }
    if (choice && !node->chosen) {
      warnOfOpen(*node, scope);
    }
  }
  for (const ast::Choice* node : nodes) {
    checkCondition(*node, scope);
  }
  open.objectives = readPreference(mission, !nodes.empty(), scope);
  return open;
}

}  // namespace glider::frontend
