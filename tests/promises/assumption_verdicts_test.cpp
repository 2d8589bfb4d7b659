// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Assumptions: the verdicts that they allow, and which of them cannot be.

#include "ir/opt/prepare_for_flight.h"
#include "ir/prove/prove.h"
#include "ir/text/print.h"
#include "ir/verify/verify.h"
#include "ir/worlds/under_assumptions.h"
#include "support/diagnostics/ids/verification.h"
#include "tests/promises/patrol.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

namespace glider::tests {
namespace {

struct Found {
  std::string verdict;
  std::string premises;
  bool contradict = false;
};

Found check(const std::string& text, const ir::prove::Options& options = {}) {
  frontend::testing_support::FrontendRun run(text);
  const auto mission = run.compile();
  EXPECT_TRUE(mission.has_value()) << run.said();
  if (!mission) {
    return {};
  }
  const ir::MissionFacts facts = ir::verify(*mission, run.diagnostics);
  const auto findings = ir::prove::prove(*mission, facts, slocum(), options, run.diagnostics);
  Found found;
  found.contradict = run.says(support::diagnostics::assumptionsContradict);
  if (!findings.requirements.empty()) {
    found.verdict = ir::prove::word(findings.requirements[0].verdict);
    found.premises = ir::prove::premisesOf(findings.requirements[0], *mission);
  }
  return found;
}

void expectOnlyWith(const std::string& assumption, const std::string& requirement,
                    const std::string& body = "") {
  const auto text = [&](const std::string& lines) {
    return body.empty() ? patrol(lines) : "mission m\n" + lines + body;
  };
  EXPECT_EQ(check(text("require " + requirement)).verdict, "refuted") << requirement;
  const Found with = check(text("assume " + assumption + "\nrequire " + requirement));
  EXPECT_EQ(with.verdict, "proved") << assumption;
  EXPECT_EQ(with.premises, "assuming `" + assumption + "`");
}

TEST(AssumptionVerdicts, OfOutages) {
  expectOnlyWith("no outage", "exit within 61 min", R"(
state look
begin
  flightprofile yo(5 m, 25 m, 26 deg, 26 deg)
  sensors       missiontime
  events
    case missiontime >= 1 h exit
end
)");
}

TEST(AssumptionVerdicts, OfRangesAndConditions) {
  expectOnlyWith("temp in 2 degC .. 28 degC", "always temp <= 30 degC");
  expectOnlyWith("temp <= 28 degC", "always temp <= 30 degC");
  expectOnlyWith("altitude in 10 m .. 100 m", "never up");
  expectOnlyWith("altitude >= 10 m", "never up");
}

TEST(AssumptionVerdicts, OfTheDepthOfTheStart) {
  constexpr const char* kSurfaced = R"(
state home
begin
  flightprofile surfaced
  sensors       missiontime
  events
    case missiontime >= 1 h exit
end
)";
  expectOnlyWith("start depth <= 1 m", "always depth <= 6.5 m", kSurfaced);
  EXPECT_EQ(
      check(std::string("mission m\nassume start depth <= 20 m\nrequire always depth <= 10 m") +
            kSurfaced)
          .verdict,
      "refuted");
}

/// What is assumed to be worse than usual holds for every verdict and finding.
TEST(AssumptionVerdicts, OfADeeperStart) {
  frontend::testing_support::FrontendRun run(
      patrol("assume start depth <= 50 m\nrequire whenever depth > 40 m then altitude < 0 m\n"));
  const auto mission = run.compile();
  ASSERT_TRUE(mission.has_value()) << run.said();
  const ir::MissionFacts facts = ir::verify(*mission, run.diagnostics);
  const auto findings = ir::prove::prove(*mission, facts, slocum(), {}, run.diagnostics);
  EXPECT_NE(findings.requirements.at(0).verdict, ir::prove::Verdict::Proved);
  EXPECT_FALSE(run.says(support::diagnostics::requirementVacuous));
}

/// Also a long one, so that certificates can name it.
TEST(AssumptionVerdicts, WordsAreWhole) {
  const std::string area =
      "start inside(39.15 N 73.95 W, 39.15 N 73.85 W, 39.25 N 73.85 W, 39.25 N 73.95 W)";
  EXPECT_EQ(compiled(patrol("assume " + area)).assumptions.at(0).words, area);
}

TEST(AssumptionVerdicts, OfKnownReadings) {
  constexpr const char* kLook = R"(
resume within 20 s
require exit within 6 min
state look
begin
  flightprofile yo(5 m, 25 m, 26 deg, 26 deg)
  sensors       missiontime, altitude
  events
    case missiontime >= 5 min && known(altitude) exit
end
)";
  EXPECT_EQ(check(std::string("mission m\nassume known altitude every 30 s") + kLook).verdict,
            "proved");
  EXPECT_NE(check(std::string("mission m\nassume known altitude every 50 s") + kLook).verdict,
            "proved");
}

