// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/library/library.h"
#include "tests/unit/runtime/bench_mission.h"

#include <gtest/gtest.h>

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
  double stale_from = 1e9;   ///< the CTD's water stands still from here…
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
    bench_.states = {{"s2", nullptr, nullptr, 0, 0}};
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

  double order_top = 5;
  double order_bottom = top_bottom;

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
    (context_->vertical == kGliderDescend ? order_bottom : order_top) = context_->depth;
    const bool narrowed = order_top > 5 || order_bottom < top_bottom;
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
      score.contained += order_top <= isotherm && isotherm <= order_bottom;
      score.widest = std::max(score.widest, order_bottom - order_top);
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

TEST(Thermotrackyo, KeepsTheIsothermInsideANarrowRange) {
  for (const double amplitude : {0.0, 3.0, 4.0, 5.0}) {
    for (const double thickness : {2.0, 2.5, 3.0}) {
      for (int phase = 0; phase < 8; ++phase) {
        const Water water{14, thickness, amplitude, 1200, phase * std::numbers::pi / 4};
        const Score score = Loop(water, {}, static_cast<uint32_t>(phase)).fly(1200);
        const auto at = ::testing::Message()
                        << "amplitude " << amplitude << " d " << thickness << " phase " << phase
                        << " detected " << score.detected << " share " << score.share()
                        << " widest " << score.widest;
        EXPECT_GE(score.detected, 0) << at;
        EXPECT_LE(score.detected, 250) << at;
        EXPECT_GT(score.ticks, 150) << at;
        EXPECT_GE(score.share(), 0.9) << at;
        EXPECT_LE(score.widest, 12.0) << at;
      }
    }
  }
}

}  // namespace
}  // namespace glider::runtime::testing
