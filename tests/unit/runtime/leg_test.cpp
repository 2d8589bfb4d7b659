// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Windows over a dive or climb: what they give, and that the runtime's sums are the readings.

#include "runtime/abi/leg.h"

#include "ir/eval/leg_window.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace glider::runtime::testing::legs {
namespace {

using ir::Leg;
using ir::PlainLegs;
using ir::Temporal;
using ir::TemporalKind;

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr double kSurface = 0, kDive = 1, kClimb = 2, kHover = 3;

constexpr std::pair<TemporalKind, GliderLegKind> kKinds[] = {
    {TemporalKind::Mean, kGliderLegMean},         {TemporalKind::Lowest, kGliderLegLowest},
    {TemporalKind::Highest, kGliderLegHighest},   {TemporalKind::Spread, kGliderLegSpread},
    {TemporalKind::AtLowest, kGliderLegAtLowest}, {TemporalKind::AtHighest, kGliderLegAtHighest},
    {TemporalKind::Steepest, kGliderLegSteepest}, {TemporalKind::AtSteepest, kGliderLegAtSteepest},
    {TemporalKind::Number, kGliderLegNumber}};

/// The functions of the runtime for windows of one kind.
struct Functions {
  explicit Functions(GliderLegKind kind)
      : steepest(kind == kGliderLegSteepest || kind == kGliderLegAtSteepest),
        memory(steepest ? GLIDER_STEEPEST_MEMORY : GLIDER_LEG_MEMORY),
        start(steepest ? gliderSteepestStart : gliderLegStart),
        advance(steepest ? gliderSteepestAdvance : gliderLegAdvance) {}

  bool steepest;
  size_t memory;
  decltype(&gliderLegStart) start;
  decltype(&gliderLegAdvance) advance;
};

/// A window of the runtime, in ticks of 4 s; starts at 100 s in the state `phase`.
class Window {
 public:
  explicit Window(GliderLegKind kind, Leg leg = Leg::This, double dive = kDive,
                  double climb = kClimb)
      : functions_(kind), shape_{dive, climb, kind, leg == Leg::Last ? 1U : 0U} {
    functions_.start(memory_.data(), time_);
  }
  double tick(double phase, double value, double at = 0, bool fresh = true) {
    functions_.advance(memory_.data(), &shape_, time_, phase, value, at, fresh ? 1 : 0);
    time_ += 4;
    return memory_[0];
  }
  /// A tick for each value; the last result.
  double ticks(double phase, const std::vector<double>& values) {
    double result = kNothing;
    for (const double value : values) {
      result = tick(phase, value, 10 * value);
    }
    return result;
  }
  void wait(double seconds) { time_ += seconds; }

