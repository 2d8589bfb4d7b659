// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/codegen.h"
#include "codegen/llvm/budget/flow_of.h"
#include "codegen/llvm/budget/loops.h"
#include "codegen/llvm/budget/strongly_connected.h"
#include "codegen/llvm/budget/worst_path.h"
#include "codegen/llvm/link/lld.h"
#include "codegen/llvm/program/compile.h"
#include "hooks/protocol/messages.h"
#include "hooks/protocol/tick.h"
#include "support/check.h"
#include "tests/unit/codegen/compiled_mission.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace glider::codegen {
namespace {

namespace fs = std::filesystem;
using codegen_tests::board;
using codegen_tests::Checked;
using codegen_tests::figure2;
using testing::HasSubstr;

static_assert(kMostReadings == hooks::kMostSubscriptions);

CodegenOptions optionsFor(const Checked& checked) {
  CodegenOptions options;
  options.sources = &checked.sources;
  return options;
}

Image imageOf(const Checked& checked, const platforms::Board& target) {
  const auto program = compileProgram(checked.input(), target, optionsFor(checked),
                                      ProgramKind::Executable, {"main"});
  CHECK(program.has_value(), "figure 2 does not compile");
  const auto linked =
      link({ProgramKind::Executable, program->objects, program->further_inputs, {}, true, false},
           target);
  CHECK(linked.has_value(), "figure 2 does not link");
  auto image = Image::read(*linked, target);
  CHECK(image.has_value(), "figure 2 cannot be taken apart");
  return std::move(*image);
}

TEST(Budget, TheExecutableIsTheOneThatIsBuilt) {
  const Checked checked = figure2();
  for (const char* name : {"ts7800", "ts5500", "pizero2", "cm4"}) {
    const platforms::Board target = board(name);
    const auto budget = measureBudget(checked.input(), target, optionsFor(checked));
    ASSERT_TRUE(budget) << budget.error().message;
    const fs::path output = codegen_tests::testFolder() / name;
    ASSERT_TRUE(linkExecutable(checked.input(), target, optionsFor(checked), output));
    // It contains the name of the debug file, padded to whole words.
    EXPECT_NEAR(static_cast<double>(budget->executable_bytes),
                static_cast<double>(fs::file_size(output)), 16);
    EXPECT_GT(budget->memory_bytes, budget->data_bytes);
    ASSERT_TRUE(budget->stack_bytes) << budget->stack_bytes.error();
    EXPECT_GT(*budget->stack_bytes, 1000u);
    EXPECT_LT(*budget->stack_bytes, target.max_stack_bytes);
    ASSERT_TRUE(budget->tick_instructions) << budget->tick_instructions.error();
    EXPECT_GT(*budget->tick_instructions, 1000u);
    EXPECT_LT(*budget->tick_instructions, target.max_tick_instructions);
  }
}

TEST(Budget, WhereTheCodeIsNotFollowedThereIsNoBound) {
  const Checked checked = figure2();
  const auto budget = measureBudget(checked.input(), board("host"), optionsFor(checked));
  ASSERT_TRUE(budget) << budget.error().message;
  EXPECT_GT(budget->executable_bytes, 10'000u);
  ASSERT_FALSE(budget->tick_instructions);
  EXPECT_THAT(budget->tick_instructions.error(), HasSubstr("cannot be analysed"));
}

class PathOn : public testing::TestWithParam<const char*> {
 protected:
  PathOn() : checked_(figure2()), image_(imageOf(checked_, board(GetParam()))) {
    size_ = sizeOf(checked_.input());
    size_.data_bytes = image_.writableBytes();
    knowledge_ = {[this](const Frame& frame) { return turnsIn(frame, size_); },
                  [this](const std::vector<Frame>&) { return image_.functionsNamed("guards."); },
                  neverCalled};
  }
  std::expected<uint64_t, std::string> bound() {
    return WorstPath(image_, knowledge_).bound(*image_.function("gliderStep"));
  }

  Checked checked_;
  Image image_;
  MissionSize size_;
  Knowledge knowledge_;
};

TEST_P(PathOn, MoreTurnsMakeAGreaterBound) {
  const auto before = bound();
  ASSERT_TRUE(before) << before.error();
  size_.most_readings *= 2;
  const auto readings = bound();
  ASSERT_TRUE(readings) << readings.error();
  EXPECT_GT(*readings, *before);
  size_.sensors *= 2;
  const auto sensors = bound();
  ASSERT_TRUE(sensors);
  EXPECT_GT(*sensors, *readings);
}

TEST_P(PathOn, ALoopWithoutAStatedBoundHasNoBound) {
  knowledge_.turns = [this](const Frame& frame) {
    return frame.function == "takeUpdates" ? Turns{} : turnsIn(frame, size_);
  };
  const auto none = bound();
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error(), HasSubstr("the loop in `takeUpdates`"));
}

TEST_P(PathOn, LoopsInLoopsAreDistinguishedOrAllOfThemMultiplied) {
  const auto apart = bound();
  // Only their product is stated: nothing says which is which.
  knowledge_.turns = [this](const Frame& frame) {
    const Turns turns = turnsIn(frame, size_);
    return turns.inner == 0 ? turns : Turns{turns.outer * turns.inner, 0};
  };
  const auto product = bound();
  ASSERT_TRUE(apart && product);
  EXPECT_GT(*product, *apart);
}

TEST_P(PathOn, WhatCallsItselfHasNoBound) {
  knowledge_.pointers = [this](const std::vector<Frame>&) {
    return std::vector{*image_.function("gliderStep")};
  };
  const auto none = bound();
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error(), HasSubstr("`gliderStep` may call itself"));
}

