// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Whether `always` may put a state on the stack twice: in one walk, and case by case.

#include "ir/text/print.h"
#include "ir/verify/passes.h"
#include "tests/random_missions/random.h"
#include "tests/unit/ir/missions.h"

#include <fmt/format.h>

namespace glider::ir {
namespace {

constexpr const char* kGuard = "case (ge statetime 4:time)";

/// A random mission of up to 30 states and 12 cases of `always`, in which states call later ones
/// only: without `always` no state is on the stack twice.
Mission forwardCalls(random_missions::Random& random) {
  const uint32_t states = random.between(2, 30);
  std::string text = kHeader + "always ";
  for (uint32_t k = random.between(1, 12); k > 0; --k) {
    const uint32_t target =
        random.chance(0.5) ? states - 1 - random.below((states + 1) / 2) : random.below(states);
    text += fmt::format("{} {} s{} ", kGuard, random.chance(0.7) ? "call" : "goto", target);
  }
  const double calls = random.unit() * 0.6;
  for (uint32_t s = 0; s < states; ++s) {
    std::string cases;
    for (uint32_t k = random.below(4); k > 0; --k) {
      cases += random.chance(calls) && s + 1 < states
                   ? fmt::format("{} call s{} ", kGuard, random.between(s + 1, states - 1))
               : random.chance(0.3) ? fmt::format("{} goto s{} ", kGuard, random.below(states))
                                    : fmt::format("{} exit ", kGuard);
    }
    text += stateText(fmt::format("s{}", s), cases);
  }
  return missionOf(text);
}

TEST(Interruptions, OneWalkFindsWhatEachCaseDoes) {
  random_missions::Random random(20260103);
  size_t mistaken = 0;
  constexpr size_t kMissions = 3000;
  for (size_t i = 0; i < kMissions; ++i) {
    const Mission mission = forwardCalls(random);
    const Structure structure(mission);
    support::DiagnosticEngine diagnostics;
    Verification verification{structure, diagnostics, {}};
    reportInterruptions(verification);
    ASSERT_EQ(interruptionsRecur(structure), verification.recursive) << print(mission);
    mistaken += verification.recursive;
  }
  EXPECT_GT(mistaken, kMissions / 5);  // both must happen often
  EXPECT_LT(mistaken, kMissions * 4 / 5);
}

/// On the stack as a root, a state keeps its own case of `always` from firing; another case whose
/// target calls what the root calls is nevertheless an error.
TEST(Interruptions, ARootThatAlwaysCallsHidesNothing) {
  const auto guarded = [](const std::string& what) { return fmt::format("{} {} ", kGuard, what); };
  const Mission mission = missionOf(kHeader + "always " + guarded("call a") + guarded("call b") +
                                    stateText("a", guarded("call shared") + guarded("exit")) +
                                    stateText("b", guarded("call shared") + guarded("return")) +
                                    stateText("shared", guarded("return")));
  EXPECT_TRUE(interruptionsRecur(Structure(mission)));
}

}  // namespace
}  // namespace glider::ir
