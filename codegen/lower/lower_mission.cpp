// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/lower/lower_mission.h"

#include "codegen/lower/lowering.h"
#include "ir/core/validate.h"
#include "support/check.h"

#include <llvm/IR/Verifier.h>
#include <llvm/Support/raw_ostream.h>

namespace glider::codegen {
namespace {

/// The flags that clang gives the runtime for the same machine: position independence is a property
/// of the module too.
void setRelocation(llvm::Module& module, const llvm::TargetMachine& machine) {
  if (machine.getRelocationModel() == llvm::Reloc::PIC_) {
    module.setPICLevel(llvm::PICLevel::BigPIC);
  }
}

}  // namespace

std::unique_ptr<llvm::Module> lowerMission(const ir::Mission& mission,
                                           const ir::MissionFacts& facts,
                                           const llvm::TargetMachine& machine,
                                           const support::SourceManager* sources,
                                           llvm::LLVMContext& context) {
  CHECK(ir::validate(mission).empty(), "a mission that does not hold together");
  auto module = std::make_unique<llvm::Module>(mission.name, context);
  module->setTargetTriple(machine.getTargetTriple().str());
  module->setDataLayout(machine.createDataLayout());
  setRelocation(*module, machine);
  Lowering lowering{mission,
                    facts,
                    *module,
                    makeAbiTypes(context),
                    DebugInfo(*module, sources, mission.states.front().range),
                    indexMission(mission)};
  MissionFunctions functions;
  functions.begin = lowerBegin(lowering);
  functions.advance = lowerAdvance(lowering);
  functions.guards = lowerGuards(lowering);
  functions.act = lowerAct(lowering);
  functions.enter = lowerEnter(lowering);
  functions.fly = lowerFly(lowering);
  functions.condition = lowerCondition(lowering);
  functions.log_value = lowerLogValue(lowering);
  lowerTables(lowering, functions);
  lowering.debug.finish();
  CHECK(!llvm::verifyModule(*module, &llvm::errs()), "generated code that LLVM refuses");
  return module;
}

}  // namespace glider::codegen
