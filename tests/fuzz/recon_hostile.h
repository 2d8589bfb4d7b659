// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/recon/codec.h"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

/// What the fuzzer and the unit test do with hostile bytes.
namespace glider::recon_hostile {

using namespace hooks::recon;
using Bytes = std::vector<uint8_t>;

inline void require(bool condition) {
  if (!condition) {
    std::abort();
  }
}

/// The text of a line from its `#` to what comes before its `*`; nothing if what stands before a
/// line feed is none (hooks/recon/README.md, R1 to R4). Slow.
inline bool slowLine(std::string text, std::string* found) {
  if (text.ends_with('\r')) {
    text.pop_back();
  }
  if (text.size() + 1 > 1024 || text.size() < 4 || text[text.size() - 3] != '*') {
    return false;
  }
  const std::string hex = text.substr(text.size() - 2);
  const std::string body = text.substr(0, text.size() - 2);
  if (hex.find_first_not_of("0123456789ABCDEF") != std::string::npos) {
    return false;
  }
  for (size_t begin = body.find('#'); begin != std::string::npos;
       begin = body.find('#', begin + 1)) {
    int sum = 0;
    bool printable = true;
    for (const char c : body.substr(begin)) {
      sum += c;
      printable = printable && c >= 0x20 && c < 0x7F;
    }
    if (printable && sum % 256 == std::stoi(hex, nullptr, 16)) {
      *found = body.substr(begin, body.size() - 1 - begin);
      return true;
    }
  }
  return false;
}

/// What is decoded is encoded to a line that decodes to the same.
template <typename Message>
void requireSame(const Line& line) {
  Message message;
  if (!decode(line, message)) {
    return;
  }
  char once[kMostLine];
  char twice[kMostLine];
  const uint32_t size = encode(message, once, sizeof once);
  if (size == 0) {
    return;  // a text with `#`, or a number with more digits than were read
  }
  LineReader reader;
  Line again;
  bool ended = false;
  for (uint32_t i = 0; i < size; ++i) {
    require(!ended);
    ended = reader.push(static_cast<uint8_t>(once[i]), &again);
  }
  Message same;
  require(ended && again.size + 4 == size && decode(again, same));
  require(encode(same, twice, sizeof twice) == size && std::memcmp(once, twice, size) == 0);
}

inline void requireDecoders(const Line& line) {
#define RECON_MESSAGE(name) requireSame<name>(line);
#include "hooks/recon/messages.def"
#undef RECON_MESSAGE
}

/// The reader finds what the slow one finds, and counts each byte once.
inline void requireReader(const Bytes& bytes) {
  LineReader reader;
  std::string held;
  size_t used = 0;
  for (const uint8_t byte : bytes) {
    Line line;
    const bool ended = reader.push(byte, &line);
    if (byte != '\n') {
      require(!ended);
      held += static_cast<char>(byte);
      continue;
    }
    std::string expected;
    require(ended == (held.size() + 1 <= kMostLine && slowLine(held, &expected)));
    if (ended) {
      require(std::string(line.text, line.size) == expected);
      requireDecoders(line);
      used += held.size() - held.rfind(expected) + 1;
    }
    held.clear();
  }
  require(reader.held() < kMostLine);
  require(used + reader.skippedBytes() + reader.held() == bytes.size());
}

}  // namespace glider::recon_hostile
