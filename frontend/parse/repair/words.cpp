// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/repair/words.h"

#include "frontend/bare_positions.h"
#include "frontend/parse/foreign_characters.h"
#include "frontend/parse/repair/positions.h"
#include "frontend/parse/token_kinds.h"
#include "frontend/spelling.h"
#include "support/diagnostics/ids/meaning.h"
#include "support/diagnostics/ids/syntax.h"
#include "support/word_byte.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::frontend {

using support::DiagnosticId;

namespace {

/// The intended text, with its type in the grammar.
struct Meant {
  std::string_view text;
  uint32_t type;
};

Meant comparison(std::string_view wrong) {
  if (wrong == "=>") {
    return {">=", GliderLexer::GE};
  }
  if (wrong == "=<") {
    return {"<=", GliderLexer::LE};
  }
  return wrong == "===" ? Meant{"==", GliderLexer::EQ} : Meant{"!=", GliderLexer::NE};
}

/// A fix never writes `==` or `!=`: for readings they are rarely correct.
bool comparesExactly(uint32_t type) {
  return type == GliderLexer::EQ || type == GliderLexer::NE;
}

Meant meantBy(uint32_t type, std::string_view text) {
  switch (type) {
    case GliderLexer::AND_WORD:
    case GliderLexer::ONE_AMPERSAND:
      return {"&&", GliderLexer::AND};
    case GliderLexer::OR_WORD:
    case GliderLexer::ONE_BAR:
      return {"||", GliderLexer::OR};
    default:
      return comparison(text);
  }
}

}  // namespace

std::vector<Lexeme> WordRepair::run(const std::vector<Lexeme>& lexemes) {
  std::vector<Lexeme> out;
  out.reserve(lexemes.size());
  for (size_t i = 0; i < lexemes.size() && !reporter_.full(); ++i) {
    const Lexeme& lexeme = lexemes[i];
    const Lexeme& next = lexemes[std::min(i + 1, lexemes.size() - 1)];
    followOpen(lexeme, out);
    last_keyword_ = isHardKeyword(lexeme.type) && !isOperator(lexeme.type) &&
                            !oneOf(lexeme.type, {GliderLexer::AND_WORD, GliderLexer::OR_WORD})
                        ? lexeme.type
                        : last_keyword_;
    if (lexeme.type == GliderLexer::OPEN_COMMENT) {
      reporter_.at(lexeme, support::diagnostics::openComment);
      cut_ = true;
      break;
    }
    if (const auto half = degreesAndMinutes(lexemes, i, reporter_.source())) {
      out.push_back(*half);
      ++i;
      continue;
    }
    if (const size_t taken = several(lexemes, i, out)) {
      i += taken - 1;
      continue;
    }
    if (lexeme.type == GliderLexer::OPEN_STRING) {
      openString(lexeme, out);
    } else if (partOfToken(lexeme, next, out)) {
      continue;
    } else if (isOfPromise(lexeme, next)) {
      out.push_back(lexeme);
    } else if (lexeme.type == GliderLexer::SEMICOLON) {
      semicolon(lexeme, next, out);
    } else if (auto kept = one(lexeme)) {
      out.push_back(*kept);
    }
  }
  if (out.empty() || out.back().type != lexemes.back().type) {
    out.push_back(lexemes.back());
  }
  return out;
}

/// What is recognised by more than one token: how many it took, or 0.
size_t WordRepair::several(const std::vector<Lexeme>& lexemes, size_t at,
                           std::vector<Lexeme>& out) {
  if (const size_t taken = decimalComma(lexemes, at, out)) {
    return taken;
  }
  if (const size_t taken = quotedText(lexemes, at, out)) {
    return taken;
  }
  if (isBrace(lexemes[at])) {
    brace(lexemes, at, out);
    return 1;
  }
  if (last_keyword_ != GliderLexer::SENSORS && isOperatorInCapitals(lexemes, at, out)) {
    out.push_back(capitals(lexemes[at]));
    return 1;
  }
  return barePair(lexemes, at, out);
}

/// `and` of `whenever and only when`, `or` of `or exit`: words, not operators.
bool WordRepair::isOfPromise(const Lexeme& lexeme, const Lexeme& next) {
  return (lexeme.type == GliderLexer::AND_WORD && next.type == GliderLexer::ONLY) ||
         (lexeme.type == GliderLexer::OR_WORD && next.type == GliderLexer::EXIT);
}

