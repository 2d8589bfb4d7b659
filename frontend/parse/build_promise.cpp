// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Requirements that are patterns: visits, patrols, reactions.

#include "frontend/parse/build_ast.h"
#include "support/check.h"

namespace glider::frontend {
namespace {

using grammar::GliderParser;

ast::Manner mannerOf(GliderParser::RouteContext* route, GliderParser::MannerContext* manner) {
  if (!route->THEN().empty()) {
    return ast::Manner::Sequence;
  }
  if (manner == nullptr) {
    return ast::Manner::AnyOrder;
  }
  if (manner->FAIRLY() != nullptr) {
    return ast::Manner::Fairly;
  }
  return manner->STRICT() != nullptr ? ast::Manner::StrictOrder : ast::Manner::Order;
}

}  // namespace

ast::PlaceDeclaration AstBuilder::place(Parser::PlaceContext* rule) {
  return {name(rule->anyName()), expr(rule->expr()), where(rule)};
}

/// A state may have the name of a unit, which is not an expression.
ast::Expr AstBuilder::somewhere(Parser::SomewhereContext* rule) {
  if (rule->expr() != nullptr) {
    return expr(rule->expr());
  }
  return {ast::NameUse{text(rule)}, where(rule)};
}

std::vector<ast::Expr> AstBuilder::route(Parser::RouteContext* rule) {
  std::vector<ast::Expr> places;
  for (Parser::SomewhereContext* place : rule->somewhere()) {
    places.push_back(somewhere(place));
  }
  return places;
}

ast::PromiseScope AstBuilder::scope(Parser::ScopeContext* rule) {
  ast::PromiseScope scope;
  scope.place = somewhere(rule->somewhere(0));
  scope.kind = rule->IN() != nullptr        ? ast::ScopeKind::In
               : rule->OUTSIDE() != nullptr ? ast::ScopeKind::Outside
               : rule->BEFORE() != nullptr  ? ast::ScopeKind::Before
               : rule->AFTER() != nullptr   ? ast::ScopeKind::After
                                            : ast::ScopeKind::FromTo;
  if (scope.kind == ast::ScopeKind::FromTo) {
    scope.to = somewhere(rule->somewhere(1));
  }
  return scope;
}

ast::CountPromise AstBuilder::count(Parser::CountPatternContext* rule) {
  const auto bound =
      rule->EXACTLY() != nullptr ? ast::CountBound::Exactly : ast::CountBound::AtLeast;
  return {somewhere(rule->somewhere()), bound, expr(rule->expr(0)), expr(rule->expr(1))};
}

ast::NeverPromise AstBuilder::never(Parser::NeverPatternContext* rule) {
  ast::NeverPromise never{somewhere(rule->somewhere(0)), ast::NeverWhen::Ever, std::nullopt};
  if (rule->somewhere(1) != nullptr) {
    never.when = rule->BEFORE() != nullptr ? ast::NeverWhen::Before : ast::NeverWhen::After;
    never.event = somewhere(rule->somewhere(1));
  }
  return never;
}

ast::ReactionPromise AstBuilder::reaction(Parser::ReactionPatternContext* rule) {
  ast::ReactionPromise reaction;
  reaction.trigger = rule->ONLY() != nullptr       ? ast::Trigger::WheneverAndOnly
                     : rule->WHENEVER() != nullptr ? ast::Trigger::Whenever
                                                   : ast::Trigger::When;
  reaction.cause = somewhere(rule->somewhere(0));
  reaction.response = somewhere(rule->somewhere(1));
  if (Parser::TimingContext* timing = rule->timing()) {
    reaction.timing = timing->TICK() != nullptr  ? ast::Timing::NextTick
                      : timing->FOR() != nullptr ? ast::Timing::For
                                                 : ast::Timing::Within;
    if (timing->expr() != nullptr) {
      reaction.time = expr(timing->expr());
    }
  }
  return reaction;
}

ast::Requirement AstBuilder::patternRequirement(Parser::PatternPromiseContext* rule,
                                                ast::Where where) {
  ast::Requirement result{ast::NeverPromise{}, where};
  if (rule->scope() != nullptr) {
    result.scope = scope(rule->scope());
  }
  result.or_exit = rule->EXIT() != nullptr;
  Parser::PatternContext* pattern = rule->pattern();
  if (auto* visit = dynamic_cast<Parser::VisitPatternContext*>(pattern)) {
    result.node = ast::VisitPromise{route(visit->route()),
                                    mannerOf(visit->route(), visit->manner()), expr(visit->expr())};
  } else if (auto* patrol = dynamic_cast<Parser::PatrolPatternContext*>(pattern)) {
    result.node = ast::PatrolPromise{
        route(patrol->route()), mannerOf(patrol->route(), patrol->manner()), expr(patrol->expr())};
  } else if (auto* most = dynamic_cast<Parser::AtMostPatternContext*>(pattern)) {
    result.node = ast::CountPromise{somewhere(most->somewhere()), ast::CountBound::AtMost,
                                    expr(most->expr()), std::nullopt};
  } else if (auto* counted = dynamic_cast<Parser::CountPatternContext*>(pattern)) {
    result.node = count(counted);
  } else if (auto* avoided = dynamic_cast<Parser::NeverPatternContext*>(pattern)) {
    result.node = never(avoided);
  } else if (auto* reacts = dynamic_cast<Parser::ReactionPatternContext*>(pattern)) {
    result.node = reaction(reacts);
  } else {
    auto* hold = dynamic_cast<Parser::HoldPatternContext*>(pattern);
    CHECK(hold != nullptr, "a pattern that the grammar lacks");
    result.node = ast::HoldPromise{somewhere(hold->somewhere(0)), somewhere(hold->somewhere(1)),
                                   expr(hold->expr())};
  }
  return result;
}

}  // namespace glider::frontend
