// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <llvm/IR/IRBuilder.h>

/// Comparisons of doubles as whole numbers (runtime/abi/order.h), for a processor without an FPU: a
/// few instructions instead of a call.
namespace glider::codegen {

/// Whether `expr` is never -0, and never a NaN other than that of `unknown`: a settled value or a
/// constant.
bool hasPlainOrder(const ir::Expr& expr);

/// The bit that is set if `op` (Less to NotEqual) holds between two doubles of plain order; not set
/// if either is unknown.
llvm::Value* compareByOrder(llvm::IRBuilder<>& builder, ir::Op op, llvm::Value* a, llvm::Value* b);

/// The bit that is set if a double is not NaN, whether or not its order is plain.
llvm::Value* isKnownByBits(llvm::IRBuilder<>& builder, llvm::Value* value);

llvm::Value* haveSameBits(llvm::IRBuilder<>& builder, llvm::Value* a, llvm::Value* b);

}  // namespace glider::codegen
