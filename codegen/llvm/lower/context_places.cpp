// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/lower/context_places.h"

#include "runtime/abi/glider_abi.h"

#include <llvm/Support/MathExtras.h>

namespace glider::codegen {

ContextPlaces contextPlaces(const Input& input, const MissionIndex& index,
                            const llvm::DataLayout& layout, const AbiTypes& types) {
  const ir::Mission& mission = input.mission;
  constexpr uint64_t kAlignment = 8;
  const auto part = [&](llvm::StructType* type, uint64_t count) {
    return llvm::alignTo(count * layout.getTypeAllocSize(type).getFixedValue(), kAlignment);
  };
  ContextPlaces places;
  places.readings = part(types.GliderContext, 1);
  places.frames = places.readings + part(types.GliderReading, mission.sensors.size());
  places.variables = places.frames + part(types.GliderFrame, input.stack_depth) +
                     uint64_t{index.memory_count} * GLIDER_BEHAVIOUR_MEMORY_BYTES;
  places.temporals = places.variables + mission.variables.size() * sizeof(double);
  const uint64_t calls = places.temporals + index.slot_count * sizeof(double);
  const uint64_t intervals = calls + part(types.GliderCall, mission.uses.size());
  const uint64_t notes =
      intervals + llvm::alignTo(uint64_t{index.interval_count} * sizeof(uint32_t), kAlignment);
  places.bytes = notes + part(types.GliderNote, GLIDER_MOST_NOTES) +
                 uint64_t{GLIDER_MOST_NOTE_VALUES} * sizeof(double);
  return places;
}

ContextPlaces contextPlaces(const Lowering& lowering) {
  return contextPlaces({lowering.mission, lowering.platform, lowering.stack_depth}, lowering.index,
                       lowering.module.getDataLayout(), lowering.types);
}

}  // namespace glider::codegen
