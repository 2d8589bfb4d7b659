// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// `sample …` of a state: what is written beside `when` is a condition too, in other words.

#include "frontend/parse/build_ast.h"

#include <algorithm>
#include <utility>

namespace glider::frontend {
namespace {

ast::Expr binary(ast::BinaryOp op, ast::Expr left, ast::Expr right, const ast::Where& where) {
  return {ast::Binary{op, std::move(left), std::move(right), where}, where};
}

/// The first of each `count` yos: `remainder(yo_number + count - 1, count) == 0`.
ast::Expr oneYoIn(const ast::Expr& count, const ast::Where& where) {
  const auto number = [&](const char* digits) {
    return ast::Expr{ast::Literal{digits, "", {}}, where};
  };
  const ast::Expr yo{ast::NameUse{"yo_number"}, where};
  const ast::Expr shifted = binary(
      ast::BinaryOp::Subtract, binary(ast::BinaryOp::Add, yo, count, where), number("1"), where);
  ast::Invocation rest{{"remainder", where}, {}};
  rest.arguments.push_back({shifted, {}});
  rest.arguments.push_back({count, {}});
  return binary(ast::BinaryOp::Equal, {std::move(rest), where}, number("0"), where);
}

}  // namespace

/// Every second part is an item, the others are `sample` and commas.
ast::SampleMember AstBuilder::sample(const Rule* rule) {
  ast::SampleMember list;
  for (size_t i = 1; i < rule->children.size(); i += 2) {
    auto* item = static_cast<Parser::SampleItemContext*>(rule->children[i]);
    ast::SampleItem one{name(item->anyName()), item->OFF() != nullptr, {}, {}, {}};
    one.how = where(item);
    one.how.begin = std::min(one.how.end, one.instrument.where.end);
    if (item->EVERY() != nullptr) {
      one.every = expr(item->expr());
    }
    for (Parser::SamplePartContext* part : item->samplePart()) {
      ast::Expr next = samplePart(part);
      one.when =
          one.when ? binary(ast::BinaryOp::And, *std::move(one.when), std::move(next), where(part))
                   : std::move(next);
    }
    list.items.push_back(std::move(one));
  }
  return list;
}

ast::Expr AstBuilder::samplePart(Parser::SamplePartContext* rule) {
  if (rule->WHEN() != nullptr) {
    return expr(rule->expr());
  }
  if (rule->ON() != nullptr) {
    return {ast::NameUse{rule->CLIMBS() != nullptr ? "climbing" : "diving"}, where(rule)};
  }
  if (rule->ONE() != nullptr) {
    return oneYoIn(expr(rule->expr()), where(rule));
  }
  const bool below = rule->BELOW() != nullptr;
  return binary(below ? ast::BinaryOp::Greater : ast::BinaryOp::Less,
                {ast::NameUse{"depth"}, where(rule->start)}, expr(rule->expr()), where(rule));
}

}  // namespace glider::frontend
