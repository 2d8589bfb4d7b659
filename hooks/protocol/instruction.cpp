// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/instruction.h"

#include "hooks/protocol/bytes.h"
#include "hooks/protocol/crc.h"
#include "hooks/protocol/messages.h"
#include "hooks/protocol/numbers.h"

namespace glider::hooks {
namespace {

constexpr uint32_t kMostCode = 127;  // a one-byte sensor

/// A field in as many bytes: numbers and codes as they are, real numbers as the sensor holds them.
template <typename Field>
void write(ByteWriter& out, uint32_t bytes, Field field) {
  out.bits(static_cast<uint64_t>(field), bytes);
}
void write(ByteWriter& out, uint32_t bytes, double field) {
  if (bytes == 4) {
    out.f32(static_cast<float>(field));
  } else {
    out.f64(field);
  }
}

template <typename Field>
Field asHeld(uint32_t /*bytes*/, Field field) {
  return field;
}
double asHeld(uint32_t bytes, double field) {
  return bytes == 4 ? asFloat32(field) : field;
}

bool read(double word, uint32_t* session) {
  return isWhole(word, 1, kMostSession, session);
}
bool read(double word, uint16_t* sequence) {
  uint32_t whole = 0;
  const bool good = isWhole(word, 1, UINT16_MAX, &whole);
  *sequence = static_cast<uint16_t>(whole);
  return good;
}
bool read(double word, double* number) {
  *number = word;
  return true;
}
template <typename Code>
bool read(double word, Code* code) {
  uint32_t whole = 0;
  const bool good = isWhole(word, 0, kMostCode, &whole);
  *code = static_cast<Code>(whole);
  return good;
}

}  // namespace

InstructionWords wordsOf(const Instruction& instruction) {
  InstructionWords words;
#define WORD(role, sensor, word, field, ...) words.word = static_cast<double>(instruction.field);
#define CHECK_WORD(role, sensor, word, line) \
  words.word = static_cast<double>(checkValue(instruction));
#include "hooks/protocol/instruction.def"
  return words;
}

bool instructionOf(const InstructionWords& words, Instruction* instruction) {
  bool good = true;
#define WORD(role, sensor, word, field, ...) good = read(words.word, &instruction->field) && good;
#include "hooks/protocol/instruction.def"
  return good && words.check == checkValue(*instruction);
}

Instruction roundToArray(const Instruction& instruction) {
  Instruction rounded;
#define WORD(role, sensor, word, field, bytes, line) \
  rounded.field = asHeld(bytes, instruction.field);
#include "hooks/protocol/instruction.def"
  return rounded;
}

uint16_t checkValue(const Instruction& instruction) {
  constexpr uint32_t kBytes = 0
#define WORD(role, sensor, word, field, bytes, line) +(bytes)
#include "hooks/protocol/instruction.def"
      ;
  uint8_t bytes[kBytes];
  ByteWriter out(bytes, kBytes);
#define WORD(role, sensor, word, field, width, line) write(out, width, instruction.field);
#include "hooks/protocol/instruction.def"
  return crc16(bytes, kBytes);
}

}  // namespace glider::hooks
