// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Where a promise applies, and the promise that follows another on its line.

#include "frontend/parse/phrases/promises/parts.h"
#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string>

namespace glider::frontend::phrases {
namespace {

/// Whether a promise that may have a scope begins with it. `always` may not, but is written so.
bool beginsPattern(uint32_t type) {
  return oneOf(type,
               {GliderLexer::VISIT, GliderLexer::PATROL, GliderLexer::NEVER, GliderLexer::WHENEVER,
                GliderLexer::WHEN, GliderLexer::HOLD, GliderLexer::ALWAYS});
}

bool hasAmong(const Phrase& phrase, size_t count, std::initializer_list<uint32_t> types) {
  for (size_t k = 0; k < count; ++k) {
    if (std::ranges::find(types, phrase.type(k)) != types.end()) {
      return true;
    }
  }
  return false;
}

/// Whether `in home`, `after depth > 5 m`, `from a to b` is the scope of the first `count` tokens.
bool isScope(const Phrase& phrase, size_t count) {
  if (phrase.type() != GliderLexer::FROM) {
    return oneOf(phrase.type(), {GliderLexer::IN, GliderLexer::OUTSIDE, GliderLexer::BEFORE,
                                 GliderLexer::AFTER}) &&
           readsAsValue(phrase, 1, count - 1);
  }
  size_t to = 1;
  while (to < count && phrase.type(to) != GliderLexer::TO) {
    ++to;
  }
  return to + 1 < count && readsAsValue(phrase, 1, to - 1) &&
         readsAsValue(phrase, to + 1, count - to - 1);
}

/// Whether the first `count` tokens are a whole promise that may have a scope: they have the time
/// or the number that it needs.
bool isWholePattern(const Phrase& phrase, size_t count) {
  const bool timed = oneOf(phrase.type(), {GliderLexer::VISIT, GliderLexer::HOLD});
  return beginsPattern(phrase.type()) && !hasAmong(phrase, count, {GliderLexer::COLON}) &&
         (!timed || hasAmong(phrase, count, {GliderLexer::WITHIN, GliderLexer::TIMES_WORD}));
}

/// Whether a promise, and not a condition, begins with token `k`.
bool beginsPromise(const Phrase& phrase, size_t k) {
  const uint32_t next = phrase.type(k + 1);
  switch (phrase.type(k)) {
    case GliderLexer::EXIT:
    case GliderLexer::ALWAYS:
      return true;
    case GliderLexer::SURFACES:
      return next == GliderLexer::EVERY;
    case GliderLexer::STACK:
      return next == GliderLexer::LE;
    case GliderLexer::CAN:
      return next == GliderLexer::REACH;
    case GliderLexer::NEVER:
    case GliderLexer::VISIT:
    case GliderLexer::PATROL:
    case GliderLexer::WHENEVER:
      return isAnyName(next) && !phrase.startsLine(k + 1);
    default:
      return false;
  }
}

/// How many tokens ago the `require` of the promise at hand was read; empty: none is read.
std::optional<size_t> toRequire(const Phrase& phrase) {
  constexpr size_t kFarthest = 100;
  for (size_t k = 0; k < kFarthest; ++k) {
    const uint32_t type = phrase.before(k);
    if (type == GliderLexer::REQUIRE) {
      return k;
    }
    if (type == 0 || (isHardKeyword(type) && type != GliderLexer::ALWAYS && !isOperator(type) &&
                      !oneOf(type, {GliderLexer::TRUE, GliderLexer::FALSE, GliderLexer::EXIT,
                                    GliderLexer::EVERY, GliderLexer::THEN}))) {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

}  // namespace

size_t scopeWithoutColon(Phrase& phrase) {
  const size_t line = phrase.tokensOfLine();
  size_t count = 2;  // a scope has a word and a place at least
  while (count < line && !beginsPattern(phrase.type(count))) {
    ++count;
  }
  if (count >= line || !isScope(phrase, count)) {
    return 0;
  }
  const Lexeme found = phrase.token(count);
  const uint32_t end = phrase.token(count - 1).end;
  if (found.type != GliderLexer::ALWAYS) {  // else alwaysAfterScope says all at once
    expected(phrase, found, "`:`")
        .hint(
            fmt::format("write `require {}: {} …`", phrase.wholeText(0, count), phrase.text(count)))
        .fix({phrase.source().file, end, end}, ":");
  }
  for (size_t k = 0; k < count; ++k) {
    phrase.put(phrase.token(k));
  }
  phrase.insert(GliderLexer::COLON);
  return count;
}

size_t scopeAtEnd(Phrase& phrase) {
  constexpr size_t kScope = 2;  // `in home`
  const size_t line = phrase.tokensOfLine();
  const size_t count = line > kScope ? line - kScope : 0;
  if (count < 2 || !oneOf(phrase.type(count), {GliderLexer::IN, GliderLexer::OUTSIDE}) ||
      !isAnyName(phrase.type(count + 1)) || !isStateName(phrase.source(), phrase.text(count + 1)) ||
      !isWholePattern(phrase, count)) {
    return 0;
  }
  const Lexeme whole = phrase.whole(0, line);
  const bool always = phrase.type() == GliderLexer::ALWAYS;
  const std::string better = fmt::format(
      "{}: {}", phrase.wholeText(count, kScope),
      always ? neverInstead(phrase, 1, count - 1) : std::string(phrase.wholeText(0, count)));
  auto report =
      phrase.reporter().at(phrase.whole(count, kScope), support::diagnostics::superfluousWord,
                           phrase.wholeText(count, kScope), "after the requirement");
  report.hint(fmt::format("write `require {}`", better));
  if (!always) {  // where the condition is unknown, `never` is another requirement
    report.fix(phrase.source().range(whole), better);
  }
  phrase.put({GliderLexer::ALWAYS, whole.begin, whole.begin});
  phrase.put({GliderLexer::TRUE, whole.begin, whole.end});
  phrase.notAsMeant();
  return line;
}

size_t promiseAfterAnd(Phrase& phrase) {
  const auto begin = beginsPromise(phrase, 1) ? toRequire(phrase) : std::nullopt;
  if (!begin || !phrase.open().empty() || !endsValue(phrase.before())) {
    return 0;
  }
  const Lexeme word = phrase.token();
  const uint32_t end = phrase.lexemeBefore()->end;
  const std::string_view first =
      phrase.source().text(Lexeme{GliderLexer::REQUIRE, phrase.lexemeBefore(*begin)->begin, end});
  expected(phrase, word, "the end of the requirement")
      .hint(fmt::format("write two lines: `{}` and `require {}`", first,
                        phrase.wholeText(1, phrase.tokensOfLine() - 1)))
      .fix({phrase.source().file, end, phrase.token(1).begin}, "\nrequire ");
  phrase.put({GliderLexer::REQUIRE, word.begin, word.end});
  return 1;
}

}  // namespace glider::frontend::phrases
