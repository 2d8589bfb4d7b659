// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/micro_modem/codec.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

/// What the fuzzer and the unit test do with hostile bytes.
namespace glider::micro_modem_hostile {

using namespace hooks::micro_modem;

inline void require(bool condition) {
  if (!condition) {
    std::abort();
  }
}

/// Whether it can be the body of a sentence.
inline bool isPlain(const Text& body) {
  return std::all_of(body.bytes, body.bytes + body.size,
                     [](char c) { return c >= ' ' && c <= '~' && c != '$' && c != '*'; });
}

/// What is decoded is encoded to a sentence that decodes to the same.
template <typename Message>
bool requireSame(const Text& body) {
  Message message;
  if (!decode(body, message)) {
    return false;
  }
  char once[1100];
  char twice[1100];
  const uint32_t size = encode(message, once, sizeof once);
  if (size == 0) {
    require(!isPlain(body));  // the reader gives no other
    return true;
  }
  SentenceReader reader;
  int ended = 0;
  for (uint32_t i = 0; i < size; ++i) {
    ended += reader.push(static_cast<uint8_t>(once[i])) ? 1 : 0;
  }
  Message same;
  require(ended == 1 && reader.bad() == 0 && decode(reader.text(), same));
  require(encode(same, twice, sizeof twice) == size && std::memcmp(once, twice, size) == 0);
  return true;
}

/// A body is at most one message.
inline void requireDecoders(const Text& body) {
  int messages = 0;
#define MODEM_SENTENCE(name) messages += requireSame<name>(body) ? 1 : 0;
#include "hooks/micro_modem/messages.def"
#undef MODEM_SENTENCE
  require(messages <= 1);
}

/// The bodies of a stream (hooks/micro_modem/README.md, M1 and M2), found in the whole. Slow.
inline std::vector<std::string> slowBodies(const std::string& bytes) {
  std::vector<std::string> bodies;
  for (size_t begin = bytes.find('$'); begin != std::string::npos;
       begin = bytes.find('$', begin + 1)) {
    const std::string rest = bytes.substr(begin + 1, bytes.find('$', begin + 1) - begin - 1);
    const size_t star = rest.find('*');
    if (star == std::string::npos || star > 1000 || rest.size() < star + 3 ||
        rest.find_first_not_of("0123456789ABCDEFabcdef", star + 1) < star + 3) {
      continue;
    }
    int sum = 0;
    bool printable = true;
    for (const char c : rest.substr(0, star)) {
      sum ^= c;
      printable = printable && c >= 0x20 && c < 0x7F;
    }
    if (printable && sum == std::stoi(rest.substr(star + 1, 2), nullptr, 16)) {
      bodies.push_back(rest.substr(0, star));
    }
  }
  return bodies;
}

/// The reader finds what the slow one finds.
inline void requireReader(const std::string& bytes) {
  SentenceReader reader;
  std::vector<std::string> bodies;
  for (const char byte : bytes) {
    if (reader.push(static_cast<uint8_t>(byte))) {
      bodies.emplace_back(reader.body(), reader.size());
      requireDecoders(reader.text());
    }
  }
  require(bodies == slowBodies(bytes));
}

}  // namespace glider::micro_modem_hostile
