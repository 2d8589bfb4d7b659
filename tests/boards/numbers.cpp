// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Says the digest of runtime/numbers, which is the same on every board.

#include "runtime/board/arithmetic.h"
#include "tests/unit/runtime/numbers_samples.h"

#include <stdio.h>
#include <stdlib.h>

int main(int argc, char** argv) {
  glider::runtime::useDoublePrecision();
  if (argc != 2) {
    return 1;
  }
  const auto rounds = static_cast<uint32_t>(strtoul(argv[1], nullptr, 10));
  printf("%llu\n", static_cast<unsigned long long>(glider::numbers_samples::digestOf(rounds)));
  return 0;
}
