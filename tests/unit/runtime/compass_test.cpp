// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Headings are true in the mission and magnetic on the vehicle: what is converted, and by what.

#include "runtime/abi/behaviour.h"
#include "runtime/numbers/numbers.h"
#include "tests/unit/runtime/bench_mission.h"
#include "tests/unit/runtime/log_csv.h"
#include "tests/unit/runtime/power_cut_store.h"
#include "tests/unit/runtime/vehicle_bench.h"

#include <gtest/gtest.h>

#include <cmath>
#include <gmock/gmock.h>
#include <limits>

namespace glider::runtime::testing {
namespace {

constexpr double kNoHeading = std::numeric_limits<double>::quiet_NaN();
constexpr double kEast = kTwoPi / 4;
constexpr double kPi = kTwoPi / 2;
constexpr double kOffNewJersey = 0.21;  // west, so magnetic headings are greater

GliderSensorInfo headingSensor() {
  return {"m_heading", nullptr, 1, 0, kTwoPi, 20, GLIDER_M_HEADING, kGliderMagnetic};
}
GliderSensorInfo variationSensor() {
  return {"m_gps_mag_var", nullptr, 1, -kPi, kPi, 3600, GLIDER_M_GPS_MAG_VAR, kGliderLinear};
}
GliderCompass compassWith(double declination) {
  return {declination, GLIDER_M_GPS_MAG_VAR, 0, gliderConvertHeadings};
}

class Compass : public ::testing::Test {
 protected:
  Compass() {
    mission_.sensors = {depthSensor(), headingSensor(), variationSensor()};
    mission_.states = {benchState("only", nullptr, 0)};
    mission_.fly = [this](GliderContext& c, uint32_t) {
      gliderDescend(&c, 12, .454);
      gliderSteer(&c, steered_);
    };
    mission_.mission.compass = &compass_;
    mission_.mission.resume_within = 120;
    mission_.finish(1);
  }

  /// The frame, as the mission gets it.
  std::vector<double> taken(std::vector<GliderUpdate> frame) {
    const auto count = static_cast<uint32_t>(frame.size());
    frame.resize(hooks::kMostSubscriptions);
    frame.resize(
        gliderConvertHeadings(&mission_.mission, nullptr, &variation_, frame.data(), count));
    std::vector<double> values;
    for (const GliderUpdate& u : frame) {
      values.push_back(u.value);
    }
    return values;
  }
  double trueOf(double magnetic) { return taken({update(GLIDER_M_HEADING, magnetic)})[0]; }
  void hear(double variation) { (void)taken({update(GLIDER_M_GPS_MAG_VAR, variation)}); }

  /// Power comes: the program starts, and remembers nothing but its checkpoints.
  void boot(VehicleBench& vehicle) {
    runtime_memory_.assign(gliderRuntimeSize() / sizeof(double) + 1, -1.0);
    std::ranges::fill(mission_.memory, -1.0);
    const GliderRuntimeOptions options{
        {this, &Compass::writeLog, nullptr, nullptr}, nullptr, store_.store(), 7};
    runtime_ = gliderRuntimeInit(runtime_memory_.data(), mission_.memory.data(), &mission_.mission,
                                 &options);
    ASSERT_NE(runtime_, nullptr);
    vehicle.sbc = [this, &vehicle] {
      const GliderByteStream stream = vehicle.sbcEnd();
      double now = vehicle.now();
      const GliderClock clock{&now, [](void* t) { return *static_cast<double*>(t); }};
      while (gliderRuntimePoll(runtime_, &stream, &clock) == kGliderRuntimeProgressed) {
      }
    };
  }
  static int32_t writeLog(void* self, const uint8_t* bytes, uint32_t count) {
    static_cast<Compass*>(self)->log_text_.append(reinterpret_cast<const char*>(bytes), count);
    return static_cast<int32_t>(count);
  }
  [[nodiscard]] double readHeading() const {
    return gliderRead(gliderRuntimeContext(runtime_), GLIDER_M_HEADING);
  }
  /// A vehicle that reports nothing of its own but a heading.
  struct HeadedVehicle : VehicleBench {
    explicit HeadedVehicle(double magnetic) : VehicleBench({.silence_secs = 24}) {
      reports = {GLIDER_M_HEADING};
      set(GLIDER_M_HEADING, magnetic);
    }
  };

