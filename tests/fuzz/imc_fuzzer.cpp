// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/imc/crc.h"
#include "tests/fuzz/imc_hostile.h"

namespace {

using namespace glider::imc_hostile;

/// The bytes with the right CRC where a packet would end that may begin in them: by chance it is
/// hardly ever there.
Bytes withCrcs(const Bytes& bytes) {
  Bytes repaired = bytes;
  for (size_t at = 0; at + kHeaderBytes + kCrcBytes <= repaired.size(); ++at) {
    for (const ByteOrder order : {ByteOrder::Little, ByteOrder::Big}) {
      const size_t covered = kHeaderBytes + numberAt(repaired.data() + at + 4, 2, order);
      if (numberAt(repaired.data() + at, 2, order) == kSync &&
          at + covered + kCrcBytes <= repaired.size()) {
        const uint16_t crc = crc16Arc(repaired.data() + at, static_cast<uint32_t>(covered));
        const bool big = order == ByteOrder::Big;
        repaired[at + covered] = static_cast<uint8_t>(big ? crc >> 8U : crc & 0xFFU);
        repaired[at + covered + 1] = static_cast<uint8_t>(big ? crc & 0xFFU : crc >> 8U);
      }
    }
  }
  return repaired;
}

}  // namespace

// libFuzzer: target imc_fuzzer; see scripts/soak/fuzz_hooks.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t count) {
  const Bytes input(bytes, bytes + count);
  const size_t piece = count == 0 ? 1 : 1 + bytes[0];
  requireReader(input, piece);
  requireReader(withCrcs(input), piece);
  requireDecoders(input);
  return 0;
}
