// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What compiled missions foresee, on every board, against ir/eval.

#include "frontend/frontend.h"
#include "ir/opt/optimise.h"
#include "ir/verify/verify.h"
#include "tests/differential/judge.h"
#include "tests/naps/sleepy_mission.h"
#include "tests/unit/frontend/compile.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace glider::naps {
namespace {

constexpr uint64_t kMissions = 40;
constexpr size_t kTicks = 150;

/// None if the mission has errors: some never end a state, or exceed the stack.
std::optional<differential::Trial> trialOf(uint64_t seed, bool optimised) {
  frontend::testing_support::FrontendRun run(sleepyMission(seed));
  auto mission = run.compile();
  EXPECT_TRUE(mission) << run.said();
  differential::Trial trial;
  trial.name = fmt::format("sleepy mission {}{}", seed, optimised ? ", optimised" : "");
  trial.mission = optimised ? ir::optimise(std::move(*mission)) : std::move(*mission);
  trial.mission.nap_s = 240;
  support::DiagnosticEngine diagnostics;
  trial.stack_depth = ir::verify(trial.mission, diagnostics).stack_depth;
  trial.stream = slowStream(trial.mission, seed, kTicks);
  trial.parameters = random_missions::randomParameters(trial.mission, seed);
  return diagnostics.hasErrors() ? std::nullopt : std::optional(std::move(trial));
}

class ForeseeJudged : public testing::TestWithParam<const char*> {};

TEST_P(ForeseeJudged, AgreesWithEval) {
  std::vector<differential::Trial> trials;
  for (uint64_t seed = 1000; seed < 1000 + kMissions; ++seed) {
    if (auto trial = trialOf(seed, seed % 2 == 1)) {
      trials.push_back(std::move(*trial));
    }
  }
  EXPECT_GT(trials.size(), kMissions / 2);
  EXPECT_EQ(differential::judge(trials, GetParam(), 2), "");
}

INSTANTIATE_TEST_SUITE_P(Boards, ForeseeJudged,
                         testing::Values("host", "ts7800", "ts5500", "pizero2", "cm4"));

}  // namespace
}  // namespace glider::naps
