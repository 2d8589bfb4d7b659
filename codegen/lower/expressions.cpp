// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/lower/expressions.h"

#include <llvm/IR/Intrinsics.h>

#include <algorithm>
#include <vector>

#include "ir/core/ops.h"
#include "support/check.h"

namespace glider::codegen {

using ir::Op;
using llvm::Value;

Value* Expressions::number(ir::ExprId id) {
  const Lowered& lowered = lower(id);
  CHECK(lowered.is_false == nullptr, "a truth value where a number belongs");
  return lowered.value;
}

Value* Expressions::isTrue(ir::ExprId id) {
  const Lowered& lowered = lower(id);
  CHECK(lowered.is_false != nullptr, "a number where a truth value belongs");
  return lowered.value;
}

/// Without recursion, whatever the depth: operands have smaller ids, so the order of ids is an order of evaluation.
const Expressions::Lowered& Expressions::lower(ir::ExprId root) {
  std::vector<uint32_t> needed;
  std::vector<uint32_t> open{root.index};
  std::unordered_map<uint32_t, bool> seen;
  while (!open.empty()) {
    const uint32_t index = open.back();
    open.pop_back();
    if (made_.contains(index) || !seen.emplace(index, true).second) {
      continue;
    }
    needed.push_back(index);
    const ir::Expr& expr = lowering_.mission[ir::ExprId{index}];
    for (uint32_t i = 0; i < ir::opInfo(expr.op).operands; ++i) {
      open.push_back(expr.operands.at(i).index);
    }
  }
  std::ranges::sort(needed);
  for (const uint32_t index : needed) {
    const ir::Expr& expr = lowering_.mission[ir::ExprId{index}];
    lowering_.debug.locate(builder_, expr.range);
    made_.emplace(index, lowerOne(expr));
  }
  return made_.at(root.index);
}

Expressions::Lowered Expressions::lowerOne(const ir::Expr& expr) {
  switch (expr.op) {
    case Op::True:
      return {builder_.getTrue(), builder_.getFalse()};
    case Op::False:
      return {builder_.getFalse(), builder_.getTrue()};
    case Op::Constant:
    case Op::Sensor:
    case Op::MissionTime:
    case Op::StateTime:
    case Op::ResumeTime:
    case Op::Age:
      return {leaf(expr), nullptr};
    case Op::Negate:
    case Op::Abs:
    case Op::Sqrt:
    case Op::Add:
    case Op::Subtract:
    case Op::Multiply:
    case Op::Divide:
    case Op::Min:
    case Op::Max:
    case Op::Clamp:
      return {arithmetic(expr), nullptr};
    case Op::Less:
    case Op::LessEqual:
    case Op::Greater:
    case Op::GreaterEqual:
    case Op::Equal:
    case Op::NotEqual:
    case Op::Known:
      return comparison(expr);
    case Op::Not:
    case Op::And:
    case Op::Or:
      return logic(expr);
  }
  CHECK(false, "an operation that codegen does not know");
}

Value* Expressions::leaf(const ir::Expr& expr) {
  namespace context = field::GliderContext;
  switch (expr.op) {
    case Op::Constant:
      return llvm::ConstantFP::get(builder_.getDoubleTy(), expr.number);
    case Op::Sensor:
      return readingField(expr.sensor, field::GliderReading::value);
    case Op::MissionTime:
      return contextField(context::mission_time);
    case Op::StateTime:
      return timeSince(contextField(context::entered));
    case Op::ResumeTime:
      return timeSince(contextField(context::resumed));
    default:
      return timeSince(readingField(expr.sensor, field::GliderReading::updated));
  }
}

Value* Expressions::arithmetic(const ir::Expr& expr) {
  auto operand = [&](size_t i) { return made_.at(expr.operands.at(i).index).value; };
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
    default:
      return smallerOrLarger(expr.op, operand(0), operand(1));
  }
}

Value* Expressions::smallerOrLarger(Op op, Value* a, Value* b) {
  Value* take_b =
      op == Op::Min ? builder_.CreateFCmpOLT(b, a) : builder_.CreateFCmpOLT(a, b);
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
  Value* a = made_.at(expr.operands[0].index).value;
  if (expr.op == Op::Known) {
    return {builder_.CreateFCmpORD(a, a), builder_.CreateFCmpUNO(a, a)};
  }
  Value* b = made_.at(expr.operands[1].index).value;
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

/// The runtime's own function, so that there is one such rule. A call also takes the value through memory on the 486,
/// which rounds it to 64 bits.
Value* Expressions::settle(Value* value) {
  llvm::Type* number = builder_.getDoubleTy();
  llvm::CallInst* call = builder_.CreateCall(
      lowering_.module.getOrInsertFunction("gliderSettle",
                                           llvm::FunctionType::get(number, {number}, false)),
      {value});
  call->setDoesNotThrow();
  call->setDoesNotAccessMemory();
  call->addFnAttr(llvm::Attribute::WillReturn);
  return call;
}

Value* Expressions::timeSince(Value* then) {
  return settle(builder_.CreateFSub(contextField(field::GliderContext::mission_time), then));
}

Value* Expressions::readingField(ir::SensorId sensor, unsigned index) {
  Value* readings = contextField(field::GliderContext::readings);
  Value* reading = builder_.CreateConstInBoundsGEP1_32(lowering_.types.GliderReading, readings,
                                                       sensor.index);
  return loadField(builder_, lowering_.types.GliderReading, reading, index);
}

Value* Expressions::contextField(unsigned index) {
  return loadField(builder_, lowering_.types.GliderContext, context_, index);
}

Value* Expressions::unknownIf(Value* condition, Value* otherwise) {
  return builder_.CreateSelect(condition, llvm::ConstantFP::getNaN(builder_.getDoubleTy()),
                               otherwise);
}

}  // namespace glider::codegen
