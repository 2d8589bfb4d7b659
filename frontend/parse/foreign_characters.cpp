// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/foreign_characters.h"

#include "frontend/parse/token_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace glider::frontend {
namespace {

constexpr Blank kBlanks[] = {{"\xC2\xA0", "no-break space (U+00A0)", true},
                             {"\xE2\x80\xAF", "narrow no-break space (U+202F)", true},
                             {"\xE2\x80\x87", "figure space (U+2007)", true},
                             {"\xE2\x80\x89", "thin space (U+2009)", true},
                             {"\xE3\x80\x80", "ideographic space (U+3000)", true},
                             {"\xE2\x80\x8B", "zero-width space (U+200B)", false},
                             {"\xEF\xBB\xBF", "byte order mark (U+FEFF)", false}};

constexpr Lookalike kLookalikes[] = {{"≥", ">=", GliderLexer::GE},
                                     {"≤", "<=", GliderLexer::LE},
                                     {"≠", "!=", GliderLexer::NE},
                                     {"–", "-", GliderLexer::MINUS},
                                     {"−", "-", GliderLexer::MINUS},
                                     {"×", "*", GliderLexer::TIMES},
                                     {"·", "*", GliderLexer::TIMES},
                                     {"°", "deg", GliderLexer::UNIT},
                                     {"“", "\"", 0},
                                     {"”", "\"", 0}};

constexpr std::pair<std::string_view, std::string_view> kSpellings[] = {
    {"ä", "ae"}, {"ö", "oe"}, {"ü", "ue"}, {"Ä", "Ae"}, {"Ö", "Oe"}, {"Ü", "Ue"},
    {"ß", "ss"}, {"é", "e"},  {"è", "e"},  {"ê", "e"},  {"ë", "e"},  {"É", "E"},
    {"à", "a"},  {"á", "a"},  {"â", "a"},  {"ã", "a"},  {"å", "aa"}, {"Å", "Aa"},
    {"ç", "c"},  {"ñ", "n"},  {"í", "i"},  {"ï", "i"},  {"î", "i"},  {"ó", "o"},
    {"ô", "o"},  {"õ", "o"},  {"ø", "oe"}, {"Ø", "Oe"}, {"æ", "ae"}, {"Æ", "Ae"},
    {"œ", "oe"}, {"ú", "u"},  {"ù", "u"},  {"û", "u"},  {"µ", "u"},  {"μ", "u"}};

/// The bytes of the first character of `text`, which is UTF-8 or not.
size_t characterSize(std::string_view text) {
  return std::max<size_t>(characterLength(text, 0), 1);
}

/// What a run of foreign characters is divided by.
enum class Kind : uint8_t { Letters, Sign, NoCharacter };

Kind kindOf(std::string_view one) {
  return !isUtf8(one) ? Kind::NoCharacter : isLookalike(one) ? Kind::Sign : Kind::Letters;
}

void separate(const Lexeme& run, std::string_view text, std::vector<Lexeme>& out) {
  std::string_view last;
  for (size_t at = 0; at < text.size();) {
    const std::string_view one = text.substr(at, characterSize(text.substr(at)));
    const auto begin = static_cast<uint32_t>(run.begin + at);
    const auto end = static_cast<uint32_t>(begin + one.size());
    const bool blanks = one == last && blankOf(one) != nullptr;
    const bool letters =
        !last.empty() && kindOf(one) == Kind::Letters && kindOf(last) == Kind::Letters;
    if (blanks || letters) {
      out.back().end = end;
    } else {
      out.push_back({run.type, begin, end});
    }
    last = one;
    at += one.size();
  }
}

}  // namespace

const Blank* blankOf(std::string_view text) {
  const auto* const row = std::ranges::find_if(kBlanks, [&](const Blank& blank) {
    std::string_view rest = text;
    while (rest.starts_with(blank.text)) {
      rest.remove_prefix(blank.text.size());
    }
    return rest.empty();
  });
  return row == std::end(kBlanks) || text.empty() ? nullptr : row;
}

const Lookalike* lookalikeOf(std::string_view text) {
  const auto* const row = std::ranges::find(kLookalikes, text, &Lookalike::text);
  return row == std::end(kLookalikes) ? nullptr : row;
}

bool isLookalike(std::string_view text) {
  return blankOf(text) != nullptr || lookalikeOf(text) != nullptr;
}

std::string characterText(std::string_view text) {
  return fmt::format("character `{}`", text);
}

bool isQuote(std::string_view text) {
  constexpr std::string_view kQuotes[] = {"“", "”", "„", "‟", "«", "»", "‘", "’"};
  return std::ranges::find(kQuotes, text) != std::end(kQuotes);
}

size_t characterLength(std::string_view text, size_t at) {
  auto byte = [&](size_t k) {
    return at + k < text.size() ? static_cast<unsigned char>(text[at + k]) : 0U;
  };
  auto follows = [&](size_t k, unsigned low, unsigned high) {
    return byte(k) >= low && byte(k) <= high;
  };
  const unsigned b = byte(0);
  if (b < 0x80U) {
    return 1;
  }
  if (b >= 0xC2U && b <= 0xDFU) {
    return follows(1, 0x80, 0xBF) ? 2 : 0;
  }
  if (b >= 0xE0U && b <= 0xEFU) {
    const bool second = follows(1, b == 0xE0U ? 0xA0 : 0x80, b == 0xEDU ? 0x9F : 0xBF);
    return second && follows(2, 0x80, 0xBF) ? 3 : 0;
  }
  if (b >= 0xF0U && b <= 0xF4U) {
    const bool second = follows(1, b == 0xF0U ? 0x90 : 0x80, b == 0xF4U ? 0x8F : 0xBF);
    return second && follows(2, 0x80, 0xBF) && follows(3, 0x80, 0xBF) ? 4 : 0;
  }
  return 0;
}

bool isUtf8(std::string_view text) {
  for (size_t at = 0; at < text.size();) {
    const size_t length = characterLength(text, at);
    if (length == 0) {
      return false;
    }
    at += length;
  }
  return true;
}

std::string plainSpelling(std::string_view word) {
  std::string plain;
  for (size_t at = 0; at < word.size();) {
    const std::string_view one = word.substr(at, characterSize(word.substr(at)));
    const auto* const row =
        std::ranges::find(kSpellings, one, [](const auto& r) { return r.first; });
    const bool ascii = static_cast<unsigned char>(one.front()) < 0x80U;
    if (!ascii && row == std::end(kSpellings)) {
      return "";
    }
    plain += ascii ? one : row->second;
    at += one.size();
  }
  return plain;
}

std::vector<Lexeme> separateForeign(const std::vector<Lexeme>& lexemes, const Source& source) {
  std::vector<Lexeme> out;
  out.reserve(lexemes.size());
  for (const Lexeme& lexeme : lexemes) {
    if (lexeme.type == GliderLexer::FOREIGN && lexeme.end > lexeme.begin + 1) {
      separate(lexeme, source.text(lexeme), out);
    } else {
      out.push_back(lexeme);
    }
  }
  return out;
}

}  // namespace glider::frontend
