// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/budget/stack_effect.h"

#include <array>
#include <cstdint>
#include <optional>

namespace glider::codegen {

/// How deep the stack is at most where an instruction begins, from where its function began.
class StackState {
 public:
  StackState(const StackMachine& machine, int64_t depth) : machine_(&machine) {
    depths_[machine.pointer] = depth;
  }

  /// Nothing if nobody can tell.
  [[nodiscard]] std::optional<int64_t> depth() const { return depths_[machine_->pointer]; }
  /// As an instruction carried out under a condition finds it, after those under the same one.
  [[nodiscard]] StackState under(const StackEffect& effect) const;
  /// As its successor finds it if the condition does not hold.
  [[nodiscard]] StackState passing(const StackEffect& effect) const;
  /// After an instruction.
  void apply(const StackEffect& effect);
  /// After a call that takes `released` bytes off the stack as it returns.
  void call(uint32_t released);
  /// What holds if either does; true if that is news.
  bool join(const StackState& other);

 private:
  void change(const StackEffect& effect);
  void settle();

  const StackMachine* machine_;
  std::array<std::optional<int64_t>, 16> depths_;
  // ARM: the stack pointer if the condition of the last instructions holds.
  std::optional<int64_t> conditional_;
  StackEffect condition_;
};

}  // namespace glider::codegen
