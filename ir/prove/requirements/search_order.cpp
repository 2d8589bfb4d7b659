// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/requirements/search_order.h"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <utility>

namespace glider::ir::prove {
namespace {

/// The middle one, then the middle of each half, and so on.
std::vector<uint32_t> middleFirst(const std::vector<uint32_t>& sorted) {
  std::vector<uint32_t> middle_first;
  std::deque<std::pair<size_t, size_t>> parts{{0, sorted.size()}};
  for (; !parts.empty(); parts.pop_front()) {
    const auto [from, to] = parts.front();
    if (from < to) {
      const size_t middle = (from + to) / 2;
      middle_first.push_back(sorted[middle]);
      parts.emplace_back(from, middle);
      parts.emplace_back(middle + 1, to);
    }
  }
  return middle_first;
}

}  // namespace

std::vector<uint32_t> searchOrder(std::vector<uint32_t> waiting,
                                  const std::vector<Requirement>& requirements) {
  const auto surfaces = [&](uint32_t i) {
    return requirements[i].kind == RequirementKind::SurfacesEvery;
  };
  std::vector<uint32_t> surfacing;
  std::ranges::copy_if(waiting, std::back_inserter(surfacing), surfaces);
  std::ranges::stable_sort(surfacing, {}, [&](uint32_t i) { return requirements[i].seconds; });
  const std::vector<uint32_t> middle_first = middleFirst(surfacing);
  size_t next = 0;
  for (uint32_t& number : waiting) {
    if (surfaces(number)) {
      number = middle_first[next++];
    }
  }
  return waiting;
}

}  // namespace glider::ir::prove
