// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/bytes.h"

#include "hooks/protocol/c_library.h"

uint32_t hookBitsOfFloat(float value) {
  uint32_t bits = 0;
  memcpy(&bits, &value, sizeof bits);
  return value != value ? 0x7FC00000U : bits;
}

uint64_t hookBitsOfDouble(double value) {
  uint64_t bits = 0;
  memcpy(&bits, &value, sizeof bits);
  return value != value ? UINT64_C(0x7FF8000000000000) : bits;
}

float hookFloatOf(uint32_t bits) {
  float value = 0;
  memcpy(&value, &bits, sizeof value);
  return value;
}

double hookDoubleOf(uint64_t bits) {
  double value = 0;
  memcpy(&value, &bits, sizeof value);
  return value;
}

HookByteWriter hookWriterTo(uint8_t* bytes, uint32_t capacity) {
  const HookByteWriter writer = {bytes, capacity, 0, true};
  return writer;
}

void hookWrite(HookByteWriter* writer, uint64_t value, uint32_t width) {
  if (writer->capacity - writer->size < width) {
    writer->fits = false;
    return;
  }
  for (uint32_t i = 0; i < width; ++i) {
    writer->bytes[writer->size++] = (uint8_t)(value >> (8U * i));
  }
}

void hookWriteU8(HookByteWriter* writer, uint32_t value) {
  hookWrite(writer, value, 1);
}

void hookWriteU16(HookByteWriter* writer, uint32_t value) {
  hookWrite(writer, value, 2);
}

void hookWriteU24(HookByteWriter* writer, uint32_t value) {
  hookWrite(writer, value, 3);
}

void hookWriteU32(HookByteWriter* writer, uint32_t value) {
  hookWrite(writer, value, 4);
}

void hookWriteF32(HookByteWriter* writer, float value) {
  hookWrite(writer, hookBitsOfFloat(value), 4);
}

void hookWriteF64(HookByteWriter* writer, double value) {
  hookWrite(writer, hookBitsOfDouble(value), 8);
}

HookByteReader hookReaderOf(const uint8_t* bytes, uint32_t count) {
  const HookByteReader reader = {bytes, count, 0, true};
  return reader;
}

uint64_t hookRead(HookByteReader* reader, uint32_t width) {
  if (reader->count - reader->at < width) {
    reader->good = false;
    reader->at = reader->count;
    return 0;
  }
  uint64_t value = 0;
  for (uint32_t i = 0; i < width; ++i) {
    value |= (uint64_t)reader->bytes[reader->at++] << (8U * i);
  }
  return value;
}

uint8_t hookReadU8(HookByteReader* reader) {
  return (uint8_t)hookRead(reader, 1);
}

uint16_t hookReadU16(HookByteReader* reader) {
  return (uint16_t)hookRead(reader, 2);
}

uint32_t hookReadU24(HookByteReader* reader) {
  return (uint32_t)hookRead(reader, 3);
}

uint32_t hookReadU32(HookByteReader* reader) {
  return (uint32_t)hookRead(reader, 4);
}

float hookReadF32(HookByteReader* reader) {
  return hookFloatOf(hookReadU32(reader));
}

double hookReadF64(HookByteReader* reader) {
  return hookDoubleOf(hookRead(reader, 8));
}

void hookSkip(HookByteReader* reader, uint32_t count) {
  if (reader->count - reader->at < count) {
    reader->good = false;
    reader->at = reader->count;
    return;
  }
  reader->at += count;
}

bool hookIsAllRead(const HookByteReader* reader) {
  return reader->good && reader->at == reader->count;
}
