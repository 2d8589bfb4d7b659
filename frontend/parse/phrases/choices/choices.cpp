// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/choices/clauses.h"
#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/phrases/written_type.h"
#include "frontend/parse/token_kinds.h"
#include "frontend/spelling.h"
#include "support/diagnostics/ids/meaning.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace glider::frontend::phrases {
namespace {

/// A line `choose`, whose errors are reported one by one. What was meant is put in its place.
class ChoiceLine {
 public:
  explicit ChoiceLine(Phrase& phrase) : phrase_(phrase) {}

  /// The tokens of the line; 0: nothing in it is wrong, or it is none.
  size_t repair();

 private:
  [[nodiscard]] bool lacksName() const;
  size_t reportLackOfName();
  bool readName();
  bool reportVerb();
  void reportName();
  void reportArray();
  void reportNames();
  void reportClauses(bool typed);
  void reportClause(const Clause& clause);
  void reportType(const Clause& clause);
  void reportRange(const Clause& clause);
  void reportList(const Clause& clause);
  void reportLaunch(const Clause& clause);
  void reportWithoutType();
  void reportWithoutRange();
  bool reportOrder();
  void reportRest();
  void put();
  void putClause(const Clause& clause);
  void putRange(const Clause& clause);

  [[nodiscard]] const Clause* find(Part part) const;
  [[nodiscard]] std::string text(const Clause& clause) const;
  [[nodiscard]] std::string sorted() const;
  [[nodiscard]] std::string_view unitType() const;
  [[nodiscard]] std::string evenly(const Clause& clause) const;
  [[nodiscard]] bool endsLine() const;
  [[nodiscard]] size_t end() const { return clauses_.empty() ? after_name_ : clauses_.back().end; }
  [[nodiscard]] support::SourceRange range(size_t first, size_t end) const {
    return phrase_.source().range(phrase_.whole(first, end - first));
  }

