// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/lower/order_comparison.h"

#include "ir/core/ops.h"
#include "runtime/abi/order.h"

#include <cmath>

namespace glider::codegen {
namespace {

using ir::Op;
using llvm::Value;

constexpr uint64_t kInfinityBits = 0x7FF0000000000000U;

/// As gliderOrder; LLVM computes it if the value is a constant.
Value* orderOf(llvm::IRBuilder<>& builder, Value* value) {
  Value* bits = builder.CreateBitCast(value, builder.getInt64Ty());
  Value* sign = builder.CreateAShr(bits, 63);
  return builder.CreateXor(bits, builder.CreateAnd(sign, builder.getInt64(INT64_MAX)));
}

Value* isKnownOrder(llvm::IRBuilder<>& builder, Value* order) {
  return builder.CreateICmpSLE(order, builder.getInt64(kInfinityBits));
}

}  // namespace

bool hasPlainOrder(const ir::Expr& expr) {
  switch (ir::opInfo(expr.op).zero) {
    case ir::ZeroRule::Constant:
      return expr.number != 0 || !std::signbit(expr.number);
    case ir::ZeroRule::Plain:
      return true;
    case ir::ZeroRule::Signed:
      break;
  }
  return false;
}

Value* compareByOrder(llvm::IRBuilder<>& builder, Op op, Value* a, Value* b) {
  Value* left = orderOf(builder, a);
  Value* right = orderOf(builder, b);
  // Unknown is greater than everything: only the larger side must be checked for it.
  auto both = [&](llvm::CmpInst::Predicate predicate, Value* larger) {
    return builder.CreateAnd(builder.CreateICmp(predicate, left, right),
                             isKnownOrder(builder, larger));
  };
  switch (ir::opIn<ir::ComparisonOp>(op)) {
    case ir::ComparisonOp::Less:
      return both(llvm::CmpInst::ICMP_SLT, right);
    case ir::ComparisonOp::LessEqual:
      return both(llvm::CmpInst::ICMP_SLE, right);
    case ir::ComparisonOp::Greater:
      return both(llvm::CmpInst::ICMP_SGT, left);
    case ir::ComparisonOp::GreaterEqual:
      return both(llvm::CmpInst::ICMP_SGE, left);
    case ir::ComparisonOp::Equal:
      return both(llvm::CmpInst::ICMP_EQ, left);
    case ir::ComparisonOp::NotEqual:
      break;
  }
  return builder.CreateAnd(both(llvm::CmpInst::ICMP_NE, left), isKnownOrder(builder, right));
}

Value* isKnownByBits(llvm::IRBuilder<>& builder, Value* value) {
  Value* bits = builder.CreateBitCast(value, builder.getInt64Ty());
  return builder.CreateICmpULE(builder.CreateShl(bits, 1), builder.getInt64(kInfinityBits << 1U));
}

Value* haveSameBits(llvm::IRBuilder<>& builder, Value* a, Value* b) {
  return builder.CreateICmpEQ(builder.CreateBitCast(a, builder.getInt64Ty()),
                              builder.CreateBitCast(b, builder.getInt64Ty()));
}

}  // namespace glider::codegen
