// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/launch_choice.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace glider::flights {
namespace {

constexpr const char* kChoosingMission = R"(mission chooses
choose bottom : length = 60 m in 60 m .. 180 m
state fly
begin
  flightroute   heading(90 deg)
  flightprofile yo(5 m, bottom)
  sensors       missiontime, depth
  events
    case missiontime > 4 h exit
end
)";

TEST(LaunchChoice, WhatThePlanChoosesIsNotSetAtLaunch) {
  const auto compilation = compiler::compileText("chooses.mission", kChoosingMission);
  ASSERT_TRUE(compilation && compilation->checked);
  const auto set = chooseParameters(compilation->checked->mission(), {{"bottom=60m"}, ""});
  ASSERT_FALSE(set);
  EXPECT_THAT(set.error().message, testing::HasSubstr("has no parameter `bottom`"));
  EXPECT_THAT(set.error().hint, testing::HasSubstr("is chosen by `glidercc plan`"));
}

}  // namespace
}  // namespace glider::flights
