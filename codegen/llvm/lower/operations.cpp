// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/lower/expressions.h"
#include "codegen/llvm/lower/order_comparison.h"
#include "ir/core/ops.h"
#include "support/check.h"

#include <llvm/IR/Intrinsics.h>

namespace glider::codegen {

using ir::Op;
using llvm::Value;

Value* Expressions::unary(const ir::Expr& expr) {
  Value* x = operand(expr, 0);
  switch (ir::opIn<ir::UnaryOp>(expr.op)) {
    case ir::UnaryOp::Negate:
      return builder_.CreateFNeg(x);
    case ir::UnaryOp::Abs:
      return builder_.CreateUnaryIntrinsic(llvm::Intrinsic::fabs, x);
    case ir::UnaryOp::Sqrt:
      return settle(builder_.CreateUnaryIntrinsic(llvm::Intrinsic::sqrt, x));
  }
  CHECK(false, "an operation on one number that codegen does not know");
}

Value* Expressions::binary(const ir::Expr& expr) {
  Value* a = operand(expr, 0);
  Value* b = operand(expr, 1);
  switch (ir::opIn<ir::BinaryOp>(expr.op)) {
    case ir::BinaryOp::Add:
      return settle(builder_.CreateFAdd(a, b));
    case ir::BinaryOp::Subtract:
      return settle(builder_.CreateFSub(a, b));
    case ir::BinaryOp::Multiply:
      return settle(builder_.CreateFMul(a, b));
    case ir::BinaryOp::Divide:
      return settle(builder_.CreateFDiv(a, b));
    case ir::BinaryOp::Min:
    case ir::BinaryOp::Max:
      return smallerOrLarger(expr.op, a, b);
  }
  CHECK(false, "an operation on two numbers that codegen does not know");
}

/// The functions of runtime/numbers settle their own results.
Value* Expressions::function(const ir::Expr& expr) {
  std::vector<Value*> operands;
  for (uint32_t i = 0; i < ir::operandCount(expr); ++i) {
    operands.push_back(operand(expr, i));
  }
  return callPure(ir::symbolOf(ir::opIn<ir::FunctionOp>(expr.op)), operands);
}

Value* Expressions::smallerOrLarger(Op op, Value* a, Value* b) {
  Value* take_b = op == Op::Min ? builder_.CreateFCmpOLT(b, a) : builder_.CreateFCmpOLT(a, b);
  return unknownIf(builder_.CreateFCmpUNO(a, b), builder_.CreateSelect(take_b, b, a));
}

Value* Expressions::clamp(Value* x, Value* lowest, Value* highest) {
  Value* capped = builder_.CreateSelect(builder_.CreateFCmpOLT(highest, x), highest, x);
  Value* clamped = builder_.CreateSelect(builder_.CreateFCmpOLT(x, lowest), lowest, capped);
  Value* unknown = builder_.CreateOr(builder_.CreateFCmpUNO(x, lowest),
                                     builder_.CreateFCmpUNO(highest, highest));
  return unknownIf(unknown, clamped);
}

/// The numbers of a table, in memory that does not change.
llvm::Constant* Expressions::table(ir::TableId id) {
  llvm::Constant*& found = lowering_.tables.at(id.index);
  if (found == nullptr) {
    llvm::Constant* numbers =
        llvm::ConstantDataArray::get(builder_.getContext(), lowering_.mission[id].values);
    auto* variable = new llvm::GlobalVariable(lowering_.module, numbers->getType(), true,
                                              llvm::GlobalValue::PrivateLinkage, numbers, "table");
    variable->setUnnamedAddr(llvm::GlobalValue::UnnamedAddr::Global);
    variable->setAlignment(llvm::Align(8));
    found = variable;
  }
  return found;
}

/// The number is compared with the table's ends before it is converted to an integer, which it may
/// not fit.
Value* Expressions::element(const ir::Expr& expr) {
  Value* number = operand(expr, 0);
  llvm::Type* type = builder_.getDoubleTy();
  const auto count = static_cast<double>(lowering_.mission[expr.table].values.size());
  Value* zero = llvm::ConstantFP::get(type, 0.0);
  Value* inside =
      builder_.CreateAnd(builder_.CreateFCmpOGE(number, zero),
                         builder_.CreateFCmpOLT(number, llvm::ConstantFP::get(type, count)));
  Value* index =
      builder_.CreateFPToSI(builder_.CreateSelect(inside, number, zero), builder_.getInt32Ty());
  Value* whole = builder_.CreateFCmpOEQ(builder_.CreateSIToFP(index, type), number);
  Value* place = builder_.CreateInBoundsGEP(type, table(expr.table), index);
  return builder_.CreateSelect(builder_.CreateAnd(inside, whole), builder_.CreateLoad(type, place),
                               unknown());
}

Expressions::Lowered Expressions::known(const ir::Expr& expr) {
  Value* yes = isKnown(operand(expr, 0));
  return {yes, builder_.CreateNot(yes)};
}

/// Ordered comparisons in both directions: with an unknown operand neither bit is set.
Expressions::Lowered Expressions::comparison(const ir::Expr& expr) {
  using llvm::CmpInst;
  Value* a = operand(expr, 0);
  Value* b = operand(expr, 1);
  if (lowering_.soft_float && hasPlainOrder(lowering_.mission[expr.operands[0]]) &&
      hasPlainOrder(lowering_.mission[expr.operands[1]])) {
    return {compareByOrder(builder_, expr.op, a, b),
            compareByOrder(builder_, ir::negated(expr.op), a, b)};
  }
  auto both = [&](CmpInst::Predicate yes, CmpInst::Predicate no) {
    return Lowered{builder_.CreateFCmp(yes, a, b), builder_.CreateFCmp(no, a, b)};
  };
  switch (ir::opIn<ir::ComparisonOp>(expr.op)) {
    case ir::ComparisonOp::Less:
      return both(CmpInst::FCMP_OLT, CmpInst::FCMP_OGE);
    case ir::ComparisonOp::LessEqual:
      return both(CmpInst::FCMP_OLE, CmpInst::FCMP_OGT);
    case ir::ComparisonOp::Greater:
      return both(CmpInst::FCMP_OGT, CmpInst::FCMP_OLE);
    case ir::ComparisonOp::GreaterEqual:
      return both(CmpInst::FCMP_OGE, CmpInst::FCMP_OLT);
    case ir::ComparisonOp::Equal:
      return both(CmpInst::FCMP_OEQ, CmpInst::FCMP_ONE);
    case ir::ComparisonOp::NotEqual:
      return both(CmpInst::FCMP_ONE, CmpInst::FCMP_OEQ);
  }
  CHECK(false, "a comparison that codegen does not know");
}

Value* Expressions::isKnown(Value* number) {
  return lowering_.soft_float ? isKnownByBits(builder_, number)
                              : builder_.CreateFCmpORD(number, number);
}

Expressions::Lowered Expressions::logic(const ir::Expr& expr) {
  const Lowered& a = made_.at(expr.operands[0].index);
  if (expr.op == Op::Not) {
    return {a.is_false, a.value};
  }
  const Lowered& b = made_.at(expr.operands[1].index);
  if (expr.op == Op::And) {
    return {builder_.CreateAnd(a.value, b.value), builder_.CreateOr(a.is_false, b.is_false)};
  }
  return {builder_.CreateOr(a.value, b.value), builder_.CreateAnd(a.is_false, b.is_false)};
}

/// Calls the runtime's own function, so that this rule is implemented only once. On the 486 a call
/// also passes the value through memory, which rounds it to 64 bits.
Value* Expressions::settle(Value* value) {
  return callPure("gliderSettle", {value});
}

/// A function of doubles that depends on nothing else.
Value* Expressions::callPure(llvm::StringRef name, llvm::ArrayRef<Value*> arguments) {
  llvm::Type* number = builder_.getDoubleTy();
  const std::vector<llvm::Type*> types(arguments.size(), number);
  llvm::CallInst* call = builder_.CreateCall(
      lowering_.module.getOrInsertFunction(name, llvm::FunctionType::get(number, types, false)),
      arguments);
  call->setDoesNotThrow();
  call->setDoesNotAccessMemory();
  call->addFnAttr(llvm::Attribute::WillReturn);
  return call;
}

}  // namespace glider::codegen
