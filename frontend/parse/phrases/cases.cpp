// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "frontend/spelling.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace glider::frontend::phrases {
namespace {

/// What ends the condition of a case: its transition, or the block before it.
struct Condition {
  size_t tokens = 0;  ///< 0: there is no condition
  size_t then = 0;    ///< a `then` after it: its number
  size_t arrow = 0;   ///< the tokens of an arrow or a colon after it
  size_t transition = 0;
};

bool isWord(const Phrase& phrase, size_t k, std::string_view keyword) {
  return isAnyName(phrase.type(k)) || isHardKeyword(phrase.type(k)) ? phrase.says(k, keyword)
                                                                    : false;
}

/// The tokens of an arrow or a colon at `k` that leads to a transition: elsewhere `=>` is a
/// comparison.
size_t tokensOfLeadingArrow(const Phrase& phrase, size_t k) {
  const size_t tokens = phrase.type(k) == GliderLexer::COLON ? 1 : tokensOfArrow(phrase, k);
  const uint32_t next = phrase.type(k + tokens);
  return isTransition(next) || next == GliderLexer::DO ? tokens : 0;
}

/// The condition from token `first` on, if a transition follows on its line, perhaps after `then`
/// or a block.
Condition conditionFrom(const Phrase& phrase, size_t first) {
  Condition found;
  const size_t line = phrase.tokensOfLine();
  size_t k = first;
  while (k < line && !isTransition(phrase.type(k)) && phrase.type(k) != GliderLexer::DO &&
         !isWord(phrase, k, "then") && tokensOfLeadingArrow(phrase, k) == 0) {
    ++k;
  }
  const size_t count = k - first;
  found.arrow = tokensOfLeadingArrow(phrase, k);
  const bool value = found.arrow > 0 ? readsAsValue(phrase, first, count)
                                     : tokensOfValue(phrase, first, false) == count;
  if (k >= line || count == 0 || !value) {
    return {};
  }
  k += found.arrow;
  if (isWord(phrase, k, "then")) {
    found.then = k++;
  }
  const bool leads = isTransition(phrase.type(k)) || phrase.type(k) == GliderLexer::DO;
  found.tokens = leads ? count : 0;
  found.transition = k;
  return found;
}

/// The tokens of the transition at `k`: `exit`, `call up`, `call up(5 m)`.
size_t tokensOfTransition(const Phrase& phrase, size_t k) {
  if (!oneOf(phrase.type(k), {GliderLexer::GOTO, GliderLexer::CALL})) {
    return 1;
  }
  if (phrase.type(k + 2) != GliderLexer::LPAREN) {
    return 2;
  }
  size_t end = k + 3;
  while (!oneOf(phrase.type(end), {GliderLexer::RPAREN, kEof}) &&
         !isHardKeyword(phrase.type(end))) {
    ++end;
  }
  return end + 1 - k;
}

/// Whether the `end` at token `k` closes the `if` that is a case, and not the state: something that
/// is still inside the state follows it.
bool isEndOfIf(const Phrase& phrase, size_t k) {
  constexpr std::array<std::string_view, 4> kWords = {"if", "when", "else", "case"};
  return phrase.type(k) == GliderLexer::END &&
         (phrase.type(k + 1) == GliderLexer::END ||
          std::ranges::any_of(kWords, [&](auto word) { return isWord(phrase, k + 1, word); }));
}

/// `if`, `when`, `else if`: the tokens of what begins a condition in other languages.
size_t tokensOfIf(const Phrase& phrase) {
  constexpr std::array<std::string_view, 7> kWords = {"if",     "when", "whenever", "on",
                                                      "elseif", "elif", "elsif"};
  if (isWord(phrase, 0, "else") && isWord(phrase, 1, "if")) {
    return 2;
  }
  return std::ranges::any_of(kWords, [&](auto word) { return isWord(phrase, 0, word); }) ? 1 : 0;
}

support::DiagnosticBuilder report(Phrase& phrase, size_t tokens) {
  return phrase.reporter().at(phrase.whole(0, tokens), support::diagnostics::notACase,
                              phrase.wholeText(0, tokens));
}

/// Removes the `then` and the `end` around a condition that are not those of a case.
void dropThenAndEnd(Phrase& phrase, const Condition& condition,
                    support::DiagnosticBuilder& builder) {
  for (size_t k = condition.transition - condition.arrow;
       condition.then == 0 && k < condition.transition; ++k) {
    builder.fix(phrase.source().range(phrase.token(k)), "");
    phrase.leaveOut(k);
  }
  if (condition.then == 0) {
    return;
  }
  const Source& source = phrase.source();
  builder.fix(source.range(phrase.token(condition.then)), "");
  phrase.leaveOut(condition.then);
  const size_t end = condition.transition + tokensOfTransition(phrase, condition.transition);
  if (isEndOfIf(phrase, end)) {
    builder.fix(source.range(phrase.token(end)), "");
    phrase.leaveOut(end);
  }
}

/// `if depth > 30 m then call up else call down end` on one line: two cases, which only the pilot
/// can put in order.
size_t ifElseAsCases(Phrase& phrase, size_t tokens, const Condition& condition) {
  const size_t other = condition.transition + tokensOfTransition(phrase, condition.transition);
  const size_t line = phrase.tokensOfLine();
  if (!isWord(phrase, other, "else") || other >= line || !isTransition(phrase.type(other + 1))) {
    return 0;
  }
  report(phrase, tokens)
      .hint(fmt::format("write two cases: `case {} {}`, and below it `case true {}`, after which "
                        "no case is tried",
                        phrase.wholeText(tokens, condition.tokens),
                        phrase.wholeText(condition.transition, other - condition.transition),
                        phrase.wholeText(other + 1, tokensOfTransition(phrase, other + 1))));
  if (condition.then != 0) {
    phrase.leaveOut(condition.then);
  }
  for (size_t k = other; k < line; ++k) {
    phrase.leaveOut(k);
  }
  phrase.put(phrase.whole(0, tokens, GliderLexer::CASE));
  return tokens;
}

/// `if depth > 30 m then log "deep" end` among cases: a case whose block does it.
size_t ifWithActions(Phrase& phrase, size_t tokens) {
  constexpr size_t kFarthest = 100;
  const size_t line = phrase.tokensOfLine();
  size_t then = tokens;
  while (then < line && !isWord(phrase, then, "then")) {
    ++then;
  }
  if (then >= line || !oneOf(phrase.type(then + 1), {GliderLexer::SET, GliderLexer::LOG}) ||
      tokensOfValue(phrase, tokens, false) != then - tokens) {
    return 0;
  }
  size_t end = then + 1;
  while (end < kFarthest && phrase.type(end) != GliderLexer::END) {
    const uint32_t type = phrase.type(end);
    if (startsItem(type) || isTransition(type) ||
        oneOf(type, {kEof, GliderLexer::CASE, GliderLexer::IF, GliderLexer::ELSE})) {
      return 0;
    }
    ++end;
  }
  if (end >= kFarthest || !phrase.startsLine(end + 1) || startsItem(phrase.type(end + 1)) ||
      startsMember(phrase.type(end + 1))) {
    return 0;
  }
  report(phrase, tokens)
      .hint(
          fmt::format("write `case {} do … end stay`, or with `became(…)` around the condition to "
                      "do it once",
                      phrase.wholeText(tokens, then - tokens)));
  phrase.put(phrase.whole(0, tokens, GliderLexer::CASE));
  for (size_t k = tokens; k < then; ++k) {
    phrase.put(phrase.token(k));
  }
  phrase.put({GliderLexer::DO, phrase.token(then).begin, phrase.token(then).end});
  phrase.supplyBefore(end + 1, GliderLexer::STAY);
  return then + 1;
}

/// `unless battery > 12 V goto back`, `until battery < 12 V stay`.
size_t otherConditionWord(Phrase& phrase) {
  const bool unless = isWord(phrase, 0, "unless");
  const bool stays = isWord(phrase, 0, "while") || isWord(phrase, 0, "until");
  const Condition condition = unless || stays ? conditionFrom(phrase, 1) : Condition{};
  if (condition.tokens == 0 || !readsAsValue(phrase, 1, condition.tokens)) {
    return 0;
  }
  const Lexeme word = phrase.token();
  const Lexeme last = phrase.token(condition.tokens);
  const std::string_view text = phrase.wholeText(1, condition.tokens);
  auto builder = report(phrase, 1);
  if (unless) {
    builder.hint(fmt::format("write `case !({}) …`", text))
        .fix({phrase.source().file, word.begin, phrase.token(1).begin}, "case !(")
        .fix({phrase.source().file, last.end, last.end}, ")");
  } else if (phrase.type(condition.transition) == GliderLexer::STAY) {
    builder.hint(
        fmt::format("a state lasts until a case leaves it: write `case {} goto …`",
                    isWord(phrase, 0, "while") ? fmt::format("!({})", text) : std::string(text)));
  } else {
    builder.hint(fmt::format("write `case {} …`", text));
  }
  phrase.put({GliderLexer::CASE, word.begin, word.end});
  return 1;
}

/// `if temp > 20 degC then call up end` is a case. The words around its condition go with it.
size_t ifAsCase(Phrase& phrase, size_t tokens) {
  const Condition condition = conditionFrom(phrase, tokens);
  if (condition.tokens == 0) {
    return ifWithActions(phrase, tokens);
  }
  if (const size_t taken = ifElseAsCases(phrase, tokens, condition)) {
    return taken;
  }
  const Source& source = phrase.source();
  auto builder = report(phrase, tokens);
  builder.hint(fmt::format("write `case {} …`", phrase.wholeText(tokens, condition.tokens)))
      .fix(source.range(phrase.whole(0, tokens)), "case");
  dropThenAndEnd(phrase, condition, builder);
  phrase.put(phrase.whole(0, tokens, GliderLexer::CASE));
  return tokens;
}

/// Whether no case follows the one whose block or transition begins at token `k`.
bool isLastCase(const Phrase& phrase, size_t k) {
  constexpr size_t kFarthest = 300;
  size_t deep = 0;
  for (const size_t first = k; deep > 0 || !isTransition(phrase.type(k)); ++k) {
    const uint32_t type = phrase.type(k);
    if (type == kEof || k - first > kFarthest) {
      return false;
    }
    deep += oneOf(type, {GliderLexer::DO, GliderLexer::IF}) ? 1U : 0U;
    deep -= type == GliderLexer::END && deep > 0 ? 1U : 0U;
  }
  const uint32_t next = phrase.type(k + tokensOfTransition(phrase, k));
  return oneOf(next, {GliderLexer::END, kEof}) || startsItem(next);
}

/// `else stay`: a case that is always true. In the middle of others it would hide those after it.
size_t elseAsCase(Phrase& phrase) {
  constexpr std::array<std::string_view, 3> kWords = {"else", "otherwise", "default"};
  const bool other =
      std::ranges::any_of(kWords, [&](auto word) { return isWord(phrase, 0, word); });
  if (!other || !(isTransition(phrase.type(1)) || phrase.type(1) == GliderLexer::DO)) {
    return 0;
  }
  const Lexeme word = phrase.token();
  const std::string transition =
      isTransition(phrase.type(1)) ? std::string(phrase.wholeText(1, tokensOfTransition(phrase, 1)))
                                   : "do …";
  auto builder = report(phrase, 1);
  if (isLastCase(phrase, 1)) {
    builder.hint(fmt::format("write `case true {}` as the last case", transition))
        .fix(phrase.source().range(word), "case true");
  } else {
    builder.hint(
        fmt::format("move it after the other cases and write `case true {}`: no case after "
                    "it would ever be taken",
                    transition));
  }
  phrase.put({GliderLexer::CASE, word.begin, word.end});
  phrase.put({GliderLexer::TRUE, word.begin, word.end});
  return 1;
}

/// The tokens of `3 yos` from token `k` on; 0: it is something else.
size_t tokensOfYos(const Phrase& phrase, size_t k) {
  constexpr std::array<std::string_view, 4> kWords = {"yo", "yos", "dive", "dives"};
  const bool yos = phrase.type(k) == GliderLexer::NUMBER && isAnyName(phrase.type(k + 1)) &&
                   std::ranges::any_of(kWords, [&](auto word) { return phrase.says(k + 1, word); });
  return yos ? 2 : 0;
}

/// The condition that is meant with `every 3 yos` and `after 3 yos`.
std::string countOfYos(const Phrase& phrase, size_t number) {
  return phrase.type(number - 1) == GliderLexer::EVERY
             ? fmt::format("became(yo_number > 1 && remainder(yo_number - 1, {}) == 0)",
                           phrase.text(number))
             : fmt::format("yo_number > {}", phrase.text(number));
}

/// `every 30 min call up`, `after 1 h exit`: a clock does what the word says.
size_t clockAsCase(Phrase& phrase) {
  const bool every = phrase.type() == GliderLexer::EVERY;
  if (!every && phrase.type() != GliderLexer::AFTER) {
    return 0;
  }
  const size_t yos = tokensOfYos(phrase, 1);
  const size_t time = yos != 0 ? yos : tokensOfNumber(phrase, 1);
  if (time == 0 || !isTransition(phrase.type(1 + time))) {
    return 0;
  }
  const Lexeme word = phrase.token();
  // `always` belongs to no state.
  const bool always = phrase.before() == GliderLexer::ALWAYS;
  const char* clock = always ? "missiontime" : every ? "resumetime" : "statetime";
  const std::string condition =
      yos != 0 ? countOfYos(phrase, 1) : fmt::format("{} > {}", clock, phrase.wholeText(1, time));
  report(phrase, 1).hint(fmt::format("write `case {} …`", condition));
  phrase.put({GliderLexer::CASE, word.begin, word.end});
  phrase.put(phrase.whole(1, time, GliderLexer::TRUE));
  phrase.notAsMeant();
  return 1 + time;
}

/// A whole line, or what follows `always`, that is a condition and a transition.
size_t conditionAlone(Phrase& phrase) {
  const bool first = phrase.startsLine() || phrase.before() == GliderLexer::ALWAYS;
  const Condition condition = first ? conditionFrom(phrase, 0) : Condition{};
  if (condition.tokens < 3 || !readsAsValue(phrase, 0, condition.tokens)) {
    return 0;
  }
  const Lexeme word = phrase.token();
  auto builder = report(phrase, 1);
  builder.hint(fmt::format("write `case {} …`", phrase.wholeText(0, condition.tokens)))
      .fix({phrase.source().file, word.begin, word.begin}, "case ");
  if (condition.arrow > 0) {
    dropThenAndEnd(phrase, condition, builder);
  }
  phrase.put({GliderLexer::CASE, word.begin, word.begin});
  phrase.put(word);
  return 1;
}

}  // namespace