  Phrase& phrase_;
  size_t name_ = 1;        ///< the first token of the name
  size_t name_end_ = 2;    ///< past its last
  size_t after_name_ = 2;  ///< past what stands where a name should
  std::string named_;      ///< the name that was meant
  std::vector<Clause> clauses_;
  bool as_meant_ = true;
};

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

/// Reports that, and leaves out the line.
size_t ChoiceLine::reportLackOfName() {
  const Lexeme found = phrase_.token(1);
  phrase_.reporter()
      .at(found, support::diagnostics::unexpectedToken, "a name", describe(phrase_.source(), found))
      .hint("write `choose NAME : TYPE in LOWEST .. HIGHEST`");
  phrase_.put(phrase_.token());
  phrase_.insert(GliderLexer::NAME);
  return phrase_.tokensOfLine();
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

/// `choose: bottom …`, `choose length bottom …`, `choose deep bottom : …`.
void ChoiceLine::reportName() {
  const Clause* type = find(Part::Type);
  const size_t colon = phrase_.type(1) == GliderLexer::COLON ? 1 : 0;
  const Lexeme found = phrase_.token(1);
  if (name_ > 1 + colon) {
    const std::string better = fmt::format("{} : {}", named_, phrase_.text(1 + colon));
    auto report =
        phrase_.reporter().at(phrase_.token(1 + colon), support::diagnostics::unexpectedToken,
                              "a name", fmt::format("the type `{}`", phrase_.text(1 + colon)));
    report.hint(fmt::format("write `choose {}`", better)).fix(range(1, name_end_), better);
  } else if (colon > 0 && type != nullptr && !type->right) {
    const std::string better = fmt::format("{} {}", named_, text(*type));
    phrase_.reporter()
        .at(found, support::diagnostics::unexpectedToken, "a name",
            describe(phrase_.source(), found))
        .hint(fmt::format("write `choose {}`", better))
        .fix(range(1, type->end), better);
  } else if (colon > 0) {
    phrase_.reporter()
        .at(found, support::diagnostics::superfluousWord, phrase_.text(1), "after `choose`")
        .fix(phrase_.source().range(found), "");
  } else if (name_end_ > name_ + 1) {
    const std::string_view written = phrase_.wholeText(name_, name_end_ - name_);
    auto report = phrase_.reporter().at(phrase_.whole(name_, name_end_ - name_),
                                        support::diagnostics::nameNotOneWord, written,
                                        fmt::format("write `choose {} : …`", named_));
    if (!phrase_.isDeclared(named_)) {
      report.fix(range(name_, name_end_), named_);
    }
    as_meant_ = false;
  }
}

/// `choose bottom[2] : …`.
void ChoiceLine::reportArray() {
  const Lexeme found = phrase_.token(name_end_);
  phrase_.reporter()
      .at(phrase_.whole(name_end_, after_name_ - name_end_), support::diagnostics::unexpectedToken,
          "`:` and a type", describe(phrase_.source(), found))
      .hint(fmt::format("a choice is one value: write a line for each, as in `choose {0}_0 …` and "
                        "`choose {0}_1 …`",
                        named_));
  as_meant_ = false;
}

/// `choose top, bottom : …`.
void ChoiceLine::reportNames() {
  const Lexeme found = phrase_.token(name_end_);
  const bool right = std::ranges::all_of(clauses_, &Clause::right);
  const bool range = find(Part::Type) != nullptr && find(Part::Range) != nullptr;
  auto report = phrase_.reporter().at(found, support::diagnostics::unexpectedToken,
                                      "`:` and a type", describe(phrase_.source(), found));
  report.hint("each choice has a line of its own: write `choose` once for each name");
  if (right && range && endsLine()) {
    std::string lines;
    for (size_t k = name_; k < after_name_; k += 2) {
      lines += fmt::format("{}{} {}", lines.empty() ? "" : "\nchoose ", phrase_.text(k), sorted());
    }
    report.fix(this->range(name_, end()), lines);
  }
  as_meant_ = false;
}

/// `= length`, `as length`, `: depth`, `:`.
void ChoiceLine::reportType(const Clause& clause) {
  const bool colon_first = phrase_.type(1) == GliderLexer::COLON;
  if (clause.value == clause.end) {
    return reportWithoutType();
  }
  if (!clause.right && !colon_first) {
    const Lexeme found = phrase_.token(clause.first);
    phrase_.reporter()
        .at(found, support::diagnostics::unexpectedToken, "`:`", describe(phrase_.source(), found))
        .hint(fmt::format("write `choose {} {} …`", named_, text(clause)))
        .fix({phrase_.source().file, phrase_.token(clause.first - 1).end,
              phrase_.token(clause.value).begin},
             " : ");
  }
  const std::string_view type = unitType();
  const std::string_view written = phrase_.text(clause.value);
  const bool name =
      clause.end == clause.value + 1 && phrase_.type(clause.value) == GliderLexer::NAME;
  if (name && !isTypeName(written) && !type.empty()) {
    const Lexeme found = phrase_.token(clause.value);
    phrase_.reporter()
        .at(found, support::diagnostics::unknownType, written, fmt::format("write `{}`", type))
        .fix(phrase_.source().range(found), std::string(type));
    as_meant_ = false;
  }
}

/// `choose bottom in 60 m .. 180 m`, `choose bottom : 60 m .. 180 m`.
void ChoiceLine::reportWithoutType() {
  const std::string_view type = unitType();
  const Clause* colon = find(Part::Type);
  const Clause* value = find(Part::Value);
  const auto range = std::ranges::find(clauses_, Part::Range, &Clause::part);
  const Lexeme name = phrase_.whole(name_, name_end_ - name_);
  std::string rest = range == clauses_.end() ? " in LOWEST .. HIGHEST" : " in …";
  if (value != nullptr) {
    rest = fmt::format(" {} …", text(*value));
  }
  auto report = phrase_.reporter().at(name, support::diagnostics::withoutType, named_);
  report.hint(fmt::format("write `choose {} : {}{}`", named_,
                          type.empty() ? std::string_view("TYPE") : type, rest));
  as_meant_ = false;
  const bool lone = range != clauses_.end() && range->value == range->first;
  if (lone) {
    range->right = true;  // its word is missing with the type
  }
  if (type.empty()) {
    return;
  }
  const bool assigns = value != nullptr && !value->right;  // `:= 60 m`
  const uint32_t from = phrase_.token((colon != nullptr ? colon->value : after_name_) - 1).end;
  const uint32_t to = assigns ? phrase_.token(value->value).begin
                      : lone  ? phrase_.token(range->value).begin
                              : from;
  report.fix({phrase_.source().file, from, to},
             fmt::format("{} {}{}", colon != nullptr ? "" : " :", type,
                         assigns ? " = "
                         : lone  ? " in "
                                 : ""));
}

/// The range of a list whose values are equally far apart, with its step: `60 m .. 100 m by 20 m`;
/// empty: they are not.
std::string ChoiceLine::evenly(const Clause& clause) const {
  std::vector<double> values;
  std::string unit;
  for (size_t k = clause.value + 1; k < clause.end; ++k) {
    const size_t tokens = tokensOfNumber(phrase_, k);
    if (tokens == 0 || phrase_.type(k) != GliderLexer::NUMBER) {
      return "";
    }
    values.push_back(std::strtod(std::string(phrase_.text(k)).c_str(), nullptr));
    const std::string own(tokens > 1 ? phrase_.text(k + 1) : "");
    if (!unit.empty() && !own.empty() && own != unit) {
      return "";
    }
    unit = own.empty() ? unit : own;
    k += tokens;
  }
  const double step = values.size() > 2 ? values[1] - values[0] : 0;
  for (size_t i = 1; i < values.size(); ++i) {
    if (!(step > 0) || values[i] - values[i - 1] != step) {
      return "";
    }
  }
  const std::string with = unit.empty() ? "" : " " + unit;
  return step > 0 ? fmt::format("{}{} .. {}{} by {}{}", values.front(), with, values.back(), with,
                                step, with)
                  : "";
}

/// `in [60 m, 80 m, 100 m]`.
void ChoiceLine::reportList(const Clause& clause) {
  const std::string better = find(Part::Step) == nullptr ? evenly(clause) : "";
  const Lexeme list = phrase_.whole(clause.value, clause.end - clause.value);
  auto report = phrase_.reporter().at(list, support::diagnostics::notARange,
                                      phrase_.source().text(list), better);
  if (better.empty()) {
    report.hint(
        "values to choose from are a range, and how far they are apart: "
        "`in LOWEST .. HIGHEST by STEP`");
  } else {
    report.fix(range(clause.first, clause.end), "in " + better);
  }
  as_meant_ = false;
}

/// `from 60 m to 180 m`, `in 60 m - 180 m`, `= 60 m .. 180 m`, `60 m .. 180 m`.
void ChoiceLine::reportRange(const Clause& clause) {
  const auto ends = endsOf(phrase_, clause.value, clause.end);
  const bool brackets =
      phrase_.type(clause.value) == GliderLexer::LBRACKET || phrase_.text(clause.value) == "{";
  if (!ends) {
    if (brackets) {
      return reportList(clause);
    }
    if (endsLine() && clause.end > clause.value) {
      const Lexeme written = phrase_.whole(clause.value, clause.end - clause.value);
      const std::string_view text = phrase_.source().text(written);
      phrase_.reporter().at(written, support::diagnostics::notARange, text,
                            fmt::format("in {} .. HIGHEST", text));
      as_meant_ = false;
    }
    return;
  }
  const std::string better = "in " + ends->text(phrase_);
  const bool comma = brackets && phrase_.type(ends->low_end) == GliderLexer::COMMA;
  if (!ends->right) {
    const size_t first = clause.right ? clause.value : clause.first;
    const Lexeme written = phrase_.whole(first, clause.end - first);
    auto report = phrase_.reporter().at(written, support::diagnostics::notARange,
                                        phrase_.source().text(written),
                                        clause.right ? better.substr(3) : better);
    if (!comma) {  // `[60 m, 180 m]` may be two values
      report.fix(range(clause.first, clause.end), better);
    }
    return;
  }
  const Lexeme found = phrase_.token(clause.first);
  const size_t words = clause.value - clause.first;
  phrase_.reporter()
      .at(words > 0 ? phrase_.whole(clause.first, words) : found,
          support::diagnostics::unexpectedToken, "`in`",
          words > 0 ? fmt::format("`{}`", phrase_.wholeText(clause.first, words))
                    : describe(phrase_.source(), found))
      .hint(fmt::format("write `{}`", better))
      .fix({phrase_.source().file, found.begin, phrase_.token(clause.value).begin}, "in ");
}

/// `on launch`, `at surfacing`.
void ChoiceLine::reportLaunch(const Clause& clause) {
  const auto says = [&](std::string_view word) {
    for (size_t k = clause.first; k < clause.end; ++k) {
      if (phrase_.says(k, word)) {
        return true;
      }
    }
    return false;
  };
  const bool launch = !says("after") && !says("during") && !says("every") && !says("each") &&
                      (says("launch") || says("start") || says("deployment") || says("departure") ||
                       closest(phrase_.text(clause.end - 1), {"launch", "start"}) != "");
  auto report = phrase_.reporter().at(
      phrase_.whole(clause.first, clause.end - clause.first), support::diagnostics::unexpectedToken,
      "`at launch`",
      fmt::format("`{}`", phrase_.wholeText(clause.first, clause.end - clause.first)));
  if (launch) {
    report.hint("write `at launch`").fix(range(clause.first, clause.end), "at launch");
  } else {
    report.hint(
        "what is chosen stays the same for the whole mission: write `at launch`, or delete "
        "it; for a value that changes, use a `var`");
  }
}

void ChoiceLine::reportClause(const Clause& clause) {
  if (clause.part == Part::Type) {
    return reportType(clause);
  }
  if (clause.part == Part::Range && (!clause.right || !endsOf(phrase_, clause.value, clause.end) ||
                                     !endsOf(phrase_, clause.value, clause.end)->right)) {
    return reportRange(clause);
  }
  if (clause.right || (clause.part == Part::Value && clause.value == clause.first + 2)) {
    return;
  }
  const bool comma = phrase_.type(clause.first) == GliderLexer::COMMA;
  const uint32_t second = phrase_.type(clause.first + 1);
  if (comma && (second == leadType(clause.part) || second == GliderLexer::ASSIGN)) {
    const Lexeme sign = phrase_.token(clause.first);
    phrase_.reporter()
        .at(sign, support::diagnostics::superfluousWord, ",", "between the parts of a choice")
        .fix(phrase_.source().range(sign), "");
    return;
  }
  if (clause.part == Part::Launch) {
    return reportLaunch(clause);
  }
  const Lexeme words = phrase_.whole(clause.first, clause.value - clause.first);
  phrase_.reporter()
      .at(words, support::diagnostics::unexpectedToken, fmt::format("`{}`", leadOf(clause.part)),
          fmt::format("`{}`", phrase_.source().text(words)))
      .hint(fmt::format("write `{}`", text(clause)))
      .fix({phrase_.source().file, phrase_.token(clause.first - 1).end, words.end},
           fmt::format(" {}", leadOf(clause.part)));
}

/// `choose bottom : length = 60 m`.
void ChoiceLine::reportWithoutRange() {
  const Clause* value = find(Part::Value);
  const size_t first = clauses_.back().value;
  const Lexeme last = phrase_.whole(std::min(first, end() - 1), end() - std::min(first, end() - 1));
  const std::string line = fmt::format("choose {} {}", named_, sorted());
  auto report =
      phrase_.reporter().at(last, support::diagnostics::unexpectedToken,
                            fmt::format("`in` and a range after `{}`", phrase_.source().text(last)),
                            describe(phrase_.source(), phrase_.token(end())));
  report.hint(value == nullptr || clauses_.size() > 2
                  ? "write what can be chosen: `in LOWEST .. HIGHEST`"
                  : fmt::format("write what can be chosen: `{} in LOWEST .. HIGHEST`; what cannot "
                                "be chosen is a `const`",
                                line));
  as_meant_ = false;
}

/// `by 5 m in 60 m .. 180 m`: the whole line is shown, and so all that is wrong with its words.
bool ChoiceLine::reportOrder() {
  const auto wrong = std::ranges::adjacent_find(
      clauses_, [](const Clause& a, const Clause& b) { return a.part > b.part; });
  if (wrong == clauses_.end()) {
    return false;
  }
  const Clause& early = *wrong;
  const Clause& late = *(wrong + 1);
  const bool typed = find(Part::Type) != nullptr;
  const std::string_view type = typed ? "" : unitType();
  const std::string better =
      typed ? sorted() : fmt::format(": {} {}", type.empty() ? "TYPE" : type, sorted());
  auto report = phrase_.reporter().at(phrase_.whole(early.first, early.end - early.first),
                                      support::diagnostics::headerOrder,
                                      phrase_.wholeText(early.first, early.end - early.first),
                                      fmt::format("after `{}`", text(late)));
  report.hint(fmt::format("write `choose {} {}`", named_, better));
  if (typed || !type.empty()) {
    report.fix(range(clauses_.front().first, end()), better);
  }
  as_meant_ = false;
  return true;
}

/// Words after the last part of the line.
void ChoiceLine::reportRest() {
  if (endsLine() || phrase_.type(end()) != GliderLexer::NAME || find(Part::Range) == nullptr) {
    return;
  }
  as_meant_ = false;
  const Lexeme found = phrase_.token(end());
  if (editDistance(phrase_.text(end()), "where") == 1) {
    phrase_.reporter()
        .at(found, support::diagnostics::misspelledKeyword, phrase_.text(end()), "where")
        .fix(phrase_.source().range(found), "where");
    return;
  }
  if (clauses_.back().part == Part::Step &&
      (phrase_.says(end(), "steps") || phrase_.says(end(), "apart"))) {
    phrase_.reporter()
        .at(found, support::diagnostics::superfluousWord, phrase_.text(end()), "after `by …`")
        .fix(phrase_.source().range(found), "");
    return;
  }
  phrase_.reporter()
      .at(found, support::diagnostics::unexpectedToken,
          "`by`, `where`, `at launch` or another line", describe(phrase_.source(), found))
      .hint(
          "a choice is `choose NAME : TYPE in LOWEST .. HIGHEST by STEP where CONDITION at "
          "launch`");
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

void ChoiceLine::reportClauses(bool typed) {
  if (find(Part::Type) == nullptr && !typed) {
    reportWithoutType();
  }
  for (const Clause& clause : clauses_) {
    reportClause(clause);
  }
  if (find(Part::Range) == nullptr && find(Part::Type) != nullptr && endsLine()) {
    reportWithoutRange();
  }
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
  size_t tokens = end();
  const bool rest = !endsLine() && phrase_.type(tokens) == GliderLexer::NAME;
  return rest ? std::max(tokens, phrase_.tokensOfLine()) : tokens;
}

}  // namespace

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
