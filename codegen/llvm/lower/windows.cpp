// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/lower/body.h"
#include "ir/core/ops.h"
#include "ir/core/window_shape.h"
#include "runtime/abi/leg.h"
#include "runtime/abi/window.h"

#include <set>
#include <vector>

namespace glider::codegen {
namespace {

using llvm::Value;

static_assert(static_cast<int>(ir::TemporalKind::Slope) -
                  static_cast<int>(ir::TemporalKind::Mean) ==
              kGliderSlope - kGliderMean);

/// The greatest age (s) of a sensor in a reading that a window takes: ir/README.md.
constexpr double kFreshAge = 6;

GliderLegKind legKind(ir::TemporalKind kind) {
  switch (kind) {
    case ir::TemporalKind::Mean:
      return kGliderLegMean;
    case ir::TemporalKind::Lowest:
      return kGliderLegLowest;
    case ir::TemporalKind::Highest:
      return kGliderLegHighest;
    case ir::TemporalKind::Spread:
      return kGliderLegSpread;
    case ir::TemporalKind::AtLowest:
      return kGliderLegAtLowest;
    case ir::TemporalKind::AtHighest:
      return kGliderLegAtHighest;
    case ir::TemporalKind::Steepest:
      return kGliderLegSteepest;
    case ir::TemporalKind::AtSteepest:
      return kGliderLegAtSteepest;
    case ir::TemporalKind::Number:
      return kGliderLegNumber;
    case ir::TemporalKind::Became:
    case ir::TemporalKind::Held:
    case ir::TemporalKind::Slope:
      break;
  }
  CHECK(false, "not a window over a leg");
}

/// The content of a GliderLegShape.
llvm::Constant* legShapeOf(llvm::LLVMContext& context, const ir::Temporal& window) {
  llvm::Type* number = llvm::Type::getDoubleTy(context);
  llvm::Type* word = llvm::Type::getInt32Ty(context);
  return llvm::ConstantStruct::getAnon(
      {llvm::ConstantFP::get(number, window.dive), llvm::ConstantFP::get(number, window.climb),
       llvm::ConstantInt::get(word, legKind(window.kind)),
       llvm::ConstantInt::get(word, window.leg == ir::Leg::Last ? 1 : 0)});
}

/// The content of a GliderWindowShape.
llvm::Constant* windowShapeOf(llvm::LLVMContext& context, const ir::Temporal& window) {
  const ir::WindowShape shape = ir::windowShape(window);
  auto number = [&](double value) {
    return llvm::ConstantFP::get(llvm::Type::getDoubleTy(context), value);
  };
  auto word = [&](uint32_t value) {
    return llvm::ConstantInt::get(llvm::Type::getInt32Ty(context), value);
  };
  const uint32_t kind =
      static_cast<uint32_t>(shape.kind) - static_cast<uint32_t>(ir::TemporalKind::Mean);
  return llvm::ConstantStruct::getAnon({number(shape.length), number(shape.bin), word(shape.bins),
                                        word(kGliderMean + kind), word(shape.stretch ? 1 : 0),
                                        word(0)});
}

/// A constant GliderWindowShape or GliderLegShape.
llvm::Constant* shapeOf(Lowering& lowering, const ir::Temporal& window) {
  llvm::LLVMContext& context = lowering.module.getContext();
  llvm::Constant* value =
      window.leg == ir::Leg::None ? windowShapeOf(context, window) : legShapeOf(context, window);
  auto* variable = new llvm::GlobalVariable(lowering.module, value->getType(), true,
                                            llvm::GlobalValue::PrivateLinkage, value, "window");
  variable->setUnnamedAddr(llvm::GlobalValue::UnnamedAddr::Global);
  variable->setAlignment(llvm::Align(8));
  return variable;
}

/// The sensors that an expression reads itself.
void addSensors(const ir::Mission& mission, ir::ExprId id, std::set<uint32_t>& sensors) {
  std::set<uint32_t> open;
  if (id.valid()) {
    open.insert(id.index);
  }
  while (!open.empty()) {
    const ir::Expr& expr = mission.exprs.at(*open.rbegin());  // operands have smaller numbers
    open.erase(std::prev(open.end()));
    if (expr.op == ir::Op::Sensor) {
      sensors.insert(expr.sensor.index);
    }
    for (uint32_t i = 0; i < ir::operandCount(expr); ++i) {
      open.insert(expr.operands.at(i).index);
    }
  }
}

/// Whether a window that reads `sensors` may take a reading now, as u32.
Value* freshness(Body& body, const std::set<uint32_t>& sensors) {
  llvm::IRBuilder<>& builder = body.builder;
  Value* none_old = builder.getTrue();
  Value* one_new = builder.getInt1(sensors.empty());
  for (const uint32_t sensor : sensors) {
    Value* age = body.expressions.age({sensor});
    auto at = [&](double value) { return llvm::ConstantFP::get(age->getType(), value); };
    none_old = builder.CreateAnd(none_old, builder.CreateFCmpOLE(age, at(kFreshAge)));
    one_new = builder.CreateOr(one_new, builder.CreateFCmpOEQ(age, at(0)));
  }
  return builder.CreateZExt(builder.CreateAnd(none_old, one_new), builder.getInt32Ty());
}

/// The same for a window that reads `first` and `second`; generated once for the same sensors.
Value* freshnessOf(Body& body, ir::ExprId first, ir::ExprId second, Freshness& fresh) {
  std::set<uint32_t> sensors;
  addSensors(body.lowering.mission, first, sensors);
  addSensors(body.lowering.mission, second, sensors);
  Value*& taken = fresh[sensors];
  taken = taken == nullptr ? freshness(body, sensors) : taken;
  return taken;
}

/// The one constant that describes the window.
llvm::Constant* sharedShape(Body& body, ir::TemporalId id) {
  llvm::Constant*& shape = body.lowering.window_shapes.at(id.index);
  if (shape == nullptr) {
    shape = shapeOf(body.lowering, body.lowering.mission[id]);
  }
  return shape;
}

Value* memoryOf(Body& body, ir::TemporalId id) {
  return body.expressions.temporalSlot(body.lowering.index.temporal_slots.at(id.index));
}

}  // namespace

void lowerWindowStarts(Body& body, const std::vector<ir::TemporalId>& temporals) {
  for (const ir::TemporalId id : temporals) {
    const ir::Temporal& temporal = body.lowering.mission[id];
    if (temporal.leg != ir::Leg::None) {
      body.lowering.debug.locate(body.builder, temporal.range);
      body.call(ir::isOfSteepest(temporal.kind) ? "gliderSteepestStart" : "gliderLegStart",
                {memoryOf(body, id), body.expressions.missionTime()});
    } else if (ir::isWindow(temporal.kind)) {
      body.lowering.debug.locate(body.builder, temporal.range);
      body.call("gliderWindowStart",
                {memoryOf(body, id), sharedShape(body, id), body.expressions.missionTime()});
    }
  }
}

void lowerLeg(Body& body, ir::TemporalId id, Freshness& fresh) {
  const ir::Temporal& window = body.lowering.mission[id];
  body.lowering.debug.locate(body.builder, window.range);
  Value* operand = body.expressions.number(window.operand);
  Value* other = window.duration.valid() ? body.expressions.number(window.duration) : operand;
  Value* phase = body.expressions.number(window.along);
  Value* taken = freshnessOf(body, window.operand, window.duration, fresh);
  const bool of_operand = window.kind == ir::TemporalKind::Steepest;
  body.call(ir::isOfSteepest(window.kind) ? "gliderSteepestAdvance" : "gliderLegAdvance",
            {memoryOf(body, id), sharedShape(body, id), body.expressions.missionTime(), phase,
             of_operand ? operand : other, of_operand ? other : operand, taken});
}

void lowerWindow(Body& body, ir::TemporalId id, Freshness& fresh) {
  const ir::Temporal& window = body.lowering.mission[id];
  body.lowering.debug.locate(body.builder, window.range);
  Value* value = body.expressions.number(window.operand);
  Value* now = body.expressions.missionTime();
  Value* along = window.along.valid() ? body.expressions.number(window.along) : now;
  Value* taken = freshnessOf(body, window.operand, window.along, fresh);
  body.call("gliderWindowAdvance",
            {memoryOf(body, id), sharedShape(body, id), now, along, value, taken});
}

}  // namespace glider::codegen
