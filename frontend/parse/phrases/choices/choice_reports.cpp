// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/choices/choice_line.h"
#include "frontend/parse/phrases/written_type.h"
#include "frontend/parse/token_kinds.h"
#include "frontend/spelling.h"
#include "support/diagnostics/ids/meaning.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

// What is said of each error in a line `choose`.

namespace glider::frontend::phrases {

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

/// `in 60 m, 80 m, 100 m`: values to choose from, of which two would be a range.
bool ChoiceLine::reportValues(const Clause& clause) {
  size_t end = clause.end;
  while (phrase_.type(end) == GliderLexer::COMMA && tokensOfNumber(phrase_, end + 1) > 0) {
    end += 1 + tokensOfNumber(phrase_, end + 1);
  }
  if (end == clause.end || phrase_.startsLine(clause.end)) {
    return false;
  }
  const Lexeme list = phrase_.whole(clause.value, end - clause.value);
  phrase_.reporter()
      .at(list, support::diagnostics::notARange, phrase_.source().text(list), "")
      .hint(
          "values to choose from are a range, and how far they are apart: "
          "`in LOWEST .. HIGHEST by STEP`");
  values_end_ = end;
  as_meant_ = false;
  return true;
}

/// `from 60 m to 180 m`, `in 60 m - 180 m`, `= 60 m .. 180 m`, `60 m .. 180 m`.
void ChoiceLine::reportRange(const Clause& clause) {
  if (reportValues(clause)) {
    return;
  }
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

}  // namespace glider::frontend::phrases
