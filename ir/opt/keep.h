// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace glider::ir::opt {

/// Keeps the marked elements; returns the new number of each, UINT32_MAX of those that are dropped.
template <typename T>
std::vector<uint32_t> keep(std::vector<T>& elements, const std::vector<bool>& marked) {
  std::vector<uint32_t> numbers(elements.size(), UINT32_MAX);
  uint32_t count = 0;
  for (size_t i = 0; i < elements.size(); ++i) {
    if (marked[i]) {
      numbers[i] = count;
      if (count != i) {
        elements[count] = std::move(elements[i]);
      }
      ++count;
    }
  }
  elements.resize(count);
  return numbers;
}

}  // namespace glider::ir::opt
