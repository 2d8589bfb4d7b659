// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/unit/hooks/joined_flight.h"

#include <gtest/gtest.h>

namespace glider::hooks {
namespace {

TEST(Joined, ACleanFlightTakesSteersAndReleases) {
  Vehicle vehicle(0, 1);
  Mission mission(1200);
  Witness witness;
  double active_from = 0;
  double deepest = 0;
  for (int i = 0; i < 1300; ++i) {
    vehicle.second(&mission);
    witness.look(vehicle.flight, mission);
    if (vehicle.flight.outputs.state == HookState::Active) {
      active_from = active_from == 0 ? vehicle.flight.time : active_from;
      deepest = std::max(deepest, vehicle.flight.depth);
      EXPECT_STRNE(wordsFor(vehicle.flight.outputs.doing), "hover") << "the next leg comes in time";
    }
  }
  EXPECT_EQ(active_from, 64) << "one cycle after it was ready";
  EXPECT_EQ(vehicle.flight.outputs.state, HookState::Complete);
  EXPECT_GE(witness.accepted(), 14U);
  EXPECT_GE(deepest, 20);
  EXPECT_LE(deepest, 23);
}

TEST(Joined, DamagedLinesNeverGiveAWrongOrDoubledCommand) {
  for (uint32_t seed = 1; seed <= 30; ++seed) {
    const double damage = seed % 3 == 0 ? 0.01 : 0.001;
    Vehicle vehicle(damage, seed);
    Mission mission(1200);
    Witness witness;
    for (int i = 0; i < 1600; ++i) {
      if (i == 1250) {
        vehicle.sbc_line.setDamage(0);
        vehicle.flight_line.setLoss(0);
      }
      vehicle.second(&mission);
      witness.look(vehicle.flight, mission);
      if (testing::Test::HasFatalFailure()) {
        FAIL() << "seed " << seed;
      }
    }
    EXPECT_GE(witness.accepted(), damage > 0.005 ? 1U : 8U) << "seed " << seed;
    EXPECT_TRUE(vehicle.flight.outputs.state == HookState::Complete ||
                vehicle.flight.outputs.state == HookState::Silent)
        << "seed " << seed;
  }
}

TEST(Joined, FramesThatComeAgainNeverGiveAWrongOrDoubledCommand) {
  for (uint32_t seed = 1; seed <= 30; ++seed) {
    Vehicle vehicle(seed % 2 == 0 ? 0.001 : 0, seed);
    vehicle.sbc_line.setReplays(seed % 3 == 2 ? 0 : 0.05);
    vehicle.flight_line.setReplays(seed % 3 == 1 ? 0 : 0.05);
    Mission mission(1200);
    uint32_t cycle = 0;
    mission.watch = [&](const VehicleTick& tick) {
      EXPECT_GT(tick.cycle, cycle) << "seed " << seed << ": no cycle is flown again";
      cycle = tick.cycle;
    };
    Witness witness;
    for (int i = 0; i < 1400; ++i) {
      if (i == 1250) {
        vehicle.sbc_line.setReplays(0);
        vehicle.flight_line.setReplays(0);
      }
      vehicle.second(&mission);
      witness.look(vehicle.flight, mission);
      if (testing::Test::HasFatalFailure()) {
        FAIL() << "seed " << seed;
      }
    }
    EXPECT_GE(witness.accepted(), 10U) << "seed " << seed;
    EXPECT_EQ(vehicle.flight.outputs.state, HookState::Complete) << "seed " << seed;
  }
}

TEST(Joined, ASbcWhoseFramesComeAgainIsSilentInTime) {
  for (uint32_t seed = 1; seed <= 10; ++seed) {
    Vehicle vehicle(0, seed);
    vehicle.flight_line.setReplays(1e-9);  // it remembers
    Mission mission(1e9);
    for (int i = 0; i < 400; ++i) {
      vehicle.second(&mission);
    }
    ASSERT_EQ(vehicle.flight.outputs.state, HookState::Active) << seed;
    vehicle.flight_line.setReplays(0.5);
    for (int i = 0; i < 60; ++i) {
      vehicle.second(nullptr);
    }
    EXPECT_EQ(vehicle.flight.outputs.state, HookState::Silent) << seed;
  }
}

TEST(Joined, OverALateLineInAnyOrderEachInstructionIsObeyedAndControlIsKept) {
  for (uint32_t seed = 1; seed <= 20; ++seed) {
    Vehicle vehicle(0, seed);
    vehicle.flight_line.setLag(0.2, 8);
    Mission mission(1200);
    Witness witness;
    for (int i = 0; i < 1400; ++i) {
      vehicle.second(&mission);
      witness.look(vehicle.flight, mission);
      ASSERT_NE(vehicle.flight.outputs.state, HookState::Silent) << "seed " << seed << ", " << i;
    }
    EXPECT_GE(witness.accepted() + 1, mission.told.size())
        << "seed " << seed << ": the release may replace the last";
    EXPECT_EQ(vehicle.flight.outputs.state, HookState::Complete) << "seed " << seed;
  }
}

TEST(Joined, AValueThatIsLostIsSetAgain) {
  for (uint32_t seed = 1; seed <= 20; ++seed) {
    Vehicle vehicle(0, seed);
    vehicle.flight_line.setLag(0.2, 4);
    vehicle.flight_line.setLoss(0.1);
    Mission mission(1200);
    Witness witness;
    for (int i = 0; i < 1400; ++i) {
      vehicle.second(&mission);
      witness.look(vehicle.flight, mission);
      if (testing::Test::HasFatalFailure()) {
        FAIL() << "seed " << seed;
      }
    }
    EXPECT_GE(witness.accepted(), 10U) << "seed " << seed;
  }
}

TEST(Joined, ALineWithMoreThanACycleOfDelayStillMakesALinkAndFlies) {
  for (const double delay : {2.5, 4.5, 5.5}) {
    Vehicle vehicle(0, 1);
    vehicle.sbc_line.setDelay(delay);
    Mission mission(1200);
    Witness witness;
    for (int i = 0; i < 1400; ++i) {
      vehicle.second(&mission);
      witness.look(vehicle.flight, mission);
    }
    EXPECT_GE(witness.accepted(), 10U) << delay;
    EXPECT_EQ(vehicle.flight.outputs.state, HookState::Complete) << delay;
  }
}

TEST(Joined, WhatTheSbcReadsIsWhatTheVehicleReportedInThatCycle) {
  for (uint32_t seed = 1; seed <= 40; ++seed) {
    const float dead_band = seed % 2 == 0 ? 0.0F : 1.5F;
    Vehicle vehicle(seed % 5 == 0 ? 0 : 0.002, seed);
    uint32_t depths = 0;
    uint32_t ticks = 0;
    const auto check = [&](const VehicleTick& tick) {
      ++ticks;
      ASSERT_TRUE(vehicle.flight.reported.contains(tick.cycle)) << "seed " << seed;
      const auto& report = vehicle.flight.reported.at(tick.cycle);
      for (uint32_t i = 0; i < tick.reading_count; ++i) {
        const bool is_depth = tick.readings[i].id == GLIDER_M_DEPTH;
        depths += is_depth ? 1U : 0U;
        // Of a cycle whose time or number is lost, what has come is reported with the next.
        const auto before = vehicle.flight.reported.find(tick.cycle - 1);
        const auto offFrom = [&](const FlightController::Report& one) {
          return std::abs(tick.readings[i].value - (is_depth ? one.depth : one.latitude));
        };
        const double off = before == vehicle.flight.reported.end() || seed % 5 == 0
                               ? offFrom(report)
                               : std::min(offFrom(report), offFrom(before->second));
        ASSERT_LE(off, is_depth ? dead_band : 0.0F) << "seed " << seed << " cycle " << tick.cycle;
      }
    };
    auto mission = std::make_unique<Mission>(1200, 1, dead_band);
    mission->watch = check;
    for (int i = 0; i < 1300; ++i) {
      if (i % 200 == 199 && seed % 4 == 0) {  // a power cut: it starts again with nothing
        mission = std::make_unique<Mission>(1200, 1, dead_band);
        mission->watch = check;
      }
      vehicle.second(mission.get());
      if (testing::Test::HasFatalFailure()) {
        return;
      }
    }
    EXPECT_GT(ticks, 200U) << "seed " << seed;
    EXPECT_GT(depths, ticks * 9 / 10) << "each is there, changed or not; seed " << seed;
  }
}

TEST(Joined, AKilledSbcIsSilentInTime) {
  for (uint32_t seed = 1; seed <= 12; ++seed) {
    Vehicle vehicle(0, seed);
    Mission mission(5000);
    const int killed = 400 + static_cast<int>(seed) * 7;
    double silent_at = 0;
    for (int i = 0; i < 600; ++i) {
      vehicle.second(i < killed ? &mission : nullptr);
      if (silent_at == 0 && vehicle.flight.outputs.state == HookState::Silent) {
        silent_at = vehicle.flight.time;
        EXPECT_FALSE(vehicle.flight.outputs.commanding);
      }
    }
    // 24 s from the last beat's arrival, which is at most a cycle after the SBC died, and a cycle
    // to notice.
    EXPECT_GT(silent_at, killed);
    EXPECT_LE(silent_at, killed + 24 + 8);
  }
}

TEST(Joined, AStuckMissionIsSilentInTimeThoughItAnswers) {
  Vehicle vehicle(0, 1);
  Mission mission(5000);
  double silent_at = 0;
  for (int i = 0; i < 600; ++i) {
    mission.stuck = i >= 400;
    vehicle.second(&mission);
    if (silent_at == 0 && vehicle.flight.outputs.state == HookState::Silent) {
      silent_at = vehicle.flight.time;
    }
  }
  EXPECT_GT(silent_at, 400);
  EXPECT_LE(silent_at, 400 + 24 + 8);
}

TEST(Joined, CommandsThatNeverArriveEndControlInTimeThoughTheHeartBeats) {
  Vehicle vehicle(0, 1);
  Mission mission(5000);
  Witness witness;
  double lost_from = 0;
  double silent_at = 0;
  for (int i = 0; i < 600; ++i) {
    if (i == 400) {
      vehicle.flight_line.drop({GLIDER_SCI_HOOK_SEQUENCE});  // heartbeats yes, instructions no
    }
    const size_t told = mission.told.size();
    vehicle.second(&mission);
    if (i > 400 && lost_from == 0 && mission.told.size() > told) {
      lost_from = i;
    }
    if (silent_at == 0 && vehicle.flight.outputs.state == HookState::Silent) {
      silent_at = vehicle.flight.time;
    }
  }
  // 6 ticks without an answer, then silence.
  EXPECT_GT(lost_from, 0);
  EXPECT_GT(silent_at, lost_from + 24);
  EXPECT_LE(silent_at, lost_from + 24 + 24 + 8);
}

TEST(Joined, ACutFlightScienceLinkIsSilence) {
  Vehicle vehicle(0, 1);
  Mission mission(5000);
  for (int i = 0; i < 400; ++i) {
    vehicle.second(&mission);
  }
  EXPECT_EQ(vehicle.flight.outputs.state, HookState::Active);
  vehicle.flight_line.setLoss(1);
  for (int i = 0; i < 32; ++i) {
    vehicle.second(&mission);
  }
  EXPECT_EQ(vehicle.flight.outputs.state, HookState::Silent);
}

TEST(Joined, ARestartedSbcTakesControlAgainAfterTheSilence) {
  Vehicle vehicle(0, 1);
  Mission first(5000);
  for (int i = 0; i < 400; ++i) {
    vehicle.second(&first);
  }
  Mission second(800);  // it has forgotten its session numbers
  bool was_silent = false;
  bool active_again = false;
  for (int i = 0; i < 600; ++i) {
    vehicle.second(&second);
    was_silent |= vehicle.flight.outputs.state == HookState::Silent;
    active_again |= was_silent && vehicle.flight.outputs.state == HookState::Active;
  }
  EXPECT_TRUE(was_silent) << "what it does not steer it must not keep alive";
  EXPECT_TRUE(active_again);
  EXPECT_EQ(vehicle.flight.outputs.state, HookState::Complete);
}

TEST(Joined, AFalseBeaconOfAnotherVersionCostsNoControl) {
  for (const bool hello_is_lost : {false, true}) {
    Vehicle vehicle(0, 1);
    vehicle.sbc_line.setDelay(1);
    Mission mission(5000);
    int ticks = 0;
    mission.watch = [&](const VehicleTick&) { ++ticks; };
    for (int i = 0; i < 400; ++i) {
      if (i == 201) {  // what noise has made of some frame, and CRC-16 has not found
        putMessage(vehicle.sbc_line.left(), Beacon{9, {}, 0, HookState::Active}, 77);
      }
      vehicle.sbc_line.setDamage(hello_is_lost && i == 202 ? 1 : 0);
      vehicle.second(&mission);
      EXPECT_NE(vehicle.flight.outputs.state, HookState::Silent) << i;
    }
    EXPECT_EQ(vehicle.flight.outputs.state, HookState::Active);
    EXPECT_GT(ticks, 90);
  }
}

TEST(Joined, WithoutAHookbehTheFlightControllerReceivesNothing) {
  Vehicle vehicle(0, 1, false);
  Mission mission(500);
  for (int i = 0; i < 600; ++i) {
    vehicle.second(&mission);
  }
  EXPECT_EQ(vehicle.flight.received, 0U);
}

}  // namespace
}  // namespace glider::hooks
