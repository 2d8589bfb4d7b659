// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/instruction.h"

#include <gtest/gtest.h>

namespace glider::hooks {
namespace {

Instruction example() {
  Instruction instruction;
  instruction.session = 7;
  instruction.sequence = 258;
  instruction.control = HookControl::Take;
  instruction.vertical = HookVertical::Descend;
  instruction.lateral = HookLateral::Waypoint;
  instruction.depth_m = 20.1;
  instruction.pitch_rad = -0.454;
  instruction.heading_rad = 1.3;
  instruction.latitude_ddmm = 3910.5;
  instruction.longitude_ddmm = -7349.8058;
  return instruction;
}

TEST(Values, RoundingIsWhatTheArrayDoesAndDoneOnce) {
  const Instruction rounded = roundToArray(example());
  EXPECT_EQ(rounded.depth_m, static_cast<double>(20.1F));
  EXPECT_EQ(rounded.pitch_rad, static_cast<double>(-0.454F));
  EXPECT_EQ(rounded.latitude_ddmm, 3910.5);
  EXPECT_EQ(rounded.longitude_ddmm, -7349.8058);
  EXPECT_EQ(roundToArray(rounded).depth_m, rounded.depth_m);
  EXPECT_EQ(checkValue(rounded), checkValue(example()));
}

TEST(Values, TheReadmesCheckValue) {
  EXPECT_EQ(checkValue(example()), 0x5F41);
}

TEST(Values, EveryFieldCounts) {
  const uint16_t check = checkValue(example());
  auto changed = [&](auto&& change) {
    Instruction other = example();
    change(other);
    return checkValue(other) != check;
  };
  EXPECT_TRUE(changed([](Instruction& i) { i.session = 8; }));
  EXPECT_TRUE(changed([](Instruction& i) { i.sequence = 259; }));
  EXPECT_TRUE(changed([](Instruction& i) { i.control = HookControl::Steer; }));
  EXPECT_TRUE(changed([](Instruction& i) { i.vertical = HookVertical::Ascend; }));
  EXPECT_TRUE(changed([](Instruction& i) { i.lateral = HookLateral::Drift; }));
  EXPECT_TRUE(changed([](Instruction& i) { i.depth_m = 20.2; }));
  EXPECT_TRUE(changed([](Instruction& i) { i.pitch_rad = 0.454; }));
  EXPECT_TRUE(changed([](Instruction& i) { i.heading_rad = 1.4; }));
  EXPECT_TRUE(changed([](Instruction& i) { i.latitude_ddmm = 3910.6; }));
  EXPECT_TRUE(changed([](Instruction& i) { i.longitude_ddmm = 7349.8058; }));
}

TEST(Sequences, NumbersAreNewerUpToHalfOfTheRoundAhead) {
  EXPECT_FALSE(isNewerSequence(0, 0));
  EXPECT_FALSE(isNewerSequence(0, 65534)) << "no number of an instruction";
  EXPECT_TRUE(isNewerSequence(1, 0));
  EXPECT_TRUE(isNewerSequence(32768, 1)) << "half of the round";
  EXPECT_FALSE(isNewerSequence(32769, 1));
  EXPECT_FALSE(isNewerSequence(9, 9));
}

}  // namespace
}  // namespace glider::hooks
