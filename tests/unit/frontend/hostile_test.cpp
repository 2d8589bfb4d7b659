// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Bytes that no pilot writes: each gets a clear word, none harms the compiler.

#include "support/diagnostics/ids/syntax.h"
#include "tests/unit/frontend/compile.h"

namespace glider::frontend {
namespace {

using testing_support::FrontendRun;
using testing_support::readSource;

constexpr std::string_view kMission =
    "mission test\nstate s1\nbegin\n  flightprofile surfaced\nend\n";

std::string repeat(std::string_view text, size_t times) {
  std::string out;
  for (size_t i = 0; i < times; ++i) {
    out += text;
  }
  return out;
}

TEST(Hostile, Empty) {
  for (const char* text : {"", "  \n\t\r\n", "# nothing", "/* nothing */", "\xEF\xBB\xBF"}) {
    FrontendRun run(text);
    EXPECT_FALSE(run.parse().has_value());
    EXPECT_TRUE(run.says(support::diagnostics::emptyFile)) << run.said();
  }
}

// GL1015, accepts: GL1015
TEST(Hostile, ZeroByte) {
  FrontendRun run(std::string(kMission) + '\0' + std::string(kMission));
  EXPECT_FALSE(run.parse().has_value());
  EXPECT_TRUE(run.says(support::diagnostics::nulByte));
  EXPECT_EQ(run.diagnostics.errorCount(), 1U);
}

// GL1016, accepts: GL1016
TEST(Hostile, Utf16) {
  FrontendRun run(std::string("\xFF\xFEm\0i\0s\0", 8));
  EXPECT_FALSE(run.parse().has_value());
  EXPECT_TRUE(run.says(support::diagnostics::utf16));
}

TEST(Hostile, ByteOrderMarkOfUtf8IsSkipped) {
  FrontendRun run("\xEF\xBB\xBF" + std::string(kMission));
  EXPECT_TRUE(run.parse().has_value()) << run.said();
}

// GL1014, accepts: GL1014
TEST(Hostile, BadUtf8) {
  // Latin-1, a cut character, an overlong one, a surrogate, beyond U+10FFFF, a stray continuation.
  for (const char* text : {"# \xE9\n", "# \xE2\x82", "# \xC0\x80\n", "# \xED\xA0\x80\n",
                           "# \xF4\x90\x80\x80\n", "# \x80\n"}) {
    FrontendRun run(std::string(kMission) + text);
    run.parse();
    EXPECT_TRUE(run.says(support::diagnostics::notUtf8)) << text;
    EXPECT_EQ(run.diagnostics.errorCount(), 1U) << run.said();
  }
  FrontendRun good(std::string(kMission) + "# é € 𝄞 \xED\x9F\xBF\n");
  EXPECT_TRUE(good.parse().has_value()) << good.said();
}

// GL1028
TEST(Hostile, TenMegabytes) {
  for (std::string_view piece : {"(", "@", "mission ", "\xFF", "\"", "/*", "1 "}) {
    FrontendRun run(repeat(piece, 10'000'000 / piece.size()));
    EXPECT_FALSE(run.parse().has_value());
    EXPECT_TRUE(run.says(support::diagnostics::fileTooLarge));
  }
}

TEST(Hostile, MuchOfOneThing) {
  for (std::string_view piece : {"(",
                                 ")",
                                 "[",
                                 "{",
                                 "@",
                                 "mission ",
                                 "state ",
                                 "begin ",
                                 "end ",
                                 "if ",
                                 "do ",
                                 "case ",
                                 "\"",
                                 "\"\n",
                                 "/*",
                                 "1 ",
                                 "x ",
                                 "- ",
                                 "! ",
                                 "= ",
                                 ", ",
                                 "const x = ",
                                 "state s begin ",
                                 "goto ",
                                 "flightprofile ",
                                 "é",
                                 "\xFF",
                                 "5 N ",
                                 "a.b",
                                 "every "}) {
    FrontendRun run("mission test state s begin events case " + repeat(piece, 20'000));
    run.parse();
    EXPECT_TRUE(run.diagnostics.hasErrors()) << piece;
    EXPECT_LE(run.diagnostics.errorCount(), 305U) << piece;
  }
}

TEST(Hostile, NestedInEveryWay) {
  const std::string head = "mission test\nconst a = ";
  for (const std::string& text : {head + repeat("(", 10'000) + "5" + repeat(")", 10'000),
                                  head + repeat("abs(", 10'000) + "5" + repeat(")", 10'000),
                                  head + repeat("[", 10'000) + repeat("]", 10'000),
                                  "mission m state s begin entry do " +
                                      repeat("if true then ", 10'000) + repeat("end ", 10'002)}) {
    FrontendRun run(text);
    EXPECT_FALSE(run.parse().has_value());
    EXPECT_TRUE(run.says(support::diagnostics::nestedTooDeep));
    EXPECT_EQ(run.diagnostics.errorCount(), 1U) << run.said();
  }
  for (const std::string& text :
       {head + "1" + repeat(" + 1", 100'000), head + repeat("-", 100'000) + "1",
        head + repeat("!", 100'000) + "true",
        head + repeat("(1 + ", 190) + "1" + repeat(" + 1)", 190) + repeat(" * 1", 1000)}) {
    FrontendRun run(text);
    EXPECT_FALSE(run.parse().has_value());
    EXPECT_TRUE(run.says(support::diagnostics::expressionTooLong)) << run.said();
  }
}

TEST(Hostile, TheDeepestThatIsAllowed) {
  const std::string tail = "\nstate s1 begin flightprofile surfaced events case a > 0 exit end\n";
  for (const std::string& text :
       {"1" + repeat(" + 1", 1000), repeat("(", 200) + "5" + repeat(")", 200),
        repeat("-", 1000) + "1", repeat("(1 + ", 200) + "1" + repeat(")", 200)}) {
    FrontendRun run("mission test\nconst a = " + text + tail);
    EXPECT_TRUE(run.compile().has_value()) << run.said().substr(0, 2000);
  }
}

/// Each is an expression of its own.
TEST(Hostile, ManyAssumptions) {
  FrontendRun run("mission test\n" + repeat("assume temp > -2 degC || altitude > 5 m\n", 1'100) +
                  "state s begin flightprofile surfaced events case missiontime > 0 s exit end\n");
  EXPECT_TRUE(run.compile().has_value()) << run.said().substr(0, 2000);
}

TEST(Hostile, EveryPrefixOfFigure2) {
  const std::string whole = readSource("missions/figure2.mission");
  for (size_t length = 0; length < whole.size(); length += 3) {
    FrontendRun run(whole.substr(0, length));
    run.compile();
    EXPECT_LE(run.diagnostics.errorCount(), 6U) << run.said();
  }
}

TEST(Hostile, NoWordOfTheParserGeneratorReachesThePilot) {
  const std::string whole = readSource("tests/golden/parse/ok_language.mission");
  for (size_t at = 0; at + 12 < whole.size(); at += 7) {
    FrontendRun run(whole.substr(0, at) + whole.substr(at + 11));
    run.parse();
    const std::string said = run.said();
    for (std::string_view word :
         {"viable", "mismatched", "extraneous", "<EOF>", "LPAREN", "NAME", "token recognition"}) {
      EXPECT_EQ(said.find(word), std::string::npos) << said;
    }
  }
}

}  // namespace
}  // namespace glider::frontend
