// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A nap only delays: the SBC sees every control cycle as it would have seen it in time. Two
// vehicles with the same values, one whose SBC sleeps, are compared tick by tick.

#include "hooks/protocol/bytes.h"
#include "tests/unit/hooks/nap_bench.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <string>

namespace glider::hooks {
namespace {

using Kind = SeatEvent::Kind;

// An emulated 68332 is there for the order of bytes, not for rare cases.
#ifdef __m68k__
constexpr uint32_t kSeeds = 1;
#else
constexpr uint32_t kSeeds = 8;
#endif

/// In all but the mark of a Tick that was kept.
void expectSame(const VehicleTick& one, const VehicleTick& other) {
  const std::string where = "cycle " + std::to_string(one.cycle);
  EXPECT_EQ(one.vehicle_time_s, other.vehicle_time_s) << where;
  EXPECT_EQ(one.hook_state, other.hook_state) << where;
  EXPECT_EQ(one.answer, other.answer) << where;
  EXPECT_EQ(one.answered_sequence, other.answered_sequence) << where;
  EXPECT_EQ(one.session, other.session) << where;
  EXPECT_EQ(one.obeys_us, other.obeys_us) << where;
  EXPECT_EQ(one.instruction_sequence, other.instruction_sequence) << where;
  ASSERT_EQ(one.reading_count, other.reading_count) << where;
  for (uint32_t i = 0; i < one.reading_count; ++i) {
    EXPECT_EQ(one.readings[i].id, other.readings[i].id) << where;
    EXPECT_EQ(bitsOf(one.readings[i].value), bitsOf(other.readings[i].value))
        << where << " sensor " << one.readings[i].id;
  }
}

/// Each cycle of `late` is one of `ever`, in order, and the same; returns how many are missing.
size_t compare(const std::vector<VehicleTick>& late, const std::vector<VehicleTick>& ever) {
  size_t at = 0, missing = 0;
  for (const VehicleTick& tick : late) {
    while (at < ever.size() && ever[at].cycle != tick.cycle) {
      ++at;
      ++missing;
    }
    if (at == ever.size()) {
      ADD_FAILURE() << "cycle " << tick.cycle << " is out of order";
      return missing;
    }
    expectSame(tick, ever[at]);
    ++at;
  }
  return missing + ever.size() - at;
}

struct Way {
  const char* name;
  std::vector<Subscription> sensors;
};

std::vector<Way> ways() {
  const auto with = [](uint8_t every, float dead_band) {
    std::vector<Subscription> sensors;
    for (const uint16_t id : {GLIDER_M_DEPTH, GLIDER_M_LAT, GLIDER_SCI_WATER_TEMP, GLIDER_M_BATTERY,
                              GLIDER_M_PITCH, GLIDER_SCI_WATER_PRESSURE, GLIDER_X_DR_STATE}) {
      sensors.push_back({id, every, dead_band});
    }
    return sensors;
  };
  std::vector<Subscription> mixed = with(1, 0);
  for (size_t i = 0; i < mixed.size(); ++i) {
    mixed[i].every = static_cast<uint8_t>(1 + 3 * i);
    mixed[i].dead_band = i % 2 == 0 ? 0.25F : 0.0F;
  }
  return {{"every report", with(1, 0)},
          {"at most every third cycle", with(3, 0)},
          {"with a dead band", with(1, 0.35F)},
          {"both", with(2, 0.35F)},
          {"mixed", mixed},
          {"none", {}}};
}

/// Naps of random lengths, with random conditions.
void mayNap(NapBench& bench, uint32_t seed) {
  bench.order = [random = std::mt19937(seed)](const VehicleTick& tick) mutable {
    Nap nap{static_cast<uint8_t>(random() % 12), static_cast<uint16_t>(8 + random() % 300), 0, {}};
    if (random() % 2 == 0) {
      nap.count = 1;
      nap.conditions[0] = {GLIDER_M_DEPTH, NapKind::AtLeast, 13.85};
    }
    return tick.kept || random() % 3 == 0 ? std::nullopt : std::optional(nap);
  };
}

TEST(NapBuffer, TheSbcSeesEachCycleAsItWouldHaveSeenItInTime) {
  for (const Way& way : ways()) {
    for (uint32_t seed = 1; seed <= kSeeds; ++seed) {
      SCOPED_TRACE(std::string(way.name) + ", seed " + std::to_string(seed));
      NapBench awake(way.sensors, seed), asleep(way.sensors, seed);
      awake.begin();
      asleep.begin();
      if (!way.sensors.empty()) {
        mayNap(asleep, seed);
      }
      awake.seconds(3000);
      asleep.seconds(3000);
      asleep.order = nullptr;
      awake.seconds(400);
      asleep.seconds(400);
      EXPECT_EQ(compare(asleep.ticks, awake.ticks), 0U);
      EXPECT_GT(awake.ticks.size(), 800U);
      EXPECT_TRUE(way.sensors.empty() || asleep.count(Kind::SbcNap) > 5);
      EXPECT_EQ(asleep.count(Kind::SbcNap), asleep.count(Kind::SbcWoken));
      EXPECT_EQ(asleep.count(Kind::SbcLost), 0U);
    }
  }
}

/// Without a dead band, what was lost is missing with its cycle only; the values that come are
/// right.
TEST(NapBuffer, AKeptTickThatIsLostOnTheLineLeavesNoWrongValue) {
  for (uint32_t seed = 1; seed <= 2 * kSeeds; ++seed) {
    const std::vector<Subscription> sensors = ways()[0].sensors;
    NapBench awake(sensors, seed), asleep(sensors, seed);
    awake.begin();
    asleep.begin();
    mayNap(asleep, seed);
    uint32_t lost = 0;
    asleep.loses = [&lost, random = std::mt19937(seed)](const Frame& frame) mutable {
      TickHead head;
      const bool loses = decode(frame, head) && head.kept && random() % 4 == 0;
      lost += loses ? 1 : 0;
      return loses;
    };
    awake.seconds(2000);
    asleep.seconds(2000);
    asleep.order = nullptr;
    awake.seconds(400);
    asleep.seconds(400);
    EXPECT_EQ(compare(asleep.ticks, awake.ticks), lost) << seed;
    EXPECT_GT(lost, 5U);
  }
}

/// The vehicle believes that the SBC holds what it has confirmed, and no more: a whole nap's Ticks
/// may be lost.
TEST(NapBuffer, WhenAllThatWasKeptIsLostTheNextTickMakesUpForIt) {
  const std::vector<Subscription> sensors = ways()[0].sensors;
  NapBench awake(sensors, 3), asleep(sensors, 3);
  awake.begin();
  asleep.begin();
  asleep.share = awake.share = 1;
  asleep.loses = [](const Frame& frame) {
    TickHead head;
    return decode(frame, head) && head.kept;
  };
  asleep.sleep({0, 200, 0, {}});
  const double until = asleep.now + 260;
  asleep.seconds(260);
  awake.seconds(static_cast<int>(until - awake.now));
  EXPECT_GT(compare(asleep.ticks, awake.ticks), 40U);
}

std::vector<Subscription> sixtyFour() {
  std::vector<Subscription> sensors;
  for (uint16_t id = 0; id < GLIDER_SENSOR_COUNT && sensors.size() < kMostSubscriptions; ++id) {
    if (sensorWidth(id) == 8 && !isScienceSensor(id) && id != GLIDER_M_PRESENT_TIME) {
      sensors.push_back({id});
    }
  }
  for (uint32_t i = 0; sensors.size() < kMostSubscriptions; ++i) {
    sensors.push_back({sensors[i].id});
  }
  return sensors;
}

TEST(NapBuffer, WithTheGreatestTicksTheSbcIsWokenInTimeAndNoneIsLost) {
  NapBench awake(sixtyFour()), asleep(sixtyFour());
  awake.share = asleep.share = 1;
  awake.begin();
  asleep.begin();
  asleep.wake_s = 40;
  asleep.sleep({40, 3000, 0, {}});
  ASSERT_FALSE(asleep.hookprog.wantsSbc());
  const double until = asleep.now + 600;
  asleep.seconds(600);
  awake.seconds(static_cast<int>(until - awake.now));
  EXPECT_EQ(static_cast<NapEnd>(asleep.newest(Kind::SbcWoken).a), NapEnd::Full);
  // 29 of 556 bytes fit; 4 and the 10 of the waking are spared.
  EXPECT_EQ(asleep.newest(Kind::SbcWoken).b, 16U);
  EXPECT_EQ(asleep.deaf, 0U);
  EXPECT_EQ(compare(asleep.ticks, awake.ticks), 0U);
}

TEST(NapBuffer, ANapWithoutRoomForItsWakingEndsAtOnce) {
  NapBench bench(sixtyFour());
  bench.share = 1;
  bench.begin();
  bench.sleep({255, 3000, 0, {}});
  bench.seconds(6);
  EXPECT_TRUE(bench.hookprog.wantsSbc());
  EXPECT_EQ(static_cast<NapEnd>(bench.newest(Kind::SbcWoken).a), NapEnd::Full);
}

/// Of small Ticks no more are kept than have numbers of their own.
TEST(NapBuffer, TheNumbersOfKeptTicksAreAllDifferent) {
  NapBench bench(std::vector<Subscription>{{GLIDER_M_DEPTH}});
  bench.begin();
  bench.sleep({0, 3600, 0, {}});
  ASSERT_FALSE(bench.hookprog.wantsSbc());
  bench.seconds(1200);
  EXPECT_EQ(static_cast<NapEnd>(bench.newest(Kind::SbcWoken).a), NapEnd::Full);
  EXPECT_EQ(bench.newest(Kind::SbcWoken).b, 237U);
}

/// The line takes 64 frames a second, and the queue before it 2048 bytes.
TEST(NapBuffer, ALongNapComesInPartsAndInOrder) {
  NapBench bench(std::vector<Subscription>{{GLIDER_M_DEPTH}});
  bench.begin();
  bench.sleep({0, 900, 0, {}});
  for (int i = 0; i < 1000 && !bench.hookprog.wantsSbc(); ++i) {
    bench.sent.clear();
    bench.second();
  }
  EXPECT_GE(bench.sent.size(), 60U);
  EXPECT_LE(bench.sent.size(), 64U);
  bench.seconds(8);
  for (size_t i = 1; i < bench.ticks.size(); ++i) {
    EXPECT_EQ(bench.ticks[i].cycle, bench.ticks[i - 1].cycle + 1);
  }
  EXPECT_FALSE(bench.ticks.back().kept);
}

}  // namespace
}  // namespace glider::hooks
