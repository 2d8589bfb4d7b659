// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/passes.h"

#include <algorithm>
#include <optional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

namespace glider::ir {
namespace {

constexpr uint32_t kNoState = UINT32_MAX;

/// The lengths of the longest call stacks, by the limit that they begin with. ir/README.md says why
/// they are a chain of the states' own calls from the state at the bottom, then one for each state
/// that `always` may call, which the chains do not go through. The limit rises from 0, and with it
/// the number of states that `always` may call: then only the chains that went through one of these
/// are computed again.
class Chains {
 public:
  Chains(const Structure& structure, std::span<const uint32_t> callers_first)
      : s_(structure),
        order_(callers_first),
        place_(structure.size()),
        length_(structure.size(), 1),
        interrupting_(structure.size()),
        callers_(structure.size()) {
    for (size_t i = order_.size(); i-- > 0;) {
      const uint32_t state = order_[i];
      place_[state] = i;
      length_[state] = 1 + longestCalled(state).second;
      for (const Edge& edge : s_.moves[state].edges) {
        if (edge.call) {
          callers_[edge.to].push_back(state);
        }
      }
    }
  }

  /// Raises the limit, which never decreases.
  void raise(uint32_t limit) {
    const std::vector<Edge>& edges = s_.always.edges;
    std::priority_queue<size_t> changed;  // places of states, called states first
    for (; next_ < edges.size() && edges[next_].case_index < limit; ++next_) {
      const uint32_t target = edges[next_].to;
      if (edges[next_].call && !interrupting_[target]) {
        interrupting_[target] = true;
        by_always_ += length_[target];
        addCallers(target, changed);
      }
    }
    shorten(changed);
  }

  /// The number of states in the longest stack that has `root` at its bottom.
  [[nodiscard]] uint32_t states(uint32_t root) const {
    return by_always_ + (interrupting_[root] ? 0 : length_[root]);
  }

  /// Those states, outermost first; of those that `always` calls, the last case first.
  [[nodiscard]] std::vector<StateId> path(uint32_t root) const {
    std::vector<uint32_t> bottoms;
    std::vector<bool> told(s_.size());
    told[root] = true;
    for (const Edge& edge : std::span(s_.always.edges).first(next_)) {
      if (edge.call && !told[edge.to]) {
        told[edge.to] = true;
        bottoms.push_back(edge.to);
      }
    }
    bottoms.push_back(root);
    std::vector<StateId> path;
    for (size_t i = bottoms.size(); i-- > 0;) {
      for (uint32_t s = bottoms[i]; s != kNoState; s = longestCalled(s).first) {
        path.push_back({s});
      }
    }
    return path;
  }

 private:
  /// The state with the longest chain that a state itself calls, and its length; kNoState and 0 if
  /// there is none.
  [[nodiscard]] std::pair<uint32_t, uint32_t> longestCalled(uint32_t state) const {
    std::pair<uint32_t, uint32_t> longest = {kNoState, 0};
    for (const Edge& edge : s_.moves[state].edges) {
      if (edge.call && !interrupting_[edge.to] && length_[edge.to] >= longest.second) {
        longest = {edge.to, length_[edge.to]};
      }
    }
    return longest;
  }

  void addCallers(uint32_t state, std::priority_queue<size_t>& changed) const {
    for (uint32_t caller : callers_[state]) {
      changed.push(place_[caller]);
    }
  }

  /// Computes the chains of states that call a changed state again.
  void shorten(std::priority_queue<size_t>& changed) {
    while (!changed.empty()) {
      const size_t place = changed.top();
      while (!changed.empty() && changed.top() == place) {
        changed.pop();
      }
      const uint32_t state = order_[place];
      const uint32_t length = 1 + longestCalled(state).second;
      if (length != length_[state]) {
        by_always_ -= interrupting_[state] ? length_[state] - length : 0;
        length_[state] = length;
        addCallers(state, changed);
      }
    }
  }

  const Structure& s_;
  std::span<const uint32_t> order_;
  std::vector<size_t> place_;     ///< of a state in the order
  std::vector<uint32_t> length_;  ///< of the longest chain of own calls from each state
  std::vector<bool> interrupting_;
  std::vector<std::vector<uint32_t>> callers_;
  size_t next_ = 0;  ///< the first case of `always` that the limit excludes
  uint32_t by_always_ = 0;
};

/// A state that meets an empty stack.
struct Root {
  uint32_t limit = 0;  ///< the greatest limit with which it does
  size_t place = 0;    ///< among the reached states: of equally deep stacks the nearest is reported
  uint32_t state = 0;
};

std::vector<Root> rootsByLimit(const Structure& structure) {
  std::vector<Root> roots;
  for (size_t place = 0; place < structure.order.size(); ++place) {
    const uint32_t state = structure.order[place];
    if (const std::optional<uint32_t> limit = structure.rootLimit(state)) {
      roots.push_back({*limit, place, state});
    }
  }
  std::ranges::sort(roots, {}, &Root::limit);
  return roots;
}

}  // namespace

void passes::stackDepth(Verification& v) {
  if (v.recursive) {
    return;
  }
  const std::vector<uint32_t> callers_first = callersFirst(v.structure);
  const std::vector<Root> roots = rootsByLimit(v.structure);
  Chains chains(v.structure, callers_first);
  uint32_t most = 0;
  Root deepest;
  for (const Root& root : roots) {
    chains.raise(root.limit);
    const uint32_t states = chains.states(root.state);
    if (states > most || (states == most && root.place < deepest.place)) {
      most = states;
      deepest = root;
    }
  }
  Chains its_own(v.structure, callers_first);
  its_own.raise(deepest.limit);
  v.facts.deepest_path = its_own.path(deepest.state);
  v.facts.stack_depth = most - 1;
}

}  // namespace glider::ir
