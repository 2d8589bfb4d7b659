// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Reads real packets of IMC, in both byte orders, and counts those that it writes again as they
// were.

#include "hooks/imc/codec.h"
#include "hooks/imc/packet_reader.h"
#include "tests/unit/hooks/imc_samples.h"

#include <stdio.h>
#include <string.h>

namespace {

using namespace glider::hooks::imc;
using namespace glider::imc_samples;

uint32_t writtenAgain(const Packet& packet, uint8_t* bytes) {
#define MESSAGE(name, number)                                                                \
  if (packet.id == (number)) {                                                               \
    name message;                                                                            \
    return decode(packet, message) ? encode(packet.header, message, bytes, kMostPacket) : 0; \
  }
#define FIELD(type, name)
#define MESSAGE_END
#include "hooks/imc/messages.def"
  return 0;
}

bool isSame(const char* hex, const char* little) {
  uint8_t bytes[kMostSample];
  uint8_t expected[kMostSample];
  uint8_t again[kMostPacket];
  const uint32_t size = bytesOf(hex, bytes);
  PacketReader reader;
  Packet packet;
  return reader.push(bytes, size) == size && reader.next(&packet) &&
         writtenAgain(packet, again) == size && bytesOf(little, expected) == size &&
         memcmp(again, expected, size) == 0;
}

}  // namespace

int main() {
  unsigned same = 0;
  for (const Sample& sample : kSamples) {
    same += isSame(sample.little, sample.little) ? 1 : 0;
    same += isSame(sample.big, sample.little) ? 1 : 0;
  }
  printf("%u of %u packets\n", same, 2 * static_cast<unsigned>(kSampleCount));
  return 0;
}
