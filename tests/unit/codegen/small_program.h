// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/budget/disassembler.h"
#include "codegen/llvm/budget/image.h"
#include "codegen/llvm/budget/stack_bound.h"
#include "support/check.h"
#include "tests/support/command.h"
#include "tests/unit/codegen/compiled_mission.h"

#include <algorithm>
#include <expected>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace glider::codegen_tests {

using codegen::CallKnowledge;
using codegen::Image;
using codegen::StackBound;
using codegen::stackMachine;

/// A function `name` of the assembler.
inline std::string function(const std::string& name, const std::string& body) {
  return ".text\n.globl " + name + "\n.type " + name + ", %function\n" + name + ":\n" + body +
         "\n.size " + name + ", . - " + name + "\n";
}

/// What the linker makes of assembly for a board; the program begins at `_start`.
class Small {
 public:
  Small(const std::string& name, const std::string& assembly) : board_(board(name)) {
    const tests::TemporaryFolder folder;
    (void)folder.write("small.s", assembly);
    const std::string at = folder.path().string();
    const auto outcome = tests::runShell("cd " + at + " && clang-19 --target=" + board_.triple +
                                         " -mcpu=" + board_.cpu +
                                         " -c small.s -o small.o && "
                                         "ld.lld-19 -static -o small small.o");
    CHECK(outcome.status == 0, outcome.err.c_str());
    auto image = Image::read(tests::slurp(folder.path() / "small"), board_);
    CHECK(image.has_value(), "a small program cannot be taken apart");
    image_.emplace(std::move(*image));
  }

  /// Bytes of a call of `_start`; `pointers` is what calls through pointers reach, except those
  /// that `excluding` functions exclude while they are active.
  [[nodiscard]] std::expected<uint64_t, std::string> bytes(
      const std::vector<std::string>& pointers = {}, uint64_t at_once = 1,
      const std::map<std::string, std::set<std::string>>& excluding = {}) const {
    const auto bitOf = [&](const std::string& name) {
      return 1U << (std::ranges::find(pointers, name) - pointers.begin());
    };
    const auto targets = [&](uint64_t, uint32_t excluded) {
      std::vector<uint64_t> all;
      for (const std::string& name : pointers) {
        if ((bitOf(name) & excluded) == 0) {
          all.push_back(*image_->function(name));
        }
      }
      return all;
    };
    const auto excludedBy = [&](uint64_t entry) {
      uint32_t bits = 0;
      const auto found = excluding.find(image_->symbolAt(entry));
      for (const std::string& name :
           found == excluding.end() ? std::set<std::string>() : found->second) {
        bits |= bitOf(name);
      }
      return bits;
    };
    const CallKnowledge knowledge{targets, excludedBy,
                                  [at_once](const std::string&) { return at_once; }};
    const auto call = StackBound(*image_, stackMachine(board_), knowledge).bound(image_->entry());
    return call ? std::expected<uint64_t, std::string>(call->bytes) : std::unexpected(call.error());
  }
  [[nodiscard]] const Image& image() const { return *image_; }

 private:
  platforms::Board board_;
  std::optional<Image> image_;
};

}  // namespace glider::codegen_tests
