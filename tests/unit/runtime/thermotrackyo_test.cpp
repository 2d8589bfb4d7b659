// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/library/library.h"
#include "tests/unit/runtime/bench_mission.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace glider::runtime::testing {
namespace {

struct Water {
  double mean_depth = 14;
  double thickness = 2.5;  ///< d of the tanh, m
  double amplitude = 4;    ///< of the internal wave, m
  double period = 1200;    ///< s
  double phase = 0;        ///< rad

  [[nodiscard]] double isotherm(double t) const {
    return mean_depth + amplitude * std::sin(2 * std::numbers::pi * t / period + phase);
  }
  /// 24 degC over 7 degC; 15.5 at the isotherm.
  [[nodiscard]] double temperature(double t, double depth) const {
    return 15.5 - 8.5 * std::tanh((depth - isotherm(t)) / thickness);
  }
};

struct Flaws {
  double temperature_noise = 0.05;
  double depth_noise = 0.1;
  double lost_share = 0;     ///< of readings that never arrive
  double stale_from = 1e9;   ///< the CTD's water does not change from here…
  double stale_until = 1e9;  ///< …to here
};

struct Score {
  int ticks = 0;
  int contained = 0;
  double widest = 0;
  double detected = -1;  ///< time
  [[nodiscard]] double share() const { return ticks > 0 ? 1.0 * contained / ticks : 0; }
};

/// A point that sinks and rises at 0.17 m/s and needs about 20 s to turn, read every 4 s.
class Loop {
 public:
  Loop(const Water& water, const Flaws& flaws, uint32_t seed)
      : water_(water), flaws_(flaws), random_(seed) {
    bench_.sensors = {depthSensor(), temperatureSensor()};
    bench_.states = {benchState("s2")};
    bench_.fly = [](GliderContext& c, uint32_t phase) {
      gliderProfileThermotrackyo(&c, &c.memory[0], phase, 5, top_bottom, .454, .454, 10, 10);
    };
    bench_.finish(0);
  }

  /// Flies until `end`; scores from the second yo after detection.
  Score fly(double end) {
    Score score;
    context_ = bench_.start(frame());
    for (double t = 4; t <= end; t += 4) {
      move(t);
      step(context_, t, frame());
      note(t, score);
    }
    return score;
  }

  double commanded_top = 5;
  double commanded_bottom = top_bottom;

 private:
  static constexpr double top_bottom = 20;

  void move(double until) {
    for (; time_ < until - 1e-9; time_ += 0.5) {
      const double wanted = context_->vertical == kGliderDescend ? 0.17 : -0.17;
      const double most = 0.34 / 20 * 0.5;  // the whole turn takes 20 s
      speed_ += std::clamp(wanted - speed_, -most, most);
      depth_ = std::max(0.0, depth_ + 0.5 * speed_);
    }
  }

  std::vector<GliderUpdate> frame() {
    std::vector<GliderUpdate> updates;
    const bool flushed = time_ < flaws_.stale_from || time_ >= flaws_.stale_until;
    if (flushed) {
      in_ctd_ = water_.temperature(time_, depth_);
    }
    if (uniform_(random_) >= flaws_.lost_share) {
      updates.push_back(
          update(GLIDER_M_DEPTH, std::max(0.0, depth_ + flaws_.depth_noise * normal_(random_))));
    }
    if (uniform_(random_) >= flaws_.lost_share) {
      updates.push_back(
          update(GLIDER_SCI_WATER_TEMP, in_ctd_ + flaws_.temperature_noise * normal_(random_)));
    }
    return updates;
  }

  void note(double t, Score& score) {
    (context_->vertical == kGliderDescend ? commanded_bottom : commanded_top) = context_->depth;
    const bool narrowed = commanded_top > 5 || commanded_bottom < top_bottom;
    if (narrowed && score.detected < 0) {
      score.detected = t;
    }
    if (score.detected >= 0 && context_->vertical != last_vertical_) {
      ++turns_;
    }
    last_vertical_ = context_->vertical;
    if (turns_ >= 2) {  // the yo in which it was found is over at the second turn
      ++score.ticks;
      const double isotherm = water_.isotherm(t);
      score.contained += commanded_top <= isotherm && isotherm <= commanded_bottom;
      score.widest = std::max(score.widest, commanded_bottom - commanded_top);
    }
  }

