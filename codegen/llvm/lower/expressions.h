// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/lower/lowering.h"
#include "ir/core/ops.h"

#include <unordered_map>
#include <unordered_set>

namespace glider::codegen {

/// Generates code for expressions within one function, each expression once as long as nothing can
/// have changed it. It must only be called where everything generated before dominates the
/// builder's place, and rollBack() must be called where that ends.
///
/// A number is a double with NaN for unknown. A truth value is a pair of bits; for unknown neither
/// is set.
class Expressions {
 public:
  /// `context` is the function's GliderContext*; all three outlive this object.
  Expressions(Lowering& lowering, llvm::IRBuilder<>& builder, llvm::Value* context)
      : lowering_(lowering), builder_(builder), context_(context) {}

  /// The value of a numeric expression.
  llvm::Value* number(ir::ExprId id);
  /// The bit that is set if a truth value is true; if it is false.
  llvm::Value* isTrue(ir::ExprId id);
  llvm::Value* isFalse(ir::ExprId id);
  /// A number unchanged, a truth value as variables store it: 0, 1 or NaN.
  llvm::Value* asNumber(ir::ExprId id);

  /// The bit that is set if a number is not unknown.
  llvm::Value* isKnown(llvm::Value* number);
  /// The truth value stored in a double: 0, 1 or NaN.
  llvm::Value* holdsTrue(llvm::Value* held);
  llvm::Value* holdsFalse(llvm::Value* held);

  /// The address of a variable, a double.
  llvm::Value* placeOf(ir::VariableId id);
  /// The address of slot `slot` of the temporals, a double.
  llvm::Value* temporalSlot(uint32_t slot);
  /// Must be called after every change of a variable's value.
  void changed(ir::VariableId id);
  /// The age of a sensor's newest reading, s.
  llvm::Value* age(ir::SensorId sensor);
  /// Mission time, s.
  llvm::Value* missionTime() { return contextField(field::GliderContext::mission_time); }
  /// Mission time less `then`, settled.
  llvm::Value* timeSince(llvm::Value* then);

  /// The expressions generated up to now.
  struct Mark {
    size_t made = 0;
    uint32_t generation = 0;
  };
  [[nodiscard]] Mark mark() const { return {order_.size(), generation_}; }
  /// Forgets what was generated since `mark`, or everything if a variable has changed since then.
  void rollBack(Mark mark);
  /// Forgets everything.
  void forget();

 private:
  /// A number has only `value`; a truth value has `value` (is true) and `is_false`.
  struct Lowered {
    llvm::Value* value = nullptr;
    llvm::Value* is_false = nullptr;
  };

  const Lowered& lower(ir::ExprId root);
  const Lowered& truth(ir::ExprId id);
  Lowered lowerOne(const ir::Expr& expr);
  llvm::Value* choice(const ir::Expr& expr);
  llvm::Value* element(const ir::Expr& expr);
  Lowered call(const ir::Expr& expr);
  llvm::Constant* table(ir::TableId id);
  llvm::Value* clock(ir::ClockOp op);
  Lowered variable(const ir::Expr& expr);
  Lowered temporal(const ir::Expr& expr);
  llvm::Value* unary(const ir::Expr& expr);
  llvm::Value* binary(const ir::Expr& expr);
  llvm::Value* function(const ir::Expr& expr);
  llvm::Value* smallerOrLarger(ir::Op op, llvm::Value* a, llvm::Value* b);
  llvm::Value* clamp(llvm::Value* x, llvm::Value* lowest, llvm::Value* highest);
  Lowered known(const ir::Expr& expr);
  Lowered comparison(const ir::Expr& expr);
  Lowered logic(const ir::Expr& expr);
  Lowered truthIn(llvm::Value* held);
  llvm::Value* settle(llvm::Value* value);
  llvm::Value* callPure(llvm::StringRef name, llvm::ArrayRef<llvm::Value*> arguments);
  llvm::Value* readingField(ir::SensorId sensor, unsigned index);
  llvm::Value* contextField(unsigned index);
  llvm::Value* unknown() { return llvm::ConstantFP::getNaN(builder_.getDoubleTy()); }
  llvm::Value* unknownIf(llvm::Value* condition, llvm::Value* otherwise);
  llvm::Value* operand(const ir::Expr& expr, size_t i) {
    return made_.at(expr.operands.at(i).index).value;
  }

  Lowering& lowering_;
  llvm::IRBuilder<>& builder_;
  llvm::Value* context_;
  std::unordered_map<uint32_t, Lowered> made_;
  std::vector<uint32_t> order_;          ///< of made_
  std::unordered_set<uint32_t> loaded_;  ///< the variables that made_ may depend on
  uint32_t generation_ = 0;              ///< counts how often everything was forgotten
};

}  // namespace glider::codegen
