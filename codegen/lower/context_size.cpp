// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/lower/context_size.h"

#include "runtime/abi/glider_abi.h"

#include <llvm/Support/MathExtras.h>

namespace glider::codegen {

uint32_t memoryCount(const ir::Mission& mission) {
  return 2 * static_cast<uint32_t>(mission.states.size());
}

uint64_t contextBytes(const ir::Mission& mission, const ir::MissionFacts& facts,
                      const llvm::DataLayout& layout, const AbiTypes& types) {
  constexpr uint64_t kAlignment = 8;
  auto part = [&](llvm::StructType* type, uint64_t count) {
    return llvm::alignTo(count * layout.getTypeAllocSize(type).getFixedValue(), kAlignment);
  };
  return part(types.GliderContext, 1) + part(types.GliderReading, mission.sensors.size()) +
         part(types.GliderFrame, facts.stack_depth) +
         uint64_t{memoryCount(mission)} * GLIDER_BEHAVIOUR_MEMORY_BYTES;
}

}  // namespace glider::codegen
