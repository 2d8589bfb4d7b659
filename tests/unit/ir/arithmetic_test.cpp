// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/eval/arithmetic.h"

#include "ir/core/ops.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <vector>

namespace glider::ir {
namespace {

using Limits = std::numeric_limits<double>;

uint64_t bits(double value) {
  return std::bit_cast<uint64_t>(value);
}
const uint64_t kUnknownBits = 0x7FF8000000000000ULL;

TEST(Settle, KeepsNormalNumbersAndDropsTheRest) {
  const double smallest_kept = std::nextafter(Limits::min(), 1.0);
  for (double kept : {1.0, -1.0, smallest_kept, -smallest_kept, Limits::max(), -Limits::max()}) {
    EXPECT_EQ(bits(settle(kept)), bits(kept));
  }
  for (double gone :
       {0.0, -0.0, Limits::denorm_min(), -Limits::denorm_min(), Limits::min(), -Limits::min()}) {
    EXPECT_EQ(bits(settle(gone)), 0u);
  }
  const double signalling = std::bit_cast<double>(0x7FF0000000000001ULL);
  for (double unknown : {Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN(),
                         -Limits::quiet_NaN(), signalling}) {
    EXPECT_EQ(bits(settle(unknown)), kUnknownBits);
  }
}

/// Each row of a function names the right one: the interpreter and compiled code both take it from
/// there.
TEST(Arithmetic, FunctionsAreWhatTheirNamesSay) {
  struct Known {
    std::vector<double> operands;
    double value;
  };
  const double degree = std::numbers::pi / 180;
  const std::map<Op, Known> examples = {
      {Op::Sin, {{30 * degree}, 0.5}},
      {Op::Cos, {{60 * degree}, 0.5}},
      {Op::Tan, {{-45 * degree}, -1}},
      {Op::Atan2, {{2, -2}, 135 * degree}},
      {Op::Distance, {{0, 10, 0, 11}, 6371008.8 * degree}},
      {Op::Bearing, {{0, 10, 0, 11}, 90 * degree}},
      {Op::OffsetLatitude, {{0, 10, 0, 6371008.8 * degree}, 1}},
      {Op::OffsetLongitude, {{0, 10, 90 * degree, 6371008.8 * degree}, 11}},
      {Op::Remainder, {{-1, 3}, 2}},
      {Op::Salinity, {{4.2914, 15 / 1.00024, 0}, 35.000000173}},
      {Op::Density, {{4.2914, 15 / 1.00024, 0}, 1025.97275}},
  };
  for (const OpInfo& row : kOps) {
    if (row.group == OpGroup::Function) {
      ASSERT_TRUE(examples.contains(row.op)) << "give an example of " << row.text;
      const Known& known = examples.at(row.op);
      EXPECT_NEAR(function(row.op, known.operands), known.value,
                  1e-8 * std::max(1.0, std::fabs(known.value)))
          << row.text;
      for (size_t i = 0; i < row.operands; ++i) {
        std::vector<double> operands = known.operands;
        operands[i] = -Limits::quiet_NaN();
        EXPECT_EQ(bits(function(row.op, operands)), kUnknownBits) << row.text;
      }
    }
  }
}

TEST(Arithmetic, OverflowAndUndefinedResultsAreUnknown) {
  EXPECT_EQ(bits(binary(Op::Divide, 1, 0)), kUnknownBits);
  EXPECT_EQ(bits(binary(Op::Divide, 0, 0)), kUnknownBits);
  EXPECT_EQ(bits(binary(Op::Multiply, 1e200, 1e200)), kUnknownBits);
  EXPECT_EQ(bits(binary(Op::Add, Limits::max(), Limits::max())), kUnknownBits);
  EXPECT_EQ(bits(unary(Op::Sqrt, -1)), kUnknownBits);
  EXPECT_EQ(bits(unary(Op::Sqrt, -0.0)), 0u);
  EXPECT_EQ(bits(binary(Op::Multiply, 1e-200, -1e-200)), 0u);
  EXPECT_EQ(bits(binary(Op::Multiply, -1, 0)), 0u);
  EXPECT_EQ(binary(Op::Subtract, 3, 5), -2);
}

TEST(Arithmetic, SignChangesDoNotSettle) {
  EXPECT_EQ(bits(unary(Op::Negate, 0)), 1ULL << 63);
  EXPECT_EQ(bits(unary(Op::Negate, Limits::denorm_min())), bits(-Limits::denorm_min()));
  EXPECT_EQ(bits(unary(Op::Abs, -0.0)), 0u);
  EXPECT_EQ(bits(unary(Op::Negate, kUnknown)), kUnknownBits);
  EXPECT_EQ(bits(unary(Op::Abs, kUnknown)), kUnknownBits);
}

TEST(Arithmetic, ElementsGoByWholeNumbers) {
  const Table table{{}, {7, -8, 9}};
  EXPECT_EQ(element(table, 0), 7);
  EXPECT_EQ(element(table, -0.0), 7);
  EXPECT_EQ(element(table, 2), 9);
  for (const double none : {-1.0, 0.5, 3.0, 1e300, -1e300, kUnknown}) {
    EXPECT_EQ(bits(element(table, none)), kUnknownBits) << none;
  }
}

TEST(Arithmetic, ChoicesTakeTheFirstWhenEqual) {
  EXPECT_EQ(bits(binary(Op::Min, -0.0, 0.0)), bits(-0.0));
  EXPECT_EQ(bits(binary(Op::Min, 0.0, -0.0)), bits(0.0));
  EXPECT_EQ(bits(binary(Op::Max, -0.0, 0.0)), bits(-0.0));
  EXPECT_EQ(binary(Op::Min, 2, 1), 1);
  EXPECT_EQ(binary(Op::Max, 2, 1), 2);
  EXPECT_EQ(clamp(5, 1, 3), 3);
  EXPECT_EQ(clamp(0, 1, 3), 1);
  EXPECT_EQ(clamp(2, 1, 3), 2);
  EXPECT_EQ(clamp(2, 3, 1), 3) << "below the lowest is looked at first";
  EXPECT_EQ(bits(clamp(2, kUnknown, 3)), kUnknownBits);
  EXPECT_EQ(bits(binary(Op::Min, 1, kUnknown)), kUnknownBits);
  EXPECT_EQ(bits(binary(Op::Max, kUnknown, 1)), kUnknownBits);
  for (const Op op : {Op::Min, Op::Max, Op::Add, Op::Atan2}) {
    EXPECT_EQ(bits(binary(op, -Limits::quiet_NaN(), 1)), kUnknownBits) << "there is one unknown";
    EXPECT_EQ(bits(binary(op, 1, -Limits::quiet_NaN())), kUnknownBits);
  }
}

TEST(Arithmetic, ComparisonsWithAnUnknownAreUnknown) {
  for (Op op : {Op::Less, Op::LessEqual, Op::Greater, Op::GreaterEqual, Op::Equal, Op::NotEqual}) {
    EXPECT_EQ(compare(op, kUnknown, 1), Truth::Unknown);
    EXPECT_EQ(compare(op, 1, kUnknown), Truth::Unknown);
  }
  EXPECT_EQ(compare(Op::Equal, 0.0, -0.0), Truth::True);
  EXPECT_EQ(compare(Op::NotEqual, 1, 2), Truth::True);
  EXPECT_EQ(compare(Op::LessEqual, 2, 2), Truth::True);
  EXPECT_EQ(compare(Op::Greater, 2, 2), Truth::False);
}

TEST(Truth, IsKleenes) {
  constexpr Truth F = Truth::False, T = Truth::True, U = Truth::Unknown;
  EXPECT_EQ(logicalNot(U), U);
  EXPECT_EQ(logicalNot(F), T);
  EXPECT_EQ(logicalAnd(U, F), F);
  EXPECT_EQ(logicalAnd(F, U), F);
  EXPECT_EQ(logicalAnd(U, T), U);
  EXPECT_EQ(logicalAnd(T, T), T);
  EXPECT_EQ(logicalOr(U, T), T);
  EXPECT_EQ(logicalOr(T, U), T);
  EXPECT_EQ(logicalOr(U, F), U);
  EXPECT_EQ(logicalOr(F, F), F);
}

Sensor sensor(Encoding encoding) {
  return {"x", "m_x", 1, {TypeKind::Latitude, {}}, encoding, 2, -9000, 9000, 20};
}

TEST(Reading, IsUnknownOutsideItsRangeOrWhenOld) {
  const Sensor s = sensor(Encoding::Linear);
  EXPECT_EQ(reading(s, 9000, 20), 18000);
  EXPECT_FALSE(isKnown(reading(s, 9000, std::nextafter(20.0, 21.0))));
  EXPECT_FALSE(isKnown(reading(s, std::nextafter(9000.0, 9001.0), 0)));
  EXPECT_FALSE(isKnown(reading(s, std::nextafter(-9000.0, -9001.0), 0)));
  EXPECT_FALSE(isKnown(reading(s, Limits::quiet_NaN(), 0)));
  EXPECT_EQ(bits(reading(s, -0.0, 0)), 0u);
  Sensor open = s;
  open.highest = Limits::infinity();
  EXPECT_FALSE(isKnown(reading(open, Limits::infinity(), 0)));
}

TEST(Reading, OfDegreesAndMinutes) {
  const Sensor s = sensor(Encoding::DegreesMinutes);
  EXPECT_EQ(reading(s, 3910.5, 0), 39 + 10.5 / 60);
  EXPECT_EQ(reading(s, -7349.8058, 0), -(73 + std::fmod(7349.8058, 100) / 60));
  EXPECT_EQ(reading(s, -30, 0), -0.5);
  EXPECT_FALSE(isKnown(reading(s, 3960, 0)));
  EXPECT_FALSE(isKnown(reading(s, std::nextafter(3900.0, 0.0), 0))) << "99.99 minutes";
  EXPECT_TRUE(isKnown(reading(s, std::nextafter(3960.0, 0.0), 0)));
  EXPECT_EQ(bits(reading(s, -0.0, 0)), 0u);
}

}  // namespace
}  // namespace glider::ir
