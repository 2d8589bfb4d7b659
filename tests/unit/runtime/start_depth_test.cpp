// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A mission begins only after its program has seen the vehicle near the surface.

#include "tests/unit/runtime/resume_bench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>

namespace glider::runtime::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class StartDepthTest : public ResumeBench {
 protected:
  StartDepthTest() {
    mission_.mission.start_depth_cm = 210;
    vehicle_.clock_at_start = 1.7e9;
    vehicle_.depth = [this](double) { return depth_; };
  }

  [[nodiscard]] bool hasBegun() const { return gliderRuntimeContext(runtime_) != nullptr; }

  void expectWaits() {
    EXPECT_FALSE(hasBegun());
    EXPECT_FALSE(finished_);
    EXPECT_NE(vehicle_.hookbeh().state, hooks::HookState::Active);
    EXPECT_THAT(logCsv(), HasSubstr("mission waits for the surface"));
    const auto told = std::ranges::count_if(vehicle_.events, [](const hooks::SeatEvent& e) {
      return e.kind == hooks::SeatEvent::Kind::SbcNote &&
             std::string(e.text) == "the mission waits for the surface";
    });
    EXPECT_EQ(told, 1);
  }

  void expectBegins() {
    ASSERT_TRUE(hasBegun());
    EXPECT_EQ(vehicle_.hookbeh().state, hooks::HookState::Active);
    EXPECT_LT(gliderRuntimeContext(runtime_)->mission_time, 60);
  }

  VehicleBench vehicle_{{.silence_secs = 24}};
  double depth_ = 0;
};

TEST_F(StartDepthTest, AtTheSurfaceItBeginsAtOnce) {
  boot(vehicle_);
  vehicle_.run(20);
  expectBegins();
  EXPECT_THAT(logCsv(), Not(HasSubstr("waits")));
}

TEST_F(StartDepthTest, UnderWaterItWaitsUntilTheVehicleIsNearTheSurface) {
  depth_ = 12;
  boot(vehicle_);
  vehicle_.run(200);
  expectWaits();
  depth_ = 2.2;
  vehicle_.run(240);
  expectWaits();
  depth_ = 2;
  vehicle_.run(260);
  expectBegins();
}

TEST_F(StartDepthTest, AnUnknownDepthIsNotTheSurface) {
  for (const double unknown : {std::numeric_limits<double>::quiet_NaN(), -50.0}) {
    depth_ = unknown;
    boot(vehicle_);
    vehicle_.run(vehicle_.now() + 60);
    EXPECT_FALSE(hasBegun()) << unknown;
  }
}

TEST_F(StartDepthTest, OnceSeenAtTheSurfaceItsOwnFileMayHaveDivenIt) {
  VehicleBench late({.start_secs = 60, .silence_secs = 24});
  late.depth = [](double now) { return now < 30 ? 0.2 : 12; };
  boot(late);
  late.run(100);
  EXPECT_TRUE(hasBegun());
  EXPECT_EQ(late.hookbeh().state, hooks::HookState::Active);
}

TEST_F(StartDepthTest, AfterARestartOfTheVehicleTheSurfaceMustBeSeenAgain) {
  VehicleBench late({.start_secs = 60, .silence_secs = 24});
  late.depth = [](double now) { return now < 30 ? 0.2 : 12; };
  boot(late);
  late.run(40);
  late.restartMission();
  late.run(200);
  EXPECT_FALSE(hasBegun());
}

TEST_F(StartDepthTest, AProgramThatHasLostItsCheckpointWaits) {
  boot(vehicle_);
  vehicle_.run(60);
  cutPower(vehicle_);
  depth_ = 20;
  store_.content.eachByte([](uint32_t, uint8_t& byte) { byte = 0; });
  vehicle_.run(70);
  boot(vehicle_);
  vehicle_.run(200);
  expectWaits();
  depth_ = 1;
  vehicle_.run(240);
  expectBegins();
}

TEST_F(StartDepthTest, AfterTheEndAndARestartUnderWaterItWaits) {
  end = 60;
  boot(vehicle_);
  vehicle_.run(90);
  ASSERT_TRUE(finished_);
  vehicle_.restartMission();
  depth_ = 9;
  end = 400;
  boot(vehicle_);
  vehicle_.run(150);
  expectWaits();
}

TEST_F(StartDepthTest, WhatContinuesDoesNotWait) {
  boot(vehicle_);
  vehicle_.run(60);
  cutPower(vehicle_);
  depth_ = 20;
  vehicle_.restartMission();
  vehicle_.run(80);
  boot(vehicle_);
  vehicle_.run(120);
  EXPECT_THAT(logCsv(), HasSubstr("mission resumed"));
  EXPECT_EQ(vehicle_.hookbeh().state, hooks::HookState::Active);
}

TEST_F(StartDepthTest, AMissionThatDoesNotReadTheDepthWaitsToo) {
  mission_.sensors = {temperatureSensor()};
  mission_.finish(1);
  mission_.mission.memory_count = 1;
  mission_.fly = [](GliderContext& c, uint32_t) { gliderSurface(&c); };
  mission_.begin = [](GliderContext&) {};
  mission_.advance = [](GliderContext&) {};
  mission_.mission.start_depth_cm = 210;
  mission_.mission.temporal_slots = 0;
  mission_.mission.context_bytes =
      static_cast<uint32_t>(gliderContextLayout(&mission_.mission).bytes);
  mission_.memory.assign(mission_.mission.context_bytes / sizeof(double), 0.0);
  depth_ = 12;
  boot(vehicle_);
  vehicle_.run(60);
  expectWaits();
  depth_ = 0;
  vehicle_.run(80);
  EXPECT_TRUE(hasBegun());
}

}  // namespace
}  // namespace glider::runtime::testing
