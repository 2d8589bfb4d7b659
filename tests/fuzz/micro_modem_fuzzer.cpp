// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/fuzz/micro_modem_hostile.h"

namespace {

using namespace glider::micro_modem_hostile;

/// The bytes with the right sum after each `*`: by chance it is hardly ever there.
std::string withSums(const std::string& bytes) {
  static constexpr char kHex[] = "0123456789ABCDEF";
  std::string repaired;
  uint8_t sum = 0;
  for (const char byte : bytes) {
    repaired += byte;
    if (byte == '*') {
      repaired += kHex[sum >> 4];
      repaired += kHex[sum & 0xF];
    }
    sum = byte == '$' ? 0 : static_cast<uint8_t>(sum ^ static_cast<uint8_t>(byte));
  }
  return repaired;
}

}  // namespace

// libFuzzer: target micro_modem_fuzzer; see scripts/soak/fuzz_hooks.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t count) {
  const std::string input(reinterpret_cast<const char*>(bytes), count);
  requireReader(input);
  requireReader(withSums(input));
  requireDecoders({reinterpret_cast<const char*>(bytes), static_cast<uint32_t>(count)});
  return 0;
}
