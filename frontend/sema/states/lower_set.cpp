// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What changes variables: `set`, and `push` of an array. An index that is not known when the
// mission is compiled becomes a choice among all elements.

#include "frontend/sema/expressions/lower_expr.h"
#include "frontend/sema/states/lower_statement.h"
#include "frontend/spelling.h"
#include "ir/core/mission_writer.h"
#include "ir/core/walk.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::frontend {

namespace {

/// `temps[2]` of `set temps[2] = …`.
support::SourceRange targetOf(const ast::Set& node) {
  support::SourceRange range = node.variable.where;
  if (node.index) {
    range.end = node.index->where.end + 1;
  }
  return range;
}

/// `set n = n`, `set temps[i] = temps[i]`
bool isItself(const ast::Set& node) {
  if (node.index) {
    const auto* element = std::get_if<ast::Index>(&node.value.node);
    return element != nullptr && element->list.text == node.variable.text &&
           *element->position == *node.index;
  }
  const auto* use = std::get_if<ast::NameUse>(&node.value.node);
  return use != nullptr && use->name == node.variable.text;
}

support::SourceRange argumentsOf(const ast::Invocation& call) {
  support::SourceRange range = call.arguments.front().value->where;
  range.end = call.arguments.back().value->where.end;
  return range;
}

/// Sets a variable, or both halves of a position.
void add(const Element& target, const Value& value, const support::SourceRange& range,
         ir::Block& block) {
  ir::Statement set = statementOf(ir::StatementKind::Set, range);
  set.variable = target.variable;
  set.value = value.id;
  block.statements.push_back(set);
  if (target.longitude.valid()) {
    set.variable = target.longitude;
    set.value = value.longitude;
    block.statements.push_back(set);
  }
}

}  // namespace

void StatementLowering::visit(const ast::Set& node, const ast::Statement& statement,
                              ir::Block& block) {
  Named* named = settable(node.variable);
  if (named == nullptr) {
    return;
  }
  named->written = true;
  if (misindexed(*named, node)) {
    return;
  }
  if (isItself(node)) {
    scope_.report(support::diagnostics::setToItself, statement.where, scope_.text(targetOf(node)));
  }
  const auto array = findArray(node.variable.text, scope_);
  ExprLowering lowering(scope_);
  const auto index = array && node.index ? lowering.lowerIndex(*node.index, *array)
                                         : std::optional(ElementIndex());
  const bool read = named->read;
  const auto value =
      lowering.lowerDeclared(node.value, named->type, "`" + scope_.text(targetOf(node)) + "`");
  named->read = read;  // only counting up does not count as a use of a variable
  if (!value || !index || !named->valid ||
      lowering.scalesDiffer({{}, {}, {}, named->scale}, node.variable.where, *value,
                            node.value.where, "set")) {
    return;
  }
  if (array) {
    setElement(*array, *index, *value, statement.where, block);
  } else {
    add({named->variable, named->longitude}, *value, statement.where, block);
  }
}

bool StatementLowering::misindexed(const Named& named, const ast::Set& node) {
  if (named.array == node.index.has_value()) {
    return false;
  }
  const auto array = findArray(node.variable.text, scope_);
  if (array) {
    scope_.report(support::diagnostics::arrayAsValue, node.variable.where, array->name,
                  describe(*array),
                  fmt::format("set one of them, such as `set {0}[0] = …`, or all of them: "
                              "`for i in 0 .. {1} do set {0}[i] = … end`",
                              array->name, array->size - 1));
  } else if (!named.array) {
    scope_.report(support::diagnostics::noElements, node.variable.where, node.variable.text)
        .note(named.name->where, "it is declared here");
  }
  return true;
}

void StatementLowering::setElement(const Array& array, const ElementIndex& index,
                                   const Value& value, const support::SourceRange& range,
                                   ir::Block& block) {
  if (index.known) {
    add(array.named->elements[*index.known], value, range, block);
    return;
  }
  ir::MissionWriter write(scope_.mission, range);
  ir::Statement choice = statementOf(ir::StatementKind::If, range);
  choice.value =
      write.operation(ir::Op::Equal, boolean(), {index.number, write.number(0, plainNumber())});
  ir::Block first;
  add(array.named->elements[0], value, range, first);
  choice.then = write.add(std::move(first));
  choice.otherwise = chooseElement(array, 1, index.number, value, range);
  scope_.loops.statements += scope_.context.pass != nullptr ? array.size : 0;
  block.statements.push_back(std::move(choice));
}

