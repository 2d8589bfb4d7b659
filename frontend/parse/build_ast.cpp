// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/build_ast.h"

#include "support/check.h"

#include <algorithm>
#include <typeinfo>

namespace glider::frontend {

using grammar::GliderParser;

bool AstBuilder::isWord(const antlr4::tree::ParseTree* node) {
  return typeid(*node) == typeid(antlr4::tree::TerminalNodeImpl);
}

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

std::string AstBuilder::joined(const Rule* rule) const {
  if (rule->children.size() == 1) {
    return text(rule);
  }
  std::string out;
  for (antlr4::tree::ParseTree* child : rule->children) {
    out += isWord(child) ? text(wordOf(child)) : joined(ruleOf(child));
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
      return ast::Always{cases(child), where(child->start)};
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
    case GliderParser::RuleNap:
      return ast::Nap{expr(static_cast<Parser::NapContext*>(child)->expr()), where(child)};
    case GliderParser::RuleDeclination:
      return ast::Declination{expr(static_cast<Parser::DeclinationContext*>(child)->expr()),
                              where(child)};
    case GliderParser::RuleShare:
      return share(static_cast<Parser::ShareContext*>(child));
    case GliderParser::RulePack:
      return pack(static_cast<Parser::PackContext*>(child));
    case GliderParser::RuleChoice:
      return choice(static_cast<Parser::ChoiceContext*>(child));
    case GliderParser::RulePreference:
      return preference(static_cast<Parser::PreferenceContext*>(child));
    case GliderParser::RuleVehicles:
      return vehicles(static_cast<Parser::VehiclesContext*>(child));
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
    list.push_back({name(formal->anyName()), type(formal->type()),
                    formal->expr() != nullptr ? std::optional(expr(formal->expr())) : std::nullopt,
                    range(formal->range())});
  }
  return list;
}

ast::Choice AstBuilder::choice(Parser::ChoiceContext* rule) {
  const auto after = [&](antlr4::tree::TerminalNode* word) { return exprAfter(rule, word); };
  ast::Range range = *this->range(rule->range());
  auto value = after(rule->ASSIGN());
  const bool chosen = value.has_value();
  ast::Const constant{name(rule->anyName()), type(rule->type()),
                      chosen ? std::move(*value) : range.lowest, where(rule)};
  const support::SourceRange type_where = constant.type->where;
  const support::SourceRange value_where = constant.value.where;
  const support::SourceRange written =
      chosen ? value_where : support::SourceRange{type_where.file, type_where.end, type_where.end};
  return {std::move(constant),  chosen,      std::move(range), after(rule->BY()),
          after(rule->WHERE()), where(rule), written};
}

/// The value after a word of `rule`; empty if it does not have that word.
std::optional<ast::Expr> AstBuilder::exprAfter(antlr4::ParserRuleContext* rule,
                                               antlr4::tree::TerminalNode* word) {
  const auto found = std::ranges::find(rule->children, word);
  if (word == nullptr || found == rule->children.end() || found + 1 == rule->children.end()) {
    return std::nullopt;
  }
  return expr(static_cast<Parser::ExprContext*>(*(found + 1)));
}

ast::Preference AstBuilder::preference(Parser::PreferenceContext* rule) {
  ast::Preference made{{}, where(rule)};
  for (Parser::ObjectiveContext* one : rule->objective()) {
    const ast::Aim aim = one->LEAST() != nullptr      ? ast::Aim::Least
                         : one->GREATEST() != nullptr ? ast::Aim::Greatest
                                                      : ast::Aim::Endurance;
    made.objectives.push_back(
        {aim, one->expr() != nullptr ? std::optional(expr(one->expr())) : std::nullopt,
         where(one)});
  }
  return made;
}

ast::Pack AstBuilder::pack(Parser::PackContext* rule) {
  std::optional<ast::Expr> reserve;
  if (rule->RESERVE() != nullptr) {
    reserve = expr(rule->expr(2));
  }
  return {expr(rule->expr(0)), expr(rule->expr(1)), std::move(reserve), where(rule)};
}

ast::Vehicles AstBuilder::vehicles(Parser::VehiclesContext* rule) {
  ast::Vehicles result{{}, where(rule)};
  for (auto* one : rule->anyName()) {
    result.names.push_back(name(one));
  }
  return result;
}

/// Its times and the rest are distinguished by the words before them.
ast::Share AstBuilder::share(Parser::ShareContext* rule) {
  ast::Share result{name(rule->anyName()), {}, range(rule->range()), {}, {}, {}, where(rule)};
  std::optional<ast::Expr> value;
  for (size_t i = 1; i < rule->children.size(); ++i) {
    const antlr4::tree::ParseTree* before = rule->children[i - 1];
    if (!isWord(before)) {
      continue;
    }
    auto next = [&] { return expr(static_cast<Parser::ExprContext*>(rule->children[i])); };
    switch (wordOf(rule->children[i - 1])->getType()) {
      case GliderParser::ASSIGN:
        value = next();
        break;
      case GliderParser::PRECISION:
        result.precision = next();
        break;
      case GliderParser::EVERY:
        result.every = next();
        break;
      case GliderParser::AFTER:
        result.stale_after = next();
        break;
      default:
        break;
    }
  }
  if (rule->type() != nullptr) {
    const ast::TypeName declared = type(rule->type());
    ast::Expr start =
        value ? std::move(*value) : ast::Expr{ast::NameUse{"unknown"}, declared.where};
    result.variable =
        ast::Var{result.name, declared, std::move(start), std::move(result.range), result.where};
    result.range.reset();
  }
  return result;
}

std::vector<ast::Member> AstBuilder::members(const Rule* rule) {
  std::vector<ast::Member> list;
  for (antlr4::tree::ParseTree* child : rule->children) {
    if (!isWord(child) && ruleOf(child)->getRuleIndex() == GliderParser::RuleMember) {
      list.push_back(member(static_cast<Parser::MemberContext*>(child)));
    }
  }
  return list;
}

ast::State AstBuilder::state(Parser::StateContext* rule) {
  return {name(rule->anyName()), formals(rule->formals()), members(rule), where(rule)};
}

ast::Behaviour AstBuilder::behaviour(Parser::BehaviourContext* rule) {
  const auto kind =
      rule->FLIGHTPROFILE() != nullptr ? ast::BehaviourKind::Profile : ast::BehaviourKind::Route;
  return {kind, name(rule->name()), formals(rule->formals()), members(rule), where(rule)};
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
  switch (rule->start->getType()) {
    case GliderParser::FLIGHTROUTE:
      return {ast::RouteMember{use(ruleOf(rule->children[1]))}, whole, keyword};
    case GliderParser::FLIGHTPROFILE:
      return {ast::ProfileMember{use(ruleOf(rule->children[1]))}, whole, keyword};
    case GliderParser::SENSORS:
      return {sensors(rule), whole, keyword};
    case GliderParser::SAMPLE:
      return {sample(rule), whole, keyword};
    case GliderParser::VAR:
      return {variable(static_cast<Parser::VariableContext*>(rule->children[0])), whole, keyword};
    case GliderParser::ENTRY:
      return {ast::EntryMember{block(static_cast<Parser::BlockContext*>(rule->children[1]))}, whole,
              keyword};
    default:
      CHECK(rule->start->getType() == GliderParser::EVENTS, "a member that the grammar lacks");
      return {ast::EventsMember{cases(rule)}, whole, keyword};
  }
}

/// Every second part is an item, the others are `sensors` and commas.
ast::SensorsMember AstBuilder::sensors(const Rule* rule) {
  ast::SensorsMember list;
  for (size_t i = 1; i < rule->children.size(); i += 2) {
    const Rule* item = ruleOf(rule->children[i]);  // a name, perhaps `every` and a time
    std::optional<ast::Expr> every;
    if (item->children.size() > 1) {
      every = expr(static_cast<Parser::ExprContext*>(item->children[2]));
    }
    // A word alone is of a vehicle that is received.
    antlr4::tree::ParseTree* named = item->children[0];
    const ast::Name sensor =
        isWord(named) ? ast::Name{text(wordOf(named)), where(wordOf(named))} : name(ruleOf(named));
    list.items.push_back({sensor, std::move(every)});
  }
  return list;
}

/// Of a `use` or a `target`: a name, perhaps with arguments.
ast::Use AstBuilder::use(const Rule* rule) {
  const bool list = rule->children.size() > 1;
  ast::Use result{name(ruleOf(rule->children[0])), list, {}, where(rule)};
  if (list) {
    result.arguments = arguments(static_cast<Parser::ArgumentsContext*>(rule->children[1]));
  }
  return result;
}

/// All that follows the first word of `rule`.
std::vector<ast::Case> AstBuilder::cases(const Rule* rule) {
  std::vector<ast::Case> list;
  list.reserve(rule->children.size() - 1);
  for (size_t i = 1; i < rule->children.size(); ++i) {
    list.push_back(eventCase(ruleOf(rule->children[i])));
  }
  return list;
}

/// `case`, a condition, perhaps a block, a transition.
ast::Case AstBuilder::eventCase(const Rule* rule) {
  const auto& parts = rule->children;
  const Rule* transition = ruleOf(parts.back());
  ast::Case result{expr(static_cast<Parser::ExprContext*>(parts[1])),
                   std::nullopt,
                   ast::Transition::Done,
                   std::nullopt,
                   where(transition->start),
                   where(rule)};
  constexpr size_t kPartsWithBlock = 4;
  if (parts.size() == kPartsWithBlock) {
    result.action = block(static_cast<Parser::BlockContext*>(parts[2]));
  }
  // The grammar lists the transitions in the order of the enumeration.
  if (transition->start->getType() != GliderParser::DONE) {
    result.transition =
        static_cast<ast::Transition>(transition->start->getType() - GliderParser::GOTO);
  }
  if (transition->children.size() > 1) {
    result.target = use(ruleOf(transition->children[1]));
  }
  return result;
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
  switch (rule->start->getType()) {
    case GliderParser::SET: {
      auto* s = static_cast<Parser::SetStatementContext*>(rule);
      std::optional<ast::Expr> index;
      if (s->LBRACKET() != nullptr) {
        index = expr(s->expr(0));
      }
      return {ast::Set{name(s->name()), expr(s->expr().back()), std::move(index)}, where(rule)};
    }
    case GliderParser::IF:
      return {ifStatement(static_cast<Parser::IfStatementContext*>(rule)), where(rule)};
    case GliderParser::FOR: {
      auto* s = static_cast<Parser::ForStatementContext*>(rule);
      return {ast::For{name(s->anyName()), expr(s->expr(0)), expr(s->expr(1)),
                       statements(s->block()->statement())},
              where(rule)};
    }
    case GliderParser::LOG: {
      auto* s = static_cast<Parser::LogStatementContext*>(rule);
      ast::Log log{text(s->STRING()->getSymbol()), {}};
      for (auto* value : s->expr()) {
        log.values.push_back(expr(value));
      }
      return {std::move(log), where(rule)};
    }
    default: {
      CHECK(rule->start->getType() == GliderParser::NAME, "a statement that the grammar lacks");
      auto* s = static_cast<Parser::CommandStatementContext*>(rule);
      const antlr4::Token* command = s->start;
      return {ast::Command{{{text(command), where(command)}, arguments(s->arguments())}},
              where(rule)};
    }
  }
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
