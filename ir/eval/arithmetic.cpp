// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/eval/arithmetic.h"

#include "ir/core/ops.h"
#include "runtime/abi/glider_abi.h"
#include "support/check.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

namespace glider::ir {
namespace {

constexpr uint64_t kSignBit = 1ULL << 63;
constexpr uint64_t kExponentBits = 0x7FFULL << 52;

uint64_t bits(double value) {
  return std::bit_cast<uint64_t>(value);
}

bool isFinite(double value) {
  return (bits(value) & kExponentBits) != kExponentBits;
}

/// Calls a function of the runtime, which takes as many numbers as its row of ops.def says.
template <uint32_t count, typename... Numbers>
double callWith(double (*function)(Numbers...), std::span<const double> operands) {
  static_assert(sizeof...(Numbers) == count, "ops.def: another number of operands");
  return [&]<size_t... i>(std::index_sequence<i...>) {
    return function(operands[i]...);
  }(std::make_index_sequence<count>());
}

/// Converts ddmm.mmmm to degrees and keeps the sign; unknown from 60 minutes on.
double degreesMinutes(double raw) {
  const double magnitude = std::bit_cast<double>(bits(raw) & ~kSignBit);
  const double minutes = std::fmod(magnitude, 100);    // exact
  const double degrees = (magnitude - minutes) / 100;  // exact: a multiple of 100
  if (!(minutes < 60)) {
    return kUnknown;
  }
  const double value = degrees + minutes / 60;
  return settle(std::bit_cast<double>(bits(value) | (bits(raw) & kSignBit)));
}

}  // namespace

const double kUnknown = std::bit_cast<double>(0x7FF8000000000000ULL);

bool isKnown(double value) {
  return (bits(value) & ~kSignBit) <= kExponentBits;
}

double settle(double value) {
  constexpr uint64_t kSmallestNormal = 1ULL << 52;
  const uint64_t magnitude = bits(value) & ~kSignBit;
  if (magnitude >= kExponentBits) {
    return kUnknown;
  }
  return magnitude <= kSmallestNormal ? 0.0 : value;
}

double binary(Op op, double a, double b) {
  if (!isKnown(a) || !isKnown(b)) {
    return kUnknown;
  }
  switch (opIn<BinaryOp>(op)) {
    case BinaryOp::Add:
      return settle(a + b);
    case BinaryOp::Subtract:
      return settle(a - b);
    case BinaryOp::Multiply:
      return settle(a * b);
    case BinaryOp::Divide:
      return settle(a / b);
    case BinaryOp::Min:
      return b < a ? b : a;
    case BinaryOp::Max:
      return a < b ? b : a;
  }
  CHECK(false, "an operation on two numbers without a meaning");
}

double unary(Op op, double a) {
  if (!isKnown(a)) {
    return kUnknown;
  }
  switch (opIn<UnaryOp>(op)) {
    case UnaryOp::Negate:
      return std::bit_cast<double>(bits(a) ^ kSignBit);
    case UnaryOp::Abs:
      return std::bit_cast<double>(bits(a) & ~kSignBit);
    case UnaryOp::Sqrt:
      return settle(std::sqrt(a));
  }
  CHECK(false, "an operation on one number without a meaning");
}

double function(Op op, std::span<const double> operands) {
  CHECK(operands.size() == opInfo(op).operands, "a function of another number of operands");
  if (!std::ranges::all_of(operands, isKnown)) {
    return kUnknown;
  }
  switch (opIn<FunctionOp>(op)) {
#define FUNCTION(name, text, count, takes, gives, known, whole, symbol) \
  case FunctionOp::name:                                                \
    return settle(callWith<count>(&symbol, operands));
#include "ir/core/ops.def"
  }
  CHECK(false, "a function without a meaning");
}

double onEarth(Op op, Position from, Position to) {
  return function(op, std::array{from.latitude, from.longitude, to.latitude, to.longitude});
}

double clamp(double x, double lowest, double highest) {
  if (!isKnown(x) || !isKnown(lowest) || !isKnown(highest)) {
    return kUnknown;
  }
  return x < lowest ? lowest : highest < x ? highest : x;
}

double element(const Table& table, double number) {
  const bool there = number >= 0 && number < static_cast<double>(table.values.size());
  return there && std::floor(number) == number ? table.values[static_cast<size_t>(number)]
                                               : kUnknown;
}

Truth compare(Op op, double a, double b) {
  if (!isKnown(a) || !isKnown(b)) {
    return Truth::Unknown;
  }
  switch (opIn<ComparisonOp>(op)) {
    case ComparisonOp::Less:
      return truth(a < b);
    case ComparisonOp::LessEqual:
      return truth(a <= b);
    case ComparisonOp::Greater:
      return truth(a > b);
    case ComparisonOp::GreaterEqual:
      return truth(a >= b);
    case ComparisonOp::Equal:
      return truth(a == b);
    case ComparisonOp::NotEqual:
      return truth(a != b);
  }
  CHECK(false, "a comparison without a meaning");
}

double reading(const Sensor& sensor, double raw, double age_s) {
  const bool plausible = isFinite(raw) && raw >= sensor.lowest && raw <= sensor.highest;
  if (!plausible || age_s > sensor.stale_after_s) {
    return kUnknown;
  }
  return sensor.encoding == Encoding::DegreesMinutes ? degreesMinutes(raw)
                                                     : settle(raw * sensor.to_si);
}

}  // namespace glider::ir
