// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Suggested fixes, applied, give a mission without that error.

#include "support/diagnostics/fixes.h"

#include "frontend/constructs.h"
#include "support/diagnostics/ids/meaning.h"
#include "support/diagnostics/ids/syntax.h"
#include "tests/unit/frontend/compile.h"

#include <algorithm>

namespace glider::frontend {
namespace {

using testing_support::FrontendRun;

std::string mission(const std::string& guard, const std::string& sensors = "sensors depth, temp") {
  return "mission test\nstate s1\nbegin\n  flightprofile surfaced\n  " + sensors +
         "\n  events\n    case " + guard + " exit\nend\n";
}

/// The text with every fix-it applied, last place first.
std::string fixed(FrontendRun& run) {
  std::string text = run.sources.text(run.file);
  std::vector<support::FixIt> fixes;
  for (const support::Diagnostic& d : run.diagnostics.sorted()) {
    fixes.insert(fixes.end(), d.fixes.begin(), d.fixes.end());
  }
  std::ranges::sort(fixes,
                    [](const auto& a, const auto& b) { return a.range.begin > b.range.begin; });
  for (const support::FixIt& fix : fixes) {
    text.replace(fix.range.begin, fix.range.end - fix.range.begin, fix.replacement);
  }
  return text;
}

/// What `glidercc fix` leaves of `text`.
std::string automatic(const std::string& text) {
  const support::FixReader reader{
      [](const std::string& candidate) -> support::Result<std::vector<support::Diagnostic>> {
        FrontendRun run(candidate);
        (void)run.compile();
        return run.diagnostics.sorted();
      },
      [](const std::string& candidate) { return constructsOf(candidate); }};
  return support::fixAll(text, 0, reader)->text;
}

class Fixes : public testing::TestWithParam<std::string> {};

TEST_P(Fixes, LeaveNothingToSay) {
  FrontendRun broken(GetParam());
  broken.compile();
  ASSERT_NE(broken.said(), "");
  FrontendRun mended(fixed(broken));
  EXPECT_TRUE(mended.compile().has_value()) << mended.sources.text(mended.file);
  EXPECT_EQ(mended.said(), "") << mended.sources.text(mended.file);
}

INSTANTIATE_TEST_SUITE_P(
    All, Fixes,
    testing::Values(
        mission("depth > 5 m;"), mission("depth => 5 m"), mission("depth > 5 m & temp < 3"),
        mission("depth > 5 m and temp < 3"), mission("!depth > 5 m"), mission("depth ≥ 5 m"),
        mission("depth > 5 metres"), mission("depth > 5. "), mission("max(depth 5 m) > 3"),
        mission("5 m < depth < 10 m"), mission("pitch > 5 deg"), mission("pitch > 5 deg", ""),
        mission("depth > 5 m", "sensors depth temp"), mission("depth > 5 m", "sensors depth begin"),
        mission("depth > 5 m", "flightroute nav(3910.5 -7349.8)"),
        mission("depth > 5 m", "flightroute nav(3910.5, -73.8)"),
        mission("!(min(depth; -3 m) > 5 m)"),
        mission("depth > 5 m", "flightroute nav(39 10.5 N, 73 49.8 W)"), mission("true") + "end\n",
        mission("true").replace(22, 5, "begni"), mission("depth > 5 m AND temp > 3"),
        mission("depth > 5,5 m"), mission("depth > 5 m then"), mission("depth > 5 m:"),
        mission("depth > 5 m", "sensors depth, temp,"),
        mission("depth > 5 m", "sensors = depth, temp"), mission("depth > 5 m do log “deep” end"),
        mission("depth\xC2\xA0> 5 m"), mission("depth > 5 m { log \"a\" }"),
        mission("case depth > 5 m"),
        mission("true").replace(22, 5, "{").replace(mission("true").size() - 8, 3, "}")));

/// What only the pilot can decide: the hint says how, and no fix is offered.
class NoFix : public testing::TestWithParam<std::string> {};

TEST_P(NoFix, WhereTheMeaningIsNotCertain) {
  FrontendRun broken(GetParam());
  broken.compile();
  bool hinted = false;
  for (const support::Diagnostic& d : broken.diagnostics.sorted()) {
    EXPECT_TRUE(d.fixes.empty()) << broken.said();
    hinted = hinted || !d.hint.empty();
  }
  EXPECT_TRUE(hinted) << broken.said();
}

const std::string kNav = "sensors missiontime, depth, temp flightroute ";

INSTANTIATE_TEST_SUITE_P(
    All, NoFix,
    testing::Values(
        mission("temp = 20 degC"), mission("temp === 20 degC"), mission("temp !== 20 degC"),
        mission("temp <> 20 degC"), mission("temp ≠ 20 degC"),
        mission("depth > 5 m || temp > 3) && missiontime > 1 h",
                "sensors missiontime, depth, temp"),
        mission("20 degrees < temp"), mission("5 m < depth > 3 m"), mission("(depth 5 m) > 3 m"),
        mission("depth > 5·3 m"), mission("depth > 5 m", kNav + "nav(-39.1 N, 73.8 W)"),
        mission("depth > 5 m", kNav + "nav(39.1 N, -73.8 W)"),
        mission("depth > 5 m", kNav + "nav(39.1, 53.8 W)"),
        mission("depth > 5 m", kNav + "nav(39 75 N, 73.8 W)"),
        mission("depth > 5 m", kNav + "nav(-7349.8, 3910.5)"),
        mission("depth > 5 m", kNav + "nav(73.8 W, 39.1 N)"),
        mission("depth > 5 m", kNav + "nav(73.8 W 39.1 N)"),
        mission("distance(3910.5 -7349.8 , 39.1 N 73.8 W) > 5 m", "sensors depth, lat, lon"),
        // Which of two conditions, values or places is meant.
        mission("depth > 5 m, temp > 3 degC"), mission("temp is 20 degC"), mission("after 1 h"),
        mission("temp > 68 degF"),
        mission("depth > 5 m").replace(0, 12, "mission test const k = (39.2, 73.8)"),
        mission("depth > 5 m").replace(0, 12, "mission test const k = (39.2, -53.8)"),
        mission("depth > 5 m", kNav + "along([39.2 N -73.8 W], 100 m)"),
        mission("depth > 5 m", kNav + "nav(39.2, 73.8)"),
        mission("depth > 5 m").replace(0, 12, "mission test\n% const k = 5 m"),
        mission("depth > 5 m do if temp > 3 degC then log \"a\" elseif depth > 6 m then log \"b\" "
                "end end",
                "sensors depth, temp"),
        mission("depth > 5 m do wait 10 min end"),
        mission("depth > 5 m").replace(0, 12, "mission test\nlength top = 5 m"),
        mission("depth > 5 m").replace(0, 12, "mission test const k = 3910.6 -7349.9"),
        mission("depth > 5 m").replace(0, 12, "mission test const k = -3355.2 1825.4")));

TEST(NoFix, ATransitionIsNeverGuessed) {
  std::string text = mission("depth > 5 m");
  FrontendRun broken(text.replace(text.find("exit"), 4, "exti"));
  broken.compile();
  EXPECT_NE(broken.said().find("did you mean `exit`?"), std::string::npos) << broken.said();
  EXPECT_EQ(broken.said().find("fixed"), std::string::npos);
  for (const support::Diagnostic& d : broken.diagnostics.sorted()) {
    EXPECT_TRUE(d.fixes.empty()) << broken.said();
  }
}

/// A state whose header has a slip; `look` comes first, and `target` is where it leads to.
std::string header(const std::string& written, const std::string& target = "") {
  const std::string to = target.empty() ? "exit" : "goto " + target;
  const std::string first = target.empty() ? ""
                                           : "mission test\nstate look\nbegin\n"
                                             "  flightprofile surfaced\n"
                                             "  sensors missiontime\n  events\n"
                                             "    case missiontime > 1 h " +
                                                 to + "\nend\n";
  const std::string rest = target.empty() ? mission("true").substr(0, 13) : first;
  return rest + "state " + written +
         "\nbegin\n  flightprofile surfaced\n  sensors missiontime\n  events\n"
         "    case missiontime > 2 h exit\nend\n";
}

struct Header {
  std::string written;
  std::string target;
  std::string name;  ///< after the fix; empty: none is applied
};

class Headers : public testing::TestWithParam<Header> {};

/// The `begin` after it is right, and nothing but the name is changed.
TEST_P(Headers, AreOneError) {
  const Header& row = GetParam();
  FrontendRun broken(header(row.written, row.target));
  broken.compile();
  const auto reported = broken.diagnostics.sorted();
  ASSERT_EQ(reported.size(), 1U) << broken.said();
  EXPECT_EQ(support::code(reported[0].id), "GL1081");
  const std::string after = fixed(broken);
  const std::string name = row.name.empty() ? row.written : row.name;
  EXPECT_EQ(after, header(name, row.target));
}

INSTANTIATE_TEST_SUITE_P(
    All, Headers,
    testing::Values(Header{"look:", "", "look"}, Header{"go home", "", "go_home"},
                    Header{"hold-deep", "", "hold_deep"}, Header{"\"look\"", "", "look"},
                    Header{"\"go home\"", "", "go_home"}, Header{"1look", "", ""},
                    Header{"2", "", ""}, Header{"return home", "", "return_home"},
                    Header{"look look", "", "look"}, Header{"look =", "", "look"},
                    Header{"go home", "go_home", "go_home"}, Header{"go home", "home", "home"},
                    Header{"1home", "home", "home"}, Header{"the-home:", "home", "home"}));

/// A quotation mark that opens a string touches the keyword before it.
TEST(Headers, KeepWordsApart) {
  std::string text = header("look", "");
  const size_t at = text.find("mission ");
  ASSERT_NE(at, std::string::npos);
  text.insert(at + 7, "\"");
  FrontendRun broken(text);
  broken.compile();
  const std::string after = fixed(broken);
  EXPECT_EQ(after.substr(at, 8), "mission ") << after;
}

/// What a state is called cannot be known if several of its words are used.
TEST(Headers, OfWhichSeveralWordsAreUsedAreNotFixed) {
  std::string text = header("go home", "home");
  text.replace(text.find("    case missiontime > 1 h"), 4, "    case missiontime > 2 h goto go ");
  FrontendRun broken(text);
  broken.compile();
  EXPECT_TRUE(broken.says(support::diagnostics::nameNotOneWord)) << broken.said();
  EXPECT_EQ(fixed(broken), text);
}

/// `not` reaches further than a comparison: what takes the place of a chain must stay together.
TEST(Fixes, AChainOfComparisonsStaysOneCondition) {
  FrontendRun broken(mission("!(5 m < depth < 10 m)"));
  broken.compile();
  EXPECT_NE(fixed(broken).find("!((5 m < depth && depth < 10 m))"), std::string::npos)
      << fixed(broken);
}

/// `{` before a `begin` says nothing more, and before a word it stays apart from it.
TEST(Fixes, ABraceBesideAWord) {
  const std::string right = mission("depth > 5 m");
  std::string twice = right;
  twice.insert(twice.find("begin"), "{");
  EXPECT_EQ(automatic(twice), right);
  std::string beside = right;
  beside.replace(beside.find("begin\n  "), 8, "{");
  beside.replace(beside.rfind("end"), 3, "}");
  std::string apart = right;
  apart.replace(apart.find("begin\n  "), 8, "begin ");
  EXPECT_EQ(automatic(beside), apart);
}

/// The first of two may be prose, such as a comment that has lost its `#`.
TEST(Fixes, AWordOfTheLineBeforeIsNotTheSameWordTwice) {
  const std::string prose = "neither of them keeps the mission.\n" + mission("depth > 5 m");
  EXPECT_NE(automatic(prose).find("\nmission test"), std::string::npos) << automatic(prose);
  const std::string bare = "and so ends the mission\n" + mission("depth > 5 m");
  EXPECT_NE(automatic(bare).find("\nmission test"), std::string::npos) << automatic(bare);
  EXPECT_EQ(automatic("mission " + mission("depth > 5 m")), mission("depth > 5 m"));
}

/// `events` is written before the first `case`, which stays on its line.
TEST(Fixes, CaseInPlaceOfEvents) {
  std::string text = mission("depth > 5 m");
  text.replace(text.find("events"), 6, "case");
  const std::string after = automatic(text);
  FrontendRun mended(after);
  EXPECT_TRUE(mended.compile().has_value()) << after << mended.said();
}

/// Where a name is missing, `case` is what took its place, and no `events` is missing.
TEST(Fixes, CaseInPlaceOfAName) {
  const std::string text =
      mission("depth > 5 m") + "flightroute case\nbegin\n  entry do steer(0 deg) end\nend\n";
  EXPECT_EQ(automatic(text), text);
}

/// A word after a number is its unit, wrong as it is: no second one is written before it.
TEST(Fixes, AWrongUnitIsNotAMissingOne) {
  for (const std::string word : {"dewg", "dec", "dge"}) {
    const std::string text =
        "mission test\ndeclination -12 " + word + "\n" + mission("depth > 5 m").substr(13);
    EXPECT_EQ(automatic(text).find("deg " + word), std::string::npos) << automatic(text);
  }
}

/// `goto end-it` is the name of a state, wrong as it is.
TEST(Fixes, ANameThatBeginsWithAKeywordIsNotAStrayEnd) {
  std::string text =
      "mission test\nalways\n  case depth > 9 m goto end-it\n" + mission("depth > 5 m").substr(13);
  EXPECT_NE(automatic(text).find("goto end-it"), std::string::npos) << automatic(text);
  text.replace(text.find("goto end-it"), 11, "exit\nend");
  EXPECT_NE(automatic(text).find("exit\n\nstate"), std::string::npos) << automatic(text);
}

/// The next line begins with a keyword that has a letter of another alphabet.
TEST(Fixes, AWordWithAForeignLetterIsNoItemOfAList) {
  const std::string text = mission("depth > 5 m", "sensors depth, temp\n  v\xd0\xb0r top = 3");
  EXPECT_NE(automatic(text).find("temp\n  v\xd0\xb0r"), std::string::npos) << automatic(text);
}

/// Degrees with minutes are whole, and a position is on one line.
TEST(Fixes, APositionIsNotMadeFromWhatMayBeTwoThings) {
  for (const std::string written : {".39.175 N 73.84 W", "39.5 10 N 73 W", "39 deg\nN 73 W"}) {
    const std::string text = mission("depth > 5 m", "flightroute nav(" + written + ")");
    EXPECT_EQ(automatic(text), text);
  }
  const std::string right = mission("depth > 5 m", "flightroute nav(39 deg N, 73 deg 30' W)");
  EXPECT_NE(automatic(right).find("nav(39 N, 73 30 W)"), std::string::npos) << automatic(right);
}

/// An `end` with a letter of another alphabet is there, wrong as it is.
TEST(Fixes, AnEndWithAForeignLetterIsNotMissing) {
  std::string text = mission("depth > 5 m");
  const std::string right = text + text.substr(text.find("state s1")).replace(6, 2, "s2");
  std::string wrong = right;
  wrong.replace(wrong.find("\nend\n") + 1, 1, "\xd0\xb5");
  EXPECT_EQ(automatic(wrong), wrong);
  std::string none = right;
  none.erase(none.find("\nend\n") + 1, 4);
  EXPECT_EQ(automatic(none).find("exit\nend\n\nstate s2"), right.find("exit\nend\nstate s2"));
}

/// A line whose first word may be a misspelt keyword is not prose.
TEST(Fixes, AMisspeltDeclarationIsNoComment) {
  for (const std::string line : {"assnme no outage", "plase home somewhere else"}) {
    const std::string text = "mission test\n" + line + "\n" + mission("depth > 5 m").substr(13);
    EXPECT_EQ(automatic(text), text);
  }
  const std::string prose =
      "mission test\nwarm water on the shelf\n" + mission("depth > 5 m").substr(13);
  EXPECT_NE(automatic(prose).find("\n# warm water"), std::string::npos) << automatic(prose);
}

/// Commas are decimal commas only if the number of arguments then is right.
TEST(Fixes, TooFewArgumentsHaveNoDecimalCommas) {
  std::string text = mission("depth > 5 m");
  text.replace(text.find("surfaced"), 8, "yo_above(5,20)");
  FrontendRun run(text);
  run.compile();
  EXPECT_TRUE(run.says(support::diagnostics::wrongArgumentCount)) << run.said();
  EXPECT_FALSE(run.says(support::diagnostics::decimalComma)) << run.said();
}

/// Which ocean was meant cannot be seen from a number that has lost its letter.
TEST(Fixes, TheSideOfAPositionIsNotGuessed) {
  const std::string lost = mission("depth > 5 m", "flightroute nav(39 N, 73 )");
  EXPECT_EQ(automatic(lost), lost);
  const std::string sign = mission("depth > 5 m", "flightroute nav(3910.5, -73.8)");
  EXPECT_NE(automatic(sign).find("73.8 W"), std::string::npos) << automatic(sign);
}

}  // namespace
}  // namespace glider::frontend
