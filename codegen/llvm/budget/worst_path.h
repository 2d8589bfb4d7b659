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

/// How often a loop of a function turns at most, each time that it is begun.
struct Turns {
  uint64_t outer = 0;  ///< 0: nobody says
  uint64_t inner = 0;  ///< of a loop within a loop; 0: there is none
};

/// What the machine code alone does not say.
struct Knowledge {
  std::function<Turns(const Frame&)> turns;
  /// The functions that a call through a pointer made from these frames may reach.
  std::function<std::vector<uint64_t>(const std::vector<Frame>&)> pointers;
  /// Whether the function of this name is never called.
  std::function<bool(const std::string&)> never;
};

/// Bounds how many instructions a call takes at most, on linked machine code. README.md says how.
/// Whatever it cannot follow leaves the bound unknown: it never guesses.
class WorstPath {
 public:
  WorstPath(const Image& image, Knowledge knowledge);
  /// Of a call of the function at `entry`; or why there is no bound.
  std::expected<uint64_t, std::string> bound(uint64_t entry);

 private:
  const Image& image_;
  Knowledge knowledge_;
  std::map<uint64_t, std::expected<uint64_t, std::string>> known_;  // by entry
};

}  // namespace glider::codegen
