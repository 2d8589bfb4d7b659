// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/comparing.h"
#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>

namespace glider::frontend::phrases {
namespace {

/// Words that compare, with what they mean. `is` may stand before them, `or equal to` after them.
struct ComparingWords {
  std::string_view words;
  std::string_view sign;
  uint32_t type;
  std::string_view or_equal;
  uint32_t or_equal_type;
};
constexpr uint32_t kGreater = GliderLexer::GT;
constexpr uint32_t kAtLeast = GliderLexer::GE;
constexpr uint32_t kLess = GliderLexer::LT;
constexpr uint32_t kAtMost = GliderLexer::LE;
constexpr ComparingWords kComparing[] = {{"greater than", ">", kGreater, ">=", kAtLeast},
                                         {"more than", ">", kGreater, ">=", kAtLeast},
                                         {"larger than", ">", kGreater, ">=", kAtLeast},
                                         {"bigger than", ">", kGreater, ">=", kAtLeast},
                                         {"higher than", ">", kGreater, ">=", kAtLeast},
                                         {"deeper than", ">", kGreater, ">=", kAtLeast},
                                         {"warmer than", ">", kGreater, ">=", kAtLeast},
                                         {"longer than", ">", kGreater, ">=", kAtLeast},
                                         {"above", ">", kGreater, ">=", kAtLeast},
                                         {"over", ">", kGreater, ">=", kAtLeast},
                                         {"exceeds", ">", kGreater, ">=", kAtLeast},
                                         {"exceed", ">", kGreater, ">=", kAtLeast},
                                         {"less than", "<", kLess, "<=", kAtMost},
                                         {"lower than", "<", kLess, "<=", kAtMost},
                                         {"smaller than", "<", kLess, "<=", kAtMost},
                                         {"fewer than", "<", kLess, "<=", kAtMost},
                                         {"shallower than", "<", kLess, "<=", kAtMost},
                                         {"colder than", "<", kLess, "<=", kAtMost},
                                         {"cooler than", "<", kLess, "<=", kAtMost},
                                         {"shorter than", "<", kLess, "<=", kAtMost},
                                         {"below", "<", kLess, "<=", kAtMost},
                                         {"under", "<", kLess, "<=", kAtMost},
                                         {"at least", ">=", kAtLeast, "", 0},
                                         {"at most", "<=", kAtMost, "", 0}};

/// Words before `below` and `above` that say that a value is there, or that it comes there.
constexpr std::string_view kStanding[] = {"must be",     "should be", "must stay",
                                          "should stay", "has to be", "is",
                                          "stays",       "remains",   "gets"};
constexpr std::string_view kChanging[] = {"drops",  "falls", "sinks",   "goes", "rises",
                                          "climbs", "comes", "becomes", "turns"};

/// `no more than` is at most.
std::pair<std::string_view, uint32_t> negated(uint32_t sign) {
  return sign == kGreater ? std::pair<std::string_view, uint32_t>("<=", kAtMost)
                          : std::pair<std::string_view, uint32_t>(">=", kAtLeast);
}

/// Whether conditions are read here, and a value was.
bool afterValue(const Phrase& phrase) {
  return endsValue(phrase.before()) && phrase.readsValues();
}

/// Whether a comparison begins after it.
bool leadsToComparison(uint32_t type) {
  return oneOf(type,
               {GliderLexer::CASE, GliderLexer::IF, GliderLexer::ALWAYS, GliderLexer::LPAREN,
                GliderLexer::AND, GliderLexer::OR, GliderLexer::AND_WORD, GliderLexer::OR_WORD});
}

/// `peaks[3] is known`.
size_t elementIsKnown(Phrase& phrase) {
  constexpr size_t kFarthest = 12;
  size_t open = 0;
  while (open < kFarthest && phrase.before(open) != GliderLexer::LBRACKET) {
    ++open;
  }
  const bool words = phrase.says(0, "is") && phrase.says(1, "known");
  if (!words || phrase.before() != GliderLexer::RBRACKET || open == kFarthest ||
      !isName(phrase.before(open + 1)) || !leadsToComparison(phrase.before(open + 2))) {
    return 0;
  }
  const Lexeme element{0, phrase.lexemeBefore(open + 1)->begin, phrase.lexemeBefore()->end};
  const Lexeme found = phrase.whole(0, 2);
  const std::string better = fmt::format("known({})", phrase.source().text(element));
  phrase.reporter()
      .at(found, support::diagnostics::wordOperator, phrase.source().text(found), better)
      .fix({phrase.source().file, element.begin, found.end}, better);
  phrase.notAsMeant();
  return 2;
}

/// `is 20 degC`, `equals 3`: whether readings may be compared exactly is for the pilot to say.
size_t equalWords(Phrase& phrase) {
  if (const size_t taken = elementIsKnown(phrase)) {
    return taken;
  }
  for (const std::string_view words :
       {"is equal to", "equal to", "equals", "is", "reaches", "hits"}) {
    const size_t tokens = tokensOfWords(phrase, 0, words);
    if (tokens > 0 && startsAnyValue(phrase.type(tokens))) {
      const Lexeme sign = phrase.whole(0, tokens, kAtLeast);
      phrase.reporter()
          .at(sign, support::diagnostics::wordOperator, phrase.source().text(sign), "")
          .hint("write `>=` or `<=` for a reading or a clock, `==` only for a count");
      phrase.put(sign);
      return tokens;
    }
  }
  return 0;
}

struct Bounds {
  size_t low = 0;
  size_t low_tokens = 0;
  size_t high = 0;
  size_t high_tokens = 0;
  [[nodiscard]] size_t end() const { return high + high_tokens; }
};

/// The tokens of `18:00` from token `k` on; 0: there is no clock.
size_t tokensOfClock(const Phrase& phrase, size_t k) {
  const bool clock = phrase.type(k) == GliderLexer::NUMBER &&
                     phrase.type(k + 1) == GliderLexer::COLON && phrase.touches(k + 1) &&
                     phrase.type(k + 2) == GliderLexer::NUMBER && phrase.touches(k + 2);
  return clock ? 3 : 0;
}

/// "18 h 30 min" of `18:30`.
std::string hoursAndMinutes(std::string_view clock) {
  const size_t colon = clock.find(':');
  const std::string hours = fmt::format("{} h", clock.substr(0, colon));
  const std::string_view minutes = clock.substr(colon + 1);
  return minutes.find_first_not_of('0') == std::string_view::npos
             ? hours
             : fmt::format("{} {} min", hours, minutes.substr(minutes.find_first_not_of('0')));
}

/// The tokens of a bound: a number with its unit, or a time of the day after its clock.
size_t tokensOfBound(const Phrase& phrase, size_t k) {
  const Lexeme* name = phrase.lexemeBefore();
  const bool of_day = name != nullptr && phrase.source().text(*name) == "timeofday";
  const size_t clock = of_day ? tokensOfClock(phrase, k) : 0;
  return clock > 0 ? clock : tokensOfNumber(phrase, k);
}

void putBound(Phrase& phrase, size_t first, size_t count) {
  if (tokensOfClock(phrase, first) > 0) {
    phrase.put(phrase.whole(first, count, GliderLexer::NUMBER));
    phrase.notAsMeant();
    return;
  }
  for (size_t k = first; k < first + count; ++k) {
    phrase.put(phrase.token(k));
  }
}

void putComparison(Phrase& phrase, const Lexeme& name, uint32_t sign, size_t first, size_t count) {
  phrase.put(name);
  const Lexeme& from = phrase.token(first);
  phrase.put({sign, from.begin, from.begin});
  putBound(phrase, first, count);
}

/// `A and B` or `A .. B` from token `first` on.
std::optional<Bounds> boundsFrom(const Phrase& phrase, size_t first, bool range) {
  Bounds bounds;
  bounds.low = first;
  bounds.low_tokens = tokensOfBound(phrase, first);
  const size_t between = first + bounds.low_tokens;
  const bool good = range ? phrase.type(between) == GliderLexer::RANGE
                          : oneOf(phrase.type(between), {GliderLexer::AND_WORD, GliderLexer::AND});
  bounds.high = between + 1;
  bounds.high_tokens = tokensOfBound(phrase, bounds.high);
  return good && bounds.low_tokens > 0 && bounds.high_tokens > 0 ? std::optional(bounds)
                                                                 : std::nullopt;
}

/// Both as they are meant: in `2 and 4 h` the first is in hours too.
std::pair<std::string, std::string> textsOf(const Phrase& phrase, const Bounds& bounds) {
  std::string low(phrase.wholeText(bounds.low, bounds.low_tokens));
  std::string high(phrase.wholeText(bounds.high, bounds.high_tokens));
  if (tokensOfClock(phrase, bounds.low) > 0 && tokensOfClock(phrase, bounds.high) > 0) {
    return {hoursAndMinutes(low), hoursAndMinutes(high)};
  }
  const bool bare_low = phrase.type(bounds.low + bounds.low_tokens - 1) == GliderLexer::NUMBER;
  const bool bare_high = phrase.type(bounds.end() - 1) == GliderLexer::NUMBER;
  if (bare_low && !bare_high) {
    low += " " + std::string(phrase.wholeText(bounds.end() - 1, 1));
  } else if (bare_high && !bare_low) {
    high += " " + std::string(phrase.wholeText(bounds.low + bounds.low_tokens - 1, 1));
  }
  return {low, high};
}

}  // namespace

ComparingPhrase comparingAt(const Phrase& phrase, size_t k) {
  ComparingPhrase found;
  const size_t changing = tokensOfOne(phrase, k, kChanging);
  found.changes = changing > 0;
  size_t at = k + (changing > 0 ? changing : tokensOfOne(phrase, k, kStanding));
  const bool no = phrase.says(at, "no") || phrase.says(at, "not");
  at += no ? 1 : 0;
  const auto row = std::ranges::find_if(kComparing, [&](const ComparingWords& words) {
    return tokensOfWords(phrase, at, words.words) > 0;
  });
  if (row == std::end(kComparing) || (no && row->or_equal.empty())) {
    return {};
  }
  at += tokensOfWords(phrase, at, row->words);
  const size_t to = row->or_equal.empty() ? 0 : tokensOfWords(phrase, at, "or equal to");
  const size_t equal =
      to != 0 || row->or_equal.empty() ? to : tokensOfWords(phrase, at, "or equal");
  at += no ? 0 : equal;
  found.tokens = at - k;
  found.sign = equal != 0 ? row->or_equal : row->sign;
  found.type = equal != 0 ? row->or_equal_type : row->type;
  if (no) {
    std::tie(found.sign, found.type) = negated(row->type);
  }
  return found;
}

size_t comparison(Phrase& phrase) {
  const bool word = isAnyName(phrase.type()) || phrase.type() == GliderLexer::NOT_WORD;
  if (!word || phrase.type() == GliderLexer::UNIT || !afterValue(phrase)) {
    return 0;
  }
  const ComparingPhrase found = comparingAt(phrase, 0);
  if (found.tokens == 0) {
    return equalWords(phrase);
  }
  if ((phrase.keyword() == GliderLexer::REQUIRE && phrase.type() == GliderLexer::AT) ||
      !startsAnyValue(phrase.type(found.tokens))) {
    return 0;  // `visit a at most 3 times` is a promise
  }
  const Lexeme words = phrase.whole(0, found.tokens, found.type);
  auto report = phrase.reporter().at(words, support::diagnostics::wordOperator,
                                     phrase.source().text(words), found.sign);
  if (found.changes) {  // no fix: only the pilot knows whether it may be so from the beginning
    report.hint(
        fmt::format("write `{}`; if it must have been otherwise before, put `became(…)` around it",
                    found.sign));
  } else {
    report.fix(phrase.source().range(words), std::string(found.sign));
  }
  phrase.put(words);
  return found.tokens;
}

namespace {

/// `not between 10 m and 30 m`, after the name.
size_t outsideBounds(Phrase& phrase, const Lexeme& name, size_t words, const Bounds& bounds) {
  const Source& source = phrase.source();
  const auto [low, high] = textsOf(phrase, bounds);
  const uint32_t next = phrase.type(bounds.end());
  const bool alone =
      phrase.before(1) == GliderLexer::CASE && (isTransition(next) || next == GliderLexer::DO);
  const std::string better = fmt::format("{3}{0} < {1} || {0} > {2}{4}", source.text(name), low,
                                         high, alone ? "" : "(", alone ? "" : ")");
  const Lexeme written = phrase.whole(0, words);
  const Lexeme whole{0, name.begin, phrase.token(bounds.end() - 1).end};
  phrase.reporter()
      .at(written, support::diagnostics::wordOperator, source.text(written), better)
      .fix(source.range(whole), better);
  phrase.put({kLess, written.begin, written.end});
  putBound(phrase, bounds.low, bounds.low_tokens);
  const Lexeme& high_at = phrase.token(bounds.high);
  phrase.put({GliderLexer::OR, high_at.begin, high_at.begin + 1});
  putComparison(phrase, name, kGreater, bounds.high, bounds.high_tokens);
  return bounds.end();
}

}  // namespace

size_t between(Phrase& phrase) {
  const bool word = isAnyName(phrase.type()) || phrase.type() == GliderLexer::NOT_WORD;
  if (!word || !afterValue(phrase)) {
    return 0;
  }
  const bool in = phrase.type() == GliderLexer::IN;
  const size_t only_is = phrase.says(0, "is") ? 1 : 0;
  const size_t negation = phrase.says(only_is, "not") ? 1 : 0;
  const size_t is = only_is + negation;
  if (!in && !phrase.says(is, "between")) {
    return 0;
  }
  const auto bounds = boundsFrom(phrase, 1 + is, in);
  if (!bounds || !isName(phrase.before()) || !leadsToComparison(phrase.before(1))) {
    return 0;
  }
  const Lexeme name = *phrase.lexemeBefore();
  if (negation > 0) {
    return outsideBounds(phrase, name, 1 + is, *bounds);
  }
  const Source& source = phrase.source();
  const Lexeme words = phrase.whole(0, 1 + is);
  const auto [low, high] = textsOf(phrase, *bounds);
  const std::string better = fmt::format("{0} >= {1} && {0} <= {2}", source.text(name), low, high);
  const Lexeme whole{0, name.begin, phrase.token(bounds->end() - 1).end};
  phrase.reporter()
      .at(words, support::diagnostics::wordOperator, source.text(words), better)
      .fix(source.range(whole), better);
  const Lexeme& first = phrase.token(bounds->low);
  phrase.put({kAtLeast, words.begin, words.end});
  putBound(phrase, bounds->low, bounds->low_tokens);
  phrase.put({GliderLexer::AND, first.begin, first.end});
  putComparison(phrase, name, kAtMost, bounds->high, bounds->high_tokens);
  return bounds->end();
}

size_t sameLeft(Phrase& phrase) {
  const bool compares =
      oneOf(phrase.type(), {GliderLexer::LT, GliderLexer::GT, GliderLexer::LE, GliderLexer::GE});
  if (!compares || !oneOf(phrase.before(), {GliderLexer::AND, GliderLexer::OR,
                                            GliderLexer::AND_WORD, GliderLexer::OR_WORD})) {
    return 0;
  }
  // `depth > 5 m && < 10 m`: the name, its sign, a number and perhaps a unit before the `&&`.
  const size_t unit = phrase.before(1) == GliderLexer::NUMBER ? 0 : 1;
  const size_t sign = 2 + unit;
  const bool known = phrase.before(1 + unit) == GliderLexer::NUMBER &&
                     oneOf(phrase.before(sign), {kLess, kGreater, kAtLeast, kAtMost}) &&
                     isName(phrase.before(sign + 1)) && leadsToComparison(phrase.before(sign + 2));
  if (!known) {
    return 0;
  }
  const Lexeme name = *phrase.lexemeBefore(sign + 1);
  const Lexeme& found = phrase.token();
  const std::string left(phrase.source().text(name));
  phrase.reporter()
      .at(found, support::diagnostics::unexpectedToken, "a value", describe(phrase.source(), found))
      .hint(fmt::format("write `{} {} …`", left, phrase.text()))
      .fix({phrase.source().file, found.begin, found.begin}, left + " ");
  phrase.put(name);
  phrase.put(found);
  return 1;
}

size_t notWord(Phrase& phrase) {
  const bool capital = phrase.type() == GliderLexer::NAME && phrase.says(0, "not") &&
                       !endsValue(phrase.before()) && !wantsName(phrase.before());
  if (phrase.type() != GliderLexer::NOT_WORD && !capital) {
    return 0;
  }
  const Lexeme word = phrase.token();
  const size_t count = tokensOfValue(phrase, 1, true);
  auto report =
      phrase.reporter().at(word, support::diagnostics::wordOperator, phrase.text(), "!(…)");
  phrase.put({GliderLexer::NOT_WORD, word.begin, word.end});
  if (count == 0 || !readsAsValue(phrase, 1, count)) {
    return 1;
  }
  // `!` applies to one value only: a comparison goes in parentheses.
  const bool name = count == 1;
  const size_t open = phrase.type(1) == GliderLexer::LPAREN ? 1 : 2;
  bool closed = phrase.type(open) == GliderLexer::LPAREN;
  size_t deep = 0;
  for (size_t k = open; closed && k < count; ++k) {
    deep += phrase.type(k) == GliderLexer::LPAREN ? 1U : 0U;
    deep -= phrase.type(k) == GliderLexer::RPAREN ? 1U : 0U;
    closed = deep > 0;
  }
  const Lexeme operand = phrase.whole(1, count);
  const Source& source = phrase.source();
  const bool alone = name || closed;
  report.hint(alone ? fmt::format("write `!{}`", source.text(operand))
                    : fmt::format("write `!({})`", source.text(operand)));
  report.fix({source.file, word.begin, operand.begin}, alone ? "!" : "!(");
  if (!alone) {
    report.fix({source.file, operand.end, operand.end}, ")");
  }
  return 1;
}

size_t foreignSign(Phrase& phrase) {
  std::string_view better;
  uint32_t meant = 0;
  support::DiagnosticId id = support::diagnostics::wordOperator;
  if (phrase.type() == GliderLexer::COLON && phrase.type(1) == GliderLexer::ASSIGN &&
      phrase.touches(1)) {
    better = "=";
    meant = GliderLexer::ASSIGN;
  } else if (oneOf(phrase.type(), {kGreater, kLess}) && phrase.type(1) == phrase.type() &&
             phrase.touches(1)) {
    better = phrase.text();
    meant = phrase.type();
    id = support::diagnostics::wrongComparison;
  } else if (phrase.type() == GliderLexer::TO && phrase.keyword() == GliderLexer::SET &&
             phrase.before(1) == GliderLexer::SET) {
    better = "=";
    meant = GliderLexer::ASSIGN;
  } else {
    return 0;
  }
  const size_t tokens = meant == GliderLexer::ASSIGN && phrase.type() == GliderLexer::TO ? 1 : 2;
  const Lexeme sign = phrase.whole(0, tokens, meant);
  if (phrase.type() == GliderLexer::COLON) {
    phrase.put(sign);
    return tokens;  // StructureRepair reports it with the keyword that may be missing before it
  }
  phrase.reporter()
      .at(sign, id, phrase.source().text(sign), better)
      .fix(phrase.source().range(sign), std::string(better));
  phrase.put(sign);
  return tokens;
}

size_t tilde(Phrase& phrase) {
  if (phrase.text() != "~") {
    return 0;
  }
  const Source& source = phrase.source();
  if (phrase.type(1) == GliderLexer::ASSIGN && phrase.touches(1)) {
    const Lexeme sign = phrase.whole(0, 2, GliderLexer::NE);
    phrase.reporter().at(sign, support::diagnostics::wrongComparison, source.text(sign), "!=");
    phrase.put(sign);
    phrase.notAsMeant();
    return 2;
  }
  const bool value = startsValue(phrase.type(1)) || phrase.type(1) == GliderLexer::LPAREN;
  if (endsValue(phrase.before()) || !value) {
    return 0;
  }
  const Lexeme sign = phrase.whole(0, 1, GliderLexer::NOT);
  phrase.reporter()
      .at(sign, support::diagnostics::wordOperator, phrase.text(), "!")
      .hint(isName(phrase.type(1)) && phrase.type(2) != GliderLexer::LPAREN
                ? fmt::format("write `!{}`", phrase.text(1))
                : "write `!`")
      .fix(source.range(sign), "!");
  phrase.put(sign);
  return 1;
}

size_t commaAsAnd(Phrase& phrase) {
  const bool condition =
      phrase.keyword() == GliderLexer::CASE && phrase.open().empty() && endsValue(phrase.before());
  if (phrase.type() != GliderLexer::COMMA || !condition || phrase.touches(1)) {
    return 0;
  }
  const size_t count = tokensOfValue(phrase, 1, false);
  if (count < 3 || !readsAsValue(phrase, 1, count) || !isTransition(phrase.type(1 + count))) {
    return 0;
  }
  const Lexeme comma = phrase.token();
  phrase.reporter()
      .at(comma, support::diagnostics::wordOperator, ",", "&&")
      .hint("write `&&` if both conditions must hold, `||` if one is enough");
  phrase.put({GliderLexer::AND, comma.begin, comma.end});
  return 1;
}

size_t power(Phrase& phrase) {
  const bool sign = phrase.text() == "^";
  const size_t number = tokensOfNumber(phrase, 1);
  if (!sign || !endsValue(phrase.before()) || number == 0) {
    return 0;
  }
  const Lexeme whole = phrase.whole(0, 1 + number);
  const bool square = phrase.wholeText(1, number) == "2" && isName(phrase.before());
  const std::string_view base = phrase.source().text(*phrase.lexemeBefore());
  auto report = phrase.reporter().at(whole, support::diagnostics::wordOperator, "^", "");
  if (square) {
    report.hint(fmt::format("write `{0} * {0}`", base))
        .fix(phrase.source().range(whole), fmt::format(" * {}", base));
  } else {
    report.hint("multiply it by itself, as in `depth * depth`");
  }
  phrase.notAsMeant();
  return 1 + number;
}

size_t plusOfTexts(Phrase& phrase) {
  const bool text = phrase.before() == GliderLexer::STRING || phrase.type(1) == GliderLexer::STRING;
  if (phrase.type() != GliderLexer::PLUS || phrase.keyword() != GliderLexer::LOG || !text ||
      !phrase.open().empty() || !endsValue(phrase.before())) {
    return 0;
  }
  const Lexeme sign = phrase.token();
  const auto quoted = [&](const Lexeme& t) { return fmt::format("`{}`", phrase.source().text(t)); };
  phrase.reporter()
      .at(sign, support::diagnostics::missingComma, quoted(*phrase.lexemeBefore()),
          quoted(phrase.token(1)))
      .hint("write `,` for `+`")
      .fix(phrase.source().range(sign), ",");
  phrase.put({GliderLexer::COMMA, sign.begin, sign.end});
  return 1;
}

namespace {

/// Whether the last bar that was read begins an absolute value.
bool barIsOpen(const Phrase& phrase) {
  constexpr size_t kLongest = 200;
  for (size_t k = 0; k < kLongest && phrase.lexemeBefore(k) != nullptr; ++k) {
    const Lexeme& before = *phrase.lexemeBefore(k);
    if (oneOf(before.type, {GliderLexer::LPAREN, GliderLexer::RPAREN}) &&
        phrase.source().text(before) == "|") {
      return before.type == GliderLexer::LPAREN;
    }
  }
  return false;
}

}  // namespace

size_t absoluteBars(Phrase& phrase) {
  const Lexeme bar = phrase.token();
  if (barIsOpen(phrase)) {
    phrase.put({GliderLexer::RPAREN, bar.begin, bar.end});
    return 1;
  }
  const size_t line = phrase.tokensOfLine();
  size_t close = 1;
  while (close < line && phrase.type(close) != GliderLexer::ONE_BAR) {
    ++close;
  }
  if (endsValue(phrase.before()) || close < 2 || close >= line) {
    return 0;
  }
  const std::string value = fmt::format("abs({})", phrase.wholeText(1, close - 1));
  const Lexeme whole = phrase.whole(0, close + 1);
  phrase.reporter()
      .at(whole, support::diagnostics::singleAmpersand, "|", value)
      .fix(phrase.source().range(whole), value);
  phrase.put({GliderLexer::LPAREN, bar.begin, bar.end});
  return 1;
}

}  // namespace glider::frontend::phrases
