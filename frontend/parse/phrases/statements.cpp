// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"
#include "support/one_of.h"

#include <fmt/format.h>

#include <optional>

namespace glider::frontend::phrases {
namespace {

/// Whether statements are read: in `do`, `then` and `else`.
bool mayBeginStatement(const Phrase& phrase) {
  const bool block =
      oneOf(phrase.keyword(), {GliderLexer::DO, GliderLexer::THEN, GliderLexer::ELSE,
                               GliderLexer::SET, GliderLexer::LOG, GliderLexer::END});
  return block && phrase.open().empty() &&
         (endsValue(phrase.before()) ||
          oneOf(phrase.before(),
                {GliderLexer::DO, GliderLexer::THEN, GliderLexer::ELSE, GliderLexer::END}));
}

/// `n += 1`, `n++`: a change of a variable, with its sign.
struct Change {
  std::string_view sign;
  size_t value = 0;         ///< the first token of what is added
  size_t value_tokens = 0;  ///< 0: 1 is
  size_t end = 0;
};

std::optional<Change> changeAt(const Phrase& phrase, size_t name) {
  const size_t sign = name + 1;
  const uint32_t type = phrase.type(sign);
  const bool arithmetic =
      oneOf(type, {GliderLexer::PLUS, GliderLexer::MINUS, GliderLexer::TIMES, GliderLexer::DIVIDE});
  if (!isName(phrase.type(name)) || !arithmetic || !phrase.touches(sign + 1)) {
    return std::nullopt;
  }
  Change change;
  change.sign = phrase.text(sign);
  if (phrase.type(sign + 1) == GliderLexer::ASSIGN) {
    change.value = sign + 2;
    change.value_tokens = tokensOfNumber(phrase, change.value);
    if (change.value_tokens == 0 && isName(phrase.type(change.value))) {
      change.value_tokens = 1;
    }
    change.end = change.value + change.value_tokens;
    return change.value_tokens > 0 ? std::optional(change) : std::nullopt;
  }
  const bool twice =
      phrase.type(sign + 1) == type && oneOf(type, {GliderLexer::PLUS, GliderLexer::MINUS});
  change.end = sign + 2;
  return twice ? std::optional(change) : std::nullopt;
}

/// `set n += 1` and `n++`, with or without `set`.
size_t changeOfVariable(Phrase& phrase) {
  const size_t name = phrase.type() == GliderLexer::SET ? 1 : 0;
  const auto change = changeAt(phrase, name);
  if (!change) {
    return 0;
  }
  const std::string better = fmt::format(
      "set {0} = {0} {1} {2}", phrase.text(name), change->sign,
      change->value_tokens == 0 ? std::string_view("1")
                                : phrase.wholeText(change->value, change->value_tokens));
  const Lexeme whole = phrase.whole(0, change->end);
  // `n -= k + 1` is n - (k + 1): only the pilot can write where the value ends.
  const bool goes_on = isOperator(phrase.type(change->end));
  auto report =
      phrase.reporter().at(whole, support::diagnostics::notAStatement, phrase.source().text(whole));
  if (goes_on) {
    report.hint(fmt::format("write `set {0} = {0} {1} (…)`", phrase.text(name), change->sign));
  } else {
    report.hint(fmt::format("write `{}`", better)).fix(phrase.source().range(whole), better);
  }
  const Lexeme variable = phrase.token(name);
  phrase.put({GliderLexer::SET, whole.begin, whole.begin + 1});
  phrase.put(variable);
  phrase.put({GliderLexer::ASSIGN, variable.end, variable.end + 1});
  phrase.put(variable);
  phrase.put(phrase.token(name + 1));
  phrase.put(variable);
  return change->end;
}

/// `print "warm"`.
size_t printing(Phrase& phrase) {
  const bool word =
      phrase.type() == GliderLexer::NAME &&
      support::isOneOf(phrase.lower(), {"print", "printf", "echo", "display", "write", "say"});
  const size_t open = phrase.type(1) == GliderLexer::LPAREN ? 1 : 0;
  if (!word || phrase.type(1 + open) != GliderLexer::STRING) {
    return 0;
  }
  const Lexeme name = phrase.token();
  auto report = phrase.reporter().at(name, support::diagnostics::notAStatement, phrase.text());
  report.hint("write `log`");
  if (open == 0) {
    report.fix(phrase.source().range(name), "log");
  }
  phrase.put({GliderLexer::LOG, name.begin, name.end});
  if (open == 0) {
    return 1;
  }
  size_t end = 2;
  while (!oneOf(phrase.type(end), {GliderLexer::RPAREN, kEof}) &&
         !isHardKeyword(phrase.type(end))) {
    ++end;
  }
  if (phrase.type(end) == GliderLexer::RPAREN) {
    phrase.leaveOut(end);
  }
  return 2;
}

/// `wait 10 min`: the cases of a state wait.
size_t waiting(Phrase& phrase) {
  const bool word = phrase.type() == GliderLexer::NAME &&
                    support::isOneOf(phrase.lower(), {"wait", "sleep", "delay", "pause"});
  const size_t open = phrase.type(1) == GliderLexer::LPAREN ? 1 : 0;
  const size_t time = word ? tokensOfNumber(phrase, 1 + open) : 0;
  if (time == 0) {
    return 0;
  }
  const bool closed = open > 0 && phrase.type(2 + time) == GliderLexer::RPAREN;
  const size_t tokens = 1 + open + time + (closed ? 1 : 0);
  const Lexeme whole = phrase.whole(0, tokens);
  phrase.reporter()
      .at(whole, support::diagnostics::notAStatement, phrase.source().text(whole))
      .hint(fmt::format("a mission does not wait: give a state the case `case statetime > {} …`",
                        phrase.wholeText(1 + open, time)));
  return tokens;
}

/// `elseif depth > 3 m then`: to keep the blocks in order, it is read as an `if` of its own.
size_t elseIf(Phrase& phrase) {
  if (phrase.type() != GliderLexer::NAME ||
      !support::isOneOf(phrase.lower(), {"elseif", "elif", "elsif"})) {
    return 0;
  }
  const Lexeme word = phrase.token();
  phrase.reporter()
      .at(word, support::diagnostics::notAStatement, phrase.text())
      .hint("write `else if … then … end`, and one `end` more");
  phrase.put({GliderLexer::END, word.begin, word.end});
  phrase.put({GliderLexer::IF, word.begin, word.end});
  return 1;
}

}  // namespace

size_t statement(Phrase& phrase) {
  const bool set = phrase.type() == GliderLexer::SET;
  if (set) {
    return changeOfVariable(phrase);
  }
  if (!isName(phrase.type()) || !mayBeginStatement(phrase)) {
    return 0;
  }
  return firstOf(phrase, {changeOfVariable, printing, waiting, elseIf});
}

size_t actionWithoutDo(Phrase& phrase) {
  const bool action = oneOf(phrase.type(), {GliderLexer::SET, GliderLexer::LOG});
  const bool condition =
      phrase.keyword() == GliderLexer::CASE && endsValue(phrase.before()) && phrase.open().empty();
  if (!action || !condition) {
    return 0;
  }
  const size_t line = phrase.tokensOfLine();
  size_t end = 1;
  while (end < line && !isTransition(phrase.type(end)) && phrase.type(end) != GliderLexer::END) {
    ++end;
  }
  if (end >= line || !isTransition(phrase.type(end))) {
    return 0;
  }
  const Lexeme keyword = phrase.token();
  const Lexeme& last = phrase.token(end - 1);
  const uint32_t file = phrase.source().file;
  phrase.reporter()
      .at(keyword, support::diagnostics::actionWithoutDo, phrase.text(), phrase.wholeText(0, end))
      .fix({file, keyword.begin, keyword.begin}, "do ")
      .fix({file, last.end, last.end}, " end");
  phrase.insert(GliderLexer::DO);
  for (size_t k = 0; k < end; ++k) {
    phrase.put(phrase.token(k));
  }
  phrase.insert(GliderLexer::END);
  return end;
}

}  // namespace glider::frontend::phrases
