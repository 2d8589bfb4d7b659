// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/instruction.h"

#include "hooks/protocol/bytes.h"
#include "hooks/protocol/crc.h"
#include "hooks/protocol/numbers.h"

#include <stddef.h>

#define WORD(role, sensor, word, field, bytes, steps, line) \
  GLIDER_STATIC_ASSERT(role, kGliderRole##role - kGliderRoleHookSession == (line));
#define CHECK_WORD(role, sensor, word, line) \
  GLIDER_STATIC_ASSERT(role, kGliderRole##role - kGliderRoleHookSession == (line));
#define LATER_WORD(role, sensor, word, field, line) \
  GLIDER_STATIC_ASSERT(role, kGliderRole##role - kGliderRoleHookSession == (line));
#include "hooks/protocol/instruction.def"

enum {
  kMostCode = 127,  // a one-byte sensor
  kCheckedBytes = 0
#define WORD(role, sensor, word, field, bytes, ...) +(bytes)
#define REAL_WORD(role, ...) +4
#define LATER_WORD(role, ...) +4
#include "hooks/protocol/instruction.def"
};

/// A word that is a whole number: a session, the sequence, or a code. The first two count from 1.
static bool readWhole(double word, uint32_t bytes, uint32_t* whole) {
  return hookIsWhole(word, bytes == 1 ? 0 : 1,
                     bytes == 1   ? kMostCode
                     : bytes == 2 ? UINT16_MAX
                                  : kHookMostSession,
                     whole);
}

/// The word of a feature: never set, it is 0.
static bool readLater(double word, uint32_t* whole) {
  *whole = 0;
  return word != word || hookIsWhole(word, 0, kHookMostSampling, whole);
}

static double inSteps(double number, uint32_t steps, int32_t most) {
  return (double)hookWholeSteps(number, steps, most) / steps;
}

/// The real numbers lie one behind the other, in the order of the table: loops over them are a
/// third of the code without, of which a board has little room.
enum {
  kFirstReal = offsetof(HookInstruction, depth_m),
  kRealCount = 0
#define WORD(...)
#define REAL_WORD(role, ...) +1
#include "hooks/protocol/instruction.def"
};
GLIDER_STATIC_ASSERT(RealNumbersAreTogether, offsetof(HookInstruction, longitude_ddmm) ==
                                                 kFirstReal + (kRealCount - 1) * sizeof(double));
static const struct {
  uint32_t steps;
  int32_t most;
} kReals[] = {
#define WORD(...)
#define REAL_WORD(role, sensor, word, field, bytes, steps, line) {steps, kHookMostStepsOf##bytes},
#include "hooks/protocol/instruction.def"
};

static double* realOf(HookInstruction* instruction, uint32_t i) {
  return (double*)(void*)((char*)instruction + kFirstReal) + i;
}

static int32_t wholeOf(const HookInstruction* instruction, uint32_t i) {
  const double* reals = (const double*)(const void*)((const char*)instruction + kFirstReal);
  return hookWholeSteps(reals[i], kReals[i].steps, kReals[i].most);
}

void hookWordsOf(const HookInstruction* instruction, HookInstructionWords* words) {
  HookInstruction carried;
  hookInSteps(instruction, &carried);
#define WORD(role, sensor, word, field, ...) words->word = (double)carried.field;
#define CHECK_WORD(role, sensor, word, line) words->word = (double)hookCheckValue(&carried);
#define LATER_WORD(role, sensor, word, field, line) words->word = (double)carried.field;
#include "hooks/protocol/instruction.def"
}

bool hookInstructionOf(const HookInstructionWords* words, HookInstruction* instruction) {
  bool good = true;
  uint32_t whole = 0;
#define WORD(role, sensor, word, field, bytes, ...)     \
  good = readWhole(words->word, bytes, &whole) && good; \
  instruction->field = (HOOK_TYPE_OF_##bytes)whole;
#define REAL_WORD(role, sensor, word, field, bytes, steps, line) \
  good = hookIsFinite(words->word) && good;                      \
  instruction->field = inSteps(words->word, steps, kHookMostStepsOf##bytes);
#define LATER_WORD(role, sensor, word, field, line) \
  good = readLater(words->word, &whole) && good;    \
  instruction->field = whole;
#define HOOK_TYPE_OF_1 uint8_t
#define HOOK_TYPE_OF_2 uint16_t
#define HOOK_TYPE_OF_4 uint32_t
#include "hooks/protocol/instruction.def"
  return good && words->check == (double)hookCheckValue(instruction);
}

#ifdef __GNUC__
__attribute__((noinline))  // a board has little room
#endif
void hookInSteps(const HookInstruction* instruction, HookInstruction* carried) {
  *carried = *instruction;
  for (uint32_t i = 0; i < kRealCount; ++i) {
    *realOf(carried, i) = (double)wholeOf(instruction, i) / kReals[i].steps;
  }
}

uint32_t hookCheckValue(const HookInstruction* instruction) {
  uint8_t bytes[kCheckedBytes];
  HookByteWriter out = hookWriterTo(bytes, kCheckedBytes);
#define WORD(role, sensor, word, field, width, ...) HOOK_WRITE_##width(&out, instruction->field);
#define HOOK_WRITE_1 hookWriteU8
#define HOOK_WRITE_2 hookWriteU16
#define HOOK_WRITE_4 hookWriteU32
#define REAL_WORD(...)
#include "hooks/protocol/instruction.def"
  // Real numbers come behind those, in steps.
  for (uint32_t i = 0; i < kRealCount; ++i) {
    hookWriteU32(&out, (uint32_t)wholeOf(instruction, i));
  }
#define WORD(...)
#define LATER_WORD(role, sensor, word, field, line) \
  if (instruction->field != 0) {                    \
    hookWriteU32(&out, instruction->field);         \
  }
#include "hooks/protocol/instruction.def"
  return hookCrc32c(bytes, out.size, kHookCrc32cStart);
}
