// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// How long what the vehicle reports of its depth stays known: it reports what changes only.

#include "tests/unit/runtime/port_bench.h"

namespace glider::runtime::extctl {
namespace {

/// The vehicle reports that it dives once, and the mission's reading of it is stale after 20 s.
TEST(Backseat, AStateOfTheVehicleThatGoesOnStaysKnown) {
  TwoStates mission;
  mission.sensors.push_back(
      {"m_depth_state", nullptr, 1, 0, 99, 20, GLIDER_M_DEPTH_STATE, kGliderLinear});
  mission.finish(2);
  PortBench bench(mission.mission);
  bench.begin();
  for (double now = 0; now <= 120; now += 4) {
    if (now == 20) {
      bench.say(fmt::format("SD,{}:1", bench.ofSensor(GLIDER_M_DEPTH_STATE)));
    }
    bench.cycle(now, now < 100 ? 1 + now / 8 : 13.4 - (now - 100) / 2, 20);
    if (now >= 24) {
      ASSERT_NE(bench.context(), nullptr);
      EXPECT_EQ(std::isnan(bench.context()->readings[2].value), false) << now;
    }
  }
  for (double now = 124; now <= 140; now += 4) {
    bench.cycle(now, 3, 20);
  }
  EXPECT_TRUE(std::isnan(bench.context()->readings[2].value)) << "it climbs";
}

/// A mission that commands the surface, and after `dives_s` a dive.
struct AtTheSurface : TwoStates {
  AtTheSurface() {
    fly = [this](GliderContext& c, uint32_t) {
      if (c.mission_time < dives_s) {
        gliderSurface(&c);
      } else {
        gliderDescend(&c, 20, -0.4);
      }
      gliderSteer(&c, 1.5);
    };
    finish(2);
  }
  double dives_s = 200;
};

/// At the surface it may report the same depth for hours: it is reported once, and stale after 20
/// s.
TEST(Backseat, TheDepthAtTheSurfaceStaysKnownUntilADiveIsCommanded) {
  for (const double depth : {0.0, 1.0, 1.5}) {
    AtTheSurface mission;
    PortBench bench(mission.mission);
    bench.begin();
    for (double now = 0; now <= 300; now += 4) {
      if (now == 0) {
        bench.cycle(now, depth, 20);
      } else {
        bench.cycle(now);
      }
      if (now < 60 || bench.context() == nullptr) {
        continue;
      }
      const bool known = !std::isnan(bench.context()->readings[0].value);
      if (now < 200) {
        EXPECT_EQ(known, depth <= 1) << now << " s at " << depth << " m";
      } else if (now > 270) {
        EXPECT_FALSE(known) << "it should have left the surface";
      }
    }
    ASSERT_NE(bench.context(), nullptr);
  }
}

/// A sensor that stops at the surface: after the next dive its depth says nothing.
TEST(Backseat, ADepthThatDidNotMoveInTheDiveIsNotThatOfTheSurface) {
  for (const bool stopped : {true, false}) {
    AtTheSurface mission;
    mission.dives_s = 100;
    mission.fly = [&mission](GliderContext& c, uint32_t) {
      if (c.mission_time >= mission.dives_s && c.mission_time < 300) {
        gliderDescend(&c, 20, -0.4);
      } else {
        gliderSurface(&c);
      }
      gliderSteer(&c, 1.5);
    };
    PortBench bench(mission.mission);
    bench.begin();
    for (double now = 0; now <= 600; now += 4) {
      const bool moves = now == 0 || (!stopped && now > 150 && now < 400);
      if (moves) {
        bench.cycle(now, now == 0 ? 0.4 : (396 - now) / 10, 20);
      } else {
        bench.cycle(now);
      }
    }
    ASSERT_NE(bench.context(), nullptr);
    EXPECT_EQ(std::isnan(bench.context()->readings[0].value), stopped);
  }
}

}  // namespace
}  // namespace glider::runtime::extctl
