// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/lower/expressions.h"

#include "codegen/llvm/lower/order_comparison.h"
#include "ir/core/ops.h"
#include "support/check.h"

#include <algorithm>
#include <vector>

namespace glider::codegen {

using ir::Op;
using ir::OpGroup;
using llvm::Value;

Value* Expressions::number(ir::ExprId id) {
  const Lowered& lowered = lower(id);
  CHECK(lowered.is_false == nullptr, "a truth value where a number belongs");
  return lowered.value;
}

const Expressions::Lowered& Expressions::truth(ir::ExprId id) {
  const Lowered& lowered = lower(id);
  CHECK(lowered.is_false != nullptr, "a number where a truth value belongs");
  return lowered;
}

Value* Expressions::isTrue(ir::ExprId id) {
  return truth(id).value;
}

Value* Expressions::isFalse(ir::ExprId id) {
  return truth(id).is_false;
}

Value* Expressions::asNumber(ir::ExprId id) {
  const Lowered& lowered = lower(id);
  if (lowered.is_false == nullptr) {
    return lowered.value;
  }
  llvm::Type* type = builder_.getDoubleTy();
  Value* otherwise = builder_.CreateSelect(lowered.is_false, llvm::ConstantFP::get(type, 0.0),
                                           llvm::ConstantFP::getNaN(type));
  return builder_.CreateSelect(lowered.value, llvm::ConstantFP::get(type, 1.0), otherwise);
}

void Expressions::changed(ir::VariableId id) {
  if (loaded_.contains(id.index)) {
    forget();
  }
}

void Expressions::forget() {
  rollBack({0, generation_});
  loaded_.clear();
  ++generation_;
}

/// Entry by entry: clearing the map would cost its size each time.
void Expressions::rollBack(Mark mark) {
  const size_t keep = mark.generation == generation_ ? mark.made : 0;
  for (; order_.size() > keep; order_.pop_back()) {
    made_.erase(order_.back());
  }
}

/// Without recursion, at any depth: operands have smaller ids, so the order of ids is an order of
/// evaluation.
const Expressions::Lowered& Expressions::lower(ir::ExprId root) {
  std::vector<uint32_t> needed;
  std::vector<uint32_t> open{root.index};
  std::unordered_set<uint32_t> seen;
  while (!open.empty()) {
    const uint32_t index = open.back();
    open.pop_back();
    if (made_.contains(index) || !seen.insert(index).second) {
      continue;
    }
    needed.push_back(index);
    const ir::Expr& expr = lowering_.mission[ir::ExprId{index}];
    for (uint32_t i = 0; i < ir::operandCount(expr); ++i) {
      open.push_back(expr.operands.at(i).index);
    }
  }
  std::ranges::sort(needed);
  for (const uint32_t index : needed) {
    const ir::Expr& expr = lowering_.mission[ir::ExprId{index}];
    lowering_.debug.locate(builder_, expr.range);
    made_.emplace(index, lowerOne(expr));
    order_.push_back(index);
  }
  return made_.at(root.index);
}

Expressions::Lowered Expressions::lowerOne(const ir::Expr& expr) {
  switch (ir::groupOf(expr.op)) {
    case OpGroup::Truth:
      return {builder_.getInt1(expr.op == Op::True), builder_.getInt1(expr.op == Op::False)};
    case OpGroup::Constant:
      return {llvm::ConstantFP::get(builder_.getDoubleTy(), expr.number), nullptr};
    case OpGroup::Sensor:
      return {readingField(expr.sensor, field::GliderReading::value), nullptr};
    case OpGroup::Clock:
      return {clock(ir::opIn<ir::ClockOp>(expr.op)), nullptr};
    case OpGroup::Age:
      return {age(expr.sensor), nullptr};
    case OpGroup::Variable:
      return variable(expr);
    case OpGroup::Temporal:
      return temporal(expr);
    case OpGroup::Call:
      return call(expr);
    case OpGroup::Comparison:
      return comparison(expr);
    case OpGroup::Known:
      return known(expr);
    case OpGroup::Logic:
      return logic(expr);
    case OpGroup::Unary:
      return {unary(expr), nullptr};
    case OpGroup::Binary:
      return {binary(expr), nullptr};
    case OpGroup::Function:
      return {function(expr), nullptr};
    case OpGroup::Clamp:
      return {clamp(operand(expr, 0), operand(expr, 1), operand(expr, 2)), nullptr};
    case OpGroup::Select:
      return {choice(expr), nullptr};
    case OpGroup::Element:
      return {element(expr), nullptr};
  }
  CHECK(false, "an operation that codegen does not know");
}

Value* Expressions::choice(const ir::Expr& expr) {
  const Lowered& condition = made_.at(expr.operands[0].index);
  Value* yes = made_.at(expr.operands[1].index).value;
  Value* no = made_.at(expr.operands[2].index).value;
  Value* unknown = llvm::ConstantFP::getNaN(builder_.getDoubleTy());
  return builder_.CreateSelect(condition.value, yes,
                               builder_.CreateSelect(condition.is_false, no, unknown));
}

Value* Expressions::clock(ir::ClockOp op) {
  namespace context = field::GliderContext;
  switch (op) {
    case ir::ClockOp::MissionTime:
      return missionTime();
    case ir::ClockOp::StateTime:
      return timeSince(contextField(context::entered));
    case ir::ClockOp::ResumeTime:
      return timeSince(contextField(context::resumed));
  }
  CHECK(false, "a clock that codegen does not know");
}

Expressions::Lowered Expressions::variable(const ir::Expr& expr) {
  loaded_.insert(expr.variable.index);
  Value* held = builder_.CreateLoad(builder_.getDoubleTy(), placeOf(expr.variable));
  return expr.type.kind == ir::TypeKind::Bool ? truthIn(held) : Lowered{held, nullptr};
}

Expressions::Lowered Expressions::temporal(const ir::Expr& expr) {
  const uint32_t slot = lowering_.index.temporal_slots.at(expr.temporal.index);
  Value* value = builder_.CreateLoad(builder_.getDoubleTy(), temporalSlot(slot));
  return expr.type.kind == ir::TypeKind::Bool ? truthIn(value) : Lowered{value, nullptr};
}

Expressions::Lowered Expressions::call(const ir::Expr& expr) {
  std::vector<Value*> arguments{context_};
  for (uint32_t i = 0; i < ir::operandCount(expr); ++i) {
    arguments.push_back(asNumber(expr.operands.at(i)));
  }
  llvm::CallInst* value = builder_.CreateCall(lowerUse(lowering_, expr.use), arguments);
  value->setDoesNotThrow();
  if (expr.type.kind != ir::TypeKind::Bool) {
    return {value, nullptr};
  }
  // Not truthIn: in C any number but 0 is true.
  Value* zero = llvm::ConstantFP::get(builder_.getDoubleTy(), 0.0);
  return {builder_.CreateFCmpONE(value, zero), builder_.CreateFCmpOEQ(value, zero)};
}

Value* Expressions::age(ir::SensorId sensor) {
  return timeSince(readingField(sensor, field::GliderReading::updated));
}

Expressions::Lowered Expressions::truthIn(Value* held) {
  return {holdsTrue(held), holdsFalse(held)};
}

Value* Expressions::holdsTrue(Value* held) {
  Value* one = llvm::ConstantFP::get(builder_.getDoubleTy(), 1.0);
  return lowering_.soft_float ? haveSameBits(builder_, held, one)
                              : builder_.CreateFCmpOEQ(held, one);
}

Value* Expressions::holdsFalse(Value* held) {
  Value* zero = llvm::ConstantFP::get(builder_.getDoubleTy(), 0.0);
  return lowering_.soft_float ? haveSameBits(builder_, held, zero)
                              : builder_.CreateFCmpOEQ(held, zero);
}

Value* Expressions::placeOf(ir::VariableId id) {
  return builder_.CreateConstInBoundsGEP1_32(
      builder_.getDoubleTy(), contextField(field::GliderContext::variables), id.index);
}

Value* Expressions::temporalSlot(uint32_t slot) {
  return builder_.CreateConstInBoundsGEP1_32(builder_.getDoubleTy(),
                                             contextField(field::GliderContext::temporals), slot);
}

Value* Expressions::timeSince(Value* then) {
  return settle(builder_.CreateFSub(contextField(field::GliderContext::mission_time), then));
}

Value* Expressions::readingField(ir::SensorId sensor, unsigned index) {
  Value* readings = contextField(field::GliderContext::readings);
  Value* reading =
      builder_.CreateConstInBoundsGEP1_32(lowering_.types.GliderReading, readings, sensor.index);
  return loadField(builder_, lowering_.types.GliderReading, reading, index);
}

Value* Expressions::contextField(unsigned index) {
  return loadField(builder_, lowering_.types.GliderContext, context_, index);
}

Value* Expressions::unknownIf(Value* condition, Value* otherwise) {
  return builder_.CreateSelect(condition, unknown(), otherwise);
}

}  // namespace glider::codegen
