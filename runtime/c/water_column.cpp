// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/c/water_column.h"

namespace glider::runtime {
namespace {

/// m; neighbouring readings further apart than this do not describe the water between them.
constexpr float kWidestGap = 3.0F;
constexpr int32_t kHalf = WaterColumn::kBins / 2;

int32_t binNumber(double depth) {
  return depth > 0.0 ? static_cast<int32_t>(depth / WaterColumn::kBinMetres) : 0;
}

uint32_t slotOf(int32_t number) {
  return static_cast<uint32_t>(number) % WaterColumn::kBins;
}

float least(float a, float b) {
  return b < a ? b : a;
}
float greatest(float a, float b) {
  return a < b ? b : a;
}

}  // namespace

void WaterColumn::clear() {
  for (Bin& bin : bins_) {
    bin = {-1.0F, 0.0F, 0.0F};
  }
  newest_ = 0;
}

void WaterColumn::record(double time, double depth, double temperature) {
  newest_ = binNumber(depth);
  bins_[slotOf(newest_)] = {static_cast<float>(time), static_cast<float>(depth > 0.0 ? depth : 0.0),
                            static_cast<float>(temperature)};
}

const WaterColumn::Bin* WaterColumn::at(int32_t number, float since) const {
  const Bin& bin = bins_[slotOf(number)];
  const bool holds =
      bin.time >= since && bin.time >= 0.0F && binNumber(static_cast<double>(bin.depth)) == number;
  return holds ? &bin : nullptr;
}

Stretch WaterColumn::steepest(double length, double since) const {
  const auto longest = static_cast<float>(length);
  const auto from = static_cast<float>(since);
  Stretch best;
  for (int32_t first = newest_ - kHalf; first < newest_ + kHalf; ++first) {
    const Bin* top = at(first, from);
    if (top == nullptr) {
      continue;
    }
    float lowest = top->temperature;
    float highest = top->temperature;
    for (int32_t next = first + 1; next < newest_ + kHalf; ++next) {
      const Bin* bin = at(next, from);
      if (bin != nullptr && bin->depth - top->depth <= longest) {
        lowest = least(lowest, bin->temperature);
        highest = greatest(highest, bin->temperature);
      }
    }
    const double difference = static_cast<double>(highest) - static_cast<double>(lowest);
    if (difference > best.difference) {
      best = {difference, 0.5 * (static_cast<double>(highest) + static_cast<double>(lowest))};
    }
  }
  return best;
}

Crossing WaterColumn::crossing(double middle, double since) const {
  const auto wanted = static_cast<float>(middle);
  const auto from = static_cast<float>(since);
  const Bin* above = nullptr;
  float newest = -1.0F;
  Crossing last;
  for (int32_t number = newest_ - kHalf; number < newest_ + kHalf; ++number) {
    const Bin* below = at(number, from);
    if (below == nullptr) {
      continue;
    }
    const bool passes = above != nullptr && below->depth - above->depth <= kWidestGap &&
                        (above->temperature < wanted) != (below->temperature < wanted);
    if (passes && least(above->time, below->time) >= newest) {
      newest = least(above->time, below->time);
      last = between(*above, *below, middle);
    }
    above = below;
  }
  return last;
}

Crossing WaterColumn::between(const Bin& above, const Bin& below, double middle) {
  const double gap = static_cast<double>(below.depth - above.depth);
  const double rise = static_cast<double>(below.temperature - above.temperature);
  const double share = (middle - static_cast<double>(above.temperature)) / rise;
  return {true, static_cast<double>(above.depth) + share * gap};
}

}  // namespace glider::runtime
