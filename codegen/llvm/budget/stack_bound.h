// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/budget/flow_graph.h"
#include "codegen/llvm/budget/image.h"

#include <cstdint>
#include <expected>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace glider::codegen {

/// What the machine code alone does not say of calls.
struct CallKnowledge {
  /// The functions that the call through a pointer at this address may reach.
  std::function<std::vector<uint64_t>(uint64_t)> pointers;
  /// How many calls of the function of this name there are at most at one time; 1 but for what
  /// calls itself.
  std::function<uint64_t(const std::string&)> at_once;
};

/// Bounds the bytes of stack that a call takes at most, on linked machine code. README.md says how.
/// Whatever it cannot follow leaves the bound unknown: it never guesses.
class StackBound {
 public:
  /// Of what one call needs, and how it ends.
  struct Call {
    uint64_t bytes = 0;         ///< below where the stack pointer is as it begins
    std::vector<uint64_t> way;  ///< the functions on the deepest way, this one first
    uint32_t released = 0;      ///< what it takes off the stack as it returns
    bool returns = false;
  };
  using Bound = std::expected<Call, std::string>;

  StackBound(const Image& image, const StackMachine& machine, CallKnowledge knowledge);
  /// Of a call of the function at `entry`, without the return address of that call; or why there is
  /// no bound.
  Bound bound(uint64_t entry);

 private:
  class Walk;
  Bound walk(uint64_t entry);

  const Image& image_;
  const StackMachine& machine_;
  CallKnowledge knowledge_;
  std::map<uint64_t, Bound> known_;  // by entry
};

}  // namespace glider::codegen