  Water water_;
  Flaws flaws_;
  std::mt19937 random_;
  std::normal_distribution<double> normal_{0, 1};
  std::uniform_real_distribution<double> uniform_{0, 1};
  BenchMission bench_;
  GliderContext* context_ = nullptr;
  double time_ = 0;
  double depth_ = 5;
  double speed_ = 0;
  double in_ctd_ = 20;
  uint32_t last_vertical_ = kGliderDescend;
  int turns_ = 0;
};

/// The worst of all phases of the wave, each with another seed; each must have found the
/// thermocline by `latest`.
Score worst(Water water, const Flaws& flaws, double end, double latest = 200) {
  Score least;
  for (int phase = 0; phase < 8; ++phase) {
    water.phase = phase * std::numbers::pi / 4;
    const Score score = Loop(water, flaws, static_cast<uint32_t>(phase)).fly(end);
    EXPECT_GE(score.detected, 0) << "phase " << phase;
    EXPECT_LE(score.detected, latest) << "phase " << phase;
    EXPECT_GT(score.ticks, 150) << "phase " << phase;
    if (phase == 0 || score.share() < least.share()) {
      least.ticks = score.ticks;
      least.contained = score.contained;
    }
    least.widest = std::max(least.widest, score.widest);
  }
  return least;
}

TEST(Thermotrackyo, KeepsTheIsothermInsideANarrowRange) {
  for (const double amplitude : {0.0, 3.0, 4.0, 5.0}) {
    for (const double thickness : {2.0, 2.5, 3.0}) {
      const Score score = worst({.thickness = thickness, .amplitude = amplitude}, {}, 1200);
      const auto at = ::testing::Message() << "amplitude " << amplitude << " d " << thickness;
      EXPECT_GE(score.share(), 0.98) << at;
      EXPECT_LE(score.widest, 12.0) << at;
    }
  }
}

TEST(Thermotrackyo, CopesWithNoiseAndLostReadings) {
  const Score noisy = worst({}, {.temperature_noise = 0.5, .depth_noise = 0.3}, 1200);
  EXPECT_GE(noisy.share(), 0.95);
  EXPECT_LE(noisy.widest, 12.0);
  // Where the depth is unknown for 20 s the glider turns up, and has to dive once more.
  const Score gappy = worst({}, {.lost_share = 0.3}, 1200, 260);
  EXPECT_GE(gappy.share(), 0.95);
  EXPECT_LE(gappy.widest, 12.5);
}

TEST(Thermotrackyo, OneLegOfStaleWaterInTheCtdLosesNothingForGood) {
  for (const double from : {400.0, 430.0, 460.0, 490.0}) {
    const Flaws flaws{.stale_from = from, .stale_until = from + 90};
    const Score score = worst({.amplitude = 3}, flaws, 1200);
    EXPECT_GE(score.share(), 0.9) << "from " << from;
    EXPECT_LE(score.widest, 15.0) << "from " << from;
  }
}

TEST(Thermotrackyo, SearchesTheFullRangeAgainWhenTheThermoclineIsGone) {
  Loop loop({.amplitude = 0}, {}, 1);
  loop.fly(600);
  EXPECT_LE(loop.commanded_bottom - loop.commanded_top, 10);
  Loop mixed({.amplitude = 0}, {.stale_from = 600, .stale_until = 1e9}, 1);
  mixed.fly(1200);
  EXPECT_EQ(mixed.commanded_top, 5);
  EXPECT_EQ(mixed.commanded_bottom, 20);
}

TEST(Thermotrackyo, IsAYoWhereThereIsNoThermocline) {
  Loop loop({.mean_depth = 1000}, {}, 1);
  const Score score = loop.fly(1200);
  EXPECT_LT(score.detected, 0);
  EXPECT_EQ(loop.commanded_top, 5);
  EXPECT_EQ(loop.commanded_bottom, 20);
}

TEST(Yo, TurnsAtItsDepthsClimbsWhenDepthIsUnknownAndFollowsLiveArguments) {
  BenchMission bench;
  double bottom = 10;
  bench.sensors = {depthSensor()};
  bench.states = {benchState("a")};
  bench.fly = [&](GliderContext& c, uint32_t phase) {
    gliderProfileYo(&c, &c.memory[0], phase, 5, bottom, .454, .3);
  };
  bench.finish(0);
  GliderContext* c = bench.start({update(GLIDER_M_DEPTH, 7)});
  auto at = [&](double t, double depth) {
    step(c, t, {update(GLIDER_M_DEPTH, depth)});
    return c->vertical;
  };
  EXPECT_EQ(c->vertical, static_cast<uint32_t>(kGliderDescend));
  EXPECT_EQ(at(4, 9.9), static_cast<uint32_t>(kGliderDescend));
  EXPECT_EQ(at(8, 10), static_cast<uint32_t>(kGliderAscend));
  EXPECT_EQ(c->depth, 5);
  EXPECT_EQ(c->pitch, .3);
  EXPECT_EQ(at(12, 7), static_cast<uint32_t>(kGliderAscend));
  EXPECT_EQ(at(16, 5), static_cast<uint32_t>(kGliderDescend));
  bottom = 12;
  EXPECT_EQ(at(20, 8), static_cast<uint32_t>(kGliderDescend));
  EXPECT_EQ(c->depth, 12) << "a change of the argument reaches the command";
  step(c, 60);
  EXPECT_EQ(c->vertical, static_cast<uint32_t>(kGliderAscend)) << "depth is unknown";
  EXPECT_EQ(at(64, 8), static_cast<uint32_t>(kGliderAscend)) << "until the top is reached";
  bottom = std::nan("");
  EXPECT_EQ(at(68, 5), static_cast<uint32_t>(kGliderAscend)) << "an unknown target changes nothing";
  EXPECT_EQ(c->refused_commands, 1U);
}

}  // namespace
}  // namespace glider::runtime::testing
