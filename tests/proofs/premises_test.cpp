// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The assumptions that a proof names: those that it needs.

#include "ir/prove/evidence/needed_assumptions.h"
#include "ir/prove/prove.h"
#include "ir/verify/verify.h"
#include "tests/proofs/properties.h"
#include "tests/unit/frontend/compile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>

namespace glider::tests {
namespace {

using ir::prove::neededAssumptions;
using Numbers = std::vector<uint32_t>;
using testing::ElementsAre;
using testing::IsEmpty;

bool holds(const Numbers& all, uint32_t one) {
  return std::ranges::find(all, one) != all.end();
}

TEST(NeededAssumptions, AreThoseThatAProofNeeds) {
  const auto needs = [](const Numbers& needed) {
    return [needed](const Numbers& fewer) {
      return std::ranges::all_of(needed, [&](uint32_t one) { return holds(fewer, one); });
    };
  };
  EXPECT_THAT(neededAssumptions({0, 1, 2, 3}, needs({1})), ElementsAre(1));
  EXPECT_THAT(neededAssumptions({0, 1, 2, 3}, needs({0, 3})), ElementsAre(0, 3));
  EXPECT_THAT(neededAssumptions({0, 1, 2, 3}, needs({})), IsEmpty());
  EXPECT_THAT(neededAssumptions({5, 7}, needs({5, 7})), ElementsAre(5, 7));
  EXPECT_THAT(neededAssumptions({}, needs({})), IsEmpty());
}

TEST(NeededAssumptions, OfTwoThatEachSufficeAreTheFirst) {
  const auto either = [](const Numbers& fewer) { return holds(fewer, 0) || holds(fewer, 1); };
  EXPECT_THAT(neededAssumptions({0, 1}, either), ElementsAre(0));
}

TEST(NeededAssumptions, StayWhereNothingIsProvedAgain) {
  EXPECT_THAT(neededAssumptions({0, 1}, [](const Numbers&) { return false; }), ElementsAre(0, 1));
}

constexpr const char* kAssumes = R"(mission m
assume temp in 2 degC .. 28 degC
assume altitude in 5 m .. 100 m
assume no outage
assume start depth <= 1 m
assume battery > 11 V

)";

constexpr const char* kStates = R"(
state a
begin
  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)
  sensors       missiontime, depth, temp, altitude, battery
  events
    case altitude < 4.9 m goto deep
    case missiontime >= 1 h exit
end
state deep
begin
  flightprofile surfaced
  sensors       missiontime
  events
    case missiontime >= 1 h exit
end
)";

/// The numbers of the assumptions that the proof of the one requirement names.
Numbers named(const std::string& requirement) {
  frontend::testing_support::FrontendRun run(kAssumes + ("require " + requirement) + kStates);
  const auto mission = run.compile();
  EXPECT_TRUE(mission.has_value()) << run.said();
  if (!mission) {
    return {};
  }
  const ir::MissionFacts facts = ir::verify(*mission, run.diagnostics);
  const auto found = ir::prove::prove(*mission, facts, slocum(), {}, run.diagnostics);
  EXPECT_EQ(found.requirements.at(0).verdict, ir::prove::Verdict::Proved) << requirement;
  return found.requirements.at(0).assumptions;
}

TEST(Premises, AreOnlyThoseThatTheProofNeeds) {
  EXPECT_THAT(named("always !known(temp) || temp <= 28 degC"), ElementsAre(0));
  EXPECT_THAT(named("always temp <= 28.01 degC"), ElementsAre(0));
  EXPECT_THAT(named("always altitude >= 5 m || temp > 40 degC"), ElementsAre(1));
  EXPECT_THAT(named("exit within 61 min"), ElementsAre(2));
  EXPECT_THAT(named("surfaces every 61 min"), ElementsAre(2));
  EXPECT_THAT(named("always depth <= 25 m"), IsEmpty());
  EXPECT_THAT(named("always missiontime > 0 s || depth <= 1.5 m"), ElementsAre(3));
  EXPECT_THAT(named("never deep"), ElementsAre(1));
  EXPECT_THAT(named("always battery > 11 V || temp > 30 degC"), ElementsAre(4));
  EXPECT_THAT(named("always altitude >= 5 m && temp <= 28 degC"), ElementsAre(0, 1));
}

