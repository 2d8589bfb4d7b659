// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/lower/order_comparison.h"

#include "ir/core/ops.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <llvm/IR/Constants.h>

#include <bit>
#include <cmath>
#include <limits>

/// Comparisons without a floating-point unit, on constants that LLVM folds: every pair of
/// awkward numbers against what the comparison means.
namespace glider::codegen {
namespace {

using ir::Op;
using Limits = std::numeric_limits<double>;

class OrderComparison : public testing::Test {
 protected:
  llvm::Value* number(double value) { return llvm::ConstantFP::get(builder_.getDoubleTy(), value); }
  static bool isTrue(llvm::Value* value) {
    const auto* constant = llvm::dyn_cast<llvm::ConstantInt>(value);
    EXPECT_NE(constant, nullptr) << "not folded";
    return constant != nullptr && constant->isOne();
  }

  llvm::LLVMContext context_;
  llvm::IRBuilder<> builder_{context_};
};

constexpr double kNumbers[] = {0.0,
                               1.0,
                               -1.0,
                               1.5,
                               -2.25,
                               Limits::min(),
                               -Limits::min(),
                               Limits::denorm_min(),
                               Limits::max(),
                               -Limits::max(),
                               Limits::infinity(),
                               -Limits::infinity(),
                               Limits::quiet_NaN()};

TEST_F(OrderComparison, SaysWhatTheNumbersSay) {
  for (const double a : kNumbers) {
    for (const double b : kNumbers) {
      const bool known = !std::isnan(a) && !std::isnan(b);
      const auto holds = [&](Op op) {
        return isTrue(compareByOrder(builder_, op, number(a), number(b)));
      };
      EXPECT_EQ(holds(Op::Less), known && a < b) << a << " " << b;
      EXPECT_EQ(holds(Op::LessEqual), known && a <= b) << a << " " << b;
      EXPECT_EQ(holds(Op::Greater), known && a > b) << a << " " << b;
      EXPECT_EQ(holds(Op::GreaterEqual), known && a >= b) << a << " " << b;
      EXPECT_EQ(holds(Op::Equal), known && a == b) << a << " " << b;
      EXPECT_EQ(holds(Op::NotEqual), known && a != b) << a << " " << b;
      EXPECT_EQ(isTrue(haveSameBits(builder_, number(a), number(b))),
                std::bit_cast<uint64_t>(a) == std::bit_cast<uint64_t>(b));
    }
  }
}

TEST_F(OrderComparison, KnownIsAllButNaN) {
  for (const double a : kNumbers) {
    EXPECT_EQ(isTrue(isKnownByBits(builder_, number(a))), !std::isnan(a)) << a;
  }
  EXPECT_TRUE(isTrue(isKnownByBits(builder_, number(-0.0))));
  EXPECT_FALSE(isTrue(isKnownByBits(builder_, number(-Limits::quiet_NaN()))));
  EXPECT_FALSE(isTrue(haveSameBits(builder_, number(0.0), number(-0.0))));
}

TEST_F(OrderComparison, MinusZeroIsNoPlainOrder) {
  ir::Expr constant;
  constant.op = Op::Constant;
  for (const auto& [value, plain] : {std::pair{0.0, true},
                                     {-0.0, false},
                                     {1.0, true},
                                     {-1.0, true},
                                     {Limits::denorm_min(), true}}) {
    constant.number = value;
    EXPECT_EQ(hasPlainOrder(constant), plain) << value;
  }
  // Their results settle, and so never are -0; what only hands on an operand may be.
  for (const Op op : {Op::Sensor, Op::MissionTime, Op::StateTime, Op::ResumeTime, Op::Age, Op::Sqrt,
                      Op::Sin, Op::Cos, Op::Tan, Op::Add, Op::Subtract, Op::Multiply, Op::Divide,
                      Op::Atan2, Op::Distance, Op::Bearing}) {
    constant.op = op;
    EXPECT_TRUE(hasPlainOrder(constant)) << ir::opInfo(op).text;
  }
  for (const Op op : {Op::Negate, Op::Abs, Op::Min, Op::Max, Op::Clamp, Op::Select, Op::Variable,
                      Op::Temporal, Op::Element, Op::Call}) {
    constant.op = op;
    EXPECT_FALSE(hasPlainOrder(constant)) << ir::opInfo(op).text;
  }
}

}  // namespace
}  // namespace glider::codegen
