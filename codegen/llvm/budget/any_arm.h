// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/budget/architecture.h"

#include <llvm/Support/TargetSelect.h>

namespace glider::codegen {

/// ARM in 32 bits: what both of its encodings have in common.
class AnyArm : public Architecture {
 public:
  [[nodiscard]] const StackMachine& stackMachine() const override { return kArmStack; }
  void initialiseDisassembler() const override { LLVMInitializeARMDisassembler(); }
  [[nodiscard]] uint8_t numberOf(llvm::StringRef name) const override {
    return armRegister(name.lower());
  }
  [[nodiscard]] Flow flow(const Written& written) const override { return armFlow(written); }
  [[nodiscard]] StackEffect stack(const Written& written) const override {
    return armStack(written);
  }
};

}  // namespace glider::codegen
