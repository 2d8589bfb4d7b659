// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/eval/leg_window.h"

#include "ir/core/ops.h"
#include "ir/eval/arithmetic.h"
#include "support/check.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace glider::ir {
namespace {

constexpr double kLongestGap = 60;  ///< s
constexpr double kLayer = 2;        ///< m

using Readings = std::vector<PlainLegs::Reading>;

/// first + (sum of (x - first)) / n.
double meanOf(std::span<const PlainLegs::Reading> readings, double PlainLegs::Reading::* part) {
  const double first = readings.front().*part;
  double sum = 0;
  for (const PlainLegs::Reading& reading : readings) {
    sum = binary(Op::Add, sum, binary(Op::Subtract, reading.*part, first));
  }
  return binary(Op::Add, first, binary(Op::Divide, sum, static_cast<double>(readings.size())));
}

/// The means of the complete layers; the last one is complete if the leg is `over`.
Readings layersOf(const Readings& readings, bool over) {
  Readings layers;
  size_t first = 0;
  for (size_t i = 1; i <= readings.size(); ++i) {
    const bool next = i < readings.size() &&
                      std::abs(binary(Op::Subtract, readings[i].at, readings[first].at)) >= kLayer;
    if (next || (over && i == readings.size())) {
      const std::span layer(readings.begin() + static_cast<std::ptrdiff_t>(first), i - first);
      layers.push_back(
          {meanOf(layer, &PlainLegs::Reading::value), meanOf(layer, &PlainLegs::Reading::at)});
      first = i;
    }
  }
  return layers;
}

/// The steepest slope from a layer to the next, and the middle between the two.
PlainLegs::Reading steepest(const Readings& layers) {
  PlainLegs::Reading best{kUnknown, kUnknown};
  for (size_t i = 1; i < layers.size(); ++i) {
    const double rise = binary(Op::Subtract, layers[i].at, layers[i - 1].at);
    if (!isKnown(rise) || std::abs(rise) < kLayer / 2) {
      continue;
    }
    const double slope =
        binary(Op::Divide, binary(Op::Subtract, layers[i].value, layers[i - 1].value), rise);
    if (isKnown(slope) && (!isKnown(best.value) || std::abs(slope) > std::abs(best.value))) {
      best = {slope, binary(Op::Add, layers[i - 1].at, binary(Op::Divide, rise, 2))};
    }
  }
  return best;
}

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
  if (isOfSteepest(window_.kind)) {
    const bool over = window_.leg == Leg::Last || !isLeg(phase_);
    const Reading found = steepest(layersOf(readings, over));
    return window_.kind == TemporalKind::Steepest ? found.value : found.at;
  }
  const auto low = std::ranges::min_element(readings, {}, &Reading::value);
  const auto high = std::ranges::max_element(readings, {}, &Reading::value);
  switch (window_.kind) {
    case TemporalKind::Mean:
      return std::clamp(meanOf(readings, &Reading::value), low->value, high->value);
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
    case TemporalKind::Steepest:
    case TemporalKind::AtSteepest:
    case TemporalKind::Number:
    case TemporalKind::Slope:
    case TemporalKind::Became:
    case TemporalKind::Held:
      break;
  }
  CHECK(false, "not a window over a leg");
}

}  // namespace glider::ir
