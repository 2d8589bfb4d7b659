// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// Little-endian numbers in byte arrays, the same on every board.
namespace glider::hooks {

inline uint32_t bitsOf(float value) {
  if (value != value) {
    return 0x7FC00000U;  // one NaN on the line, for any NaN of the CPU
  }
  uint32_t bits = 0;
  __builtin_memcpy(&bits, &value, sizeof bits);
  return bits;
}

inline uint64_t bitsOf(double value) {
  if (value != value) {
    return 0x7FF8000000000000U;
  }
  uint64_t bits = 0;
  __builtin_memcpy(&bits, &value, sizeof bits);
  return bits;
}

inline float floatOf(uint32_t bits) {
  float value = 0;
  __builtin_memcpy(&value, &bits, sizeof value);
  return value;
}

inline double doubleOf(uint64_t bits) {
  double value = 0;
  __builtin_memcpy(&value, &bits, sizeof value);
  return value;
}

/// Appends to a byte array; what does not fit is dropped and `fits` becomes false.
class ByteWriter {
 public:
  ByteWriter(uint8_t* bytes, uint32_t capacity) : bytes_(bytes), capacity_(capacity) {}
  void u8(uint8_t value) { bits(value, 1); }
  void u16(uint16_t value) { bits(value, 2); }
  void u24(uint32_t value) { bits(value, 3); }
  void u32(uint32_t value) { bits(value, 4); }
  void f32(float value) { bits(bitsOf(value), 4); }
  void f64(double value) { bits(bitsOf(value), 8); }
  /// The lowest `width` bytes of `value`.
  void bits(uint64_t value, uint32_t width);
  [[nodiscard]] uint32_t size() const { return size_; }
  [[nodiscard]] bool fits() const { return fits_; }

 private:
  uint8_t* bytes_;
  uint32_t capacity_;
  uint32_t size_ = 0;
  bool fits_ = true;
};

/// Reads a byte array; past its end every number is zero and `good` becomes false.
class ByteReader {
 public:
  ByteReader(const uint8_t* bytes, uint32_t count) : bytes_(bytes), count_(count) {}
  uint8_t u8() { return static_cast<uint8_t>(bits(1)); }
  uint16_t u16() { return static_cast<uint16_t>(bits(2)); }
  uint32_t u24() { return static_cast<uint32_t>(bits(3)); }
  uint32_t u32() { return static_cast<uint32_t>(bits(4)); }
  float f32() { return floatOf(u32()); }
  double f64() { return doubleOf(bits(8)); }
  /// A number of `width` bytes.
  uint64_t bits(uint32_t width);
  void skip(uint32_t count);
  [[nodiscard]] bool good() const { return good_; }
  /// True when every number was there and nothing is left over.
  [[nodiscard]] bool exact() const { return good_ && at_ == count_; }

 private:
  const uint8_t* bytes_;
  uint32_t count_;
  uint32_t at_ = 0;
  bool good_ = true;
};

}  // namespace glider::hooks