/// Tracks the open parentheses; a keyword closes them all, as in ValueRepair.
void WordRepair::followOpen(const Lexeme& lexeme, const std::vector<Lexeme>& out) {
  if (oneOf(lexeme.type, {GliderLexer::LPAREN, GliderLexer::LBRACKET})) {
    open_.push_back(lexeme.type == GliderLexer::LPAREN && !out.empty() &&
                    isAnyName(out.back().type));
    in_path_ = lexeme.type == GliderLexer::LBRACKET;
  } else if (oneOf(lexeme.type, {GliderLexer::RPAREN, GliderLexer::RBRACKET})) {
    open_.resize(open_.size() - (open_.empty() ? 0U : 1U));
  } else if (isHardKeyword(lexeme.type) && lexeme.type != GliderLexer::EVERY &&
             !oneOf(lexeme.type, {GliderLexer::TRUE, GliderLexer::FALSE, GliderLexer::AND_WORD,
                                  GliderLexer::OR_WORD, GliderLexer::NOT_WORD})) {
    open_.clear();
  }
}

/// `20,5 degC` outside all lists: a comma for the decimal point. The digits after it are left out.
size_t WordRepair::decimalComma(const std::vector<Lexeme>& lexemes, size_t at,
                                std::vector<Lexeme>& out) {
  constexpr size_t kTokens = 3;
  if (at + kTokens >= lexemes.size() ||
      oneOf(last_keyword_, {GliderLexer::LOG, GliderLexer::SENSORS})) {
    return 0;
  }
  // In a path, only a number with a letter: `[39,175 N 73,83 W]`.
  const bool path = !open_.empty() && !open_.back() && in_path_ &&
                    lexemes[at + kTokens].type == GliderLexer::COMPASS;
  // After a named argument no other is without a name.
  const bool named = !open_.empty() && open_.back() && !out.empty() &&
                     out.back().type == GliderLexer::ASSIGN &&
                     lexemes[at + kTokens].type != GliderLexer::ASSIGN;
  if (!open_.empty() && !path && !named) {
    return 0;
  }
  const Source& source = reporter_.source();
  const Lexeme& first = lexemes[at];
  const Lexeme& comma = lexemes[at + 1];
  const Lexeme& second = lexemes[at + 2];
  const auto digits = [&](const Lexeme& t) {
    return t.type == GliderLexer::NUMBER &&
           source.text(t).find_first_not_of("0123456789") == std::string_view::npos;
  };
  if (!digits(first) || comma.type != GliderLexer::COMMA || !digits(second) ||
      first.end != comma.begin || comma.end != second.begin) {
    return 0;
  }
  const Lexeme whole{GliderLexer::NUMBER, first.begin, second.end};
  const std::string better = fmt::format("{}.{}", source.text(first), source.text(second));
  auto report = reporter_.at(whole, support::diagnostics::decimalComma, source.text(whole), better);
  if (!path && mayBeThousands(source.text(first), source.text(second))) {
    report.hint(fmt::format("write `{}{}` or `{}`, whichever is meant", source.text(first),
                            source.text(second), better));
  } else {
    report.fix(source.range(comma), ".");
  }
  out.push_back(first);
  return kTokens;
}

/// `AND` or `OR` between two values.
bool WordRepair::isOperatorInCapitals(const std::vector<Lexeme>& lexemes, size_t at,
                                      const std::vector<Lexeme>& out) const {
  const std::string_view text = reporter_.source().text(lexemes[at]);
  const uint32_t next = lexemes[std::min(at + 1, lexemes.size() - 1)].type;
  return lexemes[at].type == GliderLexer::NAME &&
         (text == "AND" || text == "OR" || text == "And" || text == "Or") && !out.empty() &&
         endsValue(out.back().type) &&
         (startsValue(next) || oneOf(next, {GliderLexer::LPAREN, GliderLexer::NOT,
                                            GliderLexer::NOT_WORD, GliderLexer::MINUS}));
}

Lexeme WordRepair::capitals(const Lexeme& lexeme) {
  const bool both = reporter_.source().text(lexeme).front() == 'A';
  const std::string_view sign = both ? "&&" : "||";
  reporter_.at(lexeme, support::diagnostics::wordOperator, reporter_.source().text(lexeme), sign)
      .fix(reporter_.source().range(lexeme), std::string(sign));
  return {both ? uint32_t{GliderLexer::AND} : uint32_t{GliderLexer::OR}, lexeme.begin, lexeme.end};
}