/// The choice among the elements from `from` on. The last one needs no test: where the number is
/// unknown, neither branch of the first test runs.
// NOLINTNEXTLINE(misc-no-recursion): as deep as an array has elements
ir::BlockId StatementLowering::chooseElement(const Array& array, size_t from, ir::ExprId number,
                                             const Value& value,
                                             const support::SourceRange& range) {
  ir::MissionWriter write(scope_.mission, range);
  ir::Block block;
  if (from + 1 == array.size) {
    add(array.named->elements[from], value, range, block);
    return write.add(std::move(block));
  }
  ir::Statement choice = statementOf(ir::StatementKind::If, range);
  choice.value = write.operation(ir::Op::Equal, boolean(),
                                 {number, write.number(static_cast<double>(from), plainNumber())});
  ir::Block here;
  add(array.named->elements[from], value, range, here);
  choice.then = write.add(std::move(here));
  choice.otherwise = chooseElement(array, from + 1, number, value, range);
  block.statements.push_back(std::move(choice));
  return write.add(std::move(block));
}

void StatementLowering::push(const ast::Invocation& call, const ast::Statement& statement,
                             ir::Block& block) {
  const auto* use = call.arguments.empty()
                        ? nullptr
                        : std::get_if<ast::NameUse>(&call.arguments.front().value->node);
  Named* named = use == nullptr ? nullptr : scope_.findNamed(use->name);
  if (named != nullptr && !named->valid) {
    return;
  }
  const auto array = use == nullptr ? std::nullopt : findArray(use->name, scope_);
  if (call.arguments.size() != 2 || !array || array->named == nullptr) {
    const size_t given = call.arguments.size();
    scope_.report(support::diagnostics::wrongArgumentCount, statement.where, "push",
                  "an array that is a variable, and a value",
                  given == 0 ? "none" : fmt::format("`{}`", scope_.text(argumentsOf(call))),
                  "push(recent, temp)");
    return;
  }
  const ast::Name name{use->name, call.arguments.front().value->where};
  if (settable(name) == nullptr) {
    return;
  }
  named->written = true;
  const ast::Expr& pushed = *call.arguments.back().value;
  ExprLowering lowering(scope_);
  const auto value = lowering.lowerDeclared(pushed, named->type, "the value of `push`");
  if (!value ||
      lowering.scalesDiffer({{}, {}, {}, named->scale}, name.where, *value, pushed.where, "push")) {
    return;
  }
  if (readsElement(*value, *array)) {
    scope_.report(support::diagnostics::pushOfItself, pushed.where, array->name);
    return;
  }
  moveBack(*array, *value, statement.where, block);
  add(named->elements.front(), *value, statement.where, block);
}

/// Whether `value` depends on an element of `array`.
bool StatementLowering::readsElement(const Value& value, const Array& array) const {
  const auto isElement = [&](const ir::Expr& e) {
    return e.op == ir::Op::Variable &&
           std::ranges::any_of(array.named->elements, [&](const Element& element) {
             return e.variable == element.variable || e.variable == element.longitude;
           });
  };
  return ir::anyIn(scope_.mission, value.id, isElement) ||
         (value.longitude.valid() && ir::anyIn(scope_.mission, value.longitude, isElement));
}

/// If `value` is known, each known element takes the place of the next, from the last one on.
void StatementLowering::moveBack(const Array& array, const Value& value,
                                 const support::SourceRange& range, ir::Block& block) {
  ir::MissionWriter write(scope_.mission, range);
  const auto isKnown = [&](ir::ExprId id) {
    if (array.type.type == boolean()) {
      return write.either(id, write.negation(id));
    }
    return write.operation(ir::Op::Known, boolean(), {id});
  };
  ir::Block moves;
  for (size_t i = array.size - 1; i > 0; --i) {
    const Element& before = array.named->elements[i - 1];
    const Value moved{write.read(before.variable), array.type.type,
                      array.type.position ? write.read(before.longitude) : ir::ExprId()};
    ir::Block move;
    const ir::ExprId there = isKnown(moved.id);
    add(array.named->elements[i], moved, range, move);
    moves.statements.push_back(write.branch(there, write.add(std::move(move))));
  }
  const ir::ExprId given = isKnown(value.id);
  block.statements.push_back(write.branch(given, write.add(std::move(moves))));
  scope_.loops.statements += scope_.context.pass != nullptr ? 2 * array.size : 0;
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
  if (const LoopPass* pass = scope_.findPass(name.text)) {
    scope_
        .report(support::diagnostics::cannotSet, name.where, name.text, "the index of a loop",
                "use a `var` for a value of your own")
        .note(pass->index.name->where, "it is declared here");
    return;
  }
  if (const Constant* constant = scope_.findConstant(name.text)) {
    scope_
        .report(support::diagnostics::cannotSet, name.where, name.text,
                constant->choice ? "chosen by `glidercc plan`" : "a constant",
                constant->choice ? "it keeps that value: `set` a `var` that has it as its initial "
                                   "value"
                                 : "declare it with `var` and a type")
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

}  // namespace glider::frontend
