// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/choices/choice_line.h"
#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/phrases/written_type.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace glider::frontend::phrases {

std::string_view leadOf(Part part) {
  switch (part) {
    case Part::Type:
      return ":";
    case Part::Value:
      return "=";
    case Part::Range:
      return "in";
    case Part::Step:
      return "by";
    case Part::Condition:
      return "where";
    case Part::Launch:
      break;
  }
  return "at launch";
}

uint32_t leadType(Part part) {
  switch (part) {
    case Part::Type:
      return GliderLexer::COLON;
    case Part::Value:
      return GliderLexer::ASSIGN;
    case Part::Range:
      return GliderLexer::IN;
    case Part::Step:
      return GliderLexer::BY;
    case Part::Condition:
      return GliderLexer::WHERE;
    case Part::Launch:
      break;
  }
  return GliderLexer::AT;
}

const Clause* ChoiceLine::find(Part part) const {
  const auto found = std::ranges::find(clauses_, part, &Clause::part);
  return found == clauses_.end() ? nullptr : &*found;
}

/// A clause as it is written, with the words that lead it.
std::string ChoiceLine::text(const Clause& clause) const {
  if (clause.part == Part::Launch) {
    return std::string(leadOf(clause.part));
  }
  const auto ends =
      clause.part == Part::Range ? endsOf(phrase_, clause.value, clause.end) : std::nullopt;
  const std::string value =
      ends ? ends->text(phrase_)
           : std::string(clause.end == clause.value
                             ? std::string_view("…")
                             : phrase_.wholeText(clause.value, clause.end - clause.value));
  return fmt::format("{} {}", leadOf(clause.part), value);
}

/// All clauses in their order.
std::string ChoiceLine::sorted() const {
  std::vector<Clause> all = clauses_;
  std::ranges::stable_sort(all, {}, &Clause::part);
  std::string line;
  for (const Clause& one : all) {
    line += (line.empty() ? "" : " ") + text(one);
  }
  return line;
}

/// The type of the ends of the range, or of the value, by their unit; empty: not known.
std::string_view ChoiceLine::unitType() const {
  const Clause* range = find(Part::Range);
  const Clause* value = find(Part::Value);
  const auto ends = range != nullptr ? endsOf(phrase_, range->value, range->end) : std::nullopt;
  if (!ends) {
    return value != nullptr ? typeOf(phrase_, value->value) : "";
  }
  const auto ofEnd = [&](size_t first, size_t end) -> std::string_view {
    const size_t sign = phrase_.type(first) == GliderLexer::MINUS ? 1 : 0;
    if (tokensOfQuantity(phrase_, first) != end - first) {
      return "";
    }
    const size_t unit = first + sign + 1;
    return typeOfUnit(unit < end ? phrase_.wholeText(unit, end - unit) : "");
  };
  const std::string_view high = ofEnd(ends->high, ends->high_end);
  const std::string_view low = ofEnd(ends->low, ends->low_end);
  return high == low || low == "number" ? high : "";  // `1 .. 180 m`
}

/// Whether nothing follows the clauses that is not read as a part of the line.
bool ChoiceLine::endsLine() const {
  const uint32_t type = phrase_.type(end());
  return phrase_.startsLine(end()) || isHardKeyword(type) || type == kEof;
}

/// `choose in 60 m .. 180 m`, `choose : length in …`, `choose 60 m .. 180 m`.
bool ChoiceLine::lacksName() const {
  const size_t colon = phrase_.type(1) == GliderLexer::COLON ? 1 : 0;
  const bool type = colon == 1 && isTypeName(phrase_.text(2)) &&
                    oneOf(phrase_.type(3), {GliderLexer::IN, GliderLexer::ASSIGN});
  const bool range = phrase_.type(1) == GliderLexer::IN && tokensOfNumber(phrase_, 2) > 0;
  return !phrase_.startsLine(1) && (type || range || tokensOfNumber(phrase_, 1) > 0);
}

bool ChoiceLine::readName() {
  const size_t colon = phrase_.type(1) == GliderLexer::COLON ? 1 : 0;
  name_ = 1 + colon;
  const bool typed = isTypeName(phrase_.text(name_)) && !phrase_.startsLine(name_ + 1) &&
                     phrase_.type(name_ + 1) == GliderLexer::NAME;
  name_ += typed ? 1 : 0;
  name_end_ = name_ + 1;
  if (!isAnyName(phrase_.type(name_)) || phrase_.startsLine(1) || lacksName() ||
      phrase_.type(name_end_) == GliderLexer::LPAREN) {
    return false;
  }
  // `deep bottom : length`
  while (phrase_.type(name_end_) == GliderLexer::NAME && !phrase_.startsLine(name_end_) &&
         !isTypeName(phrase_.text(name_end_)) &&
         oneOf(phrase_.type(name_end_ + 1), {GliderLexer::NAME, GliderLexer::COLON})) {
    ++name_end_;
  }
  for (size_t k = name_; k < name_end_; ++k) {
    named_ += fmt::format("{}{}", named_.empty() ? "" : "_", phrase_.text(k));
  }
  after_name_ = name_end_;
  if (phrase_.type(name_end_) == GliderLexer::LBRACKET) {
    while (after_name_ < name_end_ + 8 && phrase_.type(after_name_ - 1) != GliderLexer::RBRACKET) {
      ++after_name_;
    }
    return phrase_.type(after_name_ - 1) == GliderLexer::RBRACKET;
  }
  while (oneOf(phrase_.type(after_name_), {GliderLexer::COMMA, GliderLexer::AND_WORD}) &&
         isAnyName(phrase_.type(after_name_ + 1))) {
    after_name_ += 2;
  }
  return true;
}

