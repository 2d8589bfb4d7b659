// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "support/source_manager.h"

#include <llvm/IR/Module.h>
#include <llvm/Target/TargetMachine.h>

#include <memory>

namespace glider::codegen {

/// The mission as a module for `machine`: `gliderMission` and `gliderContextMemory` are defined,
/// behaviours and `gliderSettle` declared. The mission must hold together and be free of errors.
/// With `sources` (of the mission's ranges; null: none) it has line tables.
std::unique_ptr<llvm::Module> lowerMission(const ir::Mission& mission,
                                           const ir::MissionFacts& facts,
                                           const llvm::TargetMachine& machine,
                                           const support::SourceManager* sources,
                                           llvm::LLVMContext& context);

}  // namespace glider::codegen