/// In the arguments of a name a comma is missing between them, which ValueRepair reports.
size_t WordRepair::barePair(const std::vector<Lexeme>& lexemes, size_t at,
                            std::vector<Lexeme>& out) {
  constexpr size_t kTokens = 2;
  if (at + kTokens >= lexemes.size() || lexemes[at].type != GliderLexer::NUMBER ||
      lexemes[at + 1].type != GliderLexer::NUMBER || (!open_.empty() && open_.back()) ||
      oneOf(lexemes[at + kTokens].type,
            {GliderLexer::UNIT, GliderLexer::COMPASS, GliderLexer::MIN})) {
    return 0;
  }
  const Source& source = reporter_.source();
  const bool negative = !out.empty() && out.back().type == GliderLexer::MINUS &&
                        (out.size() < 2 || !endsValue(out[out.size() - 2].type));
  const auto better =
      pairWithLetters({source.text(lexemes[at]), negative}, {source.text(lexemes[at + 1]), false});
  if (!better) {
    return 0;
  }
  Lexeme whole{GliderLexer::NUMBER, lexemes[at].begin, lexemes[at + 1].end};
  out.push_back(whole);
  whole.begin = negative ? out[out.size() - 2].begin : whole.begin;
  reporter_.at(whole, support::diagnostics::barePosition, source.text(whole),
               fmt::format("`{}`", *better));
  return kTokens;
}

/// A foreign character immediately after or before a name is part of it: one error, not three. The
/// same holds for the point of `5.`.
bool WordRepair::partOfToken(const Lexeme& lexeme, const Lexeme& next, std::vector<Lexeme>& out) {
  const bool behind = !out.empty() && out.back().end == lexeme.begin;
  if (behind && lexeme.begin == name_end_ &&
      oneOf(lexeme.type, {GliderLexer::NAME, GliderLexer::NUMBER})) {
    out.back().end = lexeme.end;
    return true;
  }
  if (lexeme.type != GliderLexer::FOREIGN) {
    return false;
  }
  const std::string_view text = reporter_.source().text(lexeme);
  if (text == "." && behind && pointInName(next, out)) {
    return true;
  }
  if (text == "." && behind && pointForComma(lexeme, next, out)) {
    return true;
  }
  if (text == "." && behind && out.back().type == GliderLexer::NUMBER) {
    const Lexeme whole{GliderLexer::NUMBER, out.back().begin, lexeme.end};
    const std::string_view number = reporter_.source().text(out.back());
    auto report = reporter_.at(whole, support::diagnostics::pointWithoutDigits,
                               reporter_.source().text(whole));
    if (number.find('.') == std::string_view::npos) {
      report.fix({reporter_.source().file, lexeme.end, lexeme.end}, "0");
    }
    return true;
  }
  const bool letters = static_cast<unsigned char>(text.front()) >= 0x80U && !isLookalike(text);
  const bool after = behind && isAnyName(out.back().type);
  const bool before = next.begin == lexeme.end && isAnyName(next.type);
  if (!letters || (!after && !before)) {
    return false;
  }
  foreign(lexeme);
  if (after) {
    out.back() = {GliderLexer::NAME, out.back().begin, lexeme.end};
  } else {
    out.push_back({GliderLexer::NAME, lexeme.begin, lexeme.end});
  }
  name_end_ = lexeme.end;
  return true;
}

/// `state look.deep`, which NameRepair reports.
bool WordRepair::pointInName(const Lexeme& next, const std::vector<Lexeme>& out) {
  return out.size() > 1 && out.back().end + 1 == next.begin && isAnyName(out.back().type) &&
         isAnyName(next.type) &&
         oneOf(out[out.size() - 2].type, {GliderLexer::STATE, GliderLexer::MISSION});
}

/// `20 m. 26 deg` in a list.
bool WordRepair::pointForComma(const Lexeme& lexeme, const Lexeme& next, std::vector<Lexeme>& out) {
  const bool list = !open_.empty() && open_.back() && endsValue(out.back().type) &&
                    next.begin > lexeme.end &&
                    oneOf(next.type, {GliderLexer::NUMBER, GliderLexer::MINUS});
  if (!list || out.back().type == GliderLexer::NUMBER) {
    return false;
  }
  reporter_
      .at(lexeme, support::diagnostics::foreignCharacter, characterText("."),
          "write `,` between values")
      .fix(reporter_.source().range(lexeme), ",");
  out.push_back({GliderLexer::COMMA, lexeme.begin, lexeme.end});
  return true;
}

std::optional<Lexeme> WordRepair::one(const Lexeme& lexeme) {
  switch (lexeme.type) {
    case GliderLexer::FOREIGN:
      return foreign(lexeme);
    case GliderLexer::AND_WORD:
    case GliderLexer::OR_WORD:
      return replaced(lexeme, support::diagnostics::wordOperator, lexeme.type);
    case GliderLexer::ONE_AMPERSAND:
    case GliderLexer::ONE_BAR:
      return replaced(lexeme, support::diagnostics::singleAmpersand, lexeme.type);
    case GliderLexer::WRONG_COMPARISON:
      return replaced(lexeme, support::diagnostics::wrongComparison, lexeme.type);
    default:
      return lexeme;
  }
}