TEST(Premises, OfAFlightThatReachesAStateAreNone) {
  EXPECT_THAT(named("reach a"), IsEmpty());
}

/// The verdict on the one requirement of a mission, and the numbers of the assumptions that it
/// names.
std::pair<ir::prove::Verdict, Numbers> judgedPremises(const std::string& text) {
  frontend::testing_support::FrontendRun run(text);
  const auto mission = run.compile();
  EXPECT_TRUE(mission.has_value()) << run.said();
  if (!mission) {
    return {};
  }
  const ir::MissionFacts facts = ir::verify(*mission, run.diagnostics);
  const auto found = ir::prove::prove(*mission, facts, slocum(), {}, run.diagnostics);
  return {found.requirements.at(0).verdict, found.requirements.at(0).assumptions};
}

constexpr const char* kEast = R"(
state out
begin
  flightroute   nav(39.2 N, 73.76 W)
  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)
  sensors       missiontime
  events
    case missiontime >= 2 h exit
end
)";

TEST(Premises, OfAnAreaAreTheStartThatIsAssumed) {
  const std::string start =
      "assume start inside(39.19 N 73.77 W, 39.19 N 73.75 W, 39.21 N 73.75 W, 39.21 N 73.77 W)\n";
  const std::string within =
      "require always inside(39.0 N 74.0 W, 39.0 N 73.5 W, 39.4 N 73.5 W, 39.4 N 74.0 W)\n";
  const std::string temp = "assume temp in 2 degC .. 28 degC\n";
  EXPECT_THAT(judgedPremises("mission m\n" + start + within + kEast).second, ElementsAre(0));
  EXPECT_THAT(judgedPremises("mission m\n" + start + temp + within + kEast).second, ElementsAre(0));
  EXPECT_THAT(judgedPremises("mission m\n" + temp + start + within + kEast).second, ElementsAre(1));
}

TEST(Premises, OfAFlightThatStartsDeepIsThatDepth) {
  const auto found = judgedPremises(R"(mission m
assume start depth <= 40 m
require reach deep
state look
begin
  flightprofile surfaced
  sensors       missiontime, depth
  events
    case depth > 20 m goto deep
    case missiontime >= 20 min exit
end
state deep
begin
  flightprofile surfaced
  sensors       missiontime
  events
    case missiontime >= 20 min exit
end
)");
  EXPECT_EQ(found.first, ir::prove::Verdict::Proved);
  EXPECT_THAT(found.second, ElementsAre(0));
}

/// The first search takes any readings; the second the vehicle's.
TEST(Searches, AreRepeatedWithTheVehicleIfNoFlightShowsWhatTheyFound) {
  EXPECT_EQ(judgedPremises(R"(mission m
require never x
state up
begin
  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)
  sensors       missiontime, depth
  events
    case depth > 30 m goto x
    case missiontime >= 20 min exit
end
state x
begin
  flightprofile surfaced
  sensors       missiontime
  events
    case missiontime >= 20 min exit
end
)")
                .first,
            ir::prove::Verdict::Proved);
}

/// 25.64 m + 0.1 m + 0.1 m is a double more than 25.84 m.
TEST(Searches, KnowThatCommandsAreRounded) {
  const auto dives = [](const std::string& limit) {
    return judgedPremises(
               "mission m\nparam deepest : length = 20 m in 10 m .. 30 m\n"
               "require always depth <= deepest + " +
               limit +
               "\nstate look\nbegin\n"
               "  flightprofile yo(5 m, (deepest + 0.1 m) + 0.1 m, 26 deg, 26 deg)\n"
               "  sensors missiontime, depth\n  events\n    case missiontime >= 1 h exit\nend\n")
        .first;
  };
  EXPECT_NE(dives("5.2 m"), ir::prove::Verdict::Proved);
  EXPECT_EQ(dives("5.21 m"), ir::prove::Verdict::Proved);
}

}  // namespace
}  // namespace glider::tests
