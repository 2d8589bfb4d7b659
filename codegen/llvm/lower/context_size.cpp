// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/lower/context_size.h"

#include "runtime/abi/glider_abi.h"

#include <llvm/Support/MathExtras.h>

namespace glider::codegen {

uint64_t contextBytes(const Input& input, const MissionIndex& index, const llvm::DataLayout& layout,
                      const AbiTypes& types) {
  const ir::Mission& mission = input.mission;
  constexpr uint64_t kAlignment = 8;
  auto part = [&](llvm::StructType* type, uint64_t count) {
    return llvm::alignTo(count * layout.getTypeAllocSize(type).getFixedValue(), kAlignment);
  };
  const uint64_t numbers =
      mission.variables.size() + index.slot_count + uint64_t{GLIDER_MOST_NOTE_VALUES};
  return part(types.GliderContext, 1) + part(types.GliderReading, mission.sensors.size()) +
         part(types.GliderFrame, input.stack_depth) + part(types.GliderCall, mission.uses.size()) +
         uint64_t{index.memory_count} * GLIDER_BEHAVIOUR_MEMORY_BYTES + numbers * sizeof(double) +
         llvm::alignTo(uint64_t{index.interval_count} * sizeof(uint32_t), kAlignment) +
         part(types.GliderNote, GLIDER_MOST_NOTES);
}

}  // namespace glider::codegen
