// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/fuzz/share_hostile.h"

// libFuzzer: target share_fuzzer; see scripts/soak/fuzz_hooks.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t count) {
  glider::share_hostile::requireOneText({bytes, bytes + count});
  return 0;
}