TEST(AssumptionVerdicts, ABrokenOneProvesNothingElse) {
  EXPECT_EQ(check(patrol("assume temp <= 28 degC\nrequire always temp <= 27 degC")).verdict,
            "refuted");
  EXPECT_EQ(check(patrol("assume temp <= 28 degC\nrequire always pressure <= 1 bar")).verdict,
            "refuted");
}

TEST(AssumptionVerdicts, WhatNeedsNoneNamesNone) {
  EXPECT_EQ(check(patrol("assume temp <= 28 degC\nrequire always depth <= 40 m")).premises, "");
  EXPECT_EQ(check(patrol("assume temp <= 28 degC\nrequire stack <= 1")).premises, "");
}

/// With the monitors of its assumptions Spacer takes some 520,000 steps for this, without them
/// 55,000. What assumptions a proof may rest on, if not only those that it needs are named, shows
/// which of the two it was.
TEST(AssumptionVerdicts, ASearchThatTheirMonitorsMakeTooLongIsRepeatedWithoutThem) {
  const std::string text = R"(mission counts
assume temp changes <= 0.2 degC/s
assume altitude changes <= 1 m/s
assume battery changes <= 0.1 V/s
assume waterdepth changes <= 1 m/s
assume scipressure changes <= 1 bar/s
var n : number = 0 in 0 .. 9
require always n <= 3
state count
begin
  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)
  sensors       missiontime, temp
  events
    case missiontime >= 1 h        exit
    case temp > 5 degC && n < 3    do set n = n + 1 end stay
end
)";
  ir::prove::Options options;
  options.premises = false;
  const Found with = check(text, options);
  EXPECT_EQ(with.verdict, "proved");
  EXPECT_NE(with.premises, "");
  options.run_effort = 150000;
  const Found without = check(text, options);
  EXPECT_EQ(without.verdict, "proved");
  EXPECT_EQ(without.premises, "");
}

/// `can reach` is only shown by a flight that breaks no assumption.
TEST(AssumptionVerdicts, NoFlightThatBreaksOneShowsAnything) {
  EXPECT_EQ(check(patrol("assume temp <= 28 degC\nrequire can reach up")).verdict, "proved");
  EXPECT_EQ(check(patrol("require can reach up")).verdict, "proved");
  EXPECT_NE(check(patrol("assume altitude > 6 m\nrequire can reach up")).verdict, "proved");
}

/// The reading of the depth differs from the true depth, which the assumption is about.
TEST(AssumptionVerdicts, OfADepthDoNotNarrowItsReadings) {
  const std::string mission = patrol("assume depth in 0 m .. 18 m\nrequire never up");
  const auto at = mission.find("altitude < 5 m &&");
  EXPECT_NE(check(std::string(mission).replace(at, 17, "depth > 18.3 m &&")).verdict, "proved");
}

