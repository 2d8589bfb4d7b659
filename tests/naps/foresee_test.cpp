// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/verify.h"
#include "tests/naps/sleepy_mission.h"
#include "tests/naps/slept_ticks.h"
#include "tests/random_missions/random_mission.h"
#include "tests/unit/frontend/compile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace glider::naps {
namespace {

constexpr size_t kTicks = 300;

struct Tally {
  size_t missions = 0;
  size_t slept = 0;
  size_t woken = 0;
  size_t needed = 0;
};

/// No tick that would be slept through does anything new.
void fly(const ir::Mission& mission, const std::vector<random_missions::StreamTick>& stream,
         uint64_t seed, Tally& tally) {
  support::DiagnosticEngine diagnostics;
  const ir::MissionFacts facts = ir::verify(mission, diagnostics);
  if (diagnostics.hasErrors()) {
    return;
  }
  ir::Interpreter interpreter(mission, facts.stack_depth, random_missions::randomExternals());
  SleptTicks slept(mission);
  ir::TickResult now;
  double time = 0;
  for (size_t i = 0; i < stream.size() && !now.finished; ++i) {
    now = i == 0
              ? interpreter.start(stream[i].frame, random_missions::randomParameters(mission, seed))
              : interpreter.tick(stream[i].mission_time, stream[i].frame);
    time = std::max(time, stream[i].mission_time);
    const std::string wrong = slept.after(interpreter, now, time);
    ASSERT_EQ(wrong, "") << "seed " << seed << ", tick " << i;
  }
  ++tally.missions;
  tally.slept += slept.slept;
  tally.woken += slept.woken;
  tally.needed += slept.needed;
}

void expectWorthRunning(const Tally& tally, size_t slept) {
  EXPECT_GT(tally.slept, slept);
  EXPECT_GT(tally.woken, slept / 10);
  EXPECT_GT(tally.needed, slept / 20);
}

/// With C functions, windows and all else: little can be foreseen.
TEST(Foresee, NothingNewHappensInTicksThatAreSleptThroughOfRandomMissions) {
  Tally tally;
  for (uint64_t seed = 0; seed < 600 && !HasFatalFailure(); ++seed) {
    const ir::Mission mission = random_missions::flownMission(seed);
    fly(mission, random_missions::randomStream(mission, seed, kTicks), seed, tally);
  }
  expectWorthRunning(tally, 150);
}

TEST(Foresee, NothingNewHappensInTicksThatAreSleptThrough) {
  Tally tally;
  for (uint64_t seed = 0; seed < 300 && !HasFatalFailure(); ++seed) {
    frontend::testing_support::FrontendRun run(sleepyMission(seed));
    const auto mission = run.compile();
    ASSERT_TRUE(mission) << run.said() << sleepyMission(seed);
    fly(*mission, slowStream(*mission, seed, kTicks), seed, tally);
    ASSERT_FALSE(HasFatalFailure()) << sleepyMission(seed);
  }
  expectWorthRunning(tally, 5000);
  EXPECT_GT(tally.missions, 200U);
}

}  // namespace
}  // namespace glider::naps
