// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The example missions with one requirement more, each with the verdict that properties.txt was
// committed with.

#include "tests/proofs/properties.h"

#include "ir/opt/optimise.h"
#include "ir/prove/prove.h"
#include "ir/verify/verify.h"
#include "tests/unit/frontend/compile.h"

#include <gtest/gtest.h>

namespace glider::tests {
namespace {

class Properties : public testing::TestWithParam<Property> {};

TEST_P(Properties, IsDecidedAsCommitted) {
  const Property& property = GetParam();
  frontend::testing_support::FrontendRun run(
      frontend::testing_support::readWithoutPromises("missions/" + property.mission + ".mission") +
      "require " + property.requirement + "\n");
  const auto mission = run.compile();
  ASSERT_TRUE(mission.has_value()) << run.said();
  const ir::MissionFacts facts = ir::verify(*mission, run.diagnostics);
  const auto findings = ir::prove::prove(*mission, facts, slocum(), {}, run.diagnostics);
  ASSERT_EQ(findings.requirements.size(), 1U);
  EXPECT_TRUE(ir::optimise(*mission).requirements.empty()) << "it is built too";
  EXPECT_EQ(ir::prove::word(findings.requirements[0].verdict), property.verdict) << run.said();
}

std::string nameOfProperty(const testing::TestParamInfo<Property>& info) {
  std::string name = std::to_string(info.index) + "_" + info.param.mission;
  for (char& c : name) {
    c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Missions, Properties, testing::ValuesIn(properties()), nameOfProperty);

}  // namespace
}  // namespace glider::tests
