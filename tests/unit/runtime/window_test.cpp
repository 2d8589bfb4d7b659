// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/eval/window.h"

#include "ir/eval/arithmetic.h"
#include "runtime/abi/window.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>
#include <vector>

namespace {

using glider::ir::ExprId;
using glider::ir::PlainWindow;
using glider::ir::Temporal;
using glider::ir::TemporalKind;
using glider::ir::WindowShape;
using glider::ir::windowShape;

/// The runtime's ring.
class Ring {
 public:
  explicit Ring(const WindowShape& shape)
      : shape_{shape.length,
               shape.bin,
               shape.bins,
               static_cast<uint32_t>(shape.kind) - static_cast<uint32_t>(TemporalKind::Mean),
               shape.stretch ? 1U : 0U,
               0},
        memory_(GLIDER_WINDOW_HEADER + size_t{GLIDER_WINDOW_SLOT} * shape.bins, -7.0) {}
  void start(double time) { gliderWindowStart(memory_.data(), &shape_, time); }
  double advance(double time, double along, double value, bool fresh) {
    gliderWindowAdvance(memory_.data(), &shape_, time, along, value, fresh ? 1 : 0);
    return memory_[0];
  }

 private:
  GliderWindowShape shape_;
  std::vector<double> memory_;
};

WindowShape over(TemporalKind kind, double length, bool stretch) {
  Temporal temporal;
  temporal.kind = kind;
  temporal.length = length;
  temporal.along = stretch ? ExprId{0} : ExprId{};
  return windowShape(temporal);
}

const TemporalKind kKinds[] = {TemporalKind::Mean, TemporalKind::Lowest, TemporalKind::Highest,
                               TemporalKind::Spread, TemporalKind::Slope};

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

TEST(Window, OverATimeIsUnknownUntilCovered) {
  Ring ring(over(TemporalKind::Mean, 12, false));
  ring.start(100);
  EXPECT_TRUE(std::isnan(ring.advance(100, 100, 1, true)));
  EXPECT_TRUE(std::isnan(ring.advance(104, 104, 2, true)));
  EXPECT_TRUE(std::isnan(ring.advance(108, 108, 3, true)));
  EXPECT_EQ(ring.advance(112, 112, 4, true), 2.5);
  EXPECT_EQ(ring.advance(116, 116, 5, true), 3.5);  // the first has left
  EXPECT_EQ(ring.advance(120, 120, kNothing, true), 4);
  EXPECT_TRUE(std::isnan(ring.advance(160, 160, kNothing, true)));
}

TEST(Window, OfEachKind) {
  for (const TemporalKind kind : kKinds) {
    Ring ring(over(kind, 8, false));
    ring.start(0);
    ring.advance(0, 0, 3, true);
    ring.advance(4, 4, 1, true);
    const double value = ring.advance(8, 8, 11, true);
    const double expected[] = {5, 1, 11, 10, 1};
    EXPECT_EQ(value, expected[static_cast<size_t>(kind) - static_cast<size_t>(kKinds[0])]);
  }
}

TEST(Window, OverAStretchIsKnownOnceTheLengthWasSeen) {
  Ring ring(over(TemporalKind::Spread, 10, true));
  ring.start(0);
  for (int depth = 0; depth < 10; ++depth) {
    EXPECT_TRUE(std::isnan(ring.advance(4.0 * depth, depth, 20 - depth, true)));
  }
  EXPECT_EQ(ring.advance(40, 10, 10, true), 10);
  EXPECT_EQ(ring.advance(44, 12, 8, true), 10);  // 2 m to 12 m
}

TEST(Window, OverAStretchForgetsAfterHalfAnHour) {
  Ring ring(over(TemporalKind::Highest, 10, true));
  ring.start(0);
  ring.advance(0, 0, 9, true);
  ring.advance(4, 10, 5, true);
  EXPECT_EQ(ring.advance(1800, 9, 4, true), 9);
  EXPECT_EQ(ring.advance(1804, 9, 4, true), 5);
}

TEST(Window, OverAStretchForgetsWhatWasPassedSince) {
  Ring ring(over(TemporalKind::Highest, 10, true));
  ring.start(0);
  ring.advance(0, 0, 1, true);
  ring.advance(4, 5.1, 9, true);
  EXPECT_EQ(ring.advance(8, 10, 2, true), 9);
  EXPECT_EQ(ring.advance(12, 6, 3, true), 9) << "it lies ahead";
  EXPECT_EQ(ring.advance(16, 4, 1, true), 3) << "between these two readings";
}

TEST(Window, HoveringNeedsNoMemory) {
  const WindowShape shape = over(TemporalKind::Slope, 10, true);
  EXPECT_LE(shape.bins, 66U);
  EXPECT_LE(over(TemporalKind::Mean, 1e6, false).bins, 258U);
  EXPECT_GE(over(TemporalKind::Mean, 0.001, false).bins, 2U);
}

/// Noisy, late, repeated, hovering, jumping and unknown readings.
void compare(uint32_t seed) {
  std::mt19937 random(seed);
  auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  const bool stretch = random() % 2 == 0;
  const WindowShape shape =
      over(kKinds[random() % std::size(kKinds)], std::exp(uniform(-1, 6)), stretch);
  Ring ring(shape);
  PlainWindow plain(shape);
  double time = uniform(0, 1e6);
  // In half of them near a bin whose number needs one bit more than 16 or 32.
  const double edges[] = {0, 0, 0, 0, 0x1p16, -0x1p16, 0x1p32, -0x1p32};
  double along = uniform(-50, 200) + edges[random() % std::size(edges)] * shape.bin;
  double speed = 1;
  ring.start(time);
  plain.start(time);
  for (int i = 0; i < 400; ++i) {
    time += random() % 8 == 0 ? uniform(0, 3 * shape.length) : random() % 8 == 0 ? 0 : 4;
    speed = random() % 20 == 0 ? -speed : speed;
    along += speed * uniform(-0.05, 0.2) * shape.length * (random() % 4 == 0 ? 0 : 1);
    const double where = stretch ? (random() % 16 == 0 ? kNothing : along) : time;
    const double value = random() % 16 == 0 ? kNothing : uniform(-5, 30);
    const bool fresh = random() % 5 != 0;
    const double got = ring.advance(time, where, value, fresh);
    plain.advance(time, where, value, fresh);
    ASSERT_EQ(std::bit_cast<uint64_t>(got), std::bit_cast<uint64_t>(plain.value()))
        << "seed " << seed << " tick " << i << ": " << got << ", " << plain.value();
  }
}

TEST(Window, IsThatOfThePlainImplementation) {
  for (uint32_t seed = 1; seed <= 500; ++seed) {
    compare(seed);
    if (HasFatalFailure()) {
      return;
    }
  }
}

}  // namespace
