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

/// The part of a mission in a module: large missions are compiled in parts, in parallel.
struct MissionPart {
  bool head = true;  ///< everything except the states: `gliderMission`, `gliderContextMemory`
  std::vector<uint32_t> states;    ///< by their number, each without its profile's ticks
  std::vector<uint32_t> profiles;  ///< by their state's number: what a profile does in a tick
};

/// The whole mission.
MissionPart wholeOf(const ir::Mission& mission);

/// A part of the mission as a module for `machine`. Behaviours, the runtime's functions and the
/// content of other parts are only declared. The mission must be valid and free of errors. With
/// `sources` (of the mission's ranges; null: none) it has line tables.
std::unique_ptr<llvm::Module> lowerMission(const Input& input, const MissionPart& part,
                                           const llvm::TargetMachine& machine,
                                           const support::SourceManager* sources,
                                           llvm::LLVMContext& context);

}  // namespace glider::codegen
