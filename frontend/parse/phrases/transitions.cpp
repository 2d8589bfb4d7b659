// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

namespace glider::frontend::phrases {
namespace {

bool leads(uint32_t type) {
  return oneOf(type, {GliderLexer::GOTO, GliderLexer::CALL});
}

/// Whether a condition was read and nothing after it.
bool afterCondition(const Phrase& phrase) {
  return phrase.keyword() == GliderLexer::CASE && phrase.open().empty() &&
         (endsValue(phrase.before()));
}

/// `call state up`.
size_t stateBeforeTarget(Phrase& phrase) {
  if (phrase.type() != GliderLexer::STATE || !leads(phrase.before()) || phrase.startsLine() ||
      !isAnyName(phrase.type(1))) {
    return 0;
  }
  phrase.reporter()
      .at(phrase.token(), support::diagnostics::superfluousWord, phrase.text(),
          fmt::format("after `{}`", phrase.source().text(*phrase.lexemeBefore())))
      .fix(phrase.source().range(phrase.token()), "");
  return 1;
}

/// `goto exit`, `goto end`, `call return`.
size_t transitionAsTarget(Phrase& phrase) {
  const bool leads = oneOf(phrase.type(), {GliderLexer::GOTO, GliderLexer::CALL});
  const bool transition =
      oneOf(phrase.type(1), {GliderLexer::EXIT, GliderLexer::RETURN, GliderLexer::STAY});
  const bool end = phrase.type(1) == GliderLexer::END && !phrase.startsLine(1);
  if (!leads || !(transition || end) || phrase.startsLine(1) || !afterCondition(phrase)) {
    return 0;
  }
  const Lexeme both = phrase.whole(0, 2, end ? uint32_t{GliderLexer::EXIT} : phrase.type(1));
  const std::string better = end ? "exit" : std::string(phrase.text(1));
  auto report =
      phrase.reporter().at(both, support::diagnostics::wrongTransition, phrase.source().text(both));
  report.hint(fmt::format("write `{}`{}", better, end ? " to end the mission" : ""));
  if (!end) {
    report.fix(phrase.source().range(both), better);
  }
  phrase.put(both);
  return 2;
}

/// `goto (a)`.
size_t parenthesesAroundTarget(Phrase& phrase) {
  if (phrase.type() != GliderLexer::LPAREN || !leads(phrase.before()) ||
      !isAnyName(phrase.type(1)) || phrase.type(2) != GliderLexer::RPAREN) {
    return 0;
  }
  const Lexeme whole = phrase.whole(0, 3);
  const bool apart = phrase.lexemeBefore()->end < whole.begin;
  const std::string better =
      fmt::format("{} {}", phrase.source().text(*phrase.lexemeBefore()), phrase.text(1));
  phrase.reporter()
      .at(whole, support::diagnostics::superfluousWord, "(",
          fmt::format("after `{}`", phrase.source().text(*phrase.lexemeBefore())))
      .hint(fmt::format("write `{}`", better))
      .fix(phrase.source().range(whole), (apart ? "" : " ") + std::string(phrase.text(1)));
  phrase.put(phrase.token(1));
  return 3;
}

/// `exit()`.
size_t parenthesesAfterTransition(Phrase& phrase) {
  const bool alone =
      oneOf(phrase.before(), {GliderLexer::EXIT, GliderLexer::RETURN, GliderLexer::STAY});
  if (phrase.type() != GliderLexer::LPAREN || phrase.type(1) != GliderLexer::RPAREN || !alone ||
      phrase.keyword() != phrase.before()) {
    return 0;
  }
  const Lexeme both = phrase.whole(0, 2);
  phrase.reporter()
      .at(both, support::diagnostics::superfluousWord, phrase.source().text(both),
          fmt::format("after `{}`", phrase.source().text(*phrase.lexemeBefore())))
      .fix(phrase.source().range(both), "");
  return 2;
}

/// `go to up`.
size_t goTo(Phrase& phrase) {
  if (phrase.type() != GliderLexer::NAME || !phrase.says(0, "go") || !afterCondition(phrase) ||
      !phrase.says(1, "to") || !isStateName(phrase.source(), phrase.text(2))) {
    return 0;
  }
  const Lexeme both = phrase.whole(0, 2, GliderLexer::GOTO);
  phrase.reporter()
      .at(both, support::diagnostics::wrongTransition, phrase.source().text(both))
      .hint("write `goto`")
      .fix(phrase.source().range(both), "goto");
  phrase.put(both);
  return 2;
}

/// `jump up`: only the pilot knows whether the state is to return.
size_t jumpTo(Phrase& phrase) {
  const bool after_block = phrase.before() == GliderLexer::END && !phrase.startsLine();
  if (phrase.type() != GliderLexer::NAME || !(afterCondition(phrase) || after_block) ||
      phrase.before() == GliderLexer::NUMBER) {
    return 0;
  }
  const size_t name = phrase.says(1, "to") ? 2 : 1;
  if (phrase.startsLine(name) || !isAnyName(phrase.type(name)) ||
      !isStateName(phrase.source(), phrase.text(name))) {
    return 0;
  }
  const std::string_view state = phrase.text(name);
  const Lexeme word = phrase.whole(0, name, GliderLexer::GOTO);
  if (keywordType(phrase.lower()) != 0) {
    return 0;
  }
  phrase.reporter()
      .at(word, support::diagnostics::wrongTransition, phrase.source().text(word))
      .hint(fmt::format("write `goto {0}`, or `call {0}` to come back", state));
  phrase.put(word);
  return name;
}

/// The text of the transition that was just read.
std::string_view transitionBefore(const Phrase& phrase) {
  size_t k = 0;
  while (phrase.before(k) != 0 && !isTransition(phrase.before(k))) {
    ++k;
  }
  const Lexeme* keyword = phrase.lexemeBefore(k);
  const Lexeme* last = phrase.lexemeBefore();
  return keyword == nullptr
             ? std::string_view()
             : phrase.source().text().substr(keyword->begin, last->end - keyword->begin);
}

}  // namespace

size_t target(Phrase& phrase) {
  return firstOf(phrase, {stateBeforeTarget, transitionAsTarget, parenthesesAroundTarget,
                          parenthesesAfterTransition, goTo, jumpTo});
}

namespace {

/// Whether the transition before is in the `then` of an `if`, whose `else` this is:
/// StructureRepair reports the transition.
bool isElseOfIf(const Phrase& phrase) {
  constexpr size_t kFarthest = 100;
  for (size_t k = 0; k < kFarthest && phrase.before(k) != 0; ++k) {
    if (oneOf(phrase.before(k), {GliderLexer::CASE, GliderLexer::END, GliderLexer::EVENTS})) {
      return false;
    }
    if (phrase.before(k) == GliderLexer::IF) {
      return true;
    }
  }
  return false;
}

/// `call report else goto hold`, `stay 10 min`.
size_t moreAfterTransition(Phrase& phrase) {
  const size_t line = phrase.tokensOfLine();
  if (phrase.type() == GliderLexer::ELSE && line > 1) {
    if (isElseOfIf(phrase)) {
      return 0;
    }
    phrase.reporter()
        .at(phrase.token(), support::diagnostics::unexpectedToken, "`case` or `end`",
            describe(phrase.source(), phrase.token()))
        .hint("a case has no `else`: what is to happen otherwise is another case, below this one");
    return line;
  }
  const size_t time = phrase.type() == GliderLexer::NUMBER ? tokensOfNumber(phrase, 0) : 0;
  if (time < 2 || time != line) {
    return 0;
  }
  const bool stays = phrase.before() == GliderLexer::STAY;
  phrase.reporter()
      .at(phrase.whole(0, time), support::diagnostics::unexpectedToken, "`case` or `end`",
          describe(phrase.source(), phrase.token()))
      .hint(
          fmt::format("{} takes no time: how long a state lasts is the case that leaves it, as in "
                      "`case statetime > {} …`",
                      stays ? "`stay`" : "a transition", phrase.wholeText(0, time)));
  return line;
}

}  // namespace

size_t afterTransition(Phrase& phrase) {
  if (!phrase.mayBeginCase() || phrase.startsLine() || !isTransition(phrase.keyword())) {
    return 0;
  }
  if (const size_t taken = moreAfterTransition(phrase)) {
    return taken;
  }
  const size_t line = phrase.tokensOfLine();
  const bool second = isTransition(phrase.type());
  const size_t tokens = second && leads(phrase.type()) ? 2 : 1;
  const bool word = phrase.type() == GliderLexer::MISSION ||
                    (phrase.type() == GliderLexer::NAME && isTransition(phrase.before()));
  if (line != tokens || !(second || word)) {
    return 0;
  }
  const Lexeme extra = phrase.whole(0, tokens);
  auto report = phrase.reporter().at(extra, support::diagnostics::superfluousWord,
                                     phrase.source().text(extra),
                                     fmt::format("after `{}`", transitionBefore(phrase)));
  if (second) {
    report.hint("a case has one transition: delete one of the two");
  } else if (phrase.before() == GliderLexer::RETURN) {
    report.hint("delete it: `return` goes to the state that called this one");
  } else {
    report.fix(phrase.source().range(extra), "");
  }
  return tokens;
}

namespace {

/// `-> up`: only the pilot knows whether the state is to return.
size_t arrowAsTransition(Phrase& phrase, size_t tokens) {
  const Lexeme sign = phrase.whole(0, tokens, GliderLexer::GOTO);
  phrase.reporter()
      .at(sign, support::diagnostics::wrongTransition, phrase.source().text(sign))
      .hint(fmt::format("write `goto {0}`, or `call {0}` to come back", phrase.text(tokens)));
  phrase.put(sign);
  return tokens;
}

}  // namespace

size_t arrow(Phrase& phrase) {
  if (!afterCondition(phrase)) {
    return 0;
  }
  const size_t drawn = tokensOfArrow(phrase, 0);
  const size_t tokens = drawn == 0 && phrase.type() == GliderLexer::NOT ? 1 : drawn;
  const uint32_t next = phrase.type(tokens);
  if (drawn > 0 && isAnyName(next) && isStateName(phrase.source(), phrase.text(tokens))) {
    return arrowAsTransition(phrase, drawn);
  }
  if (tokens == 0 || !(isTransition(next) || next == GliderLexer::DO)) {
    return 0;
  }
  const Lexeme sign = phrase.whole(0, tokens);
  phrase.reporter()
      .at(sign, support::diagnostics::superfluousWord, phrase.source().text(sign),
          "after the condition of a case")
      .fix(phrase.source().range(sign), "");
  return tokens;
}

namespace {

/// The tokens of the block `do … end` that begins at the current token; 0: it has no `end`.
size_t tokensOfBlock(const Phrase& phrase) {
  constexpr size_t kFarthest = 200;
  size_t deep = 0;
  for (size_t k = 0; k < kFarthest; ++k) {
    const uint32_t type = phrase.type(k);
    if (oneOf(type, {kEof, GliderLexer::CASE, GliderLexer::EVENTS}) || startsItem(type)) {
      return 0;
    }
    deep += oneOf(type, {GliderLexer::DO, GliderLexer::IF}) ? 1U : 0U;
    deep -= type == GliderLexer::END ? 1U : 0U;
    if (deep == 0) {
      return k + 1;
    }
  }
  return 0;
}

}  // namespace

size_t blockAfterTransition(Phrase& phrase) {
  const bool after =
      phrase.mayBeginCase() && isTransition(phrase.keyword()) && !phrase.startsLine();
  const size_t tokens = after ? tokensOfBlock(phrase) : 0;
  // Something that is still inside the state follows, or the block closes nothing of its own.
  if (tokens == 0 || !oneOf(phrase.type(tokens), {GliderLexer::CASE, GliderLexer::END})) {
    return 0;
  }
  const std::string_view transition = transitionBefore(phrase);
  const Lexeme block = phrase.whole(0, tokens);
  const uint32_t end = phrase.lexemeBefore()->end;
  const auto begin = static_cast<uint32_t>(end - transition.size());
  const uint32_t file = phrase.source().file;
  phrase.reporter()
      .at(phrase.token(), support::diagnostics::unexpectedToken, "`case` or `end`",
          describe(phrase.source(), phrase.token()))
      .hint(fmt::format("the block comes before the transition: write `do … end {}`", transition))
      .fix({file, begin, begin}, fmt::format("{} ", phrase.source().text(block)))
      .fix({file, end, block.end}, "");
  phrase.notAsMeant();
  return tokens;
}

size_t endForTransition(Phrase& phrase) {
  const size_t tokens =
      phrase.type(1) == GliderLexer::MISSION && !phrase.startsLine(1) ? 2 : 1;  // `end mission`
  const bool ends =
      !phrase.startsLine() && oneOf(phrase.type(tokens), {GliderLexer::CASE, GliderLexer::END});
  if (!ends || !afterCondition(phrase) || phrase.before() == GliderLexer::CASE) {
    return 0;
  }
  const Lexeme found = phrase.whole(0, tokens);
  if (tokens == 2) {
    phrase.reporter()
        .at(found, support::diagnostics::wrongTransition, phrase.source().text(found))
        .hint("write `exit`")
        .fix(phrase.source().range(found), "exit");
    phrase.put({GliderLexer::EXIT, found.begin, found.end});
    return tokens;
  }
  phrase.reporter()
      .at(found, support::diagnostics::wrongTransition, phrase.text())
      .hint("write `exit` to end the mission, or `goto`, `call`, `return` or `stay`");
  phrase.put({GliderLexer::EXIT, found.begin, found.end});
  return 1;
}

}  // namespace glider::frontend::phrases
