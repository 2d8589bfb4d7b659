// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/containment/rule.h"

#include "ir/text/print.h"
#include "tests/containment/hard_mission.h"
#include "tests/unit/ir/slocum.h"

#include <cmath>
#include <cstdlib>

namespace glider::containment {
namespace {

uint64_t numberFrom(const char* name, uint64_t standard) {
  const char* const text = std::getenv(name);
  return text != nullptr ? std::strtoull(text, nullptr, 10) : standard;
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
  const auto wanted = static_cast<size_t>(
      std::ceil(static_cast<double>(numberFrom("GLIDER_CONTAINMENT", 5000)) * plan.share));
  const uint64_t first = numberFrom("GLIDER_CONTAINMENT_SEED", 0);
  size_t steps = 0;
  size_t said = 0;
  uint64_t seed = first;
  for (; steps < wanted; ++seed) {
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
    ASSERT_TRUE(seed - first < 2000 || steps > 0);
  }
  testing::Test::RecordProperty("steps", static_cast<int>(steps));
  testing::Test::RecordProperty("missions", static_cast<int>(seed - first));
  testing::Test::RecordProperty("said", static_cast<int>(said));
}

void holdsOn(std::span<const ir::Mission> missions, const MakeRule& make, const Plan& plan) {
  size_t steps = 0;
  for (size_t i = 0; i < missions.size() && !testing::Test::HasFailure(); ++i) {
    const ir::prove::ProofContext context(missions[i], ir::slocum());
    const std::unique_ptr<Rule> rule = make(context);
    fly(*rule, Flight(context, i, plan.power_cuts), plan.ticks);
    steps += rule->steps;
  }
  EXPECT_GT(steps, 0U);
}

}  // namespace glider::containment
