// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/budget/image.h"

#include <cstdint>
#include <expected>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace glider::codegen {

/// Upper bounds of the iterations of a function's loops, each time that one is begun.
struct Turns {
  uint64_t outer = 0;  ///< 0: not known
  uint64_t inner = 0;  ///< of a nested loop; 0: there is none
};

/// What the machine code alone does not say.
struct Knowledge {
  std::function<Turns(const Frame&)> turns;
  /// The functions that a call through a pointer made from these frames may reach.
  std::function<std::vector<uint64_t>(const std::vector<Frame>&)> pointers;
  /// Whether the function of this name is never called.
  std::function<bool(const std::string&)> never;
};

/// Computes an upper bound of the instructions that a call takes, on linked machine code. README.md
/// says how. If it cannot follow something, the bound is unknown: it never guesses.
class WorstPath {
 public:
  WorstPath(const Image& image, Knowledge knowledge);
  /// For a call of the function at `entry`; or why there is no bound.
  std::expected<uint64_t, std::string> bound(uint64_t entry);

 private:
  const Image& image_;
  Knowledge knowledge_;
  std::map<uint64_t, std::expected<uint64_t, std::string>> known_;  // by entry
};

}  // namespace glider::codegen
