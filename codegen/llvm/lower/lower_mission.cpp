// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/lower/lower_mission.h"

#include "codegen/llvm/lower/body.h"
#include "codegen/llvm/lower/lowering.h"
#include "ir/core/sampling.h"
#include "ir/core/validate.h"
#include "support/check.h"

#include <llvm/IR/Verifier.h>
#include <llvm/Support/raw_ostream.h>

#include <set>

namespace glider::codegen {
namespace {

/// The flags that clang sets for the runtime on the same machine: position independence is also a
/// property of the module.
void setRelocation(llvm::Module& module, const llvm::TargetMachine& machine) {
  if (machine.getRelocationModel() == llvm::Reloc::PIC_) {
    module.setPICLevel(llvm::PICLevel::BigPIC);
  }
}

llvm::Function* lowerProfile(Lowering& lowering, uint32_t index) {
  return lowerFly(lowering, index, lowering.mission.states[index].profile, "profile",
                  lowering.index.memory_blocks[index].profile);
}

llvm::Function* lowerStateAdvance(Lowering& lowering, uint32_t index) {
  const ir::State& state = lowering.mission.states[index];
  const auto sample = [&](Body& body) { lowerSampling(body, state); };
  return lowerAdvance(lowering, lowering.index.state_temporals[index],
                      ir::samplingChanges(lowering.mission, state) ? Lowers(sample) : nullptr,
                      state.name, state.range);
}

llvm::Function* lowerAlwaysAdvance(Lowering& lowering, support::SourceRange range) {
  const ir::BlockId every_tick = lowering.mission.every_tick;
  const auto run = [&](Body& body) { lowerBlock(body, every_tick); };
  return lowerAdvance(lowering, lowering.index.always_temporals,
                      every_tick.valid() ? Lowers(run) : nullptr, "always", range);
}

/// `profile`: whether the ticks of its profile are in this part.
StateFunctions lowerState(Lowering& lowering, uint32_t index, bool profile) {
  const ir::State& state = lowering.mission.states[index];
  const MissionIndex::Blocks& blocks = lowering.index.memory_blocks[index];
  StateFunctions functions;
  functions.guards = lowerGuards(lowering, state.cases, state.table,
                                 lowering.index.table_memory[index], state.name, state.range);
  functions.act = lowerAct(lowering, state.cases, state.name, state.range);
  functions.enter = lowerEnter(lowering, index);
  functions.advance = lowerStateAdvance(lowering, index);
  functions.profile = profile ? lowerProfile(lowering, index)
                              : declareFly(lowering, index, state.profile, "profile");
  functions.route = lowerFly(lowering, index, state.route, "route", blocks.route);
  functions.foresee = lowerForesee(lowering, index);
  return functions;
}

void lowerStates(Lowering& lowering, const MissionPart& part) {
  const std::set<uint32_t> states(part.states.begin(), part.states.end());
  const std::set<uint32_t> profiles(part.profiles.begin(), part.profiles.end());
  for (const uint32_t state : states) {
    lowerStateInfo(lowering, state, lowerState(lowering, state, profiles.contains(state)));
  }
  for (const uint32_t state : profiles) {
    llvm::Function* alone = states.contains(state) ? nullptr : lowerProfile(lowering, state);
    if (alone != nullptr) {
      showToParts(*alone);
    }
  }
}

MissionFunctions lowerFunctions(Lowering& lowering) {
  const ir::Mission& mission = lowering.mission;
  const support::SourceRange range = mission.states.front().range;
  MissionFunctions functions;
  functions.begin = lowerBegin(lowering);
  functions.advance = lowerAlwaysAdvance(lowering, range);
  functions.guards = lowerGuards(lowering, mission.always, mission.always_table,
                                 lowering.index.always_table_memory, "always", range);
  functions.act = lowerAct(lowering, mission.always, "always", range);
  functions.condition = lowerCondition(lowering);
  return functions;
}

}  // namespace

MissionPart wholeOf(const ir::Mission& mission) {
  MissionPart whole;
  for (uint32_t i = 0; i < mission.states.size(); ++i) {
    whole.states.push_back(i);
    whole.profiles.push_back(i);
  }
  return whole;
}

std::unique_ptr<llvm::Module> lowerMission(const Input& input, const MissionPart& part,
                                           const llvm::TargetMachine& machine,
                                           const support::SourceManager* sources,
                                           llvm::LLVMContext& context) {
  CHECK(!part.head || ir::validate(input.mission).empty(), "a mission that does not hold together");
  auto module = std::make_unique<llvm::Module>(input.mission.name, context);
  module->setTargetTriple(machine.getTargetTriple().str());
  module->setDataLayout(machine.createDataLayout());
  setRelocation(*module, machine);
  Lowering lowering{input.mission,
                    input.platform,
                    input.stack_depth,
                    *module,
                    makeAbiTypes(context),
                    DebugInfo(*module, sources, input.mission.states.front().range),
                    indexMission(input.mission),
                    machine.Options.FloatABIType == llvm::FloatABI::Soft};
  if (part.head) {
    lowerTables(lowering, lowerFunctions(lowering));
  }
  lowerStates(lowering, part);
  lowering.debug.finish();
  CHECK(!llvm::verifyModule(*module, &llvm::errs()), "generated code that LLVM refuses");
  return module;
}

}  // namespace glider::codegen
