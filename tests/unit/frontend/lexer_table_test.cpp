// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The table from which tokens are read (frontend/parse/lexer_table.h) finds the tokens that ANTLR's
// lexer finds by itself.

#include "frontend/parse/byte_char_stream.h"
#include "frontend/parse/lexeme.h"
#include "grammar/GliderLexer.h"
#include "support/files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>
#include <string_view>

namespace glider::frontend {
namespace {

using grammar::GliderLexer;

std::string line(uint32_t type, uint32_t begin, uint32_t end) {
  return fmt::format("{} {} {}\n", type, begin, end);
}

/// The words of `sample` are names elsewhere.
uint32_t outsideSample(size_t type) {
  const bool word =
      type == GliderLexer::SAMPLE || (type >= GliderLexer::OFF && type <= GliderLexer::ONE);
  return word ? uint32_t{GliderLexer::NAME} : static_cast<uint32_t>(type);
}

/// One line a token, by ANTLR alone.
std::string byAntlr(std::string_view text) {
  ByteCharStream stream(text, 0);
  GliderLexer lexer(&stream);
  lexer.removeErrorListeners();
  std::string out;
  for (;;) {
    const auto token = lexer.nextToken();
    if (token->getType() == antlr4::Token::EOF) {
      return out;
    }
    out += line(outsideSample(token->getType()), static_cast<uint32_t>(token->getStartIndex()),
                static_cast<uint32_t>(token->getStopIndex() + 1));
  }
}

/// The same by what the frontend uses.
std::string byTable(std::string_view text) {
  std::string out;
  auto lexemes = lex(text, 0);
  EXPECT_EQ(lexemes.back().begin, text.size());
  lexemes.pop_back();
  for (const Lexeme& lexeme : lexemes) {
    out += line(lexeme.type, lexeme.begin, lexeme.end);
  }
  return out;
}

/// The second time, all that can be in the table is in it. Something is shared: else `a.b` would be
/// divided.
void expectSame(std::string_view rest) {
  const std::string text = "share " + std::string(rest);
  const std::string expected = byAntlr(text);
  EXPECT_EQ(byTable(text), expected) << text;
  EXPECT_EQ(byTable(text), expected) << text;
}

TEST(LexerTable, ANameWithAPointIsOneTokenWhereSomethingIsShared) {
  const std::string heard = line(GliderLexer::HEARD, 10, 17);
  EXPECT_EQ(byTable("vehicles  ada.top"), line(GliderLexer::VEHICLES, 0, 8) + heard);
  EXPECT_EQ(byTable("share     ada.top"), line(GliderLexer::SHARE, 0, 5) + heard);
  EXPECT_EQ(byTable("          peer.to"), heard);
  EXPECT_EQ(byTable("          end.min"), line(GliderLexer::END, 10, 13) +
                                              line(GliderLexer::FOREIGN, 13, 14) +
                                              line(GliderLexer::MIN, 14, 17));
  EXPECT_EQ(byTable("          ada.t_1 ada..b"),
            line(GliderLexer::NAME, 10, 13) + line(GliderLexer::FOREIGN, 13, 14) +
                line(GliderLexer::NAME, 14, 17) + line(GliderLexer::NAME, 18, 21) +
                line(GliderLexer::RANGE, 21, 23) + line(GliderLexer::NAME, 23, 24));
}

TEST(LexerTable, HasTheTokensOfTheLibrary) {
  const auto text = support::readFile(GLIDER_SOURCE_DIR "/missions/library/standard.mission");
  ASSERT_TRUE(text.has_value());
  expectSame(*text);
}

TEST(LexerTable, EndsTokensWhereTheGrammarDoes) {
  for (const std::string_view text : {"",
                                      " ",
                                      "m",
                                      "1",
                                      "1.",
                                      "1..2",
                                      "1.5e",
                                      "1.5e+",
                                      "1e5x",
                                      "missiontime mission min minute",
                                      "2026-11-25T12:00Z",
                                      "2026-11-25T12:0",
                                      "2026-11-25",
                                      "\"a\\\"b\" \"open",
                                      "\"open\n\"",
                                      "/* a */ b /* c",
                                      "/**/ /***/ x",
                                      "// only\nx # end",
                                      "a=>b==c===d!==e!=f<>g",
                                      "39° 10.5′ N",
                                      "\x80\xFF x",
                                      "a&&b&c||d|e",
                                      "deg degC degCx d",
                                      "5% 5%%"}) {
    expectSame(text);
    expectSame(std::string(text) + "\nstate s");
  }
}

TEST(LexerTable, HasTheTokensOfRandomTexts) {
  constexpr std::array<std::string_view, 40> kParts = {
      "a",  "E",  "e",   "0",   "9",   ".",   "..", "-", ":",    "T",    "Z",  "\"", "\\", "\n",
      " ",  "/",  "*",   "/*",  "*/",  "//",  "#",  "&", "|",    "=",    "<",  ">",  "!",  ";",
      "de", "gC", "min", "ute", "sta", "te ", "or", "°", "\xC2", "2026", "-1", "("};
  for (uint32_t seed = 0; seed < 300; ++seed) {
    std::mt19937 rng(seed);
    std::string text;
    for (int i = 0; i < 60; ++i) {
      text += kParts[rng() % kParts.size()];
    }
    expectSame(text);
  }
}

}  // namespace
}  // namespace glider::frontend
