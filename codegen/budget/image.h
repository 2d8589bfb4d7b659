// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/board.h"
#include "support/result.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glider::codegen {

/// Where control goes from an instruction. What a condition guards may also go on to the next one.
enum class Flow : uint8_t {
  Next,
  Jump,           ///< to `target`
  JumpIf,         ///< to `target` or on
  Call,           ///< of `target`, then on
  CallByPointer,  ///< then on
  JumpByPointer,  ///< to another function for good, on its behalf
  JumpByTable,    ///< a switch: to one of the words from `target` on
  Return,
  ReturnIf,
  Unknown,  ///< nobody can tell
};

struct Instruction {
  uint64_t address = 0;
  uint32_t size = 0;
  Flow flow = Flow::Next;
  uint64_t target = 0;
  /// The next instruction is repeated by the processor (x86's `rep`), so often at most if it is 0
  /// or more; kUncounted: nobody can tell.
  int64_t repeats = kOnce;
  static constexpr int64_t kOnce = -1, kUncounted = -2;
  uint64_t counted_at = 0;  ///< the instruction that set the count
};

/// Where in the sources an instruction comes from: the function, or one that was inlined there.
struct Frame {
  std::string file;  ///< its last part; empty if unknown
  std::string function;
  uint32_t line = 0;  ///< 0: unknown, or of several places
  bool operator==(const Frame& other) const {
    return file == other.file && function == other.function;
  }
};

/// The linked executable of a board, with its symbols and line tables, taken apart.
class Image {
 public:
  /// Of a machine that disassembler.h does not know, code() is empty. GL4004 if it is no ELF file.
  static support::Result<Image> read(const std::string& linked, const platforms::Board& board);
  Image(Image&&) noexcept;
  ~Image();

  /// All code, by address.
  [[nodiscard]] const std::vector<Instruction>& code() const;
  /// The place in code() of the instruction at `address`.
  [[nodiscard]] std::optional<uint32_t> at(uint64_t address) const;
  /// The address of function `name`.
  [[nodiscard]] std::optional<uint64_t> function(const std::string& name) const;
  /// The addresses of all functions whose names begin with `prefix`.
  [[nodiscard]] std::vector<uint64_t> functionsNamed(const std::string& prefix) const;
  /// The symbol that the instruction at `address` belongs to; "" if none.
  [[nodiscard]] std::string symbolAt(uint64_t address) const;
  /// Innermost first; at least one.
  [[nodiscard]] std::vector<Frame> framesAt(uint64_t address) const;
  /// Where a switch may go: what its table holds, up to the first word that is no instruction of
  /// the same function. Empty if nobody can tell.
  [[nodiscard]] std::vector<uint64_t> tableTargets(const Instruction& jump) const;
  /// Of what is loaded into memory: all of it, and what is written to.
  [[nodiscard]] uint64_t loadedBytes() const;
  [[nodiscard]] uint64_t writableBytes() const;

 private:
  struct Parts;
  explicit Image(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace glider::codegen
