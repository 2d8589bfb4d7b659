// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The simulated override of a REMUS.

#include "simulator/remus100/override.h"

#include "tests/unit/remus100/sbc_lines.h"

#include <gtest/gtest.h>

namespace glider::simulator::remus100 {
namespace {

using glider::testing::give;
using glider::testing::giveGoals;

TEST(RemusOverride, ObeysAllThreeGoalsOnceItIsOn) {
  Override override_(30);
  giveGoals(override_, 20, 1);
  EXPECT_FALSE(override_.isOn());
  EXPECT_FALSE(override_.given());
  give(override_, hooks::recon::Override{true}, 2);
  EXPECT_TRUE(override_.isOn());
  EXPECT_FALSE(override_.given()) << "the goals before it do not count";
  give(override_, hooks::recon::HeadingGoal{90}, 3);
  give(override_, hooks::recon::SpeedGoal{1.5, hooks::recon::SpeedUnit::MetresPerSecond}, 3);
  EXPECT_FALSE(override_.given());
  give(override_, hooks::recon::DepthGoal{20}, 3);
  ASSERT_TRUE(override_.given());
  EXPECT_EQ(override_.given()->heading_deg, 90);
  EXPECT_EQ(override_.given()->speed_m_s, 1.5);
  EXPECT_EQ(override_.given()->depth_m, 20);
}

TEST(RemusOverride, EndsWhenItIsReleased) {
  Override override_(30);
  give(override_, hooks::recon::Override{true}, 1);
  giveGoals(override_, 20, 1);
  EXPECT_FALSE(override_.takeEnd());
  give(override_, hooks::recon::Override{false}, 2);
  EXPECT_FALSE(override_.isOn());
  EXPECT_FALSE(override_.given());
  EXPECT_EQ(override_.takeEnd(), OverrideEnd::Released);
  EXPECT_FALSE(override_.takeEnd()) << "said once";
  give(override_, hooks::recon::Override{false}, 3);
  EXPECT_FALSE(override_.takeEnd());
}

TEST(RemusOverride, EndsWithoutGoals) {
  Override override_(30);
  give(override_, hooks::recon::Override{true}, 10);
  giveGoals(override_, 20, 20);
  give(override_, hooks::recon::Override{true}, 40);
  override_.look(50);
  EXPECT_TRUE(override_.isOn());
  override_.look(50.5);
  EXPECT_FALSE(override_.isOn()) << "to ask for it is not a goal";
  EXPECT_EQ(override_.takeEnd(), OverrideEnd::TimedOut);
  give(override_, hooks::recon::Override{true}, 60);
  EXPECT_FALSE(override_.given()) << "those of before are gone";
  override_.restart();
  EXPECT_EQ(override_.takeEnd(), OverrideEnd::Restarted);
}

}  // namespace
}  // namespace glider::simulator::remus100
