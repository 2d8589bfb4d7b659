// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "frontend/spelling.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::frontend::phrases {
namespace {

/// The tokens of a sign that begins a comment in other languages; 0: there is none.
size_t tokensOfSign(const Phrase& phrase) {
  const uint32_t type = phrase.type();
  if (type == GliderLexer::MINUS && phrase.type(1) == GliderLexer::MINUS && phrase.touches(1)) {
    return 2;
  }
  const bool percent =
      type == GliderLexer::UNIT && phrase.text() == "%" && phrase.before() != GliderLexer::NUMBER;
  return percent || oneOf(type, {GliderLexer::SEMICOLON, GliderLexer::NOT}) ? 1 : 0;
}

/// Whether nothing has to follow what was read.
bool isComplete(const Phrase& phrase) {
  return phrase.before() == 0 || endsValue(phrase.before()) || phrase.mayBeginCase() ||
         oneOf(phrase.before(), {GliderLexer::END, GliderLexer::BEGIN});
}

/// Whether the rest of the line after `sign` tokens is words: no statement begins like that.
bool isProse(const Phrase& phrase, size_t sign, size_t line) {
  return line > sign && isName(phrase.type(sign)) &&
         (line == sign + 1 || isAnyName(phrase.type(sign + 1)));
}

/// Whether a keyword may be meant: one letter is wrong, or two of a
/// long one.
bool isNearKeyword(std::string_view word) {
  const auto near = [&](std::string_view keyword) {
    return keyword.size() > 3 && editDistance(word, keyword) <= (keyword.size() > 5 ? 2U : 1U);
  };
  return std::ranges::any_of(hardKeywords(), near) || near("assume") || near("place") ||
         near("resume") || near("declination");
}

/// Whether all of the line is words, three or more, and the first is not a misspelt keyword.
bool isWords(const Phrase& phrase, size_t line) {
  constexpr size_t kFewest = 3;
  if (line < kFewest || phrase.type() != GliderLexer::NAME || isNearKeyword(phrase.text())) {
    return false;
  }
  for (size_t k = 0; k < line; ++k) {
    if (!isAnyName(phrase.type(k))) {
      return false;
    }
  }
  return true;
}

/// A line of words where a declaration or a case may begin.
size_t bareProse(Phrase& phrase) {
  if (phrase.type() != GliderLexer::NAME || !phrase.startsLine() || !phrase.open().empty()) {
    return 0;
  }
  const bool declared =
      endsValue(phrase.before()) &&
      oneOf(phrase.keyword(), {GliderLexer::MISSION, GliderLexer::PLATFORM, GliderLexer::IMPORT,
                               GliderLexer::CONST, GliderLexer::PARAM, GliderLexer::VAR});
  const bool begins =
      oneOf(phrase.before(), {0, GliderLexer::END}) || declared || phrase.mayBeginCase();
  const size_t line = begins ? phrase.tokensOfLine() : 0;
  if (!isWords(phrase, line)) {
    return 0;
  }
  const Lexeme& first = phrase.token();
  phrase.reporter()
      .at(first, support::diagnostics::unexpectedToken,
          phrase.mayBeginCase() ? "`case` or `end`" : "`state` or another declaration",
          describe(phrase.source(), first))
      .hint("begin a comment with `#`")
      .fix({phrase.source().file, first.begin, first.begin}, "# ");
  return line;
}

}  // namespace

namespace {

/// Whether a line of a `.mi` begins at token `k`: `b_arg: …`.
bool beginsLineOfMi(const Phrase& phrase, size_t k) {
  const bool word =
      phrase.says(k, "b_arg") || phrase.says(k, "behavior") || phrase.says(k, "sensor");
  return phrase.startsLine(k) && word && phrase.type(k + 1) == GliderLexer::COLON &&
         !phrase.startsLine(k + 1);
}

}  // namespace

size_t lineOfMi(Phrase& phrase) {
  if (!beginsLineOfMi(phrase, 0)) {
    return 0;
  }
  const Lexeme found = phrase.whole(0, 2);
  phrase.reporter()
      .at(found, support::diagnostics::unexpectedToken, "a line of the mission language",
          fmt::format("`{}`", phrase.source().text(found)))
      .hint(
          "that is a line of a `.mi`: docs/from-mi.md has what it is in a mission, as "
          "`d_target_depth` is `bottom` of `yo(top = …, bottom = …)`");
  phrase.notAsMeant();  // nothing else is missing where the others are
  size_t tokens = phrase.tokensOfLine();
  while (beginsLineOfMi(phrase, tokens)) {
    do {
      ++tokens;
    } while (!phrase.startsLine(tokens) && phrase.type(tokens) != kEof);
  }
  return tokens;
}

size_t comment(Phrase& phrase) {
  const size_t sign = tokensOfSign(phrase);
  if (sign == 0) {
    return bareProse(phrase);
  }
  const bool only_comment = phrase.type() == GliderLexer::UNIT || sign == 2;
  const bool begins = phrase.startsLine() || phrase.mayBeginCase() ||
                      oneOf(phrase.before(), {GliderLexer::END, GliderLexer::BEGIN});
  const size_t line = phrase.tokensOfLine();
  // `; counter` after a declaration.
  const bool word = phrase.type() == GliderLexer::SEMICOLON && line == 2 && !begins &&
                    phrase.type(1) == GliderLexer::NAME && !phrase.isDeclared(phrase.text(1)) &&
                    keywordType(phrase.lower(1)) == 0;
  const bool prose = isProse(phrase, sign, line);
  const bool list = phrase.keyword() == GliderLexer::SENSORS && !phrase.startsLine();
  const bool placed = begins || (prose && sign == 1);
  if (!phrase.open().empty() || !isComplete(phrase) || list || !placed ||
      (!prose && !only_comment) || (!begins && !only_comment && !word)) {
    return 0;
  }
  // A sign before a keyword may have been meant otherwise, or to disable the line.
  const bool certain = line == sign || !isHardKeyword(phrase.type(sign));
  auto report = phrase.reporter().at(phrase.whole(0, sign), support::diagnostics::foreignComment,
                                     phrase.wholeText(0, sign));
  if (certain) {
    report.fix(phrase.source().range(phrase.whole(0, sign)), "#");
  }
  const bool whole = only_comment && phrase.startsLine();  // `% end after 5 hours`: no code
  return certain || whole ? line : sign;
}

}  // namespace glider::frontend::phrases
