// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/budget/image.h"

#include <cstdint>
#include <expected>
#include <set>
#include <string>
#include <vector>

namespace glider::codegen {

/// Whether the next instruction may follow one of that kind.
bool goesOn(Flow flow);

/// The instructions that are reached from an entry without calls, and which may follow which.
struct FlowGraph {
  std::vector<uint32_t> instructions;       ///< places in Image::code(); the entry is node 0
  std::vector<std::vector<uint32_t>> next;  ///< by node

  std::set<uint32_t> lost;  ///< nodes that may lead to an unknown place

  /// The graph, or why it cannot be followed.
  static std::expected<FlowGraph, std::string> follow(const Image& image, uint64_t entry);
  /// The same, but lost nodes are allowed: a call that never returns has nothing after it.
  static std::expected<FlowGraph, std::string> asFarAsKnown(const Image& image, uint64_t entry);
  /// A text for people: that the instruction at `address` is lost.
  static std::string whyLost(const Image& image, uint64_t address);
};

}  // namespace glider::codegen
