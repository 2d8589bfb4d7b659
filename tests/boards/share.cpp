// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Reads messages of shares, counts those that it writes again as they were, and adds up the bits of
// their values.

#include "hooks/protocol/crc.h"
#include "hooks/share/message.h"
#include "runtime/board/arithmetic.h"

#include <stdio.h>
#include <string.h>

namespace {

using namespace glider::hooks::share;

constexpr Scale kScales[] = {{0, 0.1, 2001}, {-7.3, 1.0 / 3, 601}, {38.25, 1e-4, 20001}, {0, 1, 2}};
constexpr uint32_t kCount = sizeof kScales / sizeof kScales[0];
constexpr uint8_t kSignature = 0xC3;
constexpr uint32_t kMessages = 1000;

/// A message with values that a small generator gives.
void make(uint32_t* state, uint8_t* bytes, uint32_t size) {
  MessageWriter writer;
  for (uint32_t i = kCount; i != 0; --i) {
    *state = *state * 1664525U + 1013904223U;
    writer.put(kScales[i - 1],
               valueOf(kScales[i - 1], (*state >> 8) % (kScales[i - 1].values + 1)));
  }
  (void)writer.end(kSignature, bytes, size);
}

/// Whether the message is written again as it is; adds its values to `check`.
bool isSame(const uint8_t* bytes, uint32_t size, uint32_t* check) {
  MessageReader reader(bytes, size);
  double values[kCount];
  for (uint32_t i = 0; i < kCount; ++i) {
    values[i] = reader.take(kScales[i]);
    const double known = values[i] == values[i] ? values[i] : 0;
    uint64_t bits = 0;
    memcpy(&bits, &known, sizeof bits);
    for (uint32_t shift = 0; shift < 64; shift += 8) {
      const auto byte = static_cast<uint8_t>(bits >> shift);
      *check = glider::hooks::crc32c(&byte, 1, *check);
    }
  }
  MessageWriter writer;
  for (uint32_t i = kCount; i != 0; --i) {
    writer.put(kScales[i - 1], values[i - 1]);
  }
  uint8_t again[Number::kMostBytes];
  return reader.end(kSignature, size) && writer.end(kSignature, again, size) &&
         memcmp(again, bytes, size) == 0;
}

}  // namespace

int main() {
  glider::runtime::useDoublePrecision();
  const uint32_t size = sizeOf(kScales, kCount).bytes;
  uint32_t state = 1, check = 0;
  unsigned same = 0;
  for (uint32_t i = 0; i < kMessages; ++i) {
    uint8_t bytes[Number::kMostBytes];
    make(&state, bytes, size);
    same += isSame(bytes, size, &check) ? 1 : 0;
  }
  printf("%u of %u messages, %08x\n", same, static_cast<unsigned>(kMessages),
         static_cast<unsigned>(check));
  return 0;
}
