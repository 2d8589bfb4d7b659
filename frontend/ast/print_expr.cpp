// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/ast/print.h"
#include "frontend/ast/print_parts.h"

#include <string_view>

namespace glider::ast {
namespace {

struct Operator {
  std::string_view text;
  int binds;  ///< operators with a greater value bind more tightly
};

constexpr int kUnaryBinds = 6;
constexpr int kPrimaryBinds = 7;

Operator operatorOf(BinaryOp op) {
  switch (op) {
    case BinaryOp::Multiply:
      return {"*", 5};
    case BinaryOp::Divide:
      return {"/", 5};
    case BinaryOp::Add:
      return {"+", 4};
    case BinaryOp::Subtract:
      return {"-", 4};
    case BinaryOp::Less:
      return {"<", 3};
    case BinaryOp::LessEqual:
      return {"<=", 3};
    case BinaryOp::Greater:
      return {">", 3};
    case BinaryOp::GreaterEqual:
      return {">=", 3};
    case BinaryOp::Equal:
      return {"==", 3};
    case BinaryOp::NotEqual:
      return {"!=", 3};
    case BinaryOp::And:
      return {"&&", 2};
    case BinaryOp::Or:
      return {"||", 1};
  }
  return {"", 0};
}

std::string printLiteral(const Literal& literal) {
  return literal.unit.empty() ? literal.digits : literal.digits + " " + literal.unit;
}

class ExprPrinter {
 public:
  /// Appends `expr`, in parentheses if it binds less tightly than `least`.
  void print(const Expr& expr, int least) {
    const int binds = bindsOf(expr);
    out_ += binds < least ? "(" : "";
    std::visit([this](const auto& node) { write(node); }, expr.node);
    out_ += binds < least ? ")" : "";
  }
  std::string take() { return std::move(out_); }

 private:
  static int bindsOf(const Expr& expr) {
    if (const auto* binary = std::get_if<Binary>(&expr.node)) {
      return operatorOf(binary->op).binds;
    }
    return std::holds_alternative<Unary>(expr.node) ? kUnaryBinds : kPrimaryBinds;
  }

  void write(const Literal& node) { out_ += printLiteral(node); }
  void write(const Position& node) {
    out_ += printLiteral(node.latitude) + " " + printLiteral(node.longitude);
  }
  void write(const Duration& node) {
    for (size_t i = 0; i < node.parts.size(); ++i) {
      out_ += (i == 0 ? "" : " ") + printLiteral(node.parts[i]);
    }
  }
  void write(const Instant& node) { out_ += node.text; }
  void write(const Truth& node) { out_ += node.value ? "true" : "false"; }
  void write(const NameUse& node) { out_ += node.name; }
  void write(const Invocation& node) {
    if (node.function.text == kPeersWithin) {
      out_ += node.function.text + " ";
      print(*node.arguments.front().value, kPrimaryBinds);
    } else {
      out_ += node.function.text + printArguments(node.arguments);
    }
  }
  void write(const List& node) {
    out_ += "[";
    for (size_t i = 0; i < node.items.size(); ++i) {
      out_ += i == 0 ? "" : ", ";
      print(node.items[i], 0);
    }
    out_ += "]";
  }
  void write(const Index& node) {
    out_ += node.list.text + "[";
    print(*node.position, 0);
    out_ += "]";
  }
  void write(const Unary& node) {
    out_ += node.op == UnaryOp::Negate ? "-" : "!";
    print(*node.operand, kUnaryBinds);
  }
  void write(const Binary& node) {
    const Operator op = operatorOf(node.op);
    print(*node.left, op.binds);
    out_ += " " + std::string(op.text) + " ";
    print(*node.right, op.binds + 1);
  }

  std::string out_;
};

}  // namespace

std::string printArguments(const std::vector<Argument>& arguments) {
  std::string out = "(";
  for (size_t i = 0; i < arguments.size(); ++i) {
    out += i == 0 ? "" : ", ";
    out += arguments[i].parameter ? arguments[i].parameter->text + " = " : "";
    out += print(*arguments[i].value);
    out += arguments[i].of ? " of " + arguments[i].of->text : "";
  }
  return out + ")";
}

std::string print(const Expr& expr) {
  ExprPrinter printer;
  printer.print(expr, 0);
  return printer.take();
}

}  // namespace glider::ast
