// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What is proved without a search over traces, and what must not be: beside each rule the missions
// for which it would be wrong.

#include "ir/prove/prove.h"
#include "ir/verify/verify.h"
#include "tests/proofs/properties.h"
#include "tests/unit/frontend/compile.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace glider::tests {
namespace {

using Words = std::vector<std::string>;

/// The verdicts on the requirements of a mission, without any search over traces.
Words seen(const std::string& text, const platforms::Platform& platform = slocum()) {
  frontend::testing_support::FrontendRun run(text);
  const auto mission = run.compile();
  EXPECT_TRUE(mission.has_value()) << run.said();
  if (!mission) {
    return {};
  }
  const ir::MissionFacts facts = ir::verify(*mission, run.diagnostics);
  EXPECT_FALSE(run.diagnostics.hasErrors()) << run.said();
  ir::prove::Options how;
  how.run_effort = 1;
  Words words;
  for (const auto& verdict :
       ir::prove::prove(*mission, facts, platform, how, run.diagnostics).requirements) {
    words.emplace_back(ir::prove::word(verdict.verdict));
  }
  return words;
}

bool isSeen(const std::string& text) {
  return seen(text) == Words{"proved"};
}

std::string state(const std::string& name, const std::string& profile, const std::string& cases) {
  return "state " + name + "\nbegin\n  flightprofile " + profile +
         "\n  sensors missiontime, statetime, resumetime, depth, temp, altitude\n  events\n" +
         cases + "\nend\n";
}

const std::string kInsightYo = "yo(5 m, 20 m, 26 deg, 26 deg)";

// --- Clocks

TEST(Clocks, AreBoundedByTheEnd) {
  const auto survey = [](const std::string& requirement) {
    return isSeen("mission m\nrequire " + requirement + "\nvar t : time = 0 s in 0 s .. 1 h\n" +
                  state("a", kInsightYo,
                        "case missiontime >= 1 h exit\n"
                        "case missiontime >= 10 min do set t = 10 min end stay"));
  };
  EXPECT_TRUE(survey("always missiontime <= 65 min"));
  EXPECT_FALSE(survey("always missiontime <= 64 min")) << "the power may be cut until then";
  EXPECT_TRUE(survey("always missiontime + 1 s > missiontime"));
  EXPECT_TRUE(survey("always missiontime - statetime >= 0 s"));
  EXPECT_FALSE(survey("always statetime - missiontime >= 0 s || depth < 0 m"))
      << "of the start only";
  EXPECT_TRUE(survey("always missiontime - t <= 66 min"));
  EXPECT_TRUE(survey("always resumetime <= 65 min && statetime <= 65 min"));
  EXPECT_TRUE(survey("surfaces every 65 min"));
  EXPECT_FALSE(survey("surfaces every 64 min"));
}

/// A state goes on waiting while another is current.
TEST(Clocks, OfAStateThatWaitsGoOn) {
  const std::string promise =
      "mission m\nrequire always statetime <= 2 h || missiontime > 1000 h\n";
  const std::string hot = state("hot", kInsightYo, "case resumetime >= 90 min return");
  const std::string look = "case statetime >= 1 h exit";
  EXPECT_TRUE(isSeen(promise + state("look", kInsightYo, look + "\ncase temp > 20 degC goto hot") +
                     state("hot", kInsightYo, "case resumetime >= 90 min exit")));
  EXPECT_FALSE(
      isSeen(promise + state("look", kInsightYo, look + "\ncase temp > 20 degC call hot") + hot));
  EXPECT_FALSE(isSeen(promise + "always\n  case temp > 20 degC call hot\n" +
                      state("look", kInsightYo, look) + hot));
}

TEST(Clocks, AgesAreOfReadingsAlsoWhereTheDepthIsTheTrueOne) {
  const auto promise = [](const std::string& condition) {
    return "mission m\nrequire always " + condition + "\n" +
           state("a", kInsightYo, "case missiontime >= 1 h exit");
  };
  for (const unsigned effort : {1U, 1000000U}) {
    frontend::testing_support::FrontendRun run(promise("age(depth) <= 30 s || depth < 0 m"));
    const auto mission = run.compile();
    ASSERT_TRUE(mission.has_value()) << run.said();
    const ir::MissionFacts facts = ir::verify(*mission, run.diagnostics);
    ir::prove::Options how;
    how.run_effort = effort;
    const auto found = ir::prove::prove(*mission, facts, slocum(), how, run.diagnostics);
    EXPECT_NE(found.requirements.at(0).verdict, ir::prove::Verdict::Proved) << effort;
  }
  EXPECT_TRUE(isSeen(promise("age(depth) <= 65 min")));
}

// --- Depth and time by state

TEST(ByState, DepthAndTimeBelongTogether) {
  const std::string promise = "mission m\nrequire always depth <= 15 m || missiontime >= 1 h\n";
  const std::string deep =
      state("deep", "yo(5 m, 40 m, 26 deg, 26 deg)", "case statetime >= 1 h exit");
  const std::string shallow = "yo(5 m, 10 m, 26 deg, 26 deg)";
  EXPECT_TRUE(isSeen(promise + state("a", shallow, "case missiontime >= 1 h goto deep") + deep));
  EXPECT_FALSE(
      isSeen(promise + state("a", shallow, "case missiontime >= 59 min goto deep") + deep));
  EXPECT_FALSE(
      isSeen(promise +
             state("a", shallow,
                   "case missiontime >= 1 h goto deep\n"
                   "case temp > 20 degC call dip") +
             deep + state("dip", "yo(5 m, 40 m, 26 deg, 26 deg)", "case statetime >= 1 h return")));
  EXPECT_FALSE(isSeen(promise + "always\n  case temp > 20 degC goto deep\n" +
                      state("a", shallow, "case missiontime >= 1 h goto deep") + deep));
  EXPECT_FALSE(isSeen(promise +
                      state("a", shallow,
                            "case temp > 20 degC do descend(40 m, 26 deg) end stay\n"
                            "case missiontime >= 1 h goto deep") +
                      deep))
      << "a command in a case";
}

TEST(ByState, AProvedRequirementIsUsedForOthers) {
  const std::string counts = state("a", kInsightYo,
                                   "case missiontime >= 1 h exit\n"
                                   "case n < 5 && temp > 20 degC do set n = n + 1 end stay");
  frontend::testing_support::FrontendRun run(
      "mission m\nrequire always n <= 5\nrequire always n <= 6\n"
      "require always n <= 4\nvar n : number = 0 in 0 .. 9\n" +
      counts);
  const auto mission = run.compile();
  ASSERT_TRUE(mission.has_value()) << run.said();
  const ir::MissionFacts facts = ir::verify(*mission, run.diagnostics);
  const auto found = ir::prove::prove(*mission, facts, slocum(), {}, run.diagnostics);
  EXPECT_EQ(found.requirements.at(0).verdict, ir::prove::Verdict::Proved);
  EXPECT_TRUE(found.requirements.at(0).searched);
  EXPECT_EQ(found.requirements.at(1).verdict, ir::prove::Verdict::Proved);
  EXPECT_FALSE(found.requirements.at(1).searched) << "it follows";
  EXPECT_EQ(found.requirements.at(2).verdict, ir::prove::Verdict::Refuted) << "it does not";
}

// --- Surfacing

const std::string kReport = "case statetime > 15 min return";

/// The usual mission: every three hours it surfaces.
std::string reporting(const std::string& report = kReport, const std::string& more = "",
                      const std::string& every = "4 h", const std::string& before = "") {
  return "mission m\nrequire surfaces every " + every + "\n" + before +
         state("survey", "yo(5 m, 25 m, 26 deg, 26 deg)",
               "case resumetime > 3 h call report\n" + more) +
         state("report", "surfaced", report);
}

TEST(Surfacing, IsProvedOfTheUsualMission) {
  EXPECT_TRUE(isSeen(reporting()));
  EXPECT_TRUE(isSeen(reporting(kReport, "", "197 min"))) << "3 h, a gap of 5 min, 680 s to climb";
  EXPECT_FALSE(isSeen(reporting(kReport, "", "196 min")));
  EXPECT_TRUE(isSeen(reporting("case statetime > 15 min goto survey", "case false return")));
  EXPECT_TRUE(isSeen(reporting("case held(depth < 1 m, 60 s) || statetime > 15 min return")));
  EXPECT_TRUE(isSeen(reporting("case became(depth < 1 m) return\ncase statetime > 15 min return")));
  EXPECT_TRUE(isSeen(reporting("case depth < 1 m return"))) << "it stays until it has surfaced";
  EXPECT_TRUE(isSeen(reporting(kReport, "case missiontime > 40 h exit")));
}

TEST(Surfacing, NeedsTheTimeToClimb) {
  EXPECT_FALSE(isSeen(reporting("case statetime > 10 min return"))) << "680 s";
  EXPECT_FALSE(isSeen(reporting("case temp > 20 degC return\n" + kReport)));
  EXPECT_FALSE(isSeen(reporting("case depth < 1.2 m return\n" + kReport))) << "it may be at 2.1 m";
  EXPECT_FALSE(isSeen(reporting("case held(depth < top, 60 s) return\n" + kReport, "", "4 h",
                                "var top : length = 1 m in 0 m .. 30 m\n"
                                "always\n  case temp > 20 degC do set top = 30 m end stay\n")));
  EXPECT_FALSE(isSeen(reporting("case !known(depth) return\n" + kReport)));
  EXPECT_FALSE(
      isSeen(reporting(kReport, "case depth > 24 m goto deep") +
             state("deep", "yo(5 m, 300 m, 26 deg, 26 deg)", "case resumetime > 3 h call report")))
      << "from 305 m";
}

TEST(Surfacing, NothingElseMayCommandADepth) {
  EXPECT_FALSE(
      isSeen(reporting("case temp > 20 degC do descend(20 m, 26 deg) end stay\n" + kReport)));
  EXPECT_FALSE(isSeen(reporting(kReport, "", "4 h",
                                "always\n  case temp > 20 degC do\n    if depth > 1 m then "
                                "hover(20 m) end\n  end stay\n")));
  const auto profile = [](const std::string& body) {
    return isSeen(
        "mission m\nrequire surfaces every 4 h\nflightprofile up\nbegin\n" + body + "\nend\n" +
        state("survey", "yo(5 m, 25 m, 26 deg, 26 deg)", "case resumetime > 3 h call report") +
        state("report", "up", kReport));
  };
  EXPECT_TRUE(profile("  entry do surface() end"));
  EXPECT_FALSE(profile("  entry do ascend(3 m, 26 deg) end"));
  EXPECT_FALSE(profile("  entry do surface() if temp > 20 degC then hover(20 m) end end"));
  EXPECT_FALSE(profile("  entry do if known(temp) then surface() end end"));
  EXPECT_FALSE(
      profile("  entry do surface() end\n  events\n"
              "    case temp > 20 degC do descend(9 m, 26 deg) end stay"));
}

TEST(Surfacing, MayBePutOffForEver) {
  EXPECT_FALSE(isSeen(reporting(kReport, "case temp > 20 degC call hot") +
                      state("hot", kInsightYo, "case statetime > 10 min return")))
      << "each return restarts resumetime";
  EXPECT_FALSE(isSeen(reporting(kReport, "", "4 h", "always\n  case altitude < 4 m call hot\n") +
                      state("hot", kInsightYo, "case statetime > 10 min return")));
  EXPECT_FALSE(isSeen(reporting(kReport, "case altitude < 4 m goto survey")));
  EXPECT_FALSE(isSeen(reporting(kReport, "", "4 h", "resume within 2 h\n"))) << "a power cut";
  EXPECT_FALSE(isSeen("mission m\nrequire surfaces every 4 h\n" +
                      state("survey", kInsightYo,
                            "case temp > 30 degC call report\n"
                            "case missiontime >= 5 h exit") +
                      state("report", "surfaced", kReport)));
}

/// The mission of check_progress_test, which a search proves or not as the numbers fall.
TEST(Surfacing, DoesNotHangOnTheErrorOfTheDepth) {
  const std::string survey =
      "mission survey\nrequire surfaces every 102 min\n" +
      state("look", "yo(5 m, 25 m, 26 deg, 26 deg)",
            "case missiontime >= 1 h goto home\ncase temp > 20 degC call hot") +
      state("hot", "yo(5 m, 28 m, 26 deg, 26 deg)", "case statetime >= 10 min return") +
      state("home", "surfaced", "case statetime >= 10 min exit");
  for (const double error :
       {0.5, 0.55, 0.6, 0.65, 0.7, 0.75, 0.8, 0.85, 0.9, 0.95, 1.0, 1.1, 1.2, 1.25, 1.5}) {
    platforms::Platform platform = slocum();
    platform.world.depth_error_m = error;
    EXPECT_EQ(seen(survey, platform), Words{"proved"}) << error;
  }
}

// --- What all requirements may take together

/// Promises of a counter that only a search proves.
std::string counting(int promises) {
  std::string text = "mission m\n";
  for (int i = 0; i < promises; ++i) {
    text += fmt::format("require always n <= {}\n", 30 - i);
  }
  return text + "var n : number = 0 in 0 .. 99\n" +
         state("a", kInsightYo,
               "case missiontime >= 1 h exit\n"
               "case n < 20 && temp > 20 degC do set n = n + 1 end stay");
}

struct Judged {
  Words words;
  std::vector<std::string> reasons;
  std::vector<bool> searched;
};

Judged judged(const std::string& text, const ir::prove::Options& how) {
  frontend::testing_support::FrontendRun run(text);
  const auto mission = run.compile();
  EXPECT_TRUE(mission.has_value()) << run.said();
  const ir::MissionFacts facts = ir::verify(*mission, run.diagnostics);
  Judged all;
  for (const auto& verdict :
       ir::prove::prove(*mission, facts, slocum(), how, run.diagnostics).requirements) {
    all.words.emplace_back(ir::prove::word(verdict.verdict));
    all.reasons.push_back(verdict.reason);
    all.searched.push_back(verdict.searched);
  }
  return all;
}

TEST(TotalEffort, LeavesRequirementsUndecidedAndSaysSo) {
  ir::prove::Options how;
  EXPECT_EQ(judged(counting(9), how).words, Words(9, "proved"));
  how.total_effort = 100000;
  const Judged some = judged(counting(9), how);
  EXPECT_EQ(some.words.front(), "proved") << "what comes first is searched for first";
  EXPECT_EQ(some.words.back(), "undecided");
  EXPECT_EQ(some.reasons.back(),
            "it was not searched for: all requirements together reached their limit (`--effort`)");
  EXPECT_FALSE(some.searched.back()) << "with less before it, it may be decided: not for the cache";
  EXPECT_EQ(judged(counting(9), how).words, some.words);
  how.total_effort = 0;
  EXPECT_EQ(judged(counting(2), how).words, Words(2, "undecided"));
}

TEST(TotalEffort, MayBeATime) {
  ir::prove::Options how;
  how.until = std::chrono::steady_clock::now();
  const Judged none = judged(counting(2), how);
  EXPECT_EQ(none.words, Words(2, "undecided"));
  EXPECT_EQ(none.reasons.back(),
            "it was not searched for: the time limit was reached (`--timeout`)");
  how.until = std::chrono::steady_clock::now() + std::chrono::hours(1);
  EXPECT_EQ(judged(counting(2), how).words, Words(2, "proved"));
}

// --- Large missions

std::string chain(int states, const std::string& requirements, const std::string& set) {
  std::string text = "mission w\n" + requirements + "var v0 : number = 0 in 0 .. 10\n";
  for (int i = 0; i < states; ++i) {
    const std::string on = i + 1 < states ? fmt::format("goto s{}", i + 1) : "exit";
    text += state(fmt::format("s{}", i), kInsightYo,
                  "case statetime >= 10 s " + set + on + "\ncase missiontime >= 50 h exit");
  }
  return text;
}

TEST(LargeMissions, AreDecidedWithoutASearch) {
  const std::string promises =
      "require always v0 <= 10\nrequire always missiontime <= 60 h\nrequire exit within 60 h\n"
      "require surfaces every 60 h\nrequire always depth <= 25 m && v0 >= 0\n"
      "require always depth <= 25 m || v0 < 0\n";
  for (const int states : {30, 450}) {
    EXPECT_EQ(seen(chain(states, promises, "do set v0 = clamp(v0 + 1, 0, 10) end ")),
              Words(6, "proved"))
        << states;
  }
  EXPECT_EQ(seen(chain(200, "require exit within 60 h\n", "")), Words{"proved"});
}

}  // namespace
}  // namespace glider::tests