/// Sixty outages of a minute last as long together as `resume within` allows.
TEST(AssumptionVerdicts, OfEachOutageDoNotBoundThemAllTogether) {
  const auto verdict = [](const char* outage) {
    return check(fmt::format(R"(mission m
{}
resume within 1 h
assume start inside(39.2 N 73.76 W, 39.2 N 73.75 W, 39.201 N 73.75 W)
require always inside(39.0 N 74.0 W, 39.0 N 73.5 W, 39.26 N 73.5 W, 39.26 N 74.0 W)
state up
begin
  flightroute   nav(39.2 N, 73.76 W)
  flightprofile yo(5 m, 15 m, 26 deg, 26 deg)
  sensors       missiontime
  events
    case missiontime >= 2 h exit
end
)",
                             outage))
        .verdict;
  };
  EXPECT_EQ(verdict("assume no outage"), "proved");
  EXPECT_NE(verdict("assume outage <= 60 s"), "proved");
}

/// A flight begins where the mission assumes it.
TEST(AssumptionVerdicts, OfTheStartHoldInCounterexamples) {
  EXPECT_NE(check(R"(mission m
assume start inside(39.2 N 73.76 W, 39.2 N 73.75 W, 39.201 N 73.75 W)
assume current <= 0 m/s
assume no outage
require always inside(39.0 N 74.0 W, 39.0 N 73.5 W, 39.4 N 73.5 W, 39.4 N 74.0 W)
state up
begin
  flightroute   nav(39.45 N, 73.76 W)
  flightprofile yo(5 m, 15 m, 26 deg, 26 deg)
  sensors       missiontime
  events
    case missiontime >= 2 h exit
end
)")
                .verdict,
            "refuted");
}

/// A requirement that does not mention the depth: its counterexamples need a possible depth too.
TEST(AssumptionVerdicts, OfTheStartHoldForTheReadingOfTheDepth) {
  EXPECT_NE(check(R"(mission m
assume start depth <= 0 m
require never long
state up
begin
  flightprofile surfaced
  sensors       missiontime, depth
  events
    case depth > 50 m        goto long
    case missiontime >= 2 h exit
end
state long
begin
  flightprofile surfaced
  sensors       missiontime
  events
    case missiontime >= 20 h exit
end
)")
                .verdict,
            "refuted");
}

TEST(AssumptionVerdicts, OneAloneMayContradictItself) {
  EXPECT_TRUE(check(patrol("assume missiontime < 0 s")).contradict);
  EXPECT_TRUE(check(patrol("assume 1 > 2")).contradict);
  EXPECT_TRUE(check(patrol("assume start inside(39 N 74 W, 39.1 N 74 W, 39.2 N 74 W)")).contradict);
  EXPECT_FALSE(
      check(patrol("assume start inside(39 N 74 W, 39.1 N 74 W, 39.1 N 74.1 W)")).contradict);
  EXPECT_TRUE(check(patrol("assume start inside(39 N 74 W, 39.1 N 74 W, 39.2 N 74 W, 39 N 74 W)"))
                  .contradict);
  EXPECT_FALSE(
      check(patrol("assume start inside(39 N 74 W, 39.1 N 73.9 W, 39.1 N 74 W, 39 N 73.9 W)"))
          .contradict)
      << "two triangles, one of which counts as negative";
  EXPECT_FALSE(check(patrol("assume temp < 5 degC")).contradict);
}

