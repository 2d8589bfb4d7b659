// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace glider::frontend::phrases {
namespace {

/// Whether a condition begins at the current token.
bool beginsCondition(const Phrase& phrase) {
  return oneOf(phrase.before(), {GliderLexer::CASE, GliderLexer::IF, GliderLexer::LPAREN,
                                 GliderLexer::AND, GliderLexer::OR, GliderLexer::AND_WORD,
                                 GliderLexer::OR_WORD, GliderLexer::ALWAYS, GliderLexer::NEVER});
}

/// The tokens of `is known` from token 1 on; 0: it is something else.
size_t tokensOfKnown(const Phrase& phrase, bool& known) {
  if (!phrase.says(1, "is")) {
    return 0;
  }
  const size_t negated = phrase.says(2, "not") ? 1 : 0;
  known = phrase.says(2 + negated, "known");
  const bool unknown = phrase.says(2 + negated, "unknown");
  const bool found = known || unknown;
  known = known != (negated == 1);
  return found ? 2 + negated : 0;
}

}  // namespace

size_t knownWords(Phrase& phrase) {
  const bool value = isName(phrase.type()) || phrase.type() == GliderLexer::HEARD;
  bool known = false;
  const size_t words = value && beginsCondition(phrase) ? tokensOfKnown(phrase, known) : 0;
  if (words == 0) {
    return 0;
  }
  const Lexeme name = phrase.token();
  const Lexeme& last = phrase.token(words);
  const std::string better = fmt::format("{}known({})", known ? "" : "!", phrase.text());
  phrase.reporter()
      .at(phrase.whole(1, words), support::diagnostics::wordOperator, phrase.wholeText(1, words),
          better)
      .fix(phrase.source().range(phrase.whole(0, 1 + words)), better);
  if (!known) {
    phrase.put({GliderLexer::NOT, name.begin, name.begin});
  }
  constexpr uint32_t kKnown = 5;  // letters
  phrase.put({GliderLexer::KNOWN, last.end - kKnown, last.end});
  phrase.put({GliderLexer::LPAREN, last.end, last.end});
  phrase.put(name);
  phrase.put({GliderLexer::RPAREN, last.end, last.end});
  return 1 + words;
}

size_t stateAsCondition(Phrase& phrase) {
  const bool compares =
      oneOf(phrase.type(1), {GliderLexer::EQ, GliderLexer::NE, GliderLexer::ASSIGN}) ||
      phrase.says(1, "is");
  if (!compares || !beginsCondition(phrase) || !isAnyName(phrase.type(2))) {
    return 0;
  }
  constexpr size_t kTokens = 3;
  const Lexeme whole = phrase.whole(0, kTokens, GliderLexer::TRUE);
  phrase.reporter()
      .at(phrase.token(), support::diagnostics::unexpectedToken, "a condition",
          describe(phrase.source(), phrase.token()))
      .hint(fmt::format("delete `{}`: a case counts only in the state that it is written in",
                        phrase.source().text(whole)));
  phrase.put(whole);
  return kTokens;
}

namespace {

bool isTypeWord(std::string_view word) {
  constexpr std::string_view kTypes[] = {
      "bool", "latitude", "longitude", "position", "path",
#define DIMENSION(name, m, kg, s, a, k, rad, unit) #name,
#include "support/units/dimensions.def"
#undef DIMENSION
  };
  return std::ranges::find(kTypes, word) != std::end(kTypes);
}

/// Whether the parentheses that are open are those of a definition, whose names have types.
bool areFormals(const Phrase& phrase) {
  size_t k = 0;
  for (size_t deep = 1; deep > 0 && phrase.type(k) != kEof; ++k) {
    deep += phrase.type(k) == GliderLexer::LPAREN ? 1U : 0U;
    deep -= phrase.type(k) == GliderLexer::RPAREN ? 1U : 0U;
  }
  if (oneOf(phrase.type(k), {GliderLexer::BEGIN, GliderLexer::COLON, GliderLexer::READS})) {
    return true;
  }
  size_t back = 0;
  while (phrase.before(back) != 0 && !isHardKeyword(phrase.before(back))) {
    ++back;
  }
  return phrase.before(back) == GliderLexer::EXTERN ||
         phrase.before(back + 1) == GliderLexer::EXTERN ||
         phrase.before(back) == GliderLexer::STATE;
}

/// Whether a colon of the arguments that are open was read, and so reported.
bool readColon(const Phrase& phrase) {
  size_t deep = 0;
  for (size_t k = 0; phrase.before(k) != 0; ++k) {
    deep += phrase.before(k) == GliderLexer::RPAREN ? 1U : 0U;
    if (phrase.before(k) == GliderLexer::LPAREN && deep-- == 0) {
      return false;
    }
    if (deep == 0 && phrase.before(k) == GliderLexer::ASSIGN &&
        phrase.source().text(*phrase.lexemeBefore(k)) == ":") {
      return true;
    }
  }
  return false;
}

/// Writes `=` for every colon of the arguments that are open.
void fixColons(Phrase& phrase, support::DiagnosticBuilder& report) {
  size_t deep = 1;
  for (size_t k = 0; deep > 0 && phrase.type(k) != kEof; ++k) {
    deep += phrase.type(k) == GliderLexer::LPAREN ? 1U : 0U;
    deep -= phrase.type(k) == GliderLexer::RPAREN ? 1U : 0U;
    if (deep == 1 && phrase.type(k) == GliderLexer::COLON) {
      report.fix(phrase.source().range(phrase.token(k)), phrase.touches(k) ? " =" : "=");
    }
  }
}

}  // namespace

