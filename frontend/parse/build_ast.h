// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/parse/lexeme.h"
#include "grammar/GliderParser.h"

#include <string>

namespace glider::frontend {

/// Makes the AST from parse trees without errors.
class AstBuilder {
 public:
  explicit AstBuilder(Source source) : source_(source) {}
  ast::Item item(grammar::GliderParser::ItemContext* rule);

 private:
  using Parser = grammar::GliderParser;
  using Rule = antlr4::ParserRuleContext;

  // Parts of a rule, by what the grammar puts in their place. ANTLR's own accessors try a
  // dynamic_cast on each part.
  /// Whether it is a word, and no rule; trees without errors have nothing else.
  static bool isWord(const antlr4::tree::ParseTree* node);
  static Rule* ruleOf(antlr4::tree::ParseTree* node) { return static_cast<Rule*>(node); }
  static const antlr4::Token* wordOf(antlr4::tree::ParseTree* node) {
    return static_cast<antlr4::tree::TerminalNode*>(node)->getSymbol();
  }

  // Places and words.
  [[nodiscard]] ast::Where where(const Rule* rule) const;
  [[nodiscard]] ast::Where where(const antlr4::Token* token) const;
  [[nodiscard]] std::string text(const Rule* rule) const;
  [[nodiscard]] std::string text(const antlr4::Token* token) const;
  /// The words of `rule` without the spaces between them.
  [[nodiscard]] std::string joined(const Rule* rule) const;
  [[nodiscard]] ast::Name name(const Rule* rule) const { return {text(rule), where(rule)}; }

  // Items.
  ast::Const constant(Parser::ConstantContext* rule);
  ast::Param parameter(Parser::ParameterContext* rule);
  ast::Var variable(Parser::VariableContext* rule);
  std::optional<ast::Expr> size(Parser::SizeContext* rule);
  ast::State state(Parser::StateContext* rule);
  ast::Behaviour behaviour(Parser::BehaviourContext* rule);
  ast::Item external(Parser::ExternalContext* rule);
  ast::Share share(Parser::ShareContext* rule);
  ast::Pack pack(Parser::PackContext* rule);
  ast::Choice choice(Parser::ChoiceContext* rule);
  ast::Preference preference(Parser::PreferenceContext* rule);
  std::optional<ast::Expr> exprAfter(antlr4::ParserRuleContext* rule,
                                     antlr4::tree::TerminalNode* word);
  ast::Vehicles vehicles(Parser::VehiclesContext* rule);
  ast::Requirement requirement(Parser::RequirementContext* rule);
  ast::Assumption assumption(Parser::AssumptionContext* rule);
  ast::PlaceDeclaration place(Parser::PlaceContext* rule);
  ast::Requirement patternRequirement(Parser::PatternPromiseContext* rule, ast::Where where);
  ast::ReactionPromise reaction(Parser::ReactionPatternContext* rule);
  ast::CountPromise count(Parser::CountPatternContext* rule);
  ast::NeverPromise never(Parser::NeverPatternContext* rule);
  ast::PromiseScope scope(Parser::ScopeContext* rule);
  ast::Expr somewhere(Parser::SomewhereContext* rule);
  std::vector<ast::Expr> route(Parser::RouteContext* rule);
  ast::Resumption resumption(Parser::ResumptionContext* rule);
  ast::TypeName type(Parser::TypeContext* rule);
  std::optional<ast::Range> range(Parser::RangeContext* rule);
  std::optional<std::vector<ast::Formal>> formals(Parser::FormalsContext* rule);

  // What stands inside states.
  ast::Member member(Parser::MemberContext* rule);
  std::vector<ast::Member> members(const Rule* rule);
  ast::SensorsMember sensors(const Rule* rule);
  ast::SampleMember sample(const Rule* rule);
  ast::Expr samplePart(Parser::SamplePartContext* rule);
  ast::Use use(const Rule* rule);
  std::vector<ast::Case> cases(const Rule* rule);
  ast::Case eventCase(const Rule* rule);
  ast::Block block(Parser::BlockContext* rule);
  std::vector<ast::Statement> statements(const std::vector<Parser::StatementContext*>& rules);
  ast::Statement statement(Parser::StatementContext* rule);
  ast::If ifStatement(Parser::IfStatementContext* rule);

  // Expressions.
  ast::Expr expr(Parser::ExprContext* rule);
  ast::Expr primary(Parser::PrimaryContext* rule);
  ast::Expr named(Parser::PrimaryContext* rule);
  ast::Import import(Parser::ImportLineContext* rule);
  ast::Expr literal(const Rule* rule);
  ast::Expr duration(const Rule* rule);
  [[nodiscard]] std::string digitsOf(const antlr4::Token* number) const;
  std::vector<ast::Argument> arguments(Parser::ArgumentsContext* rule);
  ast::Argument argument(const Rule* rule);

  Source source_;
};

}  // namespace glider::frontend
