// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/text/expression_reader.h"

#include "ir/core/mission_writer.h"
#include "ir/core/ops.h"
#include "ir/text/print.h"
#include "support/diagnostics/ids/ir_text.h"

namespace glider::ir::text {
namespace {

using support::SourceRange;

constexpr uint32_t kDeepestExpression = 200;

/// Leaves that name what they read.
bool named(Op op) {
  return op == Op::Sensor || op == Op::Age || op == Op::Variable || op == Op::Temporal ||
         op == Op::Call;
}

}  // namespace

void ExpressionReader::let() {
  const Token name = in_.peek();
  if (name.kind != TokenKind::Name) {
    in_.failExpecting("a name like `%1`");
  }
  in_.take();
  in_.expect('=');
  const ExprId value = nested(0);
  lets_.define(name, value.index);
}

ExprId ExpressionReader::add(Expr e, SourceRange begin) {
  e.range = in_.since(begin);
  if (in_.failed()) {
    return {};
  }
  const std::optional<Type> type = resultType(m_, e);
  if (!type) {
    std::string operands;
    for (uint32_t i = 0; i < operandCount(e); ++i) {
      operands += (i == 0 ? "" : " and ") + typeText(m_[e.operands.at(i)].type);
    }
    in_.fail(support::diagnostics::irOperands, e.range, opInfo(e.op).text, operands);
    return {};
  }
  e.type = *type;
  return MissionWriter(m_).add(e);
}

ExprId ExpressionReader::nested(uint32_t depth) {
  const Token token = in_.peek();
  if (token.kind == TokenKind::Number) {
    return constant(token.range);
  }
  if (token.kind == TokenKind::Name) {
    in_.take();
    return {lets_.find(token)};
  }
  if (in_.accept('(')) {
    return operation(token.range, depth + 1);
  }
  const OpInfo* op = token.kind == TokenKind::Word ? findOp(token.text) : nullptr;
  if (op == nullptr || op->operands > 0 || named(op->op) || op->op == Op::Constant) {
    in_.failExpecting("an expression");
    return {};
  }
  in_.take();
  Expr e;
  e.op = op->op;
  return add(e, token.range);
}

ExprId ExpressionReader::constant(SourceRange begin) {
  Expr e;
  e.number = in_.number(false);
  if (in_.accept(':')) {
    e.type = in_.type();
  }
  return add(e, begin);
}

/// The number of a temporal or a table, of which there are `count`.
uint32_t ExpressionReader::number(std::string_view what, size_t count) {
  const Token number = in_.peek();
  const auto index = static_cast<uint32_t>(in_.integer(0, UINT32_MAX));
  if (index >= count) {
    in_.fail(support::diagnostics::irUnknownName, number.range, what, number.text);
  }
  return index;
}

void ExpressionReader::leaf(Expr& e) {
  if (e.op == Op::Sensor || e.op == Op::Age) {
    e.sensor = {sensors_.find(in_.nameToken("the name of a sensor"))};
  } else if (e.op == Op::Variable) {
    e.variable = {variables_.find(in_.nameToken("the name of a variable"))};
  } else if (e.op == Op::Temporal) {
    e.temporal = {number("temporal", m_.temporals.size())};
  } else if (e.op == Op::Element) {
    e.table = {number("table", m_.tables.size())};
  } else if (e.op == Op::Call) {
    e.use = {number("use", m_.uses.size())};
  }
}

ExprId ExpressionReader::operation(SourceRange begin, uint32_t depth) {
  if (depth > kDeepestExpression) {
    in_.fail(support::diagnostics::irTooDeep, begin, kDeepestExpression);
    return {};
  }
  const OpInfo* op = in_.peek().kind == TokenKind::Word ? findOp(in_.peek().text) : nullptr;
  if (op == nullptr || (op->operands == 0 && !named(op->op))) {
    in_.failExpecting("an operation");
    return {};
  }
  in_.take();
  Expr e;
  e.op = op->op;
  leaf(e);
  const size_t count = e.use.valid() && !in_.failed() ? m_[e.use].parameters.size() : op->operands;
  for (size_t i = 0; i < count; ++i) {
    e.operands.at(i) = nested(depth);
  }
  in_.expect(')');
  return add(e, begin);
}

}  // namespace glider::ir::text
