// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/choices/clauses.h"

#include "frontend/parse/phrases/written_type.h"
#include "frontend/parse/token_kinds.h"
#include "frontend/spelling.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace glider::frontend::phrases {
namespace {

/// The words that lead a part.
struct Lead {
  std::string_view words;
  Part part;
};

/// Longer ones before those that they begin with.
constexpr std::array kLeads = {
    Lead{"in steps of", Part::Step},   Lead{"in increments of", Part::Step},
    Lead{"with steps of", Part::Step}, Lead{"with a step of", Part::Step},
    Lead{"with step", Part::Step},     Lead{"by steps of", Part::Step},
    Lead{"at steps of", Part::Step},   Lead{"steps of", Part::Step},
    Lead{"step size", Part::Step},     Lead{"step of", Part::Step},
    Lead{"steps", Part::Step},         Lead{"step", Part::Step},
    Lead{"stepping", Part::Step},      Lead{"increment", Part::Step},
    Lead{"every", Part::Step},         Lead{"each", Part::Step},
    Lead{"by default", Part::Value},   Lead{"by", Part::Step},
    Lead{"in the range", Part::Range}, Lead{"in between", Part::Range},
    Lead{"in range", Part::Range},     Lead{"ranging from", Part::Range},
    Lead{"range", Part::Range},        Lead{"in", Part::Range},
    Lead{"from", Part::Range},         Lead{"between", Part::Range},
    Lead{"within", Part::Range},       Lead{"one of", Part::Range},
    Lead{"among", Part::Range},        Lead{"such that", Part::Condition},
    Lead{"so that", Part::Condition},  Lead{"provided that", Part::Condition},
    Lead{"provided", Part::Condition}, Lead{"subject to", Part::Condition},
    Lead{"where", Part::Condition},    Lead{"whenever", Part::Condition},
    Lead{"when", Part::Condition},     Lead{"default", Part::Value},
    Lead{"initially", Part::Value},    Lead{"if", Part::Condition},
    Lead{"with", Part::Condition},
};

/// A part that begins here: what it is, and the tokens that lead it.
struct Head {
  Part part = Part::Type;
  size_t tokens = 0;
  bool right = true;
};

bool opensList(const Phrase& phrase, size_t k) {
  return oneOf(phrase.type(k), {GliderLexer::LPAREN, GliderLexer::LBRACKET}) ||
         phrase.text(k) == "{";
}

bool closesList(const Phrase& phrase, size_t k) {
  return oneOf(phrase.type(k), {GliderLexer::RPAREN, GliderLexer::RBRACKET}) ||
         phrase.text(k) == "}";
}

bool beginsOperand(const Phrase& phrase, size_t k) {
  return startsAnyValue(phrase.type(k)) || phrase.text(k) == "{" ||
         oneOf(phrase.type(k), {GliderLexer::LBRACKET, GliderLexer::NOT, GliderLexer::NOT_WORD});
}

/// `at launch`, `on launch`, `at each surfacing`, `before the flight`: when something is chosen.
size_t tokensOfLaunch(const Phrase& phrase, size_t k) {
  constexpr size_t kMostWords = 4;
  constexpr std::array<std::string_view, 9> kWords = {"at",     "on",    "upon", "before", "after",
                                                      "during", "every", "each", "launch"};
  if (!std::ranges::any_of(kWords, [&](auto word) { return phrase.says(k, word); })) {
    return 0;
  }
  if (phrase.type(k) == GliderLexer::AT && phrase.type(k + 1) == GliderLexer::LAUNCH) {
    return 2;
  }
  size_t words = 1;
  while (words < kMostWords && !phrase.startsLine(k + words) &&
         (isName(phrase.type(k + words)) || phrase.says(k + words, "every")) &&
         !oneOf(phrase.type(k + words), {GliderLexer::WHERE, GliderLexer::BY, GliderLexer::IN})) {
    ++words;
  }
  return words > 1 || phrase.type(k) == GliderLexer::LAUNCH ? words : 0;
}

/// `surfacing` of `every surfacing`.
bool isMoment(const Phrase& phrase, size_t k) {
  constexpr std::array<std::string_view, 9> kWords = {
      "surfacing", "dive", "yo", "climb", "cycle", "time", "flight", "segment", "turn"};
  return std::ranges::any_of(kWords, [&](auto word) { return phrase.says(k, word); });
}

/// `:`, `=`, `:=` of a choice.
std::optional<Head> signAt(const Phrase& phrase, size_t k) {
  if (phrase.type(k) == GliderLexer::COLON) {
    const bool assigns = phrase.type(k + 1) == GliderLexer::ASSIGN;
    return assigns ? Head{Part::Value, 2, false} : Head{Part::Type, 1, true};
  }
  if (oneOf(phrase.type(k), {GliderLexer::ASSIGN, GliderLexer::EQ})) {
    return Head{Part::Value, 1, true};
  }
  return std::nullopt;
}

/// A word may begin its line only where it is right: others begin something else there.
std::optional<Head> wordAt(const Phrase& phrase, size_t k) {
  for (const Lead& lead : kLeads) {
    size_t tokens = tokensOfWords(phrase, k, lead.words);
    if (tokens == 0) {
      continue;
    }
    const uint32_t type = phrase.type(k);
    const bool right =
        tokens == 1 && oneOf(type, {GliderLexer::IN, GliderLexer::BY, GliderLexer::WHERE});
    const bool sign =
        oneOf(phrase.type(k + tokens), {GliderLexer::ASSIGN, GliderLexer::COLON, GliderLexer::OF});
    tokens += !right && sign ? 1U : 0U;
    if ((right || !phrase.startsLine(k)) && beginsOperand(phrase, k + tokens)) {
      return Head{lead.part, tokens, right};
    }
  }
  return std::nullopt;
}

std::optional<Head> headAt(const Phrase& phrase, size_t k) {
  if (const auto sign = signAt(phrase, k)) {
    return sign;
  }
  const auto word = wordAt(phrase, k);
  const size_t launch = tokensOfLaunch(phrase, k);
  const bool right =
      launch == 2 && phrase.type(k) == GliderLexer::AT && phrase.type(k + 1) == GliderLexer::LAUNCH;
  const bool moment = word && isMoment(phrase, k + word->tokens);
  if (launch > 0 && (right || !phrase.startsLine(k)) && (!word || moment)) {
    return Head{Part::Launch, launch, right};
  }
  return word;
}

/// `..`, `to`, `up to`, `and`, `…`: the tokens of what may stand between the ends of a range.
size_t tokensOfSeparator(const Phrase& phrase, size_t k) {
  constexpr std::array<std::string_view, 8> kWords = {"up to", "down to", "to",   "until",
                                                      "till",  "through", "thru", "and"};
  if (const size_t tokens = tokensOfOne(phrase, k, kWords)) {
    return tokens;
  }
  const std::string_view text = phrase.text(k);
  if (phrase.type(k) == GliderLexer::RANGE) {
    return phrase.text(k + 1) == "." && phrase.touches(k + 1) ? 2 : 1;  // `...`
  }
  const bool sign = text == "…" || text == "–" || text == "—" ||
                    oneOf(phrase.type(k), {GliderLexer::COMMA, GliderLexer::COLON, GliderLexer::AND,
                                           GliderLexer::ONE_AMPERSAND});
  return sign ? 1 : 0;
}

/// The tokens of an operand that begins here and is written in several: `4 h 30 min`, `2 days`.
size_t tokensOfOperand(const Phrase& phrase, size_t k) {
  const size_t number = tokensOfQuantity(phrase, k);
  const bool bare = number == 1 && phrase.type(k) == GliderLexer::NUMBER;
  if (bare && phrase.type(k + 1) == GliderLexer::NAME && !unitForWord(phrase.text(k + 1)).empty()) {
    return 2;  // `60 metres`, which is reported later
  }
  if (bare && phrase.type(k + 1) == GliderLexer::NUMBER &&
      phrase.type(k + 2) == GliderLexer::COMPASS) {
    return 3;  // `39 10.5 N`
  }
  const bool coordinate = number == 2 && phrase.type(k + 1) == GliderLexer::COMPASS;
  return coordinate ? number + tokensOfQuantity(phrase, k + number) : std::max<size_t>(number, 1);
}

}  // namespace