size_t caseWord(Phrase& phrase) {
  const uint32_t type = phrase.type();
  if (!phrase.mayBeginCase() || oneOf(type, {GliderLexer::CASE, GliderLexer::END})) {
    return 0;
  }
  if (!phrase.startsLine() && !oneOf(phrase.before(), {GliderLexer::EVENTS, GliderLexer::ALWAYS})) {
    return 0;
  }
  if (const size_t tokens = tokensOfIf(phrase)) {
    return ifAsCase(phrase, tokens);
  }
  return firstOf(phrase, {elseAsCase, otherConditionWord, clockAsCase, conditionAlone});
}

size_t ifInCase(Phrase& phrase) {
  if (phrase.before() != GliderLexer::CASE) {
    return 0;
  }
  const size_t tokens = tokensOfIf(phrase);
  const Condition condition = tokens == 0 ? Condition{} : conditionFrom(phrase, tokens);
  if (condition.tokens == 0 || !readsAsValue(phrase, tokens, condition.tokens)) {
    return 0;
  }
  const Lexeme word = phrase.whole(0, tokens);
  auto builder = phrase.reporter().at(word, support::diagnostics::superfluousWord,
                                      phrase.source().text(word), "after `case`");
  builder.hint(fmt::format("write `case {} …`", phrase.wholeText(tokens, condition.tokens)))
      .fix({phrase.source().file, word.begin, phrase.token(tokens).begin}, "");
  dropThenAndEnd(phrase, condition, builder);
  return tokens;
}

