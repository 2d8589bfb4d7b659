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

/// "commands: descend, ascend, …"
std::string commandsText(const std::vector<VehicleCommand>& commands) {
  std::string all;
  for (const VehicleCommand& each : commands) {
    all += (all.empty() ? "commands: " : ", ") + each.name;
  }
  return all;
}

}  // namespace

ir::Statement statementOf(ir::StatementKind kind, const support::SourceRange& range) {
  ir::Statement result;
  result.kind = kind;
  result.range = range;
  return result;
}

ir::BlockId StatementLowering::lower(const std::vector<ast::Statement>& statements) {
  ir::Block block;
  lowerInto(block, statements);
  return ir::MissionWriter(scope_.mission).add(std::move(block));
}

void StatementLowering::lowerInto(ir::Block& block, const std::vector<ast::Statement>& statements) {
  for (const ast::Statement& statement : statements) {
    scope_.loops.statements += scope_.context.pass != nullptr ? 1U : 0U;
    std::visit([&](const auto& node) { visit(node, statement, block); }, statement.node);
  }
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

/// Of a longer text both logs keep the begin, and the vehicle's has no room for a value.
void StatementLowering::checkLength(const std::string& text, const ast::Statement& statement) {
  constexpr size_t kRoomForValue = 2;
  if (text.size() + kRoomForValue > kNoteBytes) {
    scope_.report(support::diagnostics::longLog, statement.where, text.size(), kNoteBytes);
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
  checkLength(result.text, statement);
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
  if (name == "push") {
    return push(node.call, statement, block);
  }
  const auto& commands = vehicleCommands(scope_.platform());
  const auto command = std::ranges::find(commands, name, &VehicleCommand::name);
  if (command == commands.end() && isCommandName(name)) {
    scope_.report(support::diagnostics::commandOfAnother, node.call.function.where, name,
                  scope_.platform().name, commandsText(commands));
    return;
  }
  if (command == commands.end()) {
    std::vector<std::string_view> known;
    for (const VehicleCommand& each : commands) {
      known.push_back(each.name);
    }
    const std::string all = commandsText(commands);
    const bool function = isFunctionName(name);
    const bool behaviour = scope_.behaviours.contains(name);
    scope_.reportUnknown(
        support::diagnostics::unknownCommand, node.call.function.where,
        function ? Suggestion{"`" + name + "` is a function: use it in the value of a `set`", ""}
        : name == "append" ? Suggestion{"write `push`", ""}
        : behaviour        ? Suggestion{"`" + name +
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
