// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_PROTOCOL_BYTES_H
#define GLIDER_HOOKS_PROTOCOL_BYTES_H

#include "hooks/protocol/language.h"

/// Little-endian numbers in byte arrays, the same on every board.
GLIDER_HOOKS_BEGIN

/// The bits of a number; one NaN on the line, for any NaN of the CPU.
uint32_t hookBitsOfFloat(float value);
uint64_t hookBitsOfDouble(double value);
float hookFloatOf(uint32_t bits);
double hookDoubleOf(uint64_t bits);

/// Appends to a byte array; what does not fit is dropped and `fits` becomes false.
typedef struct HookByteWriter {
  uint8_t* bytes;
  uint32_t capacity;
  uint32_t size;
  bool fits;
} HookByteWriter;

HookByteWriter hookWriterTo(uint8_t* bytes, uint32_t capacity);
/// The lowest `width` bytes of `value`.
void hookWrite(HookByteWriter* writer, uint64_t value, uint32_t width);
/// The same of 1 to 4 bytes: calls of these are short on a board with 32-bit registers.
void hookWriteU8(HookByteWriter* writer, uint32_t value);
void hookWriteU16(HookByteWriter* writer, uint32_t value);
void hookWriteU24(HookByteWriter* writer, uint32_t value);
void hookWriteU32(HookByteWriter* writer, uint32_t value);
void hookWriteF32(HookByteWriter* writer, float value);
void hookWriteF64(HookByteWriter* writer, double value);

/// Reads a byte array; past its end every number is zero and `good` becomes false.
typedef struct HookByteReader {
  const uint8_t* bytes;
  uint32_t count;
  uint32_t at;
  bool good;
} HookByteReader;

HookByteReader hookReaderOf(const uint8_t* bytes, uint32_t count);
/// A number of `width` bytes.
uint64_t hookRead(HookByteReader* reader, uint32_t width);
uint8_t hookReadU8(HookByteReader* reader);
uint16_t hookReadU16(HookByteReader* reader);
uint32_t hookReadU24(HookByteReader* reader);
uint32_t hookReadU32(HookByteReader* reader);
float hookReadF32(HookByteReader* reader);
double hookReadF64(HookByteReader* reader);
void hookSkip(HookByteReader* reader, uint32_t count);
/// True when every number was there and nothing is left over.
bool hookIsAllRead(const HookByteReader* reader);

GLIDER_HOOKS_END

#ifdef __cplusplus
namespace glider::hooks {

inline uint32_t bitsOf(float value) {
  return hookBitsOfFloat(value);
}
inline uint64_t bitsOf(double value) {
  return hookBitsOfDouble(value);
}

/// HookByteWriter.
class ByteWriter {
 public:
  ByteWriter(uint8_t* bytes, uint32_t capacity) : writer_(hookWriterTo(bytes, capacity)) {}
  void u8(uint8_t value) { hookWriteU8(&writer_, value); }
  void u16(uint16_t value) { hookWriteU16(&writer_, value); }
  void u24(uint32_t value) { hookWriteU24(&writer_, value); }
  void u32(uint32_t value) { hookWriteU32(&writer_, value); }
  void f32(float value) { hookWriteF32(&writer_, value); }
  void f64(double value) { hookWriteF64(&writer_, value); }
  void bits(uint64_t value, uint32_t width) { hookWrite(&writer_, value, width); }
  [[nodiscard]] uint32_t size() const { return writer_.size; }
  [[nodiscard]] bool fits() const { return writer_.fits; }

 private:
  HookByteWriter writer_;
};

/// HookByteReader.
class ByteReader {
 public:
  ByteReader(const uint8_t* bytes, uint32_t count) : reader_(hookReaderOf(bytes, count)) {}
  uint8_t u8() { return hookReadU8(&reader_); }
  uint16_t u16() { return hookReadU16(&reader_); }
  uint32_t u24() { return hookReadU24(&reader_); }
  uint32_t u32() { return hookReadU32(&reader_); }
  float f32() { return hookReadF32(&reader_); }
  double f64() { return hookReadF64(&reader_); }
  uint64_t bits(uint32_t width) { return hookRead(&reader_, width); }
  void skip(uint32_t count) { hookSkip(&reader_, count); }
  [[nodiscard]] bool good() const { return reader_.good; }
  [[nodiscard]] bool exact() const { return hookIsAllRead(&reader_); }

 private:
  HookByteReader reader_;
};

}  // namespace glider::hooks
#endif

#endif
