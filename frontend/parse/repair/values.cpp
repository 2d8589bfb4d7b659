// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/repair/values.h"

#include "frontend/parse/token_kinds.h"
#include "frontend/spelling.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace glider::frontend {

namespace {

/// The keyword that `word` may be meant as. One of two letters is near every other.
std::string_view keywordNear(std::string_view word) {
  constexpr size_t kShortest = 3;
  return word.size() < kShortest ? std::string_view() : closest(word, hardKeywords());
}

bool isKeywordInCapitals(std::string_view word) {
  return keywordType(inLowerCase(word)) != 0;
}

/// Whether both are units of time, and the second is smaller: `3 h 30 min` is one duration.
bool isSmallerTime(std::string_view unit, std::string_view next) {
  constexpr std::array<std::string_view, 4> kTimes = {"day", "h", "min", "s"};
  const auto* first = std::ranges::find(kTimes, unit == "days" ? "day" : unit);
  const auto* second = std::ranges::find(kTimes, next);
  return second != kTimes.end() && first < second;
}

/// A word that stands for one unit and is spelled like another: `5 M` may be nautical miles, and
/// `5 m` something else.
struct TwoReadings {
  std::string_view word;
  std::string_view unit;
  std::string_view of;
  std::string_view other;
  std::string_view of_other;
};
constexpr TwoReadings kTwoReadings[] = {{"M", "nmi", "nautical miles", "m", "metres"}};

bool isComparison(uint32_t type) {
  return type >= GliderLexer::EQ && type <= GliderLexer::GT;
}

}  // namespace

void ValueRepair::insert(uint32_t type) {
  const uint32_t place = out_.empty() ? 0 : out_.back().end;
  out_.push_back({type, place, place});
}

/// Where in `out_` the operator is before which the innermost parenthesis was meant to close:
/// `abs(depth > 5 m`. 0: it was meant to close at the end, or that is not known.
size_t ValueRepair::comparisonInside() const {
  size_t at = out_.size();
  size_t found = 0;
  for (size_t deep = 0; at > 0; --at) {
    const uint32_t type = out_[at - 1].type;
    const bool closes = oneOf(type, {GliderLexer::RPAREN, GliderLexer::RBRACKET});
    const bool opens = oneOf(type, {GliderLexer::LPAREN, GliderLexer::LBRACKET});
    if (opens && deep == 0) {
      break;
    }
    deep += closes ? 1U : 0U;
    deep -= opens ? 1U : 0U;
    found = deep == 0 && isComparison(type) ? at - 1 : found;
  }
  if (at < 2 || found == at || !isAnyName(out_[at - 2].type)) {
    return 0;
  }
  const std::string_view function = source_.text(out_[at - 2]);
  return function == "became" || function == "held" ? 0 : found;
}

/// Reports the innermost parenthesis, and closes it where it was meant to close.
void ValueRepair::closeBefore(const Lexeme& found) {
  const Parenthesis& left = parentheses_.back();
  const bool round = left.opener.type == GliderLexer::LPAREN;
  const char* sign = round ? ")" : "]";
  auto report = reporter_.at(left.opener, support::diagnostics::missingParenthesis,
                             source_.text(left.opener), sign, describe(source_, found));
  const uint32_t type = round ? GliderLexer::RPAREN : GliderLexer::RBRACKET;
  if (const size_t at = comparisonInside(); at != 0) {
    report.hint(fmt::format("write `{}` before `{}`", sign, source_.text(out_[at])));
    const uint32_t place = out_[at - 1].end;
    out_.insert(out_.begin() + static_cast<std::ptrdiff_t>(at), {type, place, place});
    return;
  }
  if (left.lists && left.operators == 0 && endsValue(previous())) {
    report.hint(fmt::format("write `{}` after `{}`", sign, lastValue()));
  }
  insert(type);
}

/// The last number with its unit, or the last word.
std::string_view ValueRepair::lastValue() const {
  const Lexeme& last = out_.back();
  const bool unit = oneOf(last.type, {GliderLexer::UNIT, GliderLexer::COMPASS});
  const bool both = unit && out_.size() > 1 && out_[out_.size() - 2].type == GliderLexer::NUMBER;
  const uint32_t begin = both ? out_[out_.size() - 2].begin : last.begin;
  return source_.text().substr(begin, last.end - begin);
}

void ValueRepair::keyword(const Lexeme& found) {
  operators_ = 0;
  if (found.type == GliderLexer::EVERY) {
    return;
  }
  while (!parentheses_.empty()) {
    closeBefore(found);
    parentheses_.pop_back();
  }
  in_sensors_ = found.type == GliderLexer::SENSORS;
  names_arguments_ = oneOf(found.type, {GliderLexer::FLIGHTPROFILE, GliderLexer::FLIGHTROUTE,
                                        GliderLexer::GOTO, GliderLexer::CALL});
  assignable_ =
      oneOf(found.type, {GliderLexer::CONST, GliderLexer::PARAM, GliderLexer::VAR, GliderLexer::SET,
                         GliderLexer::PLACE, GliderLexer::SHARE, GliderLexer::CHOOSE});
}

