// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// linkShared and LoadedMission: Figure 2 flown in this process, tick by tick.

#include "codegen/load/loaded_mission.h"

#include "support/diagnostics/ids/command.h"
#include "support/diagnostics/ids/target.h"
#include "tests/slocum.h"
#include "tests/unit/codegen/compiled_mission.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glider::codegen_tests {
namespace {

codegen::LoadedMission load(const Checked& checked, int level) {
  codegen::CodegenOptions options;
  options.optimisation_level = level;
  const auto shared = codegen::linkShared(checked.input(), board("host"), options);
  EXPECT_TRUE(shared.has_value()) << shared.error().message;
  auto loaded = codegen::LoadedMission::load(*shared);
  EXPECT_TRUE(loaded.has_value()) << loaded.error().message;
  return std::move(*loaded);
}

class Shared : public testing::TestWithParam<int> {};

TEST_P(Shared, Figure2ChangesStateWhenThePaperSays) {
  Checked checked = figure2();
  checked.mission.sensors[0].id = GLIDER_M_DEPTH;  // which yo asks for
  const codegen::LoadedMission loaded = load(checked, GetParam());
  EXPECT_STREQ(loaded.mission().name, "sampleMission");
  EXPECT_EQ(loaded.mission().state_count, 3u);
  EXPECT_STREQ(loaded.mission().states[1]->name, "s2");
  EXPECT_EQ(loaded.mission().stack_limit, 1u);
  std::vector<double> memory(loaded.mission().context_bytes / sizeof(double));
  GliderUpdate depth{8, GLIDER_M_DEPTH, 0};
  GliderContext* context = loaded.start(memory.data(), nullptr, &depth, 1);
  EXPECT_EQ(context->vertical, kGliderDescend);
  EXPECT_EQ(context->depth, 10);
  std::vector<std::pair<double, uint32_t>> changes;
  for (double time = 4; context->finished == 0 && time < 4000; time += 4) {
    const uint32_t before = context->state;
    loaded.step(context, time, &depth, 1);
    if (context->state != before || context->finished != 0) {
      changes.emplace_back(time, context->state);
    }
  }
  const std::vector<std::pair<double, uint32_t>> expected{
      {500, 1}, {1500, 0}, {2000, 2}, {2500, 2}};
  EXPECT_EQ(changes, expected);
}

INSTANTIATE_TEST_SUITE_P(Levels, Shared, testing::Values(0, 1, 2, 3));

TEST(LoadedMission, TwoLiveSideBySide) {
  const codegen::LoadedMission first = load(figure2(), 2);
  Checked other = figure2();
  other.mission.name = "other";
  const codegen::LoadedMission second = load(other, 2);
  EXPECT_STREQ(first.mission().name, "sampleMission");
  EXPECT_STREQ(second.mission().name, "other");
}

/// A mission with `count` parameters.
Checked withParameters(uint32_t count) {
  Checked checked = figure2();
  for (uint32_t i = 0; i < count; ++i) {
    ir::Expr initial;
    initial.number = 1;
    checked.mission.exprs.push_back(initial);
    ir::Variable& parameter = checked.mission.variables.emplace_back();
    parameter.name = "p" + std::to_string(i);
    parameter.kind = ir::VariableKind::Parameter;
    parameter.initial = {static_cast<uint32_t>(checked.mission.exprs.size() - 1)};
  }
  return checked;
}

TEST(LoadedMission, HasAsManyParametersAsALaunchCanSet) {  // GL4007; accepts: GL4007
  const Checked most = withParameters(GLIDER_MOST_PARAMETERS);
  EXPECT_EQ(load(most, 0).mission().parameter_count, GLIDER_MOST_PARAMETERS);
  const Checked more = withParameters(GLIDER_MOST_PARAMETERS + 1);
  const auto refused = codegen::linkShared(more.input(), board("host"), {});
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().id, support::diagnostics::tooManyParameters);
}

TEST(LoadedMission, RefusesWhatIsNotAMission) {  // GL9051; accepts: GL9051 above
  for (const char* bytes : {"", "hello",
                            "\x7f"
                            "ELF"}) {
    const auto loaded = codegen::LoadedMission::load(bytes);
    ASSERT_FALSE(loaded.has_value());
    EXPECT_EQ(loaded.error().id, support::diagnostics::cannotLoadMission);
  }
}

}  // namespace
}  // namespace glider::codegen_tests
