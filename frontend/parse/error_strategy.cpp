// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/error_strategy.h"

#include "frontend/parse/lexeme_stream.h"
#include "frontend/parse/token_kinds.h"
#include "frontend/spelling.h"
#include "grammar/GliderParser.h"
#include "support/diagnostics/ids/syntax.h"
#include "support/one_of.h"

#include <fmt/format.h>

#include <string>

namespace glider::frontend {

using grammar::GliderParser;

namespace {

/// Whether it is a keyword that begins something: a good place to continue reading.
bool isBoundary(size_t type) {
  const auto t = static_cast<uint32_t>(type);
  return t == kEof || (isHardKeyword(t) && !oneOf(t, {GliderLexer::TRUE, GliderLexer::FALSE,
                                                      GliderLexer::EVERY, GliderLexer::NOT_WORD}));
}

/// Ends the events of a state, or begins the next of its cases.
bool endsCase(size_t type) {
  const auto t = static_cast<uint32_t>(type);
  return startsItem(t) || startsMember(t) ||
         oneOf(t, {kEof, GliderLexer::CASE, GliderLexer::END, GliderLexer::VAR});
}

/// Skips to a token for which `stop` is true, and skips whole blocks; it never passes the end of an
/// outer block.
template <typename Stop>
void skipTo(antlr4::Parser* parser, Stop stop) {
  size_t deep = 0;
  for (;;) {
    const size_t type = parser->getTokenStream()->LA(1);
    if (type == antlr4::Token::EOF || (deep == 0 && (stop(type) || type == GliderParser::END))) {
      return;
    }
    deep += type == GliderParser::BEGIN || type == GliderParser::DO || type == GliderParser::IF
                ? 1U
                : 0U;
    deep -= type == GliderParser::END ? 1U : 0U;
    parser->consume();
  }
}

bool isLoop(const antlr4::atn::ATNState* state) {
  const auto type = const_cast<antlr4::atn::ATNState*>(state)->getStateType();
  return type == antlr4::atn::ATNState::STAR_LOOP_ENTRY ||
         type == antlr4::atn::ATNState::STAR_LOOP_BACK ||
         type == antlr4::atn::ATNState::PLUS_LOOP_BACK;
}

/// Whether what was read last is `sample …`.
bool isInSample(antlr4::Parser* parser) {
  for (ssize_t k = 1;; ++k) {
    const antlr4::Token* token = parser->getTokenStream()->LT(-k);
    const auto type = token == nullptr ? kEof : static_cast<uint32_t>(token->getType());
    if (type == kEof || startsMember(type)) {
      return type == GliderLexer::SAMPLE;
    }
  }
}

/// "`,` or `)`" for a set of tokens; operators (which may follow every value) are left out if the
/// set has anything else.
std::string listOf(const antlr4::misc::IntervalSet& set) {
  constexpr size_t kMost = 6;
  std::vector<std::string> words;
  for (const ssize_t type : set.toList()) {
    const auto t = static_cast<uint32_t>(type);
    const bool alias =
        (isName(t) && t != GliderLexer::NAME) || t == GliderLexer::MIN || isOperator(t);
    if (type > 0 && !alias) {
      words.push_back(describeType(t));
    }
  }
  if (words.empty() || words.size() > kMost) {
    return "something else";
  }
  std::string out;
  for (size_t i = 0; i < words.size(); ++i) {
    out += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  }
  return out;
}

/// What is between the quotation marks, typewritten or typeset; empty if the second is missing.
std::string unquoted(std::string_view string) {
  const bool typeset = !string.empty() && (static_cast<unsigned char>(string.back()) & 0x80) != 0;
  const bool whole = string.size() >= 2 && (string.back() == '"' || typeset);
  return whole ? std::string(string.substr(1, string.size() - 2)) : "";
}

}  // namespace

void ErrorStrategy::reportMatch(antlr4::Parser* parser) {
  if (errorRecoveryMode && isBoundary(parser->getTokenStream()->LA(1))) {
    endErrorCondition(parser);
  }
}

void ErrorStrategy::reportError(antlr4::Parser* parser, const antlr4::RecognitionException& error) {
  complain(parser, error.getOffendingToken());
}

antlr4::Token* ErrorStrategy::recoverInline(antlr4::Parser* parser) {
  throw antlr4::InputMismatchException(parser);
}

void ErrorStrategy::recover(antlr4::Parser* parser, std::exception_ptr) {
  const size_t rule = parser->getContext()->getRuleIndex();
  const auto index = static_cast<int>(parser->getTokenStream()->index());
  if (lastErrorIndex == index &&
      lastErrorStates.contains(static_cast<ssize_t>(parser->getState()))) {
    parser->consume();  // the same rule failed here before: always advance
  }
  if (lastErrorIndex != index) {
    lastErrorStates.clear();
  }
  lastErrorIndex = index;
  lastErrorStates.add(static_cast<ssize_t>(parser->getState()));
  if (rule == GliderParser::RuleTransition || rule == GliderParser::RuleTarget) {
    skipTo(parser, endsCase);
  } else {
    skipTo(parser, isBoundary);
  }
}

void ErrorStrategy::sync(antlr4::Parser* parser) {
  const auto& atn = parser->getInterpreter<antlr4::atn::ParserATNSimulator>()->atn;
  const antlr4::atn::ATNState* state = atn.states[parser->getState()];
  if (!isLoop(state)) {
    return;
  }
  const size_t found = parser->getTokenStream()->LA(1);
  const auto next = atn.nextTokens(const_cast<antlr4::atn::ATNState*>(state));
  if (next.contains(found) && isBoundary(found)) {
    endErrorCondition(parser);  // recovered
  }
  const bool cases = next.contains(size_t{GliderParser::CASE});
  const bool mayEnd = next.contains(antlr4::Token::EPSILON) && !(cases && !endsCase(found));
  if (mayEnd || next.contains(found) || found == antlr4::Token::EOF) {
    return;
  }
  complain(parser, parser->getCurrentToken());
  if (cases) {
    skipTo(parser, endsCase);
  } else {
    // A list of arguments ends at the next keyword at the latest; a body of a state ends only at a
    // token that may be in it.
    const bool body =
        next.contains(size_t{GliderParser::END}) || next.contains(size_t{GliderParser::STATE});
    skipTo(parser, [&](size_t type) { return next.contains(type) || (!body && isBoundary(type)); });
  }
}

void ErrorStrategy::complain(antlr4::Parser* parser, const antlr4::Token* found) {
  failed_ = true;
  if (inErrorRecoveryMode(parser)) {
    return;
  }
  beginErrorCondition(parser);
  const antlr4::Token* before = parser->getTokenStream()->LT(-1);
  if (before != nullptr && before->getStartIndex() == before->getStopIndex()) {
    return;  // after something missing that repair has inserted: already reported
  }
  if (reporter_.full()) {
    throw antlr4::ParseCancellationException();
  }
  complainInRule(parser, parser->getContext()->getRuleIndex(), lexemeOf(found));
}

void ErrorStrategy::expected(std::string_view what, const Lexeme& found) {
  const Source& source = reporter_.source();
  auto report =
      reporter_.at(found, support::diagnostics::unexpectedToken, what, describe(source, found));
  const std::string text = found.type == GliderLexer::STRING ? unquoted(source.text(found)) : "";
  if (!text.empty() && what.starts_with("a value") && text.front() >= '0' && text.front() <= '9') {
    report.hint(fmt::format("write it without quotes: `{}`", text)).fix(source.range(found), text);
  }
}

/// `param d: length` and `set n 1`: the error is where the value is missing, which may be lines
/// before what was found.
void ErrorStrategy::expectedValue(uint32_t keyword, const Lexeme& before, const Lexeme& found) {
  const Source& source = reporter_.source();
  const std::string_view last = source.text(before);
  if (oneOf(found.type, {GliderLexer::NUMBER, GliderLexer::NAME, GliderLexer::STRING,
                         GliderLexer::MINUS, GliderLexer::LPAREN})) {
    reporter_.at(found, support::diagnostics::unexpectedToken, "`=`", describe(source, found))
        .hint(fmt::format("write `=` after `{}`", last))
        .fix({source.file, before.end, before.end}, " =");
    return;
  }
  auto report =
      reporter_.at(before, support::diagnostics::unexpectedToken,
                   fmt::format("`=` and a value after `{}`", last), describe(source, found));
  const bool fixed = oneOf(keyword, {GliderLexer::PARAM, GliderLexer::CONST});
  report.hint(fixed && found.type == GliderLexer::IN
                  ? fmt::format("write `{} = …`; a value that `glidercc plan` is to choose is "
                                "declared with `choose`",
                                last)
                  : fmt::format("write `{} = …`", last));
}

/// `log deep`.
void ErrorStrategy::expectedText(const Lexeme& found) {
  const Source& source = reporter_.source();
  auto report = reporter_.at(found, support::diagnostics::unexpectedToken, "a text in quotes",
                             describe(source, found));
  if (found.type == GliderLexer::NAME) {
    report.hint(fmt::format("write `log \"{0}\"`, or `log \"{0}\", {0}` to log its value",
                            source.text(found)));
  }
}

bool ErrorStrategy::misspelled(const Lexeme& found, const std::vector<std::string_view>& keywords) {
  const std::string_view word = reporter_.source().text(found);
  const std::string_view meant =
      found.type == GliderLexer::NAME ? closest(word, keywords) : std::string_view{};
  if (!meant.empty()) {
    auto report = reporter_.at(found, support::diagnostics::misspelledKeyword, word, meant);
    if (isSlip(word, meant)) {
      report.fix(reporter_.source().range(found), std::string(meant));
    }
  }
  return !meant.empty();
}

void ErrorStrategy::complainOfTransition(const Lexeme& before, const Lexeme& found) {
  if (isBoundary(found.type)) {
    reporter_.at(before, support::diagnostics::missingTransition);
  } else if (found.type == GliderLexer::NAME) {
    const std::string_view word = reporter_.source().text(found);
    auto report = reporter_.at(found, support::diagnostics::wrongTransition, word);
    const std::string_view meant = closest(word, {"goto", "call", "return", "exit", "stay"});
    if (!meant.empty()) {
      // No fix: where a mission continues is never guessed.
      report.hint(fmt::format("did you mean `{}`?", meant));
    } else if (isStateName(reporter_.source(), word)) {
      report.hint(fmt::format("write `goto {0}` or `call {0}`", word));
    } else if (support::isOneOf(word, {"stop", "finish", "quit", "terminate", "abort"})) {
      report.hint("write `exit`, which ends the mission");
    } else if (support::isOneOf(word, {"surface", "surfaced"})) {
      report.hint("write `goto` and a state with `flightprofile surfaced`");
    }
  } else {
    expected("an operator, or `goto`, `call`, `return`, `exit` or `stay`", found);
  }
}

void ErrorStrategy::complainOfValue(antlr4::Parser* parser, const antlr4::Token* before,
                                    const Lexeme& found) {
  const auto set = parser->getExpectedTokens();
  if (before != nullptr && before->getType() == GliderParser::LOG) {
    return expectedText(found);
  }
  if (before != nullptr && set.contains(size_t{GliderParser::ASSIGN})) {
    const size_t keyword = parser->getContext()->getStart()->getType();
    return expectedValue(static_cast<uint32_t>(keyword), lexemeOf(before), found);
  }
  const bool statement = set.contains(size_t{GliderParser::SET});
  expected(statement ? "`set`, `if`, `for`, `log`, a command or `end`" : listOf(set), found);
}

void ErrorStrategy::complainOfPromise(size_t last, const Lexeme& found) {
  const Source& source = reporter_.source();
  auto report = reporter_.at(
      found, support::diagnostics::unexpectedToken,
      "`always`, `exit within`, `stack <=`, `can reach`, `surfaces every`, `never`, `visit`, "
      "`patrol`, `whenever`, `when` or `hold`",
      describe(source, found));
  if (last == GliderParser::COLON &&
      oneOf(found.type, {GliderLexer::SURFACES, GliderLexer::EXIT, GliderLexer::STACK})) {
    report.hint(fmt::format("`{}` is about the whole mission: write it without a scope before it",
                            found.type == GliderLexer::SURFACES ? "surfaces every"
                            : found.type == GliderLexer::EXIT   ? "exit within"
                                                                : "stack <="));
  } else if (last == GliderParser::STACK && found.type == GliderLexer::LT) {
    report.hint("write `require stack <= …`");
  } else if (last == GliderParser::REQUIRE && found.type == GliderLexer::NAME) {
    const std::string_view word = source.text(found);
    report.hint(isStateName(source, word)
                    ? fmt::format("write what is required of it, as in `require visit {0}` or "
                                  "`require never {0}`",
                                  word)
                    : "write what is required, as in `require visit …`, `require never …` or "
                      "`require always …`");
  }
}

/// A word that begins nothing, before whose `(` nothing is wrong yet.
void ErrorStrategy::complainOfWord(antlr4::Parser* parser, const Lexeme& word) {
  const auto* outer = dynamic_cast<antlr4::ParserRuleContext*>(parser->getContext()->parent);
  if (outer != nullptr && outer->getRuleIndex() == GliderParser::RuleStatement) {
    reporter_.at(word, support::diagnostics::notAStatement, reporter_.source().text(word));
    return;
  }
  expected("an operator, or the end of the value", word);
}

void ErrorStrategy::complainOfBody(antlr4::Parser* parser, const Lexeme& found) {
  if (isInSample(parser)) {
    return complainOfSample(found);
  }
  if (!misspelled(found, {"flightroute", "flightprofile", "sensors", "sample", "entry", "events",
                          "var", "end"})) {
    expected("`flightroute`, `flightprofile`, `sensors`, `events` or `end`", found);
  }
}

void ErrorStrategy::complainOfSample(const Lexeme& found) {
  reporter_
      .at(found, support::diagnostics::unexpectedToken, "`,` or the next line",
          describe(reporter_.source(), found))
      .hint(
          "an instrument reads `off` or `every 10 s`, then `on climbs`, `on dives`, `below 20 m`, "
          "`above 5 m`, `one yo in 3` or `when CONDITION`");
}

void ErrorStrategy::complainOfItem(const Lexeme& found) {
  if (!misspelled(found, {"mission", "platform", "import", "const", "param", "var", "always",
                          "state", "flightprofile", "flightroute", "extern", "require", "place",
                          "resume", "declination", "pack", "choose", "prefer", "nap"})) {
    expected("`state` or another declaration", found);
  }
}

/// A line of energy: the batteries, how long the SBC may sleep, what is to be chosen and what is
/// preferred. A range is missing only where something is to be chosen.
void ErrorStrategy::complainOfLine(antlr4::Parser* parser, size_t rule, const Lexeme& found) {
  const auto set = parser->getExpectedTokens();
  if (rule == GliderParser::RulePack) {
    return expected("`at` and the voltage, as in `pack 168 Ah at 14.4 V`", found);
  }
  if (rule == GliderParser::RuleNap) {
    return expected("`at most` and a time, as in `nap at most 4 min`", found);
  }
  if (rule == GliderParser::RulePreference || rule == GliderParser::RuleObjective) {
    return expected("`least` or `greatest` and a value, or `endurance`", found);
  }
  if (set.contains(size_t{GliderParser::COLON})) {
    return expected("`:` and a type, as in `choose bottom : length in 60 m .. 180 m`", found);
  }
  expected(set.contains(size_t{GliderParser::IN})
               ? "`in` and a range, as in `choose bottom : length in 60 m .. 180 m`"
               : listOf(set),
           found);
}

void ErrorStrategy::complainInRule(antlr4::Parser* parser, size_t rule, const Lexeme& found) {
  const antlr4::Token* before = parser->getTokenStream()->LT(-1);
  const size_t last = before == nullptr ? 0 : before->getType();
  switch (rule) {
    case GliderParser::RuleTransition:
      return complainOfTransition(lexemeOf(before), found);
    case GliderParser::RuleArgument:
    case GliderParser::RuleExpr:
    case GliderParser::RulePrimary:
      return last == GliderParser::NUMBER
                 ? expected("an operator, or the end of the value", lexemeOf(before))
                 : expected(last == GliderParser::CASE ? "a condition" : "a value", found);
    case GliderParser::RuleArguments:
      if (parser->getExpectedTokens().contains(size_t{GliderParser::LPAREN}) &&
          last != GliderParser::LPAREN && last != GliderParser::COMMA) {
        return complainOfWord(parser, lexemeOf(before));
      }
      return expected(last == GliderParser::LPAREN ? "a value or `)`" : "`,` or `)`", found);
    case GliderParser::RuleFormals:
      return expected(last == GliderParser::LPAREN ? "a name or `)`" : "`,` or `)`", found);
    case GliderParser::RuleScope:
    case GliderParser::RulePromise:
    case GliderParser::RulePattern:
      return complainOfPromise(last, found);
    case GliderParser::RulePack:
    case GliderParser::RuleNap:
    case GliderParser::RuleRange:
    case GliderParser::RuleChoice:
    case GliderParser::RulePreference:
    case GliderParser::RuleObjective:
      return complainOfLine(parser, rule, found);
    case GliderParser::RuleDeclaration:
      return expected(last == GliderParser::EXTERN
                          ? "`function`, `flightprofile`, `flightroute` or `sensor`"
                          : listOf(parser->getExpectedTokens()),
                      found);
    case GliderParser::RuleFile:
    case GliderParser::RuleItem:
      return complainOfItem(found);
    case GliderParser::RuleState:
    case GliderParser::RuleBehaviour:
      return complainOfBody(parser, found);
    case GliderParser::RuleSampleItem:
    case GliderParser::RuleSamplePart:
      return complainOfSample(found);
    case GliderParser::RuleMember:
      return expected("`case` or `end`", found);
    case GliderParser::RuleConstant:
    case GliderParser::RuleParameter:
    case GliderParser::RuleVariable:
    case GliderParser::RuleBlock:
    case GliderParser::RuleStatement:
      return complainOfValue(parser, before, found);
    case GliderParser::RuleName:
    case GliderParser::RuleAnyName:
      return expected("a name", found);
    default:
      return expected(listOf(parser->getExpectedTokens()), found);
  }
}

}  // namespace glider::frontend
