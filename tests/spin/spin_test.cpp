// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The checks of a mission's structure say what SPIN finds when it searches a model of it.

#include "tests/spin/spin.h"

#include "ir/text/print.h"
#include "ir/text/read.h"
#include "ir/verify/structure.h"
#include "ir/verify/verify.h"
#include "support/diagnostics/ids/verification.h"
#include "support/diagnostics/render.h"
#include "tests/random_missions/random_mission.h"
#include "tests/random_missions/random_structure.h"
#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <optional>

namespace glider::tests {
namespace {

using support::DiagnosticId;

ir::Mission missionOf(const std::string& text) {
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  std::optional<ir::Mission> mission = ir::read(sources, sources.add("text", text), diagnostics);
  EXPECT_TRUE(mission) << support::render(diagnostics, sources, false);
  return mission.value_or(ir::Mission());
}

/// How often the missions put each question.
struct Asked {
  size_t recursive = 0, empty_returns = 0, deep = 0, unreached = 0;
};

Asked compare(const std::vector<ir::Mission>& missions) {
  Asked asked;
  const std::vector<SpinFindings> found = searchWithSpin(missions);
  for (size_t i = 0; i < missions.size(); ++i) {
    support::DiagnosticEngine diagnostics;
    const ir::MissionFacts facts = ir::verify(missions[i], diagnostics);
    const auto reported = diagnostics.sorted();
    const auto count = [&](DiagnosticId id) {
      return static_cast<size_t>(std::ranges::count(reported, id, &support::Diagnostic::id));
    };
    const ir::Structure structure(missions[i]);
    const std::set<uint32_t> reached(structure.order.begin(), structure.order.end());
    EXPECT_EQ(reached, found[i].reached) << ir::print(missions[i]);
    EXPECT_EQ(count(support::diagnostics::emptyReturn), found[i].empty_returns.size())
        << ir::print(missions[i]);
    EXPECT_EQ(count(support::diagnostics::recursiveCall) > 0, found[i].recursive)
        << ir::print(missions[i]);
    if (!found[i].recursive) {
      EXPECT_EQ(facts.stack_depth, found[i].depth) << ir::print(missions[i]);
      asked.deep += found[i].depth > 1;
    }
    asked.recursive += found[i].recursive;
    asked.empty_returns += !found[i].empty_returns.empty();
    asked.unreached += reached.size() < missions[i].states.size();
  }
  return asked;
}

/// The missions that ship, and the good ones of the mutants.
TEST(Spin, FindsWhatTheChecksSayOfTheExamples) {
  std::vector<ir::Mission> missions;
  for (const char* folder : {"/missions", "/missions/gallery", "/tests/mutants/missions"}) {
    for (const auto& file :
         std::filesystem::directory_iterator(GLIDER_SOURCE_DIR + std::string(folder))) {
      if (file.path().extension() == ".mission") {
        const Outcome ir = runShell("$GLIDERCC build " + file.path().string() + " --emit ir -o -");
        ASSERT_EQ(ir.status, 0) << ir.err;
        missions.push_back(missionOf(ir.out));
      }
    }
  }
  EXPECT_GE(missions.size(), 22U);
  compare(missions);
}

TEST(Spin, FindsWhatTheChecksSayOfRandomMissions) {
  std::vector<ir::Mission> missions;
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    missions.push_back(random_missions::randomMission(seed));
  }
  EXPECT_GT(compare(missions).deep, 10U);
}

class SpinStructures : public testing::TestWithParam<bool> {};

/// Most of them are mistaken.
TEST_P(SpinStructures, FindsWhatTheChecksSay) {
  random_missions::Random random(20260104);
  std::vector<ir::Mission> missions;
  for (int i = 0; i < 150; ++i) {
    missions.push_back(missionOf(random_missions::randomStructure(random, GetParam())));
  }
  const Asked asked = compare(missions);
  EXPECT_GT(asked.recursive, 8U);
  EXPECT_LT(asked.recursive, 130U);
  EXPECT_GT(asked.empty_returns, 15U);
  EXPECT_GT(asked.deep, 5U);
  EXPECT_GT(asked.unreached, 15U);
}

INSTANTIATE_TEST_SUITE_P(Kinds, SpinStructures, testing::Bool(), [](const auto& tested) {
  return tested.param ? "WithAlways" : "WithoutAlways";
});

}  // namespace
}  // namespace glider::tests
