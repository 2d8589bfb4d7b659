// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/input.h"
#include "ir/core/mission.h"
#include "support/source_manager.h"

#include <llvm/IR/Module.h>
#include <llvm/Target/TargetMachine.h>

#include <memory>
#include <vector>

namespace glider::codegen {

/// What of a mission a module holds, for large ones are compiled in parts, side by side.
struct MissionPart {
  bool head = true;                ///< all but the states: `gliderMission`, `gliderContextMemory`
  std::vector<uint32_t> states;    ///< by their number, each without its profile's ticks
  std::vector<uint32_t> profiles;  ///< by their state's number: what a profile does in a tick
};

/// The whole mission.
MissionPart wholeOf(const ir::Mission& mission);

/// A part of the mission as a module for `machine`: behaviours and the runtime's functions are
/// declared, and what other parts hold. The mission must hold together and be free of errors. With
/// `sources` (of the mission's ranges; null: none) it has line tables.
std::unique_ptr<llvm::Module> lowerMission(const Input& input, const MissionPart& part,
                                           const llvm::TargetMachine& machine,
                                           const support::SourceManager* sources,
                                           llvm::LLVMContext& context);

}  // namespace glider::codegen
