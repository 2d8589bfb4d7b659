// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/lower/abi_types.h"
#include "codegen/lower/debug_info.h"
#include "codegen/lower/mission_index.h"
#include "ir/core/mission.h"

#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/Module.h>

#include <map>
#include <string>
#include <vector>

/// What the parts of the lowering share; one file a function family. lower_mission.h is the way in.
namespace glider::codegen {

struct Lowering {
  const ir::Mission& mission;
  const ir::MissionFacts& facts;
  llvm::Module& module;
  AbiTypes types;
  DebugInfo debug;
  MissionIndex index;
  std::map<std::string, llvm::Constant*> texts{};  ///< of text()
  std::vector<llvm::Constant*> window_shapes =
      std::vector<llvm::Constant*>(mission.temporals.size());  ///< null: not made yet
  std::vector<llvm::Constant*> tables =
      std::vector<llvm::Constant*>(mission.tables.size());  ///< the same
  std::vector<llvm::Function*> uses =
      std::vector<llvm::Function*>(mission.uses.size());  ///< the same
};

/// A constant string; equal ones are one.
llvm::Constant* text(Lowering& lowering, const std::string& text);
/// A field of the struct that `base` points to.
llvm::Value* loadField(llvm::IRBuilder<>& builder, llvm::StructType* type, llvm::Value* base,
                       unsigned index);

/// The function (context, arguments as numbers) that gives what a use of a C function is worth in
/// this tick: calls it the first time.
llvm::Function* lowerUse(Lowering& lowering, ir::UseId use);

/// The functions that a mission is made of, as runtime/abi/glider_abi.h describes them. Each goes
/// on to a function of the current state: one a state keeps the work linear in their number.
llvm::Function* lowerBegin(Lowering& lowering);
llvm::Function* lowerAdvance(Lowering& lowering);
llvm::Function* lowerGuards(Lowering& lowering);
llvm::Function* lowerAct(Lowering& lowering);
llvm::Function* lowerEnter(Lowering& lowering);
llvm::Function* lowerFly(Lowering& lowering);
llvm::Function* lowerCondition(Lowering& lowering);
llvm::Function* lowerLogValue(Lowering& lowering);

struct MissionFunctions {
  llvm::Function* begin = nullptr;
  llvm::Function* advance = nullptr;
  llvm::Function* guards = nullptr;
  llvm::Function* act = nullptr;
  llvm::Function* enter = nullptr;
  llvm::Function* fly = nullptr;
  llvm::Function* condition = nullptr;
  llvm::Function* log_value = nullptr;
};
/// The constant `gliderMission` with its tables, and `gliderContextMemory`.
void lowerTables(Lowering& lowering, const MissionFunctions& functions);

}  // namespace glider::codegen
