// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Reads lines of RECON and counts those that it writes again as they were.

#include "hooks/recon/codec.h"

#include <stdio.h>
#include <string.h>

namespace {

using namespace glider::hooks::recon;

constexpr const char* kLines[] = {
    "#C,Heading,Goal,90.000000,*2A\n",
    "#C,Speed,1.500000 meters/sec,*A3\n",
    "#C,Depth,Depth,10.000000,*D9\n",
    "#C,Depth,Triangle,3.000000,3.000000,10.000000,30.000000,*51\n",
    "#E,1,*1B\n",
    "#V,0.000000,*79\n",
    "#s,Time,query,*09\n",
};

uint32_t writtenAgain(const Line& line, char* bytes) {
#define RECON_MESSAGE(name)                   \
  if (name message; decode(line, message)) {  \
    return encode(message, bytes, kMostLine); \
  }
#include "hooks/recon/messages.def"
#undef RECON_MESSAGE
  return 0;
}

bool isSame(const char* text) {
  LineReader reader;
  Line line;
  char again[kMostLine];
  const size_t size = strlen(text);
  bool ended = false;
  for (size_t i = 0; i < size; ++i) {
    ended = reader.push(static_cast<uint8_t>(text[i]), &line);
  }
  return ended && writtenAgain(line, again) == size && memcmp(again, text, size) == 0;
}

}  // namespace

int main() {
  unsigned same = 0;
  for (const char* line : kLines) {
    same += isSame(line) ? 1 : 0;
  }
  printf("%u of %u lines\n", same, static_cast<unsigned>(sizeof kLines / sizeof kLines[0]));
  return 0;
}