  GliderCompass compass_ = compassWith(kNoHeading);
  double variation_ = kNoHeading;
  double steered_ = kEast;
  BenchMission mission_;
  RecordingStore store_;
  std::vector<double> runtime_memory_;
  GliderRuntime* runtime_ = nullptr;
  std::string log_text_;
};

TEST_F(Compass, TrueIsMagneticLessVariation) {
  hear(kOffNewJersey);
  EXPECT_DOUBLE_EQ(trueOf(kEast + kOffNewJersey), kEast);
  EXPECT_DOUBLE_EQ(trueOf(0.1), 0.1 - kOffNewJersey + kTwoPi);
  hear(-kOffNewJersey);
  EXPECT_DOUBLE_EQ(trueOf(kEast), kEast + kOffNewJersey);
  EXPECT_NEAR(trueOf(kTwoPi - 0.1), kOffNewJersey - 0.1, 1e-14);
}

TEST_F(Compass, TheVariationOfAFrameCountsForItsHeadings) {
  EXPECT_DOUBLE_EQ(taken({update(GLIDER_M_HEADING, 1), update(GLIDER_M_GPS_MAG_VAR, 0.5)})[0], 0.5);
}

TEST_F(Compass, AHeadingIsNeverAFullTurn) {
  hear(1e-20);
  EXPECT_EQ(trueOf(0), 0);
  hear(-kPi);
  EXPECT_EQ(trueOf(kPi), 0);
  hear(0);
  EXPECT_EQ(trueOf(kTwoPi), 0);
  EXPECT_EQ(trueOf(kEast), kEast) << "to the bit";
}

TEST_F(Compass, WhatNoCompassGivesStaysImplausible) {
  hear(0.5);
  EXPECT_EQ(trueOf(kTwoPi + 0.2), kTwoPi + 0.2);
  EXPECT_EQ(trueOf(-0.2), -0.2);
  EXPECT_TRUE(std::isnan(trueOf(kNoHeading)));
}

TEST_F(Compass, OnlyHeadingsAreTurned) {
  hear(0.5);
  EXPECT_EQ(taken({update(GLIDER_M_DEPTH, 1)})[0], 1);
  EXPECT_EQ(taken({update(GLIDER_M_GPS_MAG_VAR, 0.5)})[0], 0.5);
  EXPECT_EQ(taken({update(GLIDER_C_HEADING, 1)})[0], 1) << "not one of the mission's";
}

TEST_F(Compass, AnAbsurdVariationLeavesTheLast) {
  hear(kOffNewJersey);
  for (const double absurd : {kNoHeading, 3.15, -3.15, 69.0, HUGE_VAL, -HUGE_VAL}) {
    hear(absurd);
    EXPECT_DOUBLE_EQ(trueOf(1), 1 - kOffNewJersey) << absurd;
  }
}

TEST_F(Compass, WhatTheMissionReadsIsWhatHeadingsAreConvertedBy) {
  hear(kOffNewJersey);
  for (const double absurd : {kNoHeading, 3.15, 69696969.0}) {
    EXPECT_EQ(taken({update(GLIDER_M_GPS_MAG_VAR, absurd)})[0], kOffNewJersey) << absurd;
  }
  std::vector<GliderUpdate> frame{update(GLIDER_M_HEADING, 1), {}};
  const auto convert = [&](GliderContext* context, uint32_t count) {
    return gliderConvertHeadings(&mission_.mission, context, &variation_, frame.data(), count);
  };
  EXPECT_EQ(convert(nullptr, 1), 2U) << "reported before the mission began";
  EXPECT_EQ(frame[1].id, GLIDER_M_GPS_MAG_VAR);
  EXPECT_EQ(frame[1].value, kOffNewJersey);
  EXPECT_EQ(convert(nullptr, 2), 2U);
  EXPECT_EQ(convert(mission_.start(), 1), 1U) << "the mission has it";
  std::vector<GliderUpdate> full(hooks::kMostSubscriptions + 1, update(GLIDER_M_DEPTH, 1));
  EXPECT_EQ(gliderConvertHeadings(&mission_.mission, nullptr, &variation_, full.data(),
                                  hooks::kMostSubscriptions),
            hooks::kMostSubscriptions);
  variation_ = kNoHeading;
  EXPECT_EQ(convert(nullptr, 1), 1U) << "never reported";
}

TEST_F(Compass, UntilTheVehicleReportsItTheMissionsDeclinationCounts) {
  compass_.declination = -0.2;
  EXPECT_DOUBLE_EQ(trueOf(1), 0.8);
  hear(kOffNewJersey);
  EXPECT_DOUBLE_EQ(trueOf(1), 1 - kOffNewJersey);
}

TEST_F(Compass, WithNeitherHeadingsAreMagnetic) {
  EXPECT_EQ(trueOf(1), 1);
}

TEST_F(Compass, AResumedMissionKeepsTheLast) {
  GliderContext* kept = mission_.start();
  kept->variation = 0.3;
  GliderUpdate frame[] = {update(GLIDER_M_HEADING, 1)};
  gliderConvertHeadings(&mission_.mission, kept, &variation_, frame, 1);
  EXPECT_DOUBLE_EQ(frame[0].value, 0.7);
  variation_ = 0.1;  // newer than the checkpoint
  frame[0].value = 1;
  gliderConvertHeadings(&mission_.mission, kept, &variation_, frame, 1);
  EXPECT_DOUBLE_EQ(frame[0].value, 0.9);
}

TEST_F(Compass, TheVehicleGetsMagneticHeadingsAndTheMissionTrueOnes) {
  HeadedVehicle vehicle(1);
  vehicle.reports.push_back(GLIDER_M_GPS_MAG_VAR);
  vehicle.set(GLIDER_M_GPS_MAG_VAR, kOffNewJersey);
  boot(vehicle);
  vehicle.run(20);
  EXPECT_NEAR(vehicle.array(GLIDER_SCI_HOOK_HEADING), kEast + kOffNewJersey, 5e-6);
  EXPECT_NEAR(readHeading(), 1 - kOffNewJersey, 1e-6);
  EXPECT_THAT(log_text_, ::testing::Not(::testing::HasSubstr("declination")));
  // Another fix, far away: the command in force follows.
  vehicle.set(GLIDER_M_GPS_MAG_VAR, -0.3);
  vehicle.run(40);
  EXPECT_NEAR(vehicle.array(GLIDER_SCI_HOOK_HEADING), kEast - 0.3, 5e-6);
  EXPECT_NEAR(readHeading(), 1.3, 1e-6);
}

TEST_F(Compass, WhatWasReportedBeforeControlCounts) {
  VehicleBench vehicle({.start_secs = 60, .silence_secs = 24});
  vehicle.reports = {GLIDER_M_GPS_MAG_VAR};
  vehicle.set(GLIDER_M_GPS_MAG_VAR, kOffNewJersey);
  boot(vehicle);
  vehicle.run(40);
  vehicle.reports.clear();  // under water before the SBC has control
  vehicle.run(90);
  EXPECT_NEAR(vehicle.array(GLIDER_SCI_HOOK_HEADING), kEast + kOffNewJersey, 5e-6);
}

TEST_F(Compass, AVehicleThatNeverReportsItFliesByTheMissionsLine) {
  compass_.declination = -0.2;
  HeadedVehicle vehicle(1);
  boot(vehicle);
  vehicle.run(20);
  EXPECT_NEAR(vehicle.array(GLIDER_SCI_HOOK_HEADING), kEast + 0.2, 5e-6);
  EXPECT_NEAR(readHeading(), 0.8, 1e-6);
  EXPECT_THAT(log_text_, ::testing::Not(::testing::HasSubstr("declination")));
}

TEST_F(Compass, WithoutVariationAndDeclinationHeadingsStayMagneticWithOneNote) {
  HeadedVehicle vehicle(1);
  boot(vehicle);
  vehicle.run(60);
  EXPECT_NEAR(vehicle.array(GLIDER_SCI_HOOK_HEADING), kEast, 5e-6);
  EXPECT_NEAR(readHeading(), 1, 1e-6);
  const std::string log = csvOf(log_text_);
  const size_t first = log.find("declination unknown: headings are magnetic");
  EXPECT_NE(first, std::string::npos) << log;
  EXPECT_EQ(log.find("declination unknown", first + 1), std::string::npos) << log;
  int told = 0;
  for (const auto& event : vehicle.events) {
    told += event.kind == hooks::SeatEvent::Kind::SbcNote ? 1 : 0;
  }
  EXPECT_EQ(told, 1);
}

TEST_F(Compass, APowerCutKeepsTheLast) {
  HeadedVehicle vehicle(1);
  vehicle.reports.push_back(GLIDER_M_GPS_MAG_VAR);
  vehicle.set(GLIDER_M_GPS_MAG_VAR, kOffNewJersey);
  boot(vehicle);
  vehicle.run(60);
  vehicle.reports = {GLIDER_M_HEADING};  // under water
  vehicle.sbc = [] {};
  vehicle.run(64);
  boot(vehicle);
  vehicle.set(GLIDER_M_HEADING, 2);
  vehicle.run(90);
  EXPECT_NEAR(readHeading(), 2 - kOffNewJersey, 1e-6);
  EXPECT_NEAR(vehicle.array(GLIDER_SCI_HOOK_HEADING), kEast + kOffNewJersey, 5e-6);
}

TEST_F(Compass, NorthAcrossTheTurn) {
  steered_ = kTwoPi - 0.1;
  HeadedVehicle vehicle(1);
  vehicle.reports.push_back(GLIDER_M_GPS_MAG_VAR);
  vehicle.set(GLIDER_M_GPS_MAG_VAR, kOffNewJersey);
  boot(vehicle);
  vehicle.run(20);
  EXPECT_NEAR(vehicle.array(GLIDER_SCI_HOOK_HEADING), kOffNewJersey - 0.1, 5e-6);
}

TEST_F(Compass, AWaypointHasNoHeading) {
  mission_.fly = [](GliderContext& c, uint32_t) {
    gliderDescend(&c, 12, .454);
    gliderSteerTo(&c, 39, -73);
  };
  HeadedVehicle vehicle(1);
  vehicle.reports.push_back(GLIDER_M_GPS_MAG_VAR);
  vehicle.set(GLIDER_M_GPS_MAG_VAR, kOffNewJersey);
  boot(vehicle);
  vehicle.run(20);
  EXPECT_NEAR(vehicle.array(GLIDER_SCI_HOOK_LAT), 3900, 1e-9);
  EXPECT_EQ(vehicle.array(GLIDER_SCI_HOOK_HEADING), 0);
}

TEST_F(Compass, AMissionWithoutHeadingsIsLeftAlone) {
  mission_.mission.compass = nullptr;
  mission_.fly = [](GliderContext& c, uint32_t) {
    gliderDescend(&c, 12, .454);
    gliderSteerTo(&c, 39, -73);
  };
  HeadedVehicle vehicle(1);
  boot(vehicle);
  vehicle.run(20);
  EXPECT_NEAR(vehicle.array(GLIDER_SCI_HOOK_LAT), 3900, 1e-9);
  EXPECT_NEAR(readHeading(), 1, 1e-6);
}

}  // namespace
}  // namespace glider::runtime::testing
