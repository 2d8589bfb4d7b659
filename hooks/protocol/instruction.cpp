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

/// The real numbers of an instruction, in their order.
struct RealField {
  double Instruction::* field = nullptr;
  uint32_t steps = 0;
  int32_t most = 0;
};
struct RealFields {
  RealField all[8];
  uint32_t count = 0;

  constexpr void add(double Instruction::* field, uint32_t bytes, uint32_t steps) {
    all[count++] = {field, steps, mostSteps(bytes)};
  }
  template <typename Field>
  constexpr void add(Field Instruction::* /*field*/, uint32_t /*bytes*/, uint32_t /*steps*/) {}
};
constexpr RealFields realFields() {
  RealFields fields;
#define WORD(role, sensor, word, field, bytes, steps, line) \
  fields.add(&Instruction::field, bytes, steps);
#include "hooks/protocol/instruction.def"
  return fields;
}
constexpr RealFields kReals = realFields();

/// A whole number or code under the check value; real numbers come behind these, in steps.
template <typename Field>
void write(ByteWriter& out, uint32_t bytes, Field field) {
  out.bits(static_cast<uint64_t>(field), bytes);
}
void write(ByteWriter& /*out*/, uint32_t /*bytes*/, double /*field*/) {}

bool read(double word, uint32_t /*bytes*/, uint32_t /*steps*/, uint32_t* session) {
  return isWhole(word, 1, kMostSession, session);
}
bool read(double word, uint32_t /*bytes*/, uint32_t /*steps*/, uint16_t* sequence) {
  uint32_t whole = 0;
  const bool good = isWhole(word, 1, UINT16_MAX, &whole);
  *sequence = static_cast<uint16_t>(whole);
  return good;
}
bool read(double word, uint32_t bytes, uint32_t steps, double* number) {
  *number = static_cast<double>(wholeSteps(word, steps, mostSteps(bytes))) / steps;
  return isFinite(word);
}
template <typename Code>
bool read(double word, uint32_t /*bytes*/, uint32_t /*steps*/, Code* code) {
  uint32_t whole = 0;
  const bool good = isWhole(word, 0, kMostCode, &whole);
  *code = static_cast<Code>(whole);
  return good;
}

/// Of a real number a whole number of steps, 4 bytes.
template <typename Field>
constexpr uint32_t checkedBytes(uint32_t bytes, Field Instruction::* /*field*/) {
  return bytes;
}
constexpr uint32_t checkedBytes(uint32_t /*bytes*/, double Instruction::* /*field*/) {
  return 4;
}

}  // namespace

InstructionWords wordsOf(const Instruction& instruction) {
  const Instruction carried = inSteps(instruction);
  InstructionWords words;
#define WORD(role, sensor, word, field, ...) words.word = static_cast<double>(carried.field);
#define CHECK_WORD(role, sensor, word, line) words.word = static_cast<double>(checkValue(carried));
#include "hooks/protocol/instruction.def"
  return words;
}

bool instructionOf(const InstructionWords& words, Instruction* instruction) {
  bool good = true;
#define WORD(role, sensor, word, field, bytes, steps, line) \
  good = read(words.word, bytes, steps, &instruction->field) && good;
#include "hooks/protocol/instruction.def"
  return good && words.check == static_cast<double>(checkValue(*instruction));
}

Instruction inSteps(const Instruction& instruction) {
  Instruction carried = instruction;
  for (uint32_t i = 0; i < kReals.count; ++i) {
    const RealField& real = kReals.all[i];
    double& number = carried.*real.field;
    number = static_cast<double>(wholeSteps(number, real.steps, real.most)) / real.steps;
  }
  return carried;
}

uint32_t checkValue(const Instruction& instruction) {
  constexpr uint32_t kBytes = 0
#define WORD(role, sensor, word, field, bytes, ...) +checkedBytes(bytes, &Instruction::field)
#include "hooks/protocol/instruction.def"
      ;
  uint8_t bytes[kBytes];
  ByteWriter out(bytes, kBytes);
#define WORD(role, sensor, word, field, width, ...) write(out, width, instruction.field);
#include "hooks/protocol/instruction.def"
  for (uint32_t i = 0; i < kReals.count; ++i) {
    const RealField& real = kReals.all[i];
    out.u32(static_cast<uint32_t>(wholeSteps(instruction.*real.field, real.steps, real.most)));
  }
  return crc32c(bytes, kBytes);
}

}  // namespace glider::hooks
