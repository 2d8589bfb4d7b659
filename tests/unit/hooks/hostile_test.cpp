// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/hull.h"
#include "tests/fuzz/hooks_hostile.h"
#include "tests/unit/hooks/examples.h"
#include "tests/unit/hooks/hookbeh_bench.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

/// A deterministic share of what tests/fuzz/hooks_fuzzer.cpp does for as long as one likes.
namespace glider::hooks {
namespace {

// An emulated 68332 takes a tenth: it is there for the order of bytes, not for rare cases.
#ifdef __m68k__
constexpr int kShare = 10;
#else
constexpr int kShare = 1;
#endif

using Bytes = std::vector<uint8_t>;

void feed(const Bytes& bytes) {
  feedEverything(bytes.data(), static_cast<uint32_t>(bytes.size()));
}

TEST(Hostile, RandomBytes) {
  std::mt19937 random(7);
  for (int i = 0; i < 20000 / kShare; ++i) {
    Bytes bytes(random() % 600);
    for (uint8_t& byte : bytes) {
      byte = static_cast<uint8_t>(i % 2 == 0 ? random() : random() % 4);
    }
    feed(bytes);
  }
}

TEST(Hostile, DamagedGoodFrames) {
  std::mt19937 random(8);
  const auto examples = exampleFrames();
  for (int i = 0; i < 20000 / kShare; ++i) {
    Bytes bytes;
    for (int n = 0; n < 6; ++n) {
      const Frame& frame = examples[random() % examples.size()].second;
      if (i % 2 == 0) {
        Bytes encoded(kMostEncodedBytes);
        encoded.resize(encodeFrame(frame, encoded.data()));
        bytes.insert(bytes.end(), encoded.begin(), encoded.end());
      } else {  // the fuzzer's own form, behind the checksum
        bytes.push_back(static_cast<uint8_t>(frame.size));
        bytes.push_back(static_cast<uint8_t>(frame.type));
        bytes.insert(bytes.end(), frame.payload, frame.payload + frame.size);
      }
    }
    for (uint32_t changes = random() % 4; changes > 0; --changes) {
      bytes[random() % bytes.size()] = static_cast<uint8_t>(random());
    }
    feed(bytes);
  }
}

/// Numbers by `any`, codes that may be unknown; rarely one that may `release` control.
template <typename Any>
Instruction wildInstruction(std::mt19937_64& random, const Any& any, bool release) {
  Instruction instruction;
  instruction.session = 1 + static_cast<uint32_t>(random() % 3);
  instruction.control = static_cast<HookControl>(1 + random() % (release ? 4 : 2));
  instruction.vertical = static_cast<HookVertical>(random() % 7);
  instruction.lateral = static_cast<HookLateral>(random() % 5);
  instruction.depth_m = any();
  instruction.pitch_rad = any();
  instruction.heading_rad = any();
  instruction.latitude_ddmm = any();
  instruction.longitude_ddmm = any();
  return instruction;
}

bool obeysActuators(const Instruction& instruction, const HookbehOutputs& out) {
  return out.answer == HookAnswer::Accepted && instruction.vertical == HookVertical::Actuators;
}

TEST(Hostile, InstructionsWithRightChecksAndWildValues) {
  std::mt19937_64 random(9);
  const double wild[] = {kNan,
                         -1e300,
                         1e300,
                         -0.0,
                         0,
                         5,
                         20,
                         30,
                         30.00001,
                         9000,
                         -18000,
                         0.4,
                         -0.4,
                         6.3,
                         std::numeric_limits<double>::infinity(),
                         std::numeric_limits<double>::denorm_min()};
  const auto any = [&] { return wild[random() % std::size(wild)]; };
  HookbehBench bench;
  uint32_t accepted = 0;
  uint32_t held = 0;
  uint32_t actuated = 0;
  for (int i = 0; i < 300000 / kShare; ++i) {
    if (i % 1000 == 0) {
      bench = HookbehBench();
      bench.raw_depth = true;  // no dive leads to such depths
      bench.cycle();
    }
    const Instruction instruction = wildInstruction(random, any, i % 100 == 99);
    bench.inputs.depth_m = random() % 8 == 0 ? any() : static_cast<double>(random() % 40);
    bench.inputs.depth_rate_mps = any();
    bench.inputs.altitude_m = any();
    bench.inputs.latitude_ddmm = any();
    bench.alive = random() % 16 != 0;
    const HookbehOutputs out = bench.give(instruction);
    accepted += out.answer == HookAnswer::Accepted ? 1 : 0;
    actuated += obeysActuators(instruction, out) ? 1U : 0U;
    ASSERT_EQ(out.commanding, out.state == HookState::Active);
    if (!out.commanding) {
      continue;
    }
    ASSERT_LE(std::abs(out.pitch_rad), 0.61 + 1e-6);
    const bool full = out.guard != HookGuard::None || out.pitch_mode == PitchMode::Battery;
    ASSERT_LE(std::abs(out.pump_cc), full ? kHull.pump_cc : 230);
    ASSERT_GE(out.heading_rad, 0);
    ASSERT_LE(out.heading_rad, 6.2831854);
    ASSERT_LE(std::abs(out.fin_rad), kHull.fin_rad);
    ASSERT_TRUE(out.heading_mode == HeadingMode::Fin || out.fin_rad == 0);
    ASSERT_LE(std::abs(out.battery_in), kHull.battery_in);
    ASSERT_TRUE(out.pitch_mode == PitchMode::Battery || out.battery_in == 0);
    held += out.fin_rad != 0 ? 1 : 0;
    if (!(bench.inputs.depth_m <= 30)) {
      ASSERT_EQ(out.pump_cc, kHull.pump_cc) << "deeper than allowed, or unknown, it climbs";
    }
  }
  EXPECT_GT(accepted, 1000U);
  EXPECT_GT(held, 100U) << "also a fin";
  EXPECT_GT(actuated, 50U) << "also pump and battery";
}

}  // namespace
}  // namespace glider::hooks