void ChoiceLine::putRange(const Clause& clause) {
  const auto ends = endsOf(phrase_, clause.value, clause.end);
  if (!ends) {  // a list: any range
    const Lexeme list = phrase_.whole(clause.value, clause.end - clause.value, GliderLexer::NAME);
    phrase_.put(list);
    phrase_.insert(GliderLexer::RANGE);
    phrase_.put(list);
    return;
  }
  for (size_t k = ends->low; k < ends->low_end; ++k) {
    phrase_.put(phrase_.token(k));
  }
  if (const size_t unit = ends->sharedUnit(phrase_); unit != 0) {
    phrase_.put(phrase_.token(unit));
  }
  const Lexeme between = phrase_.whole(ends->low_end, ends->high - ends->low_end);
  phrase_.put({GliderLexer::RANGE, between.begin, between.end});
  for (size_t k = ends->high; k < ends->high_end; ++k) {
    phrase_.put(phrase_.token(k));
  }
}

void ChoiceLine::putClause(const Clause& clause) {
  const Lexeme first = phrase_.token(clause.first);
  const uint32_t end =
      clause.value > clause.first ? phrase_.token(clause.value - 1).end : first.begin;
  phrase_.put({leadType(clause.part), first.begin, end});
  if (clause.part == Part::Launch) {
    phrase_.put({GliderLexer::LAUNCH, first.begin, end});
  } else if (clause.part == Part::Range) {
    putRange(clause);
  } else if (clause.value == clause.end) {
    phrase_.put({GliderLexer::NAME, phrase_.token(name_).begin, phrase_.token(name_).end});
  } else {
    for (size_t k = clause.value; k < clause.end; ++k) {
      phrase_.put(phrase_.token(k));
    }
  }
}

/// Puts the line that was meant. What it lacks was reported: the name stands for it.
void ChoiceLine::put() {
  const Lexeme name = phrase_.whole(name_, name_end_ - name_, GliderLexer::NAME);
  phrase_.put({GliderLexer::CHOOSE, phrase_.token().begin, phrase_.token().end});
  phrase_.put(name);
  if (find(Part::Type) == nullptr) {
    phrase_.insert(GliderLexer::COLON);
    phrase_.put(name);
  }
  bool range = find(Part::Range) != nullptr;
  std::vector<Clause> all = clauses_;
  std::ranges::stable_sort(all, {}, &Clause::part);
  const auto putName = [&] {
    phrase_.insert(GliderLexer::IN);
    phrase_.put(name);
    phrase_.insert(GliderLexer::RANGE);
    phrase_.put(name);
    range = true;
  };
  for (const Clause& clause : all) {
    if (!range && clause.part > Part::Range) {
      putName();
    }
    putClause(clause);
  }
  if (!range) {
    putName();
  }
  if (!as_meant_) {
    phrase_.notAsMeant();
  }
}

/// `select bottom : length in 60 m .. 180 m`. False: the line may be something else.
bool ChoiceLine::reportVerb() {
  if (phrase_.type() == GliderLexer::CHOOSE) {
    return true;
  }
  const Clause* range = find(Part::Range);
  if (range == nullptr || !endsOf(phrase_, range->value, range->end) || !endsLine()) {
    return false;
  }
  const Lexeme word = phrase_.token();
  phrase_.reporter()
      .at(word, support::diagnostics::misspelledKeyword, phrase_.text(), "choose")
      .fix(phrase_.source().range(word), "choose");
  return true;
}

size_t ChoiceLine::repair() {
  if (phrase_.type() == GliderLexer::CHOOSE && lacksName()) {
    return reportLackOfName();
  }
  if (!readName()) {
    return 0;
  }
  clauses_ = clausesOf(phrase_, after_name_);
  const bool typed = name_ > 1 + (phrase_.type(1) == GliderLexer::COLON ? 1U : 0U);
  if (clauses_.empty() && !endsLine()) {
    return 0;
  }
  const size_t before = phrase_.reporter().count();
  if (!reportVerb()) {
    return 0;
  }
  reportName();
  as_meant_ = as_meant_ && !typed;
  if (phrase_.type(name_end_) == GliderLexer::LBRACKET) {
    reportArray();
  } else if (after_name_ > name_end_) {
    reportNames();
  }
  if (typed || !reportOrder()) {
    reportClauses(typed);
  }
  reportRest();
  if (phrase_.reporter().count() == before) {
    return 0;
  }
  put();
  size_t tokens = std::max(end(), values_end_);
  const bool rest = !endsLine() && phrase_.type(tokens) == GliderLexer::NAME;
  return rest ? std::max(tokens, phrase_.tokensOfLine()) : tokens;
}

size_t choice(Phrase& phrase) {
  constexpr std::array<std::string_view, 17> kWords = {
      "choose",   "chooses",  "chose", "chosen", "choice", "select", "pick",   "decide", "option",
      "optimise", "optimize", "tune",  "vary",   "plan",   "find",   "search", "free"};
  const bool begins = phrase.type() == GliderLexer::CHOOSE ||
                      (isAnyName(phrase.type(1)) && std::ranges::any_of(kWords, [&](auto word) {
                         return phrase.says(0, word);
                       }));
  return begins && mayBeginItem(phrase) ? ChoiceLine(phrase).repair() : 0;
}

}  // namespace glider::frontend::phrases
