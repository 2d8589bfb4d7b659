// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <vector>

namespace glider::codegen {

/// The strongly connected components of a directed graph (Tarjan 1972), in linear time and without
/// recursion.
class Circles {
 public:
  /// `next[n]`: the nodes that n leads to.
  explicit Circles(const std::vector<std::vector<uint32_t>>& next);

  /// The components, each after all those that it leads to.
  [[nodiscard]] const std::vector<std::vector<uint32_t>>& list() const { return list_; }
  /// The number of a node's component.
  [[nodiscard]] uint32_t of(uint32_t node) const { return of_[node]; }
  /// Whether component `number` contains a cycle.
  [[nodiscard]] bool turns(uint32_t number) const { return turns_[number]; }

 private:
  std::vector<std::vector<uint32_t>> list_;
  std::vector<uint32_t> of_;
  std::vector<bool> turns_;
};

}  // namespace glider::codegen