 private:
  Functions functions_;
  GliderLegShape shape_;
  std::vector<double> memory_ = std::vector<double>(functions_.memory, -7.0);
  double time_ = 100;
};

TEST(Legs, OfEachKind) {
  const double ofThis[] = {4, 1, 9, 8, 10, 90, 0.1, 55, 2};
  const double ofLast[] = {5, 2, 8, 6, 20, 80, 0.1, 65, 2};
  for (size_t i = 0; i < std::size(kKinds); ++i) {
    for (const Leg leg : {Leg::This, Leg::Last}) {
      Window window(kKinds[i].second, leg);
      EXPECT_TRUE(std::isnan(window.tick(kSurface, 100))) << "the tick of the start";
      window.ticks(kDive, {5, 8, 2});
      EXPECT_EQ(window.ticks(kClimb, {2, 9, 1}), leg == Leg::This ? ofThis[i] : ofLast[i])
          << i << (leg == Leg::This ? " this" : " last");
    }
  }
}

TEST(Legs, OnlyWholeLegsAreLast) {
  for (const bool under_way : {true, false}) {
    Window window(kGliderLegMean, Leg::Last);
    window.ticks(under_way ? kDive : kSurface, {1});
    window.ticks(kDive, {3, 5});
    EXPECT_EQ(std::isnan(window.ticks(kClimb, {7, 9})), under_way);
    EXPECT_EQ(window.ticks(kDive, {1}), 8);
  }
  Window called(kGliderLegMean, Leg::Last);
  called.ticks(kSurface, {0});
  called.ticks(kDive, {3, 5});
  called.wait(57);  // with the tick, 61 s
  called.ticks(kDive, {3});
  EXPECT_TRUE(std::isnan(called.ticks(kClimb, {7})));
  called.ticks(kDive, {3});
  called.wait(56);
  called.ticks(kDive, {5});
  EXPECT_EQ(called.ticks(kClimb, {7}), 4);
}

/// In a call or a power cut, legs come and go: the one before is another.
TEST(Legs, NoneIsKnownAfterAGap) {
  for (const double seconds : {56, 57}) {  // with the tick, 60 s and 61 s
    for (const double after : {kDive, kClimb, kHover}) {
      const bool gap = seconds > 56;
      Window last(kGliderLegHighest, Leg::Last);
      Window present(kGliderLegHighest, Leg::This);
      Window dives(kGliderLegHighest, Leg::Last, kDive, kDive);
      for (Window* window : {&last, &present, &dives}) {
        window->ticks(kSurface, {1});
        window->ticks(kDive, {2, 3});
        window->ticks(kClimb, {5, 4});
        window->ticks(kDive, {7, 6});
        window->ticks(kClimb, {9, 8});
        window->wait(seconds);
      }
      SCOPED_TRACE(::testing::Message() << seconds << " s, then in the state " << after);
      EXPECT_EQ(std::isnan(last.tick(after, 1)), gap);
      EXPECT_EQ(std::isnan(dives.tick(after, kNothing)), gap);
      EXPECT_EQ(std::isnan(present.tick(after, kNothing)), gap || after == kDive);
      // A leg of which the beginning was not watched is not the last one either.
      EXPECT_EQ(std::isnan(last.ticks(after == kDive ? kClimb : kDive, {5})), gap);
      EXPECT_FALSE(std::isnan(last.ticks(after == kDive ? kDive : kClimb, {5})));
    }
  }
}

TEST(Legs, BetweenTwoLegsThePresentOneIsTheOneBefore) {
  Window dives(kGliderLegHighest, Leg::This, kDive, kDive);
  Window last(kGliderLegHighest, Leg::Last, kDive, kDive);
  for (Window* window : {&dives, &last}) {
    window->ticks(kSurface, {9});
    window->ticks(kDive, {3, 5});
    window->ticks(kClimb, {7});
    window->ticks(kHover, {8});
  }
  EXPECT_EQ(dives.ticks(kClimb, {8}), 5);
  EXPECT_TRUE(std::isnan(last.ticks(kClimb, {8})));
  EXPECT_EQ(dives.ticks(kDive, {4}), 4);
  EXPECT_EQ(last.ticks(kDive, {4}), 5);
}

TEST(Legs, TheNumberCountsBeginnings) {
  for (const double first : {kSurface, kDive, kNothing}) {
    Window window(kGliderLegNumber, Leg::This, kDive, kDive);
    window.tick(first, 0);
    const double begun = first == kSurface ? 1 : 0;
    EXPECT_EQ(window.ticks(kDive, {1, 1, 1}), begun) << "under way, or not known to begin";
    EXPECT_EQ(window.ticks(kClimb, {1}), begun);
    EXPECT_EQ(window.ticks(kDive, {kNothing}), begun + 1);
    EXPECT_TRUE(std::isnan(window.tick(kNothing, 1)));
    EXPECT_EQ(window.ticks(kDive, {1}), begun + 1);
  }
}

TEST(Legs, UnknownAndOldReadingsAreLeftOut) {
  Window window(kGliderLegMean);
  window.tick(kSurface, 0);
  EXPECT_TRUE(std::isnan(window.tick(kDive, kNothing)));
  EXPECT_TRUE(std::isnan(window.tick(kDive, 5, 0, false)));
  EXPECT_TRUE(std::isnan(window.tick(kDive, 5, kNothing)));
  EXPECT_EQ(window.tick(kDive, 5), 5);
  EXPECT_TRUE(std::isnan(window.tick(kNothing, 7)));
  EXPECT_EQ(window.tick(kDive, 7), 6);
}

TEST(Legs, AMeanIsWithinItsReadings) {
  Window window(kGliderLegMean);
  window.tick(kSurface, 0);
  for (int i = 0; i < 2000; ++i) {
    EXPECT_EQ(window.tick(kDive, 0.1), 0.1);
  }
}

/// The steepest slope of readings at depths, and its depth, over the dive under way or ended.
class Profile {
 public:
  explicit Profile(double phase = kDive) : phase_(phase) {
    slope_.tick(kSurface, 0);
    depth_.tick(kSurface, 0);
  }
  void reading(double value, double at) { tick(phase_, value, at); }
  void hover() { tick(kHover, 0, 0); }
  [[nodiscard]] double slope() const { return found_.first; }
  [[nodiscard]] double depth() const { return found_.second; }

 private:
  void tick(double phase, double value, double at) {
    found_ = {slope_.tick(phase, value, at), depth_.tick(phase, value, at)};
  }

