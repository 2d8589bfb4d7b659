// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// For readers of the log and for displays; a board only writes the numbers.
namespace glider::runtime {

/// What a failed check `number` has found; null for a number that no check has.
inline const char* checkText(uint32_t number) {
  switch (number) {
#define LOG_CHECK(name, value, text) \
  case value:                        \
    return text;
#include "runtime/log/checks.def"
    default:
      return nullptr;
  }
}

}  // namespace glider::runtime
