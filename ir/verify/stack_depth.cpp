// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/passes.h"

#include <algorithm>
#include <deque>
#include <map>
#include <optional>

namespace glider::ir {
namespace {

constexpr uint32_t kNone = UINT32_MAX;

/// The reached states in an order in which callers come before the called (Kahn's).
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

/// The longest call stacks that begin with a given limit. ir/README.md says why they are a chain of
/// the states' own calls from the state at the bottom, then one for each state that `always` may
/// call, none of which the chains go through.
class Chains {
 public:
  Chains(const Structure& structure, const std::vector<uint32_t>& callers_first, uint32_t limit)
      : length_(structure.size()), next_(structure.size(), kNone) {
    for (const Edge& edge : structure.always.edges) {
      if (edge.call && edge.case_index < limit) {
        interrupts_.emplace(edge.to, edge.case_index);  // the first case that calls it
      }
    }
    for (size_t i = callers_first.size(); i-- > 0;) {
      const uint32_t s = callers_first[i];
      for (const Edge& edge : structure.moves[s].edges) {
        if (edge.call && !interrupts_.contains(edge.to) && length_[edge.to] >= length_[s]) {
          length_[s] = length_[edge.to];
          next_[s] = edge.to;
        }
      }
      ++length_[s];
    }
    for (const auto& [target, number] : interrupts_) {
      by_always_ += length_[target];
    }
  }

  /// Of the longest stack that has `root` at its bottom: how many states.
  [[nodiscard]] uint32_t states(uint32_t root) const {
    return by_always_ + (interrupts_.contains(root) ? 0 : length_[root]);
  }

  /// Those states, outermost first.
  [[nodiscard]] std::vector<StateId> path(uint32_t root) const {
    std::vector<std::pair<uint32_t, uint32_t>> interrupts;  // number, target
    for (const auto& [target, number] : interrupts_) {
      if (target != root) {
        interrupts.emplace_back(number, target);
      }
    }
    std::ranges::sort(interrupts, std::greater());
    std::vector<StateId> path;
    append(root, path);
    for (const auto& [number, target] : interrupts) {
      append(target, path);
    }
    return path;
  }

 private:
  void append(uint32_t state, std::vector<StateId>& path) const {
    for (; state != kNone; state = next_[state]) {
      path.push_back({state});
    }
  }

  std::vector<uint32_t> length_;  ///< of the longest chain of own calls from each state
  std::vector<uint32_t> next_;    ///< what it calls in that chain
  std::map<uint32_t, uint32_t> interrupts_;
  uint32_t by_always_ = 0;
};

}  // namespace

void passes::stackDepth(Verification& v) {
  if (v.recursive) {
    return;
  }
  const std::vector<uint32_t> callers_first = callersFirst(v.structure);
  std::map<uint32_t, Chains> by_limit;
  uint32_t most = 0;
  for (uint32_t s : v.structure.order) {
    const std::optional<uint32_t> limit = v.structure.rootLimit(s);
    if (!limit) {
      continue;
    }
    const Chains& chains =
        by_limit.try_emplace(*limit, v.structure, callers_first, *limit).first->second;
    if (chains.states(s) > most) {
      most = chains.states(s);
      v.facts.deepest_path = chains.path(s);
    }
  }
  v.facts.stack_depth = most - 1;
}

}  // namespace glider::ir
