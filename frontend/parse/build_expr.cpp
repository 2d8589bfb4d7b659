// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/build_ast.h"
#include "frontend/parse/phrases/positions/written_position.h"
#include "frontend/spelling.h"
#include "support/check.h"
#include "support/units/units.h"

#include <algorithm>
#include <cctype>
#include <typeinfo>

namespace glider::frontend {

using grammar::GliderParser;

namespace {

constexpr std::string_view kOfWords =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789";

/// `metres/s` with the units of its words. Of `degrees` analysis knows which are meant.
std::string ofWords(const std::string& written) {
  std::string out;
  for (size_t at = 0; at < written.size();) {
    const size_t end = std::min(written.find_first_of("*/", at), written.size());
    const std::string word = written.substr(at, end - at);
    const std::string_view unit = support::findUnit(word) ? word : unitForWord(word);
    out += unit.empty() || unit == "deg" ? word : std::string(unit);
    out += end < written.size() ? written.substr(end, 1) : "";
    at = end + 1;
  }
  return out;
}

/// The unit that repair has made of several words, `ug / L`, or reported and left as it was
/// written: `20°`, `20 deg C`, `20 °C`.
std::string meantUnit(const std::string& written) {
  const size_t gap = written.find_first_not_of(kOfWords);
  if (gap != std::string::npos) {
    const std::string fraction =
        written.substr(0, gap) + "/" + written.substr(written.find_last_not_of(kOfWords) + 1);
    if (const auto unit = support::findUnit(fraction); unit && unit->soft) {
      return fraction;
    }
  }
  if (written.ends_with("magnetic")) {
    return written.substr(0, 3) + " magnetic";  // of `deg` or `rad`, with any space between
  }
  if (written == "°" || written == "\xB0") {  // the second in Latin-1
    return "deg";
  }
  const bool degrees = written.find("°") != std::string::npos ||
                       written.find("º") != std::string::npos ||
                       written.find_first_of(" \t") != std::string::npos;
  return degrees ? "degC" : ofWords(written);
}

/// The letter of a position, which repair may have found as `n`.
std::string capital(std::string letter) {
  letter[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(letter[0])));
  return letter;
}

/// `this leg` with one space for anything between the two words; any other name as it is.
std::string oneSpaced(const std::string& name) {
  const size_t end = name.find_first_not_of(kOfWords);
  return end == std::string::npos
             ? name
             : name.substr(0, end) + " " + name.substr(name.find_last_not_of(kOfWords) + 1);
}

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

}  // namespace

ast::Expr AstBuilder::expr(Parser::ExprContext* rule) {
  // The alternatives differ in their number of parts: a primary, a sign before one, an operator
  // between two.
  auto part = [&](size_t i) { return static_cast<Parser::ExprContext*>(rule->children[i]); };
  switch (rule->children.size()) {
    case 1:
      return primary(static_cast<Parser::PrimaryContext*>(rule->children[0]));
    case 2: {
      const bool negate = rule->start->getType() == GliderParser::MINUS;
      return {ast::Unary{negate ? ast::UnaryOp::Negate : ast::UnaryOp::Not, expr(part(1))},
              where(rule)};
    }
    default: {
      CHECK(rule->children.size() == 3, "an expression that the grammar lacks");
      const antlr4::Token* op = wordOf(rule->children[1]);
      ast::Expr left = expr(part(0));
      return {ast::Binary{binaryOp(op->getType()), std::move(left), expr(part(2)), where(op)},
              where(rule)};
    }
  }
}

ast::Expr AstBuilder::primary(Parser::PrimaryContext* rule) {
  switch (rule->start->getType()) {
    case GliderParser::INSTANT:
      return {ast::Instant{text(rule)}, where(rule)};
    case GliderParser::NUMBER:
      return typeid(*rule) == typeid(Parser::DurationContext) ? duration(rule) : literal(rule);
    case GliderParser::TRUE:
    case GliderParser::FALSE:
      return {ast::Truth{rule->start->getType() == GliderParser::TRUE}, where(rule)};
    case GliderParser::LPAREN:
      return expr(static_cast<Parser::ParenthesisContext*>(rule)->expr());
    case GliderParser::LBRACKET: {
      ast::List list;
      for (auto* item : static_cast<Parser::ListContext*>(rule)->expr()) {
        list.items.push_back(expr(item));
      }
      return {std::move(list), where(rule)};
    }
    default:
      return named(rule);
  }
}

