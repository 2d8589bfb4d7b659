// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/eval/arithmetic.h"

#include "runtime/abi/glider_abi.h"
#include "support/check.h"

#include <bit>
#include <cmath>

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

/// ddmm.mmmm to degrees, the sign kept; unknown from 60 minutes on.
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
  switch (op) {
    case Op::Add:
      return settle(a + b);
    case Op::Subtract:
      return settle(a - b);
    case Op::Multiply:
      return settle(a * b);
    case Op::Divide:
      return settle(a / b);
    case Op::Min:
      return b < a ? b : a;
    case Op::Max:
      return a < b ? b : a;
    case Op::Atan2:
      return settle(gliderAtan2(a, b));
    default:
      CHECK(false, "not an operation on two numbers");
  }
}

double unary(Op op, double a) {
  if (!isKnown(a)) {
    return kUnknown;
  }
  switch (op) {
    case Op::Negate:
      return std::bit_cast<double>(bits(a) ^ kSignBit);
    case Op::Abs:
      return std::bit_cast<double>(bits(a) & ~kSignBit);
    case Op::Sqrt:
      return settle(std::sqrt(a));
    case Op::Sin:
      return settle(gliderSin(a));
    case Op::Cos:
      return settle(gliderCos(a));
    case Op::Tan:
      return settle(gliderTan(a));
    default:
      CHECK(false, "not an operation on one number");
  }
}

double onEarth(Op op, Position from, Position to) {
  for (double value : {from.latitude, from.longitude, to.latitude, to.longitude}) {
    if (!isKnown(value)) {
      return kUnknown;
    }
  }
  CHECK(op == Op::Distance || op == Op::Bearing, "not an operation on two positions");
  auto* function = op == Op::Distance ? gliderDistance : gliderBearing;
  return settle(function(from.latitude, from.longitude, to.latitude, to.longitude));
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
  switch (op) {
    case Op::Less:
      return truth(a < b);
    case Op::LessEqual:
      return truth(a <= b);
    case Op::Greater:
      return truth(a > b);
    case Op::GreaterEqual:
      return truth(a >= b);
    case Op::Equal:
      return truth(a == b);
    case Op::NotEqual:
      return truth(a != b);
    default:
      CHECK(false, "not a comparison");
  }
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
