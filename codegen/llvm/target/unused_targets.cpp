// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include <llvm/Config/llvm-config.h>

// lld registers every target that LLVM was built with. Only ours are linked: these
// definitions replace the others, and the linker leaves their code generators out (the process
// starts in 5 ms instead of 20).
#define GLIDER_UNUSED(target)                  \
  extern "C" {                                 \
  void LLVMInitialize##target##TargetInfo() {} \
  void LLVMInitialize##target##Target() {}     \
  void LLVMInitialize##target##TargetMC() {}   \
  void LLVMInitialize##target##AsmPrinter() {} \
  void LLVMInitialize##target##AsmParser() {}  \
  }

#include "codegen/llvm/target/unused_targets.def"
