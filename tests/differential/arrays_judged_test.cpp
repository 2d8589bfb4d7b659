// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Random programs of the mission language with arrays and loops, run on every tick: compiled for
// every board against ir/eval. What they should compute is compared in
// tests/unit/frontend/arrays_random_test.cpp.

#include "ir/opt/optimise.h"
#include "ir/verify/verify.h"
#include "support/diagnostics/ids/meaning.h"
#include "tests/differential/judge.h"
#include "tests/random_missions/random_arrays.h"
#include "tests/unit/frontend/compile.h"

#include <fmt/format.h>

#include <tuple>

namespace glider::differential {
namespace {

constexpr uint64_t kPrograms = 6;
constexpr size_t kTicks = 20;

std::optional<ir::Mission> missionOf(const random_missions::RandomArrays& program) {
  frontend::testing_support::FrontendRun run(
      "mission random_arrays\n" + program.declarations +
      "state s begin flightprofile surfaced sensors missiontime, chlorophyll events\n"
      "case known(chlorophyll) || missiontime >= 0 s do set x = chlorophyll\n" +
      program.statements + "end stay\ncase missiontime > 1 h exit end\n");
  auto mission = run.compile();
  EXPECT_TRUE(mission.has_value() || run.says(support::diagnostics::loopTooLong)) << run.said();
  return mission;
}

class ArraysJudged : public testing::TestWithParam<std::tuple<const char*, int>> {};

TEST_P(ArraysJudged, AgreesWithEval) {
  const auto [board, level] = GetParam();
  std::vector<Trial> trials;
  for (uint64_t seed = 0; trials.size() < kPrograms && seed < 2 * kPrograms; ++seed) {
    auto mission = missionOf(random_missions::randomArrays(seed));
    if (!mission) {
      continue;
    }
    Trial trial;
    trial.name = fmt::format("program {}", seed);
    trial.mission = seed % 2 == 0 ? std::move(*mission) : ir::optimise(std::move(*mission));
    trial.stream = random_missions::randomStream(trial.mission, seed, kTicks);
    support::DiagnosticEngine diagnostics;
    trial.stack_depth = ir::verify(trial.mission, diagnostics).stack_depth;
    ASSERT_FALSE(diagnostics.hasErrors()) << seed;
    trials.push_back(std::move(trial));
  }
  ASSERT_EQ(trials.size(), kPrograms);
  EXPECT_EQ(judge(trials, board, level), "");
}

INSTANTIATE_TEST_SUITE_P(Boards, ArraysJudged,
                         testing::Combine(testing::Values("host", "ts7800", "ts5500", "pizero2",
                                                          "cm4"),
                                          testing::Values(0, 3)),
                         [](const auto& param) {
                           return fmt::format("{}_O{}", std::get<0>(param.param),
                                              std::get<1>(param.param));
                         });

}  // namespace
}  // namespace glider::differential
