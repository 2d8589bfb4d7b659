// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Counterexamples are among the simplest: what decides is in them, and little else.

#include "ir/prove/prove.h"
#include "ir/verify/verify.h"
#include "tests/promises/patrol.h"

#include <gtest/gtest.h>

#include <string>

namespace glider::tests {
namespace {

/// The counterexample to the first requirement of a mission with this text.
ir::prove::Counterexample refutation(const std::string& text) {
  frontend::testing_support::FrontendRun run(text);
  const auto mission = run.compile();
  EXPECT_TRUE(mission.has_value()) << run.said();
  if (!mission) {
    return {};
  }
  const ir::MissionFacts facts = ir::verify(*mission, run.diagnostics);
  const auto findings = ir::prove::prove(*mission, facts, slocum(), {}, run.diagnostics);
  EXPECT_EQ(ir::prove::word(findings.requirements.at(0).verdict), "refuted");
  return findings.requirements[0].run.value_or(ir::prove::Counterexample());
}

/// Two states that go to each other, whose yo ends at `target`.
std::string toAndFro(const std::string& target) {
  return R"(mission m
require always depth <= 40 m
var target: length = 10 m in 5 m .. 60 m
state go
begin
  flightroute   heading(90 deg)
  flightprofile yo(top = 4 m, bottom = target, dive = 26 deg, climb = 26 deg)
  sensors       depth, temp, missiontime
  events
    case temp > 20 degC do set target = )" +
         target + R"( end goto back
    case missiontime > 6 h exit
end
state back
begin
  flightroute   heading(270 deg)
  flightprofile yo(top = 4 m, bottom = target, dive = 26 deg, climb = 26 deg)
  sensors       depth, temp, missiontime
  events
    case temp < 10 degC goto go
    case missiontime > 6 h exit
end
)";
}

TEST(Counterexamples, HaveNoMoreTransitionsThanTheyNeed) {
  // 5 m more than half as much again: 10 m, 20 m, 35 m and 57.5 m, so two to four times there.
  const auto found = refutation(toAndFro("clamp(depth * 1.5 + 5 m, 5 m, 60 m)"));
  EXPECT_LE(found.story.size(), 7U);
  EXPECT_LT(found.when, 300);
}

TEST(Counterexamples, AreNotAtTheEndOfAFlightIfTheyCanBeAtItsBeginning) {
  const auto found = refutation(R"(mission m
require always temp > 5 degC || depth < 30 m
state go
begin
  flightprofile yo(top = 4 m, bottom = 40 m, dive = 26 deg, climb = 26 deg)
  sensors       depth, temp, missiontime
  events
    case missiontime > 6 h exit
end
)");
  EXPECT_TRUE(found.story.empty());
  EXPECT_LT(found.when, 300);
}

TEST(Counterexamples, OfADepthThatFollowsTheWaterAreShort) {
  const auto found = refutation(R"(mission m
require always depth <= 40 m
var target: length = 10 m in 5 m .. 60 m
state go
begin
  flightprofile yo(top = 4 m, bottom = target, dive = 26 deg, climb = 26 deg)
  sensors       depth, temp, missiontime
  events
    case diving && became(temp < 15 degC) do set target = clamp(depth + 12 m, 5 m, 60 m) end stay
    case missiontime > 6 h exit
end
)");
  EXPECT_LT(found.when, 600);
}

}  // namespace
}  // namespace glider::tests