bool ValueRepair::take(Lexeme t, const Lexeme& next) {
  switch (t.type) {
    case GliderLexer::LPAREN:
    case GliderLexer::LBRACKET:
      return open(t);
    case GliderLexer::RPAREN:
    case GliderLexer::RBRACKET:
      return close(t);
    case GliderLexer::ASSIGN:
    case GliderLexer::EQ:
      t = equals(t);
      break;
    case GliderLexer::COMMA:
      if (previous() == GliderLexer::COMMA) {
        dropComma(t);
      }
      endOfItem();
      break;
    default:
      if (unknownUnit(t, next)) {
        return true;
      }
      missingComma(t, next);
  }
  out_.push_back(t);
  return countOperator(t);
}

bool ValueRepair::open(const Lexeme& t) {
  parentheses_.push_back({t, t.type == GliderLexer::LBRACKET || isAnyName(previous()), 0, 0});
  out_.push_back(t);
  if (parentheses_.size() > kDeepestNesting) {
    reporter_.at(t, support::diagnostics::nestedTooDeep, kDeepestNesting, "parentheses");
    return false;
  }
  return true;
}

bool ValueRepair::close(const Lexeme& t) {
  const bool round = t.type == GliderLexer::RPAREN;
  const uint32_t opens = round ? GliderLexer::LPAREN : GliderLexer::LBRACKET;
  if (parentheses_.empty() || parentheses_.back().opener.type != opens) {
    // No fix: in `a || b) && c` an opening one is missing, and removing both would change the
    // meaning.
    reporter_.at(t, support::diagnostics::strayParenthesis, source_.text(t), round ? "(" : "[");
    return true;
  }
  if (previous() == GliderLexer::COMMA && parentheses_.back().lists) {
    dropComma(t);
  }
  endOfItem();
  const size_t inside = parentheses_.back().most;
  parentheses_.pop_back();
  (parentheses_.empty() ? operators_ : parentheses_.back().operators) += inside;
  out_.push_back(t);
  return true;
}

/// The comma just read has no value between it and `found`. Between two commas of a list of
/// arguments a value may be missing, unless they touch.
void ValueRepair::dropComma(const Lexeme& found) {
  const Lexeme comma = out_.back();
  auto report = reporter_.at(comma, support::diagnostics::trailingComma, describe(source_, found));
  if (in_sensors_ || found.type != GliderLexer::COMMA || comma.end == found.begin) {
    report.fix(source_.range(comma), "");
  } else {
    report.hint("write a value between the two commas, or delete one");
  }
  out_.pop_back();
}

void ValueRepair::endOfItem() {
  if (parentheses_.empty()) {
    operators_ = 0;
    return;
  }
  Parenthesis& p = parentheses_.back();
  p.most = std::max(p.most, p.operators);
  p.operators = 0;
}

bool ValueRepair::countOperator(const Lexeme& t) {
  size_t& count = parentheses_.empty() ? operators_ : parentheses_.back().operators;
  count += isOperator(t.type) ? 1U : 0U;
  if (count > kMostOperators) {
    reporter_.at(t, support::diagnostics::expressionTooLong, kMostOperators);
    return false;
  }
  return true;
}

/// Whether a name at the beginning of an argument was read: `yo(top`. It may be the word of a unit
/// or of a function, `yo(min`: analysis knows the names of the parameters.
bool ValueRepair::namesArgument() const {
  const size_t n = out_.size();
  return !parentheses_.empty() && parentheses_.back().lists && n > 1 &&
         isAnyName(out_.back().type) && parentheses_.back().opener.type == GliderLexer::LPAREN &&
         oneOf(out_[n - 2].type, {GliderLexer::LPAREN, GliderLexer::COMMA});
}

/// Whether the type of a parameter was read, whose usual argument may follow: `yo(dive: angle`.
bool ValueRepair::typesParameter() const {
  size_t n = out_.size();
  while (n > 0 && (isName(out_[n - 1].type) ||
                   oneOf(out_[n - 1].type, {GliderLexer::TIMES, GliderLexer::DIVIDE}))) {
    --n;
  }
  return !parentheses_.empty() && parentheses_.back().opener.type == GliderLexer::LPAREN && n > 2 &&
         n < out_.size() && out_[n - 1].type == GliderLexer::COLON && isAnyName(out_[n - 2].type) &&
         oneOf(out_[n - 3].type, {GliderLexer::LPAREN, GliderLexer::COMMA});
}

