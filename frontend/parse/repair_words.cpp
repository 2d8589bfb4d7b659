// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/repair_words.h"

#include <algorithm>

#include <fmt/format.h>

#include "grammar/GliderLexer.h"

namespace glider::frontend {

using grammar::GliderLexer;
using support::DiagnosticId;

namespace {

/// What word processors and web pages put in place of ASCII, and the token that was meant (0: none).
struct Lookalike {
  std::string_view text;
  std::string_view meant;
  uint32_t type;
};
const Lookalike kLookalikes[] = {
    {"≥", ">=", GliderLexer::GE},   {"≤", "<=", GliderLexer::LE},   {"≠", "!=", GliderLexer::NE},
    {"–", "-", GliderLexer::MINUS}, {"−", "-", GliderLexer::MINUS}, {"×", "*", GliderLexer::TIMES},
    {"·", "*", GliderLexer::TIMES}, {"°", "deg", GliderLexer::UNIT}, {"“", "\"", 0},
    {"”", "\"", 0},                 {"\xC2\xA0", "a blank", 0}};

/// What was meant, with its type in the grammar.
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

Meant meantBy(uint32_t type, std::string_view text) {
  switch (type) {
    case GliderLexer::AND_WORD:
    case GliderLexer::ONE_AMPERSAND:
      return {"&&", GliderLexer::AND};
    case GliderLexer::OR_WORD:
    case GliderLexer::ONE_BAR:
      return {"||", GliderLexer::OR};
    case GliderLexer::NOT_WORD:
      return {"!", GliderLexer::NOT};
    default:
      return comparison(text);
  }
}

}  // namespace

std::vector<Lexeme> WordRepair::run(const std::vector<Lexeme>& lexemes) {
  std::vector<Lexeme> out;
  out.reserve(lexemes.size());
  for (const Lexeme& lexeme : lexemes) {
    if (reporter_.full()) {
      break;
    }
    if (lexeme.type == GliderLexer::OPEN_COMMENT) {
      reporter_.at(lexeme, DiagnosticId::openComment);
      cut_ = true;
      break;
    }
    if (auto kept = one(lexeme)) {
      out.push_back(*kept);
    }
  }
  if (out.empty() || out.back().type != lexemes.back().type) {
    out.push_back(lexemes.back());
  }
  return out;
}

std::optional<Lexeme> WordRepair::one(const Lexeme& lexeme) {
  switch (lexeme.type) {
    case GliderLexer::SEMICOLON:
      reporter_.at(lexeme, DiagnosticId::semicolon).fix(reporter_.source().range(lexeme), "");
      return std::nullopt;
    case GliderLexer::FOREIGN:
      return foreign(lexeme);
    case GliderLexer::POINT_WITHOUT_DIGITS: {
      reporter_.at(lexeme, DiagnosticId::pointWithoutDigits, reporter_.source().text(lexeme))
          .fix({reporter_.source().file, lexeme.end, lexeme.end}, "0");
      return Lexeme{GliderLexer::NUMBER, lexeme.begin, lexeme.end - 1};
    }
    case GliderLexer::OPEN_STRING:
      reporter_.at(lexeme, DiagnosticId::openString);
      return Lexeme{GliderLexer::STRING, lexeme.begin, lexeme.end};
    case GliderLexer::AND_WORD:
    case GliderLexer::OR_WORD:
    case GliderLexer::NOT_WORD:
      return replaced(lexeme, DiagnosticId::wordOperator, lexeme.type);
    case GliderLexer::ONE_AMPERSAND:
    case GliderLexer::ONE_BAR:
      return replaced(lexeme, DiagnosticId::singleAmpersand, lexeme.type);
    case GliderLexer::WRONG_COMPARISON:
      return replaced(lexeme, DiagnosticId::wrongComparison, lexeme.type);
    default:
      return lexeme;
  }
}

Lexeme WordRepair::replaced(const Lexeme& lexeme, DiagnosticId id, uint32_t type) {
  const std::string_view text = reporter_.source().text(lexeme);
  const Meant meant = meantBy(type, text);
  reporter_.at(lexeme, id, text, meant.text).fix(reporter_.source().range(lexeme), std::string(meant.text));
  return {meant.type, lexeme.begin, lexeme.end};
}

std::optional<Lexeme> WordRepair::foreign(const Lexeme& lexeme) {
  const std::string_view text = reporter_.source().text(lexeme);
  for (const Lookalike& row : kLookalikes) {
    if (row.text == text) {
      auto report = reporter_.at(lexeme, DiagnosticId::foreignCharacter, text, fmt::format("write `{}`", row.meant));
      if (row.type == 0) {
        return std::nullopt;
      }
      report.fix(reporter_.source().range(lexeme), (row.type == GliderLexer::UNIT ? " " : "") + std::string(row.meant));
      return Lexeme{row.type, lexeme.begin, lexeme.end};
    }
  }
  const bool ascii = static_cast<unsigned char>(text.front()) < 0x80U;
  const bool control = ascii && (text.front() < ' ' || text.front() == 0x7F);
  const std::string shown = control ? fmt::format("\\x{:02x}", text.front()) : std::string(text.substr(0, 40));
  reporter_.at(lexeme, DiagnosticId::foreignCharacter, shown,
               ascii ? "delete it" : "outside comments and texts the language is written in ASCII letters");
  return std::nullopt;
}

}  // namespace glider::frontend
