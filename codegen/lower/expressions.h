// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <unordered_map>

#include "codegen/lower/lowering.h"

namespace glider::codegen {

/// Makes code for expressions within one function, each expression once: call it only where everything made before
/// dominates the builder's place.
///
/// A number is a double with NaN for unknown. A truth value is a pair of bits, and unknown is neither.
class Expressions {
 public:
  /// `context` is the function's GliderContext*; all three outlive this object.
  Expressions(Lowering& lowering, llvm::IRBuilder<>& builder, llvm::Value* context)
      : lowering_(lowering), builder_(builder), context_(context) {}

  /// The value of a numeric expression.
  llvm::Value* number(ir::ExprId id);
  /// The bit that says that a truth value is true.
  llvm::Value* isTrue(ir::ExprId id);

 private:
  /// A number stands in `value`; a truth value in `value` (is true) and `is_false`.
  struct Lowered {
    llvm::Value* value = nullptr;
    llvm::Value* is_false = nullptr;
  };

  const Lowered& lower(ir::ExprId root);
  Lowered lowerOne(const ir::Expr& expr);
  llvm::Value* leaf(const ir::Expr& expr);
  llvm::Value* arithmetic(const ir::Expr& expr);
  llvm::Value* smallerOrLarger(ir::Op op, llvm::Value* a, llvm::Value* b);
  llvm::Value* clamp(llvm::Value* x, llvm::Value* lowest, llvm::Value* highest);
  Lowered comparison(const ir::Expr& expr);
  Lowered logic(const ir::Expr& expr);
  llvm::Value* settle(llvm::Value* value);
  llvm::Value* timeSince(llvm::Value* then);
  llvm::Value* readingField(ir::SensorId sensor, unsigned index);
  llvm::Value* contextField(unsigned index);
  llvm::Value* unknownIf(llvm::Value* condition, llvm::Value* otherwise);

  Lowering& lowering_;
  llvm::IRBuilder<>& builder_;
  llvm::Value* context_;
  std::unordered_map<uint32_t, Lowered> made_;
};

}  // namespace glider::codegen
