// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/budget/architecture.h"

namespace glider::codegen {

std::unique_ptr<Architecture> Architecture::of(const llvm::Triple& triple) {
  switch (triple.getArch()) {
    case llvm::Triple::x86:
      return makeX86();
    case llvm::Triple::arm:
      return makeArm();
    case llvm::Triple::thumb:
      return makeThumb();
    case llvm::Triple::aarch64:
      return makeAArch64();
    default:
      return nullptr;
  }
}

}  // namespace glider::codegen
