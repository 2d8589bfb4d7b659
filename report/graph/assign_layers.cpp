// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/graph/layered.h"

#include <algorithm>
#include <utility>

namespace glider::report::layered {
namespace {

constexpr uint32_t kNone = UINT32_MAX;

/// Pairs of nodes, the first of which comes before the second: the edges, where those that close a
/// cycle are reversed. Cycles are found by a depth-first search from node 0, then from the
/// remaining nodes.
class Acyclic {
 public:
  Acyclic(size_t nodes, const std::vector<Edge>& edges) : out_(nodes), marks_(nodes) {
    for (const Edge& edge : edges) {
      out_[edge.from].push_back(edge.to);
    }
    for (uint32_t node = 0; node < nodes; ++node) {
      walk(node);
    }
  }

  [[nodiscard]] const std::vector<std::pair<uint32_t, uint32_t>>& pairs() const { return pairs_; }
  /// An order in which the first node of each pair comes before its second.
  [[nodiscard]] std::vector<uint32_t> order() const {
    return {finished_.rbegin(), finished_.rend()};
  }

 private:
  enum class Mark : uint8_t { New, Open, Done };

  void walk(uint32_t root) {
    if (marks_[root] != Mark::New) {
      return;
    }
    marks_[root] = Mark::Open;
    std::vector<std::pair<uint32_t, size_t>> open = {{root, 0}};
    while (!open.empty()) {
      const uint32_t node = open.back().first;
      if (open.back().second == out_[node].size()) {
        marks_[node] = Mark::Done;
        finished_.push_back(node);
        open.pop_back();
        continue;
      }
      const uint32_t to = out_[node][open.back().second++];
      pairs_.push_back(marks_[to] == Mark::Open ? std::pair(to, node) : std::pair(node, to));
      if (marks_[to] == Mark::New) {
        marks_[to] = Mark::Open;
        open.emplace_back(to, 0);
      }
    }
  }

  std::vector<std::vector<uint32_t>> out_;
  std::vector<Mark> marks_;
  std::vector<std::pair<uint32_t, uint32_t>> pairs_;
  std::vector<uint32_t> finished_;
};

}  // namespace

std::vector<uint32_t> assignLayers(size_t nodes, const std::vector<Edge>& edges) {
  const Acyclic acyclic(nodes, edges);
  std::vector<std::vector<uint32_t>> after(nodes);
  std::vector<bool> has_before(nodes);
  for (const auto& [first, second] : acyclic.pairs()) {
    after[first].push_back(second);
    has_before[second] = true;
  }
  std::vector<uint32_t> rank(nodes, 0);
  const std::vector<uint32_t> order = acyclic.order();
  for (const uint32_t node : order) {
    for (const uint32_t next : after[node]) {
      rank[next] = std::max(rank[next], rank[node] + 1);
    }
  }
  // A node that nothing leads to is placed immediately before what it leads to.
  for (size_t i = order.size(); i-- > 0;) {
    const uint32_t node = order[i];
    uint32_t nearest = kNone;
    for (const uint32_t next : after[node]) {
      nearest = std::min(nearest, rank[next]);
    }
    if (node != 0 && !has_before[node] && nearest != kNone) {
      rank[node] = nearest - 1;
    }
  }
  for (uint32_t& layer : rank) {
    layer *= 2;  // labels are placed between
  }
  return rank;
}

}  // namespace glider::report::layered
