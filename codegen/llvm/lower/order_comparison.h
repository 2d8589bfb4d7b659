// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <llvm/IR/IRBuilder.h>

/// Comparisons of doubles as whole numbers (runtime/abi/order.h), for a processor without an FPU:
/// a handful of instructions in place of a call.
namespace glider::codegen {

/// Whether `expr` never is -0, nor another NaN than the one of `unknown`: what settles, and a
/// constant.
bool hasPlainOrder(const ir::Expr& expr);

/// The bit that says that `op` (Less to NotEqual) holds between two doubles of plain order; false
/// if either is unknown.
llvm::Value* compareByOrder(llvm::IRBuilder<>& builder, ir::Op op, llvm::Value* a, llvm::Value* b);

/// The bit that says that a double, whatever its order, is not NaN.
llvm::Value* isKnownByBits(llvm::IRBuilder<>& builder, llvm::Value* value);

llvm::Value* haveSameBits(llvm::IRBuilder<>& builder, llvm::Value* a, llvm::Value* b);

}  // namespace glider::codegen
