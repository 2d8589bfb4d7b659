// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include <llvm/Config/llvm-config.h>

// lld registers every target that LLVM was built with. We link two of them: for the others these
// definitions stand in, and the linker leaves their code generators out (5 ms instead of 20 to
// start the process).
#define GLIDER_UNUSED(target)                  \
  extern "C" {                                 \
  void LLVMInitialize##target##TargetInfo() {} \
  void LLVMInitialize##target##Target() {}     \
  void LLVMInitialize##target##TargetMC() {}   \
  void LLVMInitialize##target##AsmPrinter() {} \
  void LLVMInitialize##target##AsmParser() {}  \
  }

#include "codegen/llvm/target/unused_targets.def"
