// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/unit/frontend/compile.h"

#include <algorithm>

namespace glider::frontend {
namespace {

using testing_support::FrontendRun;
using testing_support::readSource;

TEST(Figure2, MeansWhatThePaperSays) {
  FrontendRun run(readSource("missions/figure2.mission"));
  const auto mission = run.compile();
  ASSERT_TRUE(mission.has_value()) << run.said();
  EXPECT_EQ(run.said(), "");
  EXPECT_EQ(mission->name, "sampleMission");
  EXPECT_EQ(mission->platform, "slocum");
  ASSERT_EQ(mission->states.size(), 3U);

  const ir::State& s1 = mission->states[0];
  EXPECT_EQ((*mission)[s1.profile.behaviour].name, "yo");
  EXPECT_EQ((*mission)[s1.route.behaviour].name, "nav");
  EXPECT_TRUE(s1.profile.entry.valid());
  EXPECT_FALSE(s1.profile.cases.empty());
  const auto steers = [&](ir::TypeKind kind, double degrees) {
    return std::ranges::any_of(mission->exprs, [&](const ir::Expr& e) {
      return e.op == ir::Op::Constant && e.type.kind == kind && e.number == degrees;
    });
  };
  EXPECT_TRUE(steers(ir::TypeKind::Latitude, 39 + 10.5 / 60));
  EXPECT_TRUE(steers(ir::TypeKind::Longitude, -(73 + 49.8058 / 60)));
  ASSERT_EQ(s1.cases.size(), 2U);
  EXPECT_EQ(s1.cases[0].transition, ir::Transition::Goto);
  EXPECT_EQ((*mission)[s1.cases[0].target].name, "s3");
  EXPECT_EQ(s1.cases[1].transition, ir::Transition::Call);
  EXPECT_EQ((*mission)[s1.cases[1].guard].op, ir::Op::And);

  const ir::State& s2 = mission->states[1];
  EXPECT_EQ((*mission)[s2.route.behaviour].name, "noheading");
  EXPECT_EQ((*mission)[s2.profile.behaviour].name, "thermotrackyo");
  ASSERT_EQ(s2.log.size(), 4U);
  EXPECT_EQ((*mission)[s2.log[0].value].op, ir::Op::MissionTime);
  EXPECT_EQ(s2.cases[0].transition, ir::Transition::Return);
  EXPECT_EQ(mission->states[2].cases[0].transition, ir::Transition::Exit);
}

TEST(Figure2, OperandsComeBeforeWhatUsesThem) {
  FrontendRun run(readSource("missions/figure2.mission"));
  const auto mission = run.compile();
  ASSERT_TRUE(mission.has_value());
  for (uint32_t i = 0; i < mission->exprs.size(); ++i) {
    for (const ir::ExprId operand : mission->exprs[i].operands) {
      EXPECT_TRUE(!operand.valid() || operand.index < i);
    }
  }
}

TEST(Figure2, SubscribesEverySensorThatIsListedOrReadByAProfile) {
  FrontendRun run(readSource("missions/figure5.mission"));
  const auto mission = run.compile();
  ASSERT_TRUE(mission.has_value()) << run.said();
  EXPECT_EQ(run.said(), "");
  std::string names;
  for (const ir::Sensor& sensor : mission->sensors) {
    names += sensor.vehicle_name + " ";
  }
  EXPECT_EQ(names, "m_depth sci_water_temp m_pitch ");
}

}  // namespace
}  // namespace glider::frontend
