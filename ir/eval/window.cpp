// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/eval/window.h"

#include "ir/eval/arithmetic.h"
#include "support/check.h"

#include <algorithm>
#include <cmath>

namespace glider::ir {
namespace {

constexpr double kStretchMemory = 1800;            ///< s
constexpr double kGreatestBin = 4503599627370496;  ///< 2^52

double add(double a, double b) {
  return binary(Op::Add, a, b);
}
double subtract(double a, double b) {
  return binary(Op::Subtract, a, b);
}
double multiply(double a, double b) {
  return binary(Op::Multiply, a, b);
}

}  // namespace

void PlainWindow::start(double time) {
  readings_.clear();
  any_ = false;
  since_ = time;
  value_ = kUnknown;
}

void PlainWindow::advance(double time, double along, double value, bool fresh) {
  if (!isKnown(along)) {
    value_ = kUnknown;
    return;
  }
  const double bin = std::floor(binary(Op::Divide, along, shape_.bin));
  if (fresh && isKnown(value) && std::fabs(bin) < kGreatestBin) {
    if (any_) {
      const auto [a, b] = std::minmax(newest_, bin);
      std::erase_if(readings_,
                    [&](const auto& entry) { return a < entry.first && entry.first < b; });
    }
    newest_ = bin;
    readings_[bin] = {time, along, value};
    least_ = any_ ? std::min(least_, along) : along;
    greatest_ = any_ ? std::max(greatest_, along) : along;
    any_ = true;
  }
  std::erase_if(readings_, [&](const auto& entry) { return !within(entry.second, time, along); });
  value_ = covered(time) ? workOut(along) : kUnknown;
}

bool PlainWindow::covered(double time) const {
  return (shape_.stretch ? subtract(greatest_, least_) : subtract(time, since_)) >= shape_.length;
}

bool PlainWindow::within(const Reading& reading, double time, double now) const {
  const double off = subtract(now, reading.along);
  return shape_.stretch
             ? std::fabs(off) <= shape_.length && subtract(time, reading.time) <= kStretchMemory
             : off <= shape_.length;
}

double PlainWindow::workOut(double now) const {
  if (readings_.empty()) {
    return kUnknown;
  }
  const double first = readings_.begin()->second.value;
  const auto count = static_cast<double>(readings_.size());
  double least = first;
  double greatest = first;
  double values = 0;
  double alongs = 0;
  double along_along = 0;
  double along_value = 0;
  for (const auto& [bin, reading] : readings_) {
    const double x = subtract(reading.along, now);
    const double y = subtract(reading.value, first);
    values = add(values, y);
    alongs = add(alongs, x);
    along_along = add(along_along, multiply(x, x));
    along_value = add(along_value, multiply(x, y));
    least = std::min(least, reading.value);
    greatest = std::max(greatest, reading.value);
  }
  switch (shape_.kind) {
    case TemporalKind::Mean:
      return add(first, binary(Op::Divide, values, count));
    case TemporalKind::Lowest:
      return least;
    case TemporalKind::Highest:
      return greatest;
    case TemporalKind::Spread:
      return subtract(greatest, least);
    case TemporalKind::Slope:
      break;
    case TemporalKind::Became:
    case TemporalKind::Held:
    case TemporalKind::AtLowest:
    case TemporalKind::AtHighest:
    case TemporalKind::Steepest:
    case TemporalKind::AtSteepest:
    case TemporalKind::Number:
      CHECK(false, "not a window");
  }
  const double below = subtract(multiply(count, along_along), multiply(alongs, alongs));
  if (!(below > 0)) {
    return kUnknown;
  }
  return binary(Op::Divide, subtract(multiply(count, along_value), multiply(alongs, values)),
                below);
}

}  // namespace glider::ir
