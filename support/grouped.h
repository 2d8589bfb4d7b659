// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace glider::support {

/// 1234567 as "1,234,567".
inline std::string grouped(uint64_t number) {
  constexpr size_t kGroup = 3;
  std::string text = std::to_string(number);
  for (size_t at = text.size(); at > kGroup;) {
    at -= kGroup;
    text.insert(at, ",");
  }
  return text;
}

}  // namespace glider::support
