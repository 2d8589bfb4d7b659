// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/fuzz/recon_hostile.h"

namespace {

using namespace glider::recon_hostile;

/// The bytes with the right sum where a line ends: by chance it is hardly ever there.
Bytes withSums(const Bytes& bytes) {
  static constexpr char kHex[] = "0123456789ABCDEF";
  Bytes repaired;
  uint8_t sum = 0;
  for (const uint8_t byte : bytes) {
    sum = byte == '#' ? 0 : sum;
    sum = static_cast<uint8_t>(sum + byte);
    repaired.push_back(byte);
    if (byte == '*') {
      repaired.push_back(static_cast<uint8_t>(kHex[sum >> 4]));
      repaired.push_back(static_cast<uint8_t>(kHex[sum & 0xF]));
      repaired.push_back('\n');
    }
  }
  return repaired;
}

}  // namespace

// libFuzzer: target recon_fuzzer; see scripts/soak/fuzz_hooks.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t count) {
  const Bytes input(bytes, bytes + count);
  requireReader(input);
  requireReader(withSums(input));
  requireDecoders({reinterpret_cast<const char*>(bytes), static_cast<uint32_t>(count)});
  return 0;
}