/// Every flight starts at mission time 0, at `start_depth_m` (3 m) or above.
TEST(AssumptionVerdicts, OnesThatNoFlightKeepsAtTheStart) {
  for (const char* never : {"depth > 5 m", "missiontime > 1 s", "depth in 210 m .. 250 m",
                            "missiontime > 4 s && missiontime < 1 h"}) {
    EXPECT_TRUE(check(patrol(fmt::format("assume {}", never))).contradict) << never;
  }
  EXPECT_TRUE(check(patrol("assume start depth <= 1 m\nassume depth > 2 m")).contradict);
  EXPECT_TRUE(
      check(patrol("assume depth > 2 m || temp > 9 degC\nassume temp < 5 degC && known(temp) "
                   "\nassume start depth <= 1 m"))
          .contradict);
  EXPECT_FALSE(check(patrol("assume start depth <= 3 m\nassume depth > 2 m")).contradict);
  EXPECT_FALSE(check(patrol("assume missiontime < 2 h")).contradict);
  EXPECT_FALSE(check(patrol("assume depth > 5 m || missiontime < 5 min")).contradict);
}

/// The cases say what may wait; whether the assumptions exclude it is not asked.
TEST(AssumptionVerdicts, MayExcludeCalls) {
  EXPECT_EQ(check(patrol("require stack <= 0")).verdict, "refuted");
  EXPECT_EQ(check(patrol("assume altitude > 10 m\nrequire stack <= 0")).verdict, "undecided");
}

/// Without readings no limit is broken.
TEST(AssumptionVerdicts, UnknownReadingsContradictNothing) {
  EXPECT_FALSE(check(patrol("assume !known(temp)\nassume temp > 5 degC")).contradict);
  EXPECT_TRUE(check(patrol("assume !known(temp)\nassume known(temp)")).contradict);
  EXPECT_TRUE(
      check(patrol("assume known(temp) && temp > 5 degC\nassume temp < 4 degC")).contradict);
  frontend::testing_support::FrontendRun run(
      patrol("assume !known(temp)\nrequire always temp > 30 degC\nrequire always temp < 30 degC"));
  const auto mission = run.compile();
  ASSERT_TRUE(mission.has_value()) << run.said();
  const ir::MissionFacts facts = ir::verify(*mission, run.diagnostics);
  (void)ir::prove::prove(*mission, facts, slocum(), {}, run.diagnostics);
  EXPECT_FALSE(run.says(support::diagnostics::requirementsContradict));
}

/// Nothing rests on ranges without a common reading: searches go on without the assumptions.
TEST(AssumptionVerdicts, ContradictionsProveNothing) {
  const std::string ranges = "assume temp in 1 degC .. 5 degC\nassume temp in 6 degC .. 9 degC\n";
  const Found open = check(patrol(ranges + "require exit within 10 min"));
  EXPECT_TRUE(open.contradict);
  EXPECT_NE(open.verdict, "proved");
  const Found proved = check(patrol(ranges + "require always depth <= 40 m"));
  EXPECT_EQ(proved.verdict, "proved");
  EXPECT_EQ(proved.premises, "");
}

TEST(AssumptionVerdicts, ContradictionsAreErrors) {
  EXPECT_TRUE(check(patrol("assume temp in 10 degC .. 20 degC\nassume temp < 5 degC")).contradict);
  EXPECT_TRUE(check(patrol("assume temp in 50 degC .. 60 degC")).contradict);
  EXPECT_TRUE(
      check(patrol("assume temp in 1 degC .. 5 degC\nassume temp in 6 degC .. 9 degC")).contradict);
  EXPECT_FALSE(
      check(patrol("assume temp in 10 degC .. 20 degC\nassume temp < 11 degC")).contradict);
  EXPECT_FALSE(check(patrol("assume temp < 11 degC\nassume altitude > 99 m")).contradict);
}

/// The start and the current are not watched on board.
TEST(AssumptionVerdicts, OthersLeaveWhatFliesAsItIs) {
  ir::Mission with = compiled(patrol("assume start depth <= 1 m\nassume current <= 0.2 m/s\n"));
  ir::Mission without = compiled(patrol(""));
  ir::prepareForFlight(with);
  ir::prepareForFlight(without);
  EXPECT_EQ(ir::print(with), ir::print(without));
}

}  // namespace
}  // namespace glider::tests
