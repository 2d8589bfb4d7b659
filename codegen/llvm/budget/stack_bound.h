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
#include <utility>
#include <vector>

namespace glider::codegen {

/// What the machine code alone does not say about calls.
struct CallKnowledge {
  /// The functions that the call through a pointer at this address may reach, but none of the
  /// groups that are excluded (a bit each).
  std::function<std::vector<uint64_t>(uint64_t, uint32_t)> pointers;
  /// The groups of which no function is called through a pointer while that at this address is
  /// active.
  std::function<uint32_t(uint64_t)> excluded;
  /// The upper bound of calls of the named function that are active at one time; 1 unless it calls
  /// itself.
  std::function<uint64_t(const std::string&)> at_once;
};

/// Computes an upper bound of the bytes of stack that a call takes, on linked machine code.
/// README.md says how. If it cannot follow something, the bound is unknown: it never guesses.
class StackBound {
 public:
  /// What one call needs, and how it ends.
  struct Call {
    uint64_t bytes = 0;         ///< below the stack pointer at its beginning
    std::vector<uint64_t> way;  ///< the functions on the deepest path, this one first
    uint32_t released = 0;      ///< bytes that it takes off the stack when it returns
    bool returns = false;
  };
  using Bound = std::expected<Call, std::string>;

  StackBound(const Image& image, const StackMachine& machine, CallKnowledge knowledge);
  /// For a call of the function at `entry`, without the return address of that call; or the reason
  /// why there is none.
  Bound bound(uint64_t entry);

 private:
  class Walk;
  Bound bound(uint64_t entry, uint32_t excluded);
  Bound walk(uint64_t entry, uint32_t excluded);

  const Image& image_;
  const StackMachine& machine_;
  CallKnowledge knowledge_;
  std::map<std::pair<uint64_t, uint32_t>, Bound> known_;  // by entry and excluded groups
};

}  // namespace glider::codegen
