// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/phrase.h"

#include "frontend/parse/token_kinds.h"
#include "frontend/spelling.h"
#include "support/units/units.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace glider::frontend {
namespace {

/// How many tokens are looked at ahead: no phrase is longer, and the time that a file takes then
/// grows with its length only.
constexpr size_t kFarthest = 300;

bool isValueWord(uint32_t type) {
  return isOperator(type) || oneOf(type, {GliderLexer::TRUE, GliderLexer::FALSE,
                                          GliderLexer::AND_WORD, GliderLexer::OR_WORD});
}

/// Whether it may join two values, or stand before one.
bool joins(uint32_t type) {
  return isOperator(type) || oneOf(type, {GliderLexer::AND_WORD, GliderLexer::OR_WORD});
}

bool isUnit(uint32_t type) {
  return oneOf(type, {GliderLexer::UNIT, GliderLexer::COMPASS, GliderLexer::MIN});
}

}  // namespace

Phrase::Phrase(const std::vector<Lexeme>& in, SyntaxReporter& reporter)
    : in_(in), reporter_(reporter) {
  out_.reserve(in.size());
}

std::string Phrase::lower(size_t k) const {
  return inLowerCase(text(k));
}

bool Phrase::spells(const Lexeme& lexeme, std::string_view word) const {
  return std::ranges::equal(source().text(lexeme), word, {},
                            [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
}

bool Phrase::readsValues() const {
  return oneOf(keyword_, {GliderLexer::CASE, GliderLexer::IF, GliderLexer::ALWAYS,
                          GliderLexer::REQUIRE, GliderLexer::CONST, GliderLexer::SET});
}

bool Phrase::atEnd() const {
  return at_ >= in_.size();
}

bool Phrase::touches(size_t k) const {
  const size_t n = at_ + k;
  return n > 0 && n < in_.size() && in_[n - 1].end == in_[n].begin;
}

bool Phrase::startsLine(size_t k) const {
  const size_t n = std::min(at_ + k, in_.size() - 1);
  const uint32_t from = n == 0 ? 0 : in_[n - 1].end;
  return n == 0 ||
         source().text().substr(from, in_[n].begin - from).find('\n') != std::string_view::npos;
}

size_t Phrase::tokensOfLine() const {
  size_t k = 1;
  while (k < kFarthest && at_ + k < in_.size() && type(k) != kEof && !startsLine(k)) {
    ++k;
  }
  return k;
}

Lexeme Phrase::whole(size_t first, size_t count, uint32_t type) const {
  return {type, token(first).begin, token(first + count - 1).end};
}

bool Phrase::isDeclared(std::string_view name) {
  if (!declared_) {
    declared_.emplace();
    for (size_t i = 0; i + 1 < in_.size(); ++i) {
      if ((i > 0 && (wantsName(in_[i - 1].type) || in_[i - 1].type == GliderLexer::CHOOSE)) ||
          oneOf(in_[i + 1].type, {GliderLexer::COLON, GliderLexer::ASSIGN})) {
        declared_->insert(source().text(in_[i]));
      }
    }
  }
  return declared_->contains(name);
}

bool Phrase::isArea(std::string_view name) const {
  constexpr size_t kAfter = 4;  // `shoal: path = [`
  for (size_t i = 1; i + kAfter < in_.size(); ++i) {
    if (source().text(in_[i]) != name) {
      continue;
    }
    const bool typed = in_[i + 1].type == GliderLexer::COLON && source().text(in_[i + 2]) == "path";
    const bool list = in_[i + 1].type == GliderLexer::ASSIGN &&
                      in_[i + 2].type == GliderLexer::LBRACKET &&
                      in_[i + 3].type != GliderLexer::RBRACKET;
    if (in_[i - 1].type == GliderLexer::AS ||
        (in_[i - 1].type == GliderLexer::CONST && (typed || list))) {
      return true;
    }
  }
  return false;
}

const Lexeme* Phrase::lexemeBefore(size_t k) const {
  return k < out_.size() ? &out_[out_.size() - 1 - k] : nullptr;
}

bool Phrase::hasRead(std::initializer_list<uint32_t> types) const {
  constexpr size_t kFarthestBack = 100;
  return std::ranges::any_of(types, [&](uint32_t type) {
    return read_.at(type) > item_ && out_.size() - read_.at(type) < kFarthestBack;
  });
}

void Phrase::put(const Lexeme& lexeme) {
  out_.push_back(lexeme);
  follow(lexeme);
}

void Phrase::insert(uint32_t type) {
  const uint32_t place = out_.empty() ? 0 : out_.back().end;
  put({type, place, place});
}

bool Phrase::skip() {
  while (!supplied_.empty() && supplied_.begin()->first <= at_) {
    insert(supplied_.begin()->second);
    supplied_.erase(supplied_.begin());
  }
  const bool left_out = left_out_.contains(at_);
  at_ += left_out ? 1U : 0U;
  return left_out;
}

void Phrase::follow(const Lexeme& lexeme) {
  const uint32_t type = lexeme.type;
  if (type < read_.size()) {
    read_[type] = out_.size();
  }
  item_ = startsItem(type) ? out_.size() : item_;
  if (oneOf(type, {GliderLexer::LPAREN, GliderLexer::LBRACKET})) {
    open_.push_back({type, type == GliderLexer::LPAREN && isAnyName(before(1))});
  } else if (oneOf(type, {GliderLexer::RPAREN, GliderLexer::RBRACKET})) {
    open_.resize(open_.size() - (open_.empty() ? 0U : 1U));
  } else if (isHardKeyword(type) && !isValueWord(type) && type != GliderLexer::EVERY) {
    open_.clear();
    keyword_ = type;
    in_range_ = false;
  }
  in_range_ = in_range_ || type == GliderLexer::IN;
  case_may_begin_ = type == GliderLexer::EVENTS ||
                    (type == GliderLexer::ALWAYS && before(1) != GliderLexer::REQUIRE) ||
                    afterTransition();
}

/// `exit`, `call up` or `call up(5 m)` is the last that was read.
bool Phrase::afterTransition() const {
  const auto leads = [](uint32_t t) { return oneOf(t, {GliderLexer::GOTO, GliderLexer::CALL}); };
  if (isTransition(before()) && !leads(before()) && !wantsName(before(1))) {
    return true;
  }
  if (isAnyName(before()) && leads(before(1))) {
    return true;
  }
  if (before() != GliderLexer::RPAREN || !leads(keyword_)) {
    return false;
  }
  size_t deep = 0;
  for (size_t k = 0; k < kFarthest && before(k) != 0; ++k) {
    deep += before(k) == GliderLexer::RPAREN ? 1U : 0U;
    deep -= before(k) == GliderLexer::LPAREN ? 1U : 0U;
    if (deep == 0) {
      return isAnyName(before(k + 1)) && leads(before(k + 2));
    }
  }
  return false;
}

namespace {

/// `Wh`, `days`: a name that is a unit after a number.
bool isSoftUnit(const Phrase& phrase, size_t k) {
  const auto unit =
      phrase.type(k) == GliderLexer::NAME ? support::findUnit(phrase.text(k)) : std::nullopt;
  return unit && unit->soft;
}

}  // namespace

bool readsAsValue(const Phrase& phrase, size_t first, size_t count) {
  bool ends = false;  // whether the token before ends a value
  size_t deep = 0;
  uint32_t last = 0;
  for (size_t k = first; k < first + count; ++k) {
    const uint32_t type = phrase.type(k);
    const bool unit = last == GliderLexer::NUMBER && (isUnit(type) || isSoftUnit(phrase, k));
    const bool more_unit = last == GliderLexer::DIVIDE && isUnit(type);
    if (type == GliderLexer::LPAREN) {
      if (ends && !isAnyName(last)) {
        return false;
      }
      ++deep;
      ends = false;
    } else if (type == GliderLexer::RPAREN) {
      if (deep == 0) {
        return false;
      }
      --deep;
      ends = true;
    } else if (type == GliderLexer::COMMA) {
      if (deep == 0 || !ends) {
        return false;
      }
      ends = false;
    } else if (joins(type)) {
      const bool sign = oneOf(type, {GliderLexer::MINUS, GliderLexer::NOT, GliderLexer::NOT_WORD});
      if (!ends && !sign) {
        return false;
      }
      ends = false;
    } else if (unit || more_unit) {
      ends = true;
    } else if (startsValue(type) || type == GliderLexer::MIN) {
      const bool second = isUnit(last) && type == GliderLexer::NUMBER;  // `39 N 73 W`
      if (ends && !second) {
        return false;
      }
      ends = true;
    } else {
      return false;
    }
    last = type;
  }
  return ends && deep == 0;
}

size_t tokensOfValue(const Phrase& phrase, size_t first, bool conditions) {
  size_t deep = 0;
  size_t k = first;
  for (;; ++k) {
    const uint32_t type = phrase.type(k);
    const bool name = type == GliderLexer::NAME;
    const bool logical = oneOf(type, {GliderLexer::AND, GliderLexer::OR, GliderLexer::AND_WORD,
                                      GliderLexer::OR_WORD}) ||
                         (name && (phrase.says(k, "and") || phrase.says(k, "or")));
    const bool value = startsValue(type) || isAnyName(type) || joins(type) ||
                       oneOf(type, {GliderLexer::LPAREN, GliderLexer::RPAREN, GliderLexer::COMMA});
    if (k - first >= kFarthest) {
      return 0;
    }
    if (!value || (deep == 0 && ((logical && conditions) || type == GliderLexer::COMMA ||
                                 type == GliderLexer::RPAREN))) {
      return k - first;
    }
    deep += type == GliderLexer::LPAREN ? 1U : 0U;
    deep -= type == GliderLexer::RPAREN ? 1U : 0U;
  }
}

size_t tokensOfNumber(const Phrase& phrase, size_t first) {
  const size_t sign = phrase.type(first) == GliderLexer::MINUS ? 1 : 0;
  if (phrase.type(first + sign) != GliderLexer::NUMBER) {
    return 0;
  }
  return sign + (isUnit(phrase.type(first + sign + 1)) ? 2 : 1);
}

size_t firstOf(Phrase& phrase, std::initializer_list<PhraseRepair> repairs) {
  for (const PhraseRepair repair : repairs) {
    if (const size_t taken = repair(phrase)) {
      return taken;
    }
  }
  return 0;
}

namespace {

/// `2 days`: a number with a unit that is a name elsewhere.
size_t tokensWithSoftUnit(const Phrase& phrase, size_t first) {
  const size_t tokens = tokensOfNumber(phrase, first);
  const bool bare = tokens > 0 && phrase.type(first + tokens - 1) == GliderLexer::NUMBER;
  return tokens + (bare && isSoftUnit(phrase, first + tokens) ? 1 : 0);
}

}  // namespace

size_t tokensOfQuantity(const Phrase& phrase, size_t first) {
  size_t tokens = tokensWithSoftUnit(phrase, first);
  while (tokens > 1 && phrase.type(first + tokens) == GliderLexer::DIVIDE &&
         isUnit(phrase.type(first + tokens + 1))) {
    tokens += 2;
  }
  // `4 h 30 min`: each part is of a smaller unit.
  constexpr std::array<std::string_view, 5> kTimes = {"s", "min", "h", "day", "days"};
  const auto rank = [&](size_t k) {
    return std::ranges::find(kTimes, phrase.text(k)) - kTimes.begin();
  };
  const auto none = static_cast<std::ptrdiff_t>(kTimes.size());
  while (tokens > 1 && tokensOfNumber(phrase, first + tokens) == 2 &&
         rank(first + tokens - 1) != none && rank(first + tokens + 1) < rank(first + tokens - 1)) {
    tokens += 2;
  }
  return tokens;
}

size_t tokensOfWords(const Phrase& phrase, size_t k, std::string_view words) {
  size_t tokens = 0;
  while (!words.empty()) {
    const size_t end = std::min(words.find(' '), words.size());
    const uint32_t type = phrase.type(k + tokens);
    const bool word = isAnyName(type) || isHardKeyword(type);
    if (!word || !phrase.says(k + tokens, words.substr(0, end))) {
      return 0;
    }
    words.remove_prefix(std::min(end + 1, words.size()));
    ++tokens;
  }
  return tokens;
}

size_t tokensOfOne(const Phrase& phrase, size_t k, std::span<const std::string_view> words) {
  for (const std::string_view one : words) {
    if (const size_t tokens = tokensOfWords(phrase, k, one)) {
      return tokens;
    }
  }
  return 0;
}

size_t tokensOfArrow(const Phrase& phrase, size_t k) {
  if (phrase.type(k) == GliderLexer::MINUS) {
    const size_t line = phrase.type(k + 1) == GliderLexer::MINUS && phrase.touches(k + 1) ? 2 : 1;
    return phrase.type(k + line) == GliderLexer::GT && phrase.touches(k + line) ? line + 1 : 0;
  }
  const std::string_view text = phrase.text(k);
  const bool sign = (phrase.type(k) == GliderLexer::WRONG_COMPARISON && text == "=>") ||
                    (phrase.type(k) == GliderLexer::FOREIGN && (text == "→" || text == "⇒"));
  return sign ? 1 : 0;
}

}  // namespace glider::frontend
