// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Loops as other languages write them.

#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <charconv>
#include <string>

namespace glider::frontend::phrases {
namespace {

/// Whether a statement may begin here, as far as the token before says.
bool beginsStatement(const Phrase& phrase) {
  return phrase.open().empty() && (endsValue(phrase.before()) ||
                                   oneOf(phrase.before(), {GliderLexer::DO, GliderLexer::THEN,
                                                           GliderLexer::ELSE, GliderLexer::END}));
}

/// `for i in 0 .. 7 set …`: the first `tokens` are right.
size_t withoutDo(Phrase& phrase, size_t tokens) {
  if (!oneOf(phrase.type(tokens), {GliderLexer::SET, GliderLexer::LOG, GliderLexer::IF})) {
    return 0;
  }
  const Lexeme next = phrase.token(tokens);
  phrase.reporter()
      .at(next, support::diagnostics::unexpectedToken, "`do`", describe(phrase.source(), next))
      .hint("write `do` after the range of the loop")
      .fix({phrase.source().file, next.begin, next.begin}, "do ");
  for (size_t k = 0; k < tokens; ++k) {
    phrase.put(phrase.token(k));
  }
  phrase.insert(GliderLexer::DO);
  return tokens;
}

/// `for i = 1 to 8`, `for i in 1 to 8`, `for i = 1:8`.
size_t counting(Phrase& phrase) {
  const bool named = phrase.type() == GliderLexer::FOR && isAnyName(phrase.type(1)) &&
                     oneOf(phrase.type(2), {GliderLexer::ASSIGN, GliderLexer::IN});
  const size_t first = named ? tokensOfNumber(phrase, 3) : 0;
  const size_t separator = 3 + first;
  const size_t last = first > 0 && oneOf(phrase.type(separator),
                                         {GliderLexer::TO, GliderLexer::COLON, GliderLexer::RANGE})
                          ? tokensOfNumber(phrase, separator + 1)
                          : 0;
  const size_t tokens = separator + 1 + last;
  if (last == 0 || isOperator(phrase.type(tokens))) {
    return 0;
  }
  if (phrase.type(2) == GliderLexer::IN && phrase.type(separator) == GliderLexer::RANGE) {
    return withoutDo(phrase, tokens);
  }
  const Lexeme whole = phrase.whole(0, tokens);
  const std::string better =
      fmt::format("for {} in {} .. {}", phrase.text(1), phrase.wholeText(3, first),
                  phrase.wholeText(separator + 1, last));
  phrase.reporter()
      .at(whole, support::diagnostics::notAStatement, phrase.source().text(whole))
      .hint(fmt::format("write `{} do … end`", better))
      .fix(phrase.source().range(whole), better);
  for (size_t k = 0; k < tokens; ++k) {
    const Lexeme& token = phrase.token(k);
    const uint32_t type = k == 2           ? uint32_t{GliderLexer::IN}
                          : k == separator ? uint32_t{GliderLexer::RANGE}
                                           : token.type;
    phrase.put({type, token.begin, token.end});
  }
  return tokens;
}

/// "7" for "8".
std::string oneLess(std::string_view number) {
  uint32_t value = 0;
  const char* const last = number.data() + number.size();
  const auto [end, error] = std::from_chars(number.data(), last, value);
  const bool whole = error == std::errc() && end == last && value > 0;
  return whole ? std::to_string(value - 1) : fmt::format("{} - 1", number);
}

/// `for i in recent do`, `for i in 8 do`: read as a range of that value alone.
size_t withoutRange(Phrase& phrase) {
  const bool header = phrase.type() == GliderLexer::FOR && isAnyName(phrase.type(1)) &&
                      phrase.type(2) == GliderLexer::IN && phrase.type(4) == GliderLexer::DO;
  const bool number = phrase.type(3) == GliderLexer::NUMBER;
  if (!header || !(number || isName(phrase.type(3)))) {
    return 0;
  }
  const Lexeme whole = phrase.whole(0, 4);
  const std::string last =
      number ? oneLess(phrase.text(3)) : fmt::format("count({}) - 1", phrase.text(3));
  phrase.reporter()
      .at(whole, support::diagnostics::notAStatement, phrase.source().text(whole))
      .hint(fmt::format("write `for {} in 0 .. {} do … end`", phrase.text(1), last));
  for (size_t k = 0; k < 4; ++k) {
    phrase.put(phrase.token(k));
  }
  phrase.insert(GliderLexer::RANGE);
  phrase.put(phrase.token(3));
  phrase.notAsMeant();
  return 4;
}

/// `set recent(0) = temp`
size_t elementInParentheses(Phrase& phrase) {
  const bool element = phrase.type() == GliderLexer::SET && isName(phrase.type(1)) &&
                       phrase.type(2) == GliderLexer::LPAREN && phrase.touches(2) &&
                       phrase.type(4) == GliderLexer::RPAREN &&
                       phrase.type(5) == GliderLexer::ASSIGN;
  if (!element) {
    return 0;
  }
  const Lexeme& open = phrase.token(2);
  const Lexeme& close = phrase.token(4);
  const std::string better = fmt::format("{}[{}]", phrase.text(1), phrase.text(3));
  phrase.reporter()
      .at(open, support::diagnostics::unexpectedToken, "`[`", describe(phrase.source(), open))
      .hint(fmt::format("write `{}`", better))
      .fix(phrase.source().range(phrase.whole(1, 4)), better);
  phrase.put(phrase.token());
  phrase.put(phrase.token(1));
  phrase.put({GliderLexer::LBRACKET, open.begin, open.end});
  phrase.put(phrase.token(3));
  phrase.put({GliderLexer::RBRACKET, close.begin, close.end});
  return 5;
}

/// `while depth < 5 m do`: read as an `if`, to keep the blocks in order.
size_t repeating(Phrase& phrase) {
  const bool word = phrase.type() == GliderLexer::NAME && phrase.says(0, "while");
  const size_t line = word ? phrase.tokensOfLine() : 0;
  size_t end = 1;
  while (end < line && phrase.type(end) != GliderLexer::DO) {
    ++end;
  }
  if (!word || end < 2 || end == line) {
    return 0;
  }
  phrase.reporter()
      .at(phrase.token(), support::diagnostics::notAStatement, phrase.text())
      .hint(
          "a mission does not wait in a loop: its cases are tried on every tick. "
          "`for i in 0 .. 7 do … end` repeats a fixed number of times");
  phrase.put({GliderLexer::IF, phrase.token().begin, phrase.token().end});
  for (size_t k = 1; k < end; ++k) {
    phrase.put(phrase.token(k));
  }
  const Lexeme& last = phrase.token(end);
  phrase.put({GliderLexer::THEN, last.begin, last.end});
  return end + 1;
}

}  // namespace

size_t loop(Phrase& phrase) {
  if (!beginsStatement(phrase)) {
    return 0;
  }
  return firstOf(phrase, {counting, withoutRange, elementInParentheses, repeating});
}

}  // namespace glider::frontend::phrases
