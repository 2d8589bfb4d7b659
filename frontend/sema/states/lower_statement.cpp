// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/states/lower_statement.h"

#include "frontend/sema/expressions/evaluate.h"
#include "frontend/sema/expressions/lower_arguments.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "frontend/sema/names/commands.h"
#include "frontend/sema/names/functions.h"
#include "frontend/spelling.h"
#include "ir/core/mission_writer.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::frontend {

namespace {

ir::Statement statementOf(ir::StatementKind kind, const support::SourceRange& range) {
  ir::Statement result;
  result.kind = kind;
  result.range = range;
  return result;
}

/// The text between the quotes, or where a backslash precedes anything but `"` or `\`.
struct Unquoted {
  std::string text;
  std::optional<size_t> wrong;
};
Unquoted unquote(std::string_view quoted) {
  Unquoted result;
  for (size_t i = 1; i + 1 < quoted.size(); ++i) {
    if (quoted[i] == '\\') {
      ++i;
      if (quoted[i] != '"' && quoted[i] != '\\') {
        result.wrong = result.wrong.value_or(i - 1);
      }
    }
    result.text += quoted[i];
  }
  return result;
}

}  // namespace

ir::BlockId StatementLowering::lower(const std::vector<ast::Statement>& statements) {
  ir::Block block;
  for (const ast::Statement& statement : statements) {
    std::visit([&](const auto& node) { visit(node, statement, block); }, statement.node);
  }
  return ir::MissionWriter(scope_.mission).add(std::move(block));
}

void StatementLowering::visit(const ast::Set& node, const ast::Statement& statement,
                              ir::Block& block) {
  Named* named = settable(node.variable);
  if (named == nullptr) {
    return;
  }
  named->written = true;
  const auto* use = std::get_if<ast::NameUse>(&node.value.node);
  if (use != nullptr && use->name == node.variable.text) {
    scope_.report(support::diagnostics::setToItself, statement.where, node.variable.text);
  }
  const bool read = named->read;
  ExprLowering lowering(scope_);
  const auto value =
      lowering.lowerDeclared(node.value, named->type, "`" + node.variable.text + "`");
  named->read = read;  // only counting up does not count as a use of a variable
  if (!value || !named->valid ||
      lowering.scalesDiffer({{}, {}, {}, named->scale}, node.variable.where, *value,
                            node.value.where, "set")) {
    return;
  }
  ir::Statement set = statementOf(ir::StatementKind::Set, statement.where);
  set.variable = named->variable;
  set.value = value->id;
  block.statements.push_back(set);
  if (named->type.position) {
    set.variable = named->longitude;
    set.value = value->longitude;
    block.statements.push_back(set);
  }
}

Named* StatementLowering::settable(const ast::Name& name) {
  Named* named = scope_.findNamed(name.text);
  if (named != nullptr && isVariable(named->kind)) {
    return named;
  }
  if (named == nullptr) {
    refuseSet(name);
    return nullptr;
  }
  const bool parameter = named->kind == NamedKind::Parameter;
  scope_
      .report(support::diagnostics::cannotSet, name.where, name.text, describe(named->kind),
              parameter ? "make it a `var`, or `set` a `var` that has it as its initial value"
                        : "declare a `var` with this initial value, and `set` that")
      .note(named->name->where, "it is declared here");
  return nullptr;
}

void StatementLowering::refuseSet(const ast::Name& name) {
  if (const Constant* constant = scope_.findConstant(name.text)) {
    scope_
        .report(support::diagnostics::cannotSet, name.where, name.text, "a constant",
                "declare it with `var` and a type")
        .note(constant->name->where, "it is declared here");
    return;
  }
  if (scope_.refused_names.contains(name.text)) {
    return;
  }
  const bool own = scope_.own_sensors.contains(name.text);
  if (const std::string what = own ? "a sensor" : scope_.takenBy(name.text); !what.empty()) {
    scope_.report(support::diagnostics::cannotSet, name.where, name.text, what,
                  "use a `var` for a value of your own");
    return;
  }
  if (scope_.refuseUnseen(name.text, name.where)) {
    return;
  }
  std::vector<std::string_view> known;
  for (const Names* list : scope_.visibleNames()) {
    for (const auto& [text, named] : *list) {
      if (isVariable(named.kind)) {
        known.push_back(text);
      }
    }
  }
  scope_.reportUnknown(
      support::diagnostics::unknownVariable, name.where,
      didYouMean(name.text, known, fmt::format("declare it: `var {}: type = value`", name.text)),
      name.text);
}

void StatementLowering::visit(const ast::If& node, const ast::Statement& statement,
                              ir::Block& block) {
  ExprLowering lowering(scope_);
  const auto condition = lowering.lowerCondition(node.condition);
  ir::Statement result = statementOf(ir::StatementKind::If, statement.where);
  result.then = lower(node.then);
  if (node.otherwise) {
    result.otherwise = lower(*node.otherwise);
  }
  if (condition) {
    result.value = *condition;
    block.statements.push_back(std::move(result));
  }
}

void StatementLowering::visit(const ast::Log& node, const ast::Statement& statement,
                              ir::Block& block) {
  ir::Statement result = statementOf(ir::StatementKind::Log, statement.where);
  const Unquoted text = unquote(node.text);
  if (text.wrong) {
    scope_.report(support::diagnostics::badEscape, statement.where,
                  std::string_view(node.text).substr(*text.wrong, 2));
  }
  result.text = text.text;
  for (const ast::Expr& expr : node.values) {
    ExprLowering lowering(scope_);
    if (const auto value = lowering.lower(expr, std::nullopt)) {
      result.values.push_back(value->id);
      if (value->longitude.valid()) {
        result.values.push_back(value->longitude);
      }
    }
  }
  block.statements.push_back(std::move(result));
}

void StatementLowering::visit(const ast::Command& node, const ast::Statement& statement,
                              ir::Block& block) {
  const std::string& name = node.call.function.text;
  const auto& commands = vehicleCommands();
  const auto command = std::ranges::find(commands, name, &VehicleCommand::name);
  if (command == commands.end()) {
    std::vector<std::string_view> known;
    std::string all;
    for (const VehicleCommand& each : commands) {
      known.push_back(each.name);
      all += (all.empty() ? "commands: " : ", ") + each.name;
    }
    const bool function = isFunctionName(name);
    const bool behaviour = scope_.behaviours.contains(name);
    scope_.reportUnknown(
        support::diagnostics::unknownCommand, node.call.function.where,
        function    ? Suggestion{"`" + name + "` is a function: use it in the value of a `set`", ""}
        : behaviour ? Suggestion{"`" + name +
                                     "` controls how a state flies: use it in the state's "
                                     "`flight…` line",
                                 ""}
                    : didYouMean(name, known, all),
        name);
    return;
  }
  ir::Statement result = statementOf(ir::StatementKind::Command, statement.where);
  result.command = command->command;
  const Callee callee{command->name, command->signature};
  auto arguments = lowerArguments(node.call.arguments, callee, statement.where, scope_);
  if (arguments) {
    result.values = std::move(arguments->values);
    block.statements.push_back(std::move(result));
  }
}

}  // namespace glider::frontend
