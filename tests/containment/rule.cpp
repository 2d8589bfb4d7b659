// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/containment/rule.h"

#include "ir/text/print.h"
#include "tests/containment/hard_mission.h"
#include "tests/unit/ir/slocum.h"

#include <cstdlib>

namespace glider::containment {
namespace {

size_t wantedSteps() {
  const char* const wanted = std::getenv("GLIDER_CONTAINMENT");
  constexpr size_t kSteps = 20000;
  return wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : kSteps;
}

void fly(Rule& rule, Flight flight, size_t ticks) {
  flight.start();
  rule.start(flight);
  for (size_t i = 0; i < ticks && !flight.over(); ++i) {
    flight.advance();
    rule.begun(flight);
    flight.decide();
    rule.tick(flight);
    if (testing::Test::HasFailure()) {
      ADD_FAILURE() << flight.words() << "\n" << ir::print(flight.mission());
      return;
    }
  }
}

}  // namespace

void holdsFor(const MakeRule& make, const Plan& plan) {
  const size_t wanted = wantedSteps();
  constexpr uint64_t kMostMissions = 1000000;
  size_t steps = 0;
  size_t said = 0;
  uint64_t seed = 0;
  for (; seed < kMostMissions && steps < wanted; ++seed) {
    const ir::Mission mission = hardMission(seed);
    const ir::prove::ProofContext context(mission, ir::slocum());
    const std::unique_ptr<Rule> rule = make(context);
    for (size_t i = 0; rule && i < plan.flights; ++i) {
      fly(*rule, Flight(context, seed * plan.flights + i, plan.power_cuts), plan.ticks);
      if (testing::Test::HasFailure()) {
        ADD_FAILURE() << "seed " << seed;
        return;
      }
    }
    steps += rule ? rule->steps : 0;
    said += rule && rule->steps > 0 ? 1U : 0U;
    // A rule that never says anything is not tested.
    ASSERT_TRUE(seed < 2000 || steps > 0);
  }
  testing::Test::RecordProperty("steps", static_cast<int>(steps));
  testing::Test::RecordProperty("missions", static_cast<int>(seed));
  testing::Test::RecordProperty("said", static_cast<int>(said));
}

}  // namespace glider::containment
