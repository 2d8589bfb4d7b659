// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A behaviour above hookbeh replaces its commands: a surfacing, for example.

#include "hooks/hookbeh/hookbeh.h"
#include "tests/unit/hooks/hookbeh_sea.h"

#include <gtest/gtest.h>

namespace glider::hooks {
namespace {

using Bench = HookbehBench;
constexpr uint8_t kAll = kMaskedHeading | kMaskedPitch | kMaskedPump;

/// The layered control flies `pump` in hookbeh's place.
auto maskedBy(double pump, uint8_t channels = kAll) {
  return [=](HookbehInputs& in) {
    in.masked = channels;
    in.commanded_pump_cc = pump;
  };
}
constexpr auto kFree = [](HookbehInputs& in) {
  in.masked = 0;
  in.commanded_pump_cc = kNan;
};

/// The vehicle rises to the surface under another behaviour, for that many cycles.
void surfaceOver(HookbehSea& sea, int cycles) {
  for (int i = 0; i < cycles; ++i) {
    sea.pump = 230;
    sea.cycle(maskedBy(230));
  }
}

/// A climb that has arrived at once: hookbeh holds its commands.
void arrive(HookbehSea& sea) {
  sea.diveTo(18, 28);
  sea.held = true;
  sea.bench.write(Bench::ascend(20));
  sea.cycle();
  ASSERT_STREQ(wordsFor(sea.out.doing), "hold");
}

TEST(HookbehMasked, IsReportedFromTheLayeredControl) {
  HookbehSea sea;
  sea.diveTo(5, 28);
  EXPECT_EQ(sea.out.masked, 0);
  sea.cycle(maskedBy(sea.out.pump_cc));
  EXPECT_EQ(sea.out.masked, kAll) << "though the pump is where hookbeh commanded it";
  sea.cycle(maskedBy(sea.out.pump_cc, kMaskedHeading));
  EXPECT_EQ(sea.out.masked, kMaskedHeading);
  sea.cycle(kFree);
  EXPECT_EQ(sea.out.masked, 0);
}

TEST(HookbehMasked, ThePumpAloneTellsWhereTheLayeredControlDoesNot) {
  HookbehSea sea;
  sea.diveTo(5, 28);
  sea.cycle(maskedBy(230, 0));
  EXPECT_EQ(sea.out.masked, kMaskedPump);
  sea.cycle(maskedBy(sea.out.pump_cc + 29, 0));
  EXPECT_EQ(sea.out.masked, 0) << "the pump's own error";
}

TEST(HookbehMasked, OneThatCommandsNothingIsNotMasked) {
  HookbehSea sea;
  sea.cycle(maskedBy(230));
  ASSERT_EQ(sea.out.state, HookState::Ready);
  EXPECT_EQ(sea.out.masked, 0);
}

TEST(HookbehMasked, TheTimeOfAHoldDoesNotAdvance) {
  for (const uint8_t channels : {kMaskedPitch, kMaskedPump}) {
    HookbehSea sea;
    arrive(sea);
    sea.run(50, maskedBy(sea.out.pump_cc, channels));
    EXPECT_STREQ(wordsFor(sea.out.doing), "hold")
        << int{channels} << ": 200 s, and it holds for 12";
    sea.run(2, kFree);
    EXPECT_STREQ(wordsFor(sea.out.doing), "hold");
    sea.run(2, kFree);
    EXPECT_STREQ(wordsFor(sea.out.doing), "hover") << "then its 12 s are over";
  }
}

TEST(HookbehMasked, AMaskedHeadingLetsTheHoldGoOn) {
  HookbehSea sea;
  arrive(sea);
  sea.run(4, maskedBy(sea.out.pump_cc, kMaskedHeading));
  EXPECT_STREQ(wordsFor(sea.out.doing), "hover");
}

TEST(HookbehMasked, AHoverIsReachedAgainAtPitch) {
  HookbehSea sea;
  sea.diveTo(18, 20);
  sea.bench.write(Bench::vertical(HookVertical::Hover, 20));
  sea.run(20, kNothing);
  ASSERT_STREQ(wordsFor(sea.out.doing), "hover");
  surfaceOver(sea, 60);
  ASSERT_LT(sea.truth, 1);
  EXPECT_STREQ(wordsFor(sea.out.doing), "hover") << "it waits";
  sea.cycle(kFree);
  EXPECT_STREQ(wordsFor(sea.out.doing), "dive_to");
  EXPECT_LT(sea.out.pitch_rad, -0.4);
  sea.run(60, kFree);
  EXPECT_STREQ(wordsFor(sea.out.doing), "hover");
  EXPECT_NEAR(sea.truth, 20, 2.5);
}

TEST(HookbehMasked, ADiveThatIsUnderWayGoesOn) {
  HookbehSea sea;
  sea.diveTo(10, 28);
  surfaceOver(sea, 300);
  EXPECT_EQ(sea.out.guard, HookGuard::None) << "20 minutes without a metre gained are not its own";
  ASSERT_STREQ(wordsFor(sea.out.doing), "dive_to");
  sea.run(200, kFree);
  EXPECT_NEAR(sea.truth, 28, 2.5);
}

TEST(HookbehMasked, SilenceStillCounts) {
  HookbehSea sea;
  sea.diveTo(10, 28);
  surfaceOver(sea, 3);
  sea.bench.alive = false;
  surfaceOver(sea, 6);
  EXPECT_EQ(sea.out.state, HookState::Silent);
  EXPECT_EQ(sea.out.masked, 0) << "it commands nothing any more";
}

}  // namespace
}  // namespace glider::hooks
