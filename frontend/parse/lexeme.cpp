// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/lexeme.h"

#include "frontend/parse/byte_char_stream.h"
#include "frontend/parse/lexer_table.h"
#include "frontend/parse/token_kinds.h"
#include "frontend/spelling.h"
#include "grammar/GliderLexer.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::frontend {

using grammar::GliderLexer;

namespace {

/// Where the next token may begin. The grammar also skips white space, but one token at a time,
/// which is a quarter of the work on an indented mission.
size_t pastBlanks(std::string_view text, size_t at) {
  const size_t next = text.find_first_not_of(" \t\r\n\f", at);
  return next == std::string_view::npos ? text.size() : next;
}

/// Whether a line `sample` goes on with it.
bool goesOnInSample(uint32_t type) {
  return !isHardKeyword(type) ||
         oneOf(type,
               {GliderLexer::SAMPLE, GliderLexer::EVERY, GliderLexer::TRUE, GliderLexer::FALSE,
                GliderLexer::AND_WORD, GliderLexer::OR_WORD, GliderLexer::NOT_WORD});
}

/// `sample` is a keyword before a name, and its words are keywords behind it: elsewhere they are
/// names.
void nameOutsideSample(std::string_view text, std::vector<Lexeme>& lexemes) {
  bool in_sample = false;
  for (size_t i = 0; i + 1 < lexemes.size(); ++i) {
    Lexeme& one = lexemes[i];
    Lexeme& next = lexemes[i + 1];
    in_sample = in_sample && goesOnInSample(one.type);
    if (one.type == GliderLexer::SAMPLE) {
      in_sample = next.type == GliderLexer::NAME;
      one.type = in_sample ? one.type : uint32_t{GliderLexer::NAME};
    } else if (one.type >= GliderLexer::OFF && one.type <= GliderLexer::ONE && !in_sample) {
      one.type = GliderLexer::NAME;
    } else if (one.type == GliderLexer::ONE &&
               text.substr(next.begin, next.end - next.begin) == "yo") {
      next.type = GliderLexer::YO;
    }
  }
}

std::vector<Lexeme> readLexemes(std::string_view text, size_t start) {
  ByteCharStream stream(text, start);
  GliderLexer lexer(&stream);
  lexer.removeErrorListeners();
  LexerTable table(lexer);
  constexpr size_t kBytesPerToken = 4;
  std::vector<Lexeme> lexemes;
  lexemes.reserve(text.size() / kBytesPerToken + 1);
  const auto end = static_cast<uint32_t>(text.size());
  for (size_t at = pastBlanks(text, start); at < end; at = pastBlanks(text, at)) {
    if (const auto known = table.tokenAt(text, at)) {
      if (known->type != 0) {
        lexemes.push_back(
            {known->type, static_cast<uint32_t>(at), static_cast<uint32_t>(known->end)});
      }
      at = known->end;
      continue;
    }
    stream.seek(at);
    const auto token = lexer.nextToken();
    if (token->getType() == antlr4::Token::EOF) {
      break;
    }
    at = token->getStopIndex() + 1;
    lexemes.push_back({static_cast<uint32_t>(token->getType()),
                       static_cast<uint32_t>(token->getStartIndex()), static_cast<uint32_t>(at)});
  }
  lexemes.push_back({static_cast<uint32_t>(antlr4::Token::EOF), end, end});
  nameOutsideSample(text, lexemes);
  return lexemes;
}

/// `look.deep` is an error where nothing is received, which phrases and names repair: three
/// tokens.
std::vector<Lexeme> divided(std::string_view text, const std::vector<Lexeme>& lexemes) {
  constexpr std::string_view kPeer = "peer.";
  const auto part = [text](uint32_t begin, uint32_t end) {
    return Lexeme{readLexemes(text.substr(begin, end - begin), 0).front().type, begin, end};
  };
  std::vector<Lexeme> all;
  all.reserve(lexemes.size());
  for (const Lexeme& whole : lexemes) {
    if (whole.type != GliderLexer::HEARD || text.substr(whole.begin).starts_with(kPeer)) {
      all.push_back(whole);
      continue;
    }
    const auto point = static_cast<uint32_t>(text.find('.', whole.begin));
    all.push_back(part(whole.begin, point));
    all.push_back({GliderLexer::FOREIGN, point, point + 1});
    all.push_back(part(point + 1, whole.end));
  }
  return all;
}

}  // namespace

std::vector<Lexeme> lex(std::string_view text, size_t start) {
  const std::vector<Lexeme> lexemes = readLexemes(text, start);
  const bool talks = std::ranges::any_of(lexemes, [](const Lexeme& lexeme) {
    return lexeme.type == GliderLexer::SHARE || lexeme.type == GliderLexer::VEHICLES;
  });
  return talks ? lexemes : divided(text, lexemes);
}

std::vector<Lexeme> lex(const Source& source) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  return lex(source.text(), source.text().starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0);
}

