// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A mission's program at the port of a vehicle that has no hooks.

#include "runtime/library/library.h"
#include "tests/unit/runtime/port_bench.h"

namespace glider::runtime::extctl {
namespace {

TEST(Backseat, SteersWhileItsMissionFileFlies) {
  TwoStates mission;
  PortBench bench(mission.mission);
  bench.begin();
  for (double now = 0; now <= 40; now += 4) {
    bench.cycle(now, 1 + now / 64, 20);
  }
  ASSERT_NE(bench.context(), nullptr);
  EXPECT_EQ(bench.written(PortSensor::DiveDepth), 20);
  EXPECT_EQ(bench.written(PortSensor::ClimbDepth), hooks::extctl::kFirstClimbDepth)
      << "the vehicle has not been there: it may have to turn";
  EXPECT_EQ(bench.written(PortSensor::WantsSurface), 0);
  EXPECT_EQ(bench.written(PortSensor::Heading), 1.5);
  EXPECT_EQ(bench.written(PortSensor::State), 1);
  EXPECT_EQ(bench.written(PortSensor::Beat), 11) << "one a cycle";
  EXPECT_EQ(bench.texts.front(), "mission,bench");
  bench.cycle(44, 19, 20);
  EXPECT_EQ(bench.written(PortSensor::ClimbDepth), 10) << "holds the depth";
}

TEST(Backseat, LeavesAnotherMissionFileAlone) {
  for (const bool tells : {true, false}) {
    TwoStates mission;
    PortBench bench(mission.mission);
    bench.begin(false);
    if (tells) {
      bench.say(fmt::format("SD,{}:4712", PortBench::index(PortSensor::Program)));
    }
    for (double now = 0; now <= 100; now += 4) {
      bench.cycle(now, 1 + now / 64, 20);
    }
    EXPECT_EQ(bench.context(), nullptr);
    EXPECT_TRUE(std::isnan(bench.written(PortSensor::DiveDepth)));
  }
}

TEST(Backseat, WritesNothingIntoAnotherMissionAfterItsOwn) {
  TwoStates mission;
  PortBench bench(mission.mission);
  bench.begin();
  for (double now = 0; now <= 80; now += 4) {
    bench.cycle(now, 1 + now / 4, 20);
  }
  ASSERT_EQ(bench.written(PortSensor::ClimbDepth), 10);
  bench.say(fmt::format("SD,{}:1", PortBench::index(PortSensor::InGliderDos)));
  bench.cycle(84, 1, 20);
  bench.values.clear();
  bench.say("HI");
  for (double now = 88; now <= 200; now += 4) {
    bench.cycle(now, 1 + now / 256, 20);
  }
  EXPECT_TRUE(bench.values.contains(PortBench::index(PortSensor::Beat)));
  for (uint32_t i = 0; i < PortBench::index(PortSensor::State); ++i) {
    EXPECT_FALSE(bench.values.contains(i)) << i;
  }
}

TEST(Backseat, KnowsThatANewMissionOfTheVehicleHasItsFirstDepthsAgain) {
  TwoStates mission;
  PortBench bench(mission.mission);
  bench.begin();
  for (double now = 0; now <= 100; now += 4) {
    bench.cycle(now, 1 + now / 64, 20);
  }
  bench.values.clear();
  double dive_s = NAN, climb_s = NAN;
  for (double now = -kBegun; now <= 100; now += 4) {
    bench.cycle(now, now < 0 ? 1 : 1 + now / 4, 20);
    dive_s = std::isnan(dive_s) && bench.written(PortSensor::DiveDepth) == 20 ? now : dive_s;
    climb_s = std::isnan(climb_s) && bench.written(PortSensor::ClimbDepth) == 10 ? now : climb_s;
  }
  EXPECT_GE(dive_s, StandIn::kBeginSecs - kBegun);
  EXPECT_GE(climb_s, dive_s + hooks::extctl::kSettleSecs)
      << "the dive to 3 m may still be in force";
}

TEST(Backseat, BeginsInTheMidstAtTheSurfaceOnly) {
  TwoStates mission;
  mission.mission.start_depth_cm = 210;
  PortBench bench(mission.mission);
  bench.begin();
  double now = 400;
  for (; now <= 600; now += 4) {
    bench.cycle(now, 30 - (now - 400) / 8, 20);
    EXPECT_EQ(bench.written(PortSensor::WantsSurface), kSurfaceNow);
    EXPECT_EQ(bench.written(PortSensor::ClimbDepth), hooks::extctl::kFirstClimbDepth);
    EXPECT_EQ(bench.context(), nullptr);
  }
  EXPECT_EQ(bench.written(PortSensor::DiveDepth), hooks::extctl::kFirstDiveDepth);
  bench.values.clear();
  double dive_s = NAN, down_s = NAN;
  for (const double until = now + 120; now <= until; now += 4) {
    bench.cycle(now, 1 + now / 4096, 20);
    dive_s = std::isnan(dive_s) && bench.written(PortSensor::DiveDepth) == 20 ? now : dive_s;
    down_s = std::isnan(down_s) && bench.written(PortSensor::WantsSurface) == 0 ? now : down_s;
  }
  EXPECT_LT(dive_s, down_s);
  EXPECT_GE(down_s, dive_s + hooks::extctl::kSettleSecs);
}

/// When the mission begins of a program that begins in mid-mission, at the surface, and can write
/// nothing from 400 s to `stuck_s`; the vehicle is silent from `silent_s` to then.
double beginsAfter(double stuck_s, double silent_s) {
  TwoStates mission;
  mission.mission.start_depth_cm = 210;
  PortBench bench(mission.mission);
  bench.begin();
  bench.line_is_stuck = true;
  double now = 400;
  for (; now < stuck_s; now += 4) {
    if (now < silent_s) {
      bench.cycle(now, 1 + now / 4096, 20);
    }
    EXPECT_EQ(bench.context(), nullptr) << now;
  }
  EXPECT_TRUE(bench.values.empty());
  bench.line_is_stuck = false;
  for (; bench.context() == nullptr && now < stuck_s + 400; now += 4) {
    bench.cycle(now, 1 + now / 4096, 20);
  }
  return now - 4;
}

TEST(Backseat, WhatCouldNotBeWrittenHasNotMadeTheVehicleSafe) {
  for (const double stuck_s : {404.0, 420.0, 500.0, 1000.0}) {
    for (const double silent_s : {stuck_s, 404.0}) {
      const double begins_s = beginsAfter(stuck_s, silent_s);
      EXPECT_GE(begins_s, stuck_s + StandIn::kSafeSecs) << stuck_s << " " << silent_s;
      EXPECT_LE(begins_s, stuck_s + StandIn::kSafeSecs + 12) << stuck_s << " " << silent_s;
    }
  }
}

/// From the shallower climb until the shallower dive, s: written after the line has been stuck, and
/// the vehicle silent, for `stuck_s`.
double fromClimbToDive(double stuck_s, bool silent) {
  TwoStates mission;
  PortBench bench(mission.mission);
  bench.begin();
  double now = kBegun;
  for (; now < kBegun + 200; now += 4) {
    bench.cycle(now, 35, 10);
  }
  EXPECT_EQ(bench.written(PortSensor::DiveDepth), 40);
  EXPECT_EQ(bench.written(PortSensor::ClimbDepth), 30);
  bench.line_is_stuck = true;
  const double from_s = now;
  for (; now < from_s + stuck_s; now += 4) {
    if (!silent || now == from_s) {
      bench.cycle(now, 35, 20);
    }
  }
  bench.line_is_stuck = false;
  double climb_s = NAN, dive_s = NAN;
  for (const double until = now + 120; now < until; now += 4) {
    bench.cycle(now, 35 + now / 4096, 20);
    climb_s = std::isnan(climb_s) && bench.written(PortSensor::ClimbDepth) == 10 ? now : climb_s;
    dive_s = std::isnan(dive_s) && bench.written(PortSensor::DiveDepth) == 20 ? now : dive_s;
  }
  return dive_s - climb_s;
}

TEST(Backseat, WhatWasStuckOnTheLineSettlesFromWhenItHasLeft) {
  for (const double stuck_s : {0.0, 12.0, 24.0, 40.0, 100.0}) {
    for (const bool silent : {false, true}) {
      EXPECT_GE(fromClimbToDive(stuck_s, silent), hooks::extctl::kSettleSecs)
          << stuck_s << " " << silent;
    }
  }
}

TEST(Backseat, AnotherSurfacingOfTheVehicleMakesTheDiveAfterItANewOne) {
  TwoStates mission;
  PortBench bench(mission.mission);
  bench.begin();
  double now = 0;
  const auto fly = [&](double to_m) {
    for (double depth_m = 1; now < 400 && depth_m < to_m; depth_m += 1, now += 4) {
      bench.cycle(now, depth_m, 20);
    }
  };
  fly(21);
  EXPECT_EQ(bench.written(PortSensor::ClimbDepth), 10);
  bench.cycle(now += 400, 0.25, 20);  // by its own timer
  EXPECT_EQ(bench.written(PortSensor::ClimbDepth), hooks::extctl::kFirstClimbDepth);
  bench.cycle(now += 4, 2, 20);
  EXPECT_EQ(bench.written(PortSensor::ClimbDepth), hooks::extctl::kFirstClimbDepth);
}

TEST(Backseat, WhatTheVehicleHasSeenFarBelowDoesNotCount) {
  TwoStates mission;
  PortBench bench(mission.mission);
  bench.begin();
  double now = 0;
  for (double depth_m = 1; depth_m <= 40; depth_m += 1, now += 4) {
    bench.cycle(now, depth_m, 10);  // the state whose dive is to 40 m
  }
  EXPECT_EQ(bench.written(PortSensor::ClimbDepth), 30);
  for (double depth_m = 40; depth_m >= 3; depth_m -= 1, now += 4) {
    bench.cycle(now, depth_m, 10);
  }
  EXPECT_LE(bench.written(PortSensor::ClimbDepth), 3 + 1.5 * kPort.hold_m - kPort.hold_m)
      << "a yo lies above what is known of the water";
}

TEST(Backseat, AReportAfterAPauseIsNotOld) {
  TwoStates mission;
  PortBench bench(mission.mission);
  bench.begin();
  for (double now = 0; now <= 40; now += 4) {
    bench.cycle(now, 1 + now / 64, 20);
  }
  bench.say(fmt::format("SD,{}:17.5", bench.ofSensor(GLIDER_SCI_WATER_TEMP)));
  bench.say(fmt::format("SD,{}:{},{}:{}", bench.ofSensor(GLIDER_M_PRESENT_SECS_INTO_MISSION),
                        100 + kBegun, bench.clock(), 1.7e9 + 100));
  ASSERT_NE(bench.context(), nullptr);
  EXPECT_EQ(bench.context()->readings[1].raw, 17.5);
}

TEST(Backseat, DoesNotSteerAtTheVehiclesPrompt) {
  TwoStates mission;
  PortBench bench(mission.mission);
  bench.begin();
  bench.say(fmt::format("SD,{}:1", PortBench::index(PortSensor::InGliderDos)));
  for (double now = 0; now <= 40; now += 4) {
    bench.cycle(now, 1 + now / 64, 20);
  }
  EXPECT_EQ(bench.context(), nullptr);
}

TEST(Backseat, EndsAtTheSurfaceAndSaysSoForHalfAMinute) {
  TwoStates mission;
  mission.end_s = 60;
  PortBench bench(mission.mission);
  bench.begin();
  double ended_s = NAN;
  int surfaces = 0;
  for (double now = 0; now <= 200 && !bench.finished(); now += 4) {
    bench.values.erase(PortBench::index(PortSensor::WantsSurface));
    bench.cycle(now, 1 + now / 64, 20);
    surfaces += bench.written(PortSensor::WantsSurface) == kSurfaceNow ? 1 : 0;
    if (std::isnan(ended_s) && bench.context() != nullptr && bench.context()->finished != 0) {
      ended_s = now;
      EXPECT_EQ(bench.written(PortSensor::WantsSurface), kSurfaceNow) << "at once";
    }
    if (bench.finished()) {
      EXPECT_GE(now - ended_s, 4 * StandIn::kReleaseCycles);
    }
  }
  EXPECT_TRUE(bench.finished());
  EXPECT_GE(surfaces, static_cast<int>(StandIn::kReleaseCycles)) << "in each answer";
}

/// What it said may have been lost: a yo that turns near the surface is not up.
TEST(Backseat, EndsOnlyWhenTheVehicleHasBeenUpForAMinute) {
  TwoStates mission;
  mission.end_s = 60;
  mission.mission.start_depth_cm = 300;
  PortBench bench(mission.mission);
  bench.begin();
  double up_s = NAN;
  for (double now = 0; now <= 1000 && !bench.finished(); now += 4) {
    const double yo = std::fabs(std::fmod(now, 200) - 100) / 5;  // 0 to 20 m, 3 m or less for 60 s
    const double depth = now < 600 ? yo + 0.5 : 0.1 + now / 1e5;
    up_s = now < 600 ? now : up_s;
    bench.cycle(now, depth, 20);
  }
  EXPECT_TRUE(bench.finished());
  EXPECT_GE(up_s, 596);
}

TEST(Backseat, TwoSentencesInAReadGarbageAndAnyCase) {
  TwoStates mission;
  PortBench bench(mission.mission);
  bench.begin();
  bench.send(std::string_view("\0boot\r\n$B$HI*01$SD,3*", 21));
  for (double now = 0; now <= 40; now += 4) {
    bench.cycle(now, 1 + now / 64, 20);
  }
  EXPECT_EQ(bench.written(PortSensor::DiveDepth), 20);
}

TEST(Backseat, IndicesAndPairsThatAreNoneAreIgnored) {
  TwoStates mission;
  PortBench bench(mission.mission);
  bench.begin();
  bench.say("SD");
  bench.say("SD,");
  bench.say("SD,:5,x:1,5,99:1,4294967296:3,8:5:,-1:2,0,25*");
  bench.say("FI,AAAA");
  bench.say("NEXT");
  bench.say("ER,none");
  bench.say(std::string("TT"));
  for (double now = 0; now <= 40; now += 4) {
    bench.cycle(now, 1 + now / 64, 20);
  }
  EXPECT_EQ(bench.written(PortSensor::DiveDepth), 20);
}

TEST(Backseat, CountsWhatArrivesDamaged) {
  TwoStates mission;
  PortBench bench(mission.mission);
  bench.begin();
  bench.cycle(0, 1, 20);
  EXPECT_EQ(bench.damaged(), 0U);
  bench.send("$SD,0:1*01\r\n$B");
  bench.say("SD,99:1,x:2");
  for (double now = 4; now <= 40; now += 4) {
    bench.cycle(now, 1 + now / 64, 20);
  }
  EXPECT_EQ(bench.damaged(), 4U) << "a sum, a sentence cut off, two pairs";
}

TEST(Backseat, WhatWasSaidBeforeTheLinkIsNotLost) {
  TwoStates mission;
  PortBench bench(mission.mission);
  bench.begin();
  bench.cycle(0, 1, 20);
  for (double now = 4; now <= 16; now += 4) {  // depth and temperature do not change any more
    bench.say(fmt::format("SD,{}:{},{}:{}", bench.ofSensor(GLIDER_M_PRESENT_SECS_INTO_MISSION),
                          now + kBegun, bench.clock(), 1.7e9 + now));
  }
  ASSERT_NE(bench.context(), nullptr) << "it begins only at the surface, as the depth says";
  EXPECT_EQ(bench.context()->readings[1].raw, 20);
}

TEST(Backseat, ARestartedPortIsToldEverythingAgain) {
  TwoStates mission;
  PortBench bench(mission.mission);
  bench.begin();
  for (double now = 0; now <= 40; now += 4) {
    bench.cycle(now, 1 + now / 64, 20);
  }
  for (const char* word : {"BY", "HI"}) {
    bench.values.clear();
    bench.say(word);
    bench.cycle(word[0] == 'B' ? 44 : 48, 5, 20);
    EXPECT_EQ(bench.values.size(), hooks::extctl::kWrittenSensors) << word;
  }
}

TEST(Backseat, ACutLineEndsTheProgram) {
  TwoStates mission;
  PortBench bench(mission.mission);
  bench.begin();
  bench.cycle(0, 1, 20);
  bench.line_is_cut = true;
  bench.send("");
  EXPECT_FALSE(bench.finished());
}

/// A temperature that crosses both limits many times; exact in six decimals and in a float.
double temperatureAt(double now_s) {
  return 13 + std::round(64 * 3 * std::sin(now_s / 37)) / 64 + std::fmod(now_s, 8) / 512;
}
double depthAt(double now_s) {
  return 1 + std::round(now_s) / 256;
}

/// The vehicle's times of the transitions, s, and where to.
using Moves = std::vector<std::pair<double, uint32_t>>;

Moves movesOverPort() {
  TwoStates mission;
  PortBench bench(mission.mission);
  bench.begin();
  Moves moves;
  for (double now = 0; now < 2000; now += 4) {
    const size_t before = bench.texts.size();
    bench.cycle(now, depthAt(now), temperatureAt(now));
    for (size_t i = before; i < bench.texts.size(); ++i) {
      if (bench.texts[i].starts_with("transition,")) {
        moves.emplace_back(now, bench.context()->state);
      }
    }
  }
  return moves;
}

Moves movesOverHooks() {
  TwoStates mission;
  testing::VehicleBench vehicle({.start_secs = 0, .greatest_depth_m = 60});
  vehicle.depth = depthAt;
  vehicle.temperature = temperatureAt;
  vehicle.reports = {GLIDER_M_DEPTH};
  std::vector<double> memory(gliderRuntimeSize() / sizeof(double) + 1);
  std::vector<double> context(mission.mission.context_bytes / sizeof(double) + 1);
  GliderRuntime* runtime =
      gliderRuntimeInit(memory.data(), context.data(), &mission.mission, nullptr);
  Moves moves;
  vehicle.sbc = [&] {
    const GliderClock clock{nullptr, [](void*) { return 0.0; }};
    const GliderByteStream stream = vehicle.sbcEnd();
    const GliderContext* now = gliderRuntimeContext(runtime);
    const uint32_t before = now == nullptr ? 0 : now->state;
    while (gliderRuntimePoll(runtime, &stream, &clock) == kGliderRuntimeProgressed) {
    }
    now = gliderRuntimeContext(runtime);
    if (now != nullptr && now->state != before) {
      moves.emplace_back(vehicle.now() - std::fmod(vehicle.now(), 4), now->state);
    }
  };
  vehicle.run(2000);
  return moves;
}

TEST(Backseat, TheSameTransitionsOnTheSameTicksAsOverTheHooks) {
  const Moves port = movesOverPort(), hooks = movesOverHooks();
  EXPECT_GT(port.size(), 10U);
  EXPECT_EQ(port, hooks);
}

}  // namespace
}  // namespace glider::runtime::extctl