/// The first `=` after `const`, `param`, `var`, `share`, `set` and `place` assigns a value; every
/// other was meant as a comparison.
Lexeme ValueRepair::equals(Lexeme t) {
  if (t.type == GliderLexer::ASSIGN && namesArgument()) {
    Lexeme& name = out_.back();
    name.type = isName(name.type) ? name.type : uint32_t{GliderLexer::NAME};
    return t;
  }
  if (t.type == GliderLexer::ASSIGN && typesParameter()) {
    return t;
  }
  const bool gives = assignable_ && parentheses_.empty();
  if (gives && t.type == GliderLexer::EQ) {
    reporter_.at(t, support::diagnostics::equalForAssign).fix(source_.range(t), "=");
    t.type = GliderLexer::ASSIGN;
  } else if (!gives && t.type == GliderLexer::ASSIGN) {
    reporter_.at(t, support::diagnostics::assignForEqual);  // no fix: only the pilot knows which
    t.type = GliderLexer::EQ;
  }
  assignable_ = assignable_ && !gives;
  return t;
}

/// A word after a number that is not a valid unit is reported and left out.
bool ValueRepair::unknownUnit(const Lexeme& t, const Lexeme& next) {
  if (previous() != GliderLexer::NUMBER || t.type != GliderLexer::NAME ||
      next.type == GliderLexer::LPAREN) {
    return false;
  }
  const std::string_view word = source_.text(t);
  const std::string_view unit = unitForWord(word);
  if (isLetterOfPosition(out_.size()) && word.size() == 1) {
    reporter_.at(t, support::diagnostics::unknownUnit, word, "a longitude has `E` or `W`");
    out_.push_back({GliderLexer::COMPASS, t.begin, t.end});
    return true;
  }
  const bool perhapsKeyword = isStateName(source_, word) || isAnyName(next.type) ||
                              !keywordNear(word).empty() || isKeywordInCapitals(word);
  if (unit.empty() && parentheses_.empty() && perhapsKeyword) {
    return false;  // `case depth > 5 jump s3`, `case depth > 5 retrun`: the parser knows what is
                   // expected there
  }
  constexpr std::string_view kAll =
      "units: mm cm m km nmi ft inch, s min h day days, rad deg, degC, m/s cm/s kn kt, bar dbar, "
      "S/m, "
      "V A W J kJ MJ Wh kWh Ah mAh, cc ml, % uM ug/L";
  if (unit == "deg" && t.end - t.begin > unit.size()) {
    // Of an angle or a temperature: analysis knows which, and reports it.
    out_.push_back({GliderLexer::UNIT, t.begin, t.end});
    return true;
  }
  if (const auto* row = std::ranges::find(kTwoReadings, word, &TwoReadings::word);
      row != std::end(kTwoReadings)) {
    reporter_.at(
        t, support::diagnostics::unknownUnit, word,
        fmt::format("write `{0} {1}` for {2}, `{0} {3}` for {4}", source_.text(out_.back()),
                    row->unit, row->of, row->other, row->of_other));
    out_.push_back({GliderLexer::UNIT, t.begin, t.end});
    return true;
  }
  auto report = reporter_.at(t, support::diagnostics::unknownUnit, word,
                             unit.empty() ? std::string(kAll) : fmt::format("write `{}`", unit));
  if (!unit.empty() && !isStateName(source_, word)) {  // `2 h 26 c`: perhaps `goto c` was meant
    report.fix(source_.range(t), std::string(unit));
    out_.push_back({GliderLexer::UNIT, t.begin, t.end});  // AstBuilder reads it as the unit
  }
  return true;
}

/// Whether the `end` tokens so far end with `39.2 N 73.8`.
bool ValueRepair::isLetterOfPosition(size_t end) const {
  return end > 2 && out_[end - 1].type == GliderLexer::NUMBER &&
         out_[end - 2].type == GliderLexer::COMPASS && out_[end - 3].type == GliderLexer::NUMBER;
}

/// Two values next to each other in an argument list or a `sensors` list.
void ValueRepair::missingComma(const Lexeme& t, const Lexeme& next) {
  const bool inList = !parentheses_.empty() || in_sensors_;
  if (!inList || !endsValue(previous()) || !startsValue(t.type) || belongTogether(t, next)) {
    return;
  }
  const Lexeme before = out_.back();
  if (parentheses_.empty() || !parentheses_.back().doubtful) {
    reportMissingComma(before, t, next);
  }
  endOfItem();
  insert(GliderLexer::COMMA);
}

