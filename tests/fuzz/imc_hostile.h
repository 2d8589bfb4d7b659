// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/imc/codec.h"
#include "hooks/imc/packet_reader.h"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <vector>

/// What the fuzzer and the unit test do with hostile bytes.
namespace glider::imc_hostile {

using namespace hooks::imc;
using Bytes = std::vector<uint8_t>;

inline void require(bool condition) {
  if (!condition) {
    std::abort();
  }
}

/// Where a packet was found, and how long it is.
struct Place {
  size_t begin;
  size_t size;
  bool operator==(const Place&) const = default;
};

/// The rules of the reader (hooks/imc/README.md, I4 to I7) over bytes that are all there. Slow.
class SlowReader {
 public:
  explicit SlowReader(const Bytes& bytes) : bytes_(bytes) {}

  std::vector<Place> places() {
    std::vector<Place> found;
    for (size_t at = 0; at + 22 <= bytes_.size();) {
      const size_t size = sizeAt(at);
      if (size != 0 && at + size > bytes_.size()) {
        break;  // the rest may still become this packet
      }
      if (size != 0 && crc(at, size - 2) == number(at + size - 2, 2)) {
        found.push_back({at, size});
        at += size;
      } else {
        ++at;
      }
    }
    return found;
  }

 private:
  /// Of the whole packet that may begin here; 0: none may.
  size_t sizeAt(size_t at) {
    big_ = bytes_[at] == 0xFE && bytes_[at + 1] == 0x54;
    if (!big_ && (bytes_[at] != 0x54 || bytes_[at + 1] != 0xFE)) {
      return 0;
    }
    const uint64_t bits = number(at + 6, 8);
    double time = 0;
    std::memcpy(&time, &bits, sizeof time);
    const bool may = time == 0 || time == -1 || (time >= 1 && time < 17179869184.0);
    const size_t payload = number(at + 4, 2);
    return may && payload <= 1024 ? 20 + payload + 2 : 0;
  }
  [[nodiscard]] uint64_t number(size_t at, size_t width) const {
    uint64_t value = 0;
    for (size_t i = 0; i < width; ++i) {
      value += uint64_t{bytes_[at + i]} << 8 * (big_ ? width - 1 - i : i);
    }
    return value;
  }
  [[nodiscard]] uint64_t crc(size_t at, size_t count) const {
    uint64_t crc = 0;
    for (size_t bit = 0; bit < count * 8; ++bit) {
      crc ^= uint64_t{bytes_[at + bit / 8]} >> bit % 8 & 1U;
      crc = crc % 2 != 0 ? crc / 2 ^ 0xA001U : crc / 2;
    }
    return crc;
  }

  const Bytes& bytes_;
  bool big_ = false;
};

/// The reader finds what the slow one finds, for pieces of this size, and counts each byte once.
inline void requireReader(const Bytes& bytes, size_t piece) {
  const std::vector<Place> expected = SlowReader(bytes).places();
  PacketReader reader;
  std::vector<Place> found;
  size_t used = 0;
  for (size_t at = 0; at < bytes.size();) {
    const size_t left = bytes.size() - at;
    const uint32_t taken =
        reader.push(bytes.data() + at, static_cast<uint32_t>(piece < left ? piece : left));
    require(taken > 0);
    at += taken;
    for (Packet packet; reader.next(&packet);) {
      const size_t size = kHeaderBytes + packet.size + kCrcBytes;
      found.push_back({used + reader.skippedBytes(), size});
      used += size;
    }
    require(reader.held() < kMostPacket);
  }
  require(found == expected);
  require(used + reader.skippedBytes() + reader.held() == bytes.size());
}

/// What a program prints or compares of a text.
inline uint32_t touch(const Text& text) {
  uint32_t sum = 0;
  for (uint32_t i = 0; i < text.size; ++i) {
    sum += static_cast<uint8_t>(text.bytes[i]);
  }
  return sum;
}

/// Touches all texts of a message.
struct Toucher {
  uint32_t sum = 0;
  template <typename Field>
  void take(const Field& field) {
    if constexpr (requires { FieldsOf<decltype(field.value)>::each(*this, field.value); }) {
      FieldsOf<decltype(field.value)>::each(*this, field.value);
    } else if constexpr (requires { touch(field); }) {
      sum += touch(field);
    }
  }
};

/// What is decoded is encoded to a message that decodes to the same, of the same length.
template <typename Message>
void requireSame(const Packet& packet) {
  Message message;
  if (!decode(packet, message)) {
    return;
  }
  Toucher toucher;
  FieldsOf<Message>::each(toucher, message);
  uint8_t once[kMostPacket];
  uint8_t twice[kMostPacket];
  const uint32_t size = encode(packet.header, message, once, sizeof once);
  if constexpr (requires { message.arg; }) {
    if (!message.arg.present && message.arg.id != kNoMessage) {
      require(size == 0);
      return;
    }
  }
  require(size == kHeaderBytes + packet.size + kCrcBytes);
  PacketReader reader;
  Packet again;
  Message same;
  require(reader.push(once, size) == size && reader.next(&again) && decode(again, same));
  require(encode(packet.header, same, twice, sizeof twice) == size);
  require(std::memcmp(once, twice, size) == 0);
}

/// These bytes as the payload of each message, in both orders.
inline void requireDecoders(const Bytes& bytes) {
  if (bytes.size() > kMostPayload) {
    return;
  }
  for (const ByteOrder order : {ByteOrder::Little, ByteOrder::Big}) {
    Packet packet{.id = 0,
                  .header = {.time_s = 1.79e9},
                  .order = order,
                  .payload = bytes.data(),
                  .size = static_cast<uint32_t>(bytes.size())};
#define MESSAGE(name, number) \
  packet.id = number;         \
  requireSame<name>(packet);
#define FIELD(type, name)
#define MESSAGE_END
#include "hooks/imc/messages.def"
  }
}

}  // namespace glider::imc_hostile
