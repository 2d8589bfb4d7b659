// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace glider::frontend::phrases {
namespace {

/// `entry: log …`: the colon is read as the `do` that was meant.
size_t colonForDo(Phrase& phrase) {
  if (phrase.type() != GliderLexer::COLON ||
      !oneOf(phrase.type(1), {GliderLexer::SET, GliderLexer::LOG, GliderLexer::IF})) {
    return 0;
  }
  const Lexeme colon = phrase.token();
  phrase.reporter()
      .at(colon, support::diagnostics::unexpectedToken, "`do`", describe(phrase.source(), colon))
      .hint(fmt::format("write `entry do {} … end`", phrase.text(1)))
      .fix(phrase.source().range(colon), phrase.touches(0) ? " do" : "do");
  phrase.put({GliderLexer::DO, colon.begin, colon.end});
  return 1;
}

bool waits(const Phrase& phrase) {
  constexpr std::array<std::string_view, 4> kWords = {"wait", "sleep", "delay", "pause"};
  return std::ranges::any_of(kWords, [&](auto word) { return phrase.says(0, word); });
}

/// Whether a statement begins at the current token, as pilots write one.
bool beginsEntryStatement(const Phrase& phrase) {
  const uint32_t type = phrase.type();
  return oneOf(type, {GliderLexer::SET, GliderLexer::LOG, GliderLexer::IF, GliderLexer::FOR}) ||
         (type == GliderLexer::NAME &&
          oneOf(phrase.type(1), {GliderLexer::LPAREN, GliderLexer::NUMBER, GliderLexer::STRING,
                                 GliderLexer::ASSIGN}));
}

/// The statements from the current token on.
struct Actions {
  size_t tokens = 0;
  bool closed = false;   ///< an `end` of their own follows
  bool certain = false;  ///< it is known where they end
};

Actions actionsFrom(const Phrase& phrase) {
  constexpr size_t kFarthest = 300;
  size_t deep = 0;
  for (size_t k = 0; k < kFarthest; ++k) {
    const uint32_t type = phrase.type(k);
    if (type == GliderLexer::END && deep == 0) {
      const uint32_t next = phrase.type(k + 1);
      const bool inside = startsMember(next) || oneOf(next, {GliderLexer::END, GliderLexer::VAR});
      return {k, inside, inside};
    }
    if (startsMember(type) || startsItem(type) || oneOf(type, {kEof, GliderLexer::CASE})) {
      return {k, false, deep == 0 && startsMember(type)};
    }
    deep += oneOf(type, {GliderLexer::IF, GliderLexer::DO}) ? 1U : 0U;
    deep -= type == GliderLexer::END ? 1U : 0U;
  }
  return {};
}

}  // namespace

size_t entryWithoutDo(Phrase& phrase) {
  if (phrase.before() != GliderLexer::ENTRY) {
    return 0;
  }
  if (const size_t taken = colonForDo(phrase)) {
    return taken;
  }
  if (!beginsEntryStatement(phrase)) {
    return 0;
  }
  const Actions actions = actionsFrom(phrase);
  if (actions.tokens == 0) {
    return 0;
  }
  // A wait alone is not a statement either, and goes with its `entry`: one error is enough.
  constexpr size_t kLongestWait = 5;
  if (!(waits(phrase) && actions.tokens <= kLongestWait)) {
    const Lexeme first = phrase.token();
    const uint32_t end = phrase.token(actions.tokens - 1).end;
    const uint32_t file = phrase.source().file;
    auto report = phrase.reporter().at(first, support::diagnostics::actionWithoutDo, phrase.text(),
                                       phrase.wholeText(0, actions.tokens));
    report.hint(fmt::format("write `entry do {} … end`", phrase.text()));
    if (actions.certain) {
      report.fix({file, first.begin, first.begin}, "do ");
      if (!actions.closed) {
        report.fix({file, end, end}, " end");
      }
    }
  }
  if (!actions.closed) {
    phrase.supplyBefore(actions.tokens, GliderLexer::END);
  }
  phrase.insert(GliderLexer::DO);
  return 0;  // the statement itself is read next, and may have errors of its own
}

size_t beginOfAlways(Phrase& phrase) {
  constexpr size_t kFarthest = 300;
  if (phrase.before() != GliderLexer::ALWAYS || phrase.before(1) == GliderLexer::REQUIRE) {
    return 0;
  }
  const Lexeme found = phrase.token();
  auto report = phrase.reporter().at(found, support::diagnostics::superfluousWord, phrase.text(),
                                     "after `always`");
  report.hint("delete it and its `end`");
  size_t deep = 1;
  for (size_t k = 1; k < kFarthest && !startsItem(phrase.type(k)); ++k) {
    deep += oneOf(phrase.type(k), {GliderLexer::DO, GliderLexer::IF}) ? 1U : 0U;
    deep -= phrase.type(k) == GliderLexer::END ? 1U : 0U;
    if (deep == 0) {
      report.fix(phrase.source().range(found), "").fix(phrase.source().range(phrase.token(k)), "");
      phrase.leaveOut(k);
      break;
    }
  }
  return 1;
}

}  // namespace glider::frontend::phrases
