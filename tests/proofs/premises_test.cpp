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
  EXPECT_THAT(named("always missiontime > 0 s || depth <= 1 m"), ElementsAre(3));
  EXPECT_THAT(named("never deep"), ElementsAre(1));
  EXPECT_THAT(named("always battery > 11 V || temp > 30 degC"), ElementsAre(4));
  EXPECT_THAT(named("always altitude >= 5 m && temp <= 28 degC"), ElementsAre(0, 1));
}

TEST(Premises, OfAFlightThatReachesAStateAreNone) {
  EXPECT_THAT(named("reach a"), IsEmpty());
}

}  // namespace
}  // namespace glider::tests
