// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/fuzz/hooks_hostile.h"

// libFuzzer: target hooks_fuzzer; see scripts/soak/fuzz_hooks.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t count) {
  glider::hooks::feedEverything(bytes, static_cast<uint32_t>(count));
  return 0;
}