namespace {

/// Whether the case that begins here stays in its state: `resumetime` is then true from the first
/// time on.
bool caseStays(const Phrase& phrase) {
  constexpr size_t kLongest = 200;
  size_t k = 0;
  while (k < kLongest && !isTransition(phrase.type(k)) &&
         !oneOf(phrase.type(k), {GliderLexer::CASE, GliderLexer::STATE, kEof})) {
    ++k;
  }
  return phrase.type(k) == GliderLexer::STAY;
}

/// What is true once in each `duration`.
std::string insteadOfEvery(const Phrase& phrase, std::string_view duration) {
  return caseStays(phrase)
             ? fmt::format(
                   "keep the time of the last one: `var last: time = 0 s`, then `missiontime >= "
                   "last + {}`, with `set last = missiontime` in its `do`",
                   duration)
             : fmt::format("write `resumetime > {}`", duration);
}

}  // namespace

size_t conditionWord(Phrase& phrase) {
  if (phrase.before() != GliderLexer::CASE) {
    return 0;
  }
  const Lexeme word = phrase.token();
  const auto unexpected = [&] {
    return phrase.reporter().at(word, support::diagnostics::unexpectedToken, "a condition",
                                describe(phrase.source(), word));
  };
  if (word.type == GliderLexer::ALWAYS && isTransition(phrase.type(1))) {
    unexpected().hint("write `true`").fix(phrase.source().range(word), "true");
    phrase.put({GliderLexer::TRUE, word.begin, word.end});
    return 1;
  }
  const bool clock = oneOf(word.type, {GliderLexer::AFTER, GliderLexer::EVERY});
  const size_t yos = clock ? tokensOfYos(phrase, 1) : 0;
  size_t time = yos != 0 ? yos : clock ? tokensOfNumber(phrase, 1) : 0;
  if (time == 0) {
    return 0;
  }
  std::string duration(phrase.wholeText(1, time));
  const std::string_view unit = unitForWord(phrase.source().text(phrase.token(1 + time)));
  if (yos == 0 && time == 1 && !unit.empty()) {  // `3 hours`
    duration += fmt::format(" {}", unit);
    ++time;
  }
  unexpected().hint(
      yos != 0 ? fmt::format("write `{}`", countOfYos(phrase, 1))
      : word.type == GliderLexer::EVERY
          ? insteadOfEvery(phrase, duration)
          : fmt::format(
                "write `missiontime > {0}`, or `statetime > {0}` for the time in this state",
                duration));
  phrase.put(phrase.whole(0, 1 + time, GliderLexer::TRUE));
  return 1 + time;
}

}  // namespace glider::frontend::phrases
