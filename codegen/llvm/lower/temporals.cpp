// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/lower/body.h"
#include "ir/core/ops.h"

namespace glider::codegen {
namespace {

using llvm::Value;

// Slots of a temporal (mission_index.cpp counts them).
constexpr uint32_t kValue = 0;
constexpr uint32_t kWasTrue = 1;
constexpr uint32_t kSince = 2;  // of Held only

/// `became` and `held`, which start again on return.
class Guards {
 public:
  explicit Guards(Body& body) : body_(body), builder_(body.builder) {}

  void lower(ir::TemporalId id, TemporalMoment moment) {
    const ir::Temporal& temporal = body_.lowering.mission[id];
    slot_ = body_.lowering.index.temporal_slots.at(id.index);
    body_.lowering.debug.locate(builder_, temporal.range);
    is_true_ = body_.expressions.isTrue(temporal.operand);
    is_false_ = body_.expressions.isFalse(temporal.operand);
    Value* value = temporal.kind == ir::TemporalKind::Became
                       ? became(moment)
                       : held(moment, body_.expressions.number(temporal.duration));
    store(kValue, value);
    store(kWasTrue, truth(is_true_));
  }

 private:
  /// True on the tick on which the operand turns true.
  Value* became(TemporalMoment moment) {
    Value* known = builder_.CreateOr(is_true_, is_false_);
    Value* turned = builder_.getFalse();
    if (moment == TemporalMoment::Advance) {
      turned = builder_.CreateAnd(is_true_, builder_.CreateNot(wasTrue()));
    }
    return builder_.CreateSelect(known, truth(turned), unknown());
  }

  /// True while the operand has been true for `duration`.
  Value* held(TemporalMoment moment, Value* duration) {
    Value* now = body_.expressions.missionTime();
    Value* since = now;
    if (moment == TemporalMoment::Advance) {
      Value* turned = builder_.CreateAnd(is_true_, builder_.CreateNot(wasTrue()));
      since = builder_.CreateSelect(turned, now, load(kSince));
    }
    store(kSince, since);
    Value* long_enough = builder_.CreateFCmpOGE(body_.expressions.timeSince(since), duration);
    Value* when_true =
        builder_.CreateSelect(body_.expressions.isKnown(duration), truth(long_enough), unknown());
    Value* otherwise = builder_.CreateSelect(is_false_, number(0), unknown());
    return builder_.CreateSelect(is_true_, when_true, otherwise);
  }

  Value* wasTrue() { return body_.expressions.holdsTrue(load(kWasTrue)); }
  Value* load(uint32_t slot) {
    return builder_.CreateLoad(builder_.getDoubleTy(),
                               body_.expressions.temporalSlot(slot_ + slot));
  }
  void store(uint32_t slot, Value* value) {
    builder_.CreateStore(value, body_.expressions.temporalSlot(slot_ + slot));
  }
  Value* number(double value) { return llvm::ConstantFP::get(builder_.getDoubleTy(), value); }
  Value* unknown() { return llvm::ConstantFP::getNaN(builder_.getDoubleTy()); }
  Value* truth(Value* bit) { return builder_.CreateSelect(bit, number(1), number(0)); }

  Body& body_;
  llvm::IRBuilder<>& builder_;
  uint32_t slot_ = 0;
  Value* is_true_ = nullptr;
  Value* is_false_ = nullptr;
};

}  // namespace

void lowerTemporals(Body& body, const std::vector<ir::TemporalId>& temporals,
                    TemporalMoment moment) {
  Freshness fresh;
  for (const ir::TemporalId id : temporals) {
    if (body.lowering.mission[id].leg != ir::Leg::None) {
      lowerLeg(body, id, fresh);
    } else if (ir::isWindow(body.lowering.mission[id].kind)) {
      lowerWindow(body, id, fresh);
    } else {
      Guards(body).lower(id, moment);
    }
  }
}

llvm::Function* lowerAdvance(Lowering& lowering, const std::vector<ir::TemporalId>& temporals,
                             Lowers then, const std::string& name, support::SourceRange range) {
  if (temporals.empty() && !then) {
    return nullptr;
  }
  Body body(lowering, "advance." + name, Body::Result::None, 0, name + " watches", range);
  lowerTemporals(body, temporals, TemporalMoment::Advance);
  if (then) {
    then(body);
  }
  body.builder.CreateRetVoid();
  return body.function;
}

}  // namespace glider::codegen
