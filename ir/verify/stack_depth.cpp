// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/passes.h"

#include <algorithm>
#include <deque>
#include <iterator>
#include <optional>

namespace glider::ir {
namespace {

/// The longest chain of calls that ends in each state, found in an order in which callers come
/// before the called (Kahn's). Complete only if no state can call itself, however indirectly.
struct Chains {
  std::vector<uint32_t> length;
  std::vector<std::optional<uint32_t>> caller;
  size_t settled = 0;

  explicit Chains(const Structure& structure) : length(structure.size()), caller(structure.size()) {
    std::vector<uint32_t> open(structure.size());
    for (uint32_t s : structure.order) {
      for (const Edge& edge : structure.moves[s].edges) {
        open[edge.to] += edge.call ? 1 : 0;
      }
    }
    std::deque<uint32_t> pending;
    std::ranges::copy_if(structure.order, std::back_inserter(pending),
                         [&](uint32_t s) { return open[s] == 0; });
    while (!pending.empty()) {
      const uint32_t s = pending.front();
      pending.pop_front();
      ++settled;
      for (const Edge& edge : structure.moves[s].edges) {
        if (!edge.call) {
          continue;
        }
        if (length[s] + 1 > length[edge.to]) {
          length[edge.to] = length[s] + 1;
          caller[edge.to] = s;
        }
        if (--open[edge.to] == 0) {
          pending.push_back(edge.to);
        }
      }
    }
  }
};

}  // namespace

/// A state without a caller meets an empty stack, so every chain of calls can come about as it
/// stands.
void passes::stackDepth(Verification& v) {
  const Chains chains(v.structure);
  if (chains.settled < v.structure.order.size()) {
    return;  // a call cycle, which is an error
  }
  const auto deepest = std::ranges::max_element(chains.length);
  v.facts.stack_depth = *deepest;
  std::optional<uint32_t> state = static_cast<uint32_t>(deepest - chains.length.begin());
  for (; state; state = chains.caller[*state]) {
    v.facts.deepest_path.push_back({*state});
  }
  std::ranges::reverse(v.facts.deepest_path);
}

}  // namespace glider::ir
