// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/transport/byte_stream.h"
#include "simulator/faults/line_damage.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>

namespace glider::simulator {

/// A serial line in virtual time: what one end writes, the other end can read after it has arrived,
/// at ten bits per byte (8N1). Both ends point into it, so it must not move.
class SerialLine {
 public:
  /// Bytes that may be in transit in each direction: a UART's driver queue.
  static constexpr size_t kCapacity = 4096;

  explicit SerialLine(double baud)
      : SerialLine(baud, LineDamage({}, LineWay::ToSbc, 0, baud),
                   LineDamage({}, LineWay::ToSbc, 0, baud)) {}
  /// `to_left` and `to_right` are the faults of its two directions.
  SerialLine(double baud, LineDamage to_left, LineDamage to_right)
      : byte_time_s_(10 / baud), to_left_(std::move(to_left)), to_right_(std::move(to_right)) {
    left_ = {this, &to_left_, &to_right_};
    right_ = {this, &to_right_, &to_left_};
  }
  SerialLine(const SerialLine&) = delete;
  SerialLine& operator=(const SerialLine&) = delete;

  /// Sets the time; it never goes back.
  void setNow(double now_s) { now_s_ = now_s; }
  [[nodiscard]] GliderByteStream left() { return {&left_, read, write}; }
  [[nodiscard]] GliderByteStream right() { return {&right_, read, write}; }
  /// The left (right) end loses its power: what it has not sent yet is never sent, and what it has
  /// not read is gone.
  void dropLeft() { drop(left_); }
  void dropRight() { drop(right_); }

 private:
  struct Direction {
    explicit Direction(LineDamage what) : damage(std::move(what)) {}
    LineDamage damage;
    std::deque<LineDamage::Arrival> bytes;
    double free_s = 0;  ///< when the wire is free again
  };
  struct End {
    SerialLine* line = nullptr;
    Direction* in = nullptr;
    Direction* out = nullptr;
  };
  void drop(End& end);
  static int32_t read(void* self, uint8_t* bytes, uint32_t capacity);
  static int32_t write(void* self, const uint8_t* bytes, uint32_t count);

  double byte_time_s_;
  double now_s_ = 0;
  Direction to_left_, to_right_;
  End left_, right_;
};

}  // namespace glider::simulator