size_t colonOfArgument(Phrase& phrase) {
  const bool argument = !phrase.open().empty() && phrase.open().back().arguments &&
                        isAnyName(phrase.before()) &&
                        oneOf(phrase.before(1), {GliderLexer::LPAREN, GliderLexer::COMMA});
  const bool again = argument && readColon(phrase);
  if (!argument || phrase.type(1) == GliderLexer::ASSIGN ||
      (!again && isAnyName(phrase.type(1)) && (isTypeWord(phrase.text(1)) || areFormals(phrase)))) {
    return 0;
  }
  const Lexeme colon = phrase.token();
  if (!again) {
    const std::string_view name = phrase.source().text(*phrase.lexemeBefore());
    auto report = phrase.reporter().at(colon, support::diagnostics::unexpectedToken, "`=`",
                                       describe(phrase.source(), colon));
    report.hint(fmt::format("write `{} = …`", name));
    fixColons(phrase, report);
  }
  phrase.put({GliderLexer::ASSIGN, colon.begin, colon.end});
  return 1;
}

namespace {

/// `log("deep", depth`, without the `)`.
size_t takeOpenParenthesis(Phrase& phrase) {
  const bool blank = phrase.touches(0);
  phrase.reporter()
      .at(phrase.token(), support::diagnostics::unexpectedToken, "a text in quotes",
          describe(phrase.source(), phrase.token()))
      .hint("write it without the parenthesis")
      .fix(phrase.source().range(phrase.token()), blank ? " " : "");
  return 1;
}

}  // namespace

size_t textInParentheses(Phrase& phrase) {
  if (phrase.before() != GliderLexer::LOG || phrase.type(1) != GliderLexer::STRING) {
    return 0;
  }
  const size_t line = phrase.tokensOfLine();
  size_t deep = 1;
  size_t k = 1;
  for (; k < line && deep > 0; ++k) {
    deep += phrase.type(k) == GliderLexer::LPAREN ? 1U : 0U;
    deep -= phrase.type(k) == GliderLexer::RPAREN ? 1U : 0U;
  }
  const Lexeme open = phrase.token();
  if (deep > 0) {
    return deep == 1 ? takeOpenParenthesis(phrase) : 0;
  }
  const Lexeme close = phrase.token(k - 1);
  const bool blank = open.begin == phrase.lexemeBefore()->end;
  phrase.reporter()
      .at(open, support::diagnostics::unexpectedToken, "a text in quotes",
          describe(phrase.source(), open))
      .hint("write it without the parentheses")
      .fix(phrase.source().range(open), blank ? " " : "")
      .fix(phrase.source().range(close), "");
  phrase.leaveOut(k - 1);
  return 1;
}

size_t atTheSurface(Phrase& phrase) {
  const size_t article = phrase.says(1, "the") ? 1 : 0;
  if (!beginsCondition(phrase) || !phrase.says(1 + article, "surface") ||
      phrase.startsLine(1 + article)) {
    return 0;
  }
  const Lexeme written = phrase.whole(0, 2 + article, GliderLexer::TRUE);
  phrase.reporter()
      .at(written, support::diagnostics::unexpectedToken, "a condition",
          fmt::format("`{}`", phrase.source().text(written)))
      .hint("write `at_surface`")
      .fix(phrase.source().range(written), "at_surface");
  phrase.put(written);
  phrase.notAsMeant();
  return 2 + article;
}

size_t secondText(Phrase& phrase) {
  const bool text = phrase.type(1) == GliderLexer::STRING && phrase.text(1).size() > 2;
  if (phrase.keyword() != GliderLexer::LOG || !text || !phrase.open().empty() ||
      phrase.before() == GliderLexer::LOG ||
      (phrase.text(1)[1] >= '0' && phrase.text(1)[1] <= '9')) {
    return 0;
  }
  const Lexeme second = phrase.token(1);
  phrase.reporter()
      .at(second, support::diagnostics::unexpectedToken, "a value",
          describe(phrase.source(), second))
      .hint(fmt::format("a line of the log has one text, which is first: begin another line with "
                        "`log {}`",
                        phrase.text(1)));
  return 2;
}

}  // namespace glider::frontend::phrases
