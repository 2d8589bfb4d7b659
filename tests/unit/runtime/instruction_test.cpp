// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/core/instruction.h"

#include <gtest/gtest.h>

namespace glider::runtime {
namespace {

using hooks::Instruction;

TEST(SameCommand, DiffersWithEachOfItsParts) {
  void (*const changes[])(Instruction&) = {
      [](Instruction& i) { i.vertical = hooks::HookVertical::Hover; },
      [](Instruction& i) { i.lateral = hooks::HookLateral::Heading; },
      [](Instruction& i) { i.depth_m = 1; },
      [](Instruction& i) { i.pitch_rad = 1; },
      [](Instruction& i) { i.heading_rad = 1; },
      [](Instruction& i) { i.latitude_ddmm = 1; },
      [](Instruction& i) { i.longitude_ddmm = 1; }};
  for (const auto& change : changes) {
    Instruction changed;
    change(changed);
    EXPECT_FALSE(sameCommand(changed, {})) << &change - changes;
    EXPECT_TRUE(sameCommand(changed, changed));
  }
}

TEST(SameCommand, IsIndependentOfSenderAndTime) {
  Instruction later;
  later.session = 2;
  later.sequence = 9;
  later.control = hooks::HookControl::Take;
  EXPECT_TRUE(sameCommand(later, {}));
}

}  // namespace
}  // namespace glider::runtime
