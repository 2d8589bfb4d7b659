// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/program/optimise.h"

#include <llvm/Analysis/CGSCCPassManager.h>
#include <llvm/Analysis/InlineCost.h>
#include <llvm/Analysis/LoopAnalysisManager.h>
#include <llvm/IR/PassManager.h>
#include <llvm/Passes/PassBuilder.h>
#include <llvm/Transforms/IPO/ElimAvailExtern.h>
#include <llvm/Transforms/IPO/GlobalDCE.h>
#include <llvm/Transforms/IPO/Inliner.h>
#include <llvm/Transforms/InstCombine/InstCombine.h>
#include <llvm/Transforms/Scalar/EarlyCSE.h>
#include <llvm/Transforms/Scalar/SimplifyCFG.h>

#include <utility>

namespace glider::codegen {
namespace {

/// The boards' memory is small and their code runs once in four seconds, so transformations that
/// make code larger are off.
llvm::PipelineTuningOptions tuning() {
  llvm::PipelineTuningOptions options;
  options.LoopInterleaving = false;
  options.LoopVectorization = false;
  options.SLPVectorization = false;
  return options;
}

llvm::FunctionPassManager simplify(bool thoroughly) {
  llvm::FunctionPassManager passes;
  passes.addPass(llvm::EarlyCSEPass(true));
  passes.addPass(llvm::SimplifyCFGPass());
  if (thoroughly) {
    passes.addPass(llvm::InstCombinePass());
    passes.addPass(llvm::EarlyCSEPass(true));
    passes.addPass(llvm::SimplifyCFGPass());
  }
  return passes;
}

/// For a mission and its tick: the tick is already optimised, and a mission is many small functions
/// without loops or local memory. LLVM's own pipeline would find little more and take ten times as
/// long.
llvm::ModulePassManager leanPasses(int level) {
  llvm::ModulePassManager manager;
  if (level > 1) {
    llvm::ModuleInlinerWrapperPass inliner(llvm::getInlineParams(static_cast<unsigned>(level), 0));
    inliner.getPM().addPass(llvm::createCGSCCToFunctionPassAdaptor(simplify(true)));
    manager.addPass(std::move(inliner));
    manager.addPass(llvm::EliminateAvailableExternallyPass());
    manager.addPass(llvm::GlobalDCEPass());  // functions that were inlined everywhere
  } else {
    manager.addPass(llvm::createModuleToFunctionPassAdaptor(simplify(false)));
  }
  return manager;
}

llvm::ModulePassManager passes(llvm::PassBuilder& builder, int level) {
  switch (level) {
    case 0:
      return builder.buildO0DefaultPipeline(llvm::OptimizationLevel::O0);
    case 1:
    case 2:
      return leanPasses(level);
    default:
      return builder.buildPerModuleDefaultPipeline(llvm::OptimizationLevel::O3);
  }
}

/// On ARM in 64 bits a switch that jumps by a table ends as a call of another function in this
/// one's place does: budgets need the code to say which it is.
void compareInSwitches(llvm::Module& module) {
  for (llvm::Function& function : module) {
    function.addFnAttr("no-jump-tables", "true");
  }
}

}  // namespace

void optimise(llvm::Module& module, llvm::TargetMachine& machine, int level) {
  if (machine.getTargetTriple().isAArch64()) {
    compareInSwitches(module);
  }
  llvm::LoopAnalysisManager loops;
  llvm::FunctionAnalysisManager functions;
  llvm::CGSCCAnalysisManager components;
  llvm::ModuleAnalysisManager modules;
  llvm::PassBuilder builder(&machine, tuning());
  builder.registerModuleAnalyses(modules);
  builder.registerCGSCCAnalyses(components);
  builder.registerFunctionAnalyses(functions);
  builder.registerLoopAnalyses(loops);
  builder.crossRegisterProxies(loops, functions, components, modules);
  llvm::ModulePassManager manager;
  manager.addPass(llvm::GlobalDCEPass());  // parts of the runtime that this mission does not use
  manager.addPass(passes(builder, level));
  manager.run(module, modules);
}

}  // namespace glider::codegen
