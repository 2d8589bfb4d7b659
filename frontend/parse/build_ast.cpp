// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/build_ast.h"

#include "support/check.h"

namespace glider::frontend {

using grammar::GliderParser;

ast::Where AstBuilder::where(const antlr4::Token* token) const {
  return support::SourceRange{source_.file, static_cast<uint32_t>(token->getStartIndex()),
                              static_cast<uint32_t>(token->getStopIndex())};
}

ast::Where AstBuilder::where(const Rule* rule) const {
  ast::Where range = where(rule->start);
  // A rule that matched nothing stops before it starts.
  range.end = rule->stop == nullptr ? range.begin : std::max(range.begin, where(rule->stop).end);
  return range;
}

std::string AstBuilder::text(const antlr4::Token* token) const {
  return std::string(source_.sources.text(where(token)));
}

std::string AstBuilder::text(const Rule* rule) const {
  return std::string(source_.sources.text(where(rule)));
}

std::string AstBuilder::joined(Rule* rule) const {
  if (rule->children.size() == 1) {
    return text(rule);
  }
  std::string out;
  for (antlr4::tree::ParseTree* child : rule->children) {
    auto* word = dynamic_cast<antlr4::tree::TerminalNode*>(child);
    out += word != nullptr ? text(word->getSymbol()) : joined(dynamic_cast<Rule*>(child));
  }
  return out;
}

ast::Import AstBuilder::import(Parser::ImportLineContext* rule) {
  std::optional<ast::Name> as;
  if (rule->name() != nullptr) {
    as = name(rule->name());
  }
  return {text(rule->STRING()->getSymbol()), std::move(as), where(rule)};
}

ast::Item AstBuilder::item(Parser::ItemContext* rule) {
  auto* child = static_cast<Rule*>(rule->children.front());  // every alternative is one rule
  switch (child->getRuleIndex()) {
    case GliderParser::RuleMissionLine:
      return ast::MissionLine{name(static_cast<Parser::MissionLineContext*>(child)->anyName()),
                              where(child)};
    case GliderParser::RulePlatformLine:
      return ast::PlatformLine{name(static_cast<Parser::PlatformLineContext*>(child)->name()),
                               where(child)};
    case GliderParser::RuleImportLine:
      return import(static_cast<Parser::ImportLineContext*>(child));
    case GliderParser::RuleConstant:
      return constant(static_cast<Parser::ConstantContext*>(child));
    case GliderParser::RuleParameter:
      return parameter(static_cast<Parser::ParameterContext*>(child));
    case GliderParser::RuleVariable:
      return variable(static_cast<Parser::VariableContext*>(child));
    case GliderParser::RuleAlways:
      return ast::Always{cases(static_cast<Parser::AlwaysContext*>(child)->eventCase()),
                         where(child->start)};
    case GliderParser::RuleState:
      return state(static_cast<Parser::StateContext*>(child));
    case GliderParser::RuleBehaviour:
      return behaviour(static_cast<Parser::BehaviourContext*>(child));
    case GliderParser::RulePlace:
      return place(static_cast<Parser::PlaceContext*>(child));
    case GliderParser::RuleAssumption:
      return assumption(static_cast<Parser::AssumptionContext*>(child));
    case GliderParser::RuleResumption:
      return resumption(static_cast<Parser::ResumptionContext*>(child));
    case GliderParser::RuleDeclination:
      return ast::Declination{expr(static_cast<Parser::DeclinationContext*>(child)->expr()),
                              where(child)};
    case GliderParser::RuleExternal:
      return external(static_cast<Parser::ExternalContext*>(child));
    default:
      CHECK(child->getRuleIndex() == GliderParser::RuleRequirement,
            "an item that the grammar lacks");
      return requirement(static_cast<Parser::RequirementContext*>(child));
  }
}

ast::TypeName AstBuilder::type(Parser::TypeContext* rule) {
  return {joined(rule), where(rule)};
}

std::optional<ast::Range> AstBuilder::range(Parser::RangeContext* rule) {
  if (rule == nullptr) {
    return std::nullopt;
  }
  return ast::Range{expr(rule->expr(0)), expr(rule->expr(1))};
}

ast::Const AstBuilder::constant(Parser::ConstantContext* rule) {
  std::optional<ast::TypeName> declared;
  if (rule->type() != nullptr) {
    declared = type(rule->type());
  }
  return {name(rule->anyName()), std::move(declared), expr(rule->expr()), where(rule)};
}

ast::Param AstBuilder::parameter(Parser::ParameterContext* rule) {
  std::optional<ast::Expr> condition;
  if (rule->expr().size() > 1) {
    condition = expr(rule->expr(1));
  }
  return {name(rule->anyName()), type(rule->type()), expr(rule->expr(0)), range(rule->range()),
          std::move(condition),  where(rule),        size(rule->size())};
}

ast::Var AstBuilder::variable(Parser::VariableContext* rule) {
  return {name(rule->anyName()), type(rule->type()), expr(rule->expr()),
          range(rule->range()),  where(rule),        size(rule->size())};
}

std::optional<ast::Expr> AstBuilder::size(Parser::SizeContext* rule) {
  return rule == nullptr ? std::nullopt : std::optional(expr(rule->expr()));
}

std::optional<std::vector<ast::Formal>> AstBuilder::formals(Parser::FormalsContext* rule) {
  if (rule == nullptr) {
    return std::nullopt;
  }
  std::vector<ast::Formal> list;
  for (auto* formal : rule->formal()) {
    list.push_back(
        {name(formal->anyName()), type(formal->type()),
         formal->expr() != nullptr ? std::optional(expr(formal->expr())) : std::nullopt});
  }
  return list;
}

ast::State AstBuilder::state(Parser::StateContext* rule) {
  ast::State result{name(rule->anyName()), formals(rule->formals()), {}, where(rule)};
  for (auto* m : rule->member()) {
    result.members.push_back(member(m));
  }
  return result;
}

ast::Behaviour AstBuilder::behaviour(Parser::BehaviourContext* rule) {
  const auto kind =
      rule->FLIGHTPROFILE() != nullptr ? ast::BehaviourKind::Profile : ast::BehaviourKind::Route;
  ast::Behaviour result{kind, name(rule->name()), formals(rule->formals()), {}, where(rule)};
  for (auto* m : rule->member()) {
    result.members.push_back(member(m));
  }
  return result;
}

ast::Item AstBuilder::external(Parser::ExternalContext* rule) {
  Parser::DeclarationContext* declaration = rule->declaration();
  if (auto* f = dynamic_cast<Parser::ExternFunctionContext*>(declaration)) {
    return ast::ExternFunction{name(f->name()), *formals(f->formals()), type(f->type()),
                               range(f->range()), where(rule)};
  }
  if (auto* s = dynamic_cast<Parser::ExternSensorContext*>(declaration)) {
    std::optional<ast::Expr> stale_after;
    if (s->expr() != nullptr) {
      stale_after = expr(s->expr());
    }
    return ast::ExternSensor{name(s->name()), type(s->type()), range(s->range()),
                             std::move(stale_after), where(rule)};
  }
  auto* b = dynamic_cast<Parser::ExternBehaviourContext*>(declaration);
  CHECK(b != nullptr, "an `extern` that the grammar lacks");
  const auto kind =
      b->FLIGHTPROFILE() != nullptr ? ast::BehaviourKind::Profile : ast::BehaviourKind::Route;
  ast::ExternBehaviour result{kind, name(b->name()), formals(b->formals()), {}, where(rule)};
  if (b->reads() != nullptr) {
    for (auto* sensor : b->reads()->name()) {
      result.reads.push_back(name(sensor));
    }
  }
  return result;
}

ast::Resumption AstBuilder::resumption(Parser::ResumptionContext* rule) {
  return {expr(rule->expr()), rule->RESTART() != nullptr, where(rule)};
}

ast::Requirement AstBuilder::requirement(Parser::RequirementContext* rule) {
  Parser::PromiseContext* promise = rule->promise();
  if (auto* p = dynamic_cast<Parser::AlwaysPromiseContext*>(promise)) {
    return {ast::AlwaysPromise{expr(p->expr())}, where(rule)};
  }
  if (auto* p = dynamic_cast<Parser::ExitPromiseContext*>(promise)) {
    return {ast::ExitPromise{expr(p->expr())}, where(rule)};
  }
  if (auto* p = dynamic_cast<Parser::StackPromiseContext*>(promise)) {
    return {ast::StackPromise{expr(p->expr())}, where(rule)};
  }
  if (auto* p = dynamic_cast<Parser::ReachPromiseContext*>(promise)) {
    return {ast::ReachPromise{name(p->anyName())}, where(rule)};
  }
  if (auto* p = dynamic_cast<Parser::PatternPromiseContext*>(promise)) {
    return patternRequirement(p, where(rule));
  }
  auto* s = dynamic_cast<Parser::SurfacesPromiseContext*>(promise);
  CHECK(s != nullptr, "a requirement that the grammar lacks");
  return {ast::SurfacesPromise{expr(s->expr())}, where(rule)};
}

ast::Member AstBuilder::member(Parser::MemberContext* rule) {
  const ast::Where whole = where(rule);
  const ast::Where keyword = where(rule->start);
  if (auto* m = dynamic_cast<Parser::RouteMemberContext*>(rule)) {
    return {ast::RouteMember{use(m->use(), m->use()->name(), m->use()->arguments())}, whole,
            keyword};
  }
  if (auto* m = dynamic_cast<Parser::ProfileMemberContext*>(rule)) {
    return {ast::ProfileMember{use(m->use(), m->use()->name(), m->use()->arguments())}, whole,
            keyword};
  }
  if (auto* m = dynamic_cast<Parser::SensorsMemberContext*>(rule)) {
    ast::SensorsMember list;
    for (auto* item : m->sensorItem()) {
      std::optional<ast::Expr> every;
      if (item->expr() != nullptr) {
        every = expr(item->expr());
      }
      list.items.push_back({name(item->anyName()), std::move(every)});
    }
    return {std::move(list), whole, keyword};
  }
  if (auto* m = dynamic_cast<Parser::VariableMemberContext*>(rule)) {
    return {variable(m->variable()), whole, keyword};
  }
  if (auto* m = dynamic_cast<Parser::EntryMemberContext*>(rule)) {
    return {ast::EntryMember{block(m->block())}, whole, keyword};
  }
  auto* m = dynamic_cast<Parser::EventsMemberContext*>(rule);
  CHECK(m != nullptr, "a member that the grammar lacks");
  return {ast::EventsMember{cases(m->eventCase())}, whole, keyword};
}

ast::Use AstBuilder::use(Rule* whole, Rule* name, Parser::ArgumentsContext* list) {
  ast::Use result{this->name(name), list != nullptr, {}, where(whole)};
  if (list != nullptr) {
    result.arguments = arguments(list);
  }
  return result;
}

std::vector<ast::Case> AstBuilder::cases(const std::vector<Parser::EventCaseContext*>& rules) {
  std::vector<ast::Case> list;
  for (auto* rule : rules) {
    ast::Case result{expr(rule->expr()), std::nullopt, ast::Transition::Stay,
                     std::nullopt,       {},           where(rule)};
    if (rule->block() != nullptr) {
      result.action = block(rule->block());
    }
    Parser::TransitionContext* transition = rule->transition();
    result.transition_where = where(transition->start);
    // The grammar lists the transitions in the order of the enumeration.
    const bool done = transition->DONE() != nullptr;
    result.transition =
        done ? ast::Transition::Done
             : static_cast<ast::Transition>(transition->start->getType() - GliderParser::GOTO);
    if (auto* target = transition->target()) {
      result.target = use(target, target->anyName(), target->arguments());
    }
    list.push_back(std::move(result));
  }
  return list;
}

ast::Block AstBuilder::block(Parser::BlockContext* rule) {
  return {statements(rule->statement()), where(rule)};
}

std::vector<ast::Statement> AstBuilder::statements(
    const std::vector<Parser::StatementContext*>& rules) {
  std::vector<ast::Statement> list;
  for (auto* rule : rules) {
    list.push_back(statement(rule));
  }
  return list;
}

ast::Statement AstBuilder::statement(Parser::StatementContext* rule) {
  if (auto* s = dynamic_cast<Parser::SetStatementContext*>(rule)) {
    std::optional<ast::Expr> index;
    if (s->LBRACKET() != nullptr) {
      index = expr(s->expr(0));
    }
    return {ast::Set{name(s->name()), expr(s->expr().back()), std::move(index)}, where(rule)};
  }
  if (auto* s = dynamic_cast<Parser::IfStatementContext*>(rule)) {
    return {ifStatement(s), where(rule)};
  }
  if (auto* s = dynamic_cast<Parser::ForStatementContext*>(rule)) {
    return {ast::For{name(s->anyName()), expr(s->expr(0)), expr(s->expr(1)),
                     statements(s->block()->statement())},
            where(rule)};
  }
  if (auto* s = dynamic_cast<Parser::LogStatementContext*>(rule)) {
    ast::Log log{text(s->STRING()->getSymbol()), {}};
    for (auto* value : s->expr()) {
      log.values.push_back(expr(value));
    }
    return {std::move(log), where(rule)};
  }
  auto* s = dynamic_cast<Parser::CommandStatementContext*>(rule);
  CHECK(s != nullptr, "a statement that the grammar lacks");
  const antlr4::Token* command = s->NAME()->getSymbol();
  return {ast::Command{{{text(command), where(command)}, arguments(s->arguments())}}, where(rule)};
}

ast::If AstBuilder::ifStatement(Parser::IfStatementContext* rule) {
  std::vector<Parser::StatementContext*> then;
  std::vector<Parser::StatementContext*> otherwise;
  bool after_else = false;
  for (antlr4::tree::ParseTree* child : rule->children) {
    if (auto* word = dynamic_cast<antlr4::tree::TerminalNode*>(child)) {
      after_else = after_else || word->getSymbol()->getType() == GliderParser::ELSE;
    } else if (auto* s = dynamic_cast<Parser::StatementContext*>(child)) {
      (after_else ? otherwise : then).push_back(s);
    }
  }
  ast::If result{expr(rule->expr()), statements(then), std::nullopt};
  if (after_else) {
    result.otherwise = statements(otherwise);
  }
  return result;
}

}  // namespace glider::frontend
