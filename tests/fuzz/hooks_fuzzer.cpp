// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/fuzz/hooks_hostile.h"

// libFuzzer: cmake -DGLIDER_FUZZ=ON, target hooks_fuzzer, then build/tests/hooks_fuzzer
// -max_total_time=60
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t count) {
  glider::hooks::feedEverything(bytes, static_cast<uint32_t>(count));
  return 0;
}
