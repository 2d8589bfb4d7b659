// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/imc/packet_reader.h"
#include "tests/unit/hooks/imc_described.h"
#include "tests/unit/hooks/imc_samples.h"

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <vector>

/// Streams of packets, and what a reader finds in them.
namespace glider::imc_streams {

using namespace hooks::imc;
using imc_described::Bytes;

inline constexpr ByteOrder kBothOrders[] = {ByteOrder::Little, ByteOrder::Big};
/// From a vehicle to all.
inline constexpr Header kFromVehicle{.time_s = 1795622130.25,
                                     .source = 0xD1,
                                     .source_entity = 54,
                                     .destination = 0xFFFF,
                                     .destination_entity = 255};

inline Bytes bytesOf(const char* hex) {
  Bytes bytes(imc_samples::kMostSample);
  bytes.resize(imc_samples::bytesOf(hex, bytes.data()));
  return bytes;
}

inline Bytes joined(std::initializer_list<Bytes> parts) {
  Bytes all;
  for (const Bytes& part : parts) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

inline Bytes sampleBytes(uint32_t sample, ByteOrder order = ByteOrder::Little) {
  const imc_samples::Sample& one = imc_samples::kSamples[sample];
  return bytesOf(order == ByteOrder::Little ? one.little : one.big);
}

/// All packets of imc_samples.h, one after the other.
inline Bytes allSamples() {
  Bytes all;
  for (uint32_t i = 0; i < imc_samples::kSampleCount; ++i) {
    all = joined({all, sampleBytes(i)});
  }
  return all;
}

/// A packet without what is only valid until the next one.
struct Found {
  uint16_t id;
  ByteOrder order;
  double time_s;
  Bytes payload;
  bool operator==(const Found&) const = default;
};
using AllFound = std::vector<Found>;

inline Found foundOf(const Packet& packet) {
  return {packet.id, packet.order, packet.header.time_s,
          Bytes(packet.payload, packet.payload + packet.size)};
}

/// Pushes bytes in pieces of this size and adds the packets to `found`.
inline void read(PacketReader* reader, const Bytes& bytes, size_t piece, AllFound* found) {
  for (size_t at = 0; at < bytes.size();) {
    const size_t count = std::min(piece, bytes.size() - at);
    at += reader->push(bytes.data() + at, static_cast<uint32_t>(count));
    for (Packet packet; reader->next(&packet);) {
      found->push_back(foundOf(packet));
    }
  }
}

inline AllFound packetsIn(const Bytes& bytes, size_t piece = SIZE_MAX) {
  PacketReader reader;
  AllFound found;
  read(&reader, bytes, piece, &found);
  return found;
}

}  // namespace glider::imc_streams