/// Between values, and between sensors, it replaces a comma: without either, `min(a; -b)` would be
/// a difference.
void WordRepair::semicolon(const Lexeme& lexeme, const Lexeme& next, std::vector<Lexeme>& out) {
  const bool sensors = last_keyword_ == GliderLexer::SENSORS && isAnyName(next.type);
  const bool between = !open_.empty() || sensors;
  reporter_.at(lexeme, support::diagnostics::semicolon)
      .hint(between ? "write `,` between values" : "delete it; statements need no separator")
      .fix(reporter_.source().range(lexeme), between ? "," : "");
  if (between) {
    out.push_back({GliderLexer::COMMA, lexeme.begin, lexeme.end});
  }
}

Lexeme WordRepair::replaced(const Lexeme& lexeme, DiagnosticId id, uint32_t type) {
  const std::string_view text = reporter_.source().text(lexeme);
  const Meant meant = meantBy(type, text);
  auto report = reporter_.at(lexeme, id, text, meant.text);
  if (!comparesExactly(meant.type)) {
    report.fix(reporter_.source().range(lexeme), std::string(meant.text));
  }
  return {meant.type, lexeme.begin, lexeme.end};
}

/// `39·175`: a decimal point, and not `39 * 175`.
bool WordRepair::isRaisedPoint(const Lexeme& lexeme) const {
  const std::string_view text = reporter_.source().text();
  const auto digit = [&](size_t at) {
    return at < text.size() && text[at] >= '0' && text[at] <= '9';
  };
  return reporter_.source().text(lexeme) == "·" && lexeme.begin > 0 && digit(lexeme.begin - 1) &&
         digit(lexeme.end);
}

std::optional<Lexeme> WordRepair::foreign(const Lexeme& lexeme) {
  const std::string_view text = reporter_.source().text(lexeme);
  if (!isUtf8(text)) {  // reported once for the file; a degree sign of Latin-1 is read as one
    return text == "\xB0" ? std::optional(Lexeme{GliderLexer::UNIT, lexeme.begin, lexeme.end})
                          : std::nullopt;
  }
  if (const Blank* blank = blankOf(text)) {
    reporter_
        .at(lexeme, support::diagnostics::foreignCharacter, blank->name,
            blank->wide ? "write an ordinary space" : "delete it")
        .fix(reporter_.source().range(lexeme),
             std::string(blank->wide ? text.size() / blank->text.size() : 0, ' '));
    return std::nullopt;
  }
  if (const Lookalike* row = lookalikeOf(text)) {
    auto report = reporter_.at(lexeme, support::diagnostics::foreignCharacter, characterText(text),
                               fmt::format("write `{}`", row->meant));
    if (row->type == 0) {
      return std::nullopt;
    }
    if (!comparesExactly(row->type) && !isRaisedPoint(lexeme)) {
      report.fix(reporter_.source().range(lexeme),
                 (row->type == GliderLexer::UNIT ? " " : "") + std::string(row->meant));
    }
    return Lexeme{row->type, lexeme.begin, lexeme.end};
  }
  const bool ascii = static_cast<unsigned char>(text.front()) < 0x80U;
  const bool control = ascii && (text.front() < ' ' || text.front() == 0x7F);
  const std::string shown =
      control ? fmt::format("\\x{:02x}", text.front()) : std::string(text.substr(0, 40));
  const std::string word = ascii ? "" : plainSpelling(wordAround(lexeme));
  reporter_.at(lexeme, support::diagnostics::foreignCharacter, characterText(shown),
               ascii          ? "delete it"
               : word.empty() ? "use only ASCII characters outside comments and strings"
                              : fmt::format("names have only letters a to z, digits and `_`: "
                                            "write `{}`",
                                            word));
  return std::nullopt;
}

/// The word that a foreign letter belongs to.
std::string_view WordRepair::wordAround(const Lexeme& lexeme) const {
  const std::string_view text = reporter_.source().text();
  const auto part = [&](size_t at) {
    return support::isWordByte(text[at]) || static_cast<unsigned char>(text[at]) >= 0x80U;
  };
  size_t begin = lexeme.begin;
  size_t end = lexeme.end;
  while (begin > 0 && part(begin - 1)) {
    --begin;
  }
  while (end < text.size() && part(end)) {
    ++end;
  }
  return text.substr(begin, end - begin);
}

}  // namespace glider::frontend
