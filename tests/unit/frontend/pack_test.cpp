// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What the line `pack` becomes.

#include "platforms/load/load_platform.h"
#include "support/diagnostics/ids/meaning.h"
#include "tests/unit/frontend/compile.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace glider::frontend {
namespace {

using testing_support::FrontendRun;
using testing_support::readSource;

std::string withPack(const std::string& pack, const std::string& guard,
                     const std::string& always = "") {
  return fmt::format(
      "mission m\n{}\n{}state s begin\n flightprofile surfaced\n flightroute noheading\n"
      " sensors missiontime\n events\n case {} || missiontime > 1 h exit\nend\n",
      pack, always, guard);
}

std::optional<ir::Mission> analysed(FrontendRun& run, const std::string& platform) {
  const auto vehicle =
      platforms::loadPlatform(GLIDER_SOURCE_DIR "/platforms/" + platform + ".toml");
  EXPECT_TRUE(vehicle.has_value());
  const uint32_t library =
      run.sources.add("standard.mission", readSource("missions/library/standard.mission"));
  const auto standard = frontend::parse(run.sources, library, run.diagnostics);
  const auto mission = run.parse();
  return analyse(*mission, {*vehicle, {&*standard}, run.sources}, run.diagnostics);
}

ir::Mission compiled(const std::string& text) {
  FrontendRun run(text);
  auto mission = analysed(run, "slocum");
  EXPECT_TRUE(mission.has_value()) << run.said();
  return mission.value_or(ir::Mission());
}

TEST(Pack, IsAChargeOrAnEnergy) {
  const ir::Pack charge = *compiled(withPack("pack 10 Ah at 12 V", "energyleft < 5 %")).pack;
  EXPECT_EQ(charge, (ir::Pack{36000, 12, 0}));
  const ir::Pack energy =
      *compiled(withPack("pack 432 kJ at 12 V reserve 20 %", "energyleft < 5 %")).pack;
  EXPECT_EQ(energy, (ir::Pack{36000, 12, 0.2}));
}

TEST(Pack, OnlyEnergyUsedKeepsTheFirstCharge) {
  EXPECT_TRUE(compiled(withPack("pack 10 Ah at 12 V", "energyleft < 5 %")).always.empty());
  const ir::Mission kept = compiled(withPack("pack 10 Ah at 12 V", "energyused > 5 kJ",
                                             "always case missiontime > 30 min exit\n"));
  ASSERT_EQ(kept.always.size(), 2U);
  const auto first = std::ranges::find(kept.variables, "charge.first", &ir::Variable::name);
  ASSERT_NE(first, kept.variables.end());
  EXPECT_EQ(kept[first->initial].op, ir::Op::Sensor) << "it counts from the start";
  EXPECT_FALSE(kept.always.front().implied);
  EXPECT_TRUE(kept.always.back().implied) << "it comes last: no case is kept from being tried";
  EXPECT_EQ(kept.always.back().transition, ir::Transition::Stay);
}

/// So that requirements and guards about it are the same comparison of a reading.
TEST(Pack, WhatIsLeftIsComparedByTheCharge) {
  for (const auto& [guard, op, ampere_hours] :
       {std::tuple{"energyleft < 30 %", ir::Op::Greater, 7.0},
        {"25 % >= energyleft", ir::Op::GreaterEqual, 7.5},
        {"energyleft > 1", ir::Op::Less, 0.0}}) {
    const ir::Mission mission = compiled(withPack("pack 10 Ah at 12 V", guard));
    const ir::Expr& whole = mission[mission.states.front().cases.front().guard];
    const ir::Expr& comparison = mission[whole.operands[0]];
    EXPECT_EQ(comparison.op, op) << guard;
    EXPECT_EQ(mission[comparison.operands[0]].op, ir::Op::Sensor) << guard;
    EXPECT_NEAR(mission[comparison.operands[1]].number, ampere_hours * 3600, 1e-6) << guard;
  }
  const ir::Mission two = compiled(withPack("pack 10 Ah at 12 V", "energyleft < temp / 100 degC"));
  const ir::Expr& whole = two[two.states.front().cases.front().guard];
  EXPECT_EQ(two[whole.operands[0]].op, ir::Op::Less) << "nothing constant to compare with";
}

TEST(Pack, OfAVehicleThatCountsNoChargeHasNoEnergy) {
  for (const char* platform : {"lauv", "remus100"}) {
    for (const char* word : {"energyleft < 5 %", "energyused > 5 kJ"}) {
      FrontendRun run(withPack("pack 10 Ah at 12 V", word));
      EXPECT_FALSE(analysed(run, platform).has_value());
      EXPECT_TRUE(run.says(support::diagnostics::unknownSensor)) << run.said();
    }
  }
}

TEST(Pack, ARefusedLineIsReportedOnce) {
  FrontendRun run(withPack("pack 0 Ah at 12 V", "energyleft < 5 % || energyused > 5 kJ"));
  EXPECT_FALSE(analysed(run, "slocum").has_value());
  EXPECT_TRUE(run.says(support::diagnostics::packValue));
  EXPECT_FALSE(run.says(support::diagnostics::packMissing)) << run.said();
}

}  // namespace
}  // namespace glider::frontend
