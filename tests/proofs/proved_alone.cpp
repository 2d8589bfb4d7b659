// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/proofs/proved_alone.h"

#include "ir/prove/passes.h"
#include "ir/verify/verify.h"
#include "tests/proofs/properties.h"
#include "tests/unit/frontend/compile.h"

#include <gtest/gtest.h>

namespace glider::tests {

bool isProvedAlone(const ir::prove::Strategy& strategy, const std::string& promise,
                   const std::string& mission_text) {
  frontend::testing_support::FrontendRun run("mission m\nrequire " + promise + "\n" + mission_text);
  const auto mission = run.compile();
  EXPECT_TRUE(mission.has_value()) << run.said();
  if (!mission) {
    return false;
  }
  const ir::Worlds worlds(*mission, slocum());
  const ir::MissionFacts facts = ir::verify(*mission, run.diagnostics);
  const ir::prove::ProofContext proof_context(worlds.widest);
  const ir::prove::Options options;
  z3::context context;
  ir::prove::Proof proof{context, worlds, proof_context, facts, options, run.diagnostics};
  ir::prove::StrategyContext strategies(proof);
  ir::prove::Attempt attempt{0, strategies.mission.requirements.at(0)};
  return strategy.serves(attempt.requirement) && strategy.judge(attempt, strategies).has_value();
}

std::string stateOf(const std::string& name, const std::string& profile, const std::string& cases) {
  return "state " + name + " begin\n  flightprofile " + profile +
         "\n  sensors missiontime, depth\n  events\n" + cases + "\nend\n";
}

}  // namespace glider::tests
