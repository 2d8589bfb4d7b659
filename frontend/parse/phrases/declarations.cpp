// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/phrases/written_type.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <array>

namespace glider::frontend::phrases {
namespace {

/// The tokens of the size `[8]` of an array, from token `first` on; 0: there is none.
size_t tokensOfSize(const Phrase& phrase, size_t first) {
  constexpr size_t kLongest = 8;
  if (phrase.type(first) != GliderLexer::LBRACKET) {
    return 0;
  }
  for (size_t k = first + 1; k < first + kLongest; ++k) {
    if (phrase.type(k) == GliderLexer::RBRACKET) {
      return k + 1 - first;
    }
  }
  return 0;
}

/// `var n = 0`: analysis would ask for the type with every use.
size_t withoutType(Phrase& phrase) {
  const bool untyped =
      oneOf(phrase.type(), {GliderLexer::VAR, GliderLexer::PARAM}) && isAnyName(phrase.type(1));
  const size_t end = 2 + (untyped ? tokensOfSize(phrase, 2) : 0);
  const bool both =
      phrase.type(end) == GliderLexer::COLON && phrase.type(end + 1) == GliderLexer::ASSIGN;
  if (!untyped || !(both || oneOf(phrase.type(end), {GliderLexer::ASSIGN, GliderLexer::EQ}))) {
    return 0;
  }
  const size_t sign = both ? end + 1 : end;
  const size_t list = phrase.type(sign + 1) == GliderLexer::LBRACKET && end > 2 ? 1 : 0;
  const std::string_view type = typeOf(phrase, sign + 1 + list);
  const Lexeme name = phrase.whole(1, end - 1);
  const std::string_view written = phrase.wholeText(1, end - 1);
  auto report = phrase.reporter().at(name, support::diagnostics::withoutType, written);
  report.hint(fmt::format("write `{} {}: {} = …`", phrase.text(), written,
                          type.empty() ? std::string_view("TYPE") : type));
  if (!type.empty()) {
    report.fix({phrase.source().file, name.end, phrase.token(sign).end},
               fmt::format(": {} =", type));
  }
  for (size_t k = 0; k < end; ++k) {
    phrase.put(phrase.token(k));
  }
  phrase.put({GliderLexer::COLON, name.end, name.end});
  phrase.put(phrase.token(1));  // in place of the type
  const Lexeme& assign = phrase.token(sign);
  phrase.put({GliderLexer::ASSIGN, assign.begin, assign.end});
  phrase.notAsMeant();
  return sign + 1;
}

/// The words of `my long name` from token 1 up to token `end`, as one name.
std::string oneName(const Phrase& phrase, size_t end) {
  std::string name(phrase.text(1));
  for (size_t k = 2; k < end; ++k) {
    name += fmt::format("_{}", phrase.text(k));
  }
  return name;
}

/// `var my course = 60 deg`: the name of a variable is one word.
size_t nameOfSeveralWords(Phrase& phrase, size_t end, size_t sign) {
  const std::string_view type = typeOf(phrase, sign + 1);
  const Lexeme name = phrase.whole(1, end - 1, GliderLexer::NAME);
  phrase.reporter().at(name, support::diagnostics::nameNotOneWord, phrase.source().text(name),
                       fmt::format("write `{} {}: {} = …`", phrase.text(), oneName(phrase, end),
                                   type.empty() ? std::string_view("TYPE") : type));
  phrase.put(phrase.token());
  phrase.put(phrase.token(1));
  phrase.put({GliderLexer::COLON, name.end, name.end});
  phrase.put(phrase.token(1));  // in place of the type
  const Lexeme& assign = phrase.token(sign);
  phrase.put({GliderLexer::ASSIGN, assign.begin, assign.end});
  phrase.notAsMeant();
  return sign + 1;
}

/// `var course angle = 60 deg`: otherwise `angle =` is read as a second declaration.
size_t withoutColon(Phrase& phrase) {
  constexpr size_t kMostWords = 6;
  const bool declares =
      oneOf(phrase.type(), {GliderLexer::VAR, GliderLexer::PARAM}) && isAnyName(phrase.type(1));
  const size_t first = 2 + (declares ? tokensOfSize(phrase, 2) : 0);
  size_t end = first;
  while (declares && end < kMostWords && isAnyName(phrase.type(end)) && !phrase.startsLine(end) &&
         (end == first || phrase.type(end) != GliderLexer::IN)) {
    ++end;
  }
  const bool both = phrase.type(end) == GliderLexer::COLON &&
                    phrase.type(end + 1) == GliderLexer::ASSIGN && phrase.touches(end + 1);
  const bool assigns = both || phrase.type(end) == GliderLexer::ASSIGN;
  const bool alone = phrase.startsLine(end) && isTypeName(phrase.text(first));
  if (end == first || !(assigns || alone || phrase.type(end) == GliderLexer::IN)) {
    return 0;
  }
  const size_t sign = both ? end + 1 : end;
  const std::string_view type = phrase.text(first);
  const std::string_view near = isTypeName(type) ? type : nearTypeName(type);
  if (end > first + 1 || near.empty()) {
    return assigns && first == 2 ? nameOfSeveralWords(phrase, end, sign) : 0;
  }
  const Lexeme found = phrase.token(first);
  const Lexeme before = phrase.token(first - 1);
  auto report = phrase.reporter().at(found, support::diagnostics::unexpectedToken, "`:`",
                                     describe(phrase.source(), found));
  report.hint(fmt::format("write `{}: {} …`", phrase.wholeText(0, first), near));
  for (size_t k = 0; k < first; ++k) {
    phrase.put(phrase.token(k));
  }
  phrase.put({GliderLexer::COLON, before.end, before.end});
  phrase.put(found);
  if (near == type) {
    report.fix({phrase.source().file, before.end, before.end}, ":");
  } else {
    phrase.notAsMeant();
  }
  return first + 1;
}

/// `var recent: temperature[8] = …`
size_t sizeAfterType(Phrase& phrase) {
  const bool typed = oneOf(phrase.type(), {GliderLexer::VAR, GliderLexer::PARAM}) &&
                     isAnyName(phrase.type(1)) && phrase.type(2) == GliderLexer::COLON &&
                     isName(phrase.type(3));
  const size_t size = typed ? tokensOfSize(phrase, 4) : 0;
  if (size == 0) {
    return 0;
  }
  const Lexeme& found = phrase.token(4);
  const std::string better =
      fmt::format("{}{}: {}", phrase.text(1), phrase.wholeText(4, size), phrase.text(3));
  phrase.reporter()
      .at(found, support::diagnostics::unexpectedToken, "`=`", describe(phrase.source(), found))
      .hint(fmt::format("write `{} {} = …`", phrase.text(), better))
      .fix(phrase.source().range(phrase.whole(1, 3 + size)), better);
  phrase.put(phrase.token());
  phrase.put(phrase.token(1));
  for (size_t k = 4; k < 4 + size; ++k) {
    phrase.put(phrase.token(k));
  }
  phrase.put(phrase.token(2));
  phrase.put(phrase.token(3));
  return 4 + size;
}

/// Whether an action sets `name`, which is declared here.
bool isSetLater(const Phrase& phrase, std::string_view name) {
  constexpr size_t kFarthest = 2000;
  for (size_t k = 0; k < kFarthest && phrase.type(k) != kEof; ++k) {
    if (phrase.type(k) == GliderLexer::SET && phrase.text(k + 1) == name) {
      return true;
    }
  }
  return false;
}

/// Reports `let warm = false`, `bool warm = false` of a variable and puts its declaration.
size_t putVariable(Phrase& phrase, std::string_view type) {
  const Lexeme word = phrase.token();
  const Lexeme name = phrase.token(1);
  const size_t value = tokensOfValue(phrase, 3, false);
  phrase.reporter()
      .at(word, support::diagnostics::misspelledKeyword, phrase.text(), "var")
      .hint(fmt::format("write `var {}: {} = {}`", phrase.text(1), type,
                        value == 0 ? std::string_view("…") : phrase.wholeText(3, value)));
  phrase.put({GliderLexer::VAR, word.begin, word.begin});
  phrase.put(name);
  phrase.put({GliderLexer::COLON, name.end, name.end});
  phrase.put(word);  // in place of the type
  phrase.put(phrase.token(2));
  phrase.notAsMeant();
  return 3;
}

/// `let warm = false`.
size_t wordOfOtherLanguage(Phrase& phrase) {
  if (!isName(phrase.type(1)) || phrase.type(2) != GliderLexer::ASSIGN) {
    return 0;
  }
  const bool word = phrase.says(0, "let") || phrase.says(0, "auto") || phrase.says(0, "local") ||
                    phrase.says(0, "define");
  const bool begins =
      phrase.before() == 0 || phrase.before() == GliderLexer::END || endsValue(phrase.before());
  if (!word || !begins || !phrase.startsLine() || !phrase.open().empty()) {
    return 0;
  }
  if (isSetLater(phrase, phrase.text(1))) {
    const std::string_view type = typeOf(phrase, 3);
    return putVariable(phrase, type.empty() ? "TYPE" : type);
  }
  const Lexeme found = phrase.token();
  phrase.reporter()
      .at(found, support::diagnostics::misspelledKeyword, phrase.text(), "const")
      .hint(fmt::format("write `const {} = …`", phrase.text(1)));
  phrase.put({GliderLexer::CONST, found.begin, found.end});
  return 1;
}

/// Whether the type is one of C and other languages.
bool isForeignType(std::string_view word) {
  constexpr std::array<std::string_view, 8> kTypes = {"float", "double", "int",     "integer",
                                                      "real",  "long",   "boolean", "unsigned"};
  return std::ranges::find(kTypes, word) != kTypes.end();
}

/// `length d = 5 m`, `float talked = 0;`.
size_t typeFirst(Phrase& phrase) {
  const bool begins =
      phrase.before() == 0 || phrase.before() == GliderLexer::END || endsValue(phrase.before());
  if (!isName(phrase.type()) || !isName(phrase.type(1)) || phrase.type(2) != GliderLexer::ASSIGN ||
      !begins || !phrase.startsLine() || !phrase.open().empty()) {
    return 0;
  }
  const bool foreign = isForeignType(phrase.text());
  if (!foreign && !isTypeName(phrase.text())) {
    return 0;
  }
  const size_t value = tokensOfValue(phrase, 3, false);
  if (phrase.type(3 + value) == GliderLexer::SEMICOLON && !phrase.startsLine(3 + value)) {
    phrase.leaveOut(3 + value);  // the pilot writes the whole line
  }
  const std::string_view ours = foreign ? typeOf(phrase, 3) : phrase.text();
  const std::string_view typed = ours.empty() ? "number" : ours;
  if (isSetLater(phrase, phrase.text(1))) {
    return putVariable(phrase, typed);
  }
  const Lexeme type = phrase.token();
  const std::string_view name = phrase.text(1);
  phrase.reporter()
      .at(phrase.whole(0, 2), support::diagnostics::missingKeyword, phrase.wholeText(0, 2), "const")
      .hint(fmt::format("write `const {1} = …`, or `var {1}: {0} = …` if it changes", typed, name));
  phrase.put({GliderLexer::CONST, type.begin, type.end});
  return 1;
}

}  // namespace

size_t untyped(Phrase& phrase) {
  return firstOf(phrase,
                 {withoutType, withoutColon, sizeAfterType, wordOfOtherLanguage, typeFirst});
}

size_t range(Phrase& phrase) {
  const bool number = phrase.type() == GliderLexer::NUMBER && phrase.inRange() &&
                      oneOf(phrase.keyword(), {GliderLexer::VAR, GliderLexer::PARAM});
  const size_t first = number ? tokensOfNumber(phrase, 0) : 0;
  if (first == 0 || !oneOf(phrase.before(), {GliderLexer::IN, GliderLexer::MINUS})) {
    return 0;
  }
  const std::string_view sign = phrase.text(first);
  const bool other =
      oneOf(phrase.type(first), {GliderLexer::TO, GliderLexer::MINUS, GliderLexer::COLON}) ||
      sign == "…" || sign == "–" || sign == "TO";
  const size_t second = other ? tokensOfNumber(phrase, first + 1) : 0;
  const uint32_t next = phrase.type(first + 1 + second);
  if (second == 0 || isOperator(next) || next == GliderLexer::RANGE) {
    return 0;
  }
  const Lexeme whole = phrase.whole(0, first + 1 + second);
  const Lexeme separator = phrase.token(first);
  phrase.reporter()
      .at(whole, support::diagnostics::notARange, phrase.source().text(whole),
          fmt::format("{} .. {}", phrase.wholeText(0, first), phrase.wholeText(first + 1, second)))
      .fix(phrase.source().range(separator), "..");
  for (size_t k = 0; k < first + 1 + second; ++k) {
    phrase.put(k == first ? Lexeme{GliderLexer::RANGE, separator.begin, separator.end}
                          : phrase.token(k));
  }
  return first + 1 + second;
}

size_t rangeInBrackets(Phrase& phrase) {
  const bool list = phrase.before() == GliderLexer::IN && phrase.before(2) != GliderLexer::FOR &&
                    !phrase.readsValues();
  const uint32_t closing =
      phrase.type() == GliderLexer::LBRACKET ? GliderLexer::RBRACKET : GliderLexer::RPAREN;
  const size_t first = list ? tokensOfQuantity(phrase, 1) : 0;
  const size_t comma = 1 + first;
  const size_t second =
      first > 0 && oneOf(phrase.type(comma), {GliderLexer::COMMA, GliderLexer::RANGE})
          ? tokensOfQuantity(phrase, comma + 1)
          : 0;
  const size_t count = comma + second + 2;
  if (second == 0 || phrase.type(count - 1) != closing) {
    return 0;
  }
  const Lexeme whole = phrase.whole(0, count);
  const std::string better =
      fmt::format("{} .. {}", phrase.wholeText(1, first), phrase.wholeText(comma + 1, second));
  phrase.reporter()
      .at(whole, support::diagnostics::notARange, phrase.source().text(whole), better)
      .fix(phrase.source().range(whole), better);
  for (size_t k = 1; k < count - 1; ++k) {
    const Lexeme& token = phrase.token(k);
    phrase.put(k == comma ? Lexeme{GliderLexer::RANGE, token.begin, token.end} : token);
  }
  return count;
}

size_t sizeOfConstant(Phrase& phrase) {
  const size_t size = phrase.before(1) == GliderLexer::CONST && isAnyName(phrase.before())
                          ? tokensOfSize(phrase, 0)
                          : 0;
  if (size == 0) {
    return 0;
  }
  const std::string_view name = phrase.source().text(*phrase.lexemeBefore());
  // No fix: with another number of elements, the list may be what is wrong.
  phrase.reporter()
      .at(phrase.whole(0, size), support::diagnostics::superfluousWord, phrase.wholeText(0, size),
          fmt::format("after `const {}`", name))
      .hint(fmt::format("write `const {} = [ … ]`: the list of a constant has no size", name));
  return size;
}

namespace {

/// `yo 5 m 50 m`: how many numbers with their units the next `count` tokens are; 0: something else
/// is among them, or they are parts of one value.
size_t numbersWithoutCommas(const Phrase& phrase, size_t count) {
  size_t numbers = 0;
  for (size_t k = 0; k < count; ++numbers) {
    const size_t number = tokensOfNumber(phrase, k);
    const bool unit = number >= 2 && phrase.type(k + number - 1) == GliderLexer::UNIT;
    if (!unit || tokensOfQuantity(phrase, k) != number) {
      return 0;
    }
    k += number;
  }
  return numbers;
}

/// Reports `yo 5 m 50 m` and puts its arguments.
size_t takeNumbers(Phrase& phrase, size_t line) {
  const Lexeme callee = *phrase.lexemeBefore();
  std::string better = "(";
  for (size_t k = 0; k < line; k += tokensOfNumber(phrase, k)) {
    better +=
        fmt::format("{}{}", k == 0 ? "" : ", ", phrase.wholeText(k, tokensOfNumber(phrase, k)));
  }
  better += ")";
  const Lexeme list = phrase.whole(0, line);
  phrase.reporter()
      .at(list, support::diagnostics::argumentsWithoutParentheses, phrase.source().text(callee),
          std::string(phrase.source().text(callee)) + better)
      .fix({phrase.source().file, callee.end, list.end}, better);
  phrase.insert(GliderLexer::LPAREN);
  for (size_t k = 0; k < line;) {
    const size_t end = k + tokensOfNumber(phrase, k);
    for (; k < end; ++k) {
      phrase.put(phrase.token(k));
    }
    if (k < line) {
      phrase.insert(GliderLexer::COMMA);
    }
  }
  phrase.insert(GliderLexer::RPAREN);
  return line;
}

}  // namespace

size_t withoutParentheses(Phrase& phrase) {
  const bool name = isAnyName(phrase.before()) &&
                    oneOf(phrase.before(1), {GliderLexer::FLIGHTPROFILE, GliderLexer::FLIGHTROUTE});
  if (!name || phrase.startsLine()) {
    return 0;
  }
  const bool brackets = phrase.type() == GliderLexer::LBRACKET && phrase.touches(0);
  const bool declared = phrase.type() == GliderLexer::NAME && phrase.isDeclared(phrase.text());
  if (!brackets && !declared && tokensOfNumber(phrase, 0) == 0) {
    return 0;
  }
  const size_t line = phrase.tokensOfLine();
  if (!brackets && numbersWithoutCommas(phrase, line) > 1) {
    return takeNumbers(phrase, line);
  }
  const size_t first = brackets ? 1 : 0;
  const size_t end = brackets ? line - 1 : line;
  if (brackets && phrase.type(line - 1) != GliderLexer::RBRACKET) {
    return 0;
  }
  for (size_t k = first; k < end;) {  // value, comma, value, …
    const size_t value = tokensOfValue(phrase, k, false);
    if (value == 0 || !readsAsValue(phrase, k, value) ||
        (k + value < end && phrase.type(k + value) != GliderLexer::COMMA)) {
      return 0;
    }
    k += value + 1;
  }
  const Lexeme callee = *phrase.lexemeBefore();
  const Lexeme list = phrase.whole(0, line);
  const std::string better = fmt::format("({})", phrase.wholeText(first, end - first));
  phrase.reporter()
      .at(list, support::diagnostics::argumentsWithoutParentheses, phrase.source().text(callee),
          std::string(phrase.source().text(callee)) + better)
      .fix({phrase.source().file, callee.end, list.end}, better);
  phrase.insert(GliderLexer::LPAREN);
  for (size_t k = first; k < end; ++k) {
    phrase.put(phrase.token(k));
  }
  phrase.insert(GliderLexer::RPAREN);
  return line;
}

namespace {

/// Whether `place` begins a declaration: names follow it on its line.
bool declaresPlace(const Phrase& phrase) {
  return phrase.type() == GliderLexer::PLACE && phrase.startsLine() && phrase.open().empty() &&
         isAnyName(phrase.type(1)) && !phrase.startsLine(1);
}

/// `place low battery = …`.
size_t placeOfSeveralWords(Phrase& phrase) {
  constexpr size_t kMostWords = 5;
  std::string joined(phrase.text(1));
  size_t end = 2;
  while (end <= kMostWords && !phrase.startsLine(end)) {
    end += phrase.type(end) == GliderLexer::MINUS ? 1U : 0U;
    if (!isAnyName(phrase.type(end))) {
      break;
    }
    joined += fmt::format("_{}", phrase.text(end++));
  }
  const bool colon = phrase.type(end) == GliderLexer::COLON;
  if (end < 3 || !(colon || phrase.type(end) == GliderLexer::ASSIGN)) {
    return 0;
  }
  const Lexeme name = phrase.whole(1, end - 1, GliderLexer::NAME);
  auto report =
      phrase.reporter().at(name, support::diagnostics::nameNotOneWord, phrase.source().text(name),
                           fmt::format("write `place {} = …`", joined));
  if (!phrase.isDeclared(joined)) {
    report.fix({phrase.source().file, name.begin, colon ? phrase.token(end).end : name.end},
               colon ? joined + " =" : joined);
  }
  phrase.put(phrase.token());
  phrase.put(name);
  phrase.notAsMeant();
  if (colon) {
    phrase.insert(GliderLexer::ASSIGN);
  }
  return end + (colon ? 1 : 0);
}

/// `place low: bool = …`.
size_t placeWithType(Phrase& phrase) {
  if (phrase.type(2) != GliderLexer::COLON || phrase.type(4) != GliderLexer::ASSIGN) {
    return 0;
  }
  const Lexeme type = phrase.whole(2, 2);
  phrase.reporter()
      .at(type, support::diagnostics::superfluousWord, phrase.source().text(type),
          "after the name of a place")
      .fix(phrase.source().range(type), "");
  phrase.put(phrase.token());
  phrase.put(phrase.token(1));
  return 4;
}

/// `place low: battery < 11.5 V`, `place low when battery < 11.5 V`, `place low battery < 11.5 V`.
size_t placeWithoutSign(Phrase& phrase) {
  const bool word =
      oneOf(phrase.type(2), {GliderLexer::COLON, GliderLexer::WHEN, GliderLexer::WHENEVER,
                             GliderLexer::WHERE, GliderLexer::IF}) ||
      phrase.says(2, "is") || phrase.says(2, "means");
  const size_t first = word ? 3 : 2;
  const bool value = startsValue(phrase.type(first)) ||
                     oneOf(phrase.type(first), {GliderLexer::LPAREN, GliderLexer::NOT});
  const size_t count = tokensOfValue(phrase, first, false);
  if (!value || phrase.startsLine(2) || (!word && (count < 3 || phrase.startsLine(4)))) {
    return 0;
  }
  const Lexeme name = phrase.token(1);
  const Lexeme found = phrase.token(2);
  phrase.reporter()
      .at(found, support::diagnostics::unexpectedToken, "`=`", describe(phrase.source(), found))
      .hint(fmt::format("write `place {} = …`", phrase.text(1)))
      .fix({phrase.source().file, name.end, word ? found.end : name.end}, " =");
  phrase.put(phrase.token());
  phrase.put(name);
  phrase.put({GliderLexer::ASSIGN, found.begin, word ? found.end : found.begin});
  return first;
}

}  // namespace

size_t place(Phrase& phrase) {
  if (!declaresPlace(phrase)) {
    return 0;
  }
  return firstOf(phrase, {placeOfSeveralWords, placeWithType, placeWithoutSign});
}

namespace {

/// What stands between `declination` or `resume` and the number: `=`, or `in` of a time.
size_t tokensBeforeNumber(const Phrase& phrase, bool resume) {
  if (oneOf(phrase.type(1), {GliderLexer::ASSIGN, GliderLexer::COLON})) {
    return 1;
  }
  return resume ? tokensOfOne(phrase, 1, {"in", "at most"}) : 0;
}

}  // namespace

size_t signOfItem(Phrase& phrase) {
  const bool resume = phrase.type() == GliderLexer::RESUME;
  const bool top = endsValue(phrase.before()) || phrase.before() == GliderLexer::END ||
                   phrase.before() == GliderLexer::STRING || phrase.before() == 0;
  const size_t sign = tokensBeforeNumber(phrase, resume);
  const size_t first = 1 + sign;
  const size_t number = tokensOfQuantity(phrase, first);
  // Inside a block it may be a variable of this name.
  if (!top || (sign == 0 && !resume) || number == 0 || !phrase.startsLine() ||
      !phrase.startsLine(first + number) ||
      oneOf(phrase.keyword(), {GliderLexer::DO, GliderLexer::THEN, GliderLexer::ELSE,
                               GliderLexer::SET, GliderLexer::LOG})) {
    return 0;
  }
  const Lexeme word = phrase.token();
  const Lexeme found = phrase.token(1);
  const std::string_view between = resume ? " within " : " ";
  phrase.reporter()
      .at(found, support::diagnostics::unexpectedToken, resume ? "`within`" : "an angle",
          describe(phrase.source(), found))
      .hint(fmt::format("write `{}{}{}`", phrase.text(), between, phrase.wholeText(first, number)))
      .fix({phrase.source().file, word.end, phrase.token(first).begin}, std::string(between));
  phrase.put(word);
  if (resume) {
    phrase.insert(GliderLexer::WITHIN);
  }
  return first;
}

size_t importWithoutQuotes(Phrase& phrase) {
  if (phrase.before() != GliderLexer::IMPORT || phrase.startsLine() ||
      oneOf(phrase.type(), {GliderLexer::STRING, GliderLexer::OPEN_STRING, GliderLexer::FOREIGN})) {
    return 0;
  }
  size_t tokens = 1;
  while (phrase.touches(tokens) && phrase.type(tokens) != kEof) {
    ++tokens;
  }
  const bool ends = phrase.type(tokens) == GliderLexer::AS || phrase.startsLine(tokens) ||
                    phrase.type(tokens) == kEof;
  const Lexeme name = phrase.whole(0, tokens, GliderLexer::STRING);
  const std::string better = fmt::format("\"{}\"", phrase.source().text(name));
  auto report = phrase.reporter().at(name, support::diagnostics::unexpectedToken,
                                     "the name of a file in quotes",
                                     fmt::format("`{}`", phrase.source().text(name)));
  const bool named = phrase.type(tokens) == GliderLexer::AS && isName(phrase.type(tokens + 1));
  report.hint(fmt::format("write `import {}{}`", better,
                          named ? fmt::format(" as {}", phrase.text(tokens + 1)) : ""));
  if (ends) {
    report.fix(phrase.source().range(name), better);
  }
  phrase.put(name);
  phrase.notAsMeant();
  return tokens;
}

}  // namespace glider::frontend::phrases
