// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The layout that `format` gives, case by case. Each example is also formatted twice.

#include "frontend/format/format.h"

#include "tests/unit/frontend/compile.h"

#include <filesystem>

namespace glider::frontend {
namespace {

using testing_support::FrontendRun;

std::string formatted(const std::string& text) {
  FrontendRun run(text);
  const auto result = format(run.sources, run.file, run.diagnostics);
  EXPECT_TRUE(result.has_value()) << run.said() << text;
  return result.value_or("");
}

/// `text` formats to `expected`, and that to itself.
void expectFormat(const std::string& text, const std::string& expected) {
  EXPECT_EQ(formatted(text), expected);
  EXPECT_EQ(formatted(expected), expected);
}

/// A mission with one state whose events are `cases`, indented as they should be.
std::string inState(const std::string& cases) {
  return "mission m\n\nstate s\nbegin\n  flightprofile surfaced\n  events\n" + cases + "end\n";
}

/// Where it declares one: it may also name a state.
TEST(Format, APlaceBeginsALine) {
  expectFormat("mission a place deep=depth>10 m place up = depth<2 m require whenever deep then up",
               "mission a\nplace deep = depth > 10 m\nplace up = depth < 2 m\n"
               "require whenever deep then up\n");
  expectFormat("require never place after\nup", "require never place after up\n");
}

TEST(Format, ResumeAlwaysBeginsALine) {
  EXPECT_EQ(formatted("mission a resume within 5 min,never\nafter restart"),
            "mission a\nresume within 5 min, never after restart\n");
  EXPECT_EQ(formatted("resume within 5 min mission a resume within 1 h"),
            "resume within 5 min\nmission a\nresume within 1 h\n");
}

TEST(Format, AWholeState) {
  expectFormat(
      "mission m platform slocum import \"a/b\"  const d=30m state s(to:position)begin flightroute "
      "nav( 39.175 N ,73.830W )flightprofile yo (5,10m,.454,.454) sensors depth,temp every 8s "
      "events case depth>5m goto s case true exit end",
      "mission m\nplatform slocum\nimport \"a/b\"\nconst d = 30 m\n\nstate s(to: position)\nbegin\n"
      "  flightroute   nav(39.175 N, 73.830 W)\n  flightprofile yo(5, 10 m, .454, .454)\n"
      "  sensors       depth, temp every 8 s\n  events\n    case depth > 5 m goto s\n"
      "    case true        exit\nend\n");
}

TEST(Format, SpacesAroundOperators) {
  const std::pair<const char*, const char*> examples[] = {
      {"-  5-3*-  2/( 4 )", "-5 - 3 * -2 / (4)"},
      {"! a&&b||! ( c )", "!a && b || !(c)"},
      {"5 degC / m * s", "5 degC/m*s"},
      {"5m/2s", "5 m / 2 s"},
      {"5 m/min ( 2,3 )", "5 m / min(2, 3)"},
      {"50%", "50 %"},
      {"[39.0N 74.0W,39.0 N 73.5 W]", "[39.0 N 74.0 W, 39.0 N 73.5 W]"},
      {"track [ 2 ]+spread ( temp,10m of depth )", "track[2] + spread(temp, 10 m of depth)"},
      {"[ ]", "[]"},
      {"done-in", "done - in"},
  };
  for (const auto& [text, expected] : examples) {
    expectFormat("mission m const a=" + std::string(text),
                 "mission m\nconst a = " + std::string(expected) + "\n");
  }
}

TEST(Format, WordsThatAreNamesElsewhere) {
  expectFormat(
      "mission stack param p:length=5m in(1m)..in(2)where(p>1m) require stack<=2 "
      "require exit within(6h) extern sensor range:length extern flightprofile f(a:length)reads in "
      "extern function after(stale:time):time in-1s..stale extern sensor stale:length in 0..1m "
      "stale "
      "after-stale",
      "mission stack\nparam p: length = 5 m in (1 m) .. in(2) where (p > 1 m)\n"
      "require stack <= 2\nrequire exit within (6 h)\nextern sensor range: length\n"
      "extern flightprofile f(a: length) reads in\n"
      "extern function after(stale: time): time in -1 s .. stale\n"
      "extern sensor stale: length in 0 .. 1 m stale after -stale\n");
}

TEST(Format, VehiclesBeginALineWhereTheyAreNoName) {
  expectFormat(
      "mission a vehicles ada,\nbob share vehicles in 0..9 precision 1 every 1 h "
      "assume vehicles<=9 require always peers within(2 km)<2",
      "mission a\nvehicles ada, bob\nshare vehicles in 0 .. 9 precision 1 every 1 h\n"
      "assume vehicles <= 9\nrequire always peers within (2 km) < 2\n");
}

TEST(Format, WhatIsReceivedIsAValue) {
  expectFormat(
      inState("case peer.top-depth>-3 m && known(peer.top)  do set a = peer.top -b end goto s\n"),
      inState("    case peer.top - depth > -3 m && known(peer.top) do set a = peer.top - b end "
              "goto s\n"));
}

TEST(Format, DeclarationsAreAligned) {
  expectFormat(
      "mission m\nvar upper:length=5m in 3m..24m\nvar low:temperature/length=.5degC/m in 9..10\n\n"
      "const a=1\nconst bcd=2",
      "mission m\nvar upper: length             = 5 m       in 3 m .. 24 m\n"
      "var low  : temperature/length = .5 degC/m in 9 .. 10\n\nconst a   = 1\nconst bcd = 2\n");
}

TEST(Format, BlocksWrittenOnOneLineStayThere) {
  expectFormat(inState("case !known(depth) do ascend(5 m) end stay\n"
                       "case depth > 5 m do end goto s\n"),
               inState("    case !known(depth) do ascend(5 m) end stay\n"
                       "    case depth > 5 m   do             end goto s\n"));
  expectFormat(inState("case true do if a then hover(5 m) else set b = 5 end end goto s\n"),
               inState("    case true do if a then hover(5 m) else set b = 5 end end goto s\n"));
}

TEST(Format, OtherBlocksHaveALineAStatement) {
  expectFormat(inState("case true do set a = b hover(5 m) log \"x\", depth end call s(1,\n2)\n"),
               inState("    case true do\n      set a = b\n      hover(5 m)\n"
                       "      log \"x\", depth\n    end call s(1, 2)\n"));
  expectFormat(
      inState("case true\ndo if a then\nset b = 1 else if c then hover(1 m) end end end return\n"
              "case false do\nend exit\n"),
      inState("    case true do\n      if a then\n        set b = 1\n      else\n"
              "        if c then hover(1 m) end\n      end\n    end return\n    case false do\n"
              "    end exit\n"));
}

TEST(Format, Loops) {
  expectFormat(
      inState(
          "case true do for i in 0..3 do set a [i]=i for j in 0 .. i do log \"j\", j end end end "
          "stay\ncase for>1 do set for=for+1 for k in 0 .. 1 do push(a,k) end end stay\n"),
      inState("    case true do\n      for i in 0 .. 3 do\n        set a[i] = i\n"
              "        for j in 0 .. i do log \"j\", j end\n      end\n    end stay\n"
              "    case for > 1 do\n      set for = for + 1\n"
              "      for k in 0 .. 1 do push(a, k) end\n    end stay\n"));
}

TEST(Format, CommentsKeepTheirPlace) {
  expectFormat(
      "# head  \n\n\n// second\nmission m# name\n   /* of s */ state s /* s */ # why\n"
      "#begins\nbegin\n\n# how\nflightprofile surfaced// at the top\n\n\n#when\nevents\n"
      "#none\n\n  # none of two\ncase a # first\n && /* b */ b # second\n # third\n goto s "
      "#there\n# case c exit\n\nend# s\n\n\n# end",
      "# head\n\n// second\nmission m  # name\n\n/* of s */ state s  /* s */ # why\n"
      "#begins\nbegin\n  # how\n  flightprofile surfaced  // at the top\n\n  #when\n"
      "  events\n    #none\n\n    # none of two\n    case a  # first\n"
      "        && /* b */ b  # second\n        # third\n        goto s  #there\n"
      "    # case c exit\nend  # s\n\n# end\n");
}

TEST(Format, RemarksAreAligned) {
  expectFormat("mission m # a\nplatform slocum /* b */\n\nconst a = 5 # c\n",
               "mission m        # a\nplatform slocum  /* b */\n\nconst a = 5  # c\n");
}

TEST(Format, RemarksThatCannotBeAlignedFollowTheirText) {
  const std::string longer = "mission with_quite_a_long_name";
  const std::string shorter = "platform slocum";
  const auto both = [&](size_t gap, size_t remark) {
    return longer + "  # one\n" + shorter + std::string(gap, ' ') + "# " +
           std::string(remark, 'x') + "\n";
  };
  const size_t column = longer.size() + 2;
  const size_t most = 100 - column - 2;  // what fits behind `# ` in a line of 100
  EXPECT_EQ(formatted(both(1, most)), both(column - shorter.size(), most));
  EXPECT_EQ(formatted(both(1, most + 1)), both(2, most + 1));
}

TEST(Format, BlankLines) {
  expectFormat(
      "\n\nmission m\n\n\n\nconst a = 1\nstate s begin flightprofile p end const b = 2\n"
      "const c = 3\nalways\n\ncase true exit\n\n\ncase false exit\n\n\n",
      "mission m\n\nconst a = 1\n\nstate s\nbegin\n  flightprofile p\nend\n\nconst b = 2\n"
      "const c = 3\n\nalways\n\n  case true exit\n\n  case false exit\n");
}

TEST(Format, LongLinesAreBroken) {
  const std::string words = "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa";
  expectFormat(
      inState("case " + words + " > 5 m && " + words + " < 1 m && x goto s\n"),
      inState("    case " + words + " > 5 m &&\n        " + words + " < 1 m && x goto s\n"));
  expectFormat(
      "mission m const a = f(" + words + ", " + words + ", " + words + ")",
      "mission m\nconst a = f(" + words + ", " + words + ",\n            " + words + ")\n");
  expectFormat(inState("case " + words + words + words + " do set a = 1 end stay\n"),
               inState("    case " + words + words + words +
                       "\n        do\n      set a = 1\n"
                       "    end stay\n"));
}

TEST(Format, AListBrokenAfterItsBracketHasALineAnItem) {
  expectFormat(
      "mission m\nconst pier = [\n39.0 N 74.0 W, # pier\n 39.0 N 73.5 W, /* b */ f(1,\n2)]\n",
      "mission m\nconst pier = [\n  39.0 N 74.0 W,  # pier\n  39.0 N 73.5 W, /* b */\n"
      "  f(1, 2)\n]\n");
}

TEST(Format, OddBytes) {
  expectFormat("\xEF\xBB\xBFmission m\r\n# caf\xC3\xA9 \r\n/* a \r\n   b */\r\nconst a = 5\r",
               "mission m\n# caf\xC3\xA9\n/* a\n   b */\nconst a = 5\n");
}

TEST(Format, ErrorsAreReportedAndNothingIsMade) {
  FrontendRun run("mission m\nconst a = = 5\n");
  EXPECT_FALSE(format(run.sources, run.file, run.diagnostics).has_value());
  EXPECT_NE(run.said(), "");
  FrontendRun mended("mission m\nconst a == 5\n");
  EXPECT_FALSE(format(mended.sources, mended.file, mended.diagnostics).has_value());
}

}  // namespace
}  // namespace glider::frontend
