// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/build_ast.h"
#include "support/check.h"

#include <optional>
#include <utility>

namespace glider::frontend {

ast::Assumption AstBuilder::assumption(Parser::AssumptionContext* rule) {
  const ast::Where whole = where(rule);
  Parser::PremiseContext* premise = rule->premise();
  if (auto* p = dynamic_cast<Parser::StartPremiseContext*>(premise)) {
    return {ast::StartPremise{expr(p->expr())}, whole};
  }
  if (dynamic_cast<Parser::NoOutagePremiseContext*>(premise) != nullptr) {
    return {ast::OutagePremise{}, whole};
  }
  if (auto* p = dynamic_cast<Parser::OutagePremiseContext*>(premise)) {
    return {ast::OutagePremise{expr(p->expr())}, whole};
  }
  if (auto* p = dynamic_cast<Parser::CurrentPremiseContext*>(premise)) {
    return {ast::CurrentPremise{expr(p->expr())}, whole};
  }
  if (auto* p = dynamic_cast<Parser::KnownPremiseContext*>(premise)) {
    std::optional<ast::Name> sensor;
    if (p->name() != nullptr) {
      sensor = name(p->name());
    }
    return {ast::KnownPremise{std::move(sensor), expr(p->expr())}, whole};
  }
  if (auto* p = dynamic_cast<Parser::ChangesPremiseContext*>(premise)) {
    return {ast::ChangesPremise{name(p->name()), expr(p->expr())}, whole};
  }
  if (auto* p = dynamic_cast<Parser::RangePremiseContext*>(premise)) {
    return {ast::RangePremise{name(p->name()), *range(p->range())}, whole};
  }
  auto* p = dynamic_cast<Parser::ConditionPremiseContext*>(premise);
  CHECK(p != nullptr, "an assumption that the grammar lacks");
  std::optional<ast::Expr> inside;
  if (p->name() != nullptr) {
    ast::Where call = where(p->name());
    call.end = where(p->arguments()).end;
    inside = ast::Expr{ast::Invocation{name(p->name()), arguments(p->arguments())}, call};
  }
  return {ast::ConditionPremise{expr(p->expr()), std::move(inside)}, whole};
}

}  // namespace glider::frontend
