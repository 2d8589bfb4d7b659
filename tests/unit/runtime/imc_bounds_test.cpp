// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Commands that are refused because the vehicle would fly something else: runtime/imc/README.md,
// M8.

#include "runtime/front_seat/bounds.h"
#include "tests/unit/runtime/imc_packets.h"

#include <cmath>
#include <limits>

namespace glider::runtime::imc {
namespace {

using hooks::HookAnswer;
using hooks::HookLateral;
using hooks::HookVertical;
using hooks::Instruction;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Instruction fine() {
  Instruction instruction;
  instruction.vertical = HookVertical::Descend;
  instruction.lateral = HookLateral::Heading;
  instruction.depth_m = 20;
  instruction.pitch_rad = 1.2;
  instruction.heading_rad = 1;
  return instruction;
}
template <typename Change>
HookAnswer with(Change change) {
  Instruction instruction = fine();
  change(instruction);
  return checkBounds(instruction,
                     {testing::kImcLimits.greatest_depth_m, testing::kImcLimits.slowest_m_s,
                      testing::kImcLimits.fastest_m_s});
}
HookAnswer withDepth(double depth_m, HookVertical vertical) {
  return with([&](Instruction& i) {
    i.vertical = vertical;
    i.depth_m = depth_m;
  });
}
HookAnswer withSpeed(double speed, HookVertical vertical) {
  return with([&](Instruction& i) {
    i.vertical = vertical;
    i.pitch_rad = speed;
  });
}
HookAnswer withWaypoint(double latitude_ddmm, double longitude_ddmm) {
  return with([&](Instruction& i) {
    i.lateral = HookLateral::Waypoint;
    i.latitude_ddmm = latitude_ddmm;
    i.longitude_ddmm = longitude_ddmm;
  });
}

TEST(ImcBounds, DepthsToTheLimitAndNoDeeper) {
  for (const HookVertical vertical : {HookVertical::Descend, HookVertical::Ascend}) {
    for (const double depth_m : {-1.0, 0.0, 49.9, 50.0}) {
      EXPECT_EQ(withDepth(depth_m, vertical), HookAnswer::Accepted) << depth_m;
    }
    for (const double depth_m : {50.01, 51.0, 1e9}) {
      EXPECT_EQ(withDepth(depth_m, vertical), HookAnswer::TooDeep) << depth_m;
    }
    for (const double depth_m : {std::nan(""), kInfinity, -kInfinity}) {
      EXPECT_EQ(withDepth(depth_m, vertical), HookAnswer::BadCommand) << depth_m;
    }
  }
}

TEST(ImcBounds, SpeedsBetweenTheTwoLimits) {
  for (const HookVertical vertical : {HookVertical::Descend, HookVertical::Ascend}) {
    for (const double speed : {0.7, 1.2, 1.6}) {
      EXPECT_EQ(withSpeed(speed, vertical), HookAnswer::Accepted) << speed;
    }
    for (const double speed : {0.69, 0.0, -1.2, 1.61, 30.0}) {
      EXPECT_EQ(withSpeed(speed, vertical), HookAnswer::BadPitch) << speed;
    }
    for (const double speed : {std::nan(""), kInfinity, -kInfinity}) {
      EXPECT_EQ(withSpeed(speed, vertical), HookAnswer::BadCommand) << speed;
    }
  }
}

TEST(ImcBounds, TheSurfaceNeedsNeither) {
  EXPECT_EQ(with([](Instruction& i) {
              i.vertical = HookVertical::Surface;
              i.depth_m = i.pitch_rad = std::nan("");
            }),
            HookAnswer::Accepted);
}

TEST(ImcBounds, WhatThePropellerCannotDoIsNoCommand) {
  for (const HookVertical vertical :
       {HookVertical::None, HookVertical::Hover, HookVertical::Actuators}) {
    EXPECT_EQ(with([&](Instruction& i) { i.vertical = vertical; }), HookAnswer::BadCommand);
  }
  EXPECT_EQ(with([](Instruction& i) { i.lateral = HookLateral::Fin; }), HookAnswer::BadCommand);
}

TEST(ImcBounds, WaypointsAreOnEarth) {
  for (const double longitude : {-18000.0, -844.5, 0.0, 18000.0}) {
    for (const double latitude : {-9000.0, -0.5, 4112.5, 9000.0}) {
      EXPECT_EQ(withWaypoint(latitude, longitude), HookAnswer::Accepted) << latitude;
    }
  }
  for (const double latitude : {9000.1, -9001.0, 1e9, kInfinity, std::nan("")}) {
    EXPECT_EQ(withWaypoint(latitude, 0), HookAnswer::NotOnEarth) << latitude;
  }
  for (const double longitude : {18000.1, -18001.0, -kInfinity, std::nan("")}) {
    EXPECT_EQ(withWaypoint(0, longitude), HookAnswer::NotOnEarth) << longitude;
  }
}

TEST(ImcBounds, AHeadingIsANumberAndDriftNeedsNone) {
  for (const double heading : {std::nan(""), kInfinity}) {
    EXPECT_EQ(with([&](Instruction& i) { i.heading_rad = heading; }), HookAnswer::BadCommand);
    EXPECT_EQ(with([&](Instruction& i) {
                i.lateral = HookLateral::Drift;
                i.heading_rad = heading;
              }),
              HookAnswer::Accepted);
  }
  EXPECT_EQ(with([](Instruction& i) {
              i.depth_m = 60;
              i.lateral = HookLateral::Drift;
            }),
            HookAnswer::TooDeep);
}

}  // namespace
}  // namespace glider::runtime::imc
