// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/budget/stack_effect.h"

#include <array>
#include <cstdint>
#include <optional>

namespace glider::codegen {

/// The upper bound of the stack depth at the beginning of an instruction, from the beginning of its
/// function.
class StackState {
 public:
  StackState(const StackMachine& machine, int64_t depth) : machine_(&machine) {
    depths_[machine.pointer] = depth;
  }

  /// Empty if it is not known.
  [[nodiscard]] std::optional<int64_t> depth() const { return depths_[machine_->pointer]; }
  /// The state for an instruction executed under a condition, after those under the same condition.
  [[nodiscard]] StackState under(const StackEffect& effect) const;
  /// The state for its successor if the condition does not hold.
  [[nodiscard]] StackState passing(const StackEffect& effect) const;
  /// Applies an instruction.
  void apply(const StackEffect& effect);
  /// Applies a call that takes `released` bytes off the stack when it returns.
  void call(uint32_t released);
  /// Joins two states; true if that changed this one.
  bool join(const StackState& other);

 private:
  void change(const StackEffect& effect);
  void settle();

  const StackMachine* machine_;
  std::array<std::optional<int64_t>, 32> depths_;
  // ARM: the stack pointer if the condition of the last instructions holds.
  std::optional<int64_t> conditional_;
  StackEffect condition_;
};

}  // namespace glider::codegen