size_t endOfValue(const Phrase& phrase, size_t k, bool range) {
  size_t deep = 0;
  bool whole = false;    // whether a value ends here
  bool divided = false;  // whether both ends of the range have begun
  for (;;) {
    const uint32_t type = phrase.type(k);
    const bool opens = opensList(phrase, k);
    const bool closes = closesList(phrase, k);
    const bool joins = isOperator(type) ||
                       oneOf(type, {GliderLexer::AND_WORD, GliderLexer::OR_WORD,
                                    GliderLexer::ONE_AMPERSAND, GliderLexer::WRONG_COMPARISON});
    const bool ends = whole && (deep > 0 || !divided) && (range || type == GliderLexer::RANGE);
    const size_t between = ends ? tokensOfSeparator(phrase, k) : 0;
    const bool call = opens && isAnyName(phrase.type(k - 1));
    if (deep == 0 && whole && !joins && between == 0 && !call) {
      return k;
    }
    if ((isHardKeyword(type) && !joins && !startsValue(type)) || type == kEof ||
        (closes && deep == 0)) {
      return k;
    }
    deep += opens ? 1U : 0U;
    deep -= closes ? 1U : 0U;
    const bool operand = !joins && between == 0 && !opens && !closes;
    if (operand && deep == 0 && !isAnyName(type) && !startsValue(type)) {
      return k;
    }
    divided = divided || (deep == 0 && between > 0);
    whole = closes || operand;
    k += operand ? tokensOfOperand(phrase, k) : std::max<size_t>(between, 1);
  }
}

