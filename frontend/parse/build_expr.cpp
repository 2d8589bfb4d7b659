// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/build_ast.h"
#include "support/check.h"

namespace glider::frontend {

using grammar::GliderParser;

namespace {

ast::BinaryOp binaryOp(size_t token) {
  switch (token) {
    case GliderParser::TIMES:
      return ast::BinaryOp::Multiply;
    case GliderParser::DIVIDE:
      return ast::BinaryOp::Divide;
    case GliderParser::PLUS:
      return ast::BinaryOp::Add;
    case GliderParser::MINUS:
      return ast::BinaryOp::Subtract;
    case GliderParser::LT:
      return ast::BinaryOp::Less;
    case GliderParser::LE:
      return ast::BinaryOp::LessEqual;
    case GliderParser::GT:
      return ast::BinaryOp::Greater;
    case GliderParser::GE:
      return ast::BinaryOp::GreaterEqual;
    case GliderParser::EQ:
      return ast::BinaryOp::Equal;
    case GliderParser::NE:
      return ast::BinaryOp::NotEqual;
    case GliderParser::AND:
      return ast::BinaryOp::And;
    default:
      CHECK(token == GliderParser::OR, "an operator that the grammar lacks");
      return ast::BinaryOp::Or;
  }
}

antlr4::Token* tokenAt(const antlr4::ParserRuleContext* rule, size_t child) {
  auto* node = dynamic_cast<antlr4::tree::TerminalNode*>(rule->children.at(child));
  CHECK(node != nullptr, "a word was expected in the parse tree");
  return node->getSymbol();
}

}  // namespace

ast::Expr AstBuilder::expr(Parser::ExprContext* rule) {
  if (auto* p = dynamic_cast<Parser::PrimaryExprContext*>(rule)) {
    return primary(p->primary());
  }
  if (auto* u = dynamic_cast<Parser::UnaryExprContext*>(rule)) {
    const bool negate = tokenAt(u, 0)->getType() == GliderParser::MINUS;
    return {ast::Unary{negate ? ast::UnaryOp::Negate : ast::UnaryOp::Not, expr(u->expr())}, where(rule)};
  }
  auto* b = dynamic_cast<Parser::BinaryExprContext*>(rule);
  CHECK(b != nullptr, "an expression that the grammar lacks");
  const antlr4::Token* op = tokenAt(b, 1);
  ast::Expr left = expr(b->expr(0));
  return {ast::Binary{binaryOp(op->getType()), std::move(left), expr(b->expr(1)), where(op)}, where(rule)};
}

ast::Expr AstBuilder::primary(Parser::PrimaryContext* rule) {
  if (auto* p = dynamic_cast<Parser::LiteralContext*>(rule)) {
    return literal(p);
  }
  if (auto* p = dynamic_cast<Parser::TruthContext*>(rule)) {
    return {ast::Truth{p->TRUE() != nullptr}, where(rule)};
  }
  if (auto* p = dynamic_cast<Parser::ParenthesisContext*>(rule)) {
    return expr(p->expr());
  }
  if (auto* p = dynamic_cast<Parser::ListContext*>(rule)) {
    ast::List list;
    for (auto* item : p->expr()) {
      list.items.push_back(expr(item));
    }
    return {std::move(list), where(rule)};
  }
  if (auto* p = dynamic_cast<Parser::IndexContext*>(rule)) {
    return {ast::Index{name(p->name()), expr(p->expr())}, where(rule)};
  }
  if (auto* p = dynamic_cast<Parser::InvocationContext*>(rule)) {
    const antlr4::Token* function = p->getStart();
    return {ast::Invocation{{text(function), where(function)}, arguments(p->arguments())}, where(rule)};
  }
  return {ast::NameUse{text(rule)}, where(rule)};
}

ast::Expr AstBuilder::literal(Parser::LiteralContext* rule) {
  const antlr4::Token* digits = rule->NUMBER(0)->getSymbol();
  ast::Literal first{text(digits), "", where(digits)};
  if (rule->unit() != nullptr) {
    first.unit = joined(rule->unit());
    first.unit_where = where(rule->unit());
  }
  if (rule->NUMBER().size() == 1) {
    return {std::move(first), where(rule)};
  }
  const antlr4::Token* second = rule->NUMBER(1)->getSymbol();
  const antlr4::Token* letter = rule->COMPASS()->getSymbol();
  ast::Where left = where(digits);
  left.end = first.unit_where.end;
  ast::Where right = where(second);
  right.end = where(letter).end;
  ast::Literal other{text(second), text(letter), where(letter)};
  return {ast::Position{std::move(first), std::move(other), left, right}, where(rule)};
}

std::vector<ast::Argument> AstBuilder::arguments(Parser::ArgumentsContext* rule) {
  std::vector<ast::Argument> list;
  for (auto* argument : rule->argument()) {
    std::optional<ast::Name> of;
    if (argument->name() != nullptr) {
      of = name(argument->name());
    }
    list.push_back({expr(argument->expr()), std::move(of)});
  }
  return list;
}

}  // namespace glider::frontend
