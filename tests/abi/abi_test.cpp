// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The structs that runtime and generated code share have one layout: clang's, on every board.

#include "codegen/llvm/lower/abi_types.h"
#include "codegen/llvm/target/machine.h"
#include "platforms/load/board.h"
#include "support/files.h"

#include <gtest/gtest.h>
#include <llvm/IR/DataLayout.h>
#include <llvm/Object/ELFObjectFile.h>
#include <llvm/Support/MemoryBuffer.h>

#include <cstring>
#include <map>
#include <vector>

namespace glider {
namespace {

/// By struct: size, alignment, offsets of the fields.
using Layouts = std::map<std::string, std::vector<uint64_t>>;

/// What clang has made of layout.c for `board`.
Layouts fromC(const std::string& board) {
  const std::string path = std::string(GLIDER_BINARY_DIR) + "/tests/abi/layout-" + board + ".o";
  const std::string bytes = support::readFile(path).value_or("");
  auto object = llvm::object::createBinary(llvm::MemoryBufferRef(bytes, path));
  EXPECT_TRUE(static_cast<bool>(object)) << path;
  Layouts layouts;
  for (const auto& section : llvm::cast<llvm::object::ObjectFile>(object->get())->sections()) {
    llvm::StringRef name = llvm::cantFail(section.getName());
    if (name.consume_front("layout.")) {
      const llvm::StringRef content = llvm::cantFail(section.getContents());
      std::vector<uint32_t> numbers(content.size() / sizeof(uint32_t));
      std::memcpy(numbers.data(), content.data(), content.size());
      layouts[name.str()].assign(numbers.begin(), numbers.end());
    }
  }
  return layouts;
}

std::vector<uint64_t> numbersOf(llvm::StructType* type, const llvm::DataLayout& layout) {
  std::vector<uint64_t> numbers{layout.getTypeAllocSize(type).getFixedValue(),
                                layout.getABITypeAlign(type).value()};
  for (unsigned i = 0; i < type->getNumElements(); ++i) {
    numbers.push_back(layout.getStructLayout(type)->getElementOffset(i).getFixedValue());
  }
  return numbers;
}

Layouts fromLlvm(const platforms::Board& board) {
  const auto machine = codegen::makeMachine(board, 2, codegen::ProgramKind::Executable);
  EXPECT_TRUE(machine.has_value());
  llvm::LLVMContext context;
  const codegen::AbiTypes types = codegen::makeAbiTypes(context);
  const llvm::DataLayout layout = (*machine)->createDataLayout();
  Layouts layouts;
#define STRUCT(name) layouts[#name] = numbersOf(types.name, layout);
#define FIELD(type, name)
#define STRUCT_END(name)
#include "hooks/protocol/dictionary.def"
#include "runtime/abi/abi_structs.def"
#undef STRUCT
#undef FIELD
#undef STRUCT_END
  return layouts;
}

class Abi : public testing::TestWithParam<const char*> {};

TEST_P(Abi, StructsAreLaidOutAsInC) {
  const auto board = platforms::loadBoard(std::string(GLIDER_SOURCE_DIR "/platforms/boards/") +
                                          GetParam() + ".toml");
  ASSERT_TRUE(board.has_value());
  const Layouts layouts = fromC(GetParam());
  EXPECT_FALSE(layouts.empty());
  EXPECT_EQ(fromLlvm(*board), layouts);
}

INSTANTIATE_TEST_SUITE_P(Boards, Abi,
                         testing::Values("host", "ts7800", "ts5500", "pizero2", "cm4"));

}  // namespace
}  // namespace glider
