// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/budget/strongly_connected.h"

#include <algorithm>

namespace glider::codegen {
namespace {

constexpr uint32_t kNone = UINT32_MAX;

struct Visit {
  uint32_t node = 0;
  size_t next = 0;
};

}  // namespace

Circles::Circles(const std::vector<std::vector<uint32_t>>& next) : of_(next.size(), kNone) {
  std::vector<uint32_t> met(next.size(), kNone), lowest(next.size());
  std::vector<uint32_t> open;
  std::vector<Visit> way;
  uint32_t count = 0;
  auto enter = [&](uint32_t node) {
    met[node] = lowest[node] = count++;
    open.push_back(node);
    way.push_back({node, 0});
  };
  auto close = [&](uint32_t root) {
    std::vector<uint32_t> component;
    while (component.empty() || component.back() != root) {
      component.push_back(open.back());
      of_[open.back()] = static_cast<uint32_t>(list_.size());
      open.pop_back();
    }
    const bool to_itself = std::ranges::find(next[root], root) != next[root].end();
    turns_.push_back(component.size() > 1 || to_itself);
    list_.push_back(std::move(component));
  };
  for (uint32_t start = 0; start < next.size(); ++start) {
    if (met[start] == kNone) {
      enter(start);
    }
    while (!way.empty()) {
      Visit& visit = way.back();
      const uint32_t node = visit.node;
      if (visit.next < next[node].size()) {
        const uint32_t to = next[node][visit.next++];
        if (met[to] == kNone) {
          enter(to);
        } else if (of_[to] == kNone) {
          lowest[node] = std::min(lowest[node], met[to]);
        }
        continue;
      }
      way.pop_back();
      if (!way.empty()) {
        lowest[way.back().node] = std::min(lowest[way.back().node], lowest[node]);
      }
      if (lowest[node] == met[node]) {
        close(node);
      }
    }
  }
}

}  // namespace glider::codegen
