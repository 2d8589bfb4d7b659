// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/budget/taken.h"

#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace glider::codegen {

/// On ARM in 64 bits `br x3` ends a switch, a computed `goto`, or a function whose last call is
/// through a pointer. It is such a call if x3 was loaded from memory or is the address of a
/// function on each way to it, or the function was called with it: a switch adds something to an
/// address.
class PointerJumps {
 public:
  /// All must outlive it: the code by address, where the function of an address begins (0: there is
  /// none), and the words that are loaded.
  PointerJumps(const std::vector<Instruction>& code, const StartOf& start_of,
               const std::set<uint64_t>& words);

  /// Whether the instruction in that place certainly leads to another function.
  [[nodiscard]] bool leaves(uint32_t place) const;

 private:
  /// A register before an instruction.
  struct Held {
    uint32_t place;
    uint8_t number;
    auto operator<=>(const Held&) const = default;
  };

  [[nodiscard]] bool mayGoto(uint32_t place) const;
  [[nodiscard]] bool ofFunction(const Instruction& one) const;
  [[nodiscard]] bool before(const Held& held, std::vector<Held>& earlier) const;
  [[nodiscard]] bool through(const Held& held, std::vector<Held>& earlier) const;

  const std::vector<Instruction>& code_;
  const StartOf& start_of_;
  const std::set<uint64_t>& words_;
  std::multimap<uint64_t, uint32_t> jumps_;  // places, by target
};

}  // namespace glider::codegen
