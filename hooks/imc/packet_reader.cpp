// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/imc/packet_reader.h"

#include "hooks/imc/crc.h"
#include "hooks/protocol/bytes.h"

namespace glider::hooks::imc {
namespace {

constexpr uint32_t kLeastPacket = kHeaderBytes + kCrcBytes;
// Where in a packet.
constexpr uint32_t kId = 2;
constexpr uint32_t kSize = 4;
constexpr uint32_t kTime = 6;
constexpr uint32_t kSource = 14;
constexpr uint32_t kSourceEntity = 16;
constexpr uint32_t kDestination = 17;
constexpr uint32_t kDestinationEntity = 19;

uint16_t u16At(const uint8_t* bytes, ByteOrder order) {
  return static_cast<uint16_t>(numberAt(bytes, 2, order));
}

double timeAt(const uint8_t* bytes, ByteOrder order) {
  return hookDoubleOf(numberAt(bytes, 8, order));
}

/// Whether a number may be the time of a packet: not set (0, -1), the age of a computer that does
/// not know the time, or a time up to the year 2514. Of random numbers one in sixty may, so that
/// few false syncs make the packets behind them wait.
bool isTime(double time) {
  constexpr double kMost = 0x1p34;
  return time == 0 || time == -1 || (time >= 1 && time < kMost);
}

Header headerAt(const uint8_t* packet, ByteOrder order) {
  return {.time_s = timeAt(packet + kTime, order),
          .source = u16At(packet + kSource, order),
          .source_entity = packet[kSourceEntity],
          .destination = u16At(packet + kDestination, order),
          .destination_entity = packet[kDestinationEntity]};
}

}  // namespace

uint32_t PacketReader::push(const uint8_t* bytes, uint32_t count) {
  if (end_ == sizeof bytes_) {
    for (uint32_t i = begin_; i < end_; ++i) {
      bytes_[i - begin_] = bytes_[i];
    }
    end_ -= begin_;
    begin_ = 0;
  }
  const uint32_t room = static_cast<uint32_t>(sizeof bytes_) - end_;
  const uint32_t taken = count < room ? count : room;
  for (uint32_t i = 0; i < taken; ++i) {
    bytes_[end_++] = bytes[i];
  }
  return taken;
}

void PacketReader::reset() {
  skip(held());
}

void PacketReader::skip(uint32_t count) {
  begin_ += count;
  skipped_bytes_ += count;
}

/// Drops what comes before the next sync that a whole packet may follow. False if there is none.
bool PacketReader::findSync(ByteOrder* order) {
  for (; held() >= kLeastPacket; skip(1)) {
    const uint8_t* const begin = bytes_ + begin_;
    const bool little = u16At(begin, ByteOrder::Little) == kSync;
    if (little || u16At(begin, ByteOrder::Big) == kSync) {
      *order = little ? ByteOrder::Little : ByteOrder::Big;
      return true;
    }
  }
  return false;
}

/// The packet that begins here, if it has the right CRC; all its bytes are there.
bool PacketReader::take(ByteOrder order, uint32_t payload, Packet* packet) {
  const uint8_t* const begin = bytes_ + begin_;
  const uint32_t covered = kHeaderBytes + payload;
  if (crc16Arc(begin, covered) != u16At(begin + covered, order)) {
    return false;
  }
  *packet = {.id = u16At(begin + kId, order),
             .header = headerAt(begin, order),
             .order = order,
             .payload = begin + kHeaderBytes,
             .size = payload};
  begin_ += covered + kCrcBytes;
  return true;
}

bool PacketReader::next(Packet* packet) {
  for (ByteOrder order{}; findSync(&order); skip(1)) {
    const uint8_t* const begin = bytes_ + begin_;
    const uint32_t payload = u16At(begin + kSize, order);
    if (!isTime(timeAt(begin + kTime, order))) {
      continue;
    }
    if (payload > kMostPayload) {
      ++too_long_;
      continue;
    }
    if (held() < kHeaderBytes + payload + kCrcBytes) {
      return false;
    }
    if (take(order, payload, packet)) {
      return true;
    }
    ++bad_crcs_;
  }
  return false;
}

}  // namespace glider::hooks::imc