TEST_P(PathOn, NoPlaceInTheRuntimeIsUnknown) {
  // Frames of what was inlined are named, innermost first.
  bool inlined = false;
  for (const Instruction& one : image_.code()) {
    const std::vector<Frame> frames = image_.framesAt(one.address);
    inlined = inlined || (frames.size() > 1 && frames.front().function == "isFinite" &&
                          frames.front().file == "numbers.h");
  }
  EXPECT_TRUE(inlined);
}

INSTANTIATE_TEST_SUITE_P(Boards, PathOn, testing::Values("ts7800", "ts5500", "pizero2", "cm4"));

TEST(FlowOf, Arm) {
  const std::pair<Written, Flow> cases[] = {
      {{"add", "r0, r1, r2"}, Flow::Next},
      {{"b", "#0x10"}, Flow::Jump},
      {{"bne", "#0x10"}, Flow::JumpIf},
      {{"bls", "#0x10"}, Flow::JumpIf},
      {{"bl", "#0x10"}, Flow::Call},
      {{"bleq", "#0x10"}, Flow::Call},
      {{"blt", "#0x10"}, Flow::JumpIf},
      {{"blx", "r2"}, Flow::CallByPointer},
      {{"blx", "#0x10"}, Flow::Call},
      {{"bx", "lr"}, Flow::Return},
      {{"bxne", "lr"}, Flow::ReturnIf},
      {{"bx", "r3"}, Flow::JumpByPointer},
      {{"bic", "r0, r1, r2"}, Flow::Next},
      {{"add", "pc, pc, r3, lsl #2"}, Flow::JumpAhead},
      {{"addls", "pc, pc, r3, lsl #2"}, Flow::JumpAheadIf},
      {{"pop", "{r4, pc}"}, Flow::Return},
      {{"popne", "{r4, pc}"}, Flow::ReturnIf},
      {{"pop", "{r4, lr}"}, Flow::Next},
      {{"ldmdb", "r11, {r4, pc}"}, Flow::Return},
      {{"ldr", "pc, [sp], #4"}, Flow::Return},
      {{"ldrls", "pc, [sp], #4"}, Flow::ReturnIf},
      {{"ldr", "pc, [r4, r3, lsl #2]"}, Flow::JumpByTable},
      {{"ldr", "pc, [r4]"}, Flow::Unknown},
      {{"ldr", "r0, [pc, #8]"}, Flow::Next},
      {{"mov", "pc, lr"}, Flow::Return},
      {{"moveq", "pc, lr"}, Flow::ReturnIf},
      {{"mov", "pc, r3"}, Flow::JumpByPointer},
      {{"add", "pc, pc, r0"}, Flow::Unknown},
      {{"str", "pc, [r0]"}, Flow::Next},
  };
  for (const auto& [written, flow] : cases) {
    EXPECT_EQ(armFlow(written), flow) << written.operation << ' ' << written.operands;
  }
}

TEST(FlowOf, X86) {
  const std::pair<Written, Flow> cases[] = {
      {{"movl", "%eax, %ebx"}, Flow::Next},
      {{"jmp", "16"}, Flow::Jump},
      {{"ja", "16"}, Flow::JumpIf},
      {{"calll", "16"}, Flow::Call},
      {{"calll", "*%eax"}, Flow::CallByPointer},
      {{"calll", "*%gs:16"}, Flow::Next},
      {{"jmpl", "*%eax"}, Flow::JumpByPointer},
      {{"jmpl", "*4197908(,%esi,4)"}, Flow::JumpByTable},
      {{"retl", ""}, Flow::Return},
      {{"loop", "-4"}, Flow::JumpIf},
  };
  for (const auto& [written, flow] : cases) {
    EXPECT_EQ(x86Flow(written), flow) << written.operation << ' ' << written.operands;
  }
}

TEST(Circles, EachStandsAfterWhatItLeadsTo) {
  // 0 → 1 ⇄ 2 → 3, 3 → 3, 0 → 4
  const Circles components({{1, 4}, {2}, {1, 3}, {3}, {}});
  EXPECT_EQ(components.list().size(), 4u);
  EXPECT_EQ(components.of(1), components.of(2));
  EXPECT_TRUE(components.turns(components.of(1)));
  EXPECT_TRUE(components.turns(components.of(3)));
  EXPECT_FALSE(components.turns(components.of(0)));
  EXPECT_FALSE(components.turns(components.of(4)));
  EXPECT_LT(components.of(3), components.of(1));
  EXPECT_LT(components.of(1), components.of(0));
  EXPECT_LT(components.of(4), components.of(0));
}

TEST(Circles, LongWaysNeedNoStack) {
  std::vector<std::vector<uint32_t>> next(200'000);
  for (uint32_t i = 0; i + 1 < next.size(); ++i) {
    next[i] = {i + 1};
  }
  next.back() = {0};
  EXPECT_EQ(Circles(next).list().size(), 1u);
}

}  // namespace
}  // namespace glider::codegen
