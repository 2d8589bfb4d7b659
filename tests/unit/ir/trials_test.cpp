// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What sampling shows about a case, and that the solver never contradicts it.

#include "ir/prove/encoding/question.h"
#include "ir/prove/encoding/sampling.h"
#include "tests/random_missions/random_mission.h"
#include "tests/unit/ir/missions.h"
#include "tests/unit/ir/slocum.h"

namespace glider::ir::prove {
namespace {

std::vector<SamplingResult> triedOut(const std::string& cases) {
  const Mission mission = missionOf(kHeader + stateText("a", cases));
  return tryOut(ProofContext(mission, slocum()), mission.states[0].cases);
}

TEST(Sampling, ShowsThatUsualCasesFireAndIdle) {
  const auto seen = triedOut(
      "case (and (ge missiontime 1234:time) (gt (sensor depth) 5:length)) goto a "
      "case (or (gt (sensor temp) 20:temperature) (gt (sensor depth) 90:length)) goto a "
      "case (gt statetime 300:time) goto a "
      "case (not (known (sensor temp))) goto a "
      "case (gt missiontime 18000:time) exit");
  ASSERT_EQ(seen.size(), 5U);
  for (const SamplingResult& one : seen) {
    EXPECT_TRUE(one.fires && one.idle && one.first) << &one - seen.data();
  }
}

TEST(Sampling, ShowsNoImpossibleFiring) {
  const auto seen = triedOut(
      "case (gt (sensor depth) 200:length) goto a "
      "case (ge statetime 0:time) goto a "
      "case (gt (sensor depth) 5:length) exit");
  ASSERT_EQ(seen.size(), 3U);
  EXPECT_FALSE(seen[0].fires) << "the sensor ends at 100 m";
  EXPECT_FALSE(seen[1].idle);
  EXPECT_TRUE(seen[2].fires);
  EXPECT_FALSE(seen[2].first) << "the second is always before it";
}

TEST(Sampling, ShowsWhatTemporalGuardsMayBe) {
  const Mission mission =
      missionOf(kHeader +
                "temporal held state a (gt (sensor depth) 5:length) for 8:time "
                "temporal held state a (gt (sensor depth) 500:length) for 8:time " +
                stateText("a",
                          "case (temporal 0) exit case (temporal 1) exit "
                          "case (and (temporal 0) (lt resumetime 4:time)) exit"));
  const auto seen = tryOut(ProofContext(mission, slocum()), mission.states[0].cases);
  EXPECT_TRUE(seen[0].first && seen[0].idle);
  EXPECT_FALSE(seen[1].fires) << "what is held never is";
  EXPECT_FALSE(seen[2].fires) << "the time has not passed";
}

TEST(Sampling, WhatIsHeldForAnUnknownTimeIsUnknown) {
  const Mission mission =
      missionOf(kHeader + "temporal held state a true for (mul (mul 1e300 1e300) 1:time) " +
                stateText("a", "case (temporal 0) exit case (not (temporal 0)) exit"));
  const auto seen = tryOut(ProofContext(mission, slocum()), mission.states[0].cases);
  EXPECT_FALSE(seen[0].fires);
  EXPECT_FALSE(seen[1].fires);
}

TEST(Sampling, TimeInAStateIsPartOfTheMissions) {
  const auto seen = triedOut("case (and (gt statetime 100:time) (lt missiontime 50:time)) exit");
  EXPECT_FALSE(seen[0].fires);
  EXPECT_TRUE(seen[0].idle);
}

/// Whether a moment in which guard `number` is (or is not) true, after all `before` that are not,
/// is impossible to the solver.
bool isImpossible(const ProofContext& proof_context, const std::vector<Case>& cases, size_t number,
                  bool fires, size_t before) {
  z3::context context;
  Unknowns unknowns(context);
  SymbolicState moment(unknowns, proof_context);
  Question question(context, 400000);
  const z3::expr is_true = moment.truth(cases[number].guard).is_true;
  question.add(fires ? is_true : !is_true);
  for (size_t i = 0; i < before; ++i) {
    question.add(!moment.truth(cases[i].guard).is_true);
  }
  question.add(unknowns);
  return question.ask() == Answer::No;
}

TEST(Sampling, ShowsNothingThatTheSolverExcludes) {
  size_t seen_cases = 0;
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    const Mission mission = random_missions::randomMission(seed);
    const ProofContext proof_context(mission, slocum());
    for (const State& state : mission.states) {
      const auto seen = tryOut(proof_context, state.cases);
      for (size_t i = 0; i < seen.size(); ++i) {
        seen_cases += seen[i].first ? 1U : 0U;
        EXPECT_FALSE(seen[i].fires && isImpossible(proof_context, state.cases, i, true, 0)) << seed;
        EXPECT_FALSE(seen[i].idle && isImpossible(proof_context, state.cases, i, false, 0)) << seed;
        EXPECT_FALSE(seen[i].first && isImpossible(proof_context, state.cases, i, true, i)) << seed;
      }
    }
  }
  EXPECT_GT(seen_cases, 5U) << "the random missions have nothing to see";
}

}  // namespace
}  // namespace glider::ir::prove
