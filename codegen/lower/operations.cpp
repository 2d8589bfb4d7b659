// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/lower/expressions.h"
#include "codegen/lower/order_comparison.h"
#include "ir/core/ops.h"
#include "support/check.h"

#include <llvm/IR/Intrinsics.h>

namespace glider::codegen {

using ir::Op;
using llvm::Value;

Value* Expressions::arithmetic(const ir::Expr& expr) {
  auto operand = [&](size_t i) { return this->operand(expr, i); };
  switch (expr.op) {
    case Op::Negate:
      return builder_.CreateFNeg(operand(0));
    case Op::Abs:
      return builder_.CreateUnaryIntrinsic(llvm::Intrinsic::fabs, operand(0));
    case Op::Sqrt:
      return settle(builder_.CreateUnaryIntrinsic(llvm::Intrinsic::sqrt, operand(0)));
    case Op::Add:
      return settle(builder_.CreateFAdd(operand(0), operand(1)));
    case Op::Subtract:
      return settle(builder_.CreateFSub(operand(0), operand(1)));
    case Op::Multiply:
      return settle(builder_.CreateFMul(operand(0), operand(1)));
    case Op::Divide:
      return settle(builder_.CreateFDiv(operand(0), operand(1)));
    case Op::Clamp:
      return clamp(operand(0), operand(1), operand(2));
    case Op::Select: {
      const Lowered& condition = made_.at(expr.operands[0].index);
      return builder_.CreateSelect(
          condition.value, operand(1),
          builder_.CreateSelect(condition.is_false, operand(2), unknown()));
    }
    case Op::Min:
    case Op::Max:
      return smallerOrLarger(expr.op, operand(0), operand(1));
    default:
      CHECK(false, "an operation that codegen does not know");
  }
}

/// The functions of runtime/numbers, which settle their results.
Value* Expressions::function(const ir::Expr& expr) {
  auto operand = [&](size_t i) { return this->operand(expr, i); };
  switch (expr.op) {
    case Op::Sin:
      return callPure("gliderSin", {operand(0)});
    case Op::Cos:
      return callPure("gliderCos", {operand(0)});
    case Op::Tan:
      return callPure("gliderTan", {operand(0)});
    case Op::Atan2:
      return callPure("gliderAtan2", {operand(0), operand(1)});
    case Op::Distance:
      return callPure("gliderDistance", {operand(0), operand(1), operand(2), operand(3)});
    default:
      return callPure("gliderBearing", {operand(0), operand(1), operand(2), operand(3)});
  }
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

/// Ordered comparisons both ways: an unknown operand makes neither bit true.
Expressions::Lowered Expressions::comparison(const ir::Expr& expr) {
  using llvm::CmpInst;
  Value* a = operand(expr, 0);
  if (expr.op == Op::Known) {
    Value* known = isKnown(a);
    return {known, builder_.CreateNot(known)};
  }
  Value* b = operand(expr, 1);
  if (lowering_.soft_float && hasPlainOrder(lowering_.mission[expr.operands[0]]) &&
      hasPlainOrder(lowering_.mission[expr.operands[1]])) {
    return {compareByOrder(builder_, expr.op, a, b),
            compareByOrder(builder_, ir::negated(expr.op), a, b)};
  }
  auto both = [&](CmpInst::Predicate yes, CmpInst::Predicate no) {
    return Lowered{builder_.CreateFCmp(yes, a, b), builder_.CreateFCmp(no, a, b)};
  };
  switch (expr.op) {
    case Op::Less:
      return both(CmpInst::FCMP_OLT, CmpInst::FCMP_OGE);
    case Op::LessEqual:
      return both(CmpInst::FCMP_OLE, CmpInst::FCMP_OGT);
    case Op::Greater:
      return both(CmpInst::FCMP_OGT, CmpInst::FCMP_OLE);
    case Op::GreaterEqual:
      return both(CmpInst::FCMP_OGE, CmpInst::FCMP_OLT);
    case Op::Equal:
      return both(CmpInst::FCMP_OEQ, CmpInst::FCMP_ONE);
    default:
      return both(CmpInst::FCMP_ONE, CmpInst::FCMP_OEQ);
  }
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

/// The runtime's own function, so that there is one such rule. A call also takes the value through
/// memory on the 486, which rounds it to 64 bits.
Value* Expressions::settle(Value* value) {
  return callPure("gliderSettle", {value});
}

/// A function of doubles that depends on nothing else.
Value* Expressions::callPure(const char* name, llvm::ArrayRef<Value*> arguments) {
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