/// Between `5 m` and `30 m`, or two sensors, a comma is certain. In doubt, as in `top 5 m` and
/// `5 m to 30 m`, the pilot must say what is meant, and the rest of the list is not reported.
void ValueRepair::reportMissingComma(const Lexeme& before, const Lexeme& t, const Lexeme& next) {
  auto report =
      reporter_.at(t, support::diagnostics::missingComma, fmt::format("`{}`", source_.text(before)),
                   fmt::format("`{}`", source_.text(t)));
  const bool foreign = std::ranges::any_of(
      source_.text(t), [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
  const std::string hint = insteadOfComma(before, t, next);
  if (!hint.empty()) {
    report.hint(hint);
    parentheses_.back().doubtful = true;
    guessed_ = true;
  } else if (listsValues() && !foreign) {  // perhaps a keyword with a letter of another alphabet
    report.fix({source_.file, before.end, before.end}, ",");
  }
}

/// What may be meant where two values of an argument list stand next to each other; empty: a comma.
std::string ValueRepair::insteadOfComma(const Lexeme& before, const Lexeme& t,
                                        const Lexeme& next) const {
  const bool arguments = !parentheses_.empty() && listsValues() &&
                         parentheses_.back().opener.type == GliderLexer::LPAREN && !declares();
  const std::string_view first = source_.text(before);
  const std::string_view second = source_.text(t);
  if (!arguments) {
    return "";
  }
  if (isName(before.type) && isName(t.type)) {
    return fmt::format("write `,` between them, or `{}_{}` if it is one name", first, second);
  }
  if (isName(before.type) && t.type == GliderLexer::NUMBER) {
    const bool later = out_.size() > 1 && out_[out_.size() - 2].type == GliderLexer::COMMA;
    return names_arguments_
               ? fmt::format(
                     "write `{0} = {1}` if `{0}` is the name of an argument, `{0}, {1}` if not",
                     first, valueOf(t, next))
           : later
               ? fmt::format("write `{1} of {0}` in a window, `{0}, {1}` if they are two values",
                             first, valueOf(t, next))
               : "";
  }
  if (before.type == GliderLexer::NUMBER && t.type == GliderLexer::NUMBER) {
    return "write `,` between them, and the unit or the letter of each";
  }
  if (!isAnyName(before.type) || !isName(t.type)) {
    return "";
  }
  return next.type == GliderLexer::NUMBER
             ? fmt::format("write `,` for `{}`", second)
             : fmt::format("write `,` between them, or `{} of {}` in a window", lastValue(),
                           t.type == GliderLexer::IN ? source_.text(next) : second);
}

/// A number, with the unit after it.
std::string ValueRepair::valueOf(const Lexeme& number, const Lexeme& next) const {
  const bool unit = oneOf(next.type, {GliderLexer::UNIT, GliderLexer::MIN});
  return std::string(
      source_.text().substr(number.begin, (unit ? next : number).end - number.begin));
}

/// Whether a list of values is being read: `sensors`, a path, or the arguments of a name. Between
/// the values of a plain `(…)` an operator is missing, not a comma.
bool ValueRepair::listsValues() const {
  return parentheses_.empty() || parentheses_.back().lists;
}

/// Whether the last item of the list is a declaration, `radius: length`.
bool ValueRepair::declares() const {
  const auto stop = std::find_if(out_.rbegin(), out_.rend(), [](const Lexeme& one) {
    return oneOf(one.type, {GliderLexer::COLON, GliderLexer::COMMA, GliderLexer::LPAREN});
  });
  return stop != out_.rend() && stop->type == GliderLexer::COLON;
}

/// `10 m of depth`, `radius: length in 10 m .. 1 km`, `peers within 2 km`, and the second half of
/// `39.2 N 73.9 W`.
bool ValueRepair::belongTogether(const Lexeme& t, const Lexeme& next) const {
  const size_t n = out_.size();
  if (t.type == GliderLexer::OF ||
      (previous() == GliderLexer::OF && n > 1 && endsValue(out_[n - 2].type))) {
    return true;
  }
  if (t.type == GliderLexer::IN || previous() == GliderLexer::IN) {
    return declares();
  }
  if ((t.type == GliderLexer::WITHIN && previous() == GliderLexer::PEERS) ||
      (previous() == GliderLexer::WITHIN && n > 1 && out_[n - 2].type == GliderLexer::PEERS)) {
    return true;
  }
  if (t.type == GliderLexer::NUMBER && n > 1 && out_[n - 2].type == GliderLexer::NUMBER &&
      isSmallerTime(source_.text(out_.back()), source_.text(next))) {
    return true;
  }
  auto isPair = [&](size_t end) {
    return end >= 2 && out_[end - 1].type == GliderLexer::COMPASS &&
           out_[end - 2].type == GliderLexer::NUMBER;
  };
  const bool letter = isPair(n);
  const bool second = letter && isPair(n - 2);
  const bool letter_follows =
      next.type == GliderLexer::COMPASS ||
      (next.type == GliderLexer::NAME && next.end == next.begin + 1);  // `39.2 N 73.8 X`
  return letter && !second && t.type == GliderLexer::NUMBER && letter_follows;
}

}  // namespace glider::frontend
