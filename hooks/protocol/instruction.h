// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/dictionary.h"
#include "hooks/protocol/steps.h"
#include "hooks/protocol/values.h"

#include <stdint.h>

/// What the SBC writes into the vehicle's sensor array: the only way in which it steers.
namespace glider::hooks {

/// One instruction, in the units of the sensor array (m, rad, ddmm.mmmm). Its real numbers cross
/// the line in whole steps (steps.h): see inSteps.
struct Instruction {
  uint32_t session = 0;   ///< 1…16777215
  uint16_t sequence = 0;  ///< 1…65535, then 1 again: 0 is "none yet"
  HookControl control = HookControl::None;
  HookVertical vertical = HookVertical::None;
  HookLateral lateral = HookLateral::Drift;
  double depth_m = 0;      ///< of Actuators: the pump, cc, positive to lift
  double pitch_rad = 0;    ///< nose up positive: negative to descend; of Actuators: the pitch
                           ///< battery, inches, positive to lower the nose
  double heading_rad = 0;  ///< of Fin: the fin's angle, positive to turn to starboard
  double latitude_ddmm = 0;
  double longitude_ddmm = 0;
};

/// The words of an instruction as the sensors hold them; NaN: never set.
struct InstructionWords {
#define WORD(role, sensor, word, ...) double word = 0;
#define CHECK_WORD(role, sensor, word, line) double word = 0;
#include "hooks/protocol/instruction.def"
};

/// Each word by the role of its sensor.
struct InstructionWord {
  GliderRole role;
  double InstructionWords::* word;
};
inline constexpr InstructionWord kInstructionWords[] = {
#define WORD(role, sensor, word, ...) {kGliderRole##role, &InstructionWords::word},
#define CHECK_WORD(role, sensor, word, line) {kGliderRole##role, &InstructionWords::word},
#include "hooks/protocol/instruction.def"
};

#define WORD(role, sensor, word, field, bytes, steps, line) \
  static_assert(kGliderRole##role - kGliderRoleHookSession == (line));
#define CHECK_WORD(role, sensor, word, line) \
  static_assert(kGliderRole##role - kGliderRoleHookSession == (line));
#include "hooks/protocol/instruction.def"

/// With its check value.
InstructionWords wordsOf(const Instruction& instruction);
/// Takes the words as they are after any path that keeps six decimals: real numbers go to the
/// nearest step. False if they cannot be those of any instruction, or the check value does not
/// match.
[[nodiscard]] bool instructionOf(const InstructionWords& words, Instruction* instruction);

/// The same instruction with every real number in whole steps, as hookbeh gets it. What a word
/// cannot carry becomes the number farthest out that it can, and NaN the lowest: hookbeh refuses
/// both.
Instruction inSteps(const Instruction& instruction);
/// `sci_hook_check`: CRC-32C over all fields in whole numbers, sequence included, in the byte
/// layout of protocol/README.md.
uint32_t checkValue(const Instruction& instruction);

}  // namespace glider::hooks
