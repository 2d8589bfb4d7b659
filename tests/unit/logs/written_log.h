// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/bytes.h"
#include "hooks/protocol/frame.h"
#include "runtime/log/records.h"

#include <cstdint>
#include <string>

namespace glider::logs::testing {

/// A log as runtime/README.md lays it out, written by nothing that writes one on board.
class WrittenLog {
 public:
  /// One record's payload, number by number.
  class Record {
   public:
    explicit Record(runtime::LogRecord kind) { u8(static_cast<uint8_t>(kind)); }
    Record& u8(uint8_t value) { return put(value, 1); }
    Record& u16(uint16_t value) { return put(value, 2); }
    Record& f64(double value) { return put(hooks::bitsOf(value), 8); }
    Record& text(const std::string& text) {
      payload_ += text;
      return *this;
    }
    [[nodiscard]] const std::string& payload() const { return payload_; }

   private:
    Record& put(uint64_t value, int width) {
      for (int i = 0; i < width; ++i) {
        payload_ += static_cast<char>(value >> (8 * i) & 0xFFU);
      }
      return *this;
    }
    std::string payload_;
  };

  void add(const Record& record) { add(record.payload()); }
  void add(const std::string& payload, hooks::MessageType type = hooks::MessageType::Log) {
    hooks::Frame frame;
    frame.type = type;
    frame.sequence = sequence++;
    frame.size = static_cast<uint16_t>(payload.size());
    payload.copy(reinterpret_cast<char*>(frame.payload), payload.size());
    uint8_t encoded[hooks::kMostEncodedBytes];
    bytes.append(reinterpret_cast<const char*>(encoded), hooks::encodeFrame(frame, encoded));
  }
  void start(const std::string& mission = "bench", uint8_t version = runtime::kLogVersion) {
    bytes += '\0';
    add(Record(runtime::LogRecord::Start).u8(version).text(mission));
  }
  void name(runtime::LogNamed what, uint16_t number, uint16_t item, const std::string& name) {
    add(Record(runtime::LogRecord::Name)
            .u8(static_cast<uint8_t>(what))
            .u16(number)
            .u16(item)
            .text(name));
  }
  void event(double time, uint8_t event = 5, uint8_t detail = 0, double value = 0) {
    add(Record(runtime::LogRecord::Event).f64(time).u8(event).u8(detail).f64(value));
  }

  std::string bytes;
  uint8_t sequence = 0;  ///< of the next record
};

}  // namespace glider::logs::testing