/// What begins with a name.
ast::Expr AstBuilder::named(Parser::PrimaryContext* rule) {
  if (rule->start->getType() == GliderParser::HEARD) {
    return {ast::NameUse{text(rule)}, where(rule)};
  }
  if (typeid(*rule) == typeid(Parser::PeersWithinContext)) {
    auto* radius = static_cast<Parser::PrimaryContext*>(rule->children.back());
    ast::Where words = where(rule->start);
    words.end = where(wordOf(rule->children[1])).end;
    return {ast::Invocation{{std::string(ast::kPeersWithin), words},
                            {{primary(radius), std::nullopt, std::nullopt}}},
            where(rule)};
  }
  if (rule->children.size() == 1) {
    return {ast::NameUse{oneSpaced(text(rule))}, where(rule)};
  }
  if (rule->children.size() > 2) {
    auto* index = static_cast<Parser::IndexContext*>(rule);
    return {ast::Index{name(index->name()), expr(index->expr())}, where(rule)};
  }
  const antlr4::Token* function = rule->start;
  auto* call = static_cast<Parser::InvocationContext*>(rule);
  return {ast::Invocation{{text(function), where(function)}, arguments(call->arguments())},
          where(rule)};
}

/// The digits of a number; those of `39   10.5` with one space, those of `39°10.5` as ours.
std::string AstBuilder::digitsOf(const antlr4::Token* number) const {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::string digits = text(number);
  if (digits.find_first_not_of("0123456789.eE+-") != std::string::npos) {
    if (auto ours = positionDigits(digits)) {
      return *ours;
    }
  }
  const size_t gap = digits.find_first_of(kBlanks);
  return gap == std::string::npos
             ? digits
             : digits.substr(0, gap) + " " + digits.substr(digits.find_first_not_of(kBlanks, gap));
}

/// A number, perhaps a unit, perhaps a number and a letter.
ast::Expr AstBuilder::literal(const Rule* rule) {
  const auto& parts = rule->children;
  const antlr4::Token* digits = rule->start;
  ast::Literal first{digitsOf(digits), "", where(digits)};
  if (parts.size() % 2 == 0) {
    const Rule* unit = ruleOf(parts[1]);
    const bool letter = unit->start->getType() == GliderParser::COMPASS;
    first.unit = letter ? capital(joined(unit)) : meantUnit(joined(unit));
    first.unit_where = where(unit);
  }
  if (parts.size() <= 2) {
    return {std::move(first), where(rule)};
  }
  const antlr4::Token* second = wordOf(parts[parts.size() - 2]);
  const antlr4::Token* letter = wordOf(parts.back());
  ast::Where left = where(digits);
  left.end = first.unit_where.end;
  ast::Where right = where(second);
  right.end = where(letter).end;
  ast::Literal other{digitsOf(second), capital(text(letter)), where(letter)};
  return {ast::Position{std::move(first), std::move(other), left, right}, where(rule)};
}

ast::Expr AstBuilder::duration(const Rule* rule) {
  ast::Duration all;
  for (size_t i = 0; i + 1 < rule->children.size(); i += 2) {
    const antlr4::Token* digits = wordOf(rule->children[i]);
    antlr4::tree::ParseTree* rest = rule->children[i + 1];
    const antlr4::Token* unit = isWord(rest) ? wordOf(rest) : ruleOf(rest)->start;
    all.parts.push_back({digitsOf(digits), text(unit), where(unit)});
  }
  return {std::move(all), where(rule)};
}

/// Every second part is an argument, the others are parentheses and commas.
std::vector<ast::Argument> AstBuilder::arguments(Parser::ArgumentsContext* rule) {
  std::vector<ast::Argument> list;
  list.reserve(rule->children.size() / 2);
  for (size_t i = 1; i + 1 < rule->children.size(); i += 2) {
    list.push_back(argument(ruleOf(rule->children[i])));
  }
  return list;
}

/// Perhaps a name and `=`, a value, perhaps `of` and a name.
ast::Argument AstBuilder::argument(const Rule* rule) {
  const auto& parts = rule->children;
  const bool named = ruleOf(parts[0])->getRuleIndex() == GliderParser::RuleName;
  const size_t value = named ? 2 : 0;
  std::optional<ast::Name> of;
  std::optional<ast::Name> parameter;
  if (value + 1 < parts.size()) {
    of = name(ruleOf(parts.back()));
  }
  if (named) {
    parameter = name(ruleOf(parts[0]));
  }
  return {expr(static_cast<Parser::ExprContext*>(parts[value])), std::move(of),
          std::move(parameter)};
}

}  // namespace glider::frontend
