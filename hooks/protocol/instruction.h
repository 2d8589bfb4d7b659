// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_PROTOCOL_INSTRUCTION_H
#define GLIDER_HOOKS_PROTOCOL_INSTRUCTION_H

#include "hooks/protocol/dictionary.h"
#include "hooks/protocol/sampling.h"
#include "hooks/protocol/steps.h"
#include "hooks/protocol/values.h"

/// What the SBC writes into the vehicle's sensor array: the only way in which it steers.
GLIDER_HOOKS_BEGIN

/// One instruction, in the units of the sensor array (m, rad, ddmm.mmmm). Its real numbers cross
/// the line in whole steps (steps.h): see hookInSteps.
typedef struct HookInstruction {
  uint32_t session GLIDER_IS(0);   ///< 1…16777215
  uint16_t sequence GLIDER_IS(0);  ///< 1…65535, then 1 again: 0 is "none yet"
  HookControl control GLIDER_IS(HookControl::None);
  HookVertical vertical GLIDER_IS(HookVertical::None);
  HookLateral lateral GLIDER_IS(HookLateral::Drift);
  double depth_m GLIDER_IS(0);      ///< of Actuators: the pump, cc, positive to lift
  double pitch_rad GLIDER_IS(0);    ///< nose up positive: negative to descend; of Actuators: the
                                    ///< pitch battery, inches, positive to lower the nose
  double heading_rad GLIDER_IS(0);  ///< of Fin: the fin's angle, positive to turn to starboard
  double latitude_ddmm GLIDER_IS(0);
  double longitude_ddmm GLIDER_IS(0);
  uint32_t sampling GLIDER_IS(0);  ///< how often the instruments read (sampling.h); at most
                                   ///< kHookMostSampling
} HookInstruction;

/// The words of an instruction as the sensors hold them; NaN: never set.
typedef struct HookInstructionWords {
#define WORD(role, sensor, word, ...) double word GLIDER_IS(0);
#define CHECK_WORD(role, sensor, word, line) double word GLIDER_IS(0);
#define LATER_WORD(role, sensor, word, field, line) double word GLIDER_IS(0);
#include "hooks/protocol/instruction.def"
} HookInstructionWords;

/// With its check value.
void hookWordsOf(const HookInstruction* instruction, HookInstructionWords* words);
/// Takes the words as they are after any path that keeps six decimals: real numbers go to the
/// nearest step. False if they cannot be those of any instruction, or the check value does not
/// match.
bool hookInstructionOf(const HookInstructionWords* words, HookInstruction* instruction);

/// Into `carried` the same instruction with every real number in whole steps, as hookbeh gets it.
/// What a word cannot carry becomes the number farthest out that it can, and NaN the lowest:
/// hookbeh refuses both.
void hookInSteps(const HookInstruction* instruction, HookInstruction* carried);
/// `sci_hook_check`: CRC-32C over all fields in whole numbers, sequence included, in the byte
/// layout of protocol/README.md.
uint32_t hookCheckValue(const HookInstruction* instruction);

GLIDER_HOOKS_END

#ifdef __cplusplus
namespace glider::hooks {
using Instruction = HookInstruction;
using InstructionWords = HookInstructionWords;

/// Each word by the role of its sensor.
struct InstructionWord {
  GliderRole role;
  double InstructionWords::* word;
};
inline constexpr InstructionWord kInstructionWords[] = {
#define WORD(role, sensor, word, ...) {kGliderRole##role, &InstructionWords::word},
#define CHECK_WORD(role, sensor, word, line) {kGliderRole##role, &InstructionWords::word},
#define LATER_WORD(role, sensor, word, field, line) {kGliderRole##role, &InstructionWords::word},
#include "hooks/protocol/instruction.def"
};
/// Those that each instruction has; the later ones are of features.
inline constexpr uint32_t kWordsOfEvery = kGliderRoleHookSequence - kGliderRoleHookSession + 1;
// By reference, and by value.
inline InstructionWords wordsOf(const Instruction& instruction) {
  InstructionWords words;
  hookWordsOf(&instruction, &words);
  return words;
}
inline bool instructionOf(const InstructionWords& words, Instruction* instruction) {
  return hookInstructionOf(&words, instruction);
}
inline Instruction inSteps(const Instruction& instruction) {
  Instruction carried;
  hookInSteps(&instruction, &carried);
  return carried;
}
inline uint32_t checkValue(const Instruction& instruction) {
  return hookCheckValue(&instruction);
}
}  // namespace glider::hooks
#endif

#endif
