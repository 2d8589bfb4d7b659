// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/lower/abi_types.h"
#include "codegen/llvm/lower/debug_info.h"
#include "codegen/llvm/lower/mission_index.h"
#include "ir/core/mission.h"
#include "platforms/load/platform.h"

#include <llvm/ADT/STLFunctionalExtras.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/Module.h>

#include <map>
#include <string>
#include <vector>

/// Shared by the parts of the lowering; one file for each function family. The entry point is
/// lower_mission.h.
namespace glider::codegen {

struct Body;

struct Lowering {
  const ir::Mission& mission;
  const platforms::Platform& platform;
  uint32_t stack_depth;  ///< greatest number of frames on the call stack
  llvm::Module& module;
  AbiTypes types;
  DebugInfo debug;
  MissionIndex index;
  bool soft_float;                                 ///< the processor has no FPU
  std::map<std::string, llvm::Constant*> texts{};  ///< of text()
  std::vector<llvm::Constant*> window_shapes =
      std::vector<llvm::Constant*>(mission.temporals.size());  ///< null: not made yet
  std::vector<llvm::Constant*> tables =
      std::vector<llvm::Constant*>(mission.tables.size());  ///< the same
  std::vector<llvm::Function*> uses =
      std::vector<llvm::Function*>(mission.uses.size());  ///< the same
};

/// A constant string; equal strings share one constant.
llvm::Constant* text(Lowering& lowering, const std::string& text);
/// A field of the struct that `base` points to.
llvm::Value* loadField(llvm::IRBuilder<>& builder, llvm::StructType* type, llvm::Value* base,
                       unsigned index);

/// The function (context, arguments as numbers) that returns the value of a use of a C function in
/// this tick: calls the C function the first time.
llvm::Function* lowerUse(Lowering& lowering, ir::UseId use);

/// The functions that a mission is made of, as runtime/abi/glider_abi.h describes them: one for
/// each state keeps the work linear in the number of states. Null: it would do nothing.
struct StateFunctions {
  llvm::Function* guards = nullptr;
  llvm::Function* act = nullptr;
  llvm::Function* enter = nullptr;
  llvm::Function* advance = nullptr;
  llvm::Function* profile = nullptr;
  llvm::Function* route = nullptr;
  llvm::Function* foresee = nullptr;
};
struct MissionFunctions {
  llvm::Function* begin = nullptr;
  llvm::Function* advance = nullptr;
  llvm::Function* guards = nullptr;
  llvm::Function* act = nullptr;
  llvm::Function* condition = nullptr;
};

/// `name` says whose functions they are: "always", or the state's name. `memory` is where the table
/// of the list, if it has one, stores its state (GliderContext::intervals).
llvm::Function* lowerGuards(Lowering& lowering, const std::vector<ir::Case>& cases,
                            const ir::GuardTable& table, uint32_t memory, const std::string& name,
                            support::SourceRange range);
llvm::Function* lowerAct(Lowering& lowering, const std::vector<ir::Case>& cases,
                         const std::string& name, support::SourceRange range);
using Lowers = llvm::function_ref<void(Body&)>;
/// The temporals advance, then what `then` lowers runs; null: nothing does.
llvm::Function* lowerAdvance(Lowering& lowering, const std::vector<ir::TemporalId>& temporals,
                             Lowers then, const std::string& name, support::SourceRange range);
llvm::Function* lowerEnter(Lowering& lowering, uint32_t state);
/// The function of a profile or route; `kind` is "profile" or "route".
llvm::Function* lowerFly(Lowering& lowering, uint32_t state, const ir::Activity& activity,
                         const std::string& kind, uint32_t memory_block);
/// Declares the same function, which another part of the mission defines.
llvm::Function* declareFly(Lowering& lowering, uint32_t state, const ir::Activity& activity,
                           const std::string& kind);
/// GliderForesee of a state; null: the SBC never sleeps in it.
llvm::Function* lowerForesee(Lowering& lowering, uint32_t state);
llvm::Function* lowerBegin(Lowering& lowering);
llvm::Function* lowerCondition(Lowering& lowering);

/// The constant that describes a state to the runtime: named by its number, visible to the other
/// parts of the mission.
void lowerStateInfo(Lowering& lowering, uint32_t state, const StateFunctions& functions);
/// The constant `gliderMission` with its tables, and `gliderContextMemory`.
void lowerTables(Lowering& lowering, const MissionFunctions& functions);

}  // namespace glider::codegen