bool isStateName(const Source& source, std::string_view word) {
  constexpr std::string_view kState = "state";
  constexpr std::string_view kBlank = " \t\r\n";
  const std::string_view text = source.text();
  for (size_t at = text.find(kState); at != std::string_view::npos;
       at = text.find(kState, at + 1)) {
    const std::string_view rest = text.substr(at + kState.size());
    const size_t name = rest.find_first_not_of(kBlank);
    if (name == std::string_view::npos || name == 0) {
      continue;
    }
    const std::string_view follows = rest.substr(name);
    if (follows.starts_with(word) &&
        (follows.size() == word.size() || kBlank.contains(follows[word.size()]))) {
      return true;
    }
  }
  return false;
}

namespace detail {

constinit const std::array<uint8_t, kMostTypes> kGroups = [] {
  static_assert(GliderLexer::FOREIGN < kMostTypes);
  std::array<uint8_t, kMostTypes> groups{};
  const auto mark = [&](size_t first, size_t last, uint8_t group) {
    for (size_t type = first; type <= last; ++type) {
      groups[type] = static_cast<uint8_t>(groups[type] | group);
    }
  };
  mark(GliderLexer::MISSION, GliderLexer::NOT_WORD, kHardKeyword);
  // `min` follows the last one.
  mark(GliderLexer::IN, GliderLexer::MIN - 1, kSoftKeyword | kName | kAnyName);
  mark(GliderLexer::NAME, GliderLexer::NAME, kName | kAnyName);
  mark(GliderLexer::MIN, GliderLexer::MIN, kAnyName);
  mark(GliderLexer::UNIT, GliderLexer::COMPASS, kAnyName);
  return groups;
}();

}  // namespace detail

namespace {

/// "`begin`" as in ANTLR's vocabulary, without quotes; empty for a token with several spellings.
std::string spelling(size_t type) {
  static ByteCharStream empty("", 0);
  static const GliderLexer lexer(&empty);
  const std::string literal = lexer.getVocabulary().getLiteralName(type);
  return literal.size() > 2 ? literal.substr(1, literal.size() - 2) : std::string();
}

const std::vector<std::string>& keywordSpellings() {
  static const std::vector<std::string> words = [] {
    std::vector<std::string> list;
    for (size_t type = GliderLexer::MISSION; type <= GliderLexer::NOT_WORD; ++type) {
      list.push_back(spelling(type));
    }
    return list;
  }();
  return words;
}

}  // namespace

const std::vector<std::string_view>& hardKeywords() {
  static const std::vector<std::string_view> words(keywordSpellings().begin(),
                                                   keywordSpellings().end());
  return words;
}

uint32_t keywordType(std::string_view word) {
  const auto found = std::ranges::find(hardKeywords(), word);
  return found == hardKeywords().end()
             ? 0
             : static_cast<uint32_t>(GliderLexer::MISSION + (found - hardKeywords().begin()));
}

bool isSlip(std::string_view word, std::string_view meant) {
  constexpr size_t kShortest = 3;
  const std::string small = inLowerCase(word);
  const auto near = [&](std::string_view keyword) { return editDistance(small, keyword) <= 1; };
  return word.size() >= kShortest && near(meant) &&
         (small == meant || std::ranges::count_if(hardKeywords(), near) == 1);
}

std::string describe(const Source& source, const Lexeme& lexeme) {
  constexpr size_t kLongestShown = 40;
  if (lexeme.type == static_cast<uint32_t>(antlr4::Token::EOF)) {
    return "the end of the file";
  }
  std::string text(source.text(lexeme));
  if (text.empty()) {
    return describeType(lexeme.type);
  }
  if (text.size() > kLongestShown) {
    size_t cut = kLongestShown;
    while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xC0U) == 0x80U) {
      --cut;  // not inside a character
    }
    text = text.substr(0, cut) + "…";
  }
  switch (lexeme.type) {
    case GliderLexer::NUMBER:
      return fmt::format("the number `{}`", text);
    case GliderLexer::INSTANT:
      return fmt::format("the time `{}`", text);
    case GliderLexer::STRING:
      return fmt::format("the string `{}`", text);
    case GliderLexer::UNIT:
      return fmt::format("the unit `{}`", text);
    default:
      return fmt::format("`{}`", text);
  }
}

std::string describeType(uint32_t type) {
  switch (type) {
    case static_cast<uint32_t>(antlr4::Token::EOF):
      return "the end of the file";
    case GliderLexer::NAME:
      return "a name";
    case GliderLexer::NUMBER:
      return "a number";
    case GliderLexer::INSTANT:
      return "a time such as `2026-11-25T12:00Z`";
    case GliderLexer::STRING:
      return "a string in quotes";
    case GliderLexer::UNIT:
    case GliderLexer::MIN:
      return "a unit";
    case GliderLexer::COMPASS:
      return "`N`, `S`, `E` or `W`";
    case GliderLexer::YO:
      return "`yo`";
    default:
      return "`" + spelling(type) + "`";
  }
}

}  // namespace glider::frontend
