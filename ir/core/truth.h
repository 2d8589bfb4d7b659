// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>

namespace glider::ir {

/// Kleene's three values.
enum class Truth : uint8_t { False, True, Unknown };

constexpr Truth truth(bool value) {
  return value ? Truth::True : Truth::False;
}

constexpr Truth logicalNot(Truth a) {
  return a == Truth::Unknown ? Truth::Unknown : truth(a == Truth::False);
}

constexpr Truth logicalAnd(Truth a, Truth b) {
  if (a == Truth::False || b == Truth::False) {
    return Truth::False;
  }
  return a == Truth::True && b == Truth::True ? Truth::True : Truth::Unknown;
}

constexpr Truth logicalOr(Truth a, Truth b) {
  if (a == Truth::True || b == Truth::True) {
    return Truth::True;
  }
  return a == Truth::False && b == Truth::False ? Truth::False : Truth::Unknown;
}

}  // namespace glider::ir
