// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/lower/abi_types.h"
#include "codegen/lower/debug_info.h"
#include "ir/core/mission.h"

#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/Module.h>

#include <vector>

/// What the parts of the lowering share; one file a function family. lower_mission.h is the way in.
namespace glider::codegen {

struct Lowering {
  const ir::Mission& mission;
  const ir::MissionFacts& facts;
  llvm::Module& module;
  AbiTypes types;
  DebugInfo debug;
};

/// A function of the generated module: internal, does not unwind, strict IEEE.
llvm::Function* makeFunction(Lowering& lowering, llvm::FunctionType* type, const std::string& name);
/// A function called `name` that goes on to by_state[current state] with the same arguments; the
/// context is the first. One function a state keeps the work linear in their number.
llvm::Function* makeDispatcher(Lowering& lowering, const std::string& name,
                               const std::vector<llvm::Function*>& by_state);
/// A field of the struct that `base` points to.
llvm::Value* loadField(llvm::IRBuilder<>& builder, llvm::StructType* type, llvm::Value* base,
                       unsigned index);

/// GliderGuards: the first case of the current state whose guard is true.
llvm::Function* lowerGuards(Lowering& lowering);
/// GliderFly: the current state's profile and route, their arguments evaluated first.
llvm::Function* lowerFly(Lowering& lowering);
/// GliderLogValue: item of the current state.
llvm::Function* lowerLogValue(Lowering& lowering);

/// The three functions that a mission is made of.
struct MissionFunctions {
  llvm::Function* guards = nullptr;
  llvm::Function* fly = nullptr;
  llvm::Function* log_value = nullptr;
};
/// The constant `gliderMission` with its tables, and `gliderContextMemory`.
void lowerTables(Lowering& lowering, const MissionFunctions& functions);

}  // namespace glider::codegen
