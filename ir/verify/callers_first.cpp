// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/passes.h"

namespace glider::ir {

/// Kahn's algorithm.
std::vector<uint32_t> callersFirst(const Structure& structure) {
  std::vector<uint32_t> open(structure.size());
  auto calls = [&](uint32_t s, auto visit) {
    for (const Edge& edge : structure.moves[s].edges) {
      if (edge.call) {
        visit(edge.to);
      }
    }
  };
  for (uint32_t s : structure.order) {
    calls(s, [&](uint32_t to) { ++open[to]; });
  }
  std::vector<uint32_t> sorted;
  for (uint32_t s : structure.order) {
    if (open[s] == 0) {
      sorted.push_back(s);
    }
  }
  for (size_t i = 0; i < sorted.size(); ++i) {
    calls(sorted[i], [&](uint32_t to) {
      if (--open[to] == 0) {
        sorted.push_back(to);
      }
    });
  }
  return sorted;
}

}  // namespace glider::ir
