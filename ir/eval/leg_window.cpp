// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/eval/leg_window.h"

#include "ir/eval/arithmetic.h"
#include "support/check.h"

#include <algorithm>
#include <utility>

namespace glider::ir {
namespace {

constexpr double kLongestGap = 60;  ///< s

}  // namespace

void PlainLegs::start(double time) {
  present_ = {};
  last_ = {};
  begun_ = 0;
  since_ = time;
  phase_ = kUnknown;
  time_ = time;
  value_ = kUnknown;
}

void PlainLegs::advance(double time, double phase, double value, double at, bool fresh) {
  if (!isKnown(phase)) {
    value_ = kUnknown;
    return;
  }
  if (time == since_) {
    phase_ = phase;
    value_ = kUnknown;
    return;
  }
  const bool watched = binary(Op::Subtract, time, time_) <= kLongestGap;
  if (!watched) {  // legs may have come and gone
    present_ = {};
    last_ = {};
  }
  if (isLeg(phase) && phase != phase_) {
    last_ = present_.whole ? std::move(present_) : Part();
    present_ = {};
    present_.whole = watched && isKnown(phase_);
    begun_ += isKnown(phase_) ? 1 : 0;
  }
  phase_ = phase;
  time_ = time;
  if (fresh && isLeg(phase) && isKnown(value) && isKnown(at)) {
    present_.readings.push_back({value, at});
  }
  value_ = worth();
}

bool PlainLegs::isLeg(double phase) const {
  return phase == window_.dive || phase == window_.climb;
}

double PlainLegs::worth() const {
  const auto& readings = window_.leg == Leg::Last ? last_.readings : present_.readings;
  if (window_.kind == TemporalKind::Number) {
    return begun_;
  }
  if (readings.empty()) {
    return kUnknown;
  }
  const auto low = std::ranges::min_element(readings, {}, &Reading::value);
  const auto high = std::ranges::max_element(readings, {}, &Reading::value);
  const double first = readings.front().value;
  double sum = 0;
  for (const Reading& reading : readings) {
    sum = binary(Op::Add, sum, binary(Op::Subtract, reading.value, first));
  }
  switch (window_.kind) {
    case TemporalKind::Mean: {
      const double mean =
          binary(Op::Add, first, binary(Op::Divide, sum, static_cast<double>(readings.size())));
      return std::clamp(mean, low->value, high->value);
    }
    case TemporalKind::Lowest:
      return low->value;
    case TemporalKind::Highest:
      return high->value;
    case TemporalKind::Spread:
      return binary(Op::Subtract, high->value, low->value);
    case TemporalKind::AtLowest:
      return low->at;
    case TemporalKind::AtHighest:
      return high->at;
    case TemporalKind::Number:
    case TemporalKind::Slope:
    case TemporalKind::Became:
    case TemporalKind::Held:
      break;
  }
  CHECK(false, "not a window over a leg");
}

}  // namespace glider::ir