namespace {

/// Past the type that begins with token `k`.
size_t endOfType(const Phrase& phrase, size_t k) {
  if (!isName(phrase.type(k)) || wordAt(phrase, k)) {
    return k;
  }
  ++k;
  while (oneOf(phrase.type(k), {GliderLexer::TIMES, GliderLexer::DIVIDE}) &&
         isName(phrase.type(k + 1))) {
    k += 2;
  }
  return k;
}

/// `length`, `as length`, `of type length`: a type without its colon.
std::optional<Clause> typeWithoutColon(const Phrase& phrase, size_t k) {
  constexpr std::array<std::string_view, 5> kWords = {"of type", "of", "as", "is", "type"};
  size_t words = 0;
  for (const std::string_view word : kWords) {
    words = words == 0 ? tokensOfWords(phrase, k, word) : words;
  }
  const bool type = isTypeName(phrase.text(k + words)) && !phrase.startsLine(k) &&
                    !oneOf(phrase.type(k + words + 1), {GliderLexer::LPAREN, GliderLexer::COLON});
  return type ? std::optional(Clause{Part::Type, k, k + words, endOfType(phrase, k + words), false})
              : std::nullopt;
}

/// `60 m .. 180 m` without anything before it.
std::optional<Clause> rangeWithoutWord(const Phrase& phrase, size_t k) {
  const bool begins = oneOf(phrase.type(k), {GliderLexer::NUMBER, GliderLexer::MINUS,
                                             GliderLexer::LPAREN, GliderLexer::LBRACKET});
  const size_t end = begins && !phrase.startsLine(k) ? endOfValue(phrase, k, true) : k;
  return end > k && endsOf(phrase, k, end) ? std::optional(Clause{Part::Range, k, k, end, false})
                                           : std::nullopt;
}

bool compares(const Phrase& phrase, size_t first, size_t end) {
  while (first < end && !oneOf(phrase.type(first), {GliderLexer::LT, GliderLexer::LE,
                                                    GliderLexer::GT, GliderLexer::GE})) {
    ++first;
  }
  return first < end;
}

/// The part that begins with token `k`, of a line that already has those in `before`.
std::optional<Clause> clauseAt(const Phrase& phrase, size_t k, const std::vector<Clause>& before) {
  const auto has = [&](Part part) {
    return std::ranges::any_of(before, [&](const Clause& one) { return one.part == part; });
  };
  if (before.empty()) {
    if (auto type = typeWithoutColon(phrase, k)) {
      return type;
    }
  }
  auto head = headAt(phrase, k);
  if (phrase.type(k) == GliderLexer::COMMA && !before.empty()) {
    head = headAt(phrase, k + 1);  // `, by 5 m`
    head = head ? std::optional(Head{head->part, head->tokens + 1, false}) : std::nullopt;
  }
  if (!head || has(head->part)) {
    return has(Part::Range) || head ? std::nullopt : rangeWithoutWord(phrase, k);
  }
  const size_t value = k + head->tokens;
  if (head->part == Part::Launch) {
    return Clause{head->part, k, value, value, head->right};
  }
  if (head->part == Part::Type) {
    return Clause{head->part, k, value, endOfType(phrase, value), true};
  }
  const size_t end = endOfValue(phrase, value, head->part == Part::Range);
  if (head->part == Part::Condition && !head->right && !compares(phrase, value, end)) {
    return std::nullopt;  // `with care`
  }
  return Clause{head->part, k, value, end, head->right};
}

/// `choose bottom = length in …`, `choose bottom : length = 60 m .. 180 m`: `=` for another sign.
void readSign(const Phrase& phrase, Clause& clause, const std::vector<Clause>& all) {
  const bool lone = clause.end == clause.value + 1;
  if (clause.part != Part::Value) {
    return;
  }
  if (all.empty() && lone && isTypeName(phrase.text(clause.value))) {
    clause.part = Part::Type;
    clause.right = false;
  } else if (const auto ends = endsOf(phrase, clause.value, clause.end); ends && ends->right) {
    clause.part = Part::Range;
    clause.right = false;
  }
}

}  // namespace