  double phase_;
  Window slope_{kGliderLegSteepest};
  Window depth_{kGliderLegAtSteepest};
  std::pair<double, double> found_{kNothing, kNothing};
};

/// Compared with the slope of the water itself, which is steepest at 30 m: -1.25 degC/m there, and
/// from 28 m to 32 m never less steep than -0.98 degC/m.
TEST(SteepestOfALeg, IsThatOfAThermoclineDespiteNoise) {
  std::mt19937 random(5);
  std::normal_distribution<double> temperature_noise(0, 0.02);
  std::uniform_real_distribution<double> depth_noise(-0.1, 0.1);
  for (int flight = 0; flight < 100; ++flight) {
    const bool down = flight % 2 == 0;
    Profile profile(down ? kDive : kClimb);
    const double step = std::uniform_real_distribution(0.3, 0.9)(random);  // a tick's, m
    for (double way = 0; way < 60; way += step) {
      const double depth = down ? way : 60 - way;
      profile.reading(20 - 5 * std::tanh((depth - 30) / 4) + temperature_noise(random),
                      depth + depth_noise(random));
    }
    EXPECT_LT(profile.slope(), -0.95) << flight;
    EXPECT_GT(profile.slope(), -1.4) << flight;
    EXPECT_NEAR(profile.depth(), 30, 2.1) << flight;
  }
}

/// A vehicle that stays at a depth, or goes back over the edge of a layer, measures how the water
/// changes with time: that is not a slope.
TEST(SteepestOfALeg, RepeatedDepthsHaveNoSlope) {
  Profile still;
  for (int i = 0; i < 100; ++i) {
    still.reading(20 - 0.1 * i, 10 + 0.9 * (i % 2));
  }
  EXPECT_TRUE(std::isnan(still.slope()));
  Profile edge;
  for (const double depth : {10.0, 10.9, 11.9, 12.0, 11.9, 10.1, 10.2}) {
    edge.reading(depth < 12 ? 20 : 15, depth);
  }
  edge.hover();
  EXPECT_TRUE(std::isnan(edge.slope())) << "the layers' means are less than 1 m apart";
}

TEST(SteepestOfALeg, TheLastLayerCountsWhenTheLegIsOver) {
  Profile profile;
  for (const double depth : {0, 1, 2, 3}) {
    profile.reading(20 - depth, depth);
  }
  EXPECT_TRUE(std::isnan(profile.slope())) << "one complete layer";
  profile.reading(9, 4);
  EXPECT_EQ(profile.slope(), -1);
  EXPECT_EQ(profile.depth(), 1.5);
  profile.hover();
  EXPECT_EQ(profile.slope(), (9 - 17.5) / 1.5);
  EXPECT_EQ(profile.depth(), 3.25);
}

TEST(SteepestOfALeg, TheFirstOfTwoCounts) {
  for (const double sign : {-1, 1}) {
    Profile profile;
    for (int layer = 0; layer < 5; ++layer) {
      profile.reading(sign * (layer % 2), 3.0 * layer);
    }
    EXPECT_EQ(profile.slope(), sign / 3);
    EXPECT_EQ(profile.depth(), 1.5);
  }
}

/// A slope beyond all numbers is none.
TEST(SteepestOfALeg, WhatOverflowsIsLeftOut) {
  Profile profile;
  const std::pair<double, double> readings[] = {{2, 0}, {5, 3}, {-1.7e308, 6}, {1.7e308, 9}};
  for (const auto& [value, at] : readings) {
    profile.reading(value, at);
  }
  profile.hover();
  EXPECT_EQ(profile.slope(), -1.7e308 / 3);
  EXPECT_EQ(profile.depth(), 4.5);
}

/// The runtime's sums and the interpreter's readings give the same bits.
TEST(Legs, AreWhatTheirReadingsSay) {
  std::mt19937 random(7);
  const auto chance = [&](double p) { return std::bernoulli_distribution(p)(random); };
  size_t known = 0;
  for (size_t flight = 0; flight < 400; ++flight) {
    const auto& [kind, abi] = kKinds[flight % std::size(kKinds)];
    Temporal temporal;
    temporal.kind = kind;
    temporal.leg = chance(0.5) ? Leg::This : Leg::Last;
    temporal.dive = chance(0.7) ? kDive : kClimb;
    temporal.climb = chance(0.7) ? kClimb : temporal.dive;
    const GliderLegShape shape{temporal.dive, temporal.climb, abi,
                               temporal.leg == Leg::Last ? 1U : 0U};
    PlainLegs plain(temporal);
    const Functions functions(abi);
    std::vector<double> memory(functions.memory, -7.0);
    double time = 0;
    double phase = kSurface;
    for (int tick = 0; tick < 300; ++tick) {
      if (tick == 0 || chance(0.005)) {
        plain.start(time);
        functions.start(memory.data(), time);
      }
      phase = chance(0.1) ? std::uniform_int_distribution(0, 3)(random) : phase;
      const double seen = chance(0.05) ? kNothing : phase;
      const double value =
          chance(0.1) ? kNothing : std::uniform_real_distribution(-3.0, 3.0)(random);
      const double at = chance(0.1) ? kNothing : std::uniform_real_distribution(0.0, 9.0)(random);
      const bool fresh = chance(0.9);
      plain.advance(time, seen, value, at, fresh);
      functions.advance(memory.data(), &shape, time, seen, value, at, fresh ? 1 : 0);
      ASSERT_EQ(std::bit_cast<uint64_t>(plain.value()), std::bit_cast<uint64_t>(memory[0]))
          << flight << " " << tick << " " << plain.value() << " " << memory[0];
      known += std::isnan(memory[0]) ? 0U : 1U;
      time += chance(0.02) ? 70 : chance(0.05) ? 0 : 4;
    }
  }
  EXPECT_GT(known, 20000U);
}

}  // namespace
}  // namespace glider::runtime::testing::legs
