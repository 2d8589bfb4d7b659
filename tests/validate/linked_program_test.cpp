// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What was linked is what was compiled: every byte of the mission's functions that is changed in
// the linked program is found.

#include "codegen/llvm/link/lld.h"
#include "codegen/llvm/program/compile.h"
#include "codegen/llvm/validate/image.h"
#include "compiler/compilation.h"
#include "platforms/load/board.h"

#include <gtest/gtest.h>
#include <llvm/Object/ELFObjectFile.h>

#include <filesystem>

namespace glider::validate_test {
namespace {

class LinkedProgram : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const auto compilation =
        compiler::compileMission(GLIDER_SOURCE_DIR "/missions/gallery/thermocline.mission");
    ASSERT_TRUE(compilation && compilation->checked);
    const compiler::Optimised mission = compiler::optimise(compilation->checked);
    const auto board = platforms::loadBoard(std::filesystem::path(GLIDER_BINARY_DIR) /
                                            "share/glidercc/boards" / GetParam() / "board.toml");
    ASSERT_TRUE(board);
    auto program = codegen::compileProgram(mission.input(), *board, {},
                                           codegen::ProgramKind::Executable, {"main"});
    ASSERT_TRUE(program);
    auto linked = codegen::link({codegen::ProgramKind::Executable,
                                 program->objects,
                                 program->further_inputs,
                                 {},
                                 true,
                                 false},
                                *board);
    ASSERT_TRUE(linked) << linked.error().message;
    objects = program->objects;
    image = *linked;
  }

  /// Where a function is in the file.
  struct Extent {
    uint64_t offset = 0;
    uint64_t size = 0;
  };
  Extent extentOf(const std::string& wanted) const {
    auto file = llvm::cantFail(
        llvm::object::ObjectFile::createObjectFile(llvm::MemoryBufferRef(image, "image")));
    for (const llvm::object::ELFSymbolRef symbol :
         llvm::cast<llvm::object::ELFObjectFileBase>(file.get())->symbols()) {
      if (llvm::cantFail(symbol.getName()) == wanted) {
        const auto section = *llvm::cantFail(symbol.getSection());
        const char* content = llvm::cantFail(section.getContents()).data();
        return {static_cast<uint64_t>(content - image.data()) +
                    llvm::cantFail(symbol.getAddress()) - section.getAddress(),
                symbol.getSize()};
      }
    }
    return {};
  }

  std::vector<std::string> objects;
  std::string image;
};

TEST_P(LinkedProgram, HoldsWhatWasCompiled) {
  const codegen::Validated found = codegen::compareImage(objects, image);
  EXPECT_EQ(found.verdict, codegen::Verdict::Same) << found.words;
}

TEST_P(LinkedProgram, WithAWrongInstructionIsRefused) {
  const Extent guards = extentOf("guards.search");
  ASSERT_GT(guards.size, 20U);
  uint64_t found = 0;
  for (uint64_t i = 0; i < guards.size; ++i) {
    const char kept = image[guards.offset + i];
    image[guards.offset + i] = static_cast<char>(kept ^ 0x10);
    const codegen::Validated one = codegen::compareImage(objects, image);
    if (one.verdict == codegen::Verdict::Differs) {
      EXPECT_NE(one.words.find("guards.search"), std::string::npos) << one.words;
      ++found;
    }
    image[guards.offset + i] = kept;
  }
  // The rest is filled in when it is linked.
  EXPECT_GT(found, guards.size * 3 / 4);
}

INSTANTIATE_TEST_SUITE_P(Boards, LinkedProgram,
                         testing::Values("host", "ts7800", "ts5500", "pizero2", "cm4"),
                         [](const auto& param) { return std::string(param.param); });

}  // namespace
}  // namespace glider::validate_test