bool mayBeginItem(const Phrase& phrase) {
  const uint32_t before = phrase.before();
  const bool whole =
      before == 0 ||
      oneOf(before, {GliderLexer::END,        GliderLexer::RETURN,   GliderLexer::EXIT,
                     GliderLexer::STAY,       GliderLexer::NAME,     GliderLexer::NUMBER,
                     GliderLexer::INSTANT,    GliderLexer::STRING,   GliderLexer::RPAREN,
                     GliderLexer::RBRACKET,   GliderLexer::UNIT,     GliderLexer::COMPASS,
                     GliderLexer::MIN,        GliderLexer::TRUE,     GliderLexer::FALSE,
                     GliderLexer::TIMES_WORD, GliderLexer::TICK,     GliderLexer::FAIRLY,
                     GliderLexer::ORDER,      GliderLexer::RESTART,  GliderLexer::OUTAGE,
                     GliderLexer::LAUNCH,     GliderLexer::ENDURANCE});
  return whole && phrase.startsLine() && phrase.open().empty();
}

std::vector<Clause> clausesOf(const Phrase& phrase, size_t first) {
  std::vector<Clause> all;
  for (size_t k = first;;) {
    auto clause = clauseAt(phrase, k, all);
    if (!clause) {
      return all;
    }
    readSign(phrase, *clause, all);
    all.push_back(*clause);
    k = clause->end;
  }
}

size_t Ends::sharedUnit(const Phrase& phrase) const {
  const bool bare = low_end == low + 1 && phrase.type(low) == GliderLexer::NUMBER;
  const bool unit = high_end == high + 2 && tokensOfNumber(phrase, high) == 2;
  return bare && unit ? high + 1 : 0;
}

std::string Ends::text(const Phrase& phrase) const {
  const size_t unit = sharedUnit(phrase);
  return fmt::format("{}{} .. {}", phrase.wholeText(low, low_end - low),
                     unit == 0 ? "" : fmt::format(" {}", phrase.text(unit)),
                     phrase.wholeText(high, high_end - high));
}

namespace {

/// Where `..` outside all parentheses stands between the two ends; `end`: nowhere.
size_t placeOfRange(const Phrase& phrase, size_t first, size_t end) {
  size_t deep = 0;
  for (size_t k = first; k < end; ++k) {
    const uint32_t type = phrase.type(k);
    deep += oneOf(type, {GliderLexer::LPAREN, GliderLexer::LBRACKET}) ? 1U : 0U;
    deep -= oneOf(type, {GliderLexer::RPAREN, GliderLexer::RBRACKET}) ? 1U : 0U;
    if (deep == 0 && type == GliderLexer::RANGE) {
      return k;
    }
  }
  return end;
}

/// The ends where no parentheses are around them.
std::optional<Ends> divided(const Phrase& phrase, size_t first, size_t end) {
  const auto isValue = [&](size_t from, size_t to) {
    return to > from &&
           (readsAsValue(phrase, from, to - from) || tokensOfOperand(phrase, from) == to - from);
  };
  if (const size_t k = placeOfRange(phrase, first, end); k != end) {
    const size_t tokens = tokensOfSeparator(phrase, k);
    return Ends{first, k, k + tokens, end, tokens == 1};
  }
  std::optional<Ends> found;
  for (size_t k = first + 1; k + 1 < end; ++k) {
    const size_t tokens = phrase.type(k) == GliderLexer::MINUS ? 1 : tokensOfSeparator(phrase, k);
    const bool ends = tokens > 0 && isValue(first, k) && isValue(k + tokens, end);
    if (ends && found) {
      return std::nullopt;  // `a - b - c`
    }
    if (ends) {
      found = Ends{first, k, k + tokens, end, false};
    }
  }
  return found;
}

}  // namespace

std::optional<Ends> endsOf(const Phrase& phrase, size_t first, size_t end) {
  if (end < first + 3) {
    return std::nullopt;
  }
  const bool list = opensList(phrase, first) && closesList(phrase, end - 1);
  if (list) {
    auto inner = endsOf(phrase, first + 1, end - 1);
    if (inner) {
      inner->right = false;
      return inner;
    }
  }
  return divided(phrase, first, end);
}

}  // namespace glider::frontend::phrases
